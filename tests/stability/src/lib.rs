//! Compares the intersections of [`cpu`] with exact arithmetic.
//!
//! An [oracle] computes the exact intersection of a ray and an object. The [regimes] make cases; each regime is hard
//! for a different reason. The [methods] are the implementations. The module [measure] counts wrong answers and
//! measures their errors. The program `stress` of `gpu-check` adds the formulas in WGSL, runs all implementations and
//! writes `docs/accuracy/`. The tests run fewer cases and assert what must hold.

pub mod case;
pub mod measure;
pub mod methods;
pub mod observed;
pub mod oracle;
pub mod proof;
pub mod random;
pub mod record;
pub mod regimes;
pub mod report;
pub mod run;
