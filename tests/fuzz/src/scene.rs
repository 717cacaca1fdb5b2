//! The fuzz target `scene`: reads any bytes as a scene file.

use cpu::Scene;

use crate::plain;

/// Checks that the real parser and the plain parser return the same value or the same message. Also checks that a value
/// does not change when it is written and read again.
///
/// # Panics
/// If a check fails.
pub fn check(bytes: &[u8]) {
    match (Scene::parse(bytes), plain::scene::parse(bytes)) {
        (Ok(real), Ok(plain)) => {
            assert_eq!(real, plain);
            let written = generator::write::scene(&real);
            assert_eq!(Scene::parse(written.as_bytes()).ok(), Some(real), "{written}");
        }
        (Err(real), Err(plain)) => {
            let real = real.message();
            assert!(real == plain, "{} instead of {}", real.escape_ascii(), plain.escape_ascii());
        }
        (real, plain) => panic!("{real:?} where the plain parser says {plain:?}"),
    }
}
