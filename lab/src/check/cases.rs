//! The cases that a program is held to: its arguments, its input files, and its pictures.

use std::fs;
use std::path::Path;
use std::sync::OnceLock;

use cpu::{Aos, Config, Scatter, Scene};
use format::refused::{self, Refused};
use serde::{Deserialize, Serialize};

use crate::difference::{Difference, MAXIMUM_BOUND, RMSE_BOUND};
use crate::picture::Picture;
use crate::{Failure, engine, sources};

/// The kind of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Group {
    /// A wrong number of arguments.
    Arguments,
    /// A wrong or missing input file.
    Messages,
    /// Input files that mean the same, or not.
    Inputs,
    /// A small picture, or its file.
    Pictures,
    /// One of the course's four pictures, or a case of `grade.toml`. They are large.
    Course,
}

/// What a program has to do with a case.
#[derive(Clone, Debug)]
pub enum Expected {
    /// Refuse it with the first of these messages, or with one that begins with the first line of another one. Without
    /// a message, any will do.
    Refusal(Vec<String>),
    /// Write a picture whose largest pixel difference from the expected one, and whose RMSE, are below these bounds.
    Picture([f64; 2]),
    /// Write this colour into every pixel.
    Levels([u8; 3]),
    /// Write a file as the statement describes it, byte by byte.
    Form,
    /// Write the same bytes for these files, or other bytes.
    Pair([Vec<u8>; 2], bool),
    /// Have one thread, in this case and all before.
    OneThread,
}

/// A case.
#[derive(Clone, Debug)]
pub struct Case {
    /// Its name. The program does not see it.
    pub name: String,
    /// Its kind.
    pub group: Group,
    /// The section of the statement with the rule.
    pub section: &'static str,
    /// The line of an input file that the case is about, or nothing.
    pub line: String,
    /// The contents of the configuration and the scene, or `None` for a file that does not exist.
    pub files: [Option<Vec<u8>>; 2],
    /// Number of arguments. Those after the third are other names.
    pub arguments: usize,
    /// What the program has to do.
    pub expected: Expected,
    /// How much the case counts in the points.
    pub weight: f64,
    /// The digests of the picture in both [`CONVENTIONS`], where known.
    digests: [Option<String>; 2],
    /// The expected pictures, once they have been rendered.
    drawn: [OnceLock<Drawn>; 2],
}

/// The ways to scatter that a program may follow: that of the statement, and that of the published pictures.
pub const CONVENTIONS: [Scatter; 2] = [Scatter::Statement, Scatter::Published];

/// An expected picture.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The picture.
    pub picture: Picture,
    /// SHA-256 of its file, in hexadecimal digits.
    pub digest: String,
}

impl Case {
    /// Returns a case of `group` with three arguments.
    fn new(
        name: impl Into<String>,
        group: Group,
        section: &'static str,
        files: [Vec<u8>; 2],
        expected: Expected,
    ) -> Self {
        let (digests, drawn) = ([None, None], [const { OnceLock::new() }; 2]);
        let (name, files, line) = (name.into(), files.map(Some), String::new());
        Self { name, group, section, line, files, arguments: 3, expected, weight: 1.0, digests, drawn }
    }

    /// Returns the case of a picture. Without bounds, they are those of the course, or 1.5 times the difference that
    /// another seed makes: where noise alone exceeds the course's bounds, its measure says nothing about a program.
    ///
    /// # Errors
    /// The errors of [`Case::expected`].
    pub fn picture(name: impl Into<String>, files: [Vec<u8>; 2], bounds: [Option<f64>; 2]) -> Result<Self, Failure> {
        let mut case = Self::new(name, Group::Course, "3", files, Expected::Picture([MAXIMUM_BOUND, RMSE_BOUND]));
        let bounds = if let [Some(maximum), Some(rmse)] = bounds {
            [maximum, rmse]
        } else {
            let own = case.seeded(1)?;
            let noise = Difference::between(&case.expected(0)?.picture, &own.expected(0)?.picture)?;
            [
                bounds[0].unwrap_or(MAXIMUM_BOUND.max(1.5 * noise.maximum)),
                bounds[1].unwrap_or(RMSE_BOUND.max(1.5 * noise.rmse)),
            ]
        };
        case.expected = Expected::Picture(bounds);
        Ok(case)
    }

