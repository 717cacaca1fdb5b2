//! Any bytes as a tiny scene, rendered every way there is.
//!
//! The bytes choose: a menu of hard numbers (0, the smallest and the largest, what is nearly 1), or any number at all.
//! So every input is a valid scene and a valid configuration, and libFuzzer spends its time on geometry and not on
//! grammar.

mod choices;

use cpu::internals::layout::aos::AosImage;
use cpu::internals::{InstructionSet, Prepared};
use cpu::reference::intersect::Certified;
use cpu::{Aos, Config, Image, Layout, Scatter, Scene, Soa};

pub use choices::Choices;

const SCATTERS: [Scatter; 3] = [Scatter::Statement, Scatter::Published, Scatter::Deterministic];

/// Both layouts give the reference's bytes, or its refusal; the first with every instruction set of the machine.
///
/// # Panics
/// When it does not hold; the message has both files.
pub fn check(bytes: &[u8]) {
    let mut choices = Choices::new(bytes);
    let scatter = SCATTERS[choices.below(3)];
    // A choice that is no longer there; read on, so that inputs kept from earlier runs make the same scenes.
    let _ = choices.below(2);
    let (config, scene) = (choices.config(), choices.scene());
    let expected = cpu::reference::render_with::<AosImage, Certified>(&config, &scene, scatter);
    let expected = expected.map_err(|error| error.to_string());
    let all: Vec<_> = InstructionSet::ALL.into_iter().filter(|set| set.is_available()).collect();
    held_to::<Aos>(&config, &scene, scatter, &all, &expected);
    held_to::<Soa>(&config, &scene, scatter, &[InstructionSet::best()], &expected);
}

fn held_to<L: Layout>(
    config: &Config,
    scene: &Scene,
    scatter: Scatter,
    sets: &[InstructionSet],
    expected: &Result<AosImage, String>,
) {
    let files = || {
        format!("config.txt:\n{}scene.txt:\n{}", test_support::write::config(config), test_support::write::scene(scene))
    };
    let layout = std::any::type_name::<L>();
    let prepared = Prepared::<L>::new(config, scene, scatter).map_err(|error| error.to_string());
    match (prepared, expected) {
        (Err(real), Err(reference)) => assert_eq!(&real, reference, "{}", files()),
        (Ok(prepared), Ok(expected)) => {
            for set in sets {
                let actual = cpu::internals::render_with(&prepared, *set).expect("the picture is tiny");
                assert_eq!(actual.size(), expected.size());
                for index in 0..expected.size().pixels() {
                    let (actual, expected) = (actual.pixel(index), expected.pixel(index));
                    if actual != expected {
                        let set = set.name();
                        panic!(
                            "{layout}, {set}, {scatter:?}: pixel {index} is {actual:?}, not {expected:?}\n{}",
                            files()
                        );
                    }
                }
            }
        }
        (real, reference) => {
            panic!("{:?} where the reference says {:?}\n{}", real.err(), reference.as_ref().err(), files());
        }
    }
}
