//! The scene file: materials and objects, one a line, to a checked [`Scene`] (statement, section 2.1.3; SPEC.md).

use std::collections::HashMap;
use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

use crate::config::color;
use crate::error::Error;
use crate::material::Material;
use crate::text::{self, Tokens};
use crate::vec3::Vec3;

/// Position of a material in [`Scene::materials`].
pub type MaterialId = u32;

/// A sphere as the file describes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its centre.
    pub center: Vec3,
    /// Its radius, positive.
    pub radius: f64,
}

/// A closed cylinder as the file describes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// The point halfway between the centres of its bases.
    pub center: Vec3,
    /// Its radius, positive.
    pub radius: f64,
    /// Its axis; the length, positive and finite, is the height.
    pub axis: Vec3,
}

/// The shape of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A sphere.
    Sphere(Sphere),
    /// A cylinder with its two bases.
    Cylinder(Cylinder),
}

/// A shape and what it is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object {
    /// Its shape and place.
    pub shape: Shape,
    /// Its material, an index into [`Scene::materials`].
    pub material: MaterialId,
}

/// Materials and objects in the order of the file, which decides between hits at the same distance.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// All materials, used or not.
    pub materials: Vec<Material>,
    /// All objects.
    pub objects: Vec<Object>,
}

/// Reads the scene line by line; keeps the names, which the finished scene does not need.
#[derive(Default)]
struct Parser {
    scene: Scene,
    names: HashMap<Vec<u8>, MaterialId>,
}

/// One kind of line: its tag, its name in messages, and how its parameters are read.
struct Entity {
    tag: &'static str,
    name: &'static str,
    read: fn(&mut Tokens<'_>) -> Option<Item>,
}

/// What a line describes.
enum Item {
    Material(Material),
    Shape(Shape),
}

const ENTITIES: [Entity; 5] = [
    Entity { tag: "sphere:", name: "sphere", read: |tokens| sphere(tokens).map(Item::Shape) },
    Entity { tag: "cylinder:", name: "cylinder", read: |tokens| cylinder(tokens).map(Item::Shape) },
    Entity { tag: "matte:", name: "matte material", read: |tokens| matte(tokens).map(Item::Material) },
    Entity { tag: "metal:", name: "metal material", read: |tokens| metal(tokens).map(Item::Material) },
    Entity { tag: "refractive:", name: "refractive material", read: |tokens| refractive(tokens).map(Item::Material) },
];

fn positive(tokens: &mut Tokens<'_>) -> Option<f64> {
    tokens.real().filter(|&value| value > 0.0)
}

fn sphere(tokens: &mut Tokens<'_>) -> Option<Shape> {
    Some(Shape::Sphere(Sphere { center: tokens.reals()?.into(), radius: positive(tokens)? }))
}

fn cylinder(tokens: &mut Tokens<'_>) -> Option<Shape> {
    let (center, radius, axis) = (tokens.reals()?.into(), positive(tokens)?, Vec3::from(tokens.reals()?));
    // The height is the axis' length: one that vanishes or overflows in f64 gives no direction either.
    let height = axis.length();
    (height > 0.0 && height.is_finite()).then_some(Shape::Cylinder(Cylinder { center, radius, axis }))
}

fn matte(tokens: &mut Tokens<'_>) -> Option<Material> {
    Some(Material::Matte { reflectance: color(tokens)? })
}

fn metal(tokens: &mut Tokens<'_>) -> Option<Material> {
    let (reflectance, diffusion) = (color(tokens)?, tokens.real()?);
    (diffusion >= 0.0).then_some(Material::Metal { reflectance, diffusion })
}

fn refractive(tokens: &mut Tokens<'_>) -> Option<Material> {
    Some(Material::Refractive { index: positive(tokens)? })
}

impl Parser {
    fn read_line(&mut self, line: &[u8]) -> Result<(), Error> {
        let mut tokens = Tokens::new(line);
        let Some(tag) = tokens.next() else { return Ok(()) };
        let Some(entity) = ENTITIES.iter().find(|entity| entity.tag.as_bytes() == tag) else {
            return Err(Error::UnknownEntity { name: tag.to_vec() });
        };
        let (name, item) = entity
            .read_named(&mut tokens)
            .ok_or_else(|| Error::InvalidParameters { entity: entity.name, line: line.to_vec() })?;
        if !tokens.rest().is_empty() {
            let extra = tokens.rest().to_vec();
            return Err(Error::ExtraParameters { tag: entity.tag, extra, line: line.to_vec() });
        }
        self.add(name, item, line)
    }

