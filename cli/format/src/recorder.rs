//! A reader that stores the last line read, so that an error message can show it.

use std::io::{self, BufRead, Read};

use crate::hint::{MOST_NAMES, material};

/// A reader that passes on the bytes of another reader. It stores the last line with its number, and the names of
/// materials.
#[derive(Debug)]
pub struct Recorder<R> {
    inner: R,
    line: Vec<u8>,
    number: u64,
    is_complete: bool,
    names: Vec<Vec<u8>>,
}

impl<R: BufRead> Recorder<R> {
    /// Returns a recorder that passes on the bytes of `inner`.
    pub const fn new(inner: R) -> Self {
        Self { inner, line: Vec::new(), number: 1, is_complete: false, names: Vec::new() }
    }

    /// Returns the last line that was read: its number, counted from 1, and its bytes without the line end.
    pub fn last_line(&self) -> (u64, &[u8]) {
        let line = self.line.strip_suffix(b"\n").unwrap_or(&self.line);
        (self.number, line.strip_suffix(b"\r").unwrap_or(line))
    }

    /// Returns the names of the materials in the lines read so far, at most 10,000.
    pub fn names(&self) -> &[Vec<u8>] {
        &self.names
    }

    /// Adds a name, as if a line defined it.
    pub(crate) fn add_name(&mut self, name: Option<Vec<u8>>) {
        self.names.extend(name);
    }

    /// Adds the next bytes of the file. Keeps the line that they reach, and the names that complete lines define.
    fn record(&mut self, bytes: &[u8]) {
        for piece in bytes.split_inclusive(|&byte| byte == b'\n') {
            if self.is_complete {
                self.line.clear();
                self.number += 1;
            }
            self.line.extend_from_slice(piece);
            self.is_complete = piece.ends_with(b"\n");
            if self.is_complete && self.names.len() < MOST_NAMES {
                self.names.extend(material(&self.line).map(<[u8]>::to_vec));
            }
        }
    }
}

impl<R: BufRead> Read for Recorder<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.fill_buf()?.read(buffer)?;
        self.consume(count);
        Ok(count)
    }
}

impl<R: BufRead> BufRead for Recorder<R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        self.inner.fill_buf()
    }

    fn consume(&mut self, count: usize) {
        // The consumed bytes are still in the buffer, so this call of `fill_buf` does not read from the file.
        let piece = self.inner.fill_buf().map(|buffer| buffer[..count.min(buffer.len())].to_vec());
        if let Ok(piece) = piece {
            self.record(&piece);
        }
        self.inner.consume(count);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::BufReader;

    #[test]
    fn the_line_read_last_is_known_with_its_number() {
        let text = b"matte: a 1 1 1\r\n\nmetal: bc 1 1 1 0\nsphere";
        for capacity in [1, 2, 7, 100] {
            let mut recorder = Recorder::new(BufReader::with_capacity(capacity, &text[..]));
            let mut line = Vec::new();
            let mut seen = Vec::new();
            while recorder.read_until(b'\n', &mut line).expect("it is in memory") > 0 {
                let (number, text) = recorder.last_line();
                seen.push((number, String::from_utf8_lossy(text).into_owned()));
                line.clear();
            }
            let expected = [(1, "matte: a 1 1 1"), (2, ""), (3, "metal: bc 1 1 1 0"), (4, "sphere")];
            assert_eq!(seen, expected.map(|(number, text)| (number, text.to_owned())), "{capacity}");
            assert_eq!(recorder.names(), [b"a".to_vec(), b"bc".to_vec()]);
        }
    }
}
