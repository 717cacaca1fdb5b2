//! Intersections whose decisions are right and whose lambdas are accurate, at nearly the cost of the plain formulas.
//!
//! The plain formulas run first. A bound of their rounding errors, which costs a few multiplications, tells whether
//! their result is certain. If it is uncertain, compensated formulas run, in which less cancels: for a sphere by the
//! parts [across the ray](sphere_compensated), for a cylinder [across the axis](cylinder_compensated). If these are
//! uncertain too, a sphere is intersected in [double-double](sphere_wide) arithmetic. What is uncertain even then is
//! decided in [dyadic](crate::math::dyadic) arithmetic:
//!
//! | step | unit roundoff | taken by |
//! |---|---|---|
//! | plain, f64 | 2^-53 | nearly all rays |
//! | compensated, f64 | 2^-53 | rays that start near a large surface, pass a far object, or run along a cylinder |
//! | double-double, spheres | 2^-106 | rays that start near a sphere which is larger than the scene by far |
//! | dyadic | 0 | rays that are tangent, or pass through a rim, to the last bit |
//!
//! Uses [`geometry`](crate::geometry), [`math`](crate::math) and [`simd`](crate::simd). Begin with [`sphere`], then
//! [`error_bound`], or with [`cylinder`], whose ladder names the next file.
//!
//! "Right" means right for the numbers of the scene file and of the ray, taken as exact. The sphere is
//! `|C - O - d lambda| = r`. The cylinder has the height `|axis|` and lies around the line through its centre along
//! `axis`. This axis need not be a multiple of a rounded unit vector. The bounds are derived and measured in
//! `docs/accuracy.md`.
//!
//! If a number of the ray or of the object is not finite, the plain formula gives the result. A ray with a null
//! direction hits nothing. A ray that is parallel to a cylinder's axis does not hit the side.

pub mod compensated_roots;
pub mod cylinder;
pub mod cylinder_compensated;
pub mod cylinder_decision;
pub mod cylinder_lanes;
pub mod cylinder_plain;
pub mod error_bound;
pub(crate) mod exact_lambda;
pub(crate) mod exact_vector;
pub mod order;
pub mod sphere;
pub mod sphere_compensated;
pub mod sphere_filter;
pub mod sphere_wide;
