//! Writes scenes for pbrt-v4 and Mitsuba 3, so that another renderer can be the reference.
//!
//! [`write`](mod@write) writes both formats. [`sky`] draws the picture of a sky of two colours, and [`notes`] collects
//! what has no match in the other format.

pub mod notes;
pub mod sky;
pub mod write;
