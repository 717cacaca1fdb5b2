//! Tests with scenes that were written by hand, and with damaged ones.

use std::fs;

use test_support::folder::Folder;

use super::complete::complete;
use super::world::World;
use super::{mitsuba, pbrt};

/// Reads a file of this name and text in `folder`, which gets `inner.pbrt` too. Returns the configuration, the scene
/// and the notes, or the message of the fault.
fn read_in(folder: &Folder, name: &str, text: &[u8]) -> Result<(String, String, Vec<String>), String> {
    let path = folder.file(name);
    // To replace a file that is kept would wait for the disk.
    let _ = fs::remove_file(&path).and_then(|()| fs::remove_file(folder.file("inner.pbrt")));
    fs::write(&path, text).expect("the folder is writable");
    fs::write(folder.file("inner.pbrt"), "Translate 0 0 1\nShape \"sphere\"\nShape \"curve\"\n").expect("it is");
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

const PBRT: &str = r#"# A camera without a mirror, so all x are negated.
LookAt 1 2 -5  0 .5 0  0 1 0
Camera "perspective" "float fov" [ 45 ] "float lensradius" .1
Film "rgb" "integer xresolution" 300 "integer yresolution" [ 400 ]
Sampler "stratified" "integer xsamples" 2 "integer ysamples" 3
Integrator "volpath" "integer maxdepth" [ 7 ]
WorldBegin
LightSource "infinite" "rgb L" [ .5 .25 1 ]
LightSource "point" "point3 from" [ 0 9 0 ]
MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [ .9 .1 .1 ]
Material "dielectric" "float eta" 1.25 # glass
AttributeBegin
  Translate 2 0 0
  Scale 2 2 2
  CoordinateSystem "two"
  NamedMaterial "red"
  Shape "sphere" "float radius" .5 "float zmax" .25
  Scale 1 1 8
  Shape "sphere"
AttributeEnd
TransformBegin
  ConcatTransform [ 0 1 0 0  0 0 1 0  1 0 0 0  1 0 0 1 ]
  Shape "cylinder" "float zmin" 0 "float zmax" 3
  Shape "disk" "float height" 3
  Shape "disk"
  Shape "disk" "float height" 7
TransformEnd
CoordSysTransform "two" Shape "cylinder" "float radius" 0.5
Identity
Texture "t" "spectrum" "imagemap" "string filename" "t.png"
Material "diffuse" "texture reflectance" "t"
Include "inner.pbrt"
Material "coateddiffuse" "rgb reflectance" [ .25 .5 2 ]
Shape "trianglemesh" "point3 P" [ 0 0 0  1 0 0  0 1 0 ]
ObjectBegin "o" Shape "sphere" ObjectEnd
ObjectInstance "o"
"#;

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

const MITSUBA: &str = r##"<scene version="3.0.0">
<default name="fov" value="60"/><default name="fov" value="70"/><default name="y" value="1"/>
<integrator type="path"/>
<sensor type="perspective">
  <float name="fov" value="$fov"/>
  <transform name="to_world">
    <translate z="-4"/>
    <rotate y="1" angle="90"/>
  </transform>
  <film type="hdrfilm"><integer name="width" value="200"/><integer name="height" value="100"/></film>
  <sampler type="multijitter"><integer name="sample_count" value="9"/></sampler>
</sensor>
<emitter type="constant"><rgb name="radiance" value="#ff0000"/></emitter>
<shape type="sphere"><ref id="gold"/><ref name="interior" id="fog"/><point name="center" x="1"/><medium type="homogeneous" name="interior"/></shape>
<shape type="cylinder">
  <point name="p0" value="0, $y, 0$y"/><point name="p1" value="0 3 1"/>
  <bsdf type="twosided"><bsdf type="roughconductor"><float name="alpha" value=".25"/></bsdf></bsdf>
</shape>
<shape type="disk">
  <transform name="to_world"><rotate x="1" angle="90"/><translate value="0 3 1"/></transform>
  <emitter type="area"/>
</shape>
<shape type="obj"><string name="filename" value="a b.obj"/></shape>
<bsdf type="conductor" id="gold"><string name="material" value="Au"/></bsdf>
<texture type="bitmap" id="t"/>
</scene>
"##;

#[test]
fn a_scene_of_mitsuba_is_read_with_notes_on_what_has_no_match() {
    let (config, scene, notes) = read("a.xml", MITSUBA.as_bytes()).expect("it is a scene");
    assert!(config.starts_with("aspect_ratio: 2 1\nimage_width: 200\n"), "{config}");
    let number = |key: &str| {
        let values = config.lines().find_map(|line| line.strip_prefix(key)).expect("it is there");
        values.split(' ').map(|value| value.parse().expect("it is a number")).collect::<Vec<f64>>()
    };
    let is_near = |key, expected: &[f64]| {
        let found = number(key);
        assert!(found.iter().zip(expected).all(|(one, other)| (one - other).abs() < 1e-12), "{key} {found:?}");
    };
    is_near("field_of_view: ", &[2.0 * (0.5 * 30_f64.to_radians().tan()).atan().to_degrees()]);
    is_near("camera_position: ", &[-4.0, 0.0, 0.0]);
    is_near("camera_target: ", &[-3.0, 0.0, 0.0]);
    assert!(
        config.contains("samples_per_pixel: 9\nmax_depth: 100\n") && config.ends_with("color: 1 0 0\n"),
        "{config}"
    );
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

/// Returns the name of a file, its text and the expected message of each line of `table`: these three, separated by ` => `.
/// A text for Mitsuba is put into a scene. Its line ends are written as `\n`.
fn rows(table: &str) -> impl Iterator<Item = [String; 3]> {
    let row = |line: &str| {
        let [name, text, expected] = line.split(" => ").collect::<Vec<_>>()[..] else { panic!("{line}") };
        let text = text.trim().replace("\\n", "\n");
        let is_part =
            name.ends_with(".xml") && !["<scene>", "<!DOCTYPE", "<a/>"].iter().any(|tag| text.starts_with(tag));
        let text = if is_part { format!("<scene>\n{text}\n</scene>") } else { text };
        [name.trim().to_owned(), text, expected.to_owned()]
    };
    table.trim().lines().map(row)
}

const LOSSES: &str = r##"
a.pbrt => \nCamera "perspective"\nCamera "perspective" => a.pbrt:2: another camera follows this one, which is left out
a.pbrt => Camera "perspective"\n"float screenwindow" [2 -2 1 -1] => a.pbrt:2: [screenwindow] is not symmetrical, or it is
a.pbrt => Camera "perspective"\n"float screenwindow" [-1 3 -1 1] => a.pbrt:2: [screenwindow] is not symmetrical, or it is
a.pbrt => \nCamera "perspective" "float screenwindow" [-1 1 -1 1] => a.pbrt:2: [screenwindow] is not as wide as the pict
a.pbrt => Camera "realistic"\n"string lensfile" "a" => a.pbrt:2: [lensfile] of Camera realistic has no match; left out
a.pbrt => Camera "perspective"\nMaterial "conductor" "texture roughness" "t" => a.pbrt:2: texture [roughness] has no match; 0
a.xml => <sensor type='perspective'/>\n<sensor type='thinlens'/> => a.xml:3: a sensor that is not
a.xml => <sensor type='perspective'/>METAL => a.xml:2: the metal [Cr] has no match
a.xml => <sensor type='perspective'/><bsdf type='twosided'>METAL\nMETAL</bsdf> => a.xml:3: a second bsdf in a twosided one
a.xml => <sensor type='perspective'/><bsdf type='roughconductor'>\nTEXTURE</bsdf> => a.xml:3: texture [alpha] has no match; 0.1
"##;

#[test]
fn nothing_is_lost_without_a_note() {
    let metal = "<bsdf type='conductor'><string name='material' value='Cr'/></bsdf>";
    let losses = LOSSES.replace("METAL", metal).replace("TEXTURE", "<texture type='bitmap' name='alpha'/>");
    for [name, text, expected] in rows(&losses) {
        let (_, _, notes) = read(&name, text.as_bytes()).expect(&text);
        assert!(notes.iter().any(|note| note.starts_with(&expected)), "{notes:?}");
    }
    // What is left out is not used.
    let scene = "<scene><emitter type='constant'><float name='scale' value='.5'/><integer name='radiance' value='1'/>
         </emitter><shape type='cylinder'/><shape type='disk'><float name='radius' value='3'/></shape>
         <shape type='disk'><transform name='to_world'><translate z='1'/></transform></shape></scene>";
    let (config, _, notes) = read("a.xml", scene.as_bytes()).expect("it is a scene");
    assert!(config.ends_with("light_color: 1 1 1\n"), "{config}");
    assert!(["closes", "integer"].iter().all(|word| !notes.join("\n").contains(word)), "{notes:?}");
}

const FAULTS: &str = r##"
a.pbrt => WorldBegin\nShape "sphere" "float radius" 1e999 => a.pbrt:2: [1e999] is not a finite number; write
a.pbrt => Translate 1 nan 0 => a.pbrt:1: [nan] is not
a.pbrt => \n\nShape "sphere => a.pbrt:3: a text begins here; close it
a.pbrt => Shape "sphere" "radius" 1 => a.pbrt:1: [radius] is no parameter; write a type
a.pbrt => Shape "sphere" "float radius" [ 1 => a.pbrt:1: the file ends here
a.pbrt => Shape "sphere" "float radius" -1 => a.pbrt:1: Shape sphere needs a finite place
a.pbrt => AttributeBegin\nShape "sphere" => a.pbrt:2: the file ends here, and a AttributeBegin
a.pbrt => AttributeEnd => a.pbrt:1: no AttributeBegin
a.pbrt => CoordSysTransform "world" => a.pbrt:1: CoordSysTransform: nothing of the name [world]
a.pbrt => \nInclude "none.pbrt" => a.pbrt:2: [none.pbrt] cannot be read
a.pbrt => Include "a.pbrt" => a.pbrt:1: more than 1000 files are included
a.pbrt => WorldBegin CoordSysTransform "world" Shape "curve" => a.pbrt:1: nothing in this file has a match
a.pbrt => LookAt 0 0 0 0 0 0 0 1 0\nCamera "perspective" => a.pbrt:2: the camera's position
a.pbrt => \nCamera "perspective" "float fov" 180 => a.pbrt:2: the field of view is 180 degrees
a.pbrt => Sampler "sobol"\n"integer pixelsamples" 3e9 => a.pbrt:2: [pixelsamples] must be one whole number, at least 1, and
a.pbrt => Material "dielectric"\n"float eta" 0 => a.pbrt:2: the refractive index must be a number above 0
a.xml => <scene>\n<shape></scene> => a.xml:2: this is not correct XML
a.xml => <!DOCTYPE x [<!ENTITY a "b">]><scene/> => a.xml:1: a document type is not supported
a.xml => <a/> => a.xml:1: the file is no scene of Mitsuba
a.xml => <shape type='sphere'><ref id='x'/></shape> => a.xml:2: no bsdf of the scene has the id [x]
a.xml => <shape type='$x'/> => a.xml:2: $x has no value; add <default name="x"
a.xml => <shape type='sphere'>\n<float name='radius' value='inf'/></shape> => a.xml:3: [inf] is
a.xml => <bsdf type='diffuse'>\n<rgb name='reflectance' value='#fff'/></bsdf> => a.xml:3: [reflectance] is no colour; write
a.xml => <shape/> => a.xml:2: <shape> needs the attribute type
"##;

#[test]
fn a_wrong_file_is_refused_with_its_line_and_a_remedy() {
    for [name, text, expected] in rows(FAULTS) {
        let message = read(&name, text.as_bytes()).expect_err(&text);
        assert!(message.starts_with(&expected), "{message}");
    }
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