    /// Returns the case with other seeds and a darker background, for a picture that no earlier run has made. The
    /// number 0 changes nothing.
    ///
    /// # Errors
    /// An error of the configuration.
    pub fn seeded(&self, number: u64) -> Result<Self, Failure> {
        let text = self.files[0].as_deref().unwrap_or_default();
        let mut config = Config::parse(text)?;
        // The seeds are positive numbers of 64 bits.
        config.ray_rng_seed = (config.ray_rng_seed.wrapping_add(number)).max(1);
        config.material_rng_seed = (config.material_rng_seed.wrapping_add(number)).max(1);
        // A program that ignores the seeds makes another picture too.
        let share = 1.0 - 0.005 * (number % 50) as f64;
        config.background_dark_color = config.background_dark_color * share;
        config.background_light_color = config.background_light_color * share;
        let text = if number == 0 { text.to_vec() } else { generator::write::config(&config).into() };
        let files = [text, self.files[1].clone().unwrap_or_default()];
        Ok(Self {
            line: self.line.clone(),
            ..Self::new(&*self.name, self.group, self.section, files, self.expected.clone())
        })
    }

    /// Returns the expected picture of a convention, which is rendered by the first call.
    ///
    /// # Errors
    /// An error of the renderer, or a picture that does not have its digest.
    pub fn expected(&self, convention: usize) -> Result<&Drawn, Failure> {
        let place = &self.drawn[convention];
        if let Some(drawn) = place.get() {
            return Ok(drawn);
        }
        let drawn = self.drawn_with(convention, None)?;
        if self.digests[convention].as_ref().is_some_and(|known| *known != drawn.digest) {
            return Err(format!("{}: its file or its digest is damaged, or the renderer is wrong", self.name).into());
        }
        Ok(place.get_or_init(|| drawn))
    }

    /// Renders the picture of a convention, with another height if one is given.
    ///
    /// # Errors
    /// An error of the renderer or of its input.
    pub fn drawn_with(&self, convention: usize, height: Option<usize>) -> Result<Drawn, Failure> {
        let [config, scene] = self.files.each_ref().map(|file| file.as_deref().unwrap_or_default());
        let (mut config, scene) = (Config::parse(config)?, Scene::parse(scene)?);
        if let Some(height) = height {
            config.aspect_ratio = [config.image_width, height as u64];
        }
        let image = cpu::render::<Aos>(&config, &scene, CONVENTIONS[convention])?;
        Ok(Drawn { picture: Picture::of(&image)?, digest: format::digest::sha256(&engine::bytes(&image)) })
    }
}

/// Returns all cases. The last ones are those of the course, if `RENDER_REFERENCE_DIR` names their folder.
///
/// # Errors
/// A file of the folder cannot be read.
pub fn all() -> Result<Vec<Case>, Failure> {
    let mut cases: Vec<_> = arguments().chain(messages()).chain(inputs()).chain(pictures()).collect();
    if let Some(folder) = std::env::var_os("RENDER_REFERENCE_DIR") {
        cases.extend((1..=4).map(|number| of_course(Path::new(&folder), number)).collect::<Result<Vec<_>, _>>()?);
    }
    Ok(cases)
}

fn arguments() -> impl Iterator<Item = Case> {
    [0, 1, 2, 4, 5].into_iter().map(|count| {
        let messages = vec![format!("Error: Invalid number of arguments: {count}")];
        let files = [refused::SMALL.into(), Vec::new()];
        let name = format!("arguments-{count}");
        Case { arguments: count, ..Case::new(name, Group::Arguments, "4.1.2", files, Expected::Refusal(messages)) }
    })
}

/// Messages that the statement allows too, with the start of the line. Where data are invalid and there is something
/// behind them, it does not say which is found first, and it shows no line with the entity of its example.
const ALSO: [(&str, &str); 3] = [
    ("camera_target: 1 2 z 3", "Error: Extra data after configuration value for key: [camera_target:]"),
    ("sphere: 0 0 0 a x 3", "Error: Extra data after configuration value for key: [sphere:]"),
    ("triangle:", "Error: Unknown scene entity: triangle:"),
];

