//! A scene of another format while it is read: what has been found so far, in our terms.

use std::path::PathBuf;

use cpu::internals::input::scene::{Cylinder, MaterialId, Sphere};
use cpu::{Config, Material, Object, Scene, Shape, Vec3};

use super::matches;
use super::materials::{limited, matching};
use super::notes::{Fault, Notes, Place};
use super::plugin::Plugin;
use super::sky::Layout;
use super::transform::Transform;
use crate::picture::any::Any;
use crate::picture::floats::{Floats, GAMMA};

/// A camera as the file has it.
#[derive(Debug)]
pub struct View {
    /// The line of the camera.
    pub place: Place,
    /// The transform from camera to world. The camera looks along +z.
    pub to_world: Transform,
    /// Whether +x of the camera is at the right of the picture, as in pbrt, and not at the left, as in Mitsuba.
    pub x_is_right: bool,
    /// The field of view in degrees.
    pub fov: f64,
    /// Returns the half height of the picture where the field of view reaches to 1, for the picture's height divided by
    /// its width.
    pub top: fn(f64) -> f64,
    /// The picture's right and upper edge, as lengths from its middle, if the file gives them.
    pub window: Option<[f64; 2]>,
}

/// A disk. Two of them close a cylinder.
#[derive(Debug)]
pub(super) struct Disk {
    pub(super) place: Place,
    pub(super) center: Vec3,
    pub(super) normal: Vec3,
    pub(super) radius: f64,
    pub(super) material: MaterialId,
}

/// What has been found in a file.
#[derive(Debug, Default)]
pub struct World {
    /// What has no match.
    pub notes: Notes,
    /// The files that are read, which no output may replace.
    pub inputs: Vec<PathBuf>,
    /// The camera, if there is one.
    pub view: Option<View>,
    /// Width and height of the picture.
    pub film: [u64; 2],
    /// Samples and depth of this configuration are set while the file is read, the other values when it is complete.
    pub config: Config,
    /// Materials and objects.
    pub scene: Scene,
    pub(super) sky: Option<[Vec3; 2]>,
    pub(super) disks: Vec<Disk>,
    /// The lines of the cylinders.
    pub(super) cylinders: Vec<Place>,
    grey: Option<MaterialId>,
}

impl World {
    /// Adds the material that matches `plugin`.
    ///
    /// # Errors
    /// A fault if a number is wrong.
    pub fn material(&mut self, plugin: &mut Plugin) -> Result<MaterialId, Fault> {
        self.scene.materials.push(matching(plugin, &mut self.notes)?);
        Ok((self.scene.materials.len() - 1) as MaterialId)
    }

