//! Checkpoints: files from which `render` goes on with a picture that was not finished (docs/files.md).
//!
//! A checkpoint is a line of JSON (`Header`), the words of both random streams, the bytes of all finished rows, and
//! the SHA-256 digest of all this.

use std::io;
use std::ops::Range;
use std::path::Path;

use cpu::internals::Streams;
use cpu::internals::input::reader;
use cpu::{Config, Image, Rgb, Scene, Size};
use output::{Options, Output};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::picture::with_room;
use crate::{Failure, terminal};

/// Largest size in bytes of the header and the streams.
const MOST_BEFORE_PIXELS: u64 = 1 << 16;
const DIGEST_BYTES: usize = 32;
/// Number of this format of checkpoints. Increase it if the words of the random streams or the [`Header`] change.
const FORMAT: u32 = 1;

/// What decides the bytes of a picture. A checkpoint is of use only where all of it is the same.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Origin {
    version: String,
    scatter: String,
    config_sha256: String,
    scene_sha256: String,
}

impl Origin {
    /// Returns the origin of the picture of these inputs by this version of the program.
    pub fn new(config: &Config, scene: &Scene, scatter: &str) -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            scatter: scatter.to_owned(),
            // Two inputs with the same meaning have the same text.
            config_sha256: format::digest::sha256(generator::write::config(config).as_bytes()),
            scene_sha256: format::digest::sha256(generator::write::scene(scene).as_bytes()),
        }
    }

    /// Returns what is wrong with a checkpoint of `self` for a picture of `wanted`, or `Ok`.
    fn check(&self, wanted: &Self) -> Result<(), String> {
        if self.version != wanted.version {
            return Err(format!("it is of render-lab {}, and this is {}", self.version, wanted.version));
        }
        if self.scatter != wanted.scatter {
            let (old, new) = (&self.scatter, &wanted.scatter);
            return Err(format!("it was made with --scatter {old}, and this run has --scatter {new}"));
        }
        match (self.config_sha256 == wanted.config_sha256, self.scene_sha256 == wanted.scene_sha256) {
            (true, true) => Ok(()),
            (false, _) => Err("it is of another configuration, or of other values of --set".to_owned()),
            (true, false) => Err("it is of another scene".to_owned()),
        }
    }
}

/// The first line of a checkpoint.
#[derive(Debug, Serialize, Deserialize)]
struct Header {
    #[serde(default)]
    format: u32,
    #[serde(flatten)]
    origin: Origin,
    width: usize,
    height: usize,
    /// Number of finished rows: the row to render next.
    rows: usize,
    /// Number of words of the random streams.
    words: usize,
}

/// A picture that was not finished.
#[derive(Debug)]
pub struct Checkpoint {
    /// Number of finished rows.
    pub rows: usize,
    /// The states of the random streams after these rows; see [`Streams::visit`].
    pub words: Vec<u64>,
    /// The bytes of the file, and where the channels of the pixels of the finished rows lie.
    bytes: Vec<u8>,
    pixels: Range<usize>,
}

impl Checkpoint {
    /// Reads the checkpoint of a picture of `size` pixels.
    ///
    /// # Errors
    /// A message if the file cannot be read, is damaged, or is of another origin.
    pub fn read(path: &Path, wanted: &Origin, size: Size) -> Result<Self, Failure> {
        let most = MOST_BEFORE_PIXELS + 3 * size.pixels() as u64;
        let parsed = reader::read(path, most).map_err(|error| match error.kind() {
            io::ErrorKind::FileTooLarge => "it is larger than a checkpoint of this picture".to_owned(),
            _ => error.to_string(),
        });
        let parsed = parsed.and_then(|bytes| Self::parse(bytes, wanted, size));
        parsed.map_err(|reason| format!("the checkpoint {} cannot be used: {reason}", terminal::name(path)).into())
    }

    fn parse(bytes: Vec<u8>, wanted: &Origin, size: Size) -> Result<Self, String> {
        const DAMAGED: &str = "it is damaged, or no checkpoint; start again without --resume";

        let (content, sum) = bytes.split_last_chunk::<DIGEST_BYTES>().ok_or(DAMAGED)?;
        if Sha256::digest(content)[..] != sum[..] {
            return Err(DAMAGED.to_owned());
        }
        let end = content.iter().position(|&byte| byte == b'\n').ok_or(DAMAGED)?;
        let header: Header = serde_json::from_slice(&content[..end]).map_err(|_| DAMAGED)?;
        header.origin.check(wanted)?;
        if header.format != FORMAT || header.words != Streams::count() {
            return Err("it is of another build of render-lab; start again without --resume".to_owned());
        }
        let is_of_size = (header.width, header.height) == (size.width(), size.height()) && header.rows <= header.height;
        let (words, pixels) = content[end + 1..].split_at_checked(header.words.saturating_mul(8)).ok_or(DAMAGED)?;
        if !is_of_size || pixels.len() != 3 * header.rows * size.width() {
            return Err(DAMAGED.to_owned());
        }
        let words = words.as_chunks().0.iter().map(|&word| u64::from_le_bytes(word)).collect();
        let pixels = content.len() - pixels.len()..content.len();
        Ok(Self { rows: header.rows, words, bytes, pixels })
    }

