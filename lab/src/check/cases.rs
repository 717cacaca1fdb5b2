//! The cases that a program is held to: its arguments, wrong input files, and pictures.

use std::cell::OnceCell;
use std::fs;
use std::path::Path;

use cpu::{Aos, Config, Layout, Scatter, Scene};
use format::refused;
use generator::{Arrangement, Options};
use serde::Serialize;

use crate::picture::Picture;
use crate::{Failure, engine, sources};

/// The kind of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Group {
    /// A wrong number of arguments.
    Arguments,
    /// A wrong or missing input file.
    Messages,
    /// A small picture.
    Pictures,
    /// One of the course's four pictures, or a scene whose time is measured. They are large.
    Course,
}

/// What a program has to do with a case.
#[derive(Clone, Debug)]
pub enum Expected {
    /// Refuse it with exactly this message on standard error, or with any that begins with `Error: ` if it is `None`.
    Refusal(Option<Vec<u8>>),
    /// Write its picture. The digests are those of both [`CONVENTIONS`], where known.
    Picture([Option<String>; 2]),
}

/// A case.
#[derive(Clone, Debug)]
pub struct Case {
    /// Its name, which is also the name of the folder for its files.
    pub name: String,
    /// Its kind.
    pub group: Group,
    /// The section of the specification that a wrong message breaks.
    pub section: &'static str,
    /// The contents of the configuration and the scene, or `None` for a file that does not exist.
    pub files: [Option<Vec<u8>>; 2],
    /// Number of arguments. Those after the third are other names.
    pub arguments: usize,
    /// What the program has to do.
    pub expected: Expected,
    /// The expected pictures, once they have been rendered.
    drawn: OnceCell<[Drawn; 2]>,
}

