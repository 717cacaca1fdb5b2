//! Reads a scene of Mitsuba 3.

use std::collections::HashMap;
use std::path::Path;

use cpu::Vec3;
use cpu::internals::input::reader::read_text;
use cpu::internals::input::scene::MaterialId;
use roxmltree::{Document, Node};

use super::notes::{Fault, Place};
use super::plugin::{Param, Plugin, number, shown};
use super::sky::Layout;
use super::tokens::MAX_BYTES;
use super::transform::Transform;
use super::world::{Over, View, World};

/// The depth that takes the place of an unlimited one.
const UNLIMITED: u64 = 100;

/// The elements that are parameters.
const PARAMETERS: [&str; 9] =
    ["float", "integer", "boolean", "string", "rgb", "spectrum", "point", "vector", "texture"];

/// A file that is being read.
struct Reader<'a> {
    path: &'a Path,
    world: &'a mut World,
    /// The offsets of the ends of all lines.
    line_ends: Vec<usize>,
    defaults: HashMap<String, String>,
    materials: HashMap<String, MaterialId>,
}

/// Reads the file `path` into `world`.
///
/// # Errors
/// A fault of the file.
pub fn read(path: &Path, world: &mut World) -> Result<(), Fault> {
    world.notes.files.push(crate::terminal::name(path));
    world.inputs.push(path.to_owned());
    world.film = [768, 576];
    (world.config.samples_per_pixel, world.config.max_depth) = (4, UNLIMITED);
    let text = read_text(path, MAX_BYTES).map_err(|error| ((0, 1), format!("the file cannot be read: {error}")))?;
    // The crate refuses document types, so entities cannot expand.
    let document = Document::parse(&text).map_err(|error| {
        let text = match error {
            roxmltree::Error::DtdDetected => "a document type is not supported; remove <!DOCTYPE ...>".to_owned(),
            _ => format!("this is not correct XML ({error}); mend it with an editor that checks XML"),
        };
        ((0, error.pos().row as usize), text)
    })?;
    let line_ends = text.match_indices('\n').map(|(at, _)| at).collect();
    let mut reader = Reader { path, world, line_ends, defaults: HashMap::new(), materials: HashMap::new() };
    let root = document.root_element();
    if root.tag_name().name() != "scene" {
        return Err((reader.place(root), "the file is no scene of Mitsuba: its element must be <scene>".to_owned()));
    }
    // A material may stand below its use.
    let is_material = |node: &Node<'_, '_>| ["default", "bsdf"].contains(&node.tag_name().name());
    for node in root.children().filter(Node::is_element).filter(is_material) {
        reader.define(node)?;
    }
    for node in root.children().filter(Node::is_element).filter(|node| !is_material(node)) {
        reader.element(node)?;
    }
    Ok(())
}

