//! Tests of reading pictures in both formats, and of files that are refused.

use super::*;

const TEXT: &[u8] = b"P3\n2 2\n255\n0 0 0\n1 2 3\n255 255 255\n10 20 30\n";

fn sample() -> Picture {
    Picture { width: 2, height: 2, pixels: vec![[0; 3], [1, 2, 3], [255; 3], [10, 20, 30]] }
}

#[test]
fn all_formats_hold_the_same_picture() {
    let mut png = Vec::new();
    sample().write_png(&mut png).expect("memory takes all bytes");
    let raw = b"P6 2 2 255\n\0\0\0\x01\x02\x03\xff\xff\xff\x0a\x14\x1e";
    let free = b"P3 # made by hand\n2\t2 # size\n255 0 0 0 1 2 3\n\n255 255 255 10 20 30";
    let cr = b"P3 # ends in CR\r2 2\r255 # too\r0 0 0 1 2 3 255 255 255 10 20 30\r";
    let tail = b"P3 2 2 255#\n0 0 0 1 2 3 255 255 255 10 20 30 # the end";
    let ends = [["#6\n", "\n"], ["#6\n ", ""], [" #6\n", ""], ["\n# 6\n", ""], ["\n", "\r\n"]];
    let raws = ends.map(|[end, tail]| [&raw[..10], end.as_bytes(), &raw[11..], tail.as_bytes()].concat());
    for bytes in [TEXT, &png, raw, free, cr, tail].into_iter().chain(raws.iter().map(Vec::as_slice)) {
        assert_eq!(Picture::parse(bytes), Ok(sample()), "{}", bytes.escape_ascii());
    }
}

#[test]
fn damaged_pictures_are_refused() {
    let texts: [&[u8]; 10] = [
        b"",
        b"P3\n",
        b"P3 1 1 255 0 0 0 0",
        b"P3 0 0 255",
        b"P6 1 1 255\n\0\0",
        b"P6 1 1 255\n\x01\x02\x03\n\n\n",
        b"P6 1 1 255x\0\0\0",
        b"P6 1 1 255\r\n\x01\x02\n",
        b"P6 1 1 255",
        b"P31 1 255 0 0 0",
    ];
    for bytes in texts {
        assert!(Picture::parse(bytes).is_err(), "{}", bytes.escape_ascii());
    }
    for crlf in [&b"P6\r\n1 1\r\n255\r\n\x01\x02\x03"[..], b"P6 1 1 255\r\n\x01\r\n\x03"] {
        let message = Picture::parse(crlf).expect_err("netpbm would shift the pixels");
        assert!(message.contains("ends in CR LF") && message.contains("binary mode"), "{message}");
    }
    let message = Picture::parse(b"\xff\xfeP\x003\0").expect_err("PowerShell has changed it");
    assert!(message.contains("the byte order mark of UTF-16; save"), "{message}");
    assert!(Picture::parse(b"P3 99999999999 9999999 255 0").is_err(), "a size that lies takes no memory");
    for (text, words) in [
        ("P3 1 1\n255\n0 1.5 2\n", "line 3 of this PPM has [1.5] where a whole number belongs"),
        ("P3 1 1\n255\n0 256", "line 3 of this PPM has [256] where a number up to 255 belongs"),
        (
            "P3 1 1 255 0 9999999999999999999999",
            "line 1 of this PPM has [99999999999999999999] where a smaller number belongs",
        ),
        ("P3 1 1 255 0 1", "a PPM that ends before its last number"),
        ("P3 1 1 65535 0 1 2", "a PPM whose largest value is 65535, not 255; pamdepth 255 of netpbm converts it"),
    ] {
        assert_eq!(Picture::parse(text.as_bytes()), Err(words.to_owned()));
    }
    assert!(Picture::parse(b"\x89PNG\r\n\x1a\nrest").is_err());
}

#[test]
fn a_png_that_announces_more_than_it_holds_takes_no_memory() {
    let mut bytes = Vec::new();
    // This is a header, and pixels that end before they begin.
    let mut writer = ::png::Encoder::new(&mut bytes, 8192, 8192).write_header().expect("memory takes all bytes");
    writer.write_chunk(::png::chunk::IDAT, b"").expect("memory takes all bytes");
    drop(writer);
    let message = Picture::parse(&bytes).expect_err("it cannot hold them");
    assert!(message.starts_with("a PNG that announces 67"), "{message}");
}

#[test]
fn a_palette_that_ends_within_a_colour_is_refused() {
    let png = |palette: &[u8]| {
        let set = |encoder: &mut Encoder| {
            encoder.set_color(::png::ColorType::Indexed);
            encoder.set_palette(palette.to_vec());
        };
        Picture::parse(&encoded([1, 1], set, &[0]))
    };
    assert_eq!(png(&[1, 2, 3, 4, 5, 6]).map(|picture| picture.pixels), Ok(vec![[1, 2, 3]]));
    for length in [4, 5, 13] {
        assert_eq!(png(&vec![0; length]), Err("a PNG whose palette ends within a colour".to_owned()));
    }
}

