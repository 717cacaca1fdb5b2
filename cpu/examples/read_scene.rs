//! Reads a scene and lists its objects with their materials.
//!
//! `cargo run -p cpu --example read_scene scenes/materials/scene.txt`

use std::env;
use std::io::{Error, Write, stdout};
use std::path::PathBuf;
use std::process::ExitCode;

use cpu::{Material, Scene, Shape};

const USAGE: &str = "\
read_scene SCENE
Reads a scene and lists its objects with their materials.

Example:
  cargo run -p cpu --example read_scene scenes/materials/scene.txt";

fn main() -> ExitCode {
    if env::args_os().any(|argument| argument == "--help") {
        println!("{USAGE}");
        return ExitCode::SUCCESS;
    }
    match list() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("Error: {error}");
            ExitCode::from(2)
        }
    }
}

fn list() -> Result<(), Error> {
    let arguments: Vec<_> = env::args_os().skip(1).map(PathBuf::from).collect();
    let [path] = &arguments[..] else {
        return Err(Error::other("one argument is needed, the scene's file; see --help"));
    };
    // An error names the file, and what is wrong with which line.
    let scene = Scene::read(path).map_err(Error::other)?;
    let mut out = stdout().lock();
    writeln!(out, "{} materials, {} objects", scene.materials.len(), scene.objects.len())?;
    for object in &scene.objects {
        let shape = match object.shape {
            Shape::Sphere(sphere) => format!("sphere of radius {} at {:?}", sphere.radius, sphere.center.to_array()),
            Shape::Cylinder(cylinder) => {
                // The axis is as long as the cylinder is high.
                let [center, axis] = [cylinder.center, cylinder.axis].map(|vector| vector.to_array());
                format!("cylinder of radius {} at {center:?} along {axis:?}", cylinder.radius)
            }
        };
        // A scene that was read names only materials that it has.
        let material = match scene.materials[object.material as usize] {
            Material::Matte { reflectance } => format!("matte, reflects {:?}", reflectance.to_array()),
            Material::Metal { reflectance, diffusion } => {
                format!("metal, reflects {:?}, diffusion {diffusion}", reflectance.to_array())
            }
            Material::Refractive { index } => format!("refractive, index {index}"),
        };
        writeln!(out, "{shape}: {material}")?;
    }
    Ok(())
}
