//! Proves margins from the formulas themselves.
//!
//! The formulas of `cpu` are generic over their number. Here they run over a number that carries bounds in place of a
//! value: of its exact size and of its rounding error, as polynomials of the magnitudes of the inputs. So no formula is
//! written a second time, and what the code leaves out is missing here too. Only the comparisons with which an argument
//! by hand begins are written again, and the code must make exactly these.

pub mod background;
pub mod bounded;
pub mod bounds;
pub mod boxes;
mod bytes;
pub mod camera;
mod compensated;
pub mod direction;
pub mod exact;
pub mod filters;
mod frustum;
pub mod gappa;
pub mod interval;
pub mod lanes;
mod logarithm;
mod magnitudes;
mod operations;
pub mod parts;
pub mod polynomial;
mod power;
pub mod quadratic;
pub mod row;
pub mod ruled;
pub mod series;
pub mod signed;
mod underflow;

/// Returns the rows of all margins.
#[must_use]
pub fn rows() -> Vec<row::Row> {
    [
        exact::rows(),
        filters::rows(),
        boxes::rows(),
        magnitudes::rows().to_vec(),
        background::rows().to_vec(),
        camera::rows().to_vec(),
        vec![frustum::row(), bytes::row(), series::row(), power::row()],
    ]
    .concat()
}