type Encoder<'a> = ::png::Encoder<'static, &'a mut Vec<u8>>;

/// Returns a PNG of these bytes. `set` may change its kind, which is grey with 8 bits.
fn encoded([width, height]: [u32; 2], set: impl FnOnce(&mut Encoder<'_>), data: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut bytes, width, height);
    set(&mut encoder);
    let mut writer = encoder.write_header().expect("memory takes all bytes");
    writer.write_image_data(data).expect("memory takes all bytes");
    writer.finish().expect("memory takes all bytes");
    bytes
}

/// Returns a black greyscale PNG with one bit a pixel. The file is far smaller than its pixels.
fn black_png(width: u32, height: u32) -> Vec<u8> {
    let data = vec![0; (width as usize).div_ceil(8) * height as usize];
    encoded([width, height], |encoder| encoder.set_depth(::png::BitDepth::One), &data)
}

#[test]
fn a_picture_of_exactly_the_limit_is_read_and_one_row_more_refused() {
    let row = 8192;
    let most = black_png(row, MAX_PIXELS as u32 / row);
    assert!(most.len() < 100_000, "{} bytes", most.len());
    assert_eq!(Picture::parse(&most).map(|picture| picture.pixels.len()), Ok(MAX_PIXELS));
    let refused = Err("it has more than 67108864 pixels".to_owned());
    assert_eq!(Picture::parse(&black_png(row, MAX_PIXELS as u32 / row + 1)), refused);
    for text in ["P3 8192 8193 255 ", "P6 8192 8193 255\n", "P3 18446744073709551615 2 255 "] {
        assert_eq!(Picture::parse(text.as_bytes()), refused, "{text}");
    }
    assert!(Picture::parse(b"P6 8192 8192 255\n").is_err_and(|message| message.starts_with("0 bytes of pixels")));
}

#[test]
fn sixteen_bits_are_rounded_and_alpha_is_left_out_with_a_note() {
    let read = |bytes: &[u8]| {
        let mut notes = Vec::new();
        let read = png::decode(io::Cursor::new(bytes), bytes.len() as u64, &mut notes);
        (read.expect("it is a picture").pixels, notes.join("; "))
    };
    let deep = |encoder: &mut Encoder<'_>| encoder.set_depth(::png::BitDepth::Sixteen);
    // 255 / 65535 is 1 / 257, so 128 of 257 are rounded down, and 129 up.
    let bytes = encoded([4, 1], deep, &[0, 128, 0, 129, 255, 255, 3, 3]);
    assert_eq!(read(&bytes), (vec![[0; 3], [1; 3], [255; 3], [3; 3]], "its 16 bits a channel are rounded to 8".into()));
    assert_eq!(read(&encoded([1, 1], deep, &[7, 7])), (vec![[7; 3]], String::new()));
    let alpha = |encoder: &mut Encoder<'_>| encoder.set_color(::png::ColorType::Rgba);
    let note = "1 of its 2 pixels are not opaque; alpha is left out, their colours count";
    let bytes = encoded([2, 1], alpha, &[1, 2, 3, 255, 4, 5, 6, 254]);
    assert_eq!(read(&bytes), (vec![[1, 2, 3], [4, 5, 6]], note.to_owned()));
    assert_eq!(read(&encoded([1, 1], alpha, &[1, 2, 3, 255])).1, "");
    // A colour of a palette may be transparent, and so may a shade of grey.
    let palette = |encoder: &mut Encoder<'_>| {
        encoder.set_color(::png::ColorType::Indexed);
        encoder.set_palette(vec![9, 8, 7, 1, 2, 3]);
        encoder.set_trns(vec![0]);
    };
    assert_eq!(read(&encoded([2, 1], palette, &[0, 1])), (vec![[9, 8, 7], [1, 2, 3]], note.to_owned()));
    let grey = |encoder: &mut Encoder<'_>| encoder.set_trns(vec![0, 5]);
    assert_eq!(read(&encoded([2, 1], grey, &[5, 6])), (vec![[5; 3], [6; 3]], note.to_owned()));
}

#[test]
fn a_part_is_cut_out_row_by_row() {
    let right = Picture { width: 1, height: 2, pixels: vec![[1, 2, 3], [10, 20, 30]] };
    assert_eq!(sample().crop([1, 0, 1, 2]).expect("it is small"), right);
    assert_eq!(sample().crop([0, 0, 2, 2]).expect("it is small"), sample());
    for part in [[1, 0, 2, 1], [0, 2, 1, 1], [0, 0, 1, usize::MAX]] {
        assert_eq!(sample().crop(part), Err("--crop goes beyond the picture of 2 x 2 pixels".to_owned()));
    }
}
