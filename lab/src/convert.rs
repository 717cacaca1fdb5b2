//! Converts scenes of pbrt-v4 and Mitsuba 3 to ours, and ours to theirs.
//!
//! [`pbrt`] and [`mitsuba`] read the two formats into [`world`], [`mod@complete`] makes a configuration and a scene of
//! it, and [`write`](mod@write) writes both formats. [`mod@matches`] is the table of what has a match, and [`notes`]
//! collects what has none. Begin with [`world::World`].

pub mod complete;
pub mod matches;
pub mod materials;
pub mod mitsuba;
pub mod notes;
pub mod pbrt;
pub mod plugin;
pub mod sky;
pub mod tokens;
pub mod transform;
pub mod world;
pub mod write;

#[cfg(test)]
mod tests;
