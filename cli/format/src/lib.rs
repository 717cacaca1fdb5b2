//! Describes the two input files as tables: the fields of every line, their meaning and their allowed values.
//!
//! `cpu` decides which values are valid, and these tables explain it. `render-lab help config` and `help scene` print
//! the tables, and the page in `web/site` offers them as completions. Error messages use them to point at the wrong
//! field ([`place`]), and to say what to write instead ([`hint`]); [`located`] puts both together. [`refused`] lists
//! wrong lines. Tests check that the tables agree with the parsers of `cpu`.
//!
//! Two features add what several tools share: `digest` computes SHA-256, and `annotate` writes words on pictures.

#[cfg(feature = "annotate")]
pub mod annotate;
#[cfg(feature = "digest")]
pub mod digest;
pub mod faults;
pub mod hint;
pub mod located;
pub mod place;
pub mod recorder;
pub mod refused;
mod rewrite;
pub mod unseen;

use cpu::internals::input::text;

use hint::Language;

/// A text in English and in Spanish. Each `{}` in it stands for a value.
pub type Words = [&'static str; 2];

/// The set of values that a field may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Field {
    /// A material's name: any text without blanks.
    Name,
    /// A whole number above 0 that fits in 64 bits.
    Count,
    /// Any finite number.
    Real,
    /// A finite number above 0.
    Positive,
    /// A finite number that is not negative.
    NotNegative,
    /// A finite number from 0 to 1.
    Share,
    /// An angle in degrees, above 0 and below 180.
    Degrees,
}

impl Field {
    /// Whether `token` is a valid value of this field.
    #[must_use]
    pub fn accepts(self, token: &[u8]) -> bool {
        let real = |is_right: fn(f64) -> bool| text::parse_real(token).is_some_and(is_right);
        match self {
            Self::Name => true,
            Self::Count => text::parse_positive_integer(token).is_some(),
            Self::Real => real(|_| true),
            Self::Positive => real(|value| value > 0.0),
            Self::NotNegative => real(|value| value >= 0.0),
            Self::Share => real(|value| (0.0..=1.0).contains(&value)),
            Self::Degrees => real(|value| value > 0.0 && value < 180.0),
        }
    }

    /// Returns the description of the valid values, for an error message.
    #[must_use]
    pub const fn wanted(self) -> Words {
        match self {
            Self::Name => ["a name", "un nombre"],
            Self::Count => ["a whole number above 0", "un número entero mayor que 0"],
            Self::Real => ["a number", "un número"],
            Self::Positive => ["a number above 0", "un número mayor que 0"],
            Self::NotNegative => ["a number of at least 0", "un número de al menos 0"],
            Self::Share => ["a number from 0 to 1", "un número de 0 a 1"],
            Self::Degrees => ["an angle above 0 and below 180 degrees", "un ángulo mayor que 0 y menor que 180 grados"],
        }
    }
}

/// The format of one kind of line of an input file.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// First word of the line, with its colon.
    pub tag: &'static str,
    /// The sets of valid values of the words after the tag, in order.
    pub fields: &'static [Field],
    /// The values as the table describes them.
    pub values: &'static str,
    /// The default value in the form of an input file; empty for lines of a scene.
    pub default: &'static str,
    /// The meaning of the line, with the unit of its values.
    pub meaning: &'static str,
}

/// Phrases of [`Line::values`] in English and in Spanish. A phrase that contains another one comes before it.
const PHRASES: [Words; 8] = [
    ["two whole numbers", "dos números enteros"],
    ["whole number", "número entero"],
    ["number", "número"],
    [" in ", " en "],
    ["name", "nombre"],
    ["diffusion", "difusión"],
    ["index", "índice"],
    ["radius", "radio"],
];

impl Line {
    /// Returns the values as the table describes them, in a language.
    #[must_use]
    pub fn values_in(&self, language: Language) -> String {
        let say = |text: String, [english, spanish]: &Words| text.replace(english, spanish);
        match language {
            Language::English => self.values.to_owned(),
            Language::Spanish => PHRASES.iter().fold(self.values.to_owned(), say),
        }
    }
}

