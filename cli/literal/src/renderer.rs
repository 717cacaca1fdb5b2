//! The literal renderer: the statement as a program, with rules that can be broken.
//!
//! It renders as `cpu::reference` does, and takes the statement's steps one after the other. It has two uses:
//! [`crate::diagnose`] renders with deviations, and [`crate::explain`] has it tell its steps.

use std::collections::HashMap;

use cpu::internals::Camera;
use cpu::internals::input::error::push;
use cpu::{Config, Error, Material, Ray, Scatter, Scene, Size, Vec3};
use serde_json::{Value, json};

use crate::camera::{size, window};
use crate::develop::{Picture, bytes, share, written};
use crate::intersect::{Candidate, MISSED, PARTS, candidates, hit, outward};
use crate::random::Stream;
use crate::rules::Rules;
use crate::scatter::{Refraction, Scatterer};

/// The nearest hit of a ray.
#[derive(Clone, Copy, Debug)]
struct Hit {
    /// Place of the object in the scene.
    object: usize,
    /// Place of the part in [`PARTS`].
    part: usize,
    lambda: f64,
}

/// Most steps of a sample that are told. Between mirrors, a path may have any number of steps.
const MOST_EVENTS: usize = 100_000;

/// The literal renderer of one picture.
#[derive(Debug)]
pub struct Renderer<'a> {
    config: Config,
    scene: &'a Scene,
    rules: Rules,
    /// The size of the picture.
    pub size: Size,
    /// The window of the camera.
    pub camera: Camera,
    offsets: Stream,
    scatterer: Scatterer,
    /// The streams of materials that do not share one.
    own: HashMap<u32, Stream>,
    /// The steps of each sample, if the renderer is asked to tell them.
    pub told: Option<Vec<Vec<Value>>>,
}

impl<'a> Renderer<'a> {
    /// Returns the renderer that follows the statement, except for the deviations of `rules`.
    ///
    /// # Errors
    /// [`Error::Picture`] if the picture is too large.
    pub fn new(config: &Config, scene: &'a Scene, scatter: Scatter, rules: Rules) -> Result<Self, Error> {
        let mut config = config.clone();
        if rules.has("ignored") {
            let line = &format::CONFIG[rules.or("ignored", 0.0) as usize];
            config.set(format!("{} {}", line.tag, line.default).as_bytes())?;
        }
        let [width, height] = size(&config, &rules);
        let size = Size::new(width, height)?;
        let camera = window(&config, size, &rules);
        let stream = Stream::new(1, &rules);
        let scatterer = Scatterer::new(scatter, stream.clone());
        let own = HashMap::new();
        let mut renderer = Self { config, scene, rules, size, camera, offsets: stream, scatterer, own, told: None };
        renderer.seed(3, 0);
        Ok(renderer)
    }

    /// Seeds the generators of rays (`which` is 1), of materials (2) or both (3). With 4 more, `number` is added.
    fn seed(&mut self, which: u32, number: u64) {
        let rules = &self.rules;
        let mut seeds = [self.config.ray_rng_seed, self.config.material_rng_seed];
        if rules.has("seeds-swapped") {
            seeds.reverse();
        }
        for thing in [1, 2].into_iter().filter(|thing| which & thing != 0) {
            let seed = if rules.or("one-generator", 0.0) == 1.0 { seeds[0] } else { seeds[thing as usize - 1] };
            // A generator of C++ without a seed has the seed 5489.
            let seed = if rules.covers("unseeded", thing) { 5489 } else { seed };
            let stream = Stream::new(seed.wrapping_add(if which > 4 { number } else { 0 }), rules);
            *if thing == 1 { &mut self.offsets } else { &mut self.scatterer.stream } = stream;
        }
    }

