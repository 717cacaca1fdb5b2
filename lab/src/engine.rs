//! The implementations (engines) that the user can choose: the reference, or the real renderer with a layout and an
//! instruction set.

use std::fmt;
use std::ops::ControlFlow;

use clap::ValueEnum;
use cpu::internals::{InstructionSet, Limits, Prepared, Streams, render_from, render_with};
use cpu::{Aos, Config, Error, Layout, Renderable, Scatter, Scene, Soa, Vec3};

use crate::checkpoint::Checkpoint;

/// How objects and pixels lie in memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, ValueEnum)]
pub enum LayoutName {
    /// Arrays of structures
    #[default]
    Aos,
    /// Structures of arrays
    Soa,
}

/// How surfaces scatter light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum ScatterName {
    /// A vector in a cube, as the statement says and the evaluated programs do
    #[default]
    Statement,
    /// A unit vector by rejection, as the published images have it
    Published,
    /// None, and one ray through the middle of each pixel: for comparing implementations
    Deterministic,
}

/// Returns the name of a value of an option.
pub fn name_of(value: &impl ValueEnum) -> String {
    value.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
}

impl From<ScatterName> for Scatter {
    fn from(name: ScatterName) -> Self {
        match name {
            ScatterName::Statement => Self::Statement,
            ScatterName::Published => Self::Published,
            ScatterName::Deterministic => Self::Deterministic,
        }
    }
}

/// An implementation that can render. Its text form is `reference`, or a layout and an instruction set such as
/// `soa-avx2`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Engine {
    /// The reference, which tests every ray against every object.
    Reference,
    /// The real renderer with this layout and this instruction set.
    Real(LayoutName, InstructionSet),
}

impl Engine {
    /// Returns every implementation that this machine can run.
    pub fn all() -> Vec<Self> {
        let sets = InstructionSet::available();
        let real = sets.flat_map(|set| [LayoutName::Aos, LayoutName::Soa].map(|layout| Self::Real(layout, set)));
        std::iter::once(Self::Reference).chain(real).collect()
    }

    /// Returns three implementations: the reference, and the real renderer in both layouts with the best instruction
    /// set.
    pub fn main() -> Vec<Self> {
        let best = InstructionSet::best();
        vec![Self::Reference, Self::Real(LayoutName::Aos, best), Self::Real(LayoutName::Soa, best)]
    }

    /// Returns the picture as the bytes of a PPM file. Measurements time this call: it does all the work of the
    /// evaluated programs except reading and writing files.
    ///
    /// # Errors
    /// An error of the renderer.
    pub fn ppm(self, config: &Config, scene: &Scene) -> Result<Vec<u8>, Error> {
        let statement = Scatter::Statement;
        Ok(match self {
            Self::Reference => bytes(&cpu::reference::render::<<Aos as Layout>::Image>(config, scene, statement)?),
            Self::Real(LayoutName::Aos, set) => {
                bytes(&render_with(&Prepared::<Aos>::new(config, scene, statement)?, set)?)
            }
            Self::Real(LayoutName::Soa, set) => {
                bytes(&render_with(&Prepared::<Soa>::new(config, scene, statement)?, set)?)
            }
        })
    }
}

/// Returns the bytes of the PPM file of a picture.
pub fn bytes(image: &impl cpu::Image) -> Vec<u8> {
    let mut bytes = Vec::new();
    // Writing to a `Vec` never fails.
    let _ = cpu::internals::image::ppm::write_ppm(image, &mut bytes);
    bytes
}

/// Returns the mean colours of all pixels in linear light, before they are quantised.
///
/// # Errors
/// An error of the renderer.
pub fn means(config: &Config, scene: &Scene) -> Result<Vec<Vec3>, Error> {
    let prepared = Prepared::<Aos>::new(config, scene, Scatter::Statement)?;
    let mut means = vec![Vec3::ZERO; prepared.size.pixels()];
    let limits = Limits::default();
    cpu::internals::render_linear(&prepared, InstructionSet::chosen(), &limits, |index, mean| means[index] = mean)?;
    Ok(means)
}

/// Renders with the real renderer, from the first row or from a checkpoint on, until `after_row` stops it. Returns the
/// image, and the number of its finished rows. Calls `after_row` as [`render_from`] does.
///
/// # Errors
/// An error of the renderer.
pub fn render_rows<L: Renderable>(
    prepared: &Prepared<L>,
    start: Option<&Checkpoint>,
    mut after_row: impl FnMut(usize, &L::Image, &mut Streams<'_>) -> ControlFlow<()>,
) -> Result<(L::Image, usize), Error> {
    let mut image = <L::Image as cpu::Image>::black(prepared.size)?;
    if let Some(start) = start {
        start.fill(&mut image);
    }
    let from = start.map_or((0, &[][..]), |start| (start.rows, &start.words));
    let mut done = from.0;
    let (set, limits) = (InstructionSet::chosen(), Limits::default());
    let _ = render_from(prepared, set, &limits, from, &mut image, |row, image, streams| {
        done = row;
        after_row(row, image, streams)
    })?;
    Ok((image, done))
}

impl fmt::Display for Engine {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Reference => out.write_str("reference"),
            Self::Real(layout, set) => write!(out, "{}-{}", name_of(layout), set.name()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_engine_makes_the_same_picture() {
        let config = Config::parse(&b"image_width: 24\nsamples_per_pixel: 3\n"[..]).expect("it is valid");
        let scene = generator::scene(&generator::Options { objects: 20, ..Default::default() });
        let expected = Engine::Reference.ppm(&config, &scene).expect("it is small");
        let engines = Engine::all();
        assert!(engines.len() >= 3, "the reference, and the portable one in two layouts");
        for engine in engines {
            assert!(engine.ppm(&config, &scene).expect("it is small") == expected, "{engine}");
        }
    }
}
