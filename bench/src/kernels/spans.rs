//! Kernels of rendering: the stages of one span of 32 pixels with 32 samples each.

use cpu::internals::accel::choice::Accel;
use cpu::internals::render::camera_rays::TraceCameraRays;
use cpu::internals::render::span::{Span, spans_of_row};
use cpu::internals::render::span_state::SpanState;
use cpu::internals::render::specular_chains::TraceSpecularChains;
use cpu::internals::render::stages::{ColorPaths, DrawSamples, FindBytes};
use cpu::internals::render::trace_paths::TracePaths;
use cpu::internals::{InstructionSet, Limits, Prepared};
use cpu::{Aos, Config, Scatter, Scene};
use generator::{self, Arrangement, Options};

use super::{Kernel, Work};

/// A span of a picture, and the state of its rendering. Its stages are run one by one.
pub struct Stages {
    state: SpanState<'static, Aos>,
    set: InstructionSet,
    span: Span,
}

impl Stages {
    /// Returns the first span of `row` that begins at or after `column`, ready for its first stage.
    fn new(prepared: &'static Prepared<Aos>, row: usize, column: usize) -> Self {
        let mut spans = spans_of_row(prepared.size.width(), prepared.samples, Limits::default().samples);
        let span = spans.find(|span| span.first >= column).expect("the row is longer");
        let set = InstructionSet::chosen();
        let mut state = SpanState::new(prepared, set, &Limits::default()).expect("it fits");
        state.row = row;
        let mut stages = Self { state, set, span };
        stages.cull();
        stages
    }

    fn cull(&mut self) {
        let (prepared, row) = (self.state.prepared, self.state.row);
        self.state.candidates.begin_row(prepared, row);
        self.state.candidates.begin_span(prepared, row, &self.span);
    }

    /// Computes the bytes of the span's pixels without rays, as if no object reached the span. Returns the number of
    /// pixels whose bytes are known.
    fn background_pixels(&mut self) -> usize {
        let (mut done, mut known) = (0, 0);
        while done < self.span.width() {
            let to = self.set.run(FindBytes { state: &mut self.state, span: &self.span, done });
            known += to - done;
            done = to + 1;
        }
        known
    }

    fn draw(&mut self) {
        self.set.run(DrawSamples(&mut self.state, &self.span));
    }

    fn camera_rays(&mut self) {
        self.set.run(TraceCameraRays(&mut self.state));
    }

    fn specular_chains(&mut self) {
        self.set.run(TraceSpecularChains(&mut self.state));
    }

    fn paths(&mut self) {
        self.set.run(TracePaths(&mut self.state));
    }

    fn paths_of_filter(&mut self) {
        assert!(matches!(self.state.prepared.accel, Accel::FlatFilter(_)), "there are too many cylinders");
        self.paths();
    }

    fn path_ends(&mut self) {
        self.set.run(ColorPaths(&mut self.state));
    }

    /// Returns the number of samples in the specular queue, and the number in the path queue.
    fn queued(&self) -> (usize, usize) {
        (self.state.batch.specular.count, self.state.tracer.queue.count)
    }
}

/// Work of one stage. `before` runs the stages that must come before it, and `turn` runs the stage itself.
struct Stage {
    stages: Stages,
    before: fn(&mut Stages),
    turn: fn(&mut Stages),
}

impl Work for Stage {
    fn units(&self) -> u64 {
        self.stages.span.count as u64
    }
    fn prepare(&mut self) {
        (self.before)(&mut self.stages);
    }
    fn turn(&mut self) {
        (self.turn)(&mut self.stages);
    }
}

