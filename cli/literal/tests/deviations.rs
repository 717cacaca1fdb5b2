//! Checks the table of deviations: the literal renderer follows the statement without any, and the cases tell them
//! apart.

use std::collections::{HashMap, HashSet};

use cpu::{Aos, Image, Layout, Scatter};
use literal::cases::cases;
use literal::develop::Picture;
use literal::renderer::Renderer;
use literal::rules::{Rules, Variant, table};

/// Returns the pictures of all cases with these deviations.
fn pictures(variants: &[Variant], scatter: Scatter) -> Vec<Picture> {
    let picture = |case: &literal::cases::Case| {
        let renderer = Renderer::new(&case.config, &case.scene, scatter, Rules::with(variants));
        renderer.and_then(|mut renderer| renderer.picture()).expect("it is small")
    };
    cases().expect("they are valid").iter().map(picture).collect()
}

#[test]
fn without_deviations_the_pictures_are_the_references() {
    let mut compared = 0;
    for scatter in [Scatter::Statement, Scatter::Published, Scatter::Deterministic] {
        for (case, picture) in cases().expect("they are valid").iter().zip(pictures(&[], scatter)) {
            let image = cpu::reference::render::<<Aos as Layout>::Image>(&case.config, &case.scene, scatter);
            let image = image.expect("it is small");
            let expected: Vec<_> = (0..image.size().pixels()).map(|at| image.pixel(at)).collect();
            let expected: Vec<_> = expected.iter().map(|color| [color.red, color.green, color.blue]).collect();
            assert_eq!((picture.width, picture.pixels == expected), (image.size().width(), true), "{}", case.name);
            compared += 1;
        }
    }
    assert!(compared >= 40, "{compared} pictures");
}

#[test]
fn every_deviation_shows_and_no_two_have_equal_pictures() {
    let mut known: HashMap<Vec<Picture>, Variant> = HashMap::new();
    let statement = pictures(&[], Scatter::Statement);
    let mut faults = Vec::new();
    for variant in table() {
        let pictures = pictures(std::slice::from_ref(&variant), Scatter::Statement);
        if pictures == statement {
            faults.push(format!("{}: it does not show", variant.words));
        }
        let other = known.entry(pictures).or_insert_with(|| variant.clone());
        if other.name != variant.name {
            faults.push(format!("{} = {}", variant.words, other.words));
        }
    }
    assert_eq!(faults, [""; 0]);
    assert!(known.len() >= 220, "{} pictures", known.len());
}

#[test]
fn the_table_has_a_section_words_and_a_value_for_each_deviation() {
    let page = include_str!("../../../docs/specification.md");
    let names: HashSet<_> = table().iter().map(|variant| variant.name).collect();
    assert!(names.len() >= 90, "{} deviations", names.len());
    for variant in table() {
        assert!(variant.value.is_finite() && !variant.words.contains(['{', '\\', '=']), "{variant:?}");
        // The specification cites the sections of the statement.
        assert!(page.contains(&format!("statement {}", &variant.section[..3])), "{variant:?}");
    }
}
