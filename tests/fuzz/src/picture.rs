//! Any bytes as a picture that `render-lab compare` is given.

use lab::picture::Picture;

use crate::plain;

/// How many bytes of pixels a byte of a PNG can stand for: deflate's 1032, eight pixels a byte, three channels each.
const LARGEST_GROWTH: usize = 1032 * 8 * 3;

/// A PPM is read exactly as the plain reader does; whatever is read is no larger than its file can hold, and is written
/// and read again without a change.
///
/// # Panics
/// When it does not hold.
pub fn check(bytes: &[u8]) {
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
    // Most pictures are small; a large one takes the time of many small ones and shows nothing new.
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
