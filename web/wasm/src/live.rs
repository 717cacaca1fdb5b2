//! The scene for the shaders of the page: its buffers, the same pictures by Rust, and the steps of a pixel's path.

use cpu::internals::render::background::Background;
use cpu::internals::{Camera, InstructionSet, Limits, Prepared, render_linear};
use cpu::{Aos, Config, Scatter, Scene, Vec3};
use serde::Serialize;
use twin::head::{Part, head};
use twin::hierarchy::{Hierarchy, WORTHWHILE};
use twin::packed::buffer;
use twin::picture::depth;
use twin::{Picture, features_of};

use crate::fault::Fault;
use crate::seen::{self, Seen};

/// The cost of a ray in the hierarchy of `scenes/ten-thousand` on SwiftShader, in tests of a ray against an object.
const COST_IN_HIERARCHY: usize = 1536;

/// The scene that the shaders show, and the same scene in the numbers of the shaders.
#[derive(Debug)]
pub struct Live {
    config: Config,
    scene: Scene,
    picture: Picture<f32>,
}

/// What the page needs besides the buffers.
#[derive(Serialize)]
struct Facts {
    width: usize,
    height: usize,
    gamma: f64,
    depth: u32,
    /// The cost of a ray in tests of a ray against an object.
    tests: usize,
    position: [f64; 3],
    target: [f64; 3],
    north: [f64; 3],
    /// The constants of `shaders/wgsl/features.wgsl`.
    constants: Vec<(&'static str, f64)>,
    /// For each object: its kind, its centre, its radius and the axis of a cylinder.
    shapes: Vec<(&'static str, [f64; 3], f64, [f64; 3])>,
}

/// Returns a fault for an error of the scene's form for a device, which is about the configuration.
fn fault_of(error: twin::Error) -> Fault {
    match error {
        twin::Error::Scene(error) => Fault::without_line(error, 0),
        error @ twin::Error::TooDeep { .. } => {
            Fault::own(error.to_string(), "max_depth es demasiado grande para un dispositivo; elija uno menor", 0)
        }
    }
}

impl Live {
    /// Returns the scene as a picture of the shaders.
    ///
    /// # Errors
    /// A scene that the shaders cannot show.
    pub fn new(config: Config, scene: Scene) -> Result<Self, Fault> {
        let picture = Picture::new(&config, &scene).map_err(fault_of)?;
        Ok(Self { config, scene, picture })
    }

    /// Takes another configuration, and keeps the scene. It is fast for every scene, so a page calls it for each
    /// movement of the camera.
    ///
    /// # Errors
    /// A picture or a camera that is impossible.
    pub fn aim(&mut self, config: Config) -> Result<(), Fault> {
        let size = config.image_size().map_err(|error| Fault::without_line(error.into(), 0))?;
        let camera = Camera::new(&config, size).map_err(|error| Fault::without_line(error.into(), 0))?;
        self.picture.max_depth = depth(&config).map_err(fault_of)?;
        self.picture.size = size;
        self.picture.camera = camera.lanes();
        self.picture.background = Background::new(&config).lanes();
        self.config = config;
        Ok(())
    }

    /// Returns the bytes of a buffer of `shaders/wgsl/picture.wgsl`. `part` is its binding. For 8 it is the hierarchy
    /// of `shaders/wgsl/hierarchy.wgsl`, which is empty for a scene of few objects. Other parts are empty.
    pub fn packed(&self, part: u32) -> Vec<u8> {
        let pixels = Part::Pixels { first: 0, count: self.picture.size.pixels() as u32 };
        match part {
            0 => head(&self.picture, &pixels, &(0..self.picture.max_depth)),
            1 => buffer(&self.picture.spheres),
            2 => buffer(&self.picture.cylinders),
            3 => buffer(&self.picture.materials),
            8 if self.scene.objects.len() >= WORTHWHILE => Hierarchy::new(&self.picture).bytes(),
            _ => Vec::new(),
        }
    }

    /// Returns the facts as JSON.
    ///
    /// # Errors
    /// A maximum depth that is too large.
    pub fn facts(&self) -> Result<Vec<u8>, Fault> {
        let Self { config, scene, picture } = self;
        let features = features_of(config, scene).map_err(fault_of)?;
        let spheres = picture.spheres.iter().map(|placed| {
            let record = &placed.record;
            ("sphere", wide(record.center), f64::from(record.radius), [0.0; 3])
        });
        let cylinders = picture.cylinders.iter().map(|placed| {
            let record = &placed.record;
            let axis = wide(record.axis).map(|component| component * f64::from(record.half_height));
            ("cylinder", wide(record.center), f64::from(record.radius), axis)
        });
        let facts = Facts {
            width: picture.size.width(),
            height: picture.size.height(),
            gamma: config.gamma,
            depth: picture.max_depth,
            tests: scene.objects.len().min(COST_IN_HIERARCHY),
            position: config.camera_position.to_array(),
            target: config.camera_target.to_array(),
            north: config.camera_north.to_array(),
            constants: features.constants().to_vec(),
            shapes: spheres.chain(cylinders).collect(),
        };
        serde_json::to_vec(&facts).map_err(|error| Fault::own(error.to_string(), "", 2))
    }

    /// Returns a picture in deterministic mode as the bytes of f64: for `kind` 0 the linear colours by the exact
    /// renderer, for 1 those by the twin of the shaders in f32, and for 2 what the exact rays hit.
    ///
    /// # Errors
    /// Too little memory.
    pub fn truth(&self, kind: u32) -> Result<Vec<u8>, Fault> {
        let mut bytes = Vec::new();
        let size =
            self.picture.size.pixels().saturating_mul(if kind == 2 { size_of::<Seen>() } else { size_of::<Vec3>() });
        let short = || Fault::without_line(cpu::Error::OutOfMemory { what: "the colours of the picture" }, 2);
        bytes.try_reserve_exact(size).map_err(|_| short())?;
        let mut add = |numbers: &[f64]| numbers.iter().for_each(|number| bytes.extend(number.to_le_bytes()));
        if kind == 1 {
            let color = |index| self.picture.color(index).map(f64::from).to_array();
            (0..self.picture.size.pixels()).for_each(|index| add(&color(index)));
            return Ok(bytes);
        }
        let prepared = Prepared::<Aos>::new(&self.config, &self.scene, Scatter::Deterministic);
        let prepared = prepared.map_err(|error| Fault::without_line(error, 0))?;
        if kind == 2 {
            seen::each(&prepared, |seen| add(&seen));
        } else {
            render_linear(&prepared, InstructionSet::best(), &Limits::default(), |_, mean| add(&mean.to_array()))
                .map_err(|error| Fault::without_line(error, 2))?;
        }
        Ok(bytes)
    }

    /// Returns the steps of the path of the pixel at `index`, by the twin in f32, as the bytes of f32. Without such a
    /// pixel there are no steps.
    pub fn steps(&self, index: usize) -> Vec<u8> {
        let exists = index < self.picture.size.pixels();
        let steps = if exists { self.picture.steps(index) } else { Vec::new() };
        steps.iter().flat_map(|step| step.0).flat_map(f32::to_le_bytes).collect()
    }
}

fn wide(vector: Vec3<f32>) -> [f64; 3] {
    vector.to_array().map(f64::from)
}