    fn add(&mut self, name: &[u8], item: Item, line: &[u8]) -> Result<(), Error> {
        let known = self.names.get(name).copied();
        match (item, known) {
            (Item::Material(_), Some(_)) => Err(Error::MaterialExists { name: name.to_vec(), line: line.to_vec() }),
            (Item::Material(material), None) => {
                let id = MaterialId::try_from(self.scene.materials.len())
                    .map_err(|_| Error::OutOfMemory { what: "the materials" })?;
                push(&mut self.scene.materials, material, "the materials")?;
                self.names.try_reserve(1).map_err(|_| Error::OutOfMemory { what: "the materials" })?;
                let mut owned = Vec::new();
                owned.try_reserve_exact(name.len()).map_err(|_| Error::OutOfMemory { what: "the materials" })?;
                owned.extend_from_slice(name);
                self.names.insert(owned, id);
                Ok(())
            }
            (Item::Shape(_), None) => Err(Error::MaterialNotFound { name: name.to_vec(), line: line.to_vec() }),
            (Item::Shape(shape), Some(material)) => {
                push(&mut self.scene.objects, Object { shape, material }, "the objects")
            }
        }
    }
}

impl Entity {
    /// The name on the line, first for a material and last for an object, and what the line describes.
    fn read_named<'a>(&self, tokens: &mut Tokens<'a>) -> Option<(&'a [u8], Item)> {
        let first = if self.name.ends_with("material") { Some(tokens.next()?) } else { None };
        let item = (self.read)(tokens)?;
        let name = match first {
            Some(name) => name,
            None => tokens.next()?,
        };
        Some((name, item))
    }
}

fn push<T>(list: &mut Vec<T>, item: T, what: &'static str) -> Result<(), Error> {
    list.try_reserve(1).map_err(|_| Error::OutOfMemory { what })?;
    list.push(item);
    Ok(())
}

