//! Twenty teams whose programs fail in all ways: each has a row with its reason, however the grading is run: with two
//! jobs, and with `RENDER_ALL=1`, as in tests/extensive, with one job, and with interruptions.
//!
//! Tests begin in the order of their names. By the name of this module, the test that waits longest is among the first.

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};

use serde_json::Value;
use test_support::folder::Folder;
use test_support::{everything, number_of};

use crate::bash;
use crate::grading::{HONEST, SMALL, points, teams};

/// The cases but for those that take long, and the scene whose time is measured.
fn rubric() -> String {
    SMALL.replace("'one-*'", "'one-*', 'picture-*'")
}

/// The files of the teams: the path, the mode, the text, and a part of a reason of the row. A team without a reason has
/// all points, and `-` stands for a team that is not graded. Text after `#!` is the first line.
const FILES: [(&str, u32, &str, &str); 18] = [
    ("01-honest/render", 0o755, HONEST, ""),
    ("02-fails/render", 0o755, "exit 1", "pictures: wrong exit status (2), 1"),
    ("03-hangs/render", 0o755, "exec sleep 1000", "over the limit of time (3)"),
    // A Makefile is no program.
    ("04-notes/Makefile", 0o644, "all: render", "-no program render-aos, render-soa, render in the 1 files"),
    ("05-nested/out/build/default/aos/Release/render-aos", 0o755, HONEST, "no program render-soa in the "),
    (
        "06-replaces/render",
        0o755,
        "cp /bin/true ../../own.new; mv ../../own.new ../../own; exit 1",
        "wrong exit status (2), 1",
    ),
    ("07-floods/render", 0o755, "head -c 300000000 /dev/zero; exit 1", "wrong exit status (2), 1"),
    ("08-not-executable/render", 0o644, HONEST, "-it is not executable: chmod +x ./render"),
    ("09-crlf/render", 0o755, "#!/bin/sh\r\nexit 1", "-its first line ends in CR LF"),
    ("10-no-library/render", 0o755, "echo ./render: cannot open libx.so.1 >&2; exit 127", "-cannot open libx.so.1"),
    ("11-no-interpreter/render", 0o755, "#!/no/such/python\n", "-its interpreter [/no/such/python] is not found"),
    ("12-empty/render", 0o755, "#!", "-it is neither a program of this machine nor a script"),
    ("13-crashes/render", 0o755, "kill -SEGV $$", "crash (2), SIGSEGV"),
    ("14-leaves-processes/render", 0o755, "sleep 1000 & setsid sleep 1000 & true\n", "no picture (2)"),
    ("15-folder/render", 0o755, "rm -rf \"$3\"; mkdir -p \"$3/a\"", "no picture (2)"),
    // It fails in the pictures that are measured, and in no other one.
    (
        "16-slow/render",
        0o755,
        "grep -q 'image_width: 32$' \"$1\" && { echo no memory >&2; exit 5; }",
        "s: wrong exit status: 5: no memory",
    ),
    ("same\nname/render", 0o755, "exit 1", "wrong exit status (2), 1"),
    ("same\\nname/render", 0o755, HONEST, ""),
];

/// Returns a folder with all teams.
fn all_teams() -> Folder {
    let folder = teams(&[]);
    folder.write("st/grade.toml", rubric());
    for (path, mode, text, _) in FILES {
        let program = folder.file("st").join(path);
        fs::create_dir_all(program.parent().expect("it has one")).expect("the folder is writable");
        let rest = if path.starts_with("16") { HONEST } else { "" };
        let text = match text.strip_prefix("#!") {
            Some("") => String::new(),
            Some(_) => text.to_owned(),
            None => format!("#!/bin/sh\n{text}\n{rest}\n"),
        };
        fs::write(&program, text).expect("the folder is writable");
        fs::set_permissions(&program, PermissionsExt::from_mode(mode)).expect("it is ours");
    }
    fs::create_dir(folder.file("st/17-nothing")).expect("the folder is writable");
    symlink("01-honest", folder.file("st/18-link")).expect("the folder is writable");
    // This is no team.
    fs::create_dir(folder.file("st/.git")).expect("the folder is writable");
    folder
}

/// The command that grades them. A copy of the program grades, because a team replaces it.
const GRADE: &str = "cp $lab own; ./own grade st --json --rounds 1 --seconds 3";

/// Returns the rows, without what depends on the time.
fn rows(printed: &[u8]) -> Vec<(String, Vec<Option<f64>>, String)> {
    let all: Value = serde_json::from_slice(printed).unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(printed)));
    let row = |row: &Value| {
        let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
        let reasons: Vec<_> = row["problems"].as_array().expect("a list").iter().map(text).collect();
        let mut points = points(row);
        points.push(row["total"].as_f64());
        (text(&row["team"]), points, reasons.join("; "))
    };
    all["teams"].as_array().expect("a list").iter().map(row).collect()
}

#[test]
fn twenty_teams_have_twenty_rows_with_reasons_however_they_are_graded() {
    let folder = all_teams();
    let once = rows(&bash(&folder, &format!("{GRADE} --jobs 2")).stdout);
    let names: Vec<_> = once.iter().map(|(team, ..)| team.clone()).collect();
    assert_eq!(once.len(), 20, "{names:?}");
    let mut wrong = Vec::new();
    for (path, _, _, reason) in FILES {
        let shown = path.split('/').next().unwrap_or_default().replace('\n', "\\n");
        let number = if path == FILES[17].0 { " (2)" } else { "" };
        let found = once.iter().find(|(team, ..)| *team == format!("{shown}{number}"));
        let is_right = found.is_some_and(|(_, points, found)| {
            let is_full = points[..] == [Some(1000.0), Some(1000.0), Some(1000.0), Some(10.0)] && found.is_empty();
            let has_reason = found.contains(reason.trim_start_matches('-'));
            has_reason && points[3].is_none() == reason.starts_with('-') && is_full == reason.is_empty()
        });
        if !is_right {
            wrong.push(format!("{shown}: {found:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let with_reason = |(_, points, found): &(_, Vec<Option<f64>>, String)| !found.is_empty() || points[3] == Some(10.0);
    assert!(once.iter().all(with_reason), "{once:?}");

    if !everything() {
        return;
    }
    let alone = bash(&folder, &format!("{GRADE} --results alone"));
    assert_eq!(once, rows(&alone.stdout));

    // The grading is ended at random moments until it comes to its end. Each time it goes on where it was.
    let mut random = number_of("RENDER_SEED").unwrap_or(1).wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut interrupted = 0;
    let last = loop {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let (seconds, signal) =
            (0.2 + (random >> 40) as f64 / (1 << 22) as f64, ["TERM", "KILL", "INT"][interrupted % 3]);
        let timeout = format!("timeout -s {signal} {:.2}", if interrupted < 6 { seconds } else { 600.0 });
        let line = GRADE.replace("./own", &format!("{timeout} ./own"));
        let output = bash(&folder, &format!("{line} --results r --resume"));
        if output.status.success() {
            break output;
        }
        interrupted += 1;
    };
    assert!(interrupted >= 3, "{interrupted} interruptions");
    assert_eq!(once, rows(&last.stdout));
    assert_eq!(folder.names_in("r").len(), 22, "a folder a team, and two tables");
    let alive = bash(&folder, "pgrep -f \"$PWD/st\"");
    assert!(!alive.status.success(), "no process is left: {alive:?}");
}
