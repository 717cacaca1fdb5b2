//! Tests with scenes that were written by hand, and with damaged ones.

use std::fs;

use cpu::internals::math::vec3::Vec3;
use test_support::folder::Folder;

use super::complete::complete;
use super::world::World;
use super::{mitsuba, pbrt};

/// Reads a file of this name and text in `folder`, which gets `inner.pbrt` too. Returns the configuration, the scene
/// and the notes, or the message of the fault.
fn read_in(folder: &Folder, name: &str, text: &[u8]) -> Result<(String, String, Vec<String>), String> {
    // To replace a file that is kept would wait for the disk.
    let _ = fs::remove_file(folder.file(name)).and_then(|()| fs::remove_file(folder.file("inner.pbrt")));
    let path = folder.write(name, text);
    folder.write("inner.pbrt", "Translate 0 0 1\nShape \"sphere\"\nShape \"curve\"\n");
    let mut world = World::default();
    let reader = if name.ends_with(".pbrt") { pbrt::read } else { mitsuba::read };
    let plain = |text: &str| text.replace(&format!("{}/", folder.path().display()), "");
    match reader(&path, &mut world).and_then(|()| complete(&mut world)) {
        Ok(()) => {
            let notes = world.notes.to_lines().iter().map(|line| plain(line)).collect();
            Ok((generator::write::config(&world.config), generator::write::scene(&world.scene), notes))
        }
        Err(fault) => Err(plain(&world.notes.failure(fault).message().unwrap_or_default())),
    }
}

fn read(name: &str, text: &[u8]) -> Result<(String, String, Vec<String>), String> {
    read_in(&Folder::new(), name, text)
}

const PBRT: &str = include_str!("tests/scene.pbrt");
const MITSUBA: &str = include_str!("tests/scene.xml");

#[test]
fn a_scene_of_pbrt_is_read_with_notes_on_what_has_no_match() {
    let (config, scene, notes) = read("a.pbrt", PBRT.as_bytes()).expect("it is a scene");
    assert!(config.starts_with("aspect_ratio: 3 4\nimage_width: 300\n"), "{config}");
    // The field of view is that of the shorter side, and the upright picture is 4/3 as high as wide.
    let fov = 2.0 * (4.0 / 3.0 * 22.5_f64.to_radians().tan()).atan().to_degrees();
    assert!(config.contains(&format!("field_of_view: {fov}\nsamples_per_pixel: 6\nmax_depth: 8\n")), "{config}");
    assert!(config.contains("position: -1 2 -5\ncamera_target: 0 0.5 0\ncamera_north: 0 1 0\n"), "{config}");
    assert!(config.contains("dark_color: 0.5 0.25 1\nbackground_light_color: 0.5 0.25 1\n"), "{config}");
    assert_eq!(
        scene,
        "matte: m0 0.9 0.1 0.1\nrefractive: m1 1.25\nmatte: m2 0.5 0.5 0.5\nmatte: m3 0.25 0.5 1\n\
         sphere: -2 0 0 1 m0\nsphere: -2 0 0 4 m0\ncylinder: -2.5 0 0 1 -3 0 0 m1\n\
         cylinder: -2 0 0 1 0 0 4 m1\nsphere: 0 0 1 1 m2\n"
    );
    let expected = [
        "a.pbrt:3: [lensradius] of Camera perspective has no match; left out",
        "a.pbrt:9: LightSource point has no match; left out",
        "a.pbrt:10: matte and diffuse scatter by different rules; they agree with render --scatter published \
         (also line 31)",
        "a.pbrt:11: refractive lets all light through, and dielectric reflects a part (Fresnel)",
        "a.pbrt:17: [zmax] of Shape sphere has no match; left out",
        "a.pbrt:19: a scale that is not equal along all axes has no match; its mean is taken",
        "a.pbrt:30: Texture has no match; left out",
        "a.pbrt:31: texture [reflectance] has no match; 0.5 takes its place",
        "inner.pbrt:3: Shape curve has no match; left out",
        "a.pbrt:33: Material coateddiffuse has no match; metal, refractive or matte of its colour takes its place",
        "a.pbrt:33: a colour is limited to the range from 0 to 1",
        "a.pbrt:34: Shape trianglemesh has no match; left out",
        "a.pbrt:35: ObjectBegin has no match; left out",
        "a.pbrt:36: ObjectInstance has no match; left out",
        "a.pbrt:28: an open cylinder has no match; ours, with two caps, takes its place",
        "a.pbrt:26: a disk that closes no cylinder has no match; left out",
        "a.pbrt:3: left and right of the picture are swapped as against ours; all x are negated",
    ];
    assert_eq!(notes, expected);
}

