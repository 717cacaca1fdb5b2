//! Diagnoses a program in C++ with mistakes, `tests/literal/student.cpp`, which shares nothing with the literal
//! renderer. One of eight mistakes is made, and all of them with `RENDER_ALL=1`, as in tests/extensive.

use std::path::Path;
use std::process::Command;

use libtest_mimic::Failed;
use literal::cases::{Case, cases};
use literal::develop::Picture;
use literal::diagnose::Search;
use test_support::folder::Folder;
use test_support::{cpp, p3, trial};

/// Mistakes of the student's program, and a part of the words of each deviation that must be named.
const NAMED: &[(&str, &[&str])] = &[
    ("", &[]),
    ("half_twice", &["the half pixel is added twice"]),
    ("offset_0_to_1", &["the half pixel is added twice (offsets from 0 to 1"]),
    ("y_before_x", &["y is drawn before its x"]),
    ("no_offset", &["no random offset"]),
    ("origin_without_half", &["lacks the half pixel"]),
    ("aspect_pair", &["the configured aspect ratio"]),
    ("aspect_integers", &["divided as integers"]),
    ("u_not_unit", &["u is not normalised"]),
    ("vf_not_unit", &["the focal vector is not normalised"]),
    ("pv_positive", &["the vertical vector is not negated"]),
    ("fov_degrees", &["not converted to radians"]),
    ("fov_not_halved", &["not halved in the tangent"]),
    ("height_up", &["rounded up"]),
    ("height_nearest", &["rounded to the nearest"]),
    ("north_ignored", &["camera_north is ignored"]),
    ("printed_q", &["as printed"]),
    ("pixels_less_one", &["pixels less one"]),
    ("directions_unit", &["camera rays is normalised"]),
    ("mt32", &["a 32-bit generator"]),
    ("default_engine", &["default_random_engine"]),
    ("one_generator", &["one generator for rays and materials, with the seed of the materials"]),
    ("seeds_swapped", &["the two seeds are swapped"]),
    ("unseeded", &["not seeded"]),
    ("seed_per_row", &["again for each row"]),
    ("seed_plus_row", &["again for each row"]),
    ("seed_per_pixel", &["again for each pixel"]),
    ("seed_plus_pixel", &["again for each pixel"]),
    ("seed_per_sample", &["again for each sample"]),
    ("threads", &["4 bands of rows"]),
    ("zyx", &["z, y, x"]),
    ("columns_first", &["column by column"]),
    ("rows_upwards", &["from the bottom to the top"]),
    ("samples_outermost", &["once for each sample"]),
    ("upside_down", &["upside down"]),
    ("mirrored", &["mirrored left to right"]),
    ("bgr", &["blue, green, red"]),
    ("no_last_draws", &["for the last hit of the depth"]),
    ("smooth_without_draws", &["diffusion 0 draws no"]),
    ("depth_more", &["one more ray"]),
    ("depth_less", &["one less ray"]),
    ("end_background", &["beyond the depth contributes the background"]),
    ("limit_1e_4", &["1e-4 instead"]),
    ("limit_1e_8", &["instead of 1e-3"]),
    ("limit_0", &["is 0 instead"]),
    ("first_root", &["only the smaller root"]),
    ("far_root", &["the larger root is used for spheres"]),
    ("last_object", &["the last object"]),
    ("tie_first", &["the first one stays"]),
    ("sign_of_b", &["the printed sign"]),
    ("radius_not_squared", &["not squared in c of spheres"]),
    ("normal_not_divided", &["not divided by the radius"]),
    ("normal_inward", &["points inward, C - I"]),
    ("side_unit", &["side is normalised"]),
    ("axis_not_unit", &["the axis of cylinders is not normalised"]),
    ("height_double", &["so it doubles"]),
    ("height_half", &["halved twice"]),
    ("center_is_base", &["its lower base"]),
    ("endless_side", &["not limited to the height"]),
    ("endless_caps", &["not limited to the radius"]),
    ("no_caps", &["lack both bases"]),
    ("no_lower_cap", &["lack the lower base"]),
    ("no_side", &["lack their side"]),
    ("cap_not_turned", &["lower base is not turned"]),
    ("no_flip", &["not turned round for hits from inside"]),
    ("unit_vectors", &["unit vectors"]),
    ("ball", &["lie in the ball"]),
    ("cube_normalised", &["of the cube are normalised"]),
    ("matte_alone", &["not added to the normal"]),
    ("no_reflectance", &["reflectance of matte and metal is left out"]),
    ("metal_not_unit", &["reflected direction of metal is not normalised"]),
    ("metal_unit_after", &["normalised after the diffusion"]),
    ("no_diffusion", &["the diffusion of metal is ignored"]),
    ("clamp_diffusion", &["above 1 counts as 1"]),
    ("absorb", &["below the surface"]),
    ("refract_not_unit", &["without normalising it"]),
    ("rho_swapped", &["inverted on the wrong side"]),
    ("rho_never", &["always rho"]),
    ("no_total_reflection", &["total reflection"]),
    ("schlick", &["Schlick"]),
    ("bias_1e_3", &["1e-3 along the normal"]),
    ("bias_1e_4", &["1e-4 along the normal"]),
    ("bias_direction", &["1e-4 times the direction"]),
    ("background_swapped", &["colours are swapped"]),
    ("background_not_unit", &["the background uses the direction"]),
    ("no_gamma", &["gamma correction is missing"]),
    ("gamma_inverted", &["the exponent gamma"]),
    ("gamma_first", &["comes before the mean"]),
    ("rounded", &["rounded to the nearest, not truncated"]),
    ("scale_256", &["scaled by 256"]),
    // Two together, of one stage and of several, and with an order that is permitted.
    ("half_twice,no_caps", &["half pixel is added twice", "lack both bases"]),
    ("mt32,rho_never", &["32-bit", "always rho"]),
    ("seeds_swapped,side_unit", &["seeds are swapped", "side is normalised"]),
    ("no_gamma,seed_per_row", &["gamma correction is missing", "each row"]),
    ("limit_1e_4,no_flip", &["1e-4 instead", "not turned round"]),
    ("pv_positive,rounded", &["not negated", "rounded to the nearest"]),
    ("depth_more,no_diffusion", &["one more ray", "diffusion of metal is ignored"]),
    ("last_object,bgr", &["last object", "blue, green, red"]),
    ("origin_without_half,metal_unit_after", &["lacks the half pixel", "normalised after"]),
    ("refract_not_unit,no_total_reflection", &["without normalising it", "total reflection"]),
    ("bias_1e_4,limit_0", &["1e-4 along the normal", "instead of 1e-3"]),
    ("zyx,height_double", &["z, y, x", "so it doubles"]),
    ("unit_vectors,y_before_x", &["unit vectors", "y is drawn before"]),
    ("zyx,half_twice,no_reflectance", &["z, y, x", "half pixel", "left out"]),
    ("unit_vectors,columns_first,first_root", &["unit vectors", "column by column", "smaller root"]),
    ("no_flip,depth_less", &["not turned round", "one less ray"]),
];

