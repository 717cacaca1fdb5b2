//! Runs a program on one case, and finds what is wrong.

use std::ffi::OsString;
use std::fs;
use std::path::Path;
use std::process::Command;

use super::cases::{Case, Expected};
use super::fault::{Fault, Kind};
use crate::Failure;
use crate::bench::commands::Job;
use crate::difference::Difference;
use crate::picture::Picture;
use crate::supervise::{self, End, Limits, PRINTED, Run, content, signal_name};
use crate::terminal::foreign;

/// What a program did with a case.
#[derive(Clone, Debug, Default)]
pub struct Judged {
    /// What is wrong.
    pub faults: Vec<Fault>,
    /// What the statement leaves open, or what costs no points.
    pub remarks: Vec<Fault>,
    /// The share of the case's points that the program has in spite of its faults.
    pub credit: f64,
    /// The picture, and how near it is to the expected one of each convention, if it has the expected size.
    pub compared: Option<(Picture, [Comparison; 2])>,
}

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
    run: Run,
    /// What it printed on standard output and on standard error.
    printed: [Vec<u8>; 2],
    /// The bytes of OUT, if there is something. A folder, a pipe, a link, or a file that is too large has none.
    out: Option<Vec<u8>>,
}

/// Names of the arguments of a case. More names follow where there are too many arguments.
pub const ARGUMENTS: [&str; 5] = ["config.txt", "scene.txt", "out.ppm", "extra", "more"];

/// What is in OUT before a run that must be refused.
const OLD: &[u8] = b"old\n";

impl Case {
    /// Returns the command that runs `program` on this case, whose files are in `folder`.
    pub fn command(&self, program: &Job, folder: &Path) -> Vec<OsString> {
        let arguments = ARGUMENTS.iter().take(self.arguments).map(|name| folder.join(name).into_os_string());
        program.words.iter().cloned().chain(arguments).collect()
    }

    /// Writes the files of the case into `folder`, and runs `program` on them. Returns how the run ended and what is
    /// wrong. `threads` is the largest number of threads of earlier runs.
    ///
    /// # Errors
    /// A file cannot be written, or the errors of [`supervise::run`].
    pub fn run(&self, program: &Job, folder: &Path, limits: &Limits, threads: u32) -> Result<(Run, Judged), Failure> {
        let left = self.start(program, folder, limits, &self.files)?;
        let run = left.run;
        let judged = match &self.expected {
            Expected::Refusal(messages) => self.refused(&left, messages),
            Expected::Picture(_) => self.drawn(left)?,
            Expected::Levels(levels) => {
                self.parsed(&left).map_or_else(Judged::wrong, |(_, picture)| self.leveled(&picture, *levels))
            }
            Expected::Form => {
                self.parsed(&left).map_or_else(Judged::wrong, |(bytes, picture)| self.formed(bytes, &picture))
            }
            Expected::OneThread => {
                let threads = threads.max(run.threads);
                let fault = (threads > 1).then(|| Kind::Threads.fault(self.section, "1", threads.to_string()));
                self.ended(&left, 0).or(fault).map_or_else(Judged::right, Judged::wrong)
            }
            Expected::Pair(other, equal) => {
                let other = self.start(program, &folder.join("other"), limits, &other.clone().map(Some))?;
                self.paired(&left, &other, *equal)
            }
        };
        Ok((run, judged))
    }

