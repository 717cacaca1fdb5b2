//! The fuzz target `render`: converts any bytes to a tiny scene, and renders it with every layout and instruction set.
//!
//! The bytes choose between hard numbers (0, the smallest, the largest, nearly 1) and arbitrary ones. Every input gives
//! a valid scene and a valid configuration, so libFuzzer spends its time on geometry and not on grammar. After the last
//! byte, every choice is the first one.

use cpu::internals::input::scene::{Cylinder, MaterialId, Object, Shape, Sphere};
use cpu::{Config, Material, Scatter, Scene, Vec3};
use test_support::agreement::{SCATTERS, equals_reference};

/// Checks that both layouts give the bytes or the error of the reference, with every instruction set of this machine.
///
/// # Panics
/// If a result differs. The message has both input files.
pub fn check(bytes: &[u8]) {
    let mut choices = Choices::new(bytes);
    let scatter: Scatter = SCATTERS[choices.below(3)];
    // This choice is no longer used. It is still read, so that inputs of earlier runs give the same scenes.
    let _ = choices.below(2);
    let (config, scene) = (choices.config(), choices.scene());
    if let Err(difference) = equals_reference(&config, &scene, scatter) {
        panic!("{difference}");
    }
}

const BELOW_1: f64 = 1.0_f64.next_down();
const ABOVE_1: f64 = 1.0_f64.next_up();

/// Hard numbers: at or near them comparisons change, roundings matter, or operations overflow or underflow.
const HARD: [[f64; 7]; 4] = [
    [0.0, 1.0, -1.0, 0.5, 2.0, -0.0, 1e-3],
    [1e-8, -1e-8, BELOW_1, ABOVE_1, 3.0, -3.0, 10.0],
    [100.0, -1000.0, 1e6, 1e-6, 1e9, 1e16, -1e16],
    [1e100, 1e-100, 1e154, -1e200, f64::MIN_POSITIVE, 5e-324, f64::MAX],
];

/// Choices made by bytes. It holds the bytes that have not been used yet.
#[derive(Debug)]
pub struct Choices<'a>(&'a [u8]);

impl<'a> Choices<'a> {
    /// Returns the choices that the bytes `bytes` make.
    #[must_use]
    pub const fn new(bytes: &'a [u8]) -> Self {
        Self(bytes)
    }

