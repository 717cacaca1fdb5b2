//! The pictures that a program is expected to draw.

use cpu::{Aos, Config, Layout, Scatter, Scene};

use crate::Failure;
use crate::picture::Picture;

/// The ways to scatter that a program may follow: that of the statement, and that of the published pictures.
pub const CONVENTIONS: [Scatter; 2] = [Scatter::Statement, Scatter::Published];

/// An expected picture.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The picture.
    pub picture: Picture,
    /// SHA-256 of its file, in hexadecimal digits.
    pub digest: String,
}

impl Drawn {
    /// Renders a configuration and a scene by the reference, which follows the specification line by line. A large
    /// picture would take too long there, so the renderer makes it.
    ///
    /// # Errors
    /// An error of the renderer or of its input.
    pub fn new([config, scene]: [&[u8]; 2], scatter: Scatter, is_large: bool) -> Result<Self, Failure> {
        let (config, scene) = (Config::parse(config)?, Scene::parse(scene)?);
        let image = if is_large {
            cpu::render::<Aos>(&config, &scene, scatter)?
        } else {
            cpu::reference::render::<<Aos as Layout>::Image>(&config, &scene, scatter)?
        };
        let mut ppm = Vec::new();
        cpu::internals::image::ppm::write_ppm(&image, &mut ppm)?;
        Ok(Self { picture: Picture::of(&image)?, digest: digest::sha256(&ppm) })
    }
}
