//! Tests that the reference gives the digests of the literal program, with which it shares no code. All other renderers
//! are compared with the reference.

use cpu::internals::layout::aos::AosImage;
use cpu::{Config, Scene};
use test_support::{golden, ppm};

#[test]
fn the_reference_gives_the_digests_of_the_small_scenes() {
    let mut compared = 0;
    for golden in golden::cases() {
        let config = Config::read(&golden.config).expect("committed configurations are valid");
        let scene = Scene::read(&golden.scene).expect("committed scenes are valid");
        let image = cpu::reference::render::<AosImage>(&config, &scene, golden.scatter).expect("it fits");
        assert_eq!(golden.digest(), Ok(digest::sha256(&ppm(&image))), "{}", golden.name);
        compared += 1;
    }
    assert_eq!(compared, 32, "16 scenes in both conventions");
}
