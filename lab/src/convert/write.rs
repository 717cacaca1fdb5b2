//! Writes our scene in the formats of pbrt-v4 and Mitsuba 3.

use cpu::internals::input::material::Material::{Matte, Metal, Refractive};
use cpu::internals::input::scene::Shape;
use cpu::{Config, Scene, Size, Vec3};
use generator::write::{real, vector};

use super::matches::{CONDUCTOR, GLASS, MATTE, ROUGH, SIDE};
use super::notes::Notes;
use super::transform::Transform;

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

/// Returns the scene in the format of pbrt-v4.
pub fn pbrt(source: &Source<'_>) -> String {
    let (config, [width, height]) = (source.config, [source.size.width(), source.size.height()]);
    // pbrt counts the surfaces of a path, and ours counts its rays. Its fov is that of the shorter side, unless there
    // is a window. It shows +x at the right for a view along +z with +y up, and ours shows it at the left.
    let side = real(width as f64 / height as f64);
    let window = if width < height { format!(r#" "float screenwindow" [-{side} {side} -1 1]"#) } else { String::new() };
    let mut out = format!(
        r#"Film "rgb" "integer xresolution" {width} "integer yresolution" {height}
Sampler "independent" "integer pixelsamples" {}
Integrator "path" "integer maxdepth" {}
PixelFilter "box" "float xradius" 0.5 "float yradius" 0.5
Scale -1 1 1
LookAt {}
Camera "perspective" "float fov" {}{window}
WorldBegin
"#,
        config.samples_per_pixel,
        config.max_depth - 1,
        [config.camera_position, config.camera_target, config.camera_north].map(vector).join("  "),
        real(config.field_of_view),
    );
    out += &match source.sky {
        Some(name) => format!(
            "AttributeBegin Rotate -90 1 0 0\n  LightSource \"infinite\" \"string filename\" \"{name}\"\nAttributeEnd\n"
        ),
        None => format!("LightSource \"infinite\" \"rgb L\" [{}]\n", vector(config.background_dark_color)),
    };
    for (id, material) in source.scene.materials.iter().enumerate() {
        let rgb = vector(material.reflectance());
        let kind = match *material {
            Matte { .. } => format!(r#""diffuse" "rgb reflectance" [{rgb}]"#),
            Refractive { index } => format!(r#""dielectric" "float eta" {}"#, real(index)),
            Metal { diffusion: 0.0, .. } => format!(r#""conductor" "rgb reflectance" [{rgb}]"#),
            Metal { diffusion, .. } => {
                let rough = real(diffusion / 2.0);
                format!(
                    r#""conductor" "rgb reflectance" [{rgb}] "float roughness" {rough} "bool remaproughness" false"#
                )
            }
        };
        out += &format!("MakeNamedMaterial \"m{id}\" \"string type\" {kind}\n");
    }
    for object in &source.scene.objects {
        let shapes = match object.shape {
            Shape::Sphere(sphere) => {
                let (center, radius) = (vector(sphere.center), real(sphere.radius));
                format!(r#"Translate {center} Shape "sphere" "float radius" {radius}"#)
            }
            Shape::Cylinder(cylinder) => {
                let Transform { columns: [x, y, z], origin, .. } = Transform::along(cylinder.axis, cylinder.center);
                let [x, y, z, origin] = [x, y, z, origin].map(vector);
                let radius = format!(r#""float radius" {}"#, real(cylinder.radius));
                format!(
                    r#"Transform [{x} 0  {y} 0  {z} 0  {origin} 1]
  Shape "cylinder" {radius} "float zmin" -0.5 "float zmax" 0.5
  Shape "disk" {radius} "float height" 0.5
  ReverseOrientation Shape "disk" {radius} "float height" -0.5"#
                )
            }
        };
        out += &format!("AttributeBegin NamedMaterial \"m{}\" {shapes} AttributeEnd\n", object.material);
    }
    out
}

/// Returns the scene in the format of Mitsuba 3.
pub fn mitsuba(source: &Source<'_>) -> String {
    let (config, [width, height]) = (source.config, [source.size.width(), source.size.height()]);
    let float = |name: &str, value: f64| format!(r#"<float name="{name}" value="{}"/>"#, real(value));
    let rgb = |name: &str, value: Vec3| format!(r#"<rgb name="{name}" value="{}"/>"#, vector(value));
    let [origin, target, up] = [config.camera_position, config.camera_target, config.camera_north].map(vector);
    let sky = match source.sky {
        Some(name) => format!(r#"<emitter type="envmap"><string name="filename" value="{name}"/></emitter>"#),
        None => format!(r#"<emitter type="constant">{}</emitter>"#, rgb("radiance", config.background_dark_color)),
    };
    // With roulette, Mitsuba would end paths earlier, with more noise.
    let mut out = format!(
        r#"<scene version="3.0.0">
<integrator type="path">
  <integer name="max_depth" value="{}"/><integer name="rr_depth" value="1000000000"/>
</integrator>
<sensor type="perspective">
  {}<string name="fov_axis" value="y"/>
  <float name="near_clip" value="0.001"/><float name="far_clip" value="1e9"/>
  <transform name="to_world"><lookat origin="{origin}" target="{target}" up="{up}"/></transform>
  <sampler type="independent"><integer name="sample_count" value="{}"/></sampler>
  <film type="hdrfilm">
    <integer name="width" value="{width}"/><integer name="height" value="{height}"/><rfilter type="box"/>
  </film>
</sensor>
{sky}
"#,
        config.max_depth,
        float("fov", config.field_of_view),
        config.samples_per_pixel,
    );
    for (id, material) in source.scene.materials.iter().enumerate() {
        let mirror =
            || rgb("specular_reflectance", material.reflectance()) + r#"<string name="material" value="none"/>"#;
        let (kind, params) = match *material {
            Matte { reflectance } => ("diffuse", rgb("reflectance", reflectance)),
            Refractive { index } => ("dielectric", float("int_ior", index) + &float("ext_ior", 1.0)),
            Metal { diffusion: 0.0, .. } => ("conductor", mirror()),
            Metal { diffusion, .. } => ("roughconductor", float("alpha", diffusion / 2.0) + &mirror()),
        };
        // Our opaque surfaces have two sides, and Mitsuba's have one.
        out += &match material {
            Refractive { .. } => format!("<bsdf type=\"{kind}\" id=\"m{id}\">{params}</bsdf>\n"),
            _ => format!("<bsdf type=\"twosided\" id=\"m{id}\"><bsdf type=\"{kind}\">{params}</bsdf></bsdf>\n"),
        };
    }
    for object in &source.scene.objects {
        let mut shape = |kind: &str, params: &str| {
            out += &format!("<shape type=\"{kind}\">{params}<ref id=\"m{}\"/></shape>\n", object.material);
        };
        match object.shape {
            Shape::Sphere(sphere) => {
                let center = format!(r#"<point name="center" value="{}"/>"#, vector(sphere.center));
                shape("sphere", &(center + &float("radius", sphere.radius)));
            }
            Shape::Cylinder(cylinder) => {
                let Transform { columns: [x, y, z], origin, .. } = Transform::along(cylinder.axis, cylinder.center);
                let row = |of: fn(Vec3) -> f64| [x, y, z, origin].map(|column| real(of(column))).join(" ");
                let rows = [row(|v| v.x), row(|v| v.y), row(|v| v.z)].join("  ");
                let placed = |steps: &str| {
                    format!(r#"<transform name="to_world">{steps}<matrix value="{rows}  0 0 0 1"/></transform>"#)
                };
                let ends = r#"<point name="p0" value="0 0 -0.5"/><point name="p1" value="0 0 0.5"/>"#;
                shape("cylinder", &(ends.to_owned() + &float("radius", cylinder.radius) + &placed("")));
                let scale = format!(r#"<scale x="{0}" y="{0}"/>"#, real(cylinder.radius));
                shape("disk", &placed(&format!(r#"{scale}<translate z="0.5"/>"#)));
                shape("disk", &placed(&format!(r#"{scale}<rotate x="1" angle="180"/><translate z="-0.5"/>"#)));
            }
        }
    }
    out + "</scene>\n"
}