impl Case {
    /// Returns the expected pictures of both [`CONVENTIONS`], which are rendered by the first call.
    ///
    /// # Errors
    /// An error of the renderer, or a picture that does not have its digest.
    pub fn expected_pictures(&self) -> Result<&[Drawn; 2], Failure> {
        if let Some(drawn) = self.drawn.get() {
            return Ok(drawn);
        }
        let files = self.files.each_ref().map(|file| file.as_deref().unwrap_or_default());
        let [statement, published] = CONVENTIONS.map(|scatter| Drawn::new(files, scatter, self.group == Group::Course));
        let drawn = [statement?, published?];
        if let Expected::Picture(known) = &self.expected
            && known.iter().zip(&drawn).any(|(known, drawn)| known.as_ref().is_some_and(|it| *it != drawn.digest))
        {
            return Err(format!("{}: its file or its digest is damaged, or the renderer is wrong", self.name).into());
        }
        Ok(self.drawn.get_or_init(|| drawn))
    }
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

impl Drawn {
    /// Renders a configuration and a scene by the reference, which follows the specification line by line. A large
    /// picture would take too long there, so the renderer makes it.
    ///
    /// # Errors
    /// An error of the renderer or of its input.
    pub fn new([config, scene]: [&[u8]; 2], scatter: Scatter, is_large: bool) -> Result<Self, Failure> {
        let (config, scene) = (Config::parse(config)?, Scene::parse(scene)?);
        let image = if is_large {
            cpu::render::<Aos>(&config, &scene, scatter)?
        } else {
            cpu::reference::render::<<Aos as Layout>::Image>(&config, &scene, scatter)?
        };
        Ok(Self { picture: Picture::of(&image)?, digest: digest::sha256(&engine::bytes(&image)) })
    }
}

/// Returns all cases. The last ones are those of the course, if `RENDER_REFERENCE_DIR` names their folder.
///
/// # Errors
/// A file of the folder cannot be read.
pub fn all() -> Result<Vec<Case>, Failure> {
    let mut cases: Vec<_> = arguments().chain(messages()).chain(small()?).chain(generated()).collect();
    if let Some(folder) = std::env::var_os("RENDER_REFERENCE_DIR") {
        cases.extend((1..=4).map(|number| of_course(Path::new(&folder), number)).collect::<Result<Vec<_>, _>>()?);
    }
    Ok(cases)
}

fn case(name: String, group: Group, section: &'static str, files: [Option<Vec<u8>>; 2], expected: Expected) -> Case {
    Case { name, group, section, files, arguments: 3, expected, drawn: OnceCell::new() }
}

fn arguments() -> impl Iterator<Item = Case> {
    [0, 1, 2, 4, 5].into_iter().map(|count| {
        let message = format!("Error: Invalid number of arguments: {count}\n").into_bytes();
        let files = [Some(refused::SMALL.into()), Some(Vec::new())];
        let name = format!("arguments-{count}");
        Case { arguments: count, ..case(name, Group::Arguments, "1.1", files, Expected::Refusal(Some(message))) }
    })
}

/// Returns the cases of the wrong lines that the statement names, and of files that do not exist.
fn messages() -> impl Iterator<Item = Case> {
    let refusal = |name: &str, section, files, message| {
        case(name.to_owned(), Group::Messages, section, files, Expected::Refusal(message))
    };
    let stated = refused::all().into_iter().filter(|refused| refused.is_stated).enumerate();
    let lines = stated.map(move |(index, refused)| {
        let message = format!("Error: {}\n", refused.message).into_bytes();
        let name = format!("message-{:02}", index + 1);
        refusal(&name, refused.section(), refused.files().map(Some), Some(message))
    });
    lines.chain([
        refusal("no-configuration", "1.4", [None, Some(Vec::new())], None),
        refusal("no-scene", "1.4", [Some(refused::SMALL.into()), None], None),
    ])
}

/// Returns the case of a picture.
pub fn picture(name: String, group: Group, files: [Vec<u8>; 2], digests: [Option<String>; 2]) -> Case {
    case(name, group, "1.4", files.map(Some), Expected::Picture(digests))
}

/// Returns the digests of the picture with this number in a list of digests, in both conventions.
fn digests(sums: &str, number: &str) -> Result<[Option<String>; 2], String> {
    let sums = digest::read_sums(sums)?;
    let find = |convention: &str| {
        let name = format!("{convention}/{number}.ppm");
        sums.iter().find(|(other, _)| *other == name).map(|(_, digest)| digest.clone())
    };
    Ok(["statement", "published"].map(find))
}

/// Returns the contents of the two files of a case in `tests/cases`.
macro_rules! files {
    ($($number:literal)*) => {[$((
        $number,
        [
            include_bytes!(concat!("../../../tests/cases/", $number, "/config.txt")).as_slice(),
            include_bytes!(concat!("../../../tests/cases/", $number, "/scene.txt")),
        ],
    )),*]};
}

/// Returns the 16 cases of `tests/cases`. The program contains their files, so it needs no checkout.
fn small() -> Result<Vec<Case>, Failure> {
    let sums = include_str!("../../../tests/cases/SHA256SUMS");
    let files = files!("01" "02" "03" "04" "05" "06" "07" "08" "09" "10" "11" "12" "13" "14" "15" "16");
    let case = |(number, files): (&str, [&[u8]; 2])| {
        let digests = digests(sums, number)?;
        Ok(picture(format!("picture-{number}"), Group::Pictures, files.map(<[u8]>::to_vec), digests))
    };
    files.into_iter().map(case).collect()
}

/// Returns cases with generated scenes. They have more samples than the small cases, so less noise.
fn generated() -> impl Iterator<Item = Case> {
    let options = [
        Options { seed: 1, objects: 20, ..Options::default() },
        Options { seed: 2, objects: 20, cylinders: 1.0, ..Options::default() },
        Options { seed: 3, objects: 40, cylinders: 0.0, ..Options::default() },
        Options { seed: 4, objects: 30, arrangement: Arrangement::Grid, ..Options::default() },
    ];
    let case = |options: Options| {
        let config = Config { image_width: 96, samples_per_pixel: 16, max_depth: 5, ..generator::view(&options) };
        let files = [generator::write::config(&config), generator::write::scene(&generator::scene(&options))];
        picture(format!("generated-{}", options.seed), Group::Pictures, files.map(Into::into), [None, None])
    };
    options.into_iter().map(case)
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
    let sums = String::from_utf8_lossy(&read("SHA256SUMS".to_owned())?).into_owned();
    Ok(picture(format!("course-{number}"), Group::Course, files, digests(&sums, &number.to_string())?))
}
