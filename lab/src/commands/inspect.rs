//! `render-lab inspect`: prints what a scene holds, and how the renderer prepares it.

use std::collections::BTreeMap;
use std::path::PathBuf;

use clap::Args;
use cpu::internals::Prepared;
use cpu::internals::accel::bounds::Bounds;
use cpu::internals::accel::choice::Accel;
use cpu::internals::accel::extent::Extent;
use cpu::internals::input::scene::{Cylinder, Shape, Sphere};
use cpu::{Aos, Config, Error, Material, Scatter, Scene, Vec3};
use minijinja::value::Serde;
use serde::Serialize;

use crate::template::filled;
use crate::{Failure, sources, terminal};

/// Options of `inspect`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/inspect.txt").trim_ascii_end(), allow_missing_positional = true)]
pub struct Arguments {
    /// Configuration file; the defaults count without one
    config: Option<PathBuf>,
    /// Scene file, - for standard input
    scene: PathBuf,
    /// Print it as JSON
    #[arg(long)]
    json: bool,
}

/// The facts about a scene that the command prints.
#[derive(Debug, PartialEq, Serialize)]
struct Inspection {
    spheres: usize,
    cylinders: usize,
    /// Number of objects for each kind of material.
    objects_by_material: BTreeMap<&'static str, usize>,
    materials: usize,
    unused_materials: usize,
    /// Lowest corner of the box around all objects, in scene units; absent if there are no objects.
    lowest_corner: Option<[f64; 3]>,
    highest_corner: Option<[f64; 3]>,
    /// Largest absolute coordinate of the objects and the camera, in scene units.
    reach: f64,
    /// Whether the magnitudes allow conservative tests. If not, the renderer intersects every ray with every object.
    moderate: bool,
    structure: Structure,
    picture: [usize; 2],
    samples: u64,
}

/// The acceleration structure that the renderer chooses.
#[derive(Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case", tag = "kind")]
enum Structure {
    /// No acceleration structure: the renderer intersects every ray with every object.
    EveryObject,
    /// The structure for small scenes of up to 8 objects.
    SmallScene,
    /// The flat filter, for up to 64 spheres and 64 cylinders.
    FlatFilter,
    /// The bounding volume hierarchy, for more objects.
    Bvh {
        nodes: usize,
        children_per_node: f64,
        /// Expected number of boxes that a random line through the root's box hits: the sum of the surface areas of all
        /// boxes, divided by the surface area of the root's box.
        boxes_hit_by_a_line: f64,
    },
}

impl Arguments {
    /// Prints the facts about the scene.
    ///
    /// # Errors
    /// An error of a file.
    pub fn run(&self) -> Result<(), Failure> {
        let inputs: Vec<_> = self.config.iter().chain([&self.scene]).map(PathBuf::as_path).collect();
        sources::refuse_inputs_in_one(&inputs)?;
        let config = self.config.as_ref().map_or(Ok(Config::default()), |path| sources::config(path, &[]))?;
        let scene = sources::scene(&self.scene)?;
        let explain = |error| match &self.config {
            Some(path) => sources::about_picture(error, path, &[]),
            None => error.into(),
        };
        let inspection = Inspection::of(&config, &scene).map_err(explain)?;
        if self.json { terminal::print_json(&inspection) } else { terminal::print(&inspection.text()?) }
    }
}

impl Inspection {
    fn of(config: &Config, scene: &Scene) -> Result<Self, Error> {
        let prepared = Prepared::<Aos>::new(config, scene, Scatter::Statement)?;
        let extent = Extent::new(&prepared.objects, &prepared.camera, &scene.materials_in_use()?);
        let corners =
            scene.objects.iter().map(|object| corners(&object.shape)).reduce(|[low, high], [lower, higher]| {
                let axes = [0, 1, 2];
                [axes.map(|axis| low[axis].min(lower[axis])), axes.map(|axis| high[axis].max(higher[axis]))]
            });
        let mut used = vec![false; scene.materials.len()];
        let mut objects_by_material = BTreeMap::new();
        for object in &scene.objects {
            used[object.material as usize] = true;
            *objects_by_material.entry(kind(&scene.materials[object.material as usize])).or_insert(0) += 1;
        }
        let spheres = scene.objects.iter().filter(|object| matches!(object.shape, Shape::Sphere(_))).count();
        Ok(Self {
            spheres,
            cylinders: scene.objects.len() - spheres,
            objects_by_material,
            materials: scene.materials.len(),
            unused_materials: used.iter().filter(|&&used| !used).count(),
            lowest_corner: corners.map(|[low, _]| low),
            highest_corner: corners.map(|[_, high]| high),
            reach: extent.max_coordinate,
            moderate: !matches!(prepared.accel, Accel::EveryObject(_)),
            structure: match &prepared.accel {
                Accel::EveryObject(_) => Structure::EveryObject,
                Accel::SmallScene(_) => Structure::SmallScene,
                Accel::FlatFilter(_) => Structure::FlatFilter,
                Accel::Bvh(_) | Accel::LargeBvh(_) => tree(&prepared.accel),
            },
            picture: [prepared.size.width(), prepared.size.height()],
            samples: prepared.samples,
        })
    }

