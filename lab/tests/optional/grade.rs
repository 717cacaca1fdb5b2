//! Checks and grades variants of one correct program in C++. The statement leaves some deviations open, and all others
//! are faults.

use std::fmt::Write as _;
use std::fs;
use std::process::Command;

use libtest_mimic::{Failed, Trial};
use test_support::folder::Folder;
use test_support::{project_root, trial};

/// Deviations that the statement permits: no point may be lost. With a remark, its name follows.
const PERMITTED: [(&str, &str); 25] = [
    ("literal", ""),
    ("published", ""),
    ("published-zyx", ""),
    ("scatter-zyx", ""),
    ("offset-yx", ""),
    ("columns-first", ""),
    ("bottom-up", ""),
    ("height-up", "other_height"),
    ("height-round", "other_height"),
    ("unit-rays", ""),
    ("half-b", ""),
    ("zero-not-drawn", ""),
    ("no-draw-at-the-end", ""),
    ("ties-first", ""),
    ("scale-255.999", "scaled"),
    ("exit-2", ""),
    ("exit-minus-1", ""),
    ("stdout", "on_stdout"),
    ("no-line-end", "other_space"),
    ("message-more", "other_space"),
    ("trimmed-line", "other_space"),
    ("entity-colon", ""),
    ("empty-out", "out_lost"),
    ("extra-first", ""),
    ("no-prefix", ""),
];

/// Faults, with the kind of fault that must be found in a case whose name begins so. The others are in no other case
/// than these.
const FAULTS: [(&str, &str, &str); 66] = [
    ("last-object", "wrong_picture", "picture"),
    ("no-flip", "wrong_picture", "picture-inside"),
    ("first-root", "wrong_picture", "picture-glass"),
    ("far-root", "wrong_picture", "picture-matte"),
    ("sphere-normal-long", "wrong_picture", "picture-matte"),
    ("endless-caps", "wrong_picture", "picture-caps"),
    ("endless-cylinder", "wrong_picture", "picture-axes"),
    ("axis-half", "wrong_picture", "picture-axes"),
    ("side-normal-unit", "wrong_picture", "picture-cylinder"),
    ("no-caps", "wrong_picture", "picture-caps"),
    ("one-cap", "wrong_picture", "picture-inside"),
    ("background-swapped", "wrong_picture", "picture-background"),
    ("background-not-unit", "wrong_picture", "picture-background"),
    ("no-attenuation", "wrong_picture", "picture-matte"),
    ("matte-no-normal", "wrong_picture", "picture-matte"),
    ("metal-not-unit", "wrong_picture", "picture-metal"),
    ("no-diffusion", "wrong_picture", "picture-metal"),
    ("rho-literal", "wrong_picture", "picture-glass"),
    ("no-total-reflection", "wrong_picture", "picture-glass"),
    ("glass-free", "wrong_picture", "picture-inside"),
    ("gamma-before-mean", "wrong_picture", "picture-matte"),
    ("no-gamma", "wrong_picture", "picture-background"),
    ("offsets-0-1", "wrong_picture", "picture-background"),
    ("no-offsets", "wrong_picture", "picture-axes"),
    ("red-and-blue", "wrong_picture", "picture-matte"),
    ("upside-down", "wrong_picture", "picture-background"),
    ("mirrored", "wrong_picture", "picture-background"),
    ("depth-more", "wrong_picture", "picture-mirrors"),
    ("depth-less", "wrong_picture", "picture-mirrors"),
    ("fov-whole", "wrong_picture", "picture-background"),
    ("rounding", "rounded", "truncation"),
    ("thread", "threads", "one-thread"),
    ("seeds-ignored", "ignored", "changed-"),
    ("random", "reads_otherwise", "default-"),
    ("defaults", "reads_otherwise", "default-"),
    ("default-gamma", "reads_otherwise", "default-gamma"),
    ("default-samples", "reads_otherwise", "default-samples_per_pixel"),
    ("default-depth", "reads_otherwise", "default-max_depth"),
    ("default-fov", "reads_otherwise", "default-field_of_view"),
    ("default-aspect", "reads_otherwise", "default-aspect_ratio"),
    ("default-width", "reads_otherwise", "default-image_width"),
    ("default-position", "reads_otherwise", "default-camera_position"),
    ("default-target", "reads_otherwise", "default-camera_target"),
    ("default-north", "reads_otherwise", "default-camera_north"),
    ("default-dark", "reads_otherwise", "default-background_dark_color"),
    ("default-light", "reads_otherwise", "default-background_light_color"),
    ("default-mseed", "reads_otherwise", "default-material_rng_seed"),
    ("default-rseed", "reads_otherwise", "default-ray_rng_seed"),
    ("first-key", "reads_otherwise", "repeated-keys"),
    ("blank-lines", "wrong_status", "blank-lines"),
    ("leading-blanks", "wrong_status", "leading-blanks"),
    ("tabs", "wrong_status", "blanks-between"),
    ("trailing-blanks", "wrong_status", "blanks-at-the-end"),
    ("crlf", "wrong_form", "file-format"),
    ("header-one-line", "wrong_form", "file-format"),
    ("comment", "wrong_form", "file-format"),
    ("two-blanks", "wrong_form", "file-format"),
    ("trailing-blanks-in-ppm", "wrong_form", "file-format"),
    ("number-per-line", "wrong_form", "file-format"),
    ("row-per-line", "wrong_form", "file-format"),
    ("no-last-end", "wrong_form", "file-format"),
    ("one-pixel-less", "unreadable_picture", "picture-matte"),
    ("message-wrong", "wrong_message", "arguments-1"),
    ("message-short", "wrong_message", "message-05"),
    ("exit-0", "wrong_status", "arguments-1"),
    ("fov-unchecked", "wrong_status", "message-"),
];

