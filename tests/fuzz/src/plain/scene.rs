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
        let numbers = numbers.iter().map(|token| real(token)).collect::<Option<Vec<f64>>>();
        let thing = numbers.and_then(|numbers| thing(tag, &numbers)).ok_or_else(invalid)?;
        if values.len() > count {
            let (from, to) = (places[count + 1].0, places[places.len() - 1].1);
            let extra = &line[from..to];
            let start = [b"Extra data after configuration value for key: [", tag, b"]\nExtra: \"", extra].concat();
            return Err([&start[..], b"\"", &quoted].concat());
        }
        let known = names.iter().position(|known| *known == name);
        match (thing, known) {
            (Thing::Shape(_), None) => return Err([b"Material not found: [", name, b"]", &quoted[..]].concat()),
            (Thing::Shape(shape), Some(material)) => {
                scene.objects.push(Object { shape, material: material as MaterialId });
            }
            (Thing::Material(_), Some(_)) => {
                return Err([b"Material with name [", name, b"] already exists", &quoted[..]].concat());
            }
            (Thing::Material(material), None) => {
                names.push(name);
                scene.materials.push(material);
            }
        }
    }
    Ok(scene)
}

/// What a line defines.
enum Thing {
    Material(Material),
    Shape(Shape),
}

/// Returns what the tag and the numbers of a line define, or `None` if the numbers are invalid.
fn thing(tag: &[u8], numbers: &[f64]) -> Option<Thing> {
    let vector = |from: usize| Vec3::new(numbers[from], numbers[from + 1], numbers[from + 2]);
    let reflectance = || Some(vector(0)).filter(|it| it.to_array().iter().all(|channel| (0.0..=1.0).contains(channel)));
    let material = match (tag, numbers) {
        (b"matte:", _) => Material::Matte { reflectance: reflectance()? },
        (b"metal:", &[_, _, _, diffusion]) if diffusion >= 0.0 => {
            Material::Metal { reflectance: reflectance()?, diffusion }
        }
        (b"refractive:", &[index]) if index > 0.0 => Material::Refractive { index },
        (b"sphere:", &[_, _, _, radius]) if radius > 0.0 => {
            return Some(Thing::Shape(Shape::Sphere(Sphere { center: vector(0), radius })));
        }
        (b"cylinder:", &[_, _, _, radius, x, y, z]) if radius > 0.0 => {
            // The height is the length of the axis, which must be positive and finite.
            let height = (x * x + y * y + z * z).sqrt();
            let shape = Shape::Cylinder(Cylinder { center: vector(0), radius, axis: vector(4) });
            return (height > 0.0 && height < f64::INFINITY).then_some(Thing::Shape(shape));
        }
        _ => return None,
    };
    Some(Thing::Material(material))
}