impl Reader<'_> {
    fn place(&self, node: Node<'_, '_>) -> Place {
        (0, 1 + self.line_ends.partition_point(|&end| end < node.range().start))
    }

    /// Returns an attribute, in which each `$name` is replaced by the default of this name.
    fn attribute(&self, node: Node<'_, '_>, name: &str) -> Result<Option<String>, Fault> {
        let Some(text) = node.attribute(name) else { return Ok(None) };
        let mut parts = text.split('$');
        let mut replaced = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let is_end = |letter: char| !letter.is_alphanumeric() && letter != '_';
            let (name, after) = part.split_at(part.find(is_end).unwrap_or(part.len()));
            let value = self.defaults.get(name).ok_or_else(|| {
                let remedy = format!("add <default name=\"{name}\" value=\"...\"/> at the start of the scene");
                (self.place(node), format!("${name} has no value; {remedy}"))
            })?;
            replaced.extend([value, after]);
        }
        Ok(Some(replaced))
    }

    fn required(&self, node: Node<'_, '_>, name: &str) -> Result<String, Fault> {
        let missing = || (self.place(node), format!("<{}> needs the attribute {name}", node.tag_name().name()));
        self.attribute(node, name)?.ok_or_else(missing)
    }

    /// Returns the plugin of an element, with its parameters.
    fn plugin(&self, node: Node<'_, '_>) -> Result<Plugin, Fault> {
        let name = format!("{} {}", node.tag_name().name(), self.required(node, "type")?);
        let mut params = Vec::new();
        for child in node.children().filter(Node::is_element) {
            let kind = child.tag_name().name();
            if kind != "transform" && !PARAMETERS.contains(&kind) {
                continue;
            }
            let name = self.required(child, "name")?;
            let words = match kind {
                "transform" | "texture" => Vec::new(),
                "string" | "boolean" => vec![self.required(child, "value")?],
                _ => self.words(child)?,
            };
            params.push(Param { kind: kind.to_owned(), name, words, place: self.place(child) });
        }
        Ok(Plugin { name, params, place: self.place(node) })
    }

    /// Returns the numbers of the attribute `value`, or of `x`, `y` and `z` if it is missing.
    fn words(&self, node: Node<'_, '_>) -> Result<Vec<String>, Fault> {
        let names = ["x", "y", "z"];
        if node.has_attribute("value") || !names.iter().any(|name| node.has_attribute(*name)) {
            return self.split(node, "value");
        }
        let none = if node.has_tag_name("scale") { "1" } else { "0" };
        names.iter().map(|name| Ok(self.attribute(node, name)?.unwrap_or_else(|| none.to_owned()))).collect()
    }

    fn split(&self, node: Node<'_, '_>, name: &str) -> Result<Vec<String>, Fault> {
        let text = self.required(node, name)?;
        let words = text.split(|letter: char| letter == ',' || letter.is_whitespace());
        Ok(words.filter(|word| !word.is_empty()).map(str::to_owned).collect())
    }

    fn define(&mut self, node: Node<'_, '_>) -> Result<(), Fault> {
        if node.tag_name().name() == "default" {
            let (name, value) = (self.required(node, "name")?, self.required(node, "value")?);
            // Of several defaults of one name, the first counts.
            self.defaults.entry(name).or_insert(value);
            return Ok(());
        }
        let material = self.material(node)?;
        if let Some(id) = self.attribute(node, "id")? {
            self.materials.insert(id, material);
        }
        Ok(())
    }

    fn material(&mut self, mut node: Node<'_, '_>) -> Result<MaterialId, Fault> {
        // Our surfaces have two sides in any case.
        while self.required(node, "type")? == "twosided" {
            let inner = self.nested(node, &["bsdf"])?;
            if let Some(&second) = inner.get(1) {
                let text = "a second bsdf in a twosided one has no match; the first is on both sides";
                self.world.notes.add(self.place(second), text);
            }
            let first = inner.first().copied();
            node = first.ok_or_else(|| (self.place(node), "a twosided bsdf needs a bsdf inside".to_owned()))?;
        }
        let mut plugin = self.plugin(node)?;
        self.nested(node, &[])?;
        self.world.material(&mut plugin)
    }

    fn element(&mut self, node: Node<'_, '_>) -> Result<(), Fault> {
        let (word, place) = (node.tag_name().name(), self.place(node));
        if !["integrator", "sensor", "shape", "emitter"].contains(&word) {
            self.world.notes.add(place, format!("<{word}> has no match; left out"));
            return Ok(());
        }
        let (mut plugin, to_world) = (self.plugin(node)?, self.to_world(node)?);
        match (word, plugin.kind()) {
            ("integrator", _) => {
                self.world.known_by_parameters(&mut plugin);
                self.world.config.max_depth = match plugin.real("max_depth", -1.0)? {
                    -1.0 => {
                        self.world.notes.add(place, format!("an unlimited depth has no match; {UNLIMITED} is taken"));
                        UNLIMITED
                    }
                    _ => plugin.whole("max_depth", UNLIMITED, 1)?,
                };
            }
            ("sensor", _) if self.world.view.is_some() => {
                self.world.notes.add(place, "a sensor that is not the first has no match; left out");
            }
            ("sensor", _) => {
                self.world.known_by_parameters(&mut plugin);
                for child in self.nested(node, &["film", "sampler"])? {
                    let mut plugin = self.plugin(child)?;
                    self.world.known_by_parameters(&mut plugin);
                    if child.has_tag_name("film") {
                        self.world.film = [plugin.whole("width", 768, 1)?, plugin.whole("height", 576, 1)?];
                        for filter in self.nested(child, &["rfilter"])? {
                            let mut filter = self.plugin(filter)?;
                            self.world.known_by_parameters(&mut filter);
                        }
                    } else {
                        self.world.config.samples_per_pixel = plugin.whole("sample_count", 4, 1)?;
                    }
                }
                let over = match plugin.text("fov_axis").unwrap_or("x") {
                    "x" => Over::Width,
                    "y" => Over::Height,
                    "diagonal" => Over::Diagonal,
                    "smaller" => Over::Shorter,
                    "larger" => Over::Longer,
                    other => {
                        return Err((place, format!("[{other}] is no fov_axis; x, y, diagonal, smaller or larger is")));
                    }
                };
                // Without a field of view, Mitsuba takes that of a lens of 50 mm before a film that is 36 mm wide.
                let fov = plugin.real("fov", 2.0 * 0.36_f64.atan().to_degrees())?;
                self.world.view = Some(View { place, to_world, x_is_right: false, fov, over });
            }
            ("shape", _) => {
                let mut material = None;
                for child in self.nested(node, &["bsdf", "ref"])? {
                    let found =
                        if child.has_tag_name("bsdf") { Some(self.material(child)?) } else { self.reference(child)? };
                    // A reference to a medium leaves the material as it is.
                    material = found.or(material);
                }
                self.world.shape(&mut plugin, &to_world, material)?;
            }
            (_, "constant" | "envmap") => {
                self.world.known_by_parameters(&mut plugin);
                let picture = plugin.text("filename").map(|name| (self.path.with_file_name(name), Layout::Rows));
                let scale = plugin.real("scale", 1.0)?;
                self.world.sky(&plugin, "radiance", picture, (to_world.columns[1], scale))?;
            }
            _ => self.world.notes.add(place, format!("{} has no match; left out", plugin.name)),
        }
        Ok(())
    }

    /// Returns the elements in `node` with these names. Notes those that are no parameters either.
    fn nested<'a, 'b>(&mut self, node: Node<'a, 'b>, names: &[&str]) -> Result<Vec<Node<'a, 'b>>, Fault> {
        let mut found = Vec::new();
        for child in node.children().filter(Node::is_element) {
            let name = child.tag_name().name();
            if names.contains(&name) {
                found.push(child);
            } else if name != "transform" && !PARAMETERS.contains(&name) {
                let text = format!("<{name}> in <{}> has no match; left out", node.tag_name().name());
                self.world.notes.add(self.place(child), text);
            }
        }
        Ok(found)
    }

    fn reference(&mut self, node: Node<'_, '_>) -> Result<Option<MaterialId>, Fault> {
        let (id, place) = (self.required(node, "id")?, self.place(node));
        match self.materials.get(&id) {
            Some(&material) => Ok(Some(material)),
            // Media have names.
            None if node.has_attribute("name") => {
                self.world.notes.add(place, "a <ref> to something else than a bsdf has no match; left out");
                Ok(None)
            }
            None => Err((place, format!("no bsdf of the scene has the id [{}]; add one", shown(&id)))),
        }
    }

    /// Returns the transform of an element with the name `to_world`.
    fn to_world(&self, node: Node<'_, '_>) -> Result<Transform, Fault> {
        let mut all = Transform::IDENTITY;
        let is_it =
            |child: &Node<'_, '_>| child.has_tag_name("transform") && child.attribute("name") == Some("to_world");
        let steps = node.children().filter(is_it).flat_map(|child| child.children()).filter(Node::is_element);
        for (at, step) in steps.enumerate() {
            let place = self.place(step);
            let numbers = |words: Vec<String>| {
                let words = if words.len() == 1 { vec![words[0].clone(); 3] } else { words };
                words.iter().map(|word| number(word, place)).collect::<Result<Vec<_>, _>>()
            };
            let three = |numbers: Vec<f64>| {
                <[f64; 3]>::try_from(numbers).map_err(|_| (place, "three numbers are needed here".to_owned()))
            };
            let own = || numbers(self.words(step)?);
            let one = match step.tag_name().name() {
                "translate" => Transform::translate(three(own()?)?.into()),
                "scale" => Transform::scale(three(own()?)?),
                "rotate" => Transform::rotate(three(own()?)?.into(), number(&self.required(step, "angle")?, place)?),
                "lookat" => {
                    let point = |name| Ok(Vec3::from(three(numbers(self.split(step, name)?)?)?));
                    Transform::look_at([point("origin")?, point("target")?, point("up")?])
                }
                "matrix" => {
                    let rows = <[f64; 16]>::try_from(own()?).ok();
                    let matrix =
                        rows.and_then(|m| Transform::matrix(std::array::from_fn(|at| m[4 * (at % 4) + at / 4])));
                    matrix.ok_or((place, "a matrix has 16 numbers, and its last row is 0 0 0 1".to_owned()))?
                }
                other => return Err((place, format!("<{other}> is no translate, rotate, scale, lookat or matrix"))),
            };
            all = if at == 0 { one } else { one.then_inner(&all) };
        }
        Ok(all)
    }
}