/// Returns the test, which needs g++.
pub fn trials() -> Vec<Trial> {
    let has_compiler = Command::new("g++").arg("--version").output().is_ok_and(|output| output.status.success());
    let missing = (!has_compiler).then_some("needs g++");
    vec![trial("grade::permitted_variants_have_all_points_and_faults_are_found", missing, variants_are_told_apart)]
}

fn variants_are_told_apart() -> Result<(), Failed> {
    let folder = Folder::new();
    let source = project_root().join("lab/tests/optional/variants.cpp");
    let compiled = Command::new("g++")
        .args(["-std=c++20", "-O2", "-ffp-contract=off", "-pthread"])
        .arg(source)
        .arg("-o")
        .arg(folder.file("variants"))
        .output()?;
    assert!(compiled.status.success(), "{compiled:?}");
    let mut toml = "[points]\ntime = 0\nenergy = 0\n".to_owned();
    let faults = FAULTS.iter().map(|(name, ..)| name);
    for name in PERMITTED.iter().map(|(name, _)| name).chain(faults) {
        fs::create_dir(folder.file(name))?;
        writeln!(toml, "[[program]]\nname = '{name}'\ncommand = ['../variants', '{name}']")?;
    }
    folder.write("grade.toml", toml);
    let [csv, keep] = ["g.csv", "keep"].map(|name| folder.name(name));
    let mut command = Command::new(env!("CARGO_BIN_EXE_render-lab"));
    command.env_remove("RENDER_REFERENCE_DIR").arg("grade").arg(folder.path());
    command.args(["--json", "--jobs", "2", "--seconds", "60", "--language", "es", "--csv", &csv, "--keep", &keep]);
    let output = command.output()?;
    let grades: serde_json::Value = serde_json::from_slice(&output.stdout).map_err(|_| format!("{output:?}"))?;
    let list = |value: &serde_json::Value| value.as_array().cloned().unwrap_or_default();
    let rows = list(&grades["teams"]);
    assert_eq!(rows.len(), PERMITTED.len() + FAULTS.len());
    let kinds = |row: &serde_json::Value, of: &str| -> Vec<(String, String)> {
        let cases = list(&row["programs"][0]["report"]["cases"]);
        let text = |value: &serde_json::Value| value.as_str().unwrap_or_default().to_owned();
        let all = cases
            .iter()
            .flat_map(|case| list(&case[of]).into_iter().map(|fault| (text(&fault["kind"]), text(&case["case"]))));
        all.collect()
    };
    let mut wrong = Vec::new();
    for ((name, remark), row) in PERMITTED.iter().zip(&rows) {
        let is_full = [0, 1].iter().all(|part| row["points"][part] == 10.0) && row["total"] == 10.0;
        let remarks = kinds(row, "remarks");
        let is_remarked = remarks.iter().all(|(kind, _)| kind == remark) && remarks.is_empty() == remark.is_empty();
        if row["team"] != *name || !is_full || !is_remarked {
            wrong.push(format!("{name}: {:?} {remarks:?}", kinds(row, "faults")));
        }
    }
    for ((name, kind, case), row) in FAULTS.iter().zip(&rows[PERMITTED.len()..]) {
        let faults = kinds(row, "faults");
        let is_found = faults.iter().any(|(found, place)| found == kind && place.starts_with(case));
        if row["team"] != *name || !is_found || faults.len() > 60 {
            wrong.push(format!("{name}: {faults:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    // The figures of docs/testing.md.
    let distance = |row: &serde_json::Value| {
        let cases = list(&row["programs"][0]["report"]["cases"]);
        let of = |case: &serde_json::Value| {
            let bound = if case["case"] == "picture-background" { [4.0, 1.0] } else { [40.0, 2.5] };
            let [maximum, rmse] = ["maximum", "rmse"].map(|name| case["difference"][name].as_f64());
            Some((maximum? / bound[0]).max(rmse? / bound[1]))
        };
        cases.iter().filter_map(of).fold(0.0, f64::max)
    };
    let nearest = rows[..PERMITTED.len()].iter().map(distance).fold(0.0, f64::max);
    let is_picture = |(_, kind, _): &&(&str, &str, &str)| *kind == "wrong_picture";
    let count = FAULTS.iter().filter(is_picture).count();
    let farthest = rows[PERMITTED.len()..][..count].iter().map(distance).fold(f64::INFINITY, f64::min);
    println!(
        "permitted: at most {nearest:.2} of a bound; {count} faults of pictures: at least {farthest:.2} of a bound"
    );
    let rows = String::from_utf8(folder.read("g.csv"))?;
    assert!(rows.starts_with("\u{feff}equipo;puntos sobre 10;") && rows.contains("\nliteral;10,00;10,00;"), "{rows}");
    Ok(())
}