    fn byte(&mut self) -> u8 {
        let Some((&byte, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        byte
    }

    /// Chooses a whole number from 0 to `count - 1`.
    pub fn below(&mut self, count: usize) -> usize {
        usize::from(self.byte()) % count
    }

    /// Chooses a finite number: one from -4 to 5, one of [`HARD`], one at most 128 floating-point steps away from one
    /// of [`HARD`], or any number.
    fn real(&mut self) -> f64 {
        let kind = self.byte();
        match kind % 8 {
            0..=3 => f64::from(kind / 8) / 4.0 - 4.0 + f64::from(self.byte()) / 256.0,
            4 | 5 => HARD.as_flattened()[usize::from(kind / 8) % 28],
            6 => {
                let number = HARD.as_flattened()[self.below(28)];
                let steps = i64::from(self.byte()) - 128;
                let moved = f64::from_bits(number.to_bits().saturating_add_signed(steps));
                if moved.is_finite() { moved } else { number }
            }
            _ => {
                let bits: [u8; 8] = std::array::from_fn(|_| self.byte());
                let number = f64::from_le_bytes(bits);
                if number.is_finite() { number } else { 1.0 }
            }
        }
    }

    fn vector(&mut self) -> Vec3 {
        Vec3::new(self.real(), self.real(), self.real())
    }

    /// Chooses a positive finite number.
    fn positive(&mut self) -> f64 {
        let number = self.real().abs();
        if number > 0.0 { number } else { 1.0 }
    }

    /// Chooses a number from 0 to 1.
    fn channel(&mut self) -> f64 {
        let number = self.real().abs();
        if number <= 1.0 { number } else { f64::from(self.byte()) / 255.0 }
    }

    fn color(&mut self) -> Vec3 {
        Vec3::new(self.channel(), self.channel(), self.channel())
    }

    /// Chooses a configuration whose picture has at most 5 x 10 pixels. Pictures are small, because with extreme
    /// numbers a ray may take milliseconds.
    pub fn config(&mut self) -> Config {
        let default = Config::default();
        let shape = self.byte();
        // In three of four configurations the camera looks at the origin, near which objects are likely.
        let view = self.byte();
        let free = view % 4 == 3;
        let camera_position = if free { self.vector() } else { Vec3::new(self.real() / 2.0, 0.5, -4.0) };
        let mut camera_target = if free { self.vector() } else { Vec3::ZERO };
        let camera_north = if free { self.vector() } else { default.camera_north };
        let mut fov = self.positive();
        // In some of the others the window is so near that camera rays are rounded to few directions.
        if free && view / 4 % 4 == 3 {
            let near = (camera_target - camera_position) * 10.0_f64.powi(-i32::from(self.byte() % 18));
            let moved = camera_position + near;
            camera_target = if moved.is_finite() { moved } else { camera_target };
            fov = if self.below(2) == 0 { 180.0_f64.next_down() } else { fov * 1e-6 };
        }
        Config {
            aspect_ratio: [1 + u64::from(shape % 3), 1 + u64::from(shape / 3 % 2)],
            image_width: 1 + u64::from(shape / 6) % 5,
            gamma: if self.below(2) == 0 { default.gamma } else { self.positive() },
            camera_position,
            camera_target,
            camera_north,
            field_of_view: if fov < 180.0 { fov.max(5e-324) } else { 60.0 },
            samples_per_pixel: 1 + self.below(2) as u64,
            max_depth: 1 + self.below(6) as u64,
            material_rng_seed: 1 + u64::from(self.byte()),
            ray_rng_seed: 1 + u64::from(self.byte()),
            background_dark_color: self.color(),
            background_light_color: self.color(),
        }
    }

    /// Chooses a scene with at most four materials and 16 objects.
    pub fn scene(&mut self) -> Scene {
        let materials: Vec<_> = (0..=self.below(4)).map(|_| self.material()).collect();
        let mut objects = Vec::new();
        while !self.0.is_empty() && objects.len() < 16 {
            objects.push(self.object(&objects, materials.len()));
        }
        Scene { materials, objects }
    }

    fn material(&mut self) -> Material {
        match self.below(3) {
            0 => Material::Matte { reflectance: self.color() },
            1 => Material::Metal { reflectance: self.color(), diffusion: self.real().abs() },
            _ => Material::Refractive { index: self.positive() },
        }
    }

    /// Chooses a new object, or a moved copy of the last object, because objects that touch or coincide are harder than
    /// others.
    fn object(&mut self, former: &[Object], materials: usize) -> Object {
        let kind = self.byte();
        let material = (usize::from(kind / 16) % materials) as MaterialId;
        let shape = match (kind % 4, former.last()) {
            (3, Some(last)) => self.moved(last.shape),
            (0 | 3, _) => Shape::Sphere(Sphere { center: self.vector(), radius: self.positive() }),
            _ => {
                let (center, radius) = (self.vector(), self.positive());
                let axis = if kind % 4 == 1 { self.vector() } else { Vec3::new(0.0, self.real(), 0.0) };
                let length = axis.length();
                let axis = if length > 0.0 && length.is_finite() { axis } else { Vec3::new(0.0, 1.0, 0.0) };
                Shape::Cylinder(Cylinder { center, radius, axis })
            }
        };
        Object { shape, material }
    }

    fn moved(&mut self, shape: Shape) -> Shape {
        let by = Vec3::new(0.0, self.real(), 0.0);
        let finite = |center: Vec3| if (center + by).is_finite() { center + by } else { center };
        match shape {
            Shape::Sphere(sphere) => Shape::Sphere(Sphere { center: finite(sphere.center), ..sphere }),
            Shape::Cylinder(cylinder) => {
                Shape::Cylinder(Cylinder { center: finite(cylinder.center), radius: self.positive(), ..cylinder })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use cpu::internals::sampling::uniform::Uniform;

    use super::*;
    use test_support::mutate::below;

    #[test]
    fn every_choice_is_a_valid_pair_of_files_and_many_have_objects() {
        let mut random = Uniform::new(1);
        let mut objects = 0;
        for length in 0..400 {
            let bytes: Vec<u8> = (0..length).map(|_| below(&mut random, 256) as u8).collect();
            let mut choices = Choices::new(&bytes);
            let (config, scene) = (choices.config(), choices.scene());
            let (config_text, scene_text) = (generator::write::config(&config), generator::write::scene(&scene));
            assert_eq!(Config::parse(config_text.as_bytes()).ok(), Some(config), "{config_text}");
            objects += scene.objects.len();
            assert_eq!(Scene::parse(scene_text.as_bytes()).ok(), Some(scene), "{scene_text}");
        }
        assert!(objects > 1000, "{objects} objects");
    }
}
