//! How surfaces scatter light: matte, metal and refractive (specification, section 10).
//!
//! [`reflection`] and [`refraction`] have the formulas of metal and of refractive surfaces, and [`scatter`] adds the
//! random vector. [`prepared`] chooses the formula of a material, with constants that are computed once. Uses
//! [`math`](crate::math), [`input`](crate::input) and [`sampling`](crate::sampling). Begin with [`prepared`].

pub mod prepared;
pub mod reflection;
pub mod refraction;
pub mod scatter;
