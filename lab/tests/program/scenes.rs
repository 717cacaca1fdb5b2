//! Tests of `render-lab convert` with scenes for pbrt and Mitsuba.

use std::fs;
use std::path::Path;

use cpu::internals::input::scene::{Cylinder, Sphere};
use cpu::{Config, Scene, Shape, Vec3};
use lab::picture::any::Any;
use test_support::folder::Folder;

use crate::{complaint, printed, run};

/// Returns the numbers in `text` between each `start` and the next `end`.
fn numbers(text: &str, start: &str, end: char) -> Vec<Vec<f64>> {
    let part = |rest: &str| rest.split(end).next().unwrap_or_default().to_owned();
    let parse = |words: String| words.split_whitespace().map(|word| word.parse().expect("a number")).collect();
    text.split(start).skip(1).map(part).map(parse).collect()
}

/// Returns the shapes of a written scene: the spheres, and the cylinders with their radius, by a reader of these few
/// lines. The columns of the matrix must be two unit vectors that are perpendicular to the third, the axis.
fn shapes(text: &str, is_pbrt: bool) -> (Vec<Sphere>, Vec<Cylinder>) {
    let vector = |at: &[f64]| Vec3::new(at[0], at[1], at[2]);
    let (centers, radii, matrices, widths) = if is_pbrt {
        let balls = numbers(text, "Shape \"sphere\" \"float radius\" ", 'A');
        let tubes = numbers(text, "Shape \"cylinder\" \"float radius\" ", '"');
        (numbers(text, "Translate ", 'S'), balls, numbers(text, "Transform [", ']'), tubes)
    } else {
        let balls = "<shape type=\"sphere\"><point name=\"center\" value=\"";
        let radius = |kind: &str| {
            let start = format!("<shape type=\"{kind}\">");
            text.split(&start).skip(1).map(|part| numbers(part, "name=\"radius\" value=\"", '"')[0].clone()).collect()
        };
        let tubes = text.split("<shape type=\"cylinder\">").skip(1).collect::<Vec<_>>();
        let matrices = tubes.iter().map(|part| {
            let rows = &numbers(part, "<matrix value=\"", '"')[0];
            (0..16).map(|at| rows[at % 4 * 4 + at / 4]).collect()
        });
        (numbers(text, balls, '"'), radius("sphere"), matrices.collect(), radius("cylinder"))
    };
    let spheres =
        centers.iter().zip(radii).map(|(center, radius)| Sphere { center: vector(center), radius: radius[0] });
    let cylinders = matrices.iter().zip(widths).map(|(matrix, radius)| {
        let [x, y, axis, center] = [0, 4, 8, 12].map(|at| vector(&matrix[at..]));
        assert_eq!([3, 7, 11, 15].map(|at| matrix[at]), [0.0, 0.0, 0.0, 1.0]);
        let wrong = [x.dot(y), x.dot(axis.unit()), y.dot(axis.unit()), x.length() - 1.0, y.length() - 1.0];
        assert!(wrong.iter().all(|wrong| wrong.abs() < 1e-12), "{wrong:?}");
        Cylinder { center, radius: radius[0], axis }
    });
    (spheres.collect(), cylinders.collect())
}

#[test]
fn every_scene_is_written_in_both_formats_with_all_its_numbers() {
    let folder = Folder::new();
    let mut objects = 0;
    for entry in fs::read_dir(test_support::project_root().join("scenes")).expect("it is committed") {
        let [config, scene] =
            ["config.txt", "scene.txt"].map(|name| entry.as_ref().expect("it is there").path().join(name));
        let name = |path: &Path| path.display().to_string();
        let found = Scene::read(&scene).expect("it is valid");
        let (mut spheres, mut cylinders) = (Vec::new(), Vec::new());
        for object in &found.objects {
            match object.shape {
                Shape::Sphere(sphere) => spheres.push(sphere),
                Shape::Cylinder(cylinder) => cylinders.push(cylinder),
            }
        }
        for other in ["other.pbrt", "other.xml"] {
            assert_eq!(printed(&["convert", &name(&config), &name(&scene), &folder.name(other)]), "");
            let text = String::from_utf8(folder.read(other)).expect("it is text");
            assert!(
                shapes(&text, other.ends_with("pbrt")) == (spheres.clone(), cylinders.clone()),
                "{scene:?} {other}"
            );
            objects += found.objects.len();
        }
    }
    assert!(objects > 1000, "only {objects} objects were compared");
}

