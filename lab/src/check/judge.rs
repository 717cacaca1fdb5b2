//! Runs a program on one case, and finds what is wrong.

use std::ffi::OsString;
use std::fs;
use std::path::Path;

use cpu::{Aos, Config, Layout, Scatter, Scene};

use super::cases::{Case, Expected, Group};
use super::fault::{Fault, Kind};
use crate::Failure;
use crate::bench::commands::Job;
use crate::difference::Difference;
use crate::picture::Picture;
use crate::supervise::{self, End, Limits, PRINTED, signal_name};

/// The ways to scatter that a program may follow: that of the statement, and that of the published pictures.
pub const CONVENTIONS: [Scatter; 2] = [Scatter::Statement, Scatter::Published];

/// What a program did with a case.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// It broke these rules, or none.
    Faults(Vec<Fault>),
    /// It wrote a picture, which is compared with the expected picture of each convention.
    Compared(Box<[Comparison; 2]>),
}

/// How near a picture is to the expected one.
#[derive(Clone, Debug, PartialEq)]
pub enum Comparison {
    /// Every byte of the file is equal.
    Equal,
    /// The pixels differ by so much, which may be nothing.
    Differs(Difference),
    /// It was not computed, because the picture is the expected one of the other convention.
    Other,
}

impl Comparison {
    /// Whether the course accepts the picture.
    #[must_use]
    pub fn is_accepted(&self) -> bool {
        match self {
            Self::Equal => true,
            Self::Differs(difference) => difference.accepted,
            Self::Other => false,
        }
    }
}

/// Names of the arguments of a case. More names follow where there are too many arguments.
pub const ARGUMENTS: [&str; 5] = ["config.txt", "scene.txt", "out.ppm", "extra", "more"];

impl Case {
    /// Returns the command that runs `program` on this case, whose files are in `folder`.
    #[must_use]
    pub fn command(&self, program: &Job, folder: &Path) -> Vec<OsString> {
        let arguments = ARGUMENTS.iter().take(self.arguments).map(|name| folder.join(name).into_os_string());
        program.words.iter().cloned().chain(arguments).collect()
    }

    /// Writes the files of the case into `folder`, and runs `program` on them.
    ///
    /// # Errors
    /// A file cannot be written, the program cannot be started, or [`Failure::Interrupted`].
    pub fn run(&self, program: &Job, folder: &Path, limits: &Limits) -> Result<Outcome, Failure> {
        fs::create_dir_all(folder)?;
        for (name, content) in ARGUMENTS.iter().zip(&self.files) {
            content.as_ref().map_or(Ok(()), |content| fs::write(folder.join(name), content))?;
        }
        match &self.expected {
            Expected::Refusal(message) => {
                // The message must be right without an old file and with one.
                for old in [None, Some("old\n")] {
                    let faults = self.refused(program, folder, limits, old, message.as_deref())?;
                    if !faults.is_empty() {
                        return Ok(Outcome::Faults(faults));
                    }
                }
                Ok(Outcome::Faults(Vec::new()))
            }
            Expected::Picture(digests) => self.drawn(program, folder, limits, digests),
        }
    }

    /// Runs a program that must refuse the case and leave OUT as it was.
    fn refused(
        &self,
        program: &Job,
        folder: &Path,
        limits: &Limits,
        old: Option<&str>,
        message: Option<&[u8]>,
    ) -> Result<Vec<Fault>, Failure> {
        let out = folder.join(ARGUMENTS[2]);
        match old {
            Some(old) => fs::write(&out, old)?,
            None => drop(fs::remove_file(&out)),
        }
        let run = supervise::run(&self.command(program, folder), &program.place, folder, limits)?;
        let mut faults: Vec<_> = self.ended(run.end, 1).into_iter().collect();
        let [printed, said] = PRINTED.map(|name| start_of(&folder.join(name)));
        let is_right = message.map_or(said.starts_with(b"Error: "), |message| said == message);
        if !is_right && matches!(run.end, End::Status(_)) {
            let expected = message.map_or("Error: ...".to_owned(), shown);
            let found = if said.is_empty() && !printed.is_empty() {
                format!("{} (stdout)", shown(&printed))
            } else {
                shown(&said)
            };
            faults.push(Kind::WrongMessage.fault(self.section, expected, found));
        }
        if fs::read(&out).ok().as_deref() != old.map(str::as_bytes) {
            faults.push(Kind::OutputChanged.fault(self.section, "", ""));
        }
        Ok(faults)
    }