    /// Writes `files` into `folder`, which is made new, and runs `program` once.
    fn start(
        &self,
        program: &Job,
        folder: &Path,
        limits: &Limits,
        files: &[Option<Vec<u8>>; 2],
    ) -> Result<Left, Failure> {
        let old = matches!(self.expected, Expected::Refusal(_)).then(|| OLD.to_vec());
        let contents = || ARGUMENTS.iter().zip(files.iter().chain([&old]));
        let prepare = || {
            // An earlier run may have left anything here.
            remove(folder);
            folder.parent().map_or(Ok(()), fs::create_dir_all)?;
            fs::create_dir(folder)?;
            contents()
                .try_for_each(|(name, content)| content.as_ref().map_or(Ok(()), |it| fs::write(folder.join(name), it)))
        };
        prepare().map_err(|error| Failure::Program(format!("{}: {error}", crate::terminal::name(folder))))?;
        let run = supervise::run(&self.command(program, folder), &program.place, folder, limits, &program.hidden)?;
        let printed = PRINTED.map(|name| supervise::start_of(&folder.join(name)));
        // Shells and the loader of programs have these exit statuses for a program that is not there.
        if matches!(run.end, End::Status(126 | 127)) && !printed.iter().any(|text| text.starts_with(b"Error")) {
            return Err(Failure::Program(format!("{}: {}", run.end, foreign(&printed[1]))));
        }
        let out = folder.join(ARGUMENTS[2]);
        let out = out.symlink_metadata().is_ok().then(|| content(&out, self.most_bytes(files)).unwrap_or_default());
        Ok(Left { run, printed, out })
    }

    /// Returns the largest size of OUT that is read, in bytes. A pixel of a P3 file has up to 12 bytes, and some
    /// programs write more white space.
    fn most_bytes(&self, files: &[Option<Vec<u8>>; 2]) -> u64 {
        let config = files[0].as_deref().and_then(|text| cpu::Config::parse(text).ok());
        let pixels = config.and_then(|config| config.image_size().ok()).map_or(0, |size| size.pixels() as u64);
        (1 << 16) + 32 * pixels
    }

    /// Returns what is wrong with a program that had to refuse the case with one of `messages`.
    fn refused(&self, left: &Left, messages: &[String]) -> Judged {
        let mut judged = Judged::default();
        match left.run.end {
            End::Status(0) => judged.faults.push(Kind::WrongStatus.fault(self.section, "1 .. 255", "0")),
            End::Status(_) => {}
            _ => judged.faults.extend(self.ended(left, 0)),
        }
        let mut remark = |kind: Kind, found: String| judged.remarks.push(kind.fault(self.section, "", found));
        match left.out.as_deref() {
            Some(OLD) => {}
            None | Some([]) => remark(Kind::OutLost, String::new()),
            Some(_) => judged.faults.push(Kind::OutputChanged.fault(self.section, "", "")),
        }
        let mut has_first_line = true;
        if let Some(full) = messages.first() {
            let [stdout, stderr] = &left.printed;
            let first = |text: &str| text.lines().next().unwrap_or_default().trim_end().to_owned();
            // A message on standard error comes first. Progress may be on standard output.
            let streams = [(stderr, false), (stdout, true)];
            let said = streams.map(|(bytes, is_stdout)| (String::from_utf8_lossy(bytes).into_owned(), is_stdout));
            let exact = said.iter().find(|(text, _)| *text == format!("{full}\n"));
            let near = said.iter().find(|(text, _)| is_near(text, full));
            let also = said.iter().find(|(text, _)| messages[1..].iter().any(|also| first(text) == *also));
            has_first_line = said.iter().any(|(text, _)| first(text) == first(full));
            match exact.or(near).or(also) {
                Some((text, is_stdout)) => {
                    if *is_stdout {
                        judged.remarks.push(Kind::OnStdout.fault(self.section, "", ""));
                    }
                    if exact.is_none() && near.is_some() {
                        judged.remarks.push(Kind::OtherSpace.fault(
                            self.section,
                            visible(&format!("{full}\n")),
                            visible(text),
                        ));
                    }
                }
                None if matches!(left.run.end, End::Status(_)) => {
                    let shown = if stderr.is_empty() { stdout } else { stderr };
                    judged.faults.push(Kind::WrongMessage.fault(
                        self.section,
                        visible(&format!("{full}\n")),
                        visible(&String::from_utf8_lossy(shown)),
                    ));
                }
                None => {}
            }
        } else if left.printed.iter().all(Vec::is_empty) {
            judged.remarks.push(Kind::Silent.fault(self.section, "", ""));
        }
        let is_only_message = judged.faults.iter().all(|fault| fault.kind == Kind::WrongMessage);
        judged.credit = if judged.faults.is_empty() {
            1.0
        } else if is_only_message && has_first_line {
            0.5
        } else {
            0.0
        };
        judged
    }

