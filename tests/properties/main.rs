//! Tests properties that hold for every scene and every input, with random cases, and the committed scenes.
//!
//! Every run tries the same cases. `RENDER_SEED` chooses other cases, and `RENDER_CASES` sets their
//! number. A failure shows the smallest failing case that was found, with its seeds.

mod cameras;
mod giants;
mod limits;
mod near_surfaces;
mod odd_scenes;
mod renderers_agree;
mod runner;
mod scenes;
mod ties;
