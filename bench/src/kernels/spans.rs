//! The stages of a span: 32 pixels of a row, 32 samples each.

use cpu::internals::render::stages::Stages;
use cpu::internals::{InstructionSet, Prepared};
use cpu::{Aos, Config, Scatter, Scene};
use test_support::generator::{self, Arrangement, Options};

use super::{Kernel, Work};

/// A stage, and those that must come before it.
struct Stage {
    stages: Stages<'static>,
    before: fn(&mut Stages<'static>),
    turn: fn(&mut Stages<'static>),
}

impl Work for Stage {
    fn units(&self) -> u64 {
        self.stages.samples() as u64
    }
    fn prepare(&mut self) {
        (self.before)(&mut self.stages);
    }
    fn turn(&mut self) {
        (self.turn)(&mut self.stages);
    }
}

pub const KERNELS: &[Kernel] = &[
    Kernel { name: "sky", new: || stage("", |_| (), |stages| assert_eq!(stages.sky(), 32, "all is known")) },
    Kernel { name: "cull-tree", new: || on_board(1000, |_| (), Stages::cull) },
    Kernel { name: "sample-places", new: || stage("", |_| (), Stages::draw) },
    Kernel { name: "primary-nothing", new: || stage("", Stages::draw, Stages::primary) },
    Kernel { name: "primary-sphere", new: || stage("sphere: 0 0 0 6 m\n", Stages::draw, Stages::primary) },
    Kernel { name: "primary-cylinder", new: || stage("cylinder: 0 0 0 6 1 12 0 m\n", Stages::draw, Stages::primary) },
    Kernel { name: "glass", new: || stage("sphere: 0 0 0 6 g\nsphere: 0 0 0 3 g\n", in_glass, Stages::glass) },
    Kernel { name: "walk-few", new: || on_board(6, waiting_again, Stages::walk) },
    Kernel { name: "walk-filter", new: || on_board(60, waiting_again, Stages::walk) },
    Kernel { name: "walk-tree", new: || on_board(1000, waiting_again, Stages::walk) },
    Kernel { name: "walk-large-tree", new: || on_board(30_000, waiting_again, Stages::walk) },
    Kernel { name: "ends", new: || on_board(60, ended, Stages::ends) },
];

/// To where all samples are in glass.
fn in_glass(stages: &mut Stages<'static>) {
    stages.draw();
    stages.primary();
    assert_eq!(stages.waiting().0, stages.samples());
}

/// To where most samples wait for the walk.
fn waiting(stages: &mut Stages<'static>) {
    stages.draw();
    stages.primary();
    stages.glass();
    assert!(stages.waiting().1 > stages.samples() / 2, "{:?}", stages.waiting());
}

/// The same, when nothing is left of the walk before.
fn waiting_again(stages: &mut Stages<'static>) {
    stages.ends();
    waiting(stages);
}

/// To where all paths have ended.
fn ended(stages: &mut Stages<'static>) {
    waiting(stages);
    stages.walk();
}

/// A stage on a picture of these objects, of matte `m` or glass `g`, that fill it if there are any.
fn stage(objects: &str, before: fn(&mut Stages<'static>), turn: fn(&mut Stages<'static>)) -> Box<dyn Work> {
    let config = "field_of_view: 40\nbackground_dark_color: .2 .4 .8\nbackground_light_color: .9 .8 .7\n";
    let config = Config::parse(config.as_bytes()).expect("the configuration is valid");
    let text = format!("matte: m .5 .6 .7\nrefractive: g 1.5\n{objects}");
    let scene = Scene::parse(text.as_bytes()).expect("the scene is valid");
    on(&config, &scene, 1100, before, turn)
}

/// A stage on a board of matte, metal and refractive objects, seen from among them.
fn on_board(objects: usize, before: fn(&mut Stages<'static>), turn: fn(&mut Stages<'static>)) -> Box<dyn Work> {
    let options = Options { objects, arrangement: Arrangement::Grid, materials: [3.0, 2.0, 1.0], ..Options::default() };
    on(&generator::view(&options), &generator::scene(&options), 400, before, turn)
}

fn on(
    config: &Config,
    scene: &Scene,
    width: u64,
    before: fn(&mut Stages<'static>),
    turn: fn(&mut Stages<'static>),
) -> Box<dyn Work> {
    let config = Config { image_width: width, samples_per_pixel: 32, ..config.clone() };
    let prepared = Prepared::<Aos>::new(&config, scene, Scatter::Statement).expect("it can be rendered");
    let (row, column) = (prepared.size.height() * 5 / 8, prepared.size.width() / 2);
    // The process ends with the benchmark.
    let stages = Stages::new(Box::leak(Box::new(prepared)), InstructionSet::chosen(), row, column);
    Box::new(Stage { stages, before, turn })
}