pub const KERNELS: &[Kernel] = &[
    Kernel {
        name: "background-pixels",
        new: || stage("", |_| (), |stages| assert_eq!(stages.background_pixels(), 32)),
    },
    Kernel { name: "cull-bvh", new: || on_grid(1000, |_| (), Stages::cull) },
    Kernel { name: "draw-samples", new: || stage("", |_| (), Stages::draw) },
    Kernel { name: "camera-rays-nothing", new: || stage("", Stages::draw, Stages::camera_rays) },
    Kernel { name: "camera-rays-sphere", new: || stage("sphere: 0 0 0 6 m\n", Stages::draw, Stages::camera_rays) },
    Kernel {
        name: "camera-rays-cylinder",
        new: || stage("cylinder: 0 0 0 6 1 12 0 m\n", Stages::draw, Stages::camera_rays),
    },
    Kernel { name: "specular-chains", new: || stage(TWO_SPHERES, specular, Stages::specular_chains) },
    Kernel { name: "paths-small-scene", new: || on_grid(6, queued_again, Stages::paths) },
    Kernel { name: "paths-flat-filter", new: || on_grid(36, queued_again, Stages::paths_of_filter) },
    Kernel { name: "paths-bvh", new: || on_grid(1000, queued_again, Stages::paths) },
    Kernel { name: "paths-large-bvh", new: || on_grid(30_000, queued_again, Stages::paths) },
    Kernel { name: "path-ends", new: || on_grid(60, traced, Stages::path_ends) },
];

/// A scene with two refractive spheres, one inside the other.
const TWO_SPHERES: &str = "sphere: 0 0 0 6 g\nsphere: 0 0 0 3 g\n";

/// Runs the stages up to the moment when all samples are in the specular queue.
fn specular(stages: &mut Stages) {
    stages.draw();
    stages.camera_rays();
    assert_eq!(stages.queued().0, stages.span.count);
}

/// Runs the stages up to the moment when most samples are in the path queue.
fn queued(stages: &mut Stages) {
    stages.draw();
    stages.camera_rays();
    stages.specular_chains();
    assert!(stages.queued().1 > stages.span.count / 2, "{:?}", stages.queued());
}

/// Ends the paths of the last turn. Then it runs the stages until most samples are in the path queue.
fn queued_again(stages: &mut Stages) {
    stages.path_ends();
    queued(stages);
}

/// Runs the stages until all paths have ended.
fn traced(stages: &mut Stages) {
    queued(stages);
    stages.paths();
}

/// Returns work of a stage on a picture of `objects`, which fill the picture if there are any. Their materials are
/// matte `m` or refractive `g`.
fn stage(objects: &str, before: fn(&mut Stages), turn: fn(&mut Stages)) -> Box<dyn Work> {
    let config = "field_of_view: 40\nbackground_dark_color: .2 .4 .8\nbackground_light_color: .9 .8 .7\n";
    let config = Config::parse(config.as_bytes()).expect("the configuration is valid");
    let text = format!("matte: m .5 .6 .7\nrefractive: g 1.5\n{objects}");
    let scene = Scene::parse(text.as_bytes()).expect("the scene is valid");
    make(&config, &scene, 1100, before, turn)
}

/// Returns work of a stage on a grid of matte, metal and refractive objects. The camera is among the objects.
fn on_grid(objects: usize, before: fn(&mut Stages), turn: fn(&mut Stages)) -> Box<dyn Work> {
    let options = Options { objects, arrangement: Arrangement::Grid, materials: [3.0, 2.0, 1.0], ..Options::default() };
    make(&generator::view(&options), &generator::scene(&options), 400, before, turn)
}

fn make(config: &Config, scene: &Scene, width: u64, before: fn(&mut Stages), turn: fn(&mut Stages)) -> Box<dyn Work> {
    let config = Config { image_width: width, samples_per_pixel: 32, ..config.clone() };
    let prepared = Prepared::<Aos>::new(&config, scene, Scatter::Statement).expect("it can be rendered");
    let (row, column) = (prepared.size.height() * 5 / 8, prepared.size.width() / 2);
    // Never freed: the process ends with the benchmark.
    let stages = Stages::new(Box::leak(Box::new(prepared)), row, column);
    Box::new(Stage { stages, before, turn })
}