    /// Returns the fault of a run that did not end with the exit status `expected`.
    fn ended(&self, left: &Left, expected: i32) -> Option<Fault> {
        let (kind, wanted, found) = match left.run.end {
            End::Status(status) if status == expected => return None,
            End::Status(status) => (Kind::WrongStatus, expected.to_string(), status.to_string()),
            End::Signal(signal) => (Kind::Crash, String::new(), signal_name(signal)),
            End::TimeOut => (Kind::TimeOut, String::new(), String::new()),
            End::OverMemory => (Kind::OverMemory, String::new(), String::new()),
            End::Unwatched => (Kind::Unwatched, String::new(), String::new()),
        };
        let said = foreign(&left.printed[1]);
        let found = [found, said].into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(": ");
        Some(kind.fault(self.section, wanted, found))
    }

    /// Returns the bytes of OUT, and its picture.
    fn parsed<'a>(&self, left: &'a Left) -> Result<(&'a [u8], Picture), Fault> {
        self.ended(left, 0).map_or(Ok(()), Err)?;
        let bytes = left.out.as_deref().filter(|bytes| !bytes.is_empty());
        let bytes = bytes.ok_or_else(|| Kind::NoPicture.fault(self.section, "", ""))?;
        // Another format might need far more memory than its file.
        let is_p3 = bytes.starts_with(b"P3");
        let picture = if is_p3 { Picture::parse(bytes) } else { Err(foreign(&bytes[..bytes.len().min(8)])) };
        Ok((bytes, picture.map_err(|reason| Kind::UnreadablePicture.fault(self.section, "P3", reason))?))
    }

    /// Compares the picture that a program wrote with those of the case.
    fn drawn(&self, left: Left) -> Result<Judged, Failure> {
        let (bytes, picture) = match self.parsed(&left) {
            Ok(parsed) => parsed,
            Err(fault) => return Ok(Judged::wrong(fault)),
        };
        let digest = format::digest::sha256(bytes);
        let size = |picture: &Picture| format!("{} x {}", picture.width, picture.height);
        let mut remarks = Vec::new();
        let mut comparisons = Vec::new();
        for convention in [0, 1] {
            let expected = self.expected(convention)?;
            let is_higher = picture.width == expected.picture.width && picture.height == expected.picture.height + 1;
            // The statement does not say how the height is rounded.
            let higher = if is_higher && self.is_height_open()? {
                Some(self.drawn_with(convention, Some(picture.height))?)
            } else {
                None
            };
            let expected = higher.as_ref().unwrap_or(expected);
            let [wanted, found] = [&expected.picture, &picture].map(size);
            if wanted != found {
                return Ok(Judged::wrong(Kind::WrongSize.fault(self.section, wanted, found)));
            }
            if higher.is_some() && convention == 0 {
                remarks.push(Kind::OtherHeight.fault(self.section, "", found));
            }
            let difference = Difference::between(&expected.picture, &picture)?;
            comparisons.push(Comparison { is_equal: expected.digest == digest, difference });
        }
        let compared = <[Comparison; 2]>::try_from(comparisons).ok().map(|both| (picture, both));
        Ok(Judged { remarks, compared, credit: 1.0, ..Judged::default() })
    }

    /// Whether the height of the picture has a fraction, so that it may be rounded up or down.
    fn is_height_open(&self) -> Result<bool, Failure> {
        let config = cpu::Config::parse(self.files[0].as_deref().unwrap_or_default())?;
        let [width, height] = config.aspect_ratio.map(u128::from);
        Ok(u128::from(config.image_width) * height % width != 0)
    }

    /// Compares every pixel with the colour `levels`.
    fn leveled(&self, picture: &Picture, levels: [u8; 3]) -> Judged {
        let Some(found) = picture.pixels.iter().find(|pixel| **pixel != levels) else { return Judged::right() };
        let [expected, shown] = [&levels, found].map(|pixel| format!("{} {} {}", pixel[0], pixel[1], pixel[2]));
        // The first value has .655 behind its point. The last one is high enough to show another scale alone.
        if found[..2] == levels[..2] && found[2] == levels[2] + 1 {
            return Judged { remarks: vec![Kind::Scaled.fault(self.section, expected, shown)], ..Judged::right() };
        }
        let is_rounded = found[0] == levels[0] + 1;
        let kind = if is_rounded { Kind::Rounded } else { Kind::WrongPicture };
        Judged::wrong(kind.fault(self.section, expected, shown))
    }

    /// Compares the file with the statement's form of it, byte by byte.
    fn formed(&self, bytes: &[u8], picture: &Picture) -> Judged {
        let mut stated = Vec::new();
        if picture.write_ppm(&mut stated).is_err() || stated == bytes {
            return Judged::right();
        }
        let at = stated.iter().zip(bytes).take_while(|(a, b)| a == b).count();
        let line = bytes[..at].iter().filter(|&&byte| byte == b'\n').count();
        let shown = |text: &[u8]| {
            let start = text[..at].iter().rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1);
            let end = text[at..].iter().position(|&byte| byte == b'\n').map_or(text.len(), |end| at + end + 1);
            visible(&String::from_utf8_lossy(&text[start..end.min(start + 60)]))
        };
        let found = format!("{} (line {}, byte {} of the file)", shown(bytes), line + 1, at + 1);
        Judged::wrong(Kind::WrongForm.fault(self.section, shown(&stated), found))
    }

    /// Compares what the program made of two pairs of files.
    fn paired(&self, one: &Left, other: &Left, equal: bool) -> Judged {
        let (one, other) = match (self.parsed(one), self.parsed(other)) {
            (Ok((one, _)), Ok((other, _))) => (one, other),
            (Err(fault), _) | (_, Err(fault)) => return Judged::wrong(fault),
        };
        match (one == other, equal) {
            (true, false) => Judged::wrong(Kind::Ignored.fault(self.section, "", "")),
            (false, true) => Judged::wrong(Kind::ReadsOtherwise.fault(self.section, "", "")),
            _ => Judged::right(),
        }
    }
}

