//! What tests of `render-lab grade` share: folders of teams, whose programs are lines of shell, and their rows.

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::PermissionsExt;

use serde_json::Value;
use test_support::folder::Folder;

use crate::bash;

/// A `grade.toml` with a scene that is large enough to be timed, and few cases. The reference is above all times of the
/// tests, so that 0 points have another reason than the time.
pub const SMALL: &str = "skip = ['message-*', 'default-*', 'blank*', 'leading*', 'numbers*', 'arguments-*', 'no-*', 'one-*']\n\
    [points]\nenergy = 0\n[[scene]]\nname = 's'\nconfig = 'config.txt'\nscene = 'scene.txt'\nreference = 1e4\n";

/// Returns a folder with the programs of these teams.
pub fn teams(scripts: &[(&str, &str)]) -> Folder {
    let folder = Folder::new();
    fs::create_dir(folder.file("st")).expect("the folder is writable");
    folder.write("st/config.txt", "image_width: 32\naspect_ratio: 2 1\nsamples_per_pixel: 64\n");
    folder.write("st/scene.txt", "matte: m .5 .6 .7\nsphere: 0 0 0 3 m\n");
    folder.write("st/grade.toml", SMALL);
    for (team, script) in scripts {
        fs::create_dir(folder.file("st").join(team)).expect("the folder is writable");
        let program = folder.write(&format!("st/{team}/render"), format!("#!/bin/sh\n{script}\n"));
        fs::set_permissions(program, PermissionsExt::from_mode(0o755)).expect("it is ours");
    }
    folder
}

/// The honest program.
pub const HONEST: &str = "[ $# = 3 ] || exit 1\nexec \"$lab\" render \"$@\"";

/// Grades, and returns the rows by the names of the teams.
pub fn graded(folder: &Folder, options: &str) -> BTreeMap<String, Value> {
    let output = bash(folder, &format!("$lab grade st --json --rounds 2 {options}"));
    let all: Value = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{output:?}"));
    let rows = all["teams"].as_array().expect("a list").iter();
    rows.map(|row| (row["team"].as_str().expect("a name").to_owned(), row.clone())).collect()
}

/// Returns the points for messages, pictures and time, in hundredths.
pub fn points(row: &Value) -> Vec<Option<f64>> {
    (0..3).map(|part| row["points"][part].as_f64().map(|points| (points * 100.0).round())).collect()
}
