//! Runs the program `shader-lab` as a user does.

mod documentation;
mod samples;
#[cfg(unix)]
mod unix;
mod watching;

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use gpu_check::shader_lab::TEMPLATE;
use shaders::Library;
use shaders::module::MODULES;
use test_support::folder::Folder;
use test_support::project_root;

use crate::common::{self, Accuracy};

/// Returns the command that renders a scene of the folder `scenes` into `out.png` with the configuration `config`.
fn command_for(scene: &str, config: &Path, folder: &Folder, arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_shader-lab"));
    command.current_dir(folder).args(arguments.split_whitespace()).arg("--config").arg(config);
    let scene = project_root().join("scenes").join(scene).join("scene.txt");
    command.arg("--scene").arg(scene).args(["--out", "out.png"]);
    command
}

/// Returns the command that renders a small picture of `scenes/materials`.
fn command(folder: &Folder, arguments: &str) -> Command {
    let config = folder.write("config.txt", "image_width: 48\nmax_depth: 8\n");
    command_for("materials", &config, folder, arguments)
}

fn run(folder: &Folder, arguments: &str) -> Output {
    command(folder, arguments).output().expect("the program starts")
}

fn report(folder: &Folder, arguments: &str) -> String {
    let output = run(folder, arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("it is text")
}

/// Returns what the program wrote to standard output and to standard error.
fn words(output: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr))
}

fn fault(folder: &Folder, arguments: &str) -> String {
    message(&run(folder, arguments))
}

/// Returns the message of a refusal. The line of clap's messages begins with a small letter.
fn message(output: &Output) -> String {
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!text.contains("XDG_RUNTIME_DIR"), "{text}");
    text[text.find("Error: ").or(text.find("error: ")).expect("a message starts so")..].to_owned()
}

fn standard(name: &str) -> String {
    Library::standard().source(name).expect("it exists").to_owned()
}

#[test]
fn an_unchanged_module_differs_in_no_bit_and_a_changed_one_does() {
    let accuracy = common::accuracy(&common::gpu());
    let folder = Folder::new();
    folder.write("background.wgsl", standard("background"));
    let precisions = if accuracy == Accuracy::Ieee { &["f64", "f32"][..] } else { &["f64"] };
    for precision in precisions {
        let text = report(&folder, &format!("background.wgsl --check --{precision}"));
        assert!(text.contains("background.wgsl stands in for [background]\n"), "{text}");
        assert!(text.contains(&format!("from the CPU in {precision}: 0 of 1296 pixels differ, RMSE 0.0e0")), "{text}");
    }
    let text = report(&folder, "background.wgsl --first-difference");
    assert!(text.ends_with("no pixel differs, so there is no first difference\n"), "{text}");
    folder.write("background.wgsl", standard("background").replace("direction.y", "direction.x"));
    let text = report(&folder, "background.wgsl");
    assert!(text.contains("of 1296 pixels differ") && !text.contains(": 0 of 1296"), "{text}");
    assert!(folder.file("out-difference.png").is_file());
    assert_eq!(run(&folder, "background.wgsl --check").status.code(), Some(1));
}

#[test]
fn f64_is_calculated_as_written_by_integers_or_as_the_driver_likes() {
    common::gpu();
    let folder = Folder::new();
    // Drivers cancel the large number, unless they may not; integers never do.
    let changed = standard("background").replace(
        "let m = ",
        "let one = (1e10lf + direction.y) - 1e10lf;\n    let m = select(0.0lf, 1e-9lf, one == direction.y) + ",
    );
    folder.write("background.wgsl", changed);
    let lines = ["", " --integers", " --as-driver-likes"].map(|option| {
        let text = report(&folder, &format!("background.wgsl{option}"));
        let line = text.lines().find(|line| line.starts_with("from the CPU in f64")).expect("it compares").to_owned();
        (text.lines().next().expect("there is a first line").to_owned(), line)
    });
    assert!(lines[0].0.ends_with(", as written"), "{lines:?}");
    assert!(lines[1].0.ends_with(", f32 as written, f64 by integers"), "{lines:?}");
    assert!(lines[2].0.ends_with(", as the driver likes"), "{lines:?}");
    assert_eq!(lines[0].1, lines[1].1, "as written and by integers are the same arithmetic");
    assert_ne!(lines[0].1, lines[2].1, "this driver rewrites nothing");
}

