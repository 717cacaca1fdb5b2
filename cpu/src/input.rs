//! The two text files as checked values, and everything that can be wrong with them.
//!
//! [`reader`] reads a file of bounded size and [`text`] cuts it into lines and numbers; [`config`] and [`scene`] are
//! the two formats, [`material`] and [`size`] parts of them; [`error`] has every message. Uses [`math`](crate::math).
//! Begin with [`config::Config`].

pub mod config;
pub mod error;
pub mod material;
pub mod reader;
pub mod scene;
pub mod size;
pub mod text;
