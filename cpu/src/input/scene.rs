//! Parses the scene file into a checked [`Scene`] (specification, section 4). Each line is a material or an object.

use std::collections::HashMap;
use std::io::{self, BufRead};
use std::path::Path;

use crate::input::error::{Error, push, with_room};
use crate::input::text::{self, Tokens};
use crate::input::{config::color, material::Material, reader};
use crate::math::vec3::Vec3;

/// Largest length in bytes of the names of all materials together. The names are kept in memory while a scene is read.
/// Ten million names may have 26 bytes each.
pub const MAX_NAME_BYTES: usize = 1 << 28;

/// Position of a material in [`Scene::materials`].
pub type MaterialId = u32;

/// A sphere as the scene file describes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// The sphere's centre, in scene units.
    pub center: Vec3,
    /// The sphere's radius, in scene units, positive.
    pub radius: f64,
}

/// A closed cylinder as the scene file describes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// The point halfway between the centres of its caps.
    pub center: Vec3,
    /// The cylinder's radius, in scene units, positive.
    pub radius: f64,
    /// The cylinder's axis, towards the top cap. Its length, positive and finite, is the height of the cylinder.
    pub axis: Vec3,
}

/// The shape of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A sphere.
    Sphere(Sphere),
    /// A cylinder with its two caps.
    Cylinder(Cylinder),
}

/// An object of the scene: a shape and its material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object {
    /// The shape, with its place in the scene.
    pub shape: Shape,
    /// The material, an index into [`Scene::materials`].
    pub material: MaterialId,
}

/// Materials and objects in the order of the scene file, which decides [ties](crate::geometry::tie).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// All materials, also those that no object uses.
    pub materials: Vec<Material>,
    /// All objects.
    pub objects: Vec<Object>,
}

/// The scene that has been read so far, with the names of its materials. The finished scene does not need the names.
#[derive(Debug, Default)]
pub struct Parser {
    /// The materials and objects of the lines so far.
    pub scene: Scene,
    /// The place of each material in the scene, by its name.
    pub names: HashMap<Vec<u8>, MaterialId>,
    /// Length of all names in bytes.
    name_bytes: usize,
    /// Number of the line that was read last, from 1.
    pub line: u64,
}