    fn text(&self) -> Result<String, String> {
        filled(include_str!("../../templates/inspect.txt"), Serde(self).into())
    }
}

/// Returns the lowest and the highest corner of the box around an object.
fn corners(shape: &Shape) -> [[f64; 3]; 2] {
    let (center, half) = match *shape {
        Shape::Sphere(Sphere { center, radius }) => (center, Vec3::splat(radius)),
        Shape::Cylinder(Cylinder { center, radius, axis }) => {
            let disc = axis.unit().map(|along| (1.0 - along * along).max(0.0).sqrt() * radius);
            (center, axis.map(f64::abs) / 2.0 + disc)
        }
    };
    [(center - half).to_array(), (center + half).to_array()]
}

const fn kind(material: &Material) -> &'static str {
    match material {
        Material::Matte { .. } => "matte",
        Material::Metal { .. } => "metal",
        Material::Refractive { .. } => "refractive",
    }
}

/// Returns the numbers that describe a BVH.
fn tree(accel: &Accel) -> Structure {
    // `visit_boxes` calls its first function once for each child of a node: for every node except the root, and for
    // every object.
    let (mut boxes, mut surface, mut whole) = (0_usize, 0.0, Bounds::EMPTY);
    // The second function gets every object of the tree, and the dominant sphere, which is not in the tree.
    let (mut objects, mut outside) = (0_usize, 0_usize);
    accel.visit_boxes(|_| false, |_| outside += 1);
    accel.visit_boxes(
        |bounds| {
            boxes += 1;
            surface += f64::from(bounds.half_area());
            whole = whole.union(bounds);
            true
        },
        |_| objects += 1,
    );
    let nodes = boxes - (objects - outside) + 1;
    Structure::Bvh {
        nodes,
        children_per_node: boxes as f64 / nodes as f64,
        boxes_hit_by_a_line: surface / f64::from(whole.half_area()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use generator::{Arrangement, Options, scene};

    fn inspect(scene: &Scene) -> Inspection {
        Inspection::of(&Config::default(), scene).expect("the default picture is fine")
    }

    fn inspect_text(text: &str) -> Inspection {
        inspect(&Scene::parse(text.as_bytes()).expect("it is valid"))
    }

    #[test]
    fn a_small_scene_is_told_in_full() {
        let text = "matte: a 1 1 1\nmetal: b 1 1 1 0\nsphere: 0 0 0 1 a\nsphere: 3 0 0 1 a\n";
        let inspection = inspect_text(text);
        assert_eq!((inspection.spheres, inspection.cylinders), (2, 0));
        assert_eq!((inspection.materials, inspection.unused_materials), (2, 1));
        assert_eq!(inspection.objects_by_material, BTreeMap::from([("matte", 2)]));
        assert_eq!(inspection.reach, 10.0, "the camera's distance");
        assert_eq!((inspection.lowest_corner, inspection.highest_corner), (Some([-1.0; 3]), Some([4.0, 1.0, 1.0])));
    }

    #[test]
    fn extreme_objects_have_corners_and_are_not_moderate() {
        for (line, high) in [("cylinder: 0 0 0 1 0 1e60 0", [1.0, 5e59, 1.0]), ("sphere: 0 0 0 1e-9", [1e-9; 3])] {
            let inspection = inspect_text(&format!("matte: a 1 1 1\n{line} a\n"));
            assert_eq!((inspection.highest_corner, inspection.moderate), (Some(high), false), "{line}");
            assert_eq!(inspection.structure, Structure::EveryObject, "{line}");
        }
    }

    #[test]
    fn an_empty_scene_has_no_surfaces() {
        let inspection = inspect(&Scene::default());
        assert_eq!((inspection.lowest_corner, inspection.spheres), (None, 0));
        assert!(inspection.text().is_ok_and(|text| text.contains("surfaces    none")));
    }

    #[test]
    fn a_tree_holds_every_object_once() {
        let options = Options { objects: 3000, arrangement: Arrangement::Grid, ..Options::default() };
        let tree = inspect(&scene(&options)).structure;
        let Structure::Bvh { nodes, children_per_node, boxes_hit_by_a_line } = tree else { panic!("{tree:?}") };
        // With at most 16 children a node, 3000 objects need at least 200 nodes.
        assert!((200..3000).contains(&nodes), "{tree:?}");
        assert!(children_per_node > 1.0 && children_per_node <= 16.0, "{tree:?}");
        // The boxes of the root's children cover all objects. So the sum of their surface areas is about that of the
        // root's box, or larger. Rounding in f32 may make the quotient slightly less than 1.
        assert!(boxes_hit_by_a_line > 0.99, "{tree:?}");
    }

    #[test]
    fn the_dominant_sphere_is_not_counted_in_the_tree() {
        let mut text = "matte: m 1 1 1\n".to_owned();
        for at in 0..300 {
            text += &format!("sphere: {} 0 {} .3 m\n", at % 20, at / 20);
        }
        let nodes = |text: &str| match inspect_text(text).structure {
            Structure::Bvh { nodes, .. } => nodes,
            structure => panic!("{structure:?}"),
        };
        let alone = nodes(&text);
        text += "sphere: 0 -1001 0 1000 m\n";
        assert_eq!(nodes(&text), alone);
    }
}
