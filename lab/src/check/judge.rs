//! Runs a program on one case, and finds what is wrong.

use std::ffi::OsString;
use std::fs;
use std::path::Path;

use super::cases::{Case, Drawn, Expected};
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

/// What a run of a program left.
struct Left {
    end: End,
    /// What it printed on standard output and on standard error.
    printed: [Vec<u8>; 2],
    /// The bytes of OUT, if there is something. A folder, a pipe, a link, or a file that is too large has none.
    out: Option<Vec<u8>>,
}

/// Names of the arguments of a case. More names follow where there are too many arguments.
pub const ARGUMENTS: [&str; 5] = ["config.txt", "scene.txt", "out.ppm", "extra", "more"];

impl Case {
    /// Returns the command that runs `program` on this case, whose files are in `folder`.
    pub fn command(&self, program: &Job, folder: &Path) -> Vec<OsString> {
        let arguments = ARGUMENTS.iter().take(self.arguments).map(|name| folder.join(name).into_os_string());
        program.words.iter().cloned().chain(arguments).collect()
    }

    /// Writes the files of the case into `folder`, and runs `program` on them.
    ///
    /// # Errors
    /// A file cannot be written, the program cannot be started, or [`Failure::Interrupted`].
    pub fn run(&self, program: &Job, folder: &Path, limits: &Limits) -> Result<Outcome, Failure> {
        let start = |old| self.start(program, folder, limits, old);
        match &self.expected {
            Expected::Refusal(message) => {
                // The message must be right without an old file and with one.
                let faults = self.refused(start(None)?, None, message.as_deref());
                if !faults.is_empty() {
                    return Ok(Err(faults));
                }
                Ok(Err(self.refused(start(Some("old\n"))?, Some("old\n"), message.as_deref())))
            }
            Expected::Picture(_) => self.drawn(start(None)?),
        }
    }

    /// Writes the files of the case into `folder`, and `old` as OUT, and runs `program` once. A program may have
    /// replaced or removed any of the files in an earlier run.
    fn start(&self, program: &Job, folder: &Path, limits: &Limits, old: Option<&str>) -> Result<Left, Failure> {
        fs::create_dir_all(folder)?;
        let out = folder.join(ARGUMENTS[2]);
        let _ = fs::remove_file(&out);
        let _ = fs::remove_dir_all(&out);
        for (name, content) in ARGUMENTS.iter().zip(&self.files) {
            content.as_ref().map_or(Ok(()), |content| fs::write(folder.join(name), content))?;
        }
        old.map_or(Ok(()), |old| fs::write(&out, old))?;
        let run = supervise::run(&self.command(program, folder), &program.place, folder, limits)?;
        let printed = PRINTED.map(|name| start_of(&folder.join(name)));
        // A program may leave a pipe or a link to a device, which have no end.
        let is_file = |metadata: fs::Metadata| metadata.is_file() && metadata.len() <= MAX_FILE_BYTES;
        let is_readable = out.symlink_metadata().map(is_file).ok();
        let bytes = is_readable.map(|it| if it { fs::read(&out).unwrap_or_default() } else { Vec::new() });
        Ok(Left { end: run.end, printed, out: bytes })
    }

    /// Returns the faults of a program that had to refuse the case and to leave OUT as it was.
    fn refused(&self, left: Left, old: Option<&str>, message: Option<&[u8]>) -> Vec<Fault> {
        let mut faults: Vec<_> = self.ended(left.end, 1).into_iter().collect();
        let [printed, said] = &left.printed;
        let is_right = message.map_or(said.starts_with(b"Error: "), |message| said == message);
        if !is_right && matches!(left.end, End::Status(_)) {
            let is_elsewhere = said.is_empty() && !printed.is_empty();
            let found = if is_elsewhere { format!("{} (stdout)", shown(printed)) } else { shown(said) };
            faults.push(Kind::WrongMessage.fault(self.section, message.map_or("Error: ...".to_owned(), shown), found));
        }
        if left.out.as_deref() != old.map(str::as_bytes) {
            faults.push(Kind::OutputChanged.fault(self.section, "", ""));
        }
        faults
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

    /// Compares the picture that a program wrote with those of the case.
    fn drawn(&self, left: Left) -> Result<Outcome, Failure> {
        if let Some(mut fault) = self.ended(left.end, 0) {
            let details = [std::mem::take(&mut fault.found), shown(&left.printed[1])];
            fault.found = details.into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(": ");
            return Ok(Err(vec![fault]));
        }
        let Some(bytes) = left.out.filter(|bytes| !bytes.is_empty()) else {
            return Ok(Err(vec![Kind::NoPicture.fault(self.section, "", "")]));
        };
        let picture = match Picture::parse(&bytes) {
            Ok(picture) if bytes.starts_with(b"P3") => picture,
            other => {
                let reason = other.map_or_else(|reason| reason, |_| shown(&bytes[..2]));
                return Ok(Err(vec![Kind::UnreadablePicture.fault(self.section, "P3", reason)]));
            }
        };
        let (expected, digest) = (self.expected_pictures()?, digest::sha256(&bytes));
        let [wanted, found] = [&expected[0].picture, &picture].map(|it| format!("{} x {}", it.width, it.height));
        if wanted != found {
            return Ok(Err(vec![Kind::WrongSize.fault(self.section, wanted, found)]));
        }
        let compare = |expected: &Drawn| {
            let difference = Difference::between(&expected.picture, &picture)?;
            Ok::<_, Failure>(Comparison { is_equal: expected.digest == digest, difference })
        };
        Ok(Ok(Box::new([compare(&expected[0])?, compare(&expected[1])?])))
    }
}

fn shown(bytes: &[u8]) -> String {
    crate::terminal::escape_lines(String::from_utf8_lossy(bytes).trim_end_matches('\n'))
}