impl Judged {
    fn right() -> Self {
        Self { credit: 1.0, ..Self::default() }
    }

    fn wrong(fault: Fault) -> Self {
        Self { faults: vec![fault], ..Self::default() }
    }
}

/// Whether `text` is the message but for blanks at the ends of lines or before a quote, the last line end, or lines
/// that follow it.
fn is_near(text: &str, message: &str) -> bool {
    let line = |line: &str| match line.trim_end().strip_suffix('"') {
        Some(start) => start.trim_end().to_owned() + "\"",
        None => line.trim_end().to_owned(),
    };
    let [text, message] = [text, message].map(|text| text.lines().map(line).collect::<Vec<_>>());
    text.starts_with(&message)
}

/// Returns a text for a comparison: blanks, tabs and line ends can be seen.
fn visible(text: &str) -> String {
    let shown = text.replace(' ', "\u{b7}").replace('\t', "\u{2192}").replace('\r', "\u{240d}");
    let shown = foreign(shown.as_bytes());
    if text.is_empty() || text.ends_with('\n') { shown } else { shown + "\u{2205}" }
}

/// Removes a file or folder, whatever it is. The standard library opens a folder on each level, and gives up on deep
/// ones.
pub fn remove(path: &Path) {
    let Ok(metadata) = path.symlink_metadata() else { return };
    let removed = if metadata.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) };
    if removed.is_err() {
        let _ = Command::new("chmod").args(["-R", "u+rwx"]).arg(path).output();
        let _ = Command::new("rm").args(["-rf", "--"]).arg(path).output();
    }
}