#[test]
fn a_scene_of_mitsuba_is_read_with_notes_on_what_has_no_match() {
    let (config, scene, notes) = read("a.xml", MITSUBA.as_bytes()).expect("it is a scene");
    assert!(config.starts_with("aspect_ratio: 2 1\nimage_width: 200\n"), "{config}");
    let parsed = cpu::Config::parse(config.as_bytes()).expect("it is valid");
    let fov = 2.0 * (0.5 * 30_f64.to_radians().tan()).atan().to_degrees();
    let [position, target] = [[-4.0, 0.0, 0.0], [-3.0, 0.0, 0.0]].map(|[x, y, z]| Vec3::new(x, y, z));
    assert!((parsed.field_of_view - fov).abs() < 1e-12, "{config}");
    assert!((parsed.camera_position - position).length() < 1e-12, "{config}");
    assert!((parsed.camera_target - target).length() < 1e-12, "{config}");
    assert!(config.contains("samples_per_pixel: 9\nmax_depth: 100\n"), "{config}");
    assert!(config.ends_with("color: 1 0 0\n"), "{config}");
    assert_eq!(
        scene,
        "metal: m0 1 0.78 0.34 0\nmetal: m1 1 1 1 0.5\nmatte: m2 0.5 0.5 0.5\nsphere: 1 0 0 1 m0\n\
         cylinder: 0 2 1 1 0 2 0 m1\n"
    );
    let expected = [
        "a.xml:25: <texture> in <scene> has no match; left out",
        "a.xml:3: an unlimited depth has no match; 100 is taken",
        "a.xml:14: <medium> in <shape> has no match; left out",
        "a.xml:14: a <ref> to something else than a bsdf has no match; left out",
        "a.xml:17: diffusion and roughness blur by different rules; the diffusion is taken as 2 alpha",
        "a.xml:21: <emitter> in <shape> has no match; left out",
        "a.xml:23: shape obj has no match; left out",
        "a.xml:15: an open cylinder has no match; ours, with two caps, takes its place",
        "a.xml:19: a disk that closes no cylinder has no match; left out",
    ];
    assert_eq!(notes, expected);
}

/// Checks the notes or the message of the fault for each text in `cases.txt`. A line of it has the name of a file, its
/// text with `\\n` for line ends, and the start of a note or of the message. A text for Mitsuba is put into a scene.
#[test]
fn losses_are_noted_and_wrong_files_are_refused_with_the_line_and_a_remedy() {
    for case in include_str!("tests/cases.txt").lines() {
        let [name, text, expected] = case.split(" => ").collect::<Vec<_>>()[..] else { panic!("{case}") };
        let text = text.replace("\\n", "\n");
        let is_part = name == "a.xml" && !["<scene>", "<!DOCTYPE", "<a/>"].iter().any(|tag| text.starts_with(tag));
        let text = if is_part { format!("<scene>\n{text}\n</scene>") } else { text };
        let said = read(name, text.as_bytes()).map_or_else(|message| vec![message], |(_, _, notes)| notes);
        assert!(said.iter().any(|said| said.starts_with(expected)), "{case}: {said:?}");
    }
}

#[test]
fn what_is_left_out_is_not_used() {
    let scene = "<scene><emitter type='constant'><float name='scale' value='.5'/><integer name='radiance' value='1'/>
         </emitter><shape type='cylinder'/><shape type='disk'><float name='radius' value='3'/></shape>
         <shape type='disk'><transform name='to_world'><translate z='1'/></transform></shape></scene>";
    let (config, _, notes) = read("a.xml", scene.as_bytes()).expect("it is a scene");
    assert!(config.ends_with("light_color: 1 1 1\n"), "{config}");
    assert!(["closes", "integer"].iter().all(|word| !notes.join("\n").contains(word)), "{notes:?}");
}

#[test]
fn damaged_files_give_a_scene_or_an_error_and_no_panic() {
    let folder = Folder::new();
    let mut scenes = 0;
    for (name, text) in [("a.pbrt", PBRT), ("a.xml", MITSUBA)] {
        for at in (0..text.len()).step_by(3) {
            let mut variants = vec![text.as_bytes()[..at].to_vec(), text.as_bytes()[at..].to_vec()];
            for byte in [b'0', b'-', b'"', 0xff] {
                let mut damaged = text.as_bytes().to_vec();
                damaged[at] = byte;
                variants.push(damaged);
            }
            for variant in variants {
                let Ok((config, scene, _)) = read_in(&folder, name, &variant) else { continue };
                // What is read is valid.
                cpu::Config::parse(config.as_bytes()).unwrap_or_else(|error| panic!("{at}: {error}"));
                cpu::Scene::parse(scene.as_bytes()).unwrap_or_else(|error| panic!("{at}: {error}"));
                scenes += 1;
            }
        }
    }
    assert!(scenes > 700, "only {scenes} damaged files are scenes");
    // The tree of a deep file is no deep recursion.
    let deep = format!("<scene>{}{}</scene>", "<bsdf type='twosided'>".repeat(100_000), "</bsdf>".repeat(100_000));
    assert!(read("a.xml", deep.as_bytes()).is_err());
}