impl Scene {
    /// The materials that objects are made of, each once.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn materials_in_use(&self) -> Result<Vec<Material>, Error> {
        let out_of_memory = |_| Error::OutOfMemory { what: "the materials" };
        let (mut in_use, mut materials) = (Vec::new(), Vec::new());
        in_use.try_reserve_exact(self.materials.len()).map_err(out_of_memory)?;
        materials.try_reserve_exact(self.materials.len()).map_err(out_of_memory)?;
        in_use.resize(self.materials.len(), false);
        self.objects.iter().for_each(|object| in_use[object.material as usize] = true);
        let used = self.materials.iter().zip(in_use).filter(|&(_, in_use)| in_use);
        materials.extend(used.map(|(&material, _)| material));
        Ok(materials)
    }

    /// Reads a scene.
    ///
    /// ```
    /// let text = "matte: grey .5 .5 .5\nsphere: 0 0 0 1 grey\n";
    /// let scene = cpu::Scene::parse(text.as_bytes())?;
    /// assert_eq!((scene.materials.len(), scene.objects.len()), (1, 1));
    /// # Ok::<(), cpu::Error>(())
    /// ```
    ///
    /// # Errors
    /// The first line that is wrong. On a line the parameters are checked first, then extra data, then names.
    pub fn parse(input: impl BufRead) -> Result<Self, Error> {
        let mut parser = Parser::default();
        text::for_each_line(input, |line| parser.read_line(line))?;
        Ok(parser.scene)
    }

    /// [`Scene::parse`] of a file.
    ///
    /// # Errors
    /// As [`Scene::parse`], and [`Error::Read`] with the file's name.
    pub fn read(path: &Path) -> Result<Self, Error> {
        File::open(path)
            .map_err(Error::from)
            .and_then(|file| Self::parse(BufReader::with_capacity(1 << 16, file)))
            .map_err(|error| error.in_file(path))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MATERIALS: &str = "matte: mat1 0 0.8 0.8\nmetal: metal1 0 0.8 0 2.0\nrefractive: ref99 1.3\n";

    fn parse(text: &str) -> Result<Scene, Error> {
        Scene::parse(text.as_bytes())
    }

    fn message(text: &str) -> String {
        parse(text).expect_err("the text is invalid").to_string()
    }

    #[test]
    fn the_statements_first_listing_is_read() {
        let scene = parse(&format!("{MATERIALS}sphere: 0 0 0 0.65 mat1\r\n\ncylinder:\t0 0 0 0.5 20 10 -5 metal1 "))
            .expect("the listing is valid");
        let reflectance = Vec3::new(0.0, 0.8, 0.8);
        assert_eq!(
            scene.materials,
            [
                Material::Matte { reflectance },
                Material::Metal { reflectance: Vec3::new(0.0, 0.8, 0.0), diffusion: 2.0 },
                Material::Refractive { index: 1.3 },
            ]
        );
        let sphere = Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 0.65 });
        let axis = Vec3::new(20.0, 10.0, -5.0);
        let cylinder = Shape::Cylinder(Cylinder { center: Vec3::ZERO, radius: 0.5, axis });
        let expected = [Object { shape: sphere, material: 0 }, Object { shape: cylinder, material: 1 }];
        assert_eq!(scene.objects, expected);
    }

    #[test]
    fn a_metal_may_be_without_diffusion() {
        let scene = parse("metal: m 0 .5 1 0").expect("nought is allowed");
        assert_eq!(scene.materials, [Material::Metal { reflectance: Vec3::new(0.0, 0.5, 1.0), diffusion: 0.0 }]);
    }

    #[test]
    fn materials_in_use_are_those_of_objects_each_once() {
        let scene = parse(&format!("{MATERIALS}sphere: 0 0 0 1 ref99\nsphere: 0 0 0 1 mat1\nsphere: 0 0 0 2 ref99\n"));
        let scene = scene.expect("the text is valid");
        let in_use = scene.materials_in_use().expect("two materials fit");
        assert_eq!(in_use, [scene.materials[0], scene.materials[2]]);
    }

    #[test]
    fn a_file_is_read_as_its_text_is() {
        let path = std::env::temp_dir().join(format!("render-scene-{}", std::process::id()));
        let text = format!("{MATERIALS}sphere: 0 0 0 1 mat1\n");
        std::fs::write(&path, &text).expect("the temporary folder is writable");
        let scene = Scene::read(&path);
        std::fs::remove_file(&path).expect("it is there");
        assert_eq!(scene.expect("the text is valid"), parse(&text).expect("the text is valid"));
    }

    #[test]
    fn an_empty_scene_is_a_scene() {
        assert_eq!(parse("").ok(), Some(Scene::default()));
        assert_eq!(parse(" \t \r\n\n").ok(), Some(Scene::default()));
    }

    #[test]
    fn unknown_entities_are_named_without_a_colon() {
        assert_eq!(message("triangle: 1 2 3"), "Unknown scene entity: triangle");
        assert_eq!(message("sphere 0 0 0 1 m"), "Unknown scene entity: sphere");
    }

    #[test]
    fn invalid_parameters_show_the_line_with_its_trailing_blanks() {
        let cases = [
            ("matte material", "matte: mat1 0 0.8 "),
            ("matte material", "matte:"),
            ("matte material", "matte: m 0 0.8 1.1"),
            ("metal material", "metal: m 0 0 0"),
            ("metal material", "metal: m 0 0 0 -1"),
            ("refractive material", "refractive: m 0"),
            ("refractive material", "refractive: m"),
            ("sphere", "sphere: 0 0 0 a mat1 3"),
            ("sphere", "sphere: 0 0 0 0 mat1"),
            ("sphere", "sphere: 0 0 0 1"),
            ("cylinder", "cylinder: 0 0 0 1 0 0 0 mat1"),
            ("cylinder", "cylinder: 0 0 0 -1 0 1 0 mat1"),
            ("cylinder", "cylinder: 0 0 0 1 1e200 0 0 mat1"),
            ("cylinder", "cylinder: 0 0 0 1 0 1 mat1"),
        ];
        for (entity, line) in cases {
            assert_eq!(message(line), format!("Invalid {entity} parameters\nLine: \"{line}\""));
        }
    }

    #[test]
    fn extra_data_comes_before_names() {
        let line = "sphere: 0 0 0 0.65 nowhere 3";
        let expected =
            format!("Extra data after configuration value for key: [sphere:]\nExtra: \"3\"\nLine: \"{line}\"");
        assert_eq!(message(line), expected);
        let line = "matte: mat1 0 0.8 0.8  4 5 ";
        let expected =
            format!("Extra data after configuration value for key: [matte:]\nExtra: \"4 5\"\nLine: \"{line}\"");
        assert_eq!(message(&format!("{MATERIALS}{line}")), expected);
    }

    #[test]
    fn names_must_be_new_for_materials_and_known_for_objects() {
        let line = "matte: mat1 0 0.8 0.8";
        let expected = format!("Material with name [mat1] already exists\nLine: \"{line}\"");
        assert_eq!(message(&format!("{MATERIALS}{line}")), expected);
        let line = "cylinder: 0 0 0 0.5 20 10 -5 metal12";
        let expected = format!("Material not found: [metal12]\nLine: \"{line}\"");
        assert_eq!(message(&format!("{MATERIALS}{line}")), expected);
    }

    #[test]
    fn any_bytes_may_be_a_name() {
        let scene = Scene::parse(&b"matte: \xff\0 0 0 0\nsphere: 0 0 0 1 \xff\0"[..]);
        assert_eq!(scene.map(|scene| scene.objects.len()).ok(), Some(1));
    }

    #[test]
    fn a_folder_is_not_a_scene() {
        let error = Scene::read(Path::new("/")).expect_err("a folder cannot be read");
        assert!(error.to_string().starts_with("Cannot read file [/]: "), "{error}");
    }
}