use Field::{Count, Degrees, Name, NotNegative, Positive, Real, Share};

/// Returns a line of the format.
const fn key(
    tag: &'static str,
    fields: &'static [Field],
    values: &'static str,
    default: &'static str,
    meaning: &'static str,
) -> Line {
    Line { tag, fields, values, default, meaning }
}

/// The formats of all lines that a configuration file may have.
pub const CONFIG: [Line; 13] = [
    key("aspect_ratio:", &[Count, Count], "two whole numbers > 0", "16 9", "width to height of the picture"),
    key("image_width:", &[Count], "whole number > 0", "1920", "width in pixels; the height follows"),
    key("gamma:", &[Positive], "number > 0", "2.2", "gamma correction: a channel is its mean ^ (1 / gamma)"),
    key("camera_position:", &[Real; 3], "x y z", "0 0 -10", "where the camera stands, scene units"),
    key("camera_target:", &[Real; 3], "x y z", "0 0 0", "point in the middle of the picture, scene units"),
    key("camera_north:", &[Real; 3], "x y z", "0 1 0", "direction that is up in the picture; any length but 0"),
    key("field_of_view:", &[Degrees], "number in (0, 180)", "90", "vertical opening of the view, degrees"),
    key("samples_per_pixel:", &[Count], "whole number > 0", "20", "rays a pixel; noise falls with their square root"),
    key("max_depth:", &[Count], "whole number > 0", "5", "rays a sample may send; if the last one hits, black"),
    key("material_rng_seed:", &[Count], "whole number > 0", "13", "seed of the scatter vectors"),
    key("ray_rng_seed:", &[Count], "whole number > 0", "19", "seed of the places of rays within pixels"),
    key("background_dark_color:", &[Share; 3], "r g b in [0, 1]", "0.25 0.5 1", "background straight up (+y)"),
    key("background_light_color:", &[Share; 3], "r g b in [0, 1]", "1 1 1", "background straight down (-y)"),
];

/// The formats of all lines that a scene file may have.
pub const SCENE: [Line; 5] = [
    key("matte:", &[Name, Share, Share, Share], "name r g b", "", "material that scatters; reflectance in [0, 1]"),
    key(
        "metal:",
        &[Name, Share, Share, Share, NotNegative],
        "name r g b diffusion",
        "",
        "material that mirrors; diffusion 0 is a perfect mirror",
    ),
    key("refractive:", &[Name, Positive], "name index", "", "glass; index > 0, of window glass about 1.5"),
    key(
        "sphere:",
        &[Real, Real, Real, Positive, Name],
        "x y z radius material",
        "",
        "centre, radius > 0, a material defined above",
    ),
    key(
        "cylinder:",
        &[Real, Real, Real, Positive, Real, Real, Real, Name],
        "x y z radius ax ay az material",
        "",
        "centre, radius > 0, axis: as long as the cylinder is high",
    ),
];

/// Returns the keys of a configuration as a Markdown table, whose columns are padded so that it can be read as plain
/// text.
#[must_use]
pub fn config_table() -> String {
    let rows = CONFIG.iter().map(|line| [line.tag, line.values, line.default, line.meaning]);
    table(["key", "values", "default", "meaning"], rows)
}

/// Returns the lines of a scene as a Markdown table like that of [`config_table`].
#[must_use]
pub fn scene_table() -> String {
    table(["line", "values", "meaning"], SCENE.iter().map(|line| [line.tag, line.values, line.meaning]))
}

