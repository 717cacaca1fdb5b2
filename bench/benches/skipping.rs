//! Measures the gain of shortcuts, which skip work that a scene does not need. It renders a picture with and without a
//! shortcut in turn, and compares the user times: `cargo bench -p bench --bench skipping`.

use std::hint::black_box;

use cpu::internals::accel::{choice::Accel, every_object::EveryObject};
use cpu::internals::image::quantize;
use cpu::internals::image::quantize::Quantizer;
use cpu::internals::sampling::uniform::Uniform;
use cpu::internals::{InstructionSet, Limits, Prepared};
use cpu::{Aos, Config, Image, Layout, Scatter, Scene};
use generator::{self, Arrangement, Options};
use measure::turns::compare;

type Picture = <Aos as Layout>::Image;

const ROUNDS: usize = 7;

/// Background colours that form a gradient in all three channels.
const COLORS: &str = "background_dark_color: .2 .4 .8\nbackground_light_color: .9 .8 .7\n";
const ONE_COLOR: &str = "background_dark_color: .3 .5 .7\nbackground_light_color: .3 .5 .7\n";
const MATTE: &str = "matte: m .5 .6 .7\n";
const MIRROR: &str = "metal: m .9 .8 .7 0\n";
/// Two spheres next to each other. They leave most of the picture to the background.
const BALLS: &str = "sphere: -1.5 0 0 1.4 m\nsphere: 1.5 0 0 1.4 m\n";

fn prepared(config: &str, scene: &str) -> Prepared<Aos> {
    let config = format!("image_width: 320\nsamples_per_pixel: 20\nfield_of_view: 40\n{config}");
    let config = Config::parse(config.as_bytes()).expect("the configuration is valid");
    let scene = Scene::parse(scene.as_bytes()).expect("the scene is valid");
    Prepared::new(&config, &scene, Scatter::Statement).expect("it can be rendered")
}

fn render(prepared: &Prepared<Aos>) -> Picture {
    cpu::internals::render_with(prepared, InstructionSet::chosen()).expect("it is small")
}

/// Renders a picture as [`render`] does, but traces all samples of every pixel.
fn render_every_sample(prepared: &Prepared<Aos>) -> Picture {
    let mut image = Picture::black(prepared.size).expect("it is small");
    cpu::internals::render_linear(prepared, InstructionSet::chosen(), &Limits::default(), |index, mean| {
        let [red, green, blue] = mean.to_array().map(|channel| prepared.quantizer.quantize(channel));
        image.set_pixel(index, cpu::Rgb { red, green, blue });
    })
    .expect("it fits");
    image
}

fn row(what: &str, skipping: impl FnMut(), doing: impl FnMut()) {
    let [with, without, ratio] = compare(ROUNDS, skipping, doing);
    println!("{what:<60} {:>9.2} {:>9.2} {ratio:>7.2}", with * 1e3, without * 1e3);
}

/// Compares the times of two functions that must render the same picture.
fn pictures(what: &str, skipping: impl Fn() -> Picture, doing: impl Fn() -> Picture) {
    assert!(test_support::ppm(&skipping()) == test_support::ppm(&doing()), "{what}: the pictures differ");
    row(what, || drop(skipping()), || drop(doing()));
}

/// Compares the times of a picture with and without a shortcut. `disable` switches the shortcut off.
fn without(what: &str, config: &str, scene: &str, disable: fn(&mut Prepared<Aos>)) {
    let (skipping, mut doing) = (prepared(config, scene), prepared(config, scene));
    disable(&mut doing);
    pictures(what, || render(&skipping), || render(&doing));
}

/// Compares the times of a scene without and with a hidden object. The hidden object is never seen, but makes a
/// shortcut impossible.
fn beside_hidden(what: &str, scene: &str, hidden: &str) {
    let (skipping, doing) = (prepared(COLORS, scene), prepared(COLORS, &format!("{scene}{hidden}")));
    pictures(what, || render(&skipping), || render(&doing));
}

/// Compares the times with and without the shortcut for background pixels, which gives their bytes without rays.
fn sky(what: &str, colors: &str, scene: &str) {
    let prepared = prepared(colors, scene);
    pictures(what, || render(&prepared), || render_every_sample(&prepared));
}

/// Compares the times with the acceleration structure and with a loop over all objects. The scene has a ground and
/// `objects` matte objects in a grid; the picture is `width` pixels wide.
fn board(what: &str, objects: usize, width: u64) {
    let options = Options { objects, arrangement: Arrangement::Grid, materials: [1.0, 0.0, 0.0], ..Options::default() };
    let config = Config { image_width: width, samples_per_pixel: 4, ..generator::view(&options) };
    let new = || Prepared::<Aos>::new(&config, generator::scene(&options), Scatter::Statement).expect("it is small");
    let (skipping, mut doing) = (new(), new());
    (doing.accel, doing.moderate) = (Accel::EveryObject(EveryObject), false);
    pictures(what, || render(&skipping), || render(&doing));
}