/// Returns the cases of the wrong lines that the statement names, and of files that do not exist.
fn messages() -> impl Iterator<Item = Case> {
    let is_stated = |refused: &Refused| refused.is_stated && !refused.line.starts_with('#');
    let stated = refused::all().into_iter().filter(is_stated).enumerate();
    let lines = stated.map(move |(index, refused)| {
        let also = ALSO.iter().filter(|(start, _)| refused.line.starts_with(start)).map(|(_, text)| (*text).to_owned());
        let messages = [format!("Error: {}", refused.message)].into_iter().chain(also).collect();
        let section = if refused.section() == "3.4" { "2.2.1" } else { "2.1.4" };
        let name = format!("message-{:02}", index + 1);
        Case {
            line: refused.line.clone(),
            ..Case::new(name, Group::Messages, section, refused.files(), Expected::Refusal(messages))
        }
    });
    let missing = |name: &str, section, files| Case {
        files,
        ..Case::new(name, Group::Messages, section, Default::default(), Expected::Refusal(Vec::new()))
    };
    lines.chain([
        missing("no-configuration", "2.2.1", [None, Some(Vec::new())]),
        missing("no-scene", "2.1.4", [Some(refused::SMALL.into()), None]),
    ])
}

/// The lines of a configuration with the default of every key but the width, which is small.
const DEFAULTS: &str = "image_width: 24\naspect_ratio: 16 9\ngamma: 2.2\ncamera_position: 0 0 -10\ncamera_target: 0 0 0\n\
    camera_north: 0 1 0\nfield_of_view: 90\nsamples_per_pixel: 20\nmax_depth: 5\nmaterial_rng_seed: 13\nray_rng_seed: 19\n\
    background_dark_color: 0.25 0.5 1\nbackground_light_color: 1 1 1\n";

/// A scene in which every key of the configuration shows: light comes back after more than five surfaces.
const SHOWN: &str = "matte: grey 0.9 0.8 0.7\nmetal: mirror 0.9 0.9 0.9 0\nsphere: 1 1 0 4 grey\nsphere: -6 0 0 2.5 mirror\n\
    sphere: 9 3 4 3 mirror\nsphere: 0 -210 0 200 mirror\n";

/// Returns cases of two pairs of files each. What a program makes of the two is compared with itself, so the cases do
/// not depend on anything that the statement leaves open.
fn inputs() -> impl Iterator<Item = Case> {
    let pair = |name: String, section, line: &str, one: [&str; 2], other: [&str; 2], equal| {
        let [one, other] = [one, other].map(|files| files.map(|text| text.as_bytes().to_vec()));
        Case { line: line.to_owned(), ..Case::new(name, Group::Inputs, section, one, Expected::Pair(other, equal)) }
    };
    let defaults = DEFAULTS.lines().map(move |line| {
        let key = line.split(':').next().unwrap_or_default();
        let mut full = DEFAULTS.to_owned();
        if key == "image_width" {
            full = full.replace(" 24\n", " 1920\n").replace("16 9", "480 1").replace("pixel: 20", "pixel: 1");
        }
        let without: String =
            full.lines().filter(|other| !other.starts_with(key)).map(|other| format!("{other}\n")).collect();
        pair(format!("default-{key}"), "2.2", line, [&without, SHOWN], [&full, SHOWN], true)
    });
    let seeds = ["material_rng_seed: 13", "ray_rng_seed: 19"].map(|line| {
        let other = DEFAULTS.replace(line, &format!("{line}7"));
        pair(
            format!("changed-{}", line.split(':').next().unwrap_or_default()),
            "2.2",
            line,
            [DEFAULTS, SHOWN],
            [&other, SHOWN],
            false,
        )
    });
    let spaced = DEFAULTS.replace("gamma", "\n \t\ngamma");
    let indented = DEFAULTS.replace("\ngamma: 2.2", "\n  gamma: 2.2").replace("\nmax", "\n\tmax");
    let tabs = DEFAULTS.replace(": ", ":\t ").replace("0 0 -10", "0\t0  -10");
    let trailing = DEFAULTS.replace('\n', " \t\n");
    let twice = format!("gamma: 1.8\nimage_width: 9\nmax_depth: 1\ncamera_position: 3 0 -9\n{DEFAULTS}");
    let short = DEFAULTS.replace("0.25 0.5 1", ".25 .5 1");
    let blank_scene = format!("\n \t\n{}", SHOWN.replace("\nsphere", "\n\nsphere"));
    let more = [
        ("blank-lines", "2.2.1", [&*spaced, SHOWN]),
        ("leading-blanks", "2.2.1", [&*indented, SHOWN]),
        ("blanks-between", "2.2.1", [&*tabs, SHOWN]),
        ("blanks-at-the-end", "2.2.1", [&*trailing, SHOWN]),
        ("repeated-keys", "2.2.1", [&*twice, SHOWN]),
        ("numbers-without-0", "2.2", [&*short, SHOWN]),
        ("blank-lines-of-the-scene", "2.1.4", [DEFAULTS, &*blank_scene]),
    ]
    .map(|(name, section, files)| pair(name.to_owned(), section, "", files, [DEFAULTS, SHOWN], true));
    defaults.chain(seeds).chain(more).collect::<Vec<_>>().into_iter()
}

