//! Renders scenes of many objects in the hierarchy, and prints the times.

use std::time::Instant;

use cpu::{Config, Scene, Vec3};
use gpu_check::difference::difference;
use gpu_check::{Float, Form, Picture};
use shaders::Library;

use crate::pictures::{on_device, prepared};
use crate::scenes::{self, Case};
use test_support::everything;

/// Number of spheres of the largest scene, if everything is rendered. By default it has 70,000, which are more than the
/// iterations of a loop.
const MOST_SPHERES: usize = 1_000_000;

/// Returns `scenes/ten-thousand` with `width` columns of pixels.
pub fn ten_thousand(width: u64) -> Case {
    let cases = scenes::in_folder("scenes");
    let mut case = cases.into_iter().find(|case| case.name.contains("ten-thousand")).expect("the scene exists");
    case.config.image_width = width;
    case
}

#[test]
fn ten_thousand_objects_have_the_picture_of_the_loop_over_all_objects() {
    let case = ten_thousand(if everything() { 480 } else { 48 });
    let all = on_device::<f64>(&crate::common::gpu(), &Library::standard(), &case);
    println!("ten-thousand: {:.1?} without the hierarchy", all.time);
    for &form in if everything() { &Form::ALL[..] } else { &[Form::AsWritten] } {
        let gpu = crate::common::gpu().with_form(form);
        let library = Library::standard().in_hierarchy();
        let (renderer, picture) = prepared::<f64>(&gpu, &library, &case).expect("it compiles");
        // The time of the first picture has that of bringing the program to the device.
        let [_, tree] = [(); 2].map(|()| renderer.render(&picture).expect("it is not deep"));
        let found = difference(&tree.pixels, &all.pixels);
        println!("{} x {}, {form}: {:.2?}, {found}", tree.size.width(), tree.size.height(), tree.time);
        assert!(found.differing == 0 || form == Form::AsDriverLikes, "{found}");
    }
}

#[test]
fn a_million_spheres_or_more_than_a_loop_may_pass_are_rendered() {
    let count = if everything() { MOST_SPHERES } else { 70_000 };
    let side = (count as f64).cbrt().ceil() as usize;
    let mut text = String::from("matte: red .9 .1 .1\nmetal: grey .6 .6 .6 0\n");
    for number in 0..count {
        let [x, y, z] = [number % side, number / side % side, number / side / side].map(|place| 2 * place);
        let material = if number.is_multiple_of(7) { "grey" } else { "red" };
        text.push_str(&format!("sphere: {x} {y} -{z} {} {material}\n", 0.3 + 0.001 * (number % 300) as f64));
    }
    let scene = Scene::parse(text.as_bytes()).expect("it is valid");
    let middle = side as f64;
    let config = Config {
        image_width: 240,
        max_depth: 5,
        camera_position: Vec3::new(middle, middle, 30.0),
        camera_target: Vec3::new(0.6 * middle, 0.7 * middle, -middle),
        ..Config::default()
    };
    let case = Case { name: format!("{count} spheres"), config, scene };
    let gpu = crate::common::gpu();
    let start = Instant::now();
    let tree = on_device::<f64>(&gpu, &Library::standard().in_hierarchy(), &case);
    println!("{}: {:.2?} on the device, {:.1?} with building and transfers", case.name, tree.time, start.elapsed());
    // The CPU loops over all objects too, so it computes a few pixels.
    let twin = Picture::<f64>::new(&case.config, &case.scene).expect("it is valid");
    let mut hits = 0;
    for index in (0..tree.pixels.len()).step_by(tree.pixels.len() / 24) {
        let expected = twin.color(index);
        let actual = tree.pixels[index];
        assert!(actual.to_array().iter().zip(expected.to_array()).all(|(one, other)| one.same(other)), "{index}");
        hits += usize::from(twin.steps(index)[0].is_hit() == 1.0);
    }
    println!("{hits} of 24 compared pixels show a sphere");
    assert!(hits > 6);
}