#[test]
fn the_template_gives_a_picture_of_normals_and_is_never_written_over() {
    let folder = Folder::new();
    let template = || {
        let mut command = Command::new(env!("CARGO_BIN_EXE_shader-lab"));
        command.current_dir(&folder).args(["--template", "my.wgsl"]).output().expect("the program starts")
    };
    assert!(template().status.success());
    assert_eq!(fs::read_to_string(folder.file("my.wgsl")).expect("it was written"), TEMPLATE);
    assert!(report(&folder, "my.wgsl").contains("my.wgsl stands in for [kernels/image]"));
    let again = message(&template());
    assert!(again.starts_with("Error: my.wgsl: "), "{again}");
}

#[test]
fn an_unknown_module_is_shown_with_its_place_and_all_known_ones() {
    let folder = Folder::new();
    let shown = "\n1 | // module: kernels/imgae\n               ^^^^^^^^^^^^^\n";
    // If the unknown name is the name of the file, there is no line to show.
    for (name, text, start, end) in [
        ("my.wgsl", "// module: kernels/imgae\n", "my.wgsl:1:12: no module is called [kernels/imgae]; ", shown),
        ("torus.wgsl", "fn f() {}\n", "torus.wgsl: no module is called [torus], as the file is; ", "\n"),
    ] {
        folder.write(name, text);
        let message = fault(&folder, name);
        assert!(message.starts_with(&format!("Error: {start}")) && message.ends_with(end), "{message}");
        assert!(MODULES.iter().all(|module| message.contains(module.name)), "{message}");
    }
}

#[test]
fn a_module_or_an_option_that_cannot_be_used_is_refused() {
    common::gpu();
    let folder = Folder::new();
    let buffer = "\n@group(0) @binding(0) var<storage, read> mine: array<u32>;\n";
    let taken = TEMPLATE.replacen('\n', buffer, 1).replace("return n * real(0.5)", "return n * real(mine[0])");
    for (name, text, options, expected) in [
        ("sphere.wgsl", "fn nothing() {}\n", "", "\nsphere.wgsl:1: stands in for [sphere], and may lack a name"),
        ("my.wgsl", &taken, "", "my.wgsl:2:23: the module that this file replaces has no buffer @group(0) @binding(0)"),
        ("my.wgsl", TEMPLATE, "--set loudness=1", "no constant [loudness]; there are: "),
        ("my.wgsl", TEMPLATE, "--pixel 48 0", "--pixel: the picture has 48 x 27 pixels"),
        ("my.wgsl", TEMPLATE, "--integers --as-driver-likes", "'--as-driver-likes'"),
        ("my.wgsl", TEMPLATE, "--samples", "[kernels/samples], which does not use [kernels/image]"),
    ] {
        folder.write(name, text);
        let message = fault(&folder, &format!("{name} {options}"));
        assert!(message.contains(expected), "{message}");
        assert_eq!(message.contains("may lack a name"), name == "sphere.wgsl", "{message}");
    }
}

#[test]
fn constants_of_the_crate_and_of_the_user_are_set() {
    let folder = Folder::new();
    let own = TEMPLATE.replace("return n * real(0.5)", "return n * real(gain)");
    folder.write("my.wgsl", format!("{own}override gain: f32 = 0.5;\n"));
    let plain = report(&folder, "my.wgsl");
    let set = report(&folder, "my.wgsl --set gain=0.1 --set has_cylinders=false");
    let line = |text: &str| text.lines().find(|line| line.starts_with("from the CPU")).map(str::to_owned);
    assert!(line(&plain).is_some() && line(&plain) != line(&set), "{plain}{set}");
}

#[test]
fn a_scene_of_many_objects_and_a_path_in_it_take_runs_that_end_in_time() {
    let folder = Folder::new();
    folder.write("background.wgsl", standard("background"));
    let config = fs::read_to_string(project_root().join("scenes/ten-thousand/config.txt")).expect("it is there");
    let config = folder.write("few", config + "image_width: 64\n");
    // Each run takes as long as a run of the whole picture.
    let mut command = command_for("ten-thousand", &config, &folder, "background.wgsl --check --pixel 32 24");
    let output = command.output().expect("the program starts");
    let text = words(&output);
    assert_eq!(output.status.code(), Some(0), "{text}");
    assert!(text.contains(": 0 of 2304 pixels differ"), "{text}");
    assert!(text.contains("\nno bit differs\ncolour\n  red  "), "{text}");
}
