//! Any bytes as a configuration file.

use cpu::Config;

use crate::plain;

/// The real parser gives what the plain one gives, value or message; and a value survives being written and read.
///
/// # Panics
/// When it does not hold.
pub fn check(bytes: &[u8]) {
    let real = Config::parse(bytes);
    match (real, plain::config::parse(bytes)) {
        (Ok(real), Ok(plain)) => {
            assert_eq!(real, plain);
            let written = test_support::write::config(&real);
            assert_eq!(Config::parse(written.as_bytes()).ok(), Some(real.clone()), "{written}");
            // Whatever its values, asking for its size and its camera gives an answer.
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
