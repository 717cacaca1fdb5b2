//! Intersections whose decisions are right and whose lambdas are accurate, at nearly the textbook's price.
//!
//! The plain formulas run first. A running certificate, a few multiplications, bounds what rounding may have done
//! to them; where it holds, the textbook's bits are the answer. Where it does not, a sphere is asked by a formula in
//! which the root that is short does not [cancel](sphere_compensated). Else, or where that is in doubt too, the
//! textbook's formulas and their certificate run again in [double-double](double_double) arithmetic, and where even
//! these are in doubt, every decision is taken in [exact](dyadic) arithmetic:
//!
//! | step | unit roundoff | taken by |
//! |---|---|---|
//! | textbook, f64 | 2^-53 | nearly all rays |
//! | compensated, f64 | 2^-53 | rays that start near a large sphere |
//! | double-double | 2^-102 | rays that graze, or meet a small or far object |
//! | exact | 0 | rays that are tangent, or pass through a rim, to the last bit |
//!
//! Uses [`geometry`](crate::geometry), [`math`](crate::math) and [`simd`](crate::simd). Begin with [`sphere`], then
//! [`error_bound`].
//!
//! What is true is decided by the numbers of the scene file, taken as exact: the sphere `|C - O - d lambda| = r`; the
//! cylinder of height `|axis|` around the line through its centre along `axis`, which need not be a multiple of a
//! rounded unit vector. The bounds are derived in `docs/accuracy.md`, where they are also measured.
//!
//! A ray that is not finite has no exact meaning: it gets what the textbook says. So does a null direction, which
//! meets nothing, and the side of a cylinder that the ray is parallel to.

pub mod cylinder;
pub(crate) mod cylinder_exact;
pub(crate) mod cylinder_lanes;
pub(crate) mod cylinder_surfaces;
pub mod double_double;
pub mod dyadic;
pub mod error_bound;
pub(crate) mod limbs;
pub mod sphere;
pub mod sphere_compensated;
pub(crate) mod sphere_exact;
pub mod sphere_filter;
