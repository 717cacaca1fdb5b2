//! Tests of `grade.toml`: own cases, weights, tolerances, cases that are switched off, gates, penalties, and times.

use serde_json::Value;
use test_support::folder::Folder;

use crate::grading::{HONEST, SMALL, graded, points, teams};
use crate::{bash, bash_complaint};

/// The reasons of a row, in one text.
fn reasons(row: &Value) -> String {
    row["problems"].to_string()
}

/// Two teams: one renders all pictures, the other paints those of 24 pixels in one colour.
fn two_teams(toml: &str) -> Folder {
    let grey = "if grep -q 'image_width: 24$' \"$1\"; then { echo P3 24 12 255; yes '9 9 9' | head -n 288; } >\"$3\"; exit; fi";
    let folder = teams(&[("good", HONEST), ("grey", &format!("{grey}\n{HONEST}"))]);
    folder.write("st/own.txt", "image_width: 24\naspect_ratio: 2 1\nsamples_per_pixel: 64\n");
    folder.write("st/other.txt", "image_width: 26\naspect_ratio: 2 1\nsamples_per_pixel: 64\n");
    folder.write("st/grade.toml", toml);
    folder
}

/// Two cases of a teacher, of which the first has the weight 3, and none of `check`.
const CASES: &str = "skip = ['*']\n[[case]]\nname = 'own'\nconfig = 'own.txt'\nscene = 'scene.txt'\nweight = 3\n\
    [[case]]\nname = 'other'\nconfig = 'other.txt'\nscene = 'scene.txt'\n";

#[test]
fn own_cases_count_by_their_weights_within_their_tolerances() {
    let points = |toml: &str| {
        let rows = graded(&two_teams(toml), "");
        ["good", "grey"].map(|team| points(&rows[team]))
    };
    let untimed = format!("{CASES}[points]\ntime = 0\nenergy = 0\n");
    assert_eq!(points(&untimed), [vec![None, Some(1000.0), None], vec![None, Some(250.0), None]]);
    let tolerant = untimed.replace("weight = 3\n", "weight = 3\nmaximum = 800\nrmse = 500\n");
    assert_eq!(points(&tolerant)[1], [None, Some(1000.0), None], "the bounds accept everything");
}

#[test]
fn gates_take_the_points_for_time_and_penalties_those_of_the_total() {
    let timed = SMALL.split_once("[points]").expect("it has points").1;
    let toml = format!(
        "{CASES}[points]{timed}[gates]\npictures = 5\n[[penalty]]\nteam = 'good'\npoints = 1.5\nreason = 'late'\n"
    );
    let rows = graded(&two_teams(&toml), "");
    let [good, grey] = ["good", "grey"].map(|team| &rows[team]);
    assert_eq!((points(good), good["total"].as_f64()), (vec![None, Some(1000.0), Some(1000.0)], Some(8.5)));
    assert!(reasons(good).contains("-1.5: late"), "{good}");
    // Weights: 7 for pictures, of which a quarter is right, and 20 for time.
    assert_eq!(points(grey), [None, Some(250.0), Some(0.0)]);
    assert!((grey["total"].as_f64().unwrap_or_default() - 2.5 * 7.0 / 27.0).abs() < 1e-9, "{grey}");
    assert!(reasons(grey).contains("time: 0, because the points for messages or pictures are too few"), "{grey}");
    let table = bash(&two_teams(&toml), "$lab grade st --rounds 1 --language es --csv -");
    let table = String::from_utf8(table.stdout).expect("it is text");
    assert!(table.starts_with("\u{feff}equipo;puntos sobre 10;"), "{table}");
    assert!(table.contains("\ngood;8,50;") && table.contains("-1.5: late"), "{table}");
}

#[test]
fn a_scene_at_the_clocks_tick_gives_no_points_for_time() {
    // Each picture has one colour, which a few lines of shell know: they take less time than the clock counts.
    let quick = "level=$(awk '/dark/ { print int(255 * $2) }' \"$1\"); echo \"P3 2 1 255 $level $level $level $level $level $level\" >\"$3\"";
    let folder = teams(&[("a", quick)]);
    let toml =
        "skip = ['*']\n[points]\nenergy = 0\n[[scene]]\nname = 's'\nconfig = 'config.txt'\nscene = 'empty.txt'\n";
    let white = "background_dark_color: 1 1 1\nbackground_light_color: 1 1 1\n";
    folder
        .write("st/config.txt", format!("image_width: 2\naspect_ratio: 2 1\nsamples_per_pixel: 1\ngamma: 1\n{white}"));
    folder.write("st/empty.txt", "");
    folder.write("st/grade.toml", toml);
    let row = &graded(&folder, "")["a"];
    assert!(row["points"][2].is_null() && reasons(row).contains("s: the scene is too small to be timed: 0.0"), "{row}");
    folder.write("st/grade.toml", format!("{toml}reference = 0.01\n[[program]]\nname = 'a'\ncommand = ['true']\n"));
    let said = bash_complaint(&folder, "$lab grade st");
    assert!(said.contains("scene [s]: the scene is too small to be timed: a reference has at least 0.02 s"), "{said}");
}

#[test]
fn a_time_without_points_has_its_reason_in_every_output() {
    let fails = "grep -q '^image_width: 32$' \"$1\" 2>/dev/null && { echo 'Error: out of memory' >&2; exit 1; }";
    let folder = teams(&[("ana", &format!("{fails}\n{HONEST}"))]);
    folder.write("st/grade.toml", SMALL.replace("'one-*'", "'one-*', 'picture-*'"));
    let output = bash(&folder, "$lab grade st --rounds 1 --csv g.csv --html g.html --results r");
    let texts = ["g.csv", "g.html", "r/001-ana/page.html", "r/001-ana/results.json"].map(|name| folder.read(name));
    for text in texts.into_iter().chain([output.stdout]) {
        let text = String::from_utf8(text).expect("it is text");
        assert!(text.contains("s: wrong exit status: 1: Error: out of memory"), "{text}");
    }
}
