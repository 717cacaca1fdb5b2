//! The fuzz target `config`: reads any bytes as a configuration file.

use cpu::Config;

use crate::plain;

/// Checks that the real parser and the plain parser return the same value or the same message. Also checks that a value
/// does not change when it is written and read again.
///
/// # Panics
/// If a check fails.
pub fn check(bytes: &[u8]) {
    let real = Config::parse(bytes);
    match (real, plain::config::parse(bytes)) {
        (Ok(real), Ok(plain)) => {
            assert_eq!(real, plain);
            let written = generator::write::config(&real);
            assert_eq!(Config::parse(written.as_bytes()).ok(), Some(real.clone()), "{written}");
            // For every valid configuration, `image_size` and `Camera::new` return a value or an error.
            if let Ok(size) = real.image_size() {
                assert!(size.pixels() as u64 <= cpu::internals::input::error::MAX_PIXELS);
                let _ = cpu::internals::geometry::camera::Camera::new(&real, size);
            }
        }
        (Err(real), Err(plain)) => {
            let (real, plain) = (real.message(), plain);
            assert!(real == plain, "{} instead of {}", real.escape_ascii(), plain.escape_ascii());
        }
        (real, plain) => panic!("{real:?} where the plain parser says {plain:?}"),
    }
}
