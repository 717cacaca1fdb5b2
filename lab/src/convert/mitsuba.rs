//! Reads a scene of Mitsuba 3.

mod values;

use std::collections::HashMap;
use std::path::Path;

use cpu::internals::input::reader::read_text;
use cpu::internals::input::scene::MaterialId;
use roxmltree::{Document, Node};

use super::notes::Fault;
use super::plugin::shown;
use super::sky::Layout;
use super::tokens::MAX_BYTES;
use super::world::{View, World};
use values::is_parameter;

/// The depth that takes the place of an unlimited one.
const UNLIMITED: u64 = 100;

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
    let read = reader.nested(root, &["default", "bsdf", "integrator", "sensor", "shape", "emitter"]);
    // A material may stand below its use.
    let is_defined = |node: &Node<'_, '_>| ["default", "bsdf"].contains(&node.tag_name().name());
    read.iter().filter(|node| is_defined(node)).try_for_each(|&node| reader.define(node))?;
    read.iter().filter(|node| !is_defined(node)).try_for_each(|&node| reader.element(node))
}

impl Reader<'_> {
    fn define(&mut self, node: Node<'_, '_>) -> Result<(), Fault> {
        if node.has_tag_name("default") {
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
            let inner = self.nested(node, &["bsdf"]);
            if let Some(&second) = inner.get(1) {
                let text = "a second bsdf in a twosided one has no match; the first is on both sides";
                self.world.notes.add(self.place(second), text);
            }
            let first = inner.first().copied();
            node = first.ok_or_else(|| (self.place(node), "a twosided bsdf needs a bsdf inside".to_owned()))?;
        }
        let mut plugin = self.plugin(node)?;
        self.nested(node, &[]);
        self.world.material(&mut plugin)
    }

    /// Reads an element of the scene, or one in a sensor or a film.
    fn element(&mut self, node: Node<'_, '_>) -> Result<(), Fault> {
        let (word, place, mut plugin) = (node.tag_name().name(), self.place(node), self.plugin(node)?);
        match (word, plugin.kind()) {
            ("sensor", _) if self.world.view.is_some() => {
                self.world.notes.add(place, "a sensor that is not the first has no match; left out");
                return Ok(());
            }
            ("shape", _) => {
                let mut material = None;
                for child in self.nested(node, &["bsdf", "ref"]) {
                    let found =
                        if child.has_tag_name("bsdf") { Some(self.material(child)?) } else { self.reference(child)? };
                    // A reference to a medium leaves the material as it is.
                    material = found.or(material);
                }
                return self.world.shape(&mut plugin, &self.to_world(node)?, material);
            }
            ("emitter", kind) if !["constant", "envmap"].contains(&kind) => {
                self.world.notes.add(place, format!("{} has no match; left out", plugin.name));
                return Ok(());
            }
            _ => self.world.known_by_parameters(&mut plugin),
        }
        match word {
            "integrator" if plugin.text("max_depth").is_none_or(|depth| depth == "-1") => {
                self.world.notes.add(place, format!("an unlimited depth has no match; {UNLIMITED} is taken"));
            }
            "integrator" => self.world.config.max_depth = plugin.whole("max_depth", UNLIMITED, 1)?,
            "sensor" => {
                for child in self.nested(node, &["film", "sampler"]) {
                    self.element(child)?;
                }
                let top: fn(f64) -> f64 = match plugin.text("fov_axis").unwrap_or("x") {
                    "x" => |ratio| ratio,
                    "y" => |_| 1.0,
                    "diagonal" => |ratio| ratio / ratio.hypot(1.0),
                    "smaller" => |ratio| ratio.max(1.0),
                    "larger" => |ratio| ratio.min(1.0),
                    other => {
                        return Err((place, format!("[{other}] is no fov_axis; x, y, diagonal, smaller or larger is")));
                    }
                };
                // Without a field of view, Mitsuba takes that of a lens of 50 mm before a film that is 36 mm wide.
                let fov = plugin.real("fov", 2.0 * 0.36_f64.atan().to_degrees())?;
                let to_world = self.to_world(node)?;
                self.world.view = Some(View { place, to_world, x_is_right: false, fov, top, window: None });
            }
            "film" => {
                self.world.film = [plugin.whole("width", 768, 1)?, plugin.whole("height", 576, 1)?];
                for filter in self.nested(node, &["rfilter"]) {
                    self.element(filter)?;
                }
            }
            "sampler" => self.world.config.samples_per_pixel = plugin.whole("sample_count", 4, 1)?,
            "emitter" => {
                let picture = plugin.text("filename").map(|name| (self.path.with_file_name(name), Layout::Rows));
                let up = self.to_world(node)?.columns[1];
                self.world.sky(&plugin, "radiance", picture, (up, plugin.real("scale", 1.0)?))?;
            }
            _ => {}
        }
        Ok(())
    }

    /// Returns the elements in `node` with these names. Notes those that are not read otherwise: parameters are, except
    /// in the scene itself.
    fn nested<'a, 'b>(&mut self, node: Node<'a, 'b>, names: &[&str]) -> Vec<Node<'a, 'b>> {
        let (read, others): (Vec<_>, Vec<_>) = node
            .children()
            .filter(|child| child.is_element() && (node.has_tag_name("scene") || !is_parameter(child)))
            .partition(|child| names.contains(&child.tag_name().name()));
        for child in others {
            let [inner, outer] = [child, node].map(|node| node.tag_name().name());
            self.world.notes.add(self.place(child), format!("<{inner}> in <{outer}> has no match; left out"));
        }
        read
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
}