/// A configuration without noise, because both colours of the background are one. The first channel is 20.655 before it
/// is truncated, the second 104.55, and the third 201.45.
const LEVELS: &str = "image_width: 6\naspect_ratio: 2 1\ngamma: 1\nsamples_per_pixel: 4\n\
    background_dark_color: 0.081 0.41 0.79\nbackground_light_color: 0.081 0.41 0.79\n";

/// Returns the cases of pictures. Scenes, sizes, samples and bounds are chosen so that noise stays below the bounds,
/// and each fault of a renderer above those of one scene.
fn pictures() -> impl Iterator<Item = Case> {
    let blocks = include_str!("pictures.txt").split("= ").skip(1);
    let scenes = blocks.filter_map(|block| {
        let (head, files) = block.split_once('\n')?;
        let (config, scene) = files.split_once("-\n")?;
        let mut words = head.split(' ');
        let (name, section) = (words.next()?, words.next()?);
        let bounds = [words.next()?.parse().ok()?, words.next()?.parse().ok()?];
        let files = [config, scene].map(|text| text.as_bytes().to_vec());
        Some(Case::new(format!("picture-{name}"), Group::Pictures, section, files, Expected::Picture(bounds)))
    });
    let levels = || [LEVELS.into(), Vec::new()];
    let glass = include_str!("pictures.txt").split("= ").find(|block| block.starts_with("glass"));
    let long = glass.and_then(|block| block.split_once('\n')?.1.split_once("-\n")).unwrap_or_default();
    scenes.chain([
        Case::new("file-format", Group::Pictures, "2.3.2", levels(), Expected::Form),
        Case::new("truncation", Group::Pictures, "3.2", levels(), Expected::Levels([20, 104, 201])),
        Case::new("one-thread", Group::Pictures, "4.2.1", [long.0.into(), long.1.into()], Expected::OneThread),
    ])
}

fn of_course(folder: &Path, number: u32) -> Result<Case, Failure> {
    let read = |name: String| {
        let path = folder.join(name);
        let explain = "RENDER_REFERENCE_DIR must name the folder of the course's cases, or nothing";
        sources::regular(&path)
            .and_then(fs::read)
            .map_err(|error| format!("{}: {error}; {explain}", crate::terminal::name(&path)))
    };
    let files = [read(format!("config{number}.txt"))?, read(format!("scene{number}.txt"))?];
    let text = String::from_utf8_lossy(&read("SHA256SUMS".to_owned())?).into_owned();
    let sums = format::digest::read_sums(&text)?;
    let find = |convention: &str| {
        let name = format!("{convention}/{number}.ppm");
        sums.iter().find(|(other, _)| *other == name).map(|(_, digest)| digest.clone())
    };
    let expected = Expected::Picture([MAXIMUM_BOUND, RMSE_BOUND]);
    let case = Case::new(format!("course-{number}"), Group::Course, "3", files, expected);
    Ok(Case { digests: ["statement", "published"].map(find), ..case })
}
