//! Properties that hold for every scene and every input, tried on random ones.
//!
//! Each run tries the same cases, unless the environment says otherwise: `RENDER_PROPERTY_SEED` chooses others,
//! `RENDER_PROPERTY_CASES` how many. A failure shows the smallest case found that still fails, with its seeds.

mod odd_scenes;
mod renderers_agree;
mod runner;
mod texts;
