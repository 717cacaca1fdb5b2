//! Programs of students that attack the results, the terminal, and the machine. `render-lab` itself plays the honest
//! renderer.

use std::fs;
use std::os::unix::fs::{MetadataExt, symlink};

use serde_json::Value;
use test_support::folder::Folder;

use crate::bash;
use crate::grading::{HONEST, graded, points, teams};

#[test]
fn no_program_forges_its_result_or_changes_that_of_another() {
    let answer = r#"{"Ok":{"Ok":{"end":{"status":0},"user":1e-6,"wall":1e-3,"memory":1.0,"joules":null,"threads":1}}}"#;
    let once = "m=seen-$(basename \"$(dirname \"$3\")\"); [ $# = 3 ] && [ -e $m ]";
    let forge = format!("{once} && {{ for f in /proc/$PPID/fd/* /proc/1/fd/*; do printf '{answer}' >$f; done; ");
    let then = format!("}} 2>/dev/null; : >$m; {HONEST}");
    let scripts = [
        ("a-honest", HONEST.to_owned()),
        ("b-writes", format!("{forge} exit 0; {then}")),
        ("c-kills", format!("{forge} kill -9 $PPID; kill -9 -1; exit 0; {then}")),
        ("d-stops", format!("{forge} kill -STOP $PPID; kill -STOP -1; exit 0; {then}")),
        // It keeps its pictures by the scene, and copies them.
        ("e-copies", "k=k-$(cksum <\"$2\" | tr -d ' '); [ -e $k ] && [ ! -e \"$3\" ] && exec cp $k \"$3\"\n\"$lab\" render \"$@\" && cp \"$3\" $k".to_owned()),
        ("f-leaves", "[ -s \"$3\" ] && exit 0\n".to_owned() + HONEST),
        ("g-deletes", "rm -rf ../../st/*-honest \"$(dirname \"$3\")\"/../*; exit 0".to_owned()),
        ("h-is-huge", "truncate -s 200M \"$3\"".to_owned()),
        ("i-is-deep", "rm -rf \"$3\"; mkdir \"$3\"; cd \"$3\"; i=0; while [ $i -lt 1500 ]; do mkdir d; cd -P d; i=$((i+1)); done".to_owned()),
        ("z-honest", HONEST.to_owned()),
    ];
    let folder = teams(&scripts.each_ref().map(|(team, script)| (*team, script.as_str())));
    let rows = graded(&folder, "");
    assert_eq!(rows.len(), scripts.len());
    let alone = teams(&[("z-honest", HONEST)]);
    let expected = points(&graded(&alone, "")["z-honest"]);
    assert_eq!(expected, [Some(1000.0), Some(1000.0), Some(1000.0)]);
    for (team, row) in &rows {
        let found = points(row);
        let reasons = row["problems"].as_array().expect("a list");
        if ["a-honest", "f-leaves", "z-honest"].contains(&team.as_str()) {
            assert_eq!(found, expected, "{team}: {reasons:?}");
        } else {
            assert!(found[2].is_none_or(|points| points == 0.0), "{team}: {found:?}");
            assert!(!reasons.is_empty(), "{team} has a reason");
        }
    }
    let alive = bash(&folder, "pgrep -f \"$PWD/st\"");
    assert!(!alive.status.success(), "no process is left: {alive:?}");
}

#[test]
fn a_command_that_ends_its_watcher_is_ended_with_it() {
    let folder = Folder::new();
    let sleep = format!("sleep 1{}.5", std::process::id());
    let output = bash(&folder, &format!("$lab time '{sleep} & kill -9 $PPID; {sleep}'"));
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(2) && said.contains("stopped the process that watches it"), "{output:?}");
    let alive = bash(&folder, &format!("pgrep -x -f '{sleep}'"));
    assert!(!alive.status.success(), "no process is left: {alive:?}");
}

#[test]
fn a_program_of_ours_that_is_replaced_goes_on() {
    let replace = "printf '#!/bin/sh\\nexit 7\\n' >../../own.new; mv ../../own.new ../../own; exit 1";
    let folder = teams(&[("a", replace), ("b", HONEST)]);
    let output = bash(&folder, "cp $lab own; ./own grade st --json --rounds 1");
    let all: Value = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{output:?}"));
    assert_eq!(points(&all["teams"][1]), [Some(1000.0), Some(1000.0), Some(1000.0)], "{}", all["teams"][1]["problems"]);
}

#[test]
fn nothing_foreign_controls_a_terminal_or_forges_a_row() {
    let noise =
        r#"printf '\033]0;pwned\007\033[2J\nforged  10.00\n\302\2331mx\342\200\256y' >&2; printf '\033c=1+1'; exit 3"#;
    let folder = teams(&[("plain", noise), ("=1+1", noise), ("a\nb", noise), ("a\\nb", noise), ("c\u{1b}[2J", noise)]);
    folder.write("st/grade.toml", "skip = ['m*', 'd*', 'c*', 'b*', 'l*', 'picture-*']\n[points]\nenergy = 0\n");
    let output = bash(&folder, "$lab grade st --rounds 1 --csv g.csv --html g.html --results r");
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let files = ["g.csv", "g.html", "r/index.html", "r/grades.csv", "r/001-11/page.html", "r/001-11/junit.xml"];
    let mut texts = files.map(|name| folder.read(name)).to_vec();
    let csv = String::from_utf8(folder.read("g.csv")).expect("it is text");
    assert_eq!((csv.lines().count(), String::from_utf8_lossy(&output.stdout).lines().count()), (6, 6), "{csv}");
    assert!(csv.lines().skip(1).any(|line| line.starts_with("'=1+1,")), "{csv}");
    texts.extend([output.stdout, output.stderr, folder.read("r/001-11/results.json")]);
    for text in texts {
        let text = String::from_utf8(text).expect("it is text");
        let obeyed = text.chars().find(|&letter| letter != '\n' && lab::terminal::is_obeyed(letter));
        assert_eq!(obeyed, None, "{text}");
    }
}