/// Mistakes that the table does not know, and three together.
const UNKNOWN: &[&str] =
    &["background_x", "reflectance_squared", "scale_254", "background_x,zyx", "mt32,no_caps,rounded"];

/// One of this many mistakes is made, unless `RENDER_ALL` is 1: a diagnosis takes a second.
const STEP: usize = 8;

/// Number of trials. Each has a part of the mistakes.
const TRIALS: usize = 2;

/// Returns the program's pictures of all cases.
fn pictures(program: &Path, cases: &[Case], mistakes: &str) -> Result<Vec<Picture>, Failed> {
    let folder = Folder::new();
    let draw = |case: &Case| {
        let [config, scene] = case.files;
        let (config, scene, out) =
            (folder.write("config", config), folder.write("scene", scene), folder.file("out.ppm"));
        let status = Command::new(program).args([&config, &scene, &out]).env("MISTAKES", mistakes).status()?;
        assert!(status.success(), "{mistakes}: {status}");
        let read = p3::read(&std::fs::read(out)?)?;
        Ok(Picture { width: read.width, height: read.height, pixels: read.pixels })
    };
    cases.iter().map(draw).collect()
}

/// Returns the words of each set of deviations that explains the pictures.
fn diagnosed(search: &mut Search<'_>, pictures: &[Picture]) -> Vec<Vec<String>> {
    let found = search.explain(pictures).expect("there is memory");
    found.into_iter().map(|(variants, _)| variants.into_iter().map(|variant| variant.words).collect()).collect()
}

/// Checks what is said of the mistakes of a trial, one of [`TRIALS`].
fn names_the_mistakes(trial: usize) -> Result<(), Failed> {
    let folder = Folder::new();
    let program = cpp::build("student", &folder)?;
    let cases = cases()?;
    let mut search = Search::new(&cases);
    let mut faults = Vec::new();
    let unknown = UNKNOWN.iter().map(|mistakes| (*mistakes, None));
    let all: Vec<_> = NAMED.iter().map(|(mistakes, words)| (*mistakes, Some(*words))).chain(unknown).collect();
    assert!(all.len() >= 100);
    let step = if test_support::everything() { 1 } else { STEP };
    for &(mistakes, expected) in all.iter().step_by(step).skip(trial).step_by(TRIALS) {
        let found = diagnosed(&mut search, &pictures(&program, &cases, mistakes)?);
        let is_right = match expected {
            None => found.is_empty(),
            Some(expected) => {
                let is_named = |words: &Vec<String>| {
                    words.len() == expected.len()
                        && expected.iter().all(|it| words.iter().any(|words| words.contains(it)))
                };
                !found.is_empty() && found.iter().all(is_named)
            }
        };
        if !is_right {
            faults.push(format!("{mistakes}: {found:?}"));
        }
    }
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n").into()) }
}

fn main() {
    let named = |index| {
        let name = format!("mistakes of a student's program are named, part {}", index + 1);
        trial(name, cpp::missing(), move || names_the_mistakes(index))
    };
    test_support::run_trials((0..TRIALS).map(named).collect())
}
