//! The fuzz target `picture`: reads any bytes as a picture with the reader of `render-lab compare`.

use lab::picture::any::{Any, Kind};
use lab::picture::floats::GAMMA;
use lab::picture::{MAX_PIXELS, Picture};

use crate::plain;

/// Upper bound on the number of pixels for each byte of a PNG. Deflate compresses by a factor of at most 1032, and a
/// byte holds at most eight pixels. The factor 3 for the channels is not needed; it makes the bound looser.
const LARGEST_GROWTH: usize = 1032 * 8 * 3;

/// Checks that the real reader and the plain reader agree on a PPM. Also checks that a picture has no more pixels than
/// its file can hold, and does not change when it is written and read again.
///
/// # Panics
/// If a check fails.
pub fn check(bytes: &[u8]) {
    if let Ok(Any::Floats(floats)) = Any::parse(bytes) {
        assert_eq!(floats.values.len(), floats.width * floats.height * floats.channels);
        // A part of a large EXR may have few bytes; the rest is black.
        assert!(floats.values.len() <= 3 * MAX_PIXELS);
        let kinds = [Kind::Pfm, Kind::Npy, Kind::Exr];
        for kind in kinds.into_iter().filter(|_| floats.values.len() < 1 << 12) {
            let mut written = Vec::new();
            Any::Floats(floats.clone()).write(kind, GAMMA, &mut written).expect("memory takes all bytes");
            let Ok(Any::Floats(again)) = Any::parse(&written) else { panic!("what is written can be read") };
            // NaN is not equal to itself, so the texts are compared. Only EXR tells that numbers are depths.
            assert_eq!((again.width, again.height), (floats.width, floats.height), "{kind:?}");
            assert_eq!(format!("{:?}", again.values), format!("{:?}", floats.values), "{kind:?}");
        }
        return;
    }
    let read = Picture::parse(bytes);
    if matches!(bytes, [b'P', b'3' | b'6', ..]) {
        let plain = plain::picture::ppm(bytes);
        let real = read.as_ref().ok().map(|picture| (picture.width, picture.height, picture.pixels.clone()));
        assert_eq!(real, plain, "{:?}", read.err());
    }
    let Ok(picture) = read else { return };
    assert!(picture.width > 0 && picture.height > 0);
    assert_eq!(picture.pixels.len(), picture.width * picture.height);
    assert!(picture.pixels.len() <= LARGEST_GROWTH * bytes.len());
    // A large picture takes the time of many small ones and finds no more errors, so it is not written.
    if picture.pixels.len() > 1 << 16 {
        return;
    }
    let (mut png, mut text) = (Vec::new(), Vec::new());
    picture.write_png(&mut png).expect("memory takes all bytes");
    assert_eq!(Picture::parse(&png).as_ref(), Ok(&picture));
    picture.write_ppm(&mut text).expect("memory takes all bytes");
    assert_eq!(Picture::parse(&text).as_ref(), Ok(&picture));
    let strict = test_support::p3::read(&text).expect("what is written is P3 (specification, section 5.3)");
    assert_eq!((strict.width, strict.height, strict.pixels), (picture.width, picture.height, picture.pixels));
}
