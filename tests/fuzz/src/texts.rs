//! The fuzz targets `config` and `scene`: read any bytes as an input file.

use std::fmt::Debug;

use cpu::internals::geometry::camera::Camera;
use cpu::internals::input::error::MAX_PIXELS;
use cpu::{Config, Error, Scene};

use crate::plain;

/// Checks a configuration with `agreed`. For every valid configuration, `image_size` and `Camera::new` must return a
/// value or an error.
///
/// # Panics
/// If a check fails.
pub fn config(bytes: &[u8]) {
    let config = agreed(bytes, |bytes| Config::parse(bytes), plain::config::parse, generator::write::config);
    let Some((config, Ok(size))) = config.map(|config| (config.clone(), config.image_size())) else { return };
    assert!(size.pixels() as u64 <= MAX_PIXELS);
    let _ = Camera::new(&config, size);
}

/// Checks a scene with `agreed`.
///
/// # Panics
/// If a check fails.
pub fn scene(bytes: &[u8]) {
    agreed(bytes, |bytes| Scene::parse(bytes), plain::scene::parse, generator::write::scene);
}

/// Checks that the real parser and the plain parser return the same value or the same message, and that a value does
/// not change when it is written and read again. Returns the value, if there is one.
fn agreed<T: PartialEq + Debug>(
    bytes: &[u8],
    real: fn(&[u8]) -> Result<T, Error>,
    plain: fn(&[u8]) -> Result<T, Vec<u8>>,
    write: fn(&T) -> String,
) -> Option<T> {
    match (real(bytes), plain(bytes)) {
        (Ok(value), Ok(plain)) => {
            assert_eq!(value, plain);
            let written = write(&value);
            assert_eq!(real(written.as_bytes()).as_ref().ok(), Some(&value), "{written}");
            Some(value)
        }
        (Err(error), Err(plain)) => {
            let message = error.message();
            assert!(message == plain, "{} instead of {}", message.escape_ascii(), plain.escape_ascii());
            None
        }
        (real, plain) => panic!("{real:?} where the plain parser says {plain:?}"),
    }
}
