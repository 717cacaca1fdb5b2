//! Intersections whose decisions are right and whose lambdas are accurate, at nearly the cost of the plain formulas.
//!
//! The plain formulas run first. A bound of their rounding errors, a few multiplications, tells whether their result is
//! certain. If it is not, a sphere is intersected by a formula in which the smaller root does not
//! [cancel](sphere_compensated). If that is uncertain too, and for every cylinder, the plain formulas and their bound
//! run again in [double-double](double_double) arithmetic. Where even these are uncertain, every decision is taken in
//! [exact](dyadic) arithmetic:
//!
//! | step | unit roundoff | taken by |
//! |---|---|---|
//! | plain, f64 | 2^-53 | nearly all rays |
//! | compensated, f64 | 2^-53 | rays that start near a large sphere |
//! | double-double | 2^-102 | rays that graze, or hit a small or far object |
//! | exact | 0 | rays that are tangent, or pass through a rim, to the last bit |
//!
//! Uses [`geometry`](crate::geometry), [`math`](crate::math) and [`simd`](crate::simd). Begin with [`sphere`], then
//! [`error_bound`].
//!
//! "Right" means right for the numbers of the scene file, taken as exact: the sphere `|C - O - d lambda| = r`; the
//! cylinder of height `|axis|` around the line through its centre along `axis`, which need not be a multiple of a
//! rounded unit vector. The bounds are derived in `docs/accuracy.md`, where they are also measured.
//!
//! A ray that is not finite has no exact meaning: it gets the result of the plain formula. So does a null
//! direction, which hits nothing, and the side of a cylinder that the ray is parallel to.

pub(crate) mod cap;
pub mod cylinder;
pub(crate) mod cylinder_exact;
pub(crate) mod cylinder_lanes;
pub(crate) mod cylinder_side;
pub mod double_double;
pub mod dyadic;
pub mod error_bound;
pub(crate) mod limbs;
pub mod sphere;
pub mod sphere_compensated;
pub(crate) mod sphere_exact;
pub mod sphere_filter;
