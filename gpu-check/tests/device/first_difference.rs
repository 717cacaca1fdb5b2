//! Tests the search for the first difference with the suite's mutants: it must name the function that is wrong. With
//! `RENDER_ALL=1` all mutants are tried.

use gpu_check::first_difference::report::{Places, report};
use gpu_check::first_difference::{FirstDifference, of_pixel};
use gpu_check::{Picture, features_of};
use shaders::Library;

use crate::common;
use crate::mutants::examiner::Examiner;
use crate::mutants::mutant::{Mutant, of_modules};
use crate::scenes;

/// One of this many mutants is tried, unless `RENDER_ALL` is 1: the search for a pixel that
/// differs takes seconds.
const STEP: usize = 12;

/// Whether the search names the mutant's function. If the changed line is in no function with a result, such as
/// `trace_path`, the search must say that no such function is wrong.
fn is_named(mutant: &Mutant, places: &Places, found: &FirstDifference<f64>) -> bool {
    let source = Library::standard();
    let source = source.source(&mutant.module).expect("the mutant's module exists");
    let place = source.find(&mutant.from).expect("the mutant's text is there");
    let line = source[..place].matches('\n').count() + 1;
    let file = format!("{} (mutant)", mutant.module);
    let is_inside = |(_, [(path, first), (_, last)]): &(String, [(String, usize); 2])| {
        *path == file && (*first..=*last).contains(&line)
    };
    match found {
        FirstDifference::Call { .. } => places.functions.iter().any(is_inside),
        FirstDifference::Rest { .. } => places.functions.iter().any(is_inside) || is_outside(source, line),
    }
}

/// Whether the line is in no function with a result: in a function without one, an entry point or a declaration.
fn is_outside(source: &str, line: usize) -> bool {
    let before: Vec<_> = source.lines().take(line).collect();
    let start = before.iter().rposition(|text| text.starts_with("fn ") || text.starts_with('}'));
    start.is_none_or(|at| !before[at].contains("->"))
}

#[test]
fn the_function_of_nearly_every_mutant_is_named() {
    let gpu = common::gpu();
    let examiner = Examiner::new(&gpu).unwrap_or_else(|error| panic!("{error}"));
    let step = if test_support::everything() { 1 } else { STEP };
    let (mut missed, mut found) = (Vec::new(), 0);
    for mutant in of_modules().iter().step_by(step) {
        let library = mutant.library().expect("its module exists");
        let located = examiner.first_difference(&library, &mutant.module);
        let Some((trace, difference)) = located.unwrap_or_else(|error| panic!("{mutant:?}: {error}")) else {
            // Only pictures with random numbers show this mutant.
            continue;
        };
        found += 1;
        let places = Places::new(&trace, &difference).expect("the modules exist");
        if !is_named(mutant, &places, &difference) {
            let text = report(&trace, &difference).expect("the modules exist");
            missed.push(format!("{}: [{}] => [{}]\n{text}", mutant.module, mutant.from, mutant.to));
        }
    }
    println!("{found} mutants have a first difference, {} in another function", missed.len());
    println!("{}", missed.join("\n"));
    assert!(found * step >= 48, "{found}");
    assert!(missed.len() * 8 <= found, "{} of {found}", missed.len());
}

#[test]
fn without_a_change_there_is_no_first_difference() {
    let gpu = common::gpu();
    for case in scenes::edges().into_iter().map(|case| case.within(2_000)) {
        let features = features_of(&case.config, &case.scene).expect("it is valid");
        let picture = Picture::<f64>::new(&case.config, &case.scene).expect("it is valid");
        let middle = picture.size.pixels() / 2;
        for index in if test_support::everything() { vec![0, middle] } else { vec![middle] } {
            let found = of_pixel(&gpu, &Library::standard(), (&features, &[]), &picture, index);
            let found = found.unwrap_or_else(|error| panic!("{}: {error}", case.name));
            assert!(found.is_none(), "{}: {:?}", case.name, found.map(|(_, found)| found));
        }
    }
}
