//! Holds the exact intersections, the tangent and the power against arithmetic of another library, and whole pictures
//! against what is known of them.

mod constants;
mod extremes;
mod functions;
mod furnaces;
mod gappa;
mod near;
mod pictures;
mod proofs;
