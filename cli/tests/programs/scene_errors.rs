//! Tests of every message that a scene can cause (specification, section 4.3).

use crate::bench::{Bench, SMALL};

const MATERIALS: &str = "matte: mat1 0 0.8 0.8\r\nmetal: metal1 0 0.8 0 2.0\n\nrefractive: ref99 1.3\n";

/// Checks that both programs refuse `line` with `message`, when it follows the definitions of the materials.
fn refuses(line: &str, message: &str) {
    Bench::new(SMALL, format!("{MATERIALS}{line}\nnever read")).refuses(message.as_bytes());
}

#[test]
fn unknown_entities() {
    refuses("triangle: 1 2 3", "Unknown scene entity: triangle");
    refuses("triangle", "Unknown scene entity: triangle");
    refuses("sphere 0 0 0 1 mat1", "Unknown scene entity: sphere");
    refuses("Sphere: 0 0 0 1 mat1", "Unknown scene entity: Sphere");
}

#[test]
fn parameters_that_are_missing_unreadable_or_out_of_range() {
    let cases = [
        ("matte material", "matte: new 0 0.8 "),
        ("matte material", "matte: new 0 0.8 1.01"),
        ("matte material", "matte: new 0 -0.1 1"),
        ("matte material", "matte:"),
        ("metal material", "metal: new 0 0.8 0"),
        ("metal material", "metal: new 0 0.8 0 -2"),
        ("metal material", "metal: new 0 0.8 2 1"),
        ("refractive material", "refractive: new"),
        ("refractive material", "refractive: new 0"),
        ("refractive material", "refractive: new -1.3"),
        ("sphere", "sphere: 0 0 0 0.65"),
        ("sphere", "sphere: 0 0 0 0 mat1"),
        ("sphere", "sphere: 0 0 0 -1 mat1"),
        ("sphere", "sphere: 0 0 mat1"),
        ("sphere", "sphere: 0 0 0 1e999 mat1"),
        ("cylinder", "cylinder: 0 0 0 0.5 20 10 mat1"),
        ("cylinder", "cylinder: 0 0 0 0 20 10 -5 mat1"),
        ("cylinder", "cylinder: 0 0 0 0.5 0 0 0 mat1"),
        ("cylinder", "cylinder: 0 0 0 0.5 20 10 -5"),
        ("cylinder", "cylinder: 0 0 0 0.5 1e-200 0 0 mat1"),
        ("cylinder", "cylinder: 0 0 0 0.5 1e200 0 0 mat1"),
    ];
    for (entity, line) in cases {
        refuses(line, &format!("Invalid {entity} parameters\nLine: \"{line}\""));
    }
}

#[test]
fn extra_data_shows_the_rest_and_the_line() {
    let lines = [
        "matte: new 0 0 0",
        "metal: new 0 0 0 1",
        "refractive: new 1",
        "sphere: 0 0 0 0.65 mat1",
        "cylinder: 0 0 0 0.5 20 10 -5 mat1",
    ];
    for line in lines {
        let tag = line.split(' ').next().expect("the line has a tag");
        let line = format!("{line}  3 x ");
        let extra = "Extra data after configuration value for key:";
        refuses(&line, &format!("{extra} [{tag}]\nExtra: \"3 x\"\nLine: \"{line}\""));
    }
}

#[test]
fn materials_must_have_new_names() {
    for line in ["matte: mat1 0 0.8 0.8", "metal: ref99 0 0.8 0.8 1", "refractive: metal1 1.5"] {
        let name = line.split(' ').nth(1).expect("the line has a name");
        refuses(line, &format!("Material with name [{name}] already exists\nLine: \"{line}\""));
    }
}

#[test]
fn objects_must_be_made_of_a_material_defined_above() {
    for line in ["cylinder: 0 0 0 0.5 20 10 -5 metal12", "sphere: 0 0 0 1 metal12"] {
        let message = format!("Material not found: [metal12]\nLine: \"{line}\"");
        refuses(line, &message);
        refuses(&format!("{line}\nmatte: metal12 0 0 0"), &message);
    }
}

#[test]
fn parameters_come_before_extra_data_and_extra_data_before_names() {
    refuses("sphere: 0 0 0 a nowhere 3", "Invalid sphere parameters\nLine: \"sphere: 0 0 0 a nowhere 3\"");
    let line = "sphere: 0 0 0 1 nowhere 3";
    let extra = "Extra data after configuration value for key: [sphere:]\nExtra: \"3\"";
    refuses(line, &format!("{extra}\nLine: \"{line}\""));
    let line = "matte: mat1 0 0 0 3";
    let extra = "Extra data after configuration value for key: [matte:]\nExtra: \"3\"";
    refuses(line, &format!("{extra}\nLine: \"{line}\""));
}
