//! Input files that a program must refuse, with the exact message. The tests of `render-aos` and `render-soa` use this
//! table, and `render-lab check` holds any other program to it.

use crate::hint::Kind;

/// A wrong line of an input file.
#[derive(Clone, Copy, Debug)]
pub struct Refused {
    /// The file with the line.
    pub kind: Kind,
    /// The line, without a line end. In two cases a second line follows.
    pub line: &'static [u8],
    /// The message on standard error, without `Error: ` and without the line end.
    pub message: &'static [u8],
    /// Whether the statement says that the line is wrong. Other lines are wrong by the specification alone.
    pub is_stated: bool,
}

/// A configuration of 8 x 4 pixels, which is rendered quickly.
pub const SMALL: &str = "image_width: 8\naspect_ratio: 2 1\nsamples_per_pixel: 2\n";

/// The lines above the wrong line of a scene.
const MATERIALS: &str = "matte: mat1 0 0.8 0.8\nmetal: metal1 0 0.8 0 2.0\n\nrefractive: ref99 1.3\n";

impl Refused {
    /// Returns the contents of the configuration and the scene.
    #[must_use]
    pub fn files(&self) -> [Vec<u8>; 2] {
        match self.kind {
            Kind::Config => [[self.line, b"\n", SMALL.as_bytes()].concat(), Vec::new()],
            Kind::Scene => [SMALL.into(), [MATERIALS.as_bytes(), self.line, b"\nnever read"].concat()],
        }
    }

    /// Returns the section of the specification with the message.
    #[must_use]
    pub const fn section(&self) -> &'static str {
        match self.kind {
            Kind::Config => "3.4",
            Kind::Scene => "4.3",
        }
    }

    const fn not_stated(self) -> Self {
        Self { is_stated: false, ..self }
    }
}

const fn config(line: &'static str, message: &'static str) -> Refused {
    Refused { kind: Kind::Config, line: line.as_bytes(), message: message.as_bytes(), is_stated: true }
}

const fn scene(line: &'static str, message: &'static str) -> Refused {
    Refused { kind: Kind::Scene, ..config(line, message) }
}

