//! Converts scenes and configurations to text that reads back as equal values.

use std::fmt::Write;

use cpu::internals::input::scene::Shape;
use cpu::{Config, Material, Scene, Vec3};

/// Returns the text of the scene file of `scene`: its materials, named `m0`, `m1` and so on, and then its objects.
///
/// ```
/// let scene = cpu::internals::input::scene::Scene::parse(&b"matte: grey .5 .5 .5\nsphere: 0 0 0 1e-7 grey\n"[..])?;
/// assert_eq!(generator::write::scene(&scene), "matte: m0 0.5 0.5 0.5\nsphere: 0 0 0 1e-7 m0\n");
/// # Ok::<(), cpu::Error>(())
/// ```
#[must_use]
pub fn scene(scene: &Scene) -> String {
    let mut text = String::new();
    for (id, material) in scene.materials.iter().enumerate() {
        match *material {
            Material::Matte { reflectance } => line(&mut text, format_args!("matte: m{id} {}", vector(reflectance))),
            Material::Metal { reflectance, diffusion } => {
                line(&mut text, format_args!("metal: m{id} {} {}", vector(reflectance), real(diffusion)));
            }
            Material::Refractive { index } => line(&mut text, format_args!("refractive: m{id} {}", real(index))),
        }
    }
    for object in &scene.objects {
        let id = object.material;
        match object.shape {
            Shape::Sphere(shape) => {
                line(&mut text, format_args!("sphere: {} {} m{id}", vector(shape.center), real(shape.radius)));
            }
            Shape::Cylinder(shape) => {
                let (center, radius, axis) = (vector(shape.center), real(shape.radius), vector(shape.axis));
                line(&mut text, format_args!("cylinder: {center} {radius} {axis} m{id}"));
            }
        }
    }
    text
}

/// Returns the text of the configuration file of `config`, with every key.
#[must_use]
pub fn config(config: &Config) -> String {
    let [aspect_width, aspect_height] = config.aspect_ratio;
    [
        format!("aspect_ratio: {aspect_width} {aspect_height}\n"),
        format!("image_width: {}\n", config.image_width),
        format!("gamma: {}\n", real(config.gamma)),
        format!("camera_position: {}\n", vector(config.camera_position)),
        format!("camera_target: {}\n", vector(config.camera_target)),
        format!("camera_north: {}\n", vector(config.camera_north)),
        format!("field_of_view: {}\n", real(config.field_of_view)),
        format!("samples_per_pixel: {}\n", config.samples_per_pixel),
        format!("max_depth: {}\n", config.max_depth),
        format!("material_rng_seed: {}\n", config.material_rng_seed),
        format!("ray_rng_seed: {}\n", config.ray_rng_seed),
        format!("background_dark_color: {}\n", vector(config.background_dark_color)),
        format!("background_light_color: {}\n", vector(config.background_light_color)),
    ]
    .concat()
}

fn line(text: &mut String, content: std::fmt::Arguments<'_>) {
    writeln!(text, "{content}").expect("a string takes all text");
}

/// Returns the three numbers with blanks between them.
#[must_use]
pub fn vector(vector: Vec3) -> String {
    vector.to_array().map(real).join(" ")
}

/// Returns the shortest text that reads back as this number. Very large and very small numbers have an exponent.
#[must_use]
pub fn real(value: f64) -> String {
    let text = format!("{value:?}");
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}
