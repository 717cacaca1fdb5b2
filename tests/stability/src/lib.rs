//! Compares the intersections of [`cpu`] with exact arithmetic.
//!
//! An [oracle] computes the exact intersection of a ray and an object. [regimes] draw cases, each family hard for
//! another reason. [methods] are the implementations, and [measure] counts how often and by how much each is wrong. The
//! binary `stress` of `gpu-check` adds the formulas in WGSL, runs everything and writes `docs/accuracy/`. The tests run
//! a part of it and assert what must hold.

pub mod case;
pub mod climb;
pub mod measure;
pub mod methods;
pub mod observed;
pub mod oracle;
pub mod plot;
pub mod random;
pub mod regimes;
pub mod report;
pub mod run;
