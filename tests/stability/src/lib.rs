//! Holds the intersections of [`cpu`] against exact arithmetic.
//!
//! An [oracle] knows what is true of a ray and an object; [regimes] draw cases that are hard each for another reason;
//! [methods] are the implementations; [measure] counts how often and by how much each is wrong. The binary `stress` of
//! `gpu-check`, which adds the same formulas in WGSL, runs all of it and writes `docs/accuracy/`; the tests run a part
//! and assert what must hold.

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
