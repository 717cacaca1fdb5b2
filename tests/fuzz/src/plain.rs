//! A second reader of each format: configuration, scene and picture. Each is written from the description of its format
//! alone, and is plain and slow. The fuzz targets compare the real readers with these.

pub mod config;
pub mod lines;
pub mod picture;
pub mod scene;
