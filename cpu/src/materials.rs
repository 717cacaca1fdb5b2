//! How surfaces send light on: matte, metal and refractive.
//!
//! [`scatter`] has the formulas (specification, section 10), [`prepared`] their constants, computed once. Uses
//! [`math`](crate::math), [`input`](crate::input) and [`sampling`](crate::sampling). Begin with [`scatter`].

pub mod prepared;
pub mod scatter;
