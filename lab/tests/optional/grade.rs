//! Checks and grades variants of one correct program in C++. The statement leaves some deviations open, and all others
//! are faults. All permitted variants are graded, and one of eight faults. With `RENDER_ALL=1`, as in tests/extensive
//! and in docs/refresh, all faults are.

use std::fmt::Write as _;
use std::fs;
use std::process::Command;

use libtest_mimic::{Failed, Trial};
use test_support::folder::Folder;
use test_support::{cpp, trial};

/// Deviations that the statement permits: no point may be lost. With a remark, its name follows.
const PERMITTED: [(&str, &str); 26] = [
    ("correct", ""),
    ("unit_vectors", ""),
    ("unit_vectors,zyx", ""),
    ("zyx", ""),
    ("y_before_x", ""),
    ("columns_first", ""),
    ("rows_upwards", ""),
    ("samples_outermost", ""),
    ("height_up", "other_height"),
    ("height_nearest", "other_height"),
    ("rays_unit", ""),
    ("half_b", ""),
    ("smooth_without_draws", ""),
    ("no_last_draws", ""),
    ("tie_first", ""),
    ("scale_255_999", "scaled"),
    ("exit_2", ""),
    ("exit_255", ""),
    ("on_stdout", "on_stdout"),
    ("no_line_end", "other_space"),
    ("message_more", "other_space"),
    ("trimmed_line", "other_space"),
    ("entity_colon", ""),
    ("empty_out", "out_lost"),
    ("extra_first", ""),
    ("no_prefix", ""),
];

