//! Reads PPM files, P3 and P6, with comments and any white space, and writes P3.

use std::io::{self, BufRead, Read, Seek, SeekFrom, Write};

use cpu::{Error, Image, Rgb, Size};

use super::{Picture, check_pixels, with_room};
use crate::format::hint::shown;

const CR_LF: &str = "the header of this P6 ends in CR LF, as the text mode of Windows writes it, and one byte belongs \
                     there; write the file again in binary mode, with LF in the header, or as P3";
/// Length of a word that messages show.
const SHOWN: usize = 20;
/// Largest number of bytes of white space and comment between the header of a P6 and its pixels.
const MOST_BETWEEN: u64 = 1 << 16;

impl Picture {
    /// Writes the picture to `out` in the format PPM (P3), as the renderer does.
    ///
    /// # Errors
    /// An error of `out`.
    pub fn write_ppm(&self, out: impl Write) -> io::Result<()> {
        let explain = |error: cpu::internals::input::error::Picture| io::Error::other(error.to_string());
        let size = Size::new(self.width as u64, self.height as u64).map_err(explain)?;
        cpu::internals::image::ppm::write_ppm(&View(self, size), out)
    }
}

/// A picture as an image of the renderer, to be written.
struct View<'a>(&'a Picture, Size);

impl Image for View<'_> {
    fn black(_: Size) -> Result<Self, Error> {
        Err(Error::OutOfMemory { what: "a picture that is only written" })
    }

    fn size(&self) -> Size {
        self.1
    }

    fn pixel(&self, index: usize) -> Rgb {
        let [red, green, blue] = self.0.pixels[index];
        Rgb { red, green, blue }
    }

    fn set_pixel(&mut self, _: usize, _: Rgb) {}
}

/// Reads the picture in a PPM file of `length` bytes.
pub(super) fn decode(source: impl BufRead + Seek, length: u64) -> Result<Picture, String> {
    let mut words = Words { source, line: 1, at: 0, is_after_blank: false };
    let is_raw = [words.next()?, words.next()?] == [Some(b'P'), Some(b'6')];
    let [width, height, most] = [words.number()?, words.number()?, words.number()?];
    if most != 255 {
        return Err(format!("a PPM whose largest value is {most}, not 255; pamdepth 255 of netpbm converts it"));
    }
    let count = check_pixels(width.checked_mul(height))?;
    if count == 0 {
        return Err("a PPM without pixels".to_owned());
    }
    let mut pixels;
    if is_raw {
        let start = words.at + start_of_pixels(&mut words, length, [width, height])?;
        pixels = with_room(count)?;
        pixels.resize(count, [0; 3]);
        let read = words.source.seek(SeekFrom::Start(start));
        read.and_then(|_| words.source.read_exact(pixels.as_flattened_mut())).map_err(|error| error.to_string())?;
    } else {
        // Each pixel needs at least six bytes, so no more memory is allocated than the file can fill.
        pixels = with_room(count.min((length / 6) as usize + 1))?;
        for _ in 0..count {
            pixels.push([words.byte()?, words.byte()?, words.byte()?]);
        }
        if words.skip()?.is_some() {
            return Err(format!("something follows the {count} pixels"));
        }
    }
    Ok(Picture { width, height, pixels })
}

