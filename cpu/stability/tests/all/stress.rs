//! The stress test with fewer rays. The program `stress` of `gpu-check` runs the whole test.

use stability::methods::{self, PROJECTED};
use stability::regimes::{CYLINDERS, Regime, SPHERES};
use stability::report::Section;
use stability::run;

const SEED: u64 = 7;
const RAYS: usize = 20_000;

fn sections(regimes: &[Regime], seed: u64, count: usize) -> Vec<Section> {
    run::sections(&methods::all(), regimes, seed, count).expect("formulas in Rust have answers")
}

fn row<'a>(sections: &'a [Section], regime: &str, method: &str) -> &'a stability::measure::Row {
    let mut rows = sections.iter().flat_map(|section| &section.rows);
    rows.find(|row| row.regime == regime && row.method == method).expect("the regime was run")
}

#[test]
fn spheres_are_met_rightly_in_every_regime_and_by_the_plain_formulas_not() {
    let sections = sections(&SPHERES, SEED, RAYS);
    assert_eq!(sections.len(), 9);
    let plain_wrong = run::check(&sections, [run::PROVEN_ERRORS[0]; 2]).expect("exact intersections are right");
    assert!(plain_wrong > RAYS / 2, "the regimes are no longer hard: the plain formulas are wrong {plain_wrong} times");
    let ordinary = &sections[0];
    assert!(ordinary.fallbacks[0] < 0.005, "{:?}", ordinary.fallbacks);
    assert!(sections.iter().any(|section| section.fallbacks[1] > 0.01), "exact arithmetic was never needed");
}

#[test]
fn cylinders_are_met_rightly_in_every_regime_and_by_the_plain_formulas_not() {
    let sections = sections(&CYLINDERS, SEED, RAYS / 2);
    assert_eq!(sections.len(), 10);
    let plain_wrong = run::check(&sections, [1e-11, 1e-9]).expect("exact intersections are right");
    assert!(
        plain_wrong > RAYS / 10,
        "the regimes are no longer hard: the plain formulas are wrong {plain_wrong} times"
    );
    assert!(sections[0].fallbacks[0] < 0.01, "{:?}", sections[0].fallbacks);
    assert!(sections.iter().any(|section| section.fallbacks[1] > 0.01), "exact arithmetic was never needed");
}

#[test]
fn single_precision_in_the_projected_form_is_wrong_only_within_its_noise() {
    let regimes = ["ordinary", "far and small", "grazing", "tangent to the last bit", "direction lengths"];
    let sections = sections(&SPHERES, SEED + 1, RAYS);
    let mut wrong = 0;
    for regime in regimes {
        let row = row(&sections, regime, PROJECTED);
        assert_eq!(row.wrong_beyond_noise, Some(0), "{regime}");
        wrong += row.wrong;
    }
    assert!(wrong > 0, "nothing near the noise was tried");
}
