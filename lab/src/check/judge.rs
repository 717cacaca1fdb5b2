//! Runs a program on one case, and finds what is wrong.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::{fs, io};

use super::cases::{Case, Expected};
use super::drawn::Drawn;
use super::fault::{Fault, Kind};
use crate::Failure;
use crate::bench::commands::Job;
use crate::difference::Difference;
use crate::picture::{MAX_FILE_BYTES, Picture};
use crate::supervise::{self, End, Limits, PRINTED, signal_name, start_of};

/// What a program did with a case: a picture that is compared with the expected picture of each convention, or faults.
/// There are no faults if the program was right to write no picture.
pub type Outcome = Result<Box<[Comparison; 2]>, Vec<Fault>>;

/// How near a picture is to the expected one.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Whether every byte of the file is equal.
    pub is_equal: bool,
    /// How far the pixels differ.
    pub difference: Difference,
}

/// What lies at OUT.
#[derive(Debug, PartialEq)]
enum Found {
    Nothing,
    File(Vec<u8>),
    /// A folder, a pipe, a link, or a file that is too large or cannot be read.
    Other,
}

impl Found {
    fn at(out: &Path) -> Self {
        match out.symlink_metadata() {
            Err(_) => Self::Nothing,
            // A program may leave a pipe or a link to a device, which have no end.
            Ok(metadata) if metadata.is_file() && metadata.len() <= MAX_FILE_BYTES => {
                fs::read(out).map_or(Self::Other, Self::File)
            }
            Ok(_) => Self::Other,
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
        match &self.expected {
            Expected::Refusal(message) => {
                // The message must be right without an old file and with one.
                let faults = self.refused(program, folder, limits, None, message.as_deref())?;
                if !faults.is_empty() {
                    return Ok(Err(faults));
                }
                Ok(Err(self.refused(program, folder, limits, Some("old\n"), message.as_deref())?))
            }
            Expected::Picture(_) => Ok(self.drawn(program, folder, limits)?.map(Box::new).map_err(|fault| vec![fault])),
        }
    }

    /// Writes the files of the case into `folder`, and `old` as OUT. Returns the path of OUT. A program may have
    /// replaced or removed any of it in an earlier run.
    fn prepare(&self, folder: &Path, old: Option<&str>) -> io::Result<PathBuf> {
        fs::create_dir_all(folder)?;
        let out = folder.join(ARGUMENTS[2]);
        let _ = fs::remove_file(&out);
        let _ = fs::remove_dir_all(&out);
        for (name, content) in ARGUMENTS.iter().zip(&self.files) {
            content.as_ref().map_or(Ok(()), |content| fs::write(folder.join(name), content))?;
        }
        old.map_or(Ok(()), |old| fs::write(&out, old))?;
        Ok(out)
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
        let out = self.prepare(folder, old)?;
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
        if Found::at(&out) != old.map_or(Found::Nothing, |old| Found::File(old.into())) {
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

    /// Runs a program that must write the picture of the case, and compares the picture.
    fn drawn(&self, program: &Job, folder: &Path, limits: &Limits) -> Result<Result<[Comparison; 2], Fault>, Failure> {
        let out = self.prepare(folder, None)?;
        let run = supervise::run(&self.command(program, folder), &program.place, folder, limits)?;
        if let Some(mut fault) = self.ended(run.end, 0) {
            let said = shown(&start_of(&folder.join(PRINTED[1])));
            let separator = if fault.found.is_empty() || said.is_empty() { "" } else { ": " };
            fault.found += &format!("{separator}{said}");
            return Ok(Err(fault));
        }
        let Found::File(bytes) = Found::at(&out) else {
            return Ok(Err(Kind::NoPicture.fault(self.section, "", "")));
        };
        let picture = match Picture::parse(&bytes) {
            Ok(picture) if bytes.starts_with(b"P3") => picture,
            other => {
                let reason = other.map_or_else(|reason| reason, |_| shown(&bytes[..2]));
                return Ok(Err(Kind::UnreadablePicture.fault(self.section, "P3", reason)));
            }
        };
        let (expected, digest) = (self.expected_pictures()?, digest::sha256(&bytes));
        let size = |picture: &Picture| format!("{} x {}", picture.width, picture.height);
        if size(&expected[0].picture) != size(&picture) {
            return Ok(Err(Kind::WrongSize.fault(self.section, size(&expected[0].picture), size(&picture))));
        }
        let compare = |expected: &Drawn| {
            let difference = Difference::between(&expected.picture, &picture)?;
            Ok::<_, Failure>(Comparison { is_equal: expected.digest == digest, difference })
        };
        Ok(Ok([compare(&expected[0])?, compare(&expected[1])?]))
    }
}

fn shown(bytes: &[u8]) -> String {
    crate::terminal::escape_lines(String::from_utf8_lossy(bytes).trim_end_matches('\n'))
}
