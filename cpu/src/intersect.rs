//! Functions that intersect a ray with one sphere or cylinder.
//!
//! [`sphere`] and [`cylinder`] are exact: they decide between hit and miss as infinitely precise arithmetic would. If
//! the filter is certain, lambda has the bits of the plain formula. The methods `intersect` of [`SphereRecord`] and
//! [`CylinderRecord`] are the plain formulas (specification, section 9) in `f64`.

pub use crate::exact::cylinder::intersect as cylinder;
pub use crate::exact::sphere::intersect as sphere;
pub use crate::geometry::cylinder::{CylinderPart, CylinderRecord};
pub use crate::geometry::sphere::SphereRecord;