    /// Adds the object for a shape, or a note. A shape without a material is grey, as in both formats.
    ///
    /// # Errors
    /// A fault if a number is wrong.
    pub fn shape(
        &mut self,
        plugin: &mut Plugin,
        to_world: &Transform,
        material: Option<MaterialId>,
    ) -> Result<(), Fault> {
        // Only the type is noted for a shape that is left out.
        if !["sphere", "cylinder", "disk"].contains(&plugin.kind()) || !matches::check(plugin, &mut self.notes) {
            self.notes.add(plugin.place, format!("{} has no match; left out", plugin.name));
            return Ok(());
        }
        let material = material.unwrap_or_else(|| {
            *self.grey.get_or_insert_with(|| {
                self.scene.materials.push(Material::Matte { reflectance: Vec3::splat(0.5) });
                (self.scene.materials.len() - 1) as MaterialId
            })
        });
        let radius = plugin.real("radius", 1.0)?;
        let mut scaled = |of: &Transform, axes| {
            let (scale, is_equal) = of.scale_of(axes);
            if !is_equal {
                self.notes
                    .add(plugin.place, "a scale that is not equal along all axes has no match; its mean is taken");
            }
            radius * scale
        };
        let shape = match plugin.kind() {
            "sphere" => {
                let center = to_world.point(plugin.numbers("center", [0.0; 3])?.into());
                Shape::Sphere(Sphere { center, radius: scaled(to_world, 3) })
            }
            "cylinder" => {
                let zmin = plugin.real("zmin", if plugin.name.starts_with("shape") { 0.0 } else { -1.0 })?;
                let start = Vec3::from(plugin.numbers("p0", [0.0, 0.0, zmin])?);
                let end = Vec3::from(plugin.numbers("p1", [0.0, 0.0, plugin.real("zmax", 1.0)?])?);
                let (axis, middle) = (end - start, (start + end) / 2.0);
                let placed = to_world.then_inner(&Transform::along(axis, middle));
                self.cylinders.push(plugin.place);
                Shape::Cylinder(Cylinder { center: placed.origin, radius: scaled(&placed, 2), axis: placed.columns[2] })
            }
            _ => {
                let center = to_world.point(Vec3::new(0.0, 0.0, plugin.real("height", 0.0)?));
                let (radius, normal) = (scaled(to_world, 2), to_world.columns[2]);
                self.disks.push(Disk { place: plugin.place, center, normal, radius, material });
                return Ok(());
            }
        };
        let (center, radius, height) = match shape {
            Shape::Sphere(sphere) => (sphere.center, sphere.radius, 1.0),
            Shape::Cylinder(cylinder) => (cylinder.center, cylinder.radius, cylinder.axis.length()),
        };
        if matches!(shape, Shape::Cylinder(_)) && radius != 1.0 {
            self.notes.add(plugin.place, matches::SIDE);
        }
        let is_positive = |length: f64| length > 0.0 && length.is_finite();
        if !(center.is_finite() && is_positive(radius) && is_positive(height)) {
            let fault = format!("{} needs a finite place, and a size above 0; its radius is {radius}", plugin.name);
            return Err((plugin.place_of("radius"), fault));
        }
        self.scene.objects.push(Object { shape, material });
        Ok(())
    }

    /// Notes what has no match in a plugin whose type is not important: its parameters are used in any case.
    pub fn known_by_parameters(&mut self, plugin: &mut Plugin) {
        if !matches::check(plugin, &mut self.notes) {
            self.notes.add(plugin.place, format!("{} has no match; ours takes its place", plugin.name));
        }
    }

    /// Sets the sky to a light that surrounds the scene, times a factor. The light has the colour of the parameter
    /// `color`, or a picture whose axis has the direction `up` in the world.
    ///
    /// # Errors
    /// A fault if a number is wrong, or if memory is short.
    pub fn sky(
        &mut self,
        plugin: &Plugin,
        color: &str,
        picture: Option<(PathBuf, Layout)>,
        (up, scale): (Vec3, f64),
    ) -> Result<(), Fault> {
        let (place, notes) = (plugin.place, &mut self.notes);
        let colors = match picture {
            None => [plugin.color(color, [1.0; 3], notes)?; 2],
            Some((path, layout)) => {
                self.inputs.push(path.clone());
                let picture = match Any::read(&path) {
                    Ok(Any::Floats(floats)) => Ok(floats),
                    Ok(Any::Bytes(picture)) => Floats::of(&picture, GAMMA),
                    Err(failure) => {
                        let reason = failure.message().unwrap_or_default();
                        notes.add(place, format!("{reason}; our default sky takes the place of the picture"));
                        return Ok(());
                    }
                };
                let found = picture.and_then(|picture| layout.colors(&picture));
                let (colors, is_gradient) = found.map_err(|error| (place, error))?;
                if !is_gradient || up.unit().y < 1.0 - 1e-6 {
                    notes.add(place, "the sky is no gradient from top to bottom; that between its two poles is taken");
                }
                colors
            }
        };
        if self.sky.is_some() {
            notes.add(place, "a second sky has no match; it replaces the first");
        }
        self.sky = Some(colors.map(|color| limited(color * scale, place, notes)));
        Ok(())
    }
}
