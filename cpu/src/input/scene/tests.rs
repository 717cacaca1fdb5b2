//! Tests lines that are read, and every fault of a line.

use crate::input::scene::*;

const MATERIALS: &str = "matte: mat1 0 0.8 0.8\nmetal: metal1 0 0.8 0 2.0\nrefractive: ref99 1.3\n";

fn parse(text: &str) -> Result<Scene, Error> {
    Scene::parse(text.as_bytes())
}

fn message(text: &str) -> String {
    parse(text).expect_err("the text is invalid").to_string()
}

#[test]
fn the_statements_first_listing_is_read() {
    let scene = parse(&format!("{MATERIALS}sphere: 0 0 0 0.65 mat1\r\n\ncylinder:\t0 0 0 0.5 20 10 -5 metal1 "))
        .expect("the listing is valid");
    let reflectance = Vec3::new(0.0, 0.8, 0.8);
    assert_eq!(
        scene.materials,
        [
            Material::Matte { reflectance },
            Material::Metal { reflectance: Vec3::new(0.0, 0.8, 0.0), diffusion: 2.0 },
            Material::Refractive { index: 1.3 },
        ]
    );
    let sphere = Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 0.65 });
    let axis = Vec3::new(20.0, 10.0, -5.0);
    let cylinder = Shape::Cylinder(Cylinder { center: Vec3::ZERO, radius: 0.5, axis });
    let expected = [Object { shape: sphere, material: 0 }, Object { shape: cylinder, material: 1 }];
    assert_eq!(scene.objects, expected);
}

#[test]
fn a_metal_may_be_without_diffusion() {
    let scene = parse("metal: m 0 .5 1 0").expect("nought is allowed");
    assert_eq!(scene.materials, [Material::Metal { reflectance: Vec3::new(0.0, 0.5, 1.0), diffusion: 0.0 }]);
}

#[test]
fn materials_in_use_are_those_of_objects_each_once() {
    let scene = parse(&format!("{MATERIALS}sphere: 0 0 0 1 ref99\nsphere: 0 0 0 1 mat1\nsphere: 0 0 0 2 ref99\n"));
    let scene = scene.expect("the text is valid");
    let in_use = scene.materials_in_use().expect("two materials fit");
    assert_eq!(in_use, [scene.materials[0], scene.materials[2]]);
}

#[test]
fn a_file_is_read_as_its_text_is() {
    let path = std::env::temp_dir().join(format!("render-scene-{}", std::process::id()));
    let text = format!("{MATERIALS}sphere: 0 0 0 1 mat1\n");
    std::fs::write(&path, &text).expect("the temporary folder is writable");
    let scene = Scene::read(&path);
    std::fs::remove_file(&path).expect("it is there");
    assert_eq!(scene.expect("the text is valid"), parse(&text).expect("the text is valid"));
}

#[test]
fn an_empty_scene_is_a_scene() {
    assert_eq!(parse("").ok(), Some(Scene::default()));
    assert_eq!(parse(" \t \r\n\n").ok(), Some(Scene::default()));
}

#[test]
fn unknown_entities_are_named_without_a_colon() {
    assert_eq!(message("triangle: 1 2 3"), "Unknown scene entity: triangle");
    assert_eq!(message("sphere 0 0 0 1 m"), "Unknown scene entity: sphere");
}

#[test]
fn invalid_parameters_show_the_line_with_its_trailing_blanks() {
    let cases = [
        ("matte material", "matte: mat1 0 0.8 "),
        ("matte material", "matte:"),
        ("matte material", "matte: m 0 0.8 1.1"),
        ("metal material", "metal: m 0 0 0"),
        ("metal material", "metal: m 0 0 0 -1"),
        ("refractive material", "refractive: m 0"),
        ("refractive material", "refractive: m"),
        ("sphere", "sphere: 0 0 0 a mat1 3"),
        ("sphere", "sphere: 0 0 0 0 mat1"),
        ("sphere", "sphere: 0 0 0 1"),
        ("cylinder", "cylinder: 0 0 0 1 0 0 0 mat1"),
        ("cylinder", "cylinder: 0 0 0 -1 0 1 0 mat1"),
        ("cylinder", "cylinder: 0 0 0 1 1e200 0 0 mat1"),
        ("cylinder", "cylinder: 0 0 0 1 0 1 mat1"),
    ];
    for (entity, line) in cases {
        assert_eq!(message(line), format!("Invalid {entity} parameters\nLine: \"{line}\""));
    }
}

#[test]
fn extra_data_comes_before_names() {
    let line = "sphere: 0 0 0 0.65 nowhere 3";
    let expected = format!("Extra data after configuration value for key: [sphere:]\nExtra: \"3\"\nLine: \"{line}\"");
    assert_eq!(message(line), expected);
    let line = "matte: mat1 0 0.8 0.8  4 5 ";
    let expected = format!("Extra data after configuration value for key: [matte:]\nExtra: \"4 5\"\nLine: \"{line}\"");
    assert_eq!(message(&format!("{MATERIALS}{line}")), expected);
}

#[test]
fn names_must_be_new_for_materials_and_known_for_objects() {
    let line = "matte: mat1 0 0.8 0.8";
    let expected = format!("Material with name [mat1] already exists\nLine: \"{line}\"");
    assert_eq!(message(&format!("{MATERIALS}{line}")), expected);
    let line = "cylinder: 0 0 0 0.5 20 10 -5 metal12";
    let expected = format!("Material not found: [metal12]\nLine: \"{line}\"");
    assert_eq!(message(&format!("{MATERIALS}{line}")), expected);
}

#[test]
fn any_bytes_may_be_a_name() {
    let scene = Scene::parse(&b"matte: \xff\0 0 0 0\nsphere: 0 0 0 1 \xff\0"[..]);
    assert_eq!(scene.map(|scene| scene.objects.len()).ok(), Some(1));
}

#[test]
fn a_folder_is_not_a_scene() {
    let error = Scene::read(Path::new("/")).expect_err("a folder cannot be read");
    assert!(error.to_string().starts_with("Cannot read file [/]: "), "{error}");
}

#[test]
fn names_of_materials_are_read_up_to_their_limit_and_refused_beyond_it() {
    const LENGTH: usize = 1 << 19;
    const COUNT: usize = MAX_NAME_BYTES / LENGTH;

    let mut parser = Parser::default();
    let mut read = |name: &str| parser.read_line(format!("refractive: {name} 1").as_bytes());
    for number in 0..COUNT {
        let name = format!("{number:08}") + &"x".repeat(LENGTH - 8);
        read(&name).expect("the names are within the limit");
    }
    let error = read("a").expect_err("the names are longer by one byte").in_file(Path::new("scene.txt"));
    let expected = format!("line {}: the names of all materials are longer than 268435456 bytes", COUNT + 1);
    assert_eq!(error.to_string(), format!("Cannot read file [scene.txt]: {expected}; shorten them"));
    assert_eq!(parser.scene.materials.len(), COUNT);
}
