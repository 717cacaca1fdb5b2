//! Second readers of every format, written from its description alone, plain and slow: what the real ones must agree
//! with.

pub mod config;
pub mod lines;
pub mod picture;
pub mod scene;