/// A kind of line: the line's first token, the name in messages, and the function that reads the parameters.
struct Entity {
    tag: &'static str,
    name: &'static str,
    read: fn(&mut Tokens<'_>) -> Option<Element>,
}

/// The material or the shape that a line describes.
enum Element {
    Material(Material),
    Shape(Shape),
}

const ENTITIES: [Entity; 5] = [
    Entity { tag: "sphere:", name: "sphere", read: |tokens| sphere(tokens).map(Element::Shape) },
    Entity { tag: "cylinder:", name: "cylinder", read: |tokens| cylinder(tokens).map(Element::Shape) },
    Entity { tag: "matte:", name: "matte material", read: |tokens| matte(tokens).map(Element::Material) },
    Entity { tag: "metal:", name: "metal material", read: |tokens| metal(tokens).map(Element::Material) },
    Entity {
        tag: "refractive:",
        name: "refractive material",
        read: |tokens| refractive(tokens).map(Element::Material),
    },
];

/// Reads a number above 0.
fn positive(tokens: &mut Tokens<'_>) -> Option<f64> {
    tokens.real().filter(|&value| value > 0.0)
}

/// Reads centre and radius.
fn sphere(tokens: &mut Tokens<'_>) -> Option<Shape> {
    Some(Shape::Sphere(Sphere { center: tokens.reals()?.into(), radius: positive(tokens)? }))
}

/// Reads centre, radius and axis.
fn cylinder(tokens: &mut Tokens<'_>) -> Option<Shape> {
    let (center, radius, axis) = (tokens.reals()?.into(), positive(tokens)?, Vec3::from(tokens.reals()?));
    // The height is the length of the axis. If it vanishes or overflows in f64, the axis has no direction either.
    let height = axis.length();
    (height > 0.0 && height.is_finite()).then_some(Shape::Cylinder(Cylinder { center, radius, axis }))
}

/// Reads a reflectance.
fn matte(tokens: &mut Tokens<'_>) -> Option<Material> {
    Some(Material::Matte { reflectance: color(tokens)? })
}

/// Reads a reflectance and the diffusion.
fn metal(tokens: &mut Tokens<'_>) -> Option<Material> {
    let (reflectance, diffusion) = (color(tokens)?, tokens.real()?);
    (diffusion >= 0.0).then_some(Material::Metal { reflectance, diffusion })
}

/// Reads a refractive index.
fn refractive(tokens: &mut Tokens<'_>) -> Option<Material> {
    Some(Material::Refractive { index: positive(tokens)? })
}

impl Parser {
    /// Adds what `line`, a line of a scene file, describes. A blank line and an invalid one add nothing.
    ///
    /// # Errors
    /// The fault of the line, as in [`Scene::parse`].
    pub fn read_line(&mut self, line: &[u8]) -> Result<(), Error> {
        self.line += 1;
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

    /// Adds an item with its name to the scene: a material under its own name, an object under that of its material.
    fn add(&mut self, name: &[u8], item: Element, line: &[u8]) -> Result<(), Error> {
        let known = self.names.get(name).copied();
        match (item, known) {
            (Element::Material(_), Some(_)) => Err(Error::MaterialExists { name: name.to_vec(), line: line.to_vec() }),
            (Element::Material(material), None) => {
                self.name_bytes += name.len();
                if self.name_bytes > MAX_NAME_BYTES {
                    return Err(too_many_names(self.line).into());
                }
                // Names differ, and have at most 2^28 bytes together, so the number fits.
                debug_assert!(MaterialId::try_from(self.scene.materials.len()).is_ok());
                let id = self.scene.materials.len() as MaterialId;
                push(&mut self.scene.materials, material, "the materials")?;
                self.names.try_reserve(1).map_err(|_| Error::OutOfMemory { what: "the materials" })?;
                let mut owned = with_room(name.len(), "the materials")?;
                owned.extend_from_slice(name);
                self.names.insert(owned, id);
                Ok(())
            }
            (Element::Shape(_), None) => Err(Error::MaterialNotFound { name: name.to_vec(), line: line.to_vec() }),
            (Element::Shape(shape), Some(material)) => {
                push(&mut self.scene.objects, Object { shape, material }, "the objects")
            }
        }
    }
}

/// The error for names of more than [`MAX_NAME_BYTES`]. The line `line` has the first name beyond this limit.
fn too_many_names(line: u64) -> io::Error {
    let text = format!("line {line}: the names of all materials are longer than {MAX_NAME_BYTES} bytes; shorten them");
    io::Error::new(io::ErrorKind::InvalidData, text)
}

impl Entity {
    /// Reads a line after its tag. Returns the material's name on the line, and what the line describes. The name
    /// stands before the parameters of a material and after those of an object. `None` means that a token is missing or
    /// invalid.
    fn read_named<'a>(&self, tokens: &mut Tokens<'a>) -> Option<(&'a [u8], Element)> {
        let first = if self.name.ends_with("material") { Some(tokens.next()?) } else { None };
        let item = (self.read)(tokens)?;
        Some((first.or_else(|| tokens.next())?, item))
    }
}

impl Scene {
    /// Returns the materials that at least one object uses, each of them once.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub fn materials_in_use(&self) -> Result<Vec<Material>, Error> {
        let mut ids = with_room(self.objects.len(), "the materials")?;
        ids.extend(self.objects.iter().map(|object| object.material));
        ids.sort_unstable();
        ids.dedup();
        let mut materials = with_room(ids.len(), "the materials")?;
        materials.extend(ids.iter().map(|&id| self.materials[id as usize]));
        Ok(materials)
    }

    /// Reads the text of a scene file.
    ///
    /// ```
    /// let text = "matte: grey .5 .5 .5\nsphere: 0 0 0 1 grey\n";
    /// let scene = cpu::Scene::parse(text.as_bytes())?;
    /// assert_eq!((scene.materials.len(), scene.objects.len()), (1, 1));
    /// # Ok::<(), cpu::Error>(())
    /// ```
    ///
    /// # Errors
    /// The fault of the first invalid line. On a line, the parameters are checked first, then extra data, then names.
    /// [`Error::Input`] if `input` cannot be read or has more than [`MAX_NAME_BYTES`] in names, and
    /// [`Error::OutOfMemory`] if memory is short.
    pub fn parse(input: impl BufRead) -> Result<Self, Error> {
        let mut parser = Parser::default();
        text::for_each_line(input, |line| parser.read_line(line))?;
        Ok(parser.scene)
    }

    /// Reads the scene file at `path`, as [`Scene::parse`] does.
    ///
    /// # Errors
    /// Those of [`Scene::parse`], but [`Error::Read`] with the file's name if the file cannot be read.
    pub fn read(path: &Path) -> Result<Self, Error> {
        reader::parse(path, Self::parse)
    }
}

#[cfg(test)]
mod tests;