/// Returns a table in Markdown, with columns of even width.
fn table<const N: usize>(head: [&str; N], rows: impl Iterator<Item = [&'static str; N]>) -> String {
    let rows: Vec<_> = rows.map(|cells| cells.map(|cell| cell.to_owned())).collect();
    // The first column has words of the input files, which Markdown shows as code.
    let coded = |(place, cell): (usize, &String)| match place {
        0 => format!("`{cell}`"),
        _ => cell.clone(),
    };
    let rows: Vec<Vec<String>> = rows.iter().map(|cells| cells.iter().enumerate().map(coded).collect()).collect();
    let widths: Vec<usize> = head
        .iter()
        .enumerate()
        .map(|(place, name)| rows.iter().map(|cells| cells[place].len()).max().unwrap_or(0).max(name.len()))
        .collect();
    let line = |cells: &[&str]| {
        let padded: Vec<_> = cells.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
        format!("| {} |\n", padded.join(" | "))
    };
    let rule: Vec<_> = widths.iter().map(|width| "-".repeat(*width)).collect();
    let mut text = line(&head) + &line(&rule.iter().map(String::as_str).collect::<Vec<_>>());
    for cells in &rows {
        text += &line(&cells.iter().map(String::as_str).collect::<Vec<_>>());
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use cpu::{Config, Scene};

    #[test]
    fn every_key_is_one_of_the_renderers_and_its_default_is_the_renderers() {
        // Every value differs from its default, so a key that is missing in the table would stay different.
        let mut changed = Config {
            aspect_ratio: [1, 1],
            image_width: 1,
            gamma: 1.0,
            camera_position: cpu::internals::math::vec3::Vec3::ONE,
            camera_target: cpu::internals::math::vec3::Vec3::ONE,
            camera_north: cpu::internals::math::vec3::Vec3::ONE,
            field_of_view: 1.0,
            samples_per_pixel: 1,
            max_depth: 1,
            material_rng_seed: 1,
            ray_rng_seed: 1,
            background_dark_color: cpu::internals::math::vec3::Vec3::ZERO,
            background_light_color: cpu::internals::math::vec3::Vec3::ZERO,
        };
        for line in CONFIG {
            changed.set(format!("{} {}", line.tag, line.default).as_bytes()).expect("the table is right");
        }
        assert_eq!(changed, Config::default());
    }

    /// Returns a line with `token` in field number `place`, and a valid value in all other fields.
    fn with(line: &Line, place: usize, token: &str) -> String {
        let value = |field: &Field| if *field == Name { "m" } else { "1" };
        let mut tokens: Vec<_> = line.fields.iter().map(value).collect();
        tokens[place] = token;
        format!("{} {}\n", line.tag, tokens.join(" "))
    }

    #[test]
    fn a_field_is_accepted_here_where_the_renderer_accepts_it() {
        let tokens = ["1", "0", "-1", "0.5", "1.5", "180", "179", "nan", "x", "1e400", "18446744073709551616"];
        let mut compared = 0;
        for line in CONFIG {
            for (place, field) in line.fields.iter().enumerate() {
                for token in tokens {
                    let accepts = Config::default().set(with(&line, place, token).trim_end().as_bytes()).is_ok();
                    assert_eq!(field.accepts(token.as_bytes()), accepts, "{} {place} {token}", line.tag);
                    compared += 1;
                }
            }
        }
        for line in SCENE {
            let is_material = line.fields[0] == Name;
            let before = if is_material { "" } else { "matte: m 1 1 1\n" };
            for (place, field) in line.fields.iter().enumerate().filter(|(_, field)| **field != Name) {
                for token in tokens {
                    let text = format!("{before}{}", with(&line, place, token));
                    let accepts = Scene::parse(text.as_bytes()).is_ok();
                    assert_eq!(field.accepts(token.as_bytes()), accepts, "{text}");
                    compared += 1;
                }
            }
        }
        assert_eq!(compared, (24 + 19) * tokens.len(), "every number of both files");
    }

    #[test]
    fn the_documentation_has_these_tables() {
        let path = test_support::project_root().join("docs/files.md");
        let text = std::fs::read_to_string(path).expect("it is committed");
        for table in [config_table(), scene_table()] {
            assert!(text.contains(&table), "docs/files.md must contain what `render-lab help` prints:\n{table}");
        }
    }
}