    /// Seeds the generators again where the program does so.
    fn seed_again(&mut self, [row, column, sample]: [usize; 3]) {
        let (index, is_first) = (row * self.size.width() + column, column == 0 && sample == 0);
        let sample_index = index * self.samples() as usize + sample;
        let bands = self.rules.or("bands", 1.0);
        let rows = self.size.height().div_ceil(bands.abs() as usize);
        for (name, is_due, number) in [
            ("seed-row", is_first, row),
            ("seed-pixel", sample == 0, index),
            ("seed-sample", true, sample_index),
            ("bands", is_first && row % rows == 0, row / rows),
        ] {
            if is_due && self.rules.has(name) {
                let of_bands = if bands < 0.0 { 7.0 } else { 3.0 };
                let which = if name == "bands" { of_bands } else { self.rules.or(name, 0.0) };
                self.seed(which as u32, number as u64);
            }
        }
    }

    /// Returns the number of samples of a pixel.
    pub fn samples(&self) -> u64 {
        if self.scatterer.convention == Scatter::Deterministic { 1 } else { self.config.samples_per_pixel }
    }

    /// Renders the whole picture. It should be small: every sample is listed in memory.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub fn picture(&mut self) -> Result<Picture, Error> {
        let [width, height, samples] = [self.size.width(), self.size.height(), self.samples() as usize];
        let place = |index: usize| [index / samples / width, index / samples % width, index % samples];
        let mut order: Vec<_> = (0..width * height * samples).map(place).collect();
        order.sort_by_key(|&[row, column, sample]| {
            let sample = if self.rules.has("samples-outermost") { sample } else { 0 };
            let column = if self.rules.has("columns-first") { column } else { 0 };
            let row = if self.rules.has("rows-upwards") { height - row } else { 0 };
            [sample, column, row]
        });
        let mut sums = vec![Vec3::ZERO; width * height];
        for place in order {
            self.seed_again(place);
            let [row, column, _] = place;
            let sum = &mut sums[row * width + column];
            *sum = *sum + share(self.sample([row, column])?, &self.config, &self.rules);
        }
        let count = if self.rules.has("sum") { 1.0 } else { samples as f64 };
        let pixels = sums.iter().map(|&sum| bytes(sum / count, &self.config, &self.rules)).collect();
        Ok(written(Picture { width, height, pixels }, &self.rules))
    }

    /// Skips the random numbers of the first `rows` rows, in which the materials took `vectors` random vectors.
    pub fn skip(&mut self, rows: usize, vectors: u64) {
        if self.scatterer.convention != Scatter::Deterministic {
            let samples = (rows * self.size.width()) as u64 * self.samples();
            (0..2 * samples).for_each(|_| _ = self.offsets.draw(0.0, 1.0));
            for _ in 0..vectors {
                let _ = self.scatterer.vector(1.0, 1, &Rules::default());
                self.scatterer.draws.clear();
            }
        }
    }

    /// Traces all samples of the pixel in this row and column. Returns the mean colour.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub fn mean(&mut self, place: [usize; 2]) -> Result<Vec3, Error> {
        let mut sum = Vec3::ZERO;
        for _ in 0..self.samples() {
            sum = sum + self.sample(place)?;
        }
        Ok(sum / self.samples() as f64)
    }

    /// Tells a step, if the renderer is asked to.
    fn tell(&mut self, name: &str, values: impl FnOnce() -> Value) {
        let events = self.told.as_mut().and_then(|samples| samples.last_mut());
        if let Some(events) = events.filter(|events| events.len() < MOST_EVENTS) {
            let mut event = values();
            event["event"] = json!(name);
            events.push(event);
        }
    }

    /// Traces the next sample of the pixel in this row and column. Returns its colour.
    fn sample(&mut self, [row, column]: [usize; 2]) -> Result<Vec3, Error> {
        let rules = &self.rules;
        let half = rules.or("offset-half", 0.5);
        let stream = if rules.has("one-generator") { &mut self.scatterer.stream } else { &mut self.offsets };
        let place = stream.drawn;
        let [mut x, mut y] = [0.0; 2];
        let is_drawn = self.scatterer.convention != Scatter::Deterministic && !rules.has("no-offset");
        if is_drawn {
            x = stream.draw(-half, half);
            y = if rules.has("one-offset") { x } else { stream.draw(-half, half) };
            if rules.has("y-first") {
                (x, y) = (y, x);
            }
        }
        let half = rules.or("half", 0.0);
        let [right, down] = if rules.has("transposed") { [row, column] } else { [column, row] };
        let Camera { position, origin, delta_x, delta_y } = self.camera;
        let target = origin + delta_x * (right as f64 + half + x) + delta_y * (down as f64 + half + y);
        let direction = if rules.has("direction-q") { target } else { target - position };
        let direction = if rules.covers("unit-rays", 1) { direction.unit() } else { direction };
        self.told.iter_mut().for_each(|samples| samples.push(Vec::new()));
        let offset = if is_drawn { vec![x, y] } else { Vec::new() };
        self.tell("sample", || json!({"place": place, "offset": offset, "target": target.to_array()}));
        self.color(Ray { origin: position, direction })
    }

    /// Returns the colour that a ray contributes (statement, section 3.3).
    fn color(&mut self, mut ray: Ray) -> Result<Vec3, Error> {
        let mut reflectances = Vec::new();
        let depth = self.config.max_depth.saturating_add_signed(self.rules.or("depth", 0.0) as i64);
        let mut end = None;
        for left in (1..=depth).rev() {
            let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
            self.tell("ray", || json!({"depth": left, "origin": origin, "direction": direction}));
            let Some(hit) = self.nearest(&ray) else {
                end = Some(("background", self.background(ray.direction), json!(self.share_of_dark(ray.direction))));
                break;
            };
            let is_last = left == 1 && self.rules.has("last-draws");
            let Some(reflectance) = (!is_last).then(|| self.scatter(&mut ray, hit)).flatten() else {
                end = Some(("absorbed", Vec3::ZERO, Value::Null));
                break;
            };
            push(&mut reflectances, reflectance, "the surfaces of a path")?;
        }
        let (reason, end, m) = end.unwrap_or_else(|| {
            let colors = [Vec3::ZERO, self.background(ray.direction), Vec3::ONE];
            ("depth", colors[self.rules.or("end", 0.0) as usize], Value::Null)
        });
        let color = reflectances.into_iter().rev().fold(end, Vec3::attenuate);
        let (end, all) = (end.to_array(), color.to_array());
        self.tell("end", || json!({"reason": reason, "m": m, "end": end, "color": all}));
        Ok(color)
    }

    /// Makes `ray` the ray that is scattered at its hit. Returns the reflectance, or `None` if the surface absorbs it.
    fn scatter(&mut self, ray: &mut Ray, hit: Hit) -> Option<Vec3> {
        let (rules, scene) = (&self.rules, self.scene);
        let object = &scene.objects[hit.object];
        let material = &scene.materials[object.material as usize];
        let point = ray.origin + ray.direction * hit.lambda;
        let outward = outward(&object.shape, hit.part, point, rules);
        let is_front = ray.direction.dot(outward) < 0.0;
        let is_kept = rules.has("no-flip") || is_front != rules.has("flip");
        let normal = if is_kept { outward } else { -outward };
        let is_front = is_front || rules.or("no-flip", 0.0) == 2.0;
        let kind = match material {
            Material::Matte { .. } => 1,
            Material::Metal { .. } => 2,
            Material::Refractive { .. } => 4,
        };
        let keys = [None, Some(object.material), Some(kind), Some(hit.object as u32)];
        let key = keys[rules.or("own-generators", 0.0) as usize];
        if let Some(key) = key {
            let seed = self.config.material_rng_seed;
            let own = self.own.entry(key).or_insert_with(|| Stream::new(seed, rules));
            std::mem::swap(own, &mut self.scatterer.stream);
        }
        let place = self.scatterer.stream.drawn;
        let direction = self.scatterer.scatter(material, ray.direction, normal, is_front, rules);
        if let Some(own) = key.and_then(|key| self.own.get_mut(&key)) {
            std::mem::swap(own, &mut self.scatterer.stream);
        }
        let is_absorbed = kind == 2 && rules.has("absorbed") && direction.dot(normal) <= 0.0;
        let direction = if rules.covers("unit-rays", 2) { direction.unit() } else { direction };
        let reflectance = if rules.covers("unattenuated", kind) { Vec3::ONE } else { material.reflectance() };
        let origin = point + bias(normal, direction, rules);
        *ray = Ray { origin, direction };
        let (draws, vector) = (self.scatterer.draws.clone(), self.scatterer.last.to_array());
        let [half, extent] = self.scatterer.half_and_extent;
        let refraction = self.scatterer.refraction.map(|Refraction { index, ratio, cos, sin, reflects }| {
            json!({"index": index, "ratio": ratio, "cos": cos, "sin": sin, "product": ratio * sin, "reflects": reflects})
        });
        let values = || {
            json!({
                "object": hit.object + 1, "part": PARTS[hit.part], "lambda": hit.lambda,
                "point": point.to_array(), "normal": normal.to_array(), "front": is_front,
                "material": (["", "matte", "metal", "", "refractive"][kind as usize]), "refraction": refraction,
                "place": place, "draws": draws, "half": half, "extent": extent, "vector": vector,
                "direction": direction.to_array(),
                "reflectance": reflectance.to_array(),
            })
        };
        self.tell("hit", values);
        (!is_absorbed).then_some(reflectance)
    }

    /// Returns the nearest hit among all objects, in the order of the file (statement, section 3.4).
    fn nearest(&mut self, ray: &Ray) -> Option<Hit> {
        let mut nearest: Option<Hit> = None;
        for (index, object) in self.scene.objects.iter().enumerate() {
            let candidates = candidates(&object.shape, ray, &self.rules);
            for &Candidate { part, lambda, fault, reach } in candidates.iter().flatten() {
                // Of many objects, the line of a ray misses almost all.
                if fault != MISSED {
                    self.tell("candidate", || {
                        let part = PARTS[part];
                        let mut event = json!({"object": index + 1, "part": part, "lambda": lambda, "fault": fault});
                        if reach[0] > reach[1] {
                            event["reach"] = json!(reach);
                        }
                        event
                    });
                }
            }
            let Some((lambda, part)) = hit(&candidates, &self.rules) else { continue };
            let at_a_tie = [part < 2, true, false][self.rules.or("tie", 0.0) as usize];
            let is_nearer = nearest.is_none_or(|nearest| match self.rules.or("chosen", 0.0) {
                1.0 => true,
                2.0 => false,
                3.0 => lambda > nearest.lambda,
                _ => lambda < nearest.lambda || lambda == nearest.lambda && at_a_tie,
            });
            if is_nearer {
                nearest = Some(Hit { object: index, part, lambda });
            }
        }
        nearest
    }

    /// Returns the colour of the background in a direction (statement, section 3.6).
    fn background(&self, direction: Vec3) -> Vec3 {
        let m = self.share_of_dark(direction);
        let (light, dark) = (self.config.background_light_color, self.config.background_dark_color);
        let (light, dark) = if self.rules.has("sky-swapped") { (dark, light) } else { (light, dark) };
        light * (1.0 - m) + dark * m
    }

    /// Returns the share of the dark colour in the background, the statement's m.
    fn share_of_dark(&self, direction: Vec3) -> f64 {
        let y = if self.rules.has("sky-raw") { direction.y } else { direction.unit().y };
        [(y + 1.0) / 2.0, y, y.abs()][self.rules.or("sky", 0.0) as usize]
    }
}

/// Returns by how much the program moves the origin of a scattered ray.
fn bias(normal: Vec3, direction: Vec3, rules: &Rules) -> Vec3 {
    if !rules.has("bias") {
        return Vec3::ZERO;
    }
    let value = rules.or("bias", 0.0) as usize;
    let to_side = if direction.dot(normal) < 0.0 { -normal } else { normal };
    [normal, to_side, direction, direction.unit()][value / 4] * [1e-3, 1e-4, 1e-5, 1e-6][value % 4]
}
