//! Reads a scene line by line, according to the table in the specification, section 4.1. A linear search finds names.

use cpu::internals::input::scene::{Cylinder, MaterialId, Object, Shape, Sphere};
use cpu::{Material, Scene, Vec3};

use super::lines::{lines, real, tokens};

/// Returns the scene in the text of a file.
///
/// # Errors
/// The message of the first wrong line, without `Error: `.
pub fn parse(text: &[u8]) -> Result<Scene, Vec<u8>> {
    let mut scene = Scene::default();
    let mut names: Vec<&[u8]> = Vec::new();
    for line in lines(text) {
        let places = tokens(line);
        let Some(&(start, end)) = places.first() else { continue };
        let tag = &line[start..end];
        let values: Vec<&[u8]> = places[1..].iter().map(|&(start, end)| &line[start..end]).collect();
        let (entity, count): (&[u8], usize) = match tag {
            b"matte:" => (b"matte material", 4),
            b"metal:" => (b"metal material", 5),
            b"refractive:" => (b"refractive material", 2),
            b"sphere:" => (b"sphere", 5),
            b"cylinder:" => (b"cylinder", 8),
            _ => {
                let name = if tag.last() == Some(&b':') { &tag[..tag.len() - 1] } else { tag };
                return Err([b"Unknown scene entity: ", name].concat());
            }
        };
        let quoted = [b"\nLine: \"", line, b"\""].concat();
        let invalid = || [b"Invalid ", entity, b" parameters", &quoted[..]].concat();
        if values.len() < count {
            return Err(invalid());
        }
        let of_object = matches!(tag, b"sphere:" | b"cylinder:");
        // The name is the first value in the line of a material, and the last value in the line of an object.
        let (name, numbers) = match of_object {
            true => (values[count - 1], &values[..count - 1]),
            false => (values[0], &values[1..count]),
        };
        let Some(numbers) = numbers.iter().map(|token| real(token)).collect::<Option<Vec<f64>>>() else {
            return Err(invalid());
        };
        if !are_valid(tag, &numbers) {
            return Err(invalid());
        }
        if values.len() > count {
            let (from, to) = (places[count + 1].0, places[places.len() - 1].1);
            let extra = &line[from..to];
            let start = [b"Extra data after configuration value for key: [", tag, b"]\nExtra: \"", extra].concat();
            return Err([&start[..], b"\"", &quoted].concat());
        }
        let known = names.iter().position(|known| *known == name);
        match (of_object, known) {
            (true, None) => return Err([b"Material not found: [", name, b"]", &quoted[..]].concat()),
            (true, Some(material)) => {
                scene.objects.push(Object { shape: shape(&numbers), material: material as MaterialId });
            }
            (false, Some(_)) => {
                return Err([b"Material with name [", name, b"] already exists", &quoted[..]].concat());
            }
            (false, None) => {
                names.push(name);
                scene.materials.push(material(&numbers));
            }
        }
    }
    Ok(scene)
}

fn are_valid(tag: &[u8], numbers: &[f64]) -> bool {
    let colors = |colors: &[f64]| colors.iter().all(|channel| (0.0..=1.0).contains(channel));
    match tag {
        b"matte:" => colors(numbers),
        b"metal:" => colors(&numbers[..3]) && numbers[3] >= 0.0,
        b"refractive:" => numbers[0] > 0.0,
        b"sphere:" => numbers[3] > 0.0,
        // The height is the length of the axis, which must be positive and finite.
        _ => {
            let height = (numbers[4] * numbers[4] + numbers[5] * numbers[5] + numbers[6] * numbers[6]).sqrt();
            numbers[3] > 0.0 && height > 0.0 && height < f64::INFINITY
        }
    }
}

fn material(numbers: &[f64]) -> Material {
    match *numbers {
        [red, green, blue] => Material::Matte { reflectance: Vec3::new(red, green, blue) },
        [red, green, blue, diffusion] => Material::Metal { reflectance: Vec3::new(red, green, blue), diffusion },
        [index] => Material::Refractive { index },
        _ => panic!("no material has {} numbers", numbers.len()),
    }
}

fn shape(numbers: &[f64]) -> Shape {
    match *numbers {
        [x, y, z, radius] => Shape::Sphere(Sphere { center: Vec3::new(x, y, z), radius }),
        [x, y, z, radius, along_x, along_y, along_z] => {
            let (center, axis) = (Vec3::new(x, y, z), Vec3::new(along_x, along_y, along_z));
            Shape::Cylinder(Cylinder { center, radius, axis })
        }
        _ => panic!("no shape has {} numbers", numbers.len()),
    }
}
