//! The two text files as checked values, and the error for each fault that they can have.
//!
//! [`reader`] reads a file of bounded size. [`text`] cuts it into lines and numbers. [`config`] and [`scene`] parse the
//! two formats, and [`material`] and [`size`] have values of these formats. [`error`] has their messages. Uses
//! [`math`](crate::math). Begin with [`config::Config`].

pub mod config;
pub mod error;
pub mod material;
pub mod reader;
pub mod scene;
pub mod size;
pub mod text;
