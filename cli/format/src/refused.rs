//! Input files that a program must refuse, with the exact message. The tests of `render-aos` and `render-soa` use this
//! table, and `render-lab check` holds any other program to it.

use crate::hint::Kind;

/// A wrong line of an input file.
#[derive(Clone, Debug)]
pub struct Refused {
    /// The file with the line.
    pub kind: Kind,
    /// The line, without a line end. In two cases a second line follows.
    pub line: String,
    /// The message on standard error, without `Error: ` and without the line end.
    pub message: String,
    /// Whether the statement says that the line is wrong. Other lines are wrong by the specification alone.
    pub is_stated: bool,
}

/// A configuration of 8 x 4 pixels, which is rendered quickly.
pub const SMALL: &str = "image_width: 8\naspect_ratio: 2 1\nsamples_per_pixel: 2\n";

/// The lines above the wrong line of a scene.
const MATERIALS: &str = "matte: mat1 0 0.8 0.8\nmetal: metal1 0 0.8 0 2.0\n\nrefractive: ref99 1.3\n";

impl Refused {
    /// Returns the contents of the configuration and the scene.
    #[must_use]
    pub fn files(&self) -> [Vec<u8>; 2] {
        match self.kind {
            Kind::Config => [format!("{}\n{SMALL}", self.line).into(), Vec::new()],
            Kind::Scene => [SMALL.into(), format!("{MATERIALS}{}\nnever read", self.line).into()],
        }
    }

    /// Returns the section of the specification with the message.
    #[must_use]
    pub const fn section(&self) -> &'static str {
        match self.kind {
            Kind::Config => "3.4",
            Kind::Scene => "4.3",
        }
    }
}

/// Returns all wrong lines, from `refused.txt`. A line of that file has the kind of the input file and perhaps
/// `unstated`, the wrong line, and the message.
///
/// # Panics
/// If a line of `refused.txt` has not these three parts.
#[must_use]
pub fn all() -> Vec<Refused> {
    let row = |row: &str| {
        let [kind, line, message] = row.split(" => ").collect::<Vec<_>>()[..] else { panic!("not three parts: {row}") };
        let escapes = [("\\n", "\n"), ("\\t", "\t"), ("\\r", "\r"), ("\\0", "\0"), ("\\ufeff", "\u{feff}")];
        let [line, message] =
            [line, message].map(|text| escapes.iter().fold(text.to_owned(), |text, (from, to)| text.replace(from, to)));
        let of = if kind.starts_with("config") { Kind::Config } else { Kind::Scene };
        Refused { kind: of, line, message, is_stated: !kind.ends_with(" unstated") }
    };
    include_str!("refused.txt").lines().map(row).collect()
}
