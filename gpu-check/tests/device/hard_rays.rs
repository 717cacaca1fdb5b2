//! Compares the intersections in WGSL with exact arithmetic, with fewer rays than the program `stress`.

use gpu_check::methods::{self, PLAIN, PLAIN_SINGLE, PROJECTED};
use stability::case::Case;
use stability::measure::{Judged, Row};
use stability::methods::{Answer, Method};
use stability::regimes::{CYLINDERS, Regime, SPHERES};
use stability::run;

use crate::common::{self, Accuracy};

const SEED: u64 = 5;
const RAYS: usize = 20_000;
/// Names of the regimes in which no ray starts on its sphere, or so near to it that lambda may be too small to be in
/// range.
const OFF_THE_SURFACE: [&str; 5] =
    ["ordinary", "far and small", "grazing", "tangent to the last bit", "direction lengths"];

fn in_rust(name: &str) -> Box<dyn Method> {
    let found = stability::methods::all().into_iter().find(|method| method.name() == name);
    found.unwrap_or_else(|| panic!("Rust has no [{name}]"))
}

fn answers(method: &dyn Method, cases: &[Case]) -> Vec<Option<Answer>> {
    method.answer(cases).unwrap_or_else(|error| panic!("{}: {error}", method.name()))
}

fn regimes() -> impl Iterator<Item = &'static Regime> {
    SPHERES.iter().chain(&CYLINDERS)
}

#[test]
fn answers_of_wgsl_to_hard_rays_have_the_bits_of_rust() {
    let gpu = common::gpu();
    let accuracy = common::accuracy(&gpu);
    let in_wgsl = methods::all(gpu).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(in_wgsl.len(), 3);
    for method in in_wgsl {
        if method.name() != PLAIN && accuracy == Accuracy::Wgsl {
            continue;
        }
        let name = method.name().strip_prefix(run::WGSL).expect("names begin with WGSL");
        let twin = in_rust(name);
        assert_eq!(method.unit_roundoff(), twin.unit_roundoff());
        let mut hits = 0;
        for regime in regimes() {
            let cases = regime.cases(SEED, RAYS);
            let (wgsl, rust) = (answers(method.as_ref(), &cases), answers(twin.as_ref(), &cases));
            assert_eq!(wgsl.len(), RAYS);
            // Equal numbers have equal bits, except zeros of different signs, which tests/kernels.rs compares.
            let parted = wgsl.iter().zip(&rust).filter(|(wgsl, rust)| wgsl != rust).count();
            assert_eq!(parted, 0, "{name}, {}", regime.name);
            hits += wgsl.iter().flatten().count();
        }
        println!("{name}: {hits} hits of {} rays, all with the bits of Rust", RAYS * regimes().count());
        assert!(hits > RAYS * regimes().count() / 2);
    }
}

#[test]
fn f32_in_wgsl_is_wrong_only_within_its_rounding_errors_off_the_surface() {
    let in_wgsl = methods::all(common::gpu()).unwrap_or_else(|error| panic!("{error}"));
    let measure = |judged: &Judged, name: &str| -> Row {
        let method = in_wgsl.iter().find(|method| method.name() == name).expect("it is listed");
        judged.measure(method.as_ref()).unwrap_or_else(|error| panic!("{error}"))
    };
    let (mut wrong, mut plain_beyond) = (0, 0);
    for name in OFF_THE_SURFACE {
        let regime = SPHERES.iter().find(|regime| regime.name == name).expect("it is listed");
        let judged = Judged::new(regime.name, regime.cases(SEED + 1, RAYS / 4));
        let row = measure(&judged, PROJECTED);
        println!("{name}: {} of {} wrong", row.wrong, row.cases);
        assert_eq!(row.wrong_beyond_noise, Some(0), "{name}");
        wrong += row.wrong;
        plain_beyond += measure(&judged, PLAIN_SINGLE).wrong_beyond_noise.unwrap_or(0);
        if name == "ordinary" {
            assert_eq!(measure(&judged, PLAIN).wrong, 0, "f64 decides ordinary rays rightly");
        }
    }
    assert!(wrong > RAYS / 20, "few rays were near the noise: {wrong}");
    assert!(plain_beyond > RAYS / 100, "the plain formula's form is no longer worse: {plain_beyond}");
}
