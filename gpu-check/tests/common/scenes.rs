//! The scenes for comparing whole pictures: those of the repository, random scenes, and edge cases that show
//! differences between two implementations.

use std::fs;
use std::path::Path;

use cpu::internals::input::scene::{Object, Shape, Sphere};
use cpu::{Config, Scene, Vec3};
use generator::{Arrangement, Options};
use stability::random::Random;
use test_support::{everything, project_root};

pub use crate::sampled::Case;

/// Returns all scenes in a folder of the repository, in the order of their names. A scene is a subfolder with
/// `config.txt` and `scene.txt`.
pub fn in_folder(folder: &str) -> Vec<Case> {
    let entries = fs::read_dir(project_root().join(folder)).expect("the folder can be read");
    let paths = entries.map(|entry| entry.expect("the folder can be read").path());
    let mut folders: Vec<_> = paths.filter(|path| path.join("scene.txt").is_file()).collect();
    folders.sort();
    folders.iter().map(|path| read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))).collect()
}

/// Returns a number of random cases: `usual`, or twice as many with `RENDER_ALL=1`, as in tests/extensive.
pub fn number_of_random(usual: u64) -> u64 {
    if everything() { 2 * usual } else { usual }
}

/// Returns all scenes of the repository, the edge cases, and `random` random scenes, each [within](Case::within)
/// `tests`.
pub fn all(random: u64, tests: usize) -> Vec<Case> {
    let repository: Vec<_> = ["tests/cases", "scenes"].into_iter().flat_map(in_folder).collect();
    assert!(repository.len() >= 22, "the repository has only {} scenes", repository.len());
    let cases = repository.into_iter().chain(edges()).chain((0..random).map(self::random));
    cases.map(|case| case.within(tests)).collect()
}

fn read(folder: &Path) -> Result<Case, cpu::Error> {
    let config = Config::read(&folder.join("config.txt"))?;
    let scene = Scene::read(&folder.join("scene.txt"))?;
    let parts: Vec<_> = folder.iter().rev().take(2).map(|part| part.to_string_lossy()).collect();
    Ok(Case { name: format!("{}/{}", parts[1], parts[0]), config, scene })
}

impl Case {
    /// Returns the case with fewer pixels if its pixels times its objects are more than `tests`. The number of objects
    /// is increased by 100, because a pixel takes time even without objects.
    pub fn within(mut self, tests: usize) -> Self {
        let objects = self.scene.objects.len() + 100;
        while self.config.image_width > 8
            && self.config.image_size().is_ok_and(|size| size.pixels().saturating_mul(objects) > tests)
        {
            self.config.image_width = self.config.image_width * 3 / 4;
        }
        self
    }
}

/// Returns edge cases: scenes whose pixels differ if two implementations decide differently. They have objects of
/// different materials at one place, a camera inside an object, and rays along an axis and in the plane of a cap.
pub fn edges() -> Vec<Case> {
    const MATERIALS: &str = "matte: red .9 .1 .2\nmatte: green .1 .8 .3\nmetal: mirror .9 .8 .7 .1\nrefractive: glass 1.5\n\
        refractive: air .6\n";
    const SCENES: [(&str, &str); 12] = [
        ("one sphere twice", "sphere: 0 0 0 1 red\nsphere: 0 0 0 1 green\n"),
        ("a sphere after a cylinder that it touches", "cylinder: 0 0 0 1 0 4 0 red\nsphere: 0 0 0 1 green\n"),
        ("one cylinder twice", "cylinder: 0 0 0 1 0 2 1 green\ncylinder: 0 0 0 1 0 2 1 mirror\n"),
        ("one cylinder after another, caps together", "cylinder: 0 1 0 1 0 2 0 red\ncylinder: 0 -1 0 1 0 2 0 glass\n"),
        ("two caps in one plane", "cylinder: 0 0 0 2 0 0 2 red\ncylinder: 0 0 .5 1 0 0 3 green\n"),
        ("a cap before a sphere in its plane", "cylinder: 0 0 0 2 0 0 2 red\nsphere: 0 0 0 1 green\n"),
        ("a cap after a sphere in its plane", "sphere: 0 0 0 1 green\ncylinder: 0 0 0 2 0 0 2 red\n"),
        ("from inside a sphere", "sphere: 0 0 -10 4 mirror\nsphere: 0 0 0 1 red\nsphere: 0 0 -10 40 green\n"),
        ("from inside a glass cylinder", "cylinder: 0 0 -8 3 0 0 6 glass\nsphere: 0 0 0 1 red\n"),
        ("along the axis", "cylinder: 0 0 0 1.5 0 0 2 glass\ncylinder: 3 0 0 1 0 0 5 mirror\nsphere: 0 0 4 1 red\n"),
        ("glass in air in glass", "sphere: 0 0 0 3 glass\nsphere: 0 0 0 2 air\ncylinder: 0 0 0 .8 1 1 0 glass\n"),
        ("nothing", ""),
    ];
    let config =
        Config { image_width: 65, aspect_ratio: [1, 1], field_of_view: 40.0, max_depth: 9, ..Config::default() };
    let parse = |text: &str| {
        let text = format!("{MATERIALS}{text}sphere: 0 -1003 0 1000 red\n");
        Scene::parse(text.as_bytes()).expect("the scene is valid")
    };
    SCENES
        .iter()
        .map(|(name, text)| Case { name: (*name).to_owned(), config: config.clone(), scene: parse(text) })
        .chain([Case { name: "no object at all".to_owned(), config: config.clone(), scene: Scene::default() }])
        .collect()
}

/// The number of objects that are added to make paths too long for one run.
pub const LONG_PATHS: usize = 30_000;

/// Returns a scene whose paths a device traces in several runs, of two surfaces each, because it has so many objects.
/// With several samples for each pixel, a run ends within a pixel.
pub fn long_paths() -> Case {
    let mut case = edges().into_iter().find(|case| case.name == "glass in air in glass").expect("it is there");
    let behind = Shape::Sphere(Sphere { center: Vec3::new(0.0, 0.0, -900.0), radius: 1.0 });
    case.scene.objects.extend(std::iter::repeat_n(Object { shape: behind, material: 0 }, LONG_PATHS));
    (case.config.image_width, case.config.samples_per_pixel) = (16, 5);
    Case { name: "long paths".to_owned(), ..case }
}

/// Returns a random scene with all materials, all shapes and a maximum depth of up to 50, scattered or on a ground.
/// Equal seeds give equal scenes.
pub fn random(seed: u64) -> Case {
    let mut random = Random::new(seed);
    let arrangement = [Arrangement::Scattered, Arrangement::Grid][random.below(2)];
    let objects = 1 + random.below(60);
    let scene = generator::scene(&Options { seed, objects, extent: 5.0, arrangement, ..Options::default() });
    let color = |random: &mut Random| Vec3::from([(); 3].map(|()| random.uniform(0.0, 1.0)));
    let config = Config {
        image_width: 48 + random.below(48) as u64,
        camera_position: random.unit() * random.uniform(2.0, 14.0),
        camera_target: random.cube(1.0),
        camera_north: random.unit(),
        field_of_view: random.uniform(20.0, 110.0),
        max_depth: [1, 2, 5, 12, 50][random.below(5)],
        background_dark_color: color(&mut random),
        background_light_color: color(&mut random),
        ..Config::default()
    };
    Case { name: format!("random scene {seed}"), config, scene }
}
