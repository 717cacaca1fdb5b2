//! Reads a scene of pbrt-v4.

mod values;

use std::collections::HashMap;
use std::path::Path;

use cpu::Vec3;
use cpu::internals::input::scene::MaterialId;

use super::notes::{Fault, Place};
use super::plugin::{Plugin, shown};
use super::sky::Layout;
use super::tokens::Tokens;
use super::transform::Transform;
use super::world::{View, World};
use values::named;

/// What attribute blocks save and restore.
#[derive(Clone, Copy)]
struct State {
    transform: Transform,
    material: Option<MaterialId>,
}

struct Reader<'a> {
    tokens: Tokens,
    path: &'a Path,
    world: &'a mut World,
    state: State,
    /// The states to return to, with the directive that saved each of them.
    saved: Vec<(State, String)>,
    materials: HashMap<String, MaterialId>,
    systems: HashMap<String, Transform>,
    /// The transform after `LookAt`, and its three vectors.
    view: Option<(Transform, [Vec3; 3])>,
}

/// Reads the file `path` into `world`.
///
/// # Errors
/// A fault of the file.
pub fn read(path: &Path, world: &mut World) -> Result<(), Fault> {
    world.film = [1280, 720];
    (world.config.samples_per_pixel, world.config.max_depth) = (16, 6);
    let state = State { transform: Transform::IDENTITY, material: None };
    let (tokens, view) = (Tokens::default(), None);
    let (saved, materials, systems) = (Vec::new(), HashMap::new(), HashMap::new());
    let mut reader = Reader { tokens, path, world, state, saved, materials, systems, view };
    reader.include(path, (0, 1))?;
    while reader.tokens.peek().is_some() {
        let (word, place) = reader.tokens.take()?;
        reader.directive(&word, place)?;
    }
    let open = reader.saved.pop().map(|(_, begin)| format!("the file ends here, and a {begin} has no end"));
    open.map_or(Ok(()), |text| Err((reader.tokens.last, text)))
}

