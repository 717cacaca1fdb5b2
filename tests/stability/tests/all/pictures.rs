//! Tests that ordinary pictures have the bytes of the plain formulas, and that nearly all lambdas have the bits of the
//! plain formulas.

use std::fs;
use std::path::PathBuf;

use cpu::reference::intersect::Exact;
use cpu::{Aos, Config, Layout, Scatter, Scene};
use stability::run;

fn cases() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/cases"))
}

fn read(case: &str) -> (Config, Scene) {
    let folder = cases().join(case);
    let config = Config::read(&folder.join("config.txt")).expect("the configuration is valid");
    (config, Scene::read(&folder.join("scene.txt")).expect("the scene is valid"))
}

#[test]
fn exact_pictures_have_the_digests_of_an_independent_program() {
    let sums = fs::read_to_string(cases().join("SHA256SUMS")).expect("the list of digests is there");
    let mut compared = 0;
    for line in sums.lines().filter(|line| !line.starts_with('#')) {
        let (expected, file) = line.split_once("  ").expect("a line is a digest and a name");
        let (convention, case) = file.split_once('/').expect("a name is a convention and a case");
        let scatter = if convention == "statement" { Scatter::Statement } else { Scatter::Published };
        let (config, scene) = read(case.trim_end_matches(".ppm"));
        let image: <Aos as Layout>::Image =
            cpu::reference::render_with::<_, Exact>(&config, &scene, scatter).expect("it renders");
        let mut ppm = Vec::new();
        cpu::internals::image::ppm::write_ppm(&image, &mut ppm).expect("memory takes all bytes");
        let actual = format::digest::sha256(&ppm);
        assert_eq!(actual, expected, "{file}");
        compared += 1;
    }
    assert_eq!(compared, 32, "16 cases in two conventions");
}

#[test]
fn ordinary_pictures_keep_the_bits_of_nearly_all_lambdas_and_all_decisions() {
    let mut hits = 0;
    for case in ["02", "05", "09", "13"] {
        let (config, scene) = read(case);
        let picture = run::picture(case, &config, &scene, Scatter::Statement).expect("it renders");
        let counts = picture.counts;
        assert!(picture.same_bytes, "case {case}");
        assert_eq!(counts.other_decision, 0, "case {case}");
        assert!(counts.same_bits * 1000 >= counts.hits * 995, "case {case}: {counts:?}");
        hits += counts.hits;
    }
    assert!(hits > 10_000, "{hits}");
}