/// Returns the number of bytes between the header of a P6 and its pixels.
///
/// Exactly one white-space byte separates them. After a comment, it is the line end of the comment or the byte behind,
/// so the number of bytes decides.
fn start_of_pixels(
    words: &mut Words<impl BufRead + Seek>,
    length: u64,
    [width, height]: [usize; 2],
) -> Result<u64, String> {
    let (mut head, source) = (Vec::new(), &mut words.source);
    source.by_ref().take(MOST_BETWEEN).read_to_end(&mut head).map_err(|error| error.to_string())?;
    let (rest, wanted) = (length.saturating_sub(words.at), 3 * (width * height) as u64);
    let is_blank = |at: usize| head.get(at).is_some_and(u8::is_ascii_whitespace);
    let comment = head.iter().position(|byte| !byte.is_ascii_whitespace()).filter(|&at| head[at] == b'#');
    let end = comment.and_then(|start| Some(start + head[start..].iter().position(|byte| b"\r\n".contains(byte))?));
    let after = end.map_or([0; 2], |end| [end + 1, if is_blank(end + 1) { end + 2 } else { 0 }]);
    let starts = [usize::from(is_blank(0)), after[0], after[1]];
    let mut starts = starts.into_iter().filter(|&start| start > 0).map(|start| start as u64).peekable();
    let Some(&first) = starts.peek() else {
        return Err("a PPM whose header does not end in white space".to_owned());
    };
    let mut fitting = None;
    for start in starts {
        // Some programs end the file in a line end.
        let tail = rest.checked_sub(start + wanted).filter(|&tail| tail <= 2);
        let Some(tail) = tail else { continue };
        let mut bytes = [0; 2];
        let read = source.seek(SeekFrom::Start(length - tail));
        let read = read.and_then(|_| source.read_exact(&mut bytes[..tail as usize]));
        read.map_err(|error| error.to_string())?;
        if fitting.is_none() && [&b""[..], b"\n", b"\r\n"].contains(&&bytes[..tail as usize]) {
            fitting = Some(start);
        }
    }
    match fitting {
        _ if head.starts_with(b"\r\n") && rest.saturating_sub(first) > wanted => Err(CR_LF.to_owned()),
        Some(start) => Ok(start),
        None => {
            let found = rest.saturating_sub(first);
            Err(format!("{found} bytes of pixels where {width} x {height} are announced"))
        }
    }
}

/// The words of a text, with white space or comments between them.
struct Words<R> {
    source: R,
    /// The number of the line that is being read, from 1.
    line: usize,
    /// Number of bytes that were read.
    at: u64,
    /// Whether white space or a comment stands before the next byte.
    is_after_blank: bool,
}

impl<R: BufRead> Words<R> {
    fn peek(&mut self) -> Result<Option<u8>, String> {
        Ok(self.source.fill_buf().map_err(|error| error.to_string())?.first().copied())
    }

    fn next(&mut self) -> Result<Option<u8>, String> {
        let byte = self.peek()?;
        if byte.is_some() {
            self.source.consume(1);
            self.at += 1;
            self.line += usize::from(byte == Some(b'\n'));
        }
        Ok(byte)
    }

    /// Skips white space and comments. Returns the first byte behind them.
    fn skip(&mut self) -> Result<Option<u8>, String> {
        while let Some(byte) = self.peek()? {
            if byte == b'#' {
                while self.peek()?.is_some_and(|byte| !b"\r\n".contains(&byte)) {
                    self.next()?;
                }
            } else if byte.is_ascii_whitespace() {
                self.next()?;
            } else {
                return Ok(Some(byte));
            }
            self.is_after_blank = true;
        }
        Ok(None)
    }

    /// Reads the next number. White space or a comment must stand before it.
    fn number(&mut self) -> Result<usize, String> {
        if self.skip()?.is_none() {
            return Err("a PPM that ends before its last number".to_owned());
        }
        let is_after_blank = std::mem::take(&mut self.is_after_blank);
        let (mut number, mut word, mut length) = (Some(0_usize), [0; SHOWN], 0);
        while let Some(byte) = self.peek()?.filter(|byte| !byte.is_ascii_whitespace() && *byte != b'#') {
            if !byte.is_ascii_digit() || !is_after_blank {
                return Err(self.wrong(&word[..length], "a whole number"));
            }
            let digit = usize::from(byte - b'0');
            number = number.and_then(|number| number.checked_mul(10)?.checked_add(digit));
            word[length.min(SHOWN - 1)] = byte;
            length = SHOWN.min(length + 1);
            self.next()?;
        }
        number.ok_or_else(|| self.wrong(&word[..length], "a smaller number"))
    }

    fn byte(&mut self) -> Result<u8, String> {
        let number = self.number()?;
        u8::try_from(number).map_err(|_| self.wrong(number.to_string().as_bytes(), "a number up to 255"))
    }

    /// Returns the message for the word that begins with `start`, whose other bytes are read now.
    fn wrong(&mut self, start: &[u8], wanted: &str) -> String {
        let mut word = start.to_vec();
        while word.len() < SHOWN
            && let Ok(Some(byte)) = self.peek()
            && !byte.is_ascii_whitespace()
            && self.next().is_ok()
        {
            word.push(byte);
        }
        let word = shown(&word);
        format!("line {} of this PPM has [{word}] where {wanted} belongs", self.line)
    }
}