#[test]
fn a_kept_folder_leads_to_no_other_file() {
    let folder = teams(&[("a", "exit 1")]);
    let victim = folder.write("victim", "precious");
    fs::create_dir_all(folder.file("keep/6")).expect("the folder is writable");
    for name in ["config.txt", "scene.txt", "out.ppm", "stdout.txt", "stderr.txt", "expected.png"] {
        symlink(&victim, folder.file("keep/6").join(name)).expect("the folder is writable");
    }
    symlink(folder.path(), folder.file("keep/7")).expect("the folder is writable");
    let output = bash(&folder, "$lab check --keep keep st/a/render");
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    assert_eq!(folder.read("victim"), b"precious");
    assert!(
        !folder.names().contains(&"out.ppm".to_owned()) && folder.names_in("keep/7").contains(&"config.txt".to_owned())
    );
    // Only root can give a folder away.
    if fs::metadata(folder.path()).is_ok_and(|it| it.uid() == 0) {
        std::os::unix::fs::chown(folder.file("keep"), Some(65534), None).expect("root may");
        let said = crate::bash_complaint(&folder, "$lab check --keep keep st/a/render");
        assert!(said.contains("it belongs to another user"), "{said}");
    }
}

#[test]
fn a_signal_ends_the_command_and_all_that_it_started() {
    // Another run of the tests may be going on. One of the processes leaves its session.
    let sleep = format!("sleep 4{}.5", std::process::id());
    let both = format!("setsid {sleep} & exec {sleep}");
    let folder = teams(&[("a", &both)]);
    let time = format!("time '{both}'");
    for command in [&*time, "check --seconds 999 st/a/render", "grade --seconds 999 st --results r"] {
        for signal in ["INT", "TERM", "HUP"] {
            // A command in the background ignores SIGINT unless bash runs with job control. If the tests themselves run
            // in the background, bash cannot undo that, but `env` can.
            let line = format!(
                "set -m; export TMPDIR=$PWD/tmp; mkdir -p tmp; \
                 env --default-signal=INT,TERM,HUP $lab {command} & \
                 until pgrep -x -f '{sleep}' >/dev/null; do sleep 0.02; done; \
                 kill -{signal} $!; wait $!; echo $?; pgrep -x -f '{sleep}'; ls tmp"
            );
            let output = bash(&folder, &line);
            assert_eq!(String::from_utf8_lossy(&output.stdout), "130\n", "{command}, {signal}: {output:?}");
        }
    }
}

#[test]
fn a_build_fills_no_disk() {
    let folder = Folder::new();
    fs::create_dir_all(folder.file("st/a")).expect("the folder is writable");
    folder.write("st/grade.toml", "[[program]]\nname = 'a'\nbuild = 'truncate -s 300M large'\ncommand = ['true']\n");
    let row = &graded(&folder, "")["a"];
    assert!(row["total"].is_null() && row["problems"][0].to_string().contains("it cannot be built"), "{row}");
    assert!(!folder.file("st/a/large").metadata().is_ok_and(|it| it.len() > 1 << 28));
}

#[test]
fn a_grading_that_was_interrupted_goes_on_to_the_same_result() {
    let slow = "sleep 0.1; exit 1";
    let folder = teams(&[("a", HONEST), ("b", slow), ("c", HONEST), ("d", "exit 1")]);
    fs::create_dir(folder.file("st/e")).expect("the folder is writable");
    let line =
        "$lab grade st --results r --rounds 1 & until [ -e r/001-a/state.json ]; do sleep 0.05; done; kill $!; wait $!";
    let output = bash(&folder, line);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(130) && said.contains("--resume goes on"), "{output:?}");
    // A second check of this team would find nothing.
    fs::rename(folder.file("st/a/render"), folder.file("kept")).expect("it is ours");
    symlink(folder.file("kept"), folder.file("st/a/render")).expect("it is ours");
    let known = folder.read("r/001-a/state.json");
    let mut shown = Vec::new();
    for options in ["--results r --resume --jobs 2", "--results s --jobs 2", ""] {
        let rows = graded(&folder, options);
        let reasons = |row: &Value| row["problems"].to_string();
        shown.push(rows.iter().map(|(team, row)| (team.clone(), points(row), reasons(row))).collect::<Vec<_>>());
    }
    assert_eq!(shown[0].len(), 5);
    assert!(
        shown[0][4].1.iter().all(Option::is_none) && shown[0][4].2.contains("no program render-aos"),
        "{:?}",
        shown[0]
    );
    assert_eq!((&shown[0], &shown[1]), (&shown[1], &shown[2]));
    assert_eq!(known, folder.read("r/001-a/state.json"));
    assert!(folder.names_in("r/003-c").contains(&"page.html".to_owned()));
}