impl Reader<'_> {
    /// Reads a file that is named relative to the folder of the first one.
    fn include(&mut self, path: &Path, place: Place) -> Result<(), Fault> {
        self.world.notes.files.push(crate::terminal::name(path));
        self.world.inputs.push(path.to_owned());
        self.tokens.include(path, place)
    }

    fn directive(&mut self, word: &str, place: Place) -> Result<(), Fault> {
        match word {
            "Identity" => self.state.transform = Transform::IDENTITY,
            "WorldBegin" => {
                self.state.transform = Transform::IDENTITY;
                self.systems.insert("world".to_owned(), Transform::IDENTITY);
            }
            "Transform" => self.state.transform = self.matrix(place)?,
            "Translate" | "Scale" | "Rotate" | "ConcatTransform" | "LookAt" => {
                let before = self.state.transform;
                let inner = self.inner(word, place)?;
                self.state.transform = before.then_inner(&inner);
                if let Some(view) = inner.view {
                    let is_plain = [1.0, -1.0].map(|x| Transform::scale([x, 1.0, 1.0])).contains(&before);
                    self.view = is_plain.then_some((self.state.transform, view));
                }
            }
            "CoordinateSystem" => drop(self.text().map(|name| self.systems.insert(name, self.state.transform))?),
            "CoordSysTransform" => self.state.transform = named(&self.text()?, &self.systems, word, place)?,
            "NamedMaterial" => self.state.material = Some(named(&self.text()?, &self.materials, word, place)?),
            "AttributeBegin" | "TransformBegin" | "ObjectBegin" => {
                self.saved.push((self.state, word.to_owned()));
                if word == "ObjectBegin" {
                    self.left_out(word, place)?;
                }
            }
            "AttributeEnd" | "TransformEnd" | "ObjectEnd" => {
                let begin = word.replace("End", "Begin");
                let last = self.saved.pop().filter(|(_, saved)| *saved == begin);
                let (state, _) = last.ok_or((place, format!("no {begin} without an end stands above this {word}")))?;
                let material = if word == "TransformEnd" { self.state.material } else { state.material };
                self.state = State { material, ..state };
            }
            "ReverseOrientation" => {}
            "Include" => {
                let path = self.path.with_file_name(self.text()?);
                self.include(&path, place)?;
            }
            "MakeNamedMaterial" => {
                let mut plugin = self.plugin(word, place)?;
                let name = plugin.kind().to_owned();
                plugin.name = format!("Material {}", plugin.text("type").unwrap_or("diffuse"));
                plugin.params.retain(|param| param.name != "type");
                let material = self.world.material(&mut plugin)?;
                self.materials.insert(name, material);
            }
            "Material" | "Shape" | "Camera" | "Film" | "Sampler" | "Integrator" | "PixelFilter" | "LightSource" => {
                let mut plugin = self.plugin(word, place)?;
                self.plugged(word, &mut plugin)?;
            }
            _ if !word.starts_with(char::is_alphabetic) => {
                return Err((place, format!("[{}] stands here, and a directive is needed", shown(word))));
            }
            _ => self.left_out(word, place)?,
        }
        Ok(())
    }

    /// Handles a directive with the name of a plugin.
    fn plugged(&mut self, word: &str, plugin: &mut Plugin) -> Result<(), Fault> {
        let (world, transform) = (&mut *self.world, self.state.transform);
        match (word, plugin.kind()) {
            ("Material", _) => self.state.material = Some(world.material(plugin)?),
            ("Shape", _) if self.saved.iter().any(|(_, begin)| begin == "ObjectBegin") => {}
            ("Shape", _) => world.shape(plugin, &transform, self.state.material)?,
            ("LightSource", "infinite") => {
                world.known_by_parameters(plugin);
                let scale = plugin.real("scale", 1.0)?;
                let picture = plugin.text("filename").map(|name| (self.path.with_file_name(name), Layout::Square));
                world.sky(plugin, "L", picture, (transform.columns[2], scale))?;
            }
            ("LightSource", _) => world.notes.add(plugin.place, format!("{} has no match; left out", plugin.name)),
            _ => world.known_by_parameters(plugin),
        }
        match word {
            "Camera" => {
                let view = self.view.filter(|(after, _)| *after == transform).map(|(_, view)| view);
                let to_world = Transform { view, ..transform.inverse() };
                self.systems.insert("camera".to_owned(), to_world);
                let mut window = None;
                if let Some(param) = plugin.param("screenwindow") {
                    let [left, right, bottom, top] = plugin.numbers("screenwindow", [0.0; 4])?;
                    if left != -right || bottom != -top || left > right || bottom > top {
                        let text = "[screenwindow] is not symmetrical, or it is flipped; its size is taken";
                        world.notes.add(param.place, text);
                    }
                    if left == right || bottom == top {
                        return Err((param.place, "[screenwindow] needs a width and a height".to_owned()));
                    }
                    window = Some([right - left, top - bottom].map(|side| side.abs() / 2.0));
                }
                let (place, fov) = (plugin.place, plugin.real("fov", 90.0)?);
                // The field of view is that of the shorter side.
                let view = View { place, to_world, x_is_right: true, fov, top: |ratio| ratio.max(1.0), window };
                if let Some(before) = world.view.replace(view) {
                    world.notes.add(before.place, "another camera follows this one, which is left out");
                }
            }
            "Film" => world.film = [plugin.whole("xresolution", 1280, 1)?, plugin.whole("yresolution", 720, 1)?],
            "Sampler" => {
                let strata = plugin.whole("xsamples", 4, 1)?.saturating_mul(plugin.whole("ysamples", 4, 1)?);
                world.config.samples_per_pixel = plugin.whole("pixelsamples", strata, 1)?;
            }
            // pbrt counts the surfaces of a path, and ours counts its rays.
            "Integrator" => world.config.max_depth = plugin.whole("maxdepth", 5, 0)?.saturating_add(1),
            _ => {}
        }
        Ok(())
    }

    /// Notes that a directive has no match, and skips its values.
    fn left_out(&mut self, word: &str, place: Place) -> Result<(), Fault> {
        let is_value = |token: &str| !token.starts_with(char::is_alphabetic) || ["true", "false"].contains(&token);
        while self.tokens.peek().is_some_and(is_value) {
            self.tokens.take()?;
        }
        self.world.notes.add(place, format!("{} has no match; left out", shown(word)));
        Ok(())
    }
}