    /// Copies the finished rows into `image`.
    pub fn fill(&self, image: &mut impl Image) {
        for (index, &[red, green, blue]) in self.bytes[self.pixels.clone()].as_chunks().0.iter().enumerate() {
            image.set_pixel(index, Rgb { red, green, blue });
        }
    }

    /// Replaces the file at `path` by the checkpoint of the first `rows` rows of `image`, completely or not at all.
    ///
    /// # Errors
    /// An error of the file, or of memory.
    pub fn write(
        (path, options): (&Path, Options),
        origin: &Origin,
        (rows, image): (usize, &impl Image),
        streams: &mut Streams<'_>,
    ) -> Result<(), Failure> {
        let mut words = Vec::new();
        streams.visit(|word| words.extend(word.to_le_bytes()));
        let size = image.size();
        let (origin, width, height) = (origin.clone(), size.width(), size.height());
        let header = Header { format: FORMAT, origin, width, height, rows, words: words.len() / 8 };
        let mut bytes = with_room(MOST_BEFORE_PIXELS as usize + 3 * rows * width)?;
        serde_json::to_writer(&mut bytes, &header).map_err(io::Error::from)?;
        bytes.push(b'\n');
        bytes.extend(words);
        for index in 0..rows * width {
            let Rgb { red, green, blue } = image.pixel(index);
            bytes.extend([red, green, blue]);
        }
        bytes.extend(Sha256::digest(&bytes));
        let output = Output::open(path, options)?;
        Ok(output.fill(|file| file.write_all(&bytes))?)
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::ops::ControlFlow;

    use cpu::internals::Prepared;
    use cpu::{Scatter, Soa};
    use test_support::folder::Folder;

    use super::*;
    use crate::engine;

    #[test]
    fn every_damage_is_refused_and_a_whole_checkpoint_of_other_inputs_too() {
        let config = Config::parse(&b"image_width: 6\nsamples_per_pixel: 2\n"[..]).expect("it is valid");
        let scene = generator::scene(&generator::Options::default());
        let prepared = Prepared::<Soa>::new(&config, &scene, Scatter::Statement).expect("it is small");
        let (folder, origin) = (Folder::new(), Origin::new(&config, &scene, "statement"));
        let path = folder.file("c");
        engine::render_rows::<Soa>(&prepared, None, |rows, image, streams| {
            let how = (&*path, Options::default());
            Checkpoint::write(how, &origin, (rows, image), streams).expect("the folder is writable");
            if rows == 2 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        })
        .expect("it is small");
        let bytes = fs::read(&path).expect("it was written");
        let parse = |bytes: &[u8], origin: &Origin| {
            Checkpoint::parse(bytes.to_vec(), origin, prepared.size).map(|whole| whole.rows)
        };
        assert_eq!(parse(&bytes, &origin), Ok(2));
        for at in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[at] ^= 1;
            assert!(parse(&damaged, &origin).is_err() && parse(&bytes[..at], &origin).is_err(), "{at}");
        }
        let refused = |change: fn(&mut Origin)| {
            let mut origin = origin.clone();
            change(&mut origin);
            parse(&bytes, &origin).expect_err("it is another origin")
        };
        assert!(refused(|origin| origin.version = "9".to_owned()).contains("of render-lab 0."));
        assert!(refused(|origin| origin.scatter = "published".to_owned()).contains("--scatter statement, and"));
        assert!(refused(|origin| origin.config_sha256.clear()).contains("another configuration"));
        assert!(refused(|origin| origin.scene_sha256.clear()).contains("another scene"));
        // A header that is senseless, with the right digest.
        for header in ["{}", "{\"rows\":99999999999999999999}", ""] {
            let mut forged = format!("{header}\n").into_bytes();
            forged.extend(Sha256::digest(&forged));
            assert!(parse(&forged, &origin).is_err());
        }
        // A header with another number, and the right digest.
        let end = bytes.iter().position(|&byte| byte == b'\n').expect("a header is a line");
        let (header, rest) = bytes[..bytes.len() - DIGEST_BYTES].split_at(end);
        let forged = |name: &str, number: usize| {
            let wanted = format!("\"{name}\":{number},\"x\":");
            let header = str::from_utf8(header).expect("it is JSON").replace(&format!("\"{name}\":"), &wanted);
            let mut forged = [header.as_bytes(), rest].concat();
            forged.extend(Sha256::digest(&forged));
            parse(&forged, &origin).expect_err("it is forged")
        };
        for (name, number) in [("words", usize::MAX), ("words", 0), ("words", Streams::count() + 3), ("format", 0)] {
            assert!(forged(name, number).contains("another build"), "{name} {number}");
        }
        assert!(forged("rows", 1).contains("damaged"));
    }
}
