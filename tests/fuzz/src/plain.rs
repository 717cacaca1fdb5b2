//! A second reader of each format: configuration, scene and picture. Each is simple and slow, and written from the
//! description of its format alone. The fuzz targets compare the real readers with these.

pub mod config;
pub mod lines;
pub mod picture;
pub mod scene;
