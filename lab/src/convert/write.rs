//! Writes our scene in the formats of pbrt-v4 and Mitsuba 3.

use cpu::internals::input::material::Material::{Matte, Metal, Refractive};
use cpu::internals::input::scene::{Cylinder, Object, Shape, Sphere};
use cpu::{Config, Material, Scene, Size, Vec3};
use generator::write::{real, vector};
use minijinja::{Value, context};

use super::notes::Notes;
use crate::template::filled;

const MATTE: &str = "matte and diffuse scatter by different rules; they agree with render --scatter published";
const ROUGH: &str = "diffusion and roughness blur by different rules; the diffusion is taken as 2 alpha";
const CONDUCTOR: &str = "metal and pbrt's conductor have the same colour only for light that falls straight on them";
const GLASS: &str = "refractive lets all light through, and dielectric reflects a part (Fresnel)";
const SIDE: &str = "the normal of our cylinder's side is as long as its radius; only a radius of 1 scatters as theirs";

/// What is written: the values, the size of the picture, and the name of the file with the picture of the sky, if the
/// sky is not of one colour.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The configuration.
    pub config: &'a Config,
    /// The scene.
    pub scene: &'a Scene,
    /// The size of the picture.
    pub size: Size,
    /// The picture of the sky.
    pub sky: Option<&'a str>,
}

/// Adds what the format cannot hold to `notes`, whose files 0 and 1 have the texts `texts`.
pub fn note(source: &Source<'_>, is_pbrt: bool, texts: [&str; 2], notes: &mut Notes) {
    /// Returns the lines that begin with one of `tags`.
    fn lines<'a>(text: &'a str, tags: &'a [&str]) -> impl Iterator<Item = usize> + 'a {
        let first = |line: &'a str| line.split_ascii_whitespace().next().unwrap_or_default();
        (1..).zip(text.lines()).filter(move |(_, line)| tags.contains(&first(line))).map(|(number, _)| number)
    }
    let default = Config::default();
    let seeds = |config: &Config| [config.material_rng_seed, config.ray_rng_seed];
    let lost = [
        (source.config.gamma != default.gamma, &["gamma:"][..], "gamma has no match; left out"),
        (
            seeds(source.config) != seeds(&default),
            &["material_rng_seed:", "ray_rng_seed:"],
            "seeds of random numbers have no match; left out",
        ),
    ];
    for (_, tags, text) in lost.into_iter().filter(|(is_lost, ..)| *is_lost) {
        lines(texts[0], tags).for_each(|line| notes.add((0, line), text));
    }
    for (material, line) in source.scene.materials.iter().zip(lines(texts[1], &["matte:", "metal:", "refractive:"])) {
        let differs = match *material {
            Matte { .. } => [Some(MATTE), None],
            Refractive { .. } => [Some(GLASS), None],
            Metal { diffusion, .. } => [is_pbrt.then_some(CONDUCTOR), (diffusion > 0.0).then_some(ROUGH)],
        };
        differs.into_iter().flatten().for_each(|text| notes.add((1, line), text));
    }
    let cylinders = source.scene.objects.iter().filter_map(|object| match object.shape {
        Shape::Cylinder(cylinder) => Some(cylinder),
        Shape::Sphere(_) => None,
    });
    for (_, line) in cylinders.zip(lines(texts[1], &["cylinder:"])).filter(|(cylinder, _)| cylinder.radius != 1.0) {
        notes.add((1, line), SIDE);
    }
}

/// Returns the scene in the format of pbrt-v4, or else in that of Mitsuba 3.
///
/// # Errors
/// The error of [`filled`].
pub fn text(source: &Source<'_>, is_pbrt: bool) -> Result<String, String> {
    let (config, [width, height]) = (source.config, [source.size.width(), source.size.height()]);
    let values = context! {
        width,
        height,
        side => real(width as f64 / height as f64),
        samples => config.samples_per_pixel,
        depth => config.max_depth,
        fov => real(config.field_of_view),
        position => vector(config.camera_position),
        target => vector(config.camera_target),
        north => vector(config.camera_north),
        background => vector(config.background_dark_color),
        sky => source.sky,
        materials => Value::from_iter(source.scene.materials.iter().map(material)),
        // The values of one object at a time are in memory.
        objects => Value::make_object_iterable(source.scene.objects.clone(), |all| Box::new(all.iter().map(object))),
    };
    let template =
        if is_pbrt { include_str!("../../templates/scene.pbrt") } else { include_str!("../../templates/scene.xml") };
    Ok(filled(template, values)? + "\n")
}

fn material(material: &Material) -> Value {
    let color = vector(material.reflectance());
    match *material {
        Matte { .. } => context! { kind => "matte", color },
        Refractive { index } => context! { kind => "refractive", index => real(index) },
        Metal { diffusion: 0.0, .. } => context! { kind => "mirror", color },
        Metal { diffusion, .. } => context! { kind => "metal", color, alpha => real(diffusion / 2.0) },
    }
}

fn object(&Object { shape, material }: &Object) -> Value {
    match shape {
        Shape::Sphere(Sphere { center, radius }) => {
            context! { kind => "sphere", material, center => vector(center), radius => real(radius) }
        }
        Shape::Cylinder(Cylinder { center, radius, axis }) => {
            let [x, y, z] = frame(axis);
            let row = |of: fn(Vec3) -> f64| [x, y, z, center].map(|column| real(of(column))).join(" ");
            let rows = [row(|v| v.x), row(|v| v.y), row(|v| v.z), "0 0 0 1".to_owned()].join("  ");
            let columns = format!("{} 0  {} 0  {} 0  {} 1", vector(x), vector(y), vector(z), vector(center));
            context! { kind => "cylinder", material, columns, rows, radius => real(radius) }
        }
    }
}

/// Returns the images of the three unit vectors by a transform that takes the z axis from -0.5 to 0.5 to the axis of a
/// cylinder, and x and y to unit vectors that are perpendicular to it.
fn frame(axis: Vec3) -> [Vec3; 3] {
    let unit = axis.unit_and_length().0;
    let other = if unit.x.abs() < 0.6 { Vec3::new(1.0, 0.0, 0.0) } else { Vec3::new(0.0, 1.0, 0.0) };
    let x = other.cross(unit).unit();
    [x, unit.cross(x), axis]
}