/// Compares the times with and without the shortcut for isolated objects. The scene is a ground of rough metal with
/// `objects` spheres of glass above it. The rays that the ground scatters go inward as often as outward.
fn ground(what: &str, objects: u32) {
    let row = (0..objects).map(|at| f64::from(at) - f64::from(objects) / 2.0);
    let above: String = row.map(|x| format!("sphere: {} 1 {} .4 g\n", x % 5.0, (x / 5.0).floor())).collect();
    let scene = format!("metal: m .9 .8 .7 4\nrefractive: g 1.5\nsphere: 0 -60 0 60 m\n{above}");
    let config = format!("{COLORS}camera_position: 0 5 -10\n");
    without(what, &config, &scene, |prepared| {
        prepared.accel.without_isolation();
    });
}

/// Compares two ways to quantise: by a table, and by the power function of the gamma correction.
fn gamma() {
    let mut draws = Uniform::new(7);
    let means: Vec<_> = (0..300_000).map(|_| draws.canonical()).collect();
    let quantizer = Quantizer::new(2.2);
    let sum = |byte: &dyn Fn(f64) -> u8| means.iter().map(|&mean| u64::from(byte(mean))).sum::<u64>();
    let (table, power) = (|mean| quantizer.quantize(mean), |mean| quantize::quantize(mean, 2.2));
    assert_eq!(sum(&table), sum(&power), "the bytes differ");
    row(
        "the power of the gamma correction, 100,000 pixels",
        || _ = black_box(sum(&table)),
        || _ = black_box(sum(&power)),
    );
}

fn main() {
    // `cargo test --benches` only checks that the benchmark starts.
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    let _ = bench::instruction_set();
    println!("{:<60} {:>9} {:>9} {:>7}", "milliseconds of user time, medians", "skipped", "done", "ratio");
    sky("rays of pixels that no object reaches, large objects", COLORS, &format!("{MATTE}{BALLS}"));
    sky("the same, a small object", COLORS, &format!("{MATTE}sphere: 2 1 0 .5 m\n"));
    sky("the same, the default sky, whose blue is 1 throughout", "", &format!("{MATTE}sphere: 2 1 0 .5 m\n"));
    sky("the same, one background colour", ONE_COLOR, &format!("{MATTE}sphere: 2 1 0 .5 m\n"));
    board("objects far from a ray, 7 objects", 7, 320);
    board("objects far from a ray, 100 objects", 100, 160);
    board("objects far from a ray, 1,000 objects", 1000, 80);
    ground("objects outside a ray's own object, 30 over a ground", 30);
    ground("objects outside a ray's own object, 300 over a ground", 300);
    let forty: String = (0..40).map(|at| format!("sphere: {} 0 0 .4 m\n", f64::from(at - 20) / 4.0)).collect();
    // The hidden objects are inside mirrors, so no ray reaches them.
    beside_hidden(
        "cylinders where there is none, 2 spheres",
        &format!("{MIRROR}{BALLS}"),
        "cylinder: 1.5 0 0 .1 0 .1 0 m\n",
    );
    beside_hidden(
        "cylinders where there is none, 40 spheres",
        &format!("{MIRROR}{forty}"),
        "cylinder: 0 0 0 .1 0 .1 0 m\n",
    );
    without("random vectors where all is smooth", COLORS, &format!("{MIRROR}{BALLS}"), |prepared| {
        prepared.scatter_stream = prepared.scatter;
    });
    let one = format!("{COLORS}max_depth: 1\n");
    without("random vectors with a depth of one", &one, &format!("{MATTE}{BALLS}"), |prepared| {
        prepared.scatter_stream = prepared.scatter;
    });
    let room = format!("{COLORS}max_depth: 3\n");
    let tube = format!("{MATTE}cylinder: 0 0 0 30 9 90 5 m\nsphere: 0 0 20 3 m\n");
    without("what a last ray meets, inside a tube with a ball", &room, &tube, |prepared| {
        prepared.scatters_everywhere = false;
    });
    without("an unused material that no filter bears, 40 spheres", COLORS, &format!("{MATTE}{forty}"), |prepared| {
        (prepared.accel, prepared.moderate) = (Accel::EveryObject(EveryObject), false);
    });
    gamma();
}
