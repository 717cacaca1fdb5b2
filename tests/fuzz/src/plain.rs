//! A second, plain reader of each format: configuration, scene and picture. These readers are simple and slow, and each
//! is written only from the description of its format. The fuzz targets compare the real readers with them.

pub mod config;
pub mod lines;
pub mod picture;
pub mod scene;