/// All wrong lines.
pub const ALL: [Refused; 46] = [
    config("image_xwidth: 3", "Unknown configuration key: [image_xwidth:]"),
    config("width", "Unknown configuration key: [width:]"),
    config("# comment", "Unknown configuration key: [#:]"),
    config("image_width: 12.5", "Invalid value for key: [image_width:]\nLine: \"image_width: 12.5\"").not_stated(),
    config("image_width: 0", "Invalid value for key: [image_width:]\nLine: \"image_width: 0\""),
    config("aspect_ratio: nulo", "Invalid value for key: [aspect_ratio:]\nLine: \"aspect_ratio: nulo\""),
    config("aspect_ratio: 16 -9", "Invalid value for key: [aspect_ratio:]\nLine: \"aspect_ratio: 16 -9\""),
    config(" \taspect_ratio:  16 \t\r", "Invalid value for key: [aspect_ratio:]\nLine: \" \taspect_ratio:  16 \t\"")
        .not_stated(),
    config("gamma: 2.1 2.2 99", "Extra data after configuration value for key: [gamma:]\nExtra: \"2.2 99\""),
    config("gamma: 1\t 2.2 99 \t", "Extra data after configuration value for key: [gamma:]\nExtra: \"2.2 99\"")
        .not_stated(),
    config("gamma: x\nwidth", "Invalid value for key: [gamma:]\nLine: \"gamma: x\""),
    config("gamma: 0", "Invalid value for key: [gamma:]\nLine: \"gamma: 0\"").not_stated(),
    config("gamma: 2\0", "Invalid value for key: [gamma:]\nLine: \"gamma: 2\0\"").not_stated(),
    config("camera_position: 1 2", "Invalid value for key: [camera_position:]\nLine: \"camera_position: 1 2\""),
    config("camera_target: 1 2 z 3", "Invalid value for key: [camera_target:]\nLine: \"camera_target: 1 2 z 3\""),
    config("camera_north:", "Invalid value for key: [camera_north:]\nLine: \"camera_north:\""),
    config("field_of_view: 0", "Invalid value for key: [field_of_view:]\nLine: \"field_of_view: 0\""),
    config("field_of_view: 180", "Invalid value for key: [field_of_view:]\nLine: \"field_of_view: 180\""),
    config("samples_per_pixel: 0", "Invalid value for key: [samples_per_pixel:]\nLine: \"samples_per_pixel: 0\""),
    config("max_depth: -1", "Invalid value for key: [max_depth:]\nLine: \"max_depth: -1\""),
    config("material_rng_seed: 0", "Invalid value for key: [material_rng_seed:]\nLine: \"material_rng_seed: 0\""),
    config("ray_rng_seed: 1 2", "Extra data after configuration value for key: [ray_rng_seed:]\nExtra: \"2\""),
    config(
        "background_dark_color: 0 1.5 0",
        "Invalid value for key: [background_dark_color:]\nLine: \"background_dark_color: 0 1.5 0\"",
    ),
    config(
        "background_light_color: -.1 0 0",
        "Invalid value for key: [background_light_color:]\nLine: \"background_light_color: -.1 0 0\"",
    ),
    config("\u{feff}gamma: 2", "Unknown configuration key: [\u{feff}gamma:]").not_stated(),
    scene("triangle: 1 2 3", "Unknown scene entity: triangle"),
    scene("matte: new 0 0.8 ", "Invalid matte material parameters\nLine: \"matte: new 0 0.8 \""),
    scene("matte: new 0 0.8 1.1", "Invalid matte material parameters\nLine: \"matte: new 0 0.8 1.1\""),
    scene("metal: new 0 0.8 0", "Invalid metal material parameters\nLine: \"metal: new 0 0.8 0\""),
    scene("metal: new 0 0.8 0 -2", "Invalid metal material parameters\nLine: \"metal: new 0 0.8 0 -2\"").not_stated(),
    scene("refractive: new", "Invalid refractive material parameters\nLine: \"refractive: new\""),
    scene("refractive: new x", "Invalid refractive material parameters\nLine: \"refractive: new x\""),
    scene("sphere: 0 0 0 a x 3", "Invalid sphere parameters\nLine: \"sphere: 0 0 0 a x 3\""),
    scene("sphere: 0 0 0 0 mat1", "Invalid sphere parameters\nLine: \"sphere: 0 0 0 0 mat1\""),
    scene("cylinder: 0 0 0 -1 0 1 0 mat1", "Invalid cylinder parameters\nLine: \"cylinder: 0 0 0 -1 0 1 0 mat1\""),
    scene("cylinder: 0 0 0 1 0 1 mat1", "Invalid cylinder parameters\nLine: \"cylinder: 0 0 0 1 0 1 mat1\""),
    scene("cylinder: 0 0 0 1 0 0 0 m", "Invalid cylinder parameters\nLine: \"cylinder: 0 0 0 1 0 0 0 m\"").not_stated(),
    scene(
        "sphere: 0 0 0 0.65 mat1 3",
        "Extra data after configuration value for key: [sphere:]\nExtra: \"3\"\nLine: \"sphere: 0 0 0 0.65 mat1 3\"",
    ),
    scene(
        "sphere: 0 0 0 1 x  3 y ",
        "Extra data after configuration value for key: [sphere:]\nExtra: \"3 y\"\nLine: \"sphere: 0 0 0 1 x  3 y \"",
    )
    .not_stated(),
    scene(
        "matte: mat1 0 0 0 3",
        "Extra data after configuration value for key: [matte:]\nExtra: \"3\"\nLine: \"matte: mat1 0 0 0 3\"",
    )
    .not_stated(),
    scene(
        "refractive: r 1.5 2",
        "Extra data after configuration value for key: [refractive:]\nExtra: \"2\"\nLine: \"refractive: r 1.5 2\"",
    ),
    scene("matte: mat1 0 0.8 0.8", "Material with name [mat1] already exists\nLine: \"matte: mat1 0 0.8 0.8\""),
    scene("metal: ref99 0 0 0 1", "Material with name [ref99] already exists\nLine: \"metal: ref99 0 0 0 1\""),
    scene("sphere: 0 0 0 1 x\nmatte: x 0 0 0", "Material not found: [x]\nLine: \"sphere: 0 0 0 1 x\""),
    scene(
        "cylinder: 0 0 0 0.5 20 10 -5 metal12",
        "Material not found: [metal12]\nLine: \"cylinder: 0 0 0 0.5 20 10 -5 metal12\"",
    ),
    scene("\0ö", "Unknown scene entity: \0ö").not_stated(),
];
