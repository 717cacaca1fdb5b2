//! The scene file: materials and objects, one a line, to a checked [`Scene`] (specification, section 4).

use std::collections::HashMap;
use std::io::{BufRead, BufReader};
use std::path::Path;

use crate::input::config::color;
use crate::input::error::Error;
use crate::input::material::Material;
use crate::input::reader::Input;
use crate::input::text;
use crate::input::text::Tokens;
use crate::math::vec3::Vec3;

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
        Input::open(path, text::MAX_FILE_BYTES)
            .map_err(Error::from)
            .and_then(|input| Self::parse(BufReader::with_capacity(1 << 16, input)))
            .map_err(|error| error.in_file(path))
    }
}

#[cfg(test)]
mod tests;
