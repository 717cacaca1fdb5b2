//! Writes the lines of a camera into the configuration file, when the user has asked for it in the page.

use std::path::Path;

use cpu::Config;
use cpu::internals::input::text::Tokens;
use loopback::Answer;
use serde::Deserialize;

use super::input::{MAX_TEXT, content, version_of, without_links};
use super::replace::replace;
use super::{View, invalid, wrong};
use crate::Failure;

/// Largest size of the body of such a request, in bytes. Three lines have some hundred.
const MAX_BODY: usize = 4096;

/// The keys of a camera, in the order in which missing lines are added.
const KEYS: [&str; 3] = ["camera_position:", "camera_target:", "camera_north:"];

/// The body of a request to save a camera.
#[derive(Deserialize)]
struct Save {
    /// The version of the files that the page has.
    version: String,
    /// A line for each of [`KEYS`], without line ends.
    lines: [String; 3],
}

impl View {
    /// Writes the camera in `body` into the configuration file, and answers with the new version of the files. Refuses
    /// if one of the two files has changed since the page read them, or if the result is no valid configuration.
    pub(super) fn save_camera(&self, body: &[u8]) -> Answer {
        self.try_to_save(body).map_or_else(|refusal| refusal, |version| Answer::ok("text/plain", version))
    }

    fn try_to_save(&self, body: &[u8]) -> Result<String, Answer> {
        if body.len() > MAX_BODY {
            let text = format!("a camera has at most {MAX_BODY} bytes");
            return Err(Answer::refused("413 Content Too Large", text));
        }
        let Save { version, lines } = serde_json::from_slice(body).map_err(|error| invalid(error.to_string()))?;
        check(&lines)?;
        // Of two requests with one version the second one must see the change by the first one.
        let _turn = self.saving.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let changed = || Answer::refused("409 Conflict", "a file has changed since the page read it");
        let old = self.config.read().map_err(|error| invalid(self.config.message(&error)))?;
        let scene = self.scene.version();
        if [version_of(&old), scene.clone()].join("-") != version {
            return Err(changed());
        }
        let new = replaced(&old, &lines);
        Config::parse(&new[..]).and_then(|config| config.check_picture()).map_err(wrong)?;
        let read = |path: &Path| {
            let file = without_links(path)?;
            let length = file.metadata()?.len();
            // One byte more than the page can edit is enough to see that the file is another one.
            content(file, length.min(MAX_TEXT + 1))
        };
        let failed =
            |error| Answer::refused("500 Internal Server Error", Failure::from(error).message().unwrap_or_default());
        if !replace(self.config.path(), (&old, &new), read, self.how).map_err(failed)? {
            return Err(changed());
        }
        // The version of the new file, not of what another program may have written since.
        Ok([version_of(&new), scene].join("-"))
    }
}

/// Checks that each line has its key and values that the key may have.
fn check(lines: &[String; 3]) -> Result<(), Answer> {
    for (line, key) in lines.iter().zip(KEYS) {
        if Tokens::new(line.as_bytes()).next() != Some(key.as_bytes()) {
            return Err(invalid(format!("the line [{}] is not one of {key}", line.escape_default())));
        }
        Config::default().set(line.as_bytes()).map_err(wrong)?;
    }
    Ok(())
}

/// Returns the configuration with other lines of the camera. Each replaces the last line with its key, which is the one
/// that counts, or is added at the end. All other bytes stay, and so do the line ends.
fn replaced(config: &[u8], lines: &[String; 3]) -> Vec<u8> {
    // The offsets of the last line with each key, without its line end, and the last line end of the file.
    let (mut places, mut usual, mut start) = ([None; 3], &b"\n"[..], 0);
    for row in config.split_inclusive(|byte| *byte == b'\n') {
        // A line ends in LF, CRLF or nothing.
        let content = row.strip_suffix(b"\n").map_or(row, |row| row.strip_suffix(b"\r").unwrap_or(row));
        let end = &row[content.len()..];
        let token = Tokens::new(content).next();
        if let Some(index) = KEYS.iter().position(|key| token == Some(key.as_bytes())) {
            places[index] = Some((start, start + content.len()));
        }
        usual = if end.is_empty() { usual } else { end };
        start += row.len();
    }
    let mut found: Vec<_> = places.iter().zip(lines).filter_map(|(place, line)| Some(((*place)?, line))).collect();
    found.sort_unstable();
    let (mut new, mut copied) = (Vec::with_capacity(config.len() + MAX_BODY), 0);
    for ((start, end), line) in found {
        new.extend(&config[copied..start]);
        new.extend(line.as_bytes());
        copied = end;
    }
    new.extend(&config[copied..]);
    for (_, line) in places.iter().zip(lines).filter(|(place, _)| place.is_none()) {
        if !new.is_empty() && !new.ends_with(b"\n") {
            new.extend(usual);
        }
        new.extend(line.as_bytes());
        new.extend(usual);
    }
    new
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines() -> [String; 3] {
        ["camera_position: 1 2 3", "camera_target: 0 0.5 0", "camera_north: 0 1 0"].map(str::to_owned)
    }

    #[test]
    fn the_last_line_with_a_key_is_replaced_and_missing_lines_are_added() {
        let [position, target, north] = lines();
        let rest = format!("{target}\n{north}\n");
        let added = format!("{position}\n{rest}");
        for (config, expected) in [
            (
                "\n \tcamera_north:\t0 0 1  \ncamera_position: 9 9 9\ngamma:  2\ncamera_target: 1 1 1",
                format!("\n{north}\n{position}\ngamma:  2\n{target}"),
            ),
            (
                &format!("camera_position: 4 4 4\ncamera_position: 5 5 5\n{rest}"),
                format!("camera_position: 4 4 4\n{position}\n{rest}"),
            ),
            ("", added.clone()),
            ("gamma: 2\n", format!("gamma: 2\n{added}")),
            ("gamma: 2", format!("gamma: 2\n{added}")),
            ("gamma: 2\r\nmax_depth: 3", format!("gamma: 2\nmax_depth: 3\n{added}").replace('\n', "\r\n")),
        ] {
            assert_eq!(String::from_utf8(replaced(config.as_bytes(), &lines())), Ok(expected), "{config}");
        }
    }

    #[test]
    fn other_bytes_stay_as_they_are() {
        let config = b"\xff\xfe no text\n# camera_position: 1\r\ncamera_positions: 1\ncamera_position: 1 2 3\r\n\x0c";
        let new = replaced(config, &lines());
        assert!(new.starts_with(config), "{}", String::from_utf8_lossy(&new));
    }

    #[test]
    fn only_a_line_with_its_key_and_three_numbers_is_a_line_of_the_camera() {
        assert!(check(&lines()).is_ok());
        let wrong = [
            "camera_target: 0 0 0",
            "camera_position: 0 0",
            "camera_position: 0 0 0 0",
            "camera_position: 0 0 nan",
            "camera_position: 0 0 0\nmax_depth: 7",
            "camera_position: 0 0 0\r",
            "",
        ];
        for line in wrong {
            let [_, target, north] = lines();
            let refusal = check(&[line.to_owned(), target, north]);
            assert!(refusal.is_err_and(|refusal| refusal.status.starts_with("422")), "{line:?}");
        }
    }
}
