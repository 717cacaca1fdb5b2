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

fn command(folder: &Path, arguments: &str) -> Command {
    let config = folder.join("config.txt");
    fs::write(&config, "image_width: 48\nmax_depth: 8\n").expect("the folder is writable");
    let mut command = Command::new(env!("CARGO_BIN_EXE_shader-lab"));
    command.current_dir(folder).args(arguments.split_whitespace()).arg("--config").arg(config);
    command.arg("--scene").arg(project_root().join("scenes/materials/scene.txt")).args(["--out", "out.png"]);
    command
}

fn run(folder: &Path, arguments: &str) -> Output {
    command(folder, arguments).output().expect("the program starts")
}

fn report(folder: &Path, arguments: &str) -> String {
    let output = run(folder, arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("it is text")
}

/// Returns what the program wrote to standard output and to standard error.
fn words(output: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr))
}

fn fault(folder: &Path, arguments: &str) -> String {
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
fn the_first_difference_names_the_function_the_line_and_the_number() {
    common::gpu();
    let folder = Folder::new();
    let path = folder.file("sphere.wgsl");
    let source = standard("sphere").replace("let near = (h - root) / a;", "let near = (h - root) * (real(1.0) / a);");
    fs::write(&path, &source).expect("the folder is writable");
    let text = report(folder.path(), "sphere.wgsl --first-difference");
    let line = |start: &str| source.lines().position(|line| line.trim().starts_with(start)).expect("it is there") + 1;
    let place =
        format!("first difference: the result of sphere_intersect, sphere.wgsl:{}\n", line("fn sphere_intersect"));
    assert!(text.contains(&place), "{text}");
    assert!(text.contains("  or of what it calls: sphere_first_root\n"), "{text}");
    assert!(text.contains("  result.lambda ") && text.contains("CPU   0 "), "{text}");
    assert!(text.ends_with(&format!("changed lines: sphere.wgsl:{}\n", line("let near"))), "{text}");
    fs::write(&path, standard("sphere")).expect("the folder is writable");
    let text = report(folder.path(), "sphere.wgsl --first-difference");
    assert!(text.ends_with("no pixel differs, so there is no first difference\n"), "{text}");
}

#[test]
fn an_unchanged_module_differs_in_no_bit_and_a_changed_one_does() {
    let accuracy = common::accuracy(&common::gpu());
    let folder = Folder::new();
    let path = folder.file("background.wgsl");
    fs::write(&path, standard("background")).expect("the folder is writable");
    let precisions = if accuracy == Accuracy::Ieee { &["f64", "f32"][..] } else { &["f64"] };
    for precision in precisions {
        let text = report(folder.path(), &format!("background.wgsl --check --{precision}"));
        assert!(text.contains("background.wgsl stands in for [background]\n"), "{text}");
        assert!(text.contains(&format!("from the CPU in {precision}: 0 of 1296 pixels differ, RMSE 0.0e0")), "{text}");
    }
    fs::write(&path, standard("background").replace("direction.y", "direction.x")).expect("the folder is writable");
    let text = report(folder.path(), "background.wgsl");
    assert!(text.contains("of 1296 pixels differ") && !text.contains(": 0 of 1296"), "{text}");
    assert!(folder.file("out-difference.png").is_file());
    assert_eq!(run(folder.path(), "background.wgsl --check").status.code(), Some(1));
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
    fs::write(folder.file("background.wgsl"), changed).expect("the folder is writable");
    let lines = ["", " --integers", " --as-driver-likes"].map(|option| {
        let text = report(folder.path(), &format!("background.wgsl{option}"));
        let line = text.lines().find(|line| line.starts_with("from the CPU in f64")).expect("it compares").to_owned();
        (text.lines().next().expect("there is a first line").to_owned(), line)
    });
    assert!(lines[0].0.ends_with(", as written"), "{lines:?}");
    assert!(lines[1].0.ends_with(", f32 as written, f64 by integers"), "{lines:?}");
    assert!(lines[2].0.ends_with(", as the driver likes"), "{lines:?}");
    assert_eq!(lines[0].1, lines[1].1, "as written and by integers are the same arithmetic");
    assert_ne!(lines[0].1, lines[2].1, "this driver rewrites nothing");
    let message = fault(folder.path(), "background.wgsl --integers --as-driver-likes");
    assert!(message.contains("--as-driver-likes"), "{message}");
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
    assert!(report(folder.path(), "my.wgsl").contains("my.wgsl stands in for [kernels/image]"));
    let again = message(&template());
    assert!(again.starts_with("Error: my.wgsl: "), "{again}");
}

#[test]
fn an_unknown_module_is_shown_with_its_place_and_all_known_ones() {
    let folder = Folder::new();
    fs::write(folder.file("my.wgsl"), "// module: kernels/imgae\nfn f() {}\n").expect("the folder is writable");
    let message = fault(folder.path(), "my.wgsl");
    assert!(message.starts_with("Error: my.wgsl:1:12: no module is called [kernels/imgae]; there are: "), "{message}");
    let shown = "\n1 | // module: kernels/imgae\n               ^^^^^^^^^^^^^\n";
    assert!(message.ends_with(shown), "{message}");
    assert!(MODULES.iter().all(|module| message.contains(module.name)), "{message}");

    // If the unknown name is the name of the file, there is no line to show.
    fs::write(folder.file("torus.wgsl"), "fn f() {}\n").expect("the folder is writable");
    let message = fault(folder.path(), "torus.wgsl");
    assert!(message.starts_with("Error: torus.wgsl: no module is called [torus], as the file is; "), "{message}");
    assert!(MODULES.iter().all(|module| message.contains(module.name)), "{message}");
}

#[test]
fn a_name_that_another_module_lacks_still_gives_the_users_file() {
    let folder = Folder::new();
    fs::write(folder.file("sphere.wgsl"), "fn nothing() {}\n").expect("the folder is writable");
    let message = fault(folder.path(), "sphere.wgsl");
    assert!(message.contains("\nsphere.wgsl:1: stands in for [sphere], and may lack a name"), "{message}");
}

#[test]
fn a_binding_that_is_taken_gives_the_users_file_without_a_wrong_hint() {
    common::gpu();
    let folder = Folder::new();
    let own = "@group(0) @binding(0) var<storage, read> mine: array<u32>;\n".to_owned()
        + &TEMPLATE.replace("return n * real(0.5)", "return n * real(mine[0])");
    fs::write(folder.file("my.wgsl"), own).expect("the folder is writable");
    let message = fault(folder.path(), "my.wgsl");
    assert!(message.contains("my.wgsl:") && !message.contains("may lack a name"), "{message}");
}

#[test]
fn constants_of_the_crate_and_of_the_user_are_set_and_unknown_ones_refused() {
    let folder = Folder::new();
    let own = TEMPLATE.replace("return n * real(0.5)", "return n * real(gain)");
    fs::write(folder.file("my.wgsl"), format!("{own}override gain: f32 = 0.5;\n")).expect("writable");
    let plain = report(folder.path(), "my.wgsl");
    let set = report(folder.path(), "my.wgsl --set gain=0.1 --set has_cylinders=false");
    let line = |text: &str| text.lines().find(|line| line.starts_with("from the CPU")).map(str::to_owned);
    assert!(line(&plain).is_some() && line(&plain) != line(&set), "{plain}{set}");
    let message = fault(folder.path(), "my.wgsl --set loudness=1");
    assert!(message.contains("no constant [loudness]; there are: ") && message.contains("gain"), "{message}");
}

#[test]
fn a_dash_is_standard_input_and_output() {
    let folder = Folder::new();
    fs::write(folder.file("my.wgsl"), TEMPLATE).expect("the folder is writable");
    report(folder.path(), "my.wgsl");
    let piped = command(folder.path(), "-");
    let arguments: Vec<_> = piped.get_args().map(ToOwned::to_owned).collect();
    // The last argument is the path OUT.
    let (out, arguments) = arguments.split_last().expect("there are some");
    assert_eq!(out, "out.png");
    let module = fs::File::open(folder.file("my.wgsl")).expect("it was written");
    let output = Command::new(piped.get_program())
        .current_dir(&folder)
        .args(arguments)
        .arg("-")
        .stdin(module)
        .output()
        .expect("the program starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(output.stdout.starts_with(b"P6\n48 27\n255\n"));
    assert_eq!(output.stdout.len(), b"P6\n48 27\n255\n".len() + 3 * 48 * 27);
}

/// Runs the program for `scenes/ten-thousand`, with a configuration that ends in these lines.
fn run_ten_thousand(folder: &Path, lines: &str, arguments: &str) -> Output {
    let config = fs::read_to_string(project_root().join("scenes/ten-thousand/config.txt")).expect("it is there");
    fs::write(folder.join("few"), config + lines).expect("the folder is writable");
    let mut command = Command::new(env!("CARGO_BIN_EXE_shader-lab"));
    command.current_dir(folder).args(arguments.split(' ')).args(["--config", "few", "--out", "out.png", "--scene"]);
    command.arg(project_root().join("scenes/ten-thousand/scene.txt")).output().expect("the program starts")
}

#[test]
fn a_scene_of_many_objects_and_a_path_in_it_take_runs_that_end_in_time() {
    let folder = Folder::new();
    fs::write(folder.file("background.wgsl"), standard("background")).expect("the folder is writable");
    // Each run takes as long as a run of the whole picture.
    let output = run_ten_thousand(folder.path(), "image_width: 64\n", "background.wgsl --check --pixel 32 24");
    let text = words(&output);
    assert_eq!(output.status.code(), Some(0), "{text}");
    assert!(text.contains(": 0 of 2304 pixels differ"), "{text}");
    assert!(text.contains("\nno bit differs\ncolour\n  red  "), "{text}");
}

#[test]
fn a_pixel_outside_is_refused() {
    let folder = Folder::new();
    fs::write(folder.file("my.wgsl"), TEMPLATE).expect("the folder is writable");
    let message = fault(folder.path(), "my.wgsl --pixel 48 0");
    assert!(message.contains("--pixel: the picture has 48 x 27 pixels"), "{message}");
}