/// Faults, with the kind of fault that must be found in a case whose name begins so. The others are in no other case
/// than these.
const FAULTS: [(&str, &str, &str); 102] = [
    ("last_object", "wrong_picture", "picture"),
    ("no_flip", "wrong_picture", "picture-inside"),
    ("first_root", "wrong_picture", "picture-glass"),
    ("far_root", "wrong_picture", "picture-matte"),
    ("normal_not_divided", "wrong_picture", "picture-matte"),
    ("endless_caps", "wrong_picture", "picture-caps"),
    ("endless_side", "wrong_picture", "picture-axes"),
    ("height_double", "wrong_picture", "picture-axes"),
    ("side_unit", "wrong_picture", "picture-cylinder"),
    ("no_caps", "wrong_picture", "picture-caps"),
    ("no_lower_cap", "wrong_picture", "picture-inside"),
    ("background_swapped", "wrong_picture", "picture-background"),
    ("background_not_unit", "wrong_picture", "picture-background"),
    ("no_reflectance", "wrong_picture", "picture-matte"),
    ("matte_alone", "wrong_picture", "picture-matte"),
    ("metal_not_unit", "wrong_picture", "picture-metal"),
    ("no_diffusion", "wrong_picture", "picture-metal"),
    ("rho_swapped", "wrong_picture", "picture-glass"),
    ("no_total_reflection", "wrong_picture", "picture-glass"),
    ("glass_free", "wrong_picture", "picture-inside"),
    ("gamma_first", "wrong_picture", "picture-matte"),
    ("no_gamma", "wrong_picture", "picture-background"),
    ("offset_0_to_1", "wrong_picture", "picture-background"),
    ("no_offset", "wrong_picture", "picture-axes"),
    ("bgr", "wrong_picture", "picture-matte"),
    ("upside_down", "wrong_picture", "picture-background"),
    ("mirrored", "wrong_picture", "picture-background"),
    ("depth_more", "wrong_picture", "picture-mirrors"),
    ("depth_less", "wrong_picture", "picture-mirrors"),
    ("fov_not_halved", "wrong_picture", "picture-background"),
    ("half_twice", "wrong_picture", "picture-background"),
    ("origin_without_half", "wrong_picture", "picture-background"),
    ("aspect_integers", "wrong_size", "picture-axes"),
    ("u_not_unit", "wrong_picture", "picture-matte"),
    ("vf_not_unit", "wrong_picture", "picture-background"),
    ("pv_positive", "wrong_picture", "picture-background"),
    ("fov_degrees", "wrong_picture", "picture-background"),
    ("north_ignored", "wrong_picture", "picture-axes"),
    ("printed_q", "wrong_picture", "picture-background"),
    ("pixels_less_one", "wrong_picture", "picture-background"),
    ("seed_per_sample", "wrong_picture", "picture-matte"),
    ("end_background", "wrong_picture", "picture-metal"),
    ("limit_0", "wrong_picture", "picture-matte"),
    ("sign_of_b", "wrong_picture", "picture-matte"),
    ("radius_not_squared", "wrong_picture", "picture-matte"),
    ("normal_inward", "wrong_picture", "picture-glass"),
    ("axis_not_unit", "wrong_picture", "picture-cylinder"),
    ("height_half", "wrong_picture", "picture-cylinder"),
    ("center_is_base", "wrong_picture", "picture-cylinder"),
    ("no_side", "wrong_picture", "picture-cylinder"),
    ("cap_not_turned", "wrong_picture", "picture-inside"),
    ("ball", "wrong_picture", "picture-matte"),
    ("metal_unit_after", "wrong_picture", "picture-metal"),
    ("clamp_diffusion", "wrong_picture", "picture-metal"),
    ("absorb", "wrong_picture", "picture-metal"),
    ("refract_not_unit", "wrong_picture", "picture-glass"),
    ("rho_never", "wrong_picture", "picture-glass"),
    ("bias_1e_3", "wrong_picture", "picture-inside"),
    ("gamma_inverted", "wrong_picture", "picture-matte"),
    ("background_x", "wrong_picture", "picture-background"),
    ("reflectance_squared", "wrong_picture", "picture-matte"),
    ("rounded", "rounded", "truncation"),
    ("scale_254", "wrong_picture", "truncation"),
    ("one_generator", "ignored", "changed-ray_rng_seed"),
    ("second_thread", "threads", "one-thread"),
    ("unseeded", "ignored", "changed-"),
    ("random_seed", "reads_otherwise", "default-"),
    ("default_gamma", "reads_otherwise", "default-gamma"),
    ("default_samples", "reads_otherwise", "default-samples_per_pixel"),
    ("default_depth", "reads_otherwise", "default-max_depth"),
    ("default_fov", "reads_otherwise", "default-field_of_view"),
    ("default_aspect", "reads_otherwise", "default-aspect_ratio"),
    ("default_width", "reads_otherwise", "default-image_width"),
    ("default_position", "reads_otherwise", "default-camera_position"),
    ("default_target", "reads_otherwise", "default-camera_target"),
    ("default_north", "reads_otherwise", "default-camera_north"),
    ("default_dark", "reads_otherwise", "default-background_dark_color"),
    ("default_light", "reads_otherwise", "default-background_light_color"),
    ("default_material_seed", "reads_otherwise", "default-material_rng_seed"),
    ("default_ray_seed", "reads_otherwise", "default-ray_rng_seed"),
    ("first_key", "reads_otherwise", "repeated-keys"),
    ("no_blank_lines", "wrong_status", "blank-lines"),
    ("no_leading_blanks", "wrong_status", "leading-blanks"),
    ("no_tabs", "wrong_status", "blanks-between"),
    ("no_blanks_at_line_ends", "wrong_status", "blanks-at-the-end"),
    ("crlf", "wrong_form", "file-format"),
    ("header_on_one_line", "wrong_form", "file-format"),
    ("comment", "wrong_form", "file-format"),
    ("two_blanks", "wrong_form", "file-format"),
    ("blanks_at_line_ends", "wrong_form", "file-format"),
    ("number_a_line", "wrong_form", "file-format"),
    ("row_a_line", "wrong_form", "file-format"),
    ("no_last_line_end", "wrong_form", "file-format"),
    ("tabs_between", "wrong_form", "file-format"),
    ("size_on_two_lines", "wrong_form", "file-format"),
    ("one_pixel_less", "unreadable_picture", "picture-matte"),
    ("message_wrong", "wrong_message", "arguments-1"),
    ("message_short", "wrong_message", "message-05"),
    ("exit_0", "wrong_status", "arguments-1"),
    ("extra_ignored", "wrong_status", "message-06"),
    ("same_names", "wrong_message", "message-31"),
    ("fov_unchecked", "wrong_status", "message-"),
];