    /// Returns the fault of a run that did not end with the exit status `expected`.
    fn ended(&self, end: End, expected: i32) -> Option<Fault> {
        let (kind, wanted, found) = match end {
            End::Status(status) if status == expected => return None,
            End::Status(status) => (Kind::WrongStatus, expected.to_string(), status.to_string()),
            End::Signal(signal) => (Kind::Crash, String::new(), signal_name(signal)),
            End::TimeOut => (Kind::TimeOut, String::new(), String::new()),
            End::OverMemory => (Kind::OverMemory, String::new(), String::new()),
        };
        Some(kind.fault(self.section, wanted, found))
    }

    /// Runs a program that must write the picture of the case.
    fn drawn(
        &self,
        program: &Job,
        folder: &Path,
        limits: &Limits,
        digests: &[Option<String>; 2],
    ) -> Result<Outcome, Failure> {
        let out = folder.join(ARGUMENTS[2]);
        let _ = fs::remove_file(&out);
        let run = supervise::run(&self.command(program, folder), &program.place, folder, limits)?;
        if let Some(mut fault) = self.ended(run.end, 0) {
            let said = shown(&start_of(&folder.join(PRINTED[1])));
            fault.found += &if said.is_empty() { said } else { format!(": {said}") };
            return Ok(Outcome::Faults(vec![fault]));
        }
        if !out.is_file() {
            return Ok(Outcome::Faults(vec![Kind::NoPicture.fault(self.section, "", "")]));
        }
        Ok(match self.compare(&fs::read(&out)?, digests)? {
            Ok(compared) => Outcome::Compared(Box::new(compared)),
            Err(fault) => Outcome::Faults(vec![fault]),
        })
    }

    /// Compares the picture in a file with the expected pictures. They are rendered only if the file has
    /// no digest of an expected one.
    fn compare(&self, bytes: &[u8], digests: &[Option<String>; 2]) -> Result<Result<[Comparison; 2], Fault>, Failure> {
        let digest = Some(digest::sha256(bytes));
        if digests.contains(&digest) {
            let comparison =
                |known: &Option<String>| if *known == digest { Comparison::Equal } else { Comparison::Other };
            return Ok(Ok([comparison(&digests[0]), comparison(&digests[1])]));
        }
        let picture = match Picture::parse(bytes) {
            Ok(picture) if bytes.starts_with(b"P3") => picture,
            other => {
                let reason = other.map_or_else(|reason| reason, |_| shown(&bytes[..2]));
                return Ok(Err(Kind::UnreadablePicture.fault(self.section, "P3", reason)));
            }
        };
        let mut compared = [Comparison::Other, Comparison::Other];
        for (scatter, compared) in CONVENTIONS.into_iter().zip(&mut compared) {
            let expected = self.expected_picture(scatter)?;
            let sizes = [(&expected.width, &expected.height), (&picture.width, &picture.height)];
            if sizes[0] != sizes[1] {
                let [expected, found] = sizes.map(|(width, height)| format!("{width} x {height}"));
                return Ok(Err(Kind::WrongSize.fault(self.section, expected, found)));
            }
            let mut ppm = Vec::new();
            expected.write_ppm(&mut ppm)?;
            *compared = if ppm == bytes {
                Comparison::Equal
            } else {
                Comparison::Differs(Difference::between(&expected, &picture)?)
            };
        }
        Ok(Ok(compared))
    }

    /// Returns the expected picture: by the reference, which follows the specification line by line. The pictures of the
    /// course are too large for it, so the renderer makes them; the tests compare its bytes with digests.
    ///
    /// # Errors
    /// An error of the renderer.
    pub fn expected_picture(&self, scatter: Scatter) -> Result<Picture, Failure> {
        let [config, scene] = self.files.each_ref().map(|file| file.as_deref().unwrap_or_default());
        let (config, scene) = (Config::parse(config)?, Scene::parse(scene)?);
        Ok(if self.group == Group::Course {
            Picture::of(&cpu::render::<Aos>(&config, &scene, scatter)?)?
        } else {
            Picture::of(&cpu::reference::render::<<Aos as Layout>::Image>(&config, &scene, scatter)?)?
        })
    }
}

/// Returns the first bytes of a file, or nothing if it cannot be read. A program may print without end.
fn start_of(path: &Path) -> Vec<u8> {
    const MOST: u64 = 1 << 12;
    let mut bytes = Vec::new();
    if let Ok(file) = fs::File::open(path) {
        use std::io::Read;
        let _ = file.take(MOST).read_to_end(&mut bytes);
    }
    bytes
}

fn shown(bytes: &[u8]) -> String {
    crate::terminal::escape_lines(String::from_utf8_lossy(bytes).trim_end_matches('\n'))
}