const CONFIG: &str = "image_width: 30\naspect_ratio: 3 4\ncamera_position: 1 2 -6\nfield_of_view: 45\n\
                      samples_per_pixel: 7\nmax_depth: 6\nbackground_dark_color: .5 .25 1\n\
                      background_light_color: .5 .25 1\n";
const SCENE: &str = "matte: a .1 .2 .3\nmetal: b .4 .5 .6 0\nmetal: c .7 .8 .9 .5\nrefractive: d 1.5\n\
                     sphere: 1 -2 3 .5 d\ncylinder: 4 5 6 1 0 2 0 b\n";

/// The texts were written by hand, from the documentation of pbrt-v4 and Mitsuba 3. Mitsuba 3.9.1 reads the second.
#[test]
fn a_scene_of_all_kinds_is_written_as_both_programs_document() {
    let folder = Folder::new();
    let [config, scene] = [folder.write("c", CONFIG), folder.write("s", SCENE)].map(|path| path.display().to_string());
    for (name, expected) in
        [("a.pbrt", include_str!("scenes/expected.pbrt")), ("a.xml", include_str!("scenes/expected.xml"))]
    {
        printed(&["convert", &config, &scene, &folder.name(name)]);
        assert_eq!(String::from_utf8_lossy(&folder.read(name)), expected, "{name}");
    }
}

#[test]
fn a_sky_of_two_colours_is_a_picture_with_both_at_its_ends() {
    let folder = Folder::new();
    let colors = "background_dark_color: .25 .5 1\nbackground_light_color: 1 .75 0\n";
    let [config, scene] = [folder.write("c", colors), folder.write("s", "")].map(|path| path.display().to_string());
    for (name, [width, height], [top, bottom]) in
        [("a.pbrt", [512, 512], [256 * 512 + 256, 0]), ("a.xml", [4, 513], [0, 4 * 512])]
    {
        printed(&["convert", &config, &scene, &folder.name(name)]);
        let Ok(Any::Floats(sky)) = Any::read(&folder.file(format!("{name}.exr"))) else { panic!("{name}") };
        assert_eq!((sky.width, sky.height), (width, height));
        assert_eq!(sky.values[3 * top..][..3], [0.25, 0.5, 1.0], "{name}: above is the dark colour");
        assert_eq!(sky.values[3 * bottom..][..3], [1.0, 0.75, 0.0], "{name}: below is the light colour");
        // Over a half of the sphere, from the top or the bottom, the mean of a gradient by height is known.
        let red = |at: usize| f64::from(sky.values[3 * at]);
        let mean = if width == height {
            (0..width * height).map(red).sum::<f64>() / (width * height) as f64
        } else {
            red(4 * 256)
        };
        assert!((mean - 0.625).abs() < 1e-3, "{name}: {mean}");
    }
}

#[test]
fn what_has_no_match_is_listed_and_no_scene_of_another_program_is_read() {
    let folder = Folder::new();
    let [config, scene, other] = ["c.txt", "s.txt", "o.xml"].map(|name| folder.name(name));
    folder.write("c.txt", "gamma: 1\n\nray_rng_seed: 3");
    folder.write("s.txt", "metal: a 1 1 1 .5\nmatte: b 1 1 1\ncylinder: 0 0 0 2 0 1 0 a\n");
    let output = run(&["convert", &config, &scene, &other]);
    let said = String::from_utf8_lossy(&output.stderr).replace(&folder.name(""), "");
    assert!(
        output.status.success() && said.starts_with("c.txt:1: gamma has no match; left out\nc.txt:3: seeds"),
        "{said}"
    );
    assert!(said.contains("\ns.txt:1: diffusion and") && said.contains("\ns.txt:3: the normal of our"), "{said}");
    assert!(said.ends_with("o.xml.exr: holds the picture of the sky\n"), "{said}");
    folder.write("room.PBRT", "WorldBegin\nShape \"sphere\"\n");
    for from in [&other, &folder.name("room.PBRT")] {
        for outs in [&[&config, &scene][..], &[&folder.name("new.png")]] {
            let message =
                complaint(&[&["convert", from][..], &outs.iter().map(|out| &out[..]).collect::<Vec<_>>()].concat());
            let said = message.contains(&format!("{from}: render-lab writes scenes of pbrt and Mitsuba"));
            assert!(said && message.contains("render-lab help scene"), "{message}");
        }
    }
    assert!(Config::read(folder.file("c.txt").as_path()).is_ok_and(|config| config.gamma == 1.0), "it stays");
    // The first output is not changed if the second one cannot be written.
    assert!(complaint(&["convert", &config, &scene, "/nowhere/a.xml"]).contains("/nowhere/a.xml"));
    assert!(!folder.file("new.png").exists());
}