/// One of this many faults is made, unless `RENDER_ALL` is 1: grading a program takes a second or more.
const STEP: usize = 8;

/// Returns the test, which needs g++.
pub fn trials() -> Vec<Trial> {
    let name = "grade::permitted_variants_have_all_points_and_faults_are_found";
    vec![trial(name, cpp::missing(), variants_are_told_apart)]
}

fn variants_are_told_apart() -> Result<(), Failed> {
    let folder = Folder::new();
    cpp::build("student", &folder)?;
    let mut toml = "[points]\ntime = 0\nenergy = 0\n".to_owned();
    let faults: Vec<_> = FAULTS.iter().step_by(if test_support::everything() { 1 } else { STEP }).collect();
    for name in PERMITTED.iter().map(|(name, _)| name).chain(faults.iter().map(|(name, ..)| name)) {
        fs::create_dir(folder.file(name))?;
        let mistakes = if *name == PERMITTED[0].0 { "" } else { name };
        writeln!(toml, "[[program]]\nname = '{name}'\ncommand = ['env', 'MISTAKES={mistakes}', '../student']")?;
    }
    folder.write("grade.toml", toml);
    let [csv, keep] = ["g.csv", "keep"].map(|name| folder.name(name));
    let mut command = Command::new(env!("CARGO_BIN_EXE_render-lab"));
    command.env_remove("RENDER_REFERENCE_DIR").arg("grade").arg(folder.path());
    command.args(["--json", "--jobs", "2", "--seconds", "60", "--language", "es", "--csv", &csv, "--keep", &keep]);
    let output = command.output()?;
    let grades: serde_json::Value = serde_json::from_slice(&output.stdout).map_err(|_| format!("{output:?}"))?;
    let rows = list(&grades["teams"]);
    assert_eq!(rows.len(), PERMITTED.len() + faults.len());
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
    for ((name, kind, case), row) in faults.iter().zip(&rows[PERMITTED.len()..]) {
        let told = kinds(row, "faults");
        let is_found = told.iter().any(|(found, place)| found == kind && place.starts_with(case));
        if row["team"] != *name || !is_found || told.len() > 60 {
            wrong.push(format!("{name}: {told:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    print_figures(&rows);
    let rows = String::from_utf8(folder.read("g.csv"))?;
    assert!(rows.starts_with("\u{feff}equipo;puntos sobre 10;") && rows.contains("\ncorrect;10,00;10,00;"), "{rows}");
    Ok(())
}

/// Returns the entries of a list.
fn list(value: &serde_json::Value) -> Vec<serde_json::Value> {
    value.as_array().cloned().unwrap_or_default()
}

/// Prints how far the pictures of all variants are from the expected ones, for `docs/refresh check`: the RMSE and the
/// largest difference, with a `!` beyond the bounds. A variant whose pixels are all the expected ones is left out.
fn print_figures(rows: &[serde_json::Value]) {
    for (number, row) in rows.iter().enumerate() {
        let cases = list(&row["programs"][0]["report"]["cases"]);
        let pictures: Vec<_> = cases.iter().filter(|case| case["difference"].is_object()).collect();
        if pictures.iter().all(|case| case["difference"]["differing"] == 0) {
            continue;
        }
        let figures = pictures.iter().map(|case| {
            let scene = case["case"].as_str().unwrap_or_default().trim_start_matches("picture-");
            let [rmse, maximum] = ["rmse", "maximum"].map(|name| case["difference"][name].as_f64().unwrap_or(f64::NAN));
            let mark = if case["verdict"] == "another_picture" { "!" } else { "" };
            format!("{scene} {rmse:.2}/{maximum:.1}{mark}")
        });
        let kind = if number < PERMITTED.len() { "permitted" } else { "fault" };
        println!("figures {kind} {}: {}", row["team"], figures.collect::<Vec<_>>().join(", "));
    }
}
