//! The program `shader-lab`, as a person runs it.

mod common;

use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::time::Duration;

use gpu_check::scenes::repository;
use gpu_check::shader_lab::TEMPLATE;
use shaders::Library;
use shaders::module::MODULES;

/// How long the program may take to notice a change.
const PATIENCE: Duration = Duration::from_secs(60);

fn command(folder: &Path, arguments: &str) -> Command {
    let config = folder.join("config.txt");
    fs::write(&config, "image_width: 48\nmax_depth: 8\n").expect("the folder is writable");
    let mut command = Command::new(env!("CARGO_BIN_EXE_shader-lab"));
    command.current_dir(folder).args(arguments.split_whitespace()).arg("--config").arg(config);
    command.arg("--scene").arg(repository("scenes/materials/scene.txt")).args(["--out", "out.png"]);
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

fn fault(folder: &Path, arguments: &str) -> String {
    let output = run(folder, arguments);
    assert!(!output.status.success() && output.stdout.is_empty());
    let text = String::from_utf8(output.stderr).expect("it is text");
    // Mesa has something to say first.
    text[text.find("Error: ").expect("a message starts so")..].to_owned()
}

fn standard(name: &str) -> String {
    Library::standard().source(name).expect("it exists").to_owned()
}

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("there is room")
}

#[test]
fn an_unchanged_module_differs_in_no_bit_and_a_changed_one_does() {
    common::gpu();
    let folder = folder();
    let path = folder.path().join("background.wgsl");
    fs::write(&path, standard("background")).expect("the folder is writable");
    for precision in ["f64", "f32"] {
        let text = report(folder.path(), &format!("background.wgsl --{precision}"));
        assert!(text.contains("background.wgsl stands in for [background]\n"), "{text}");
        assert!(text.contains(&format!("from the CPU in {precision}: 0 of 1296 pixels differ, RMSE 0.0e0")), "{text}");
    }
    fs::write(&path, standard("background").replace("direction.y", "direction.x")).expect("the folder is writable");
    let text = report(folder.path(), "background.wgsl");
    assert!(text.contains("of 1296 pixels differ") && !text.contains(": 0 of 1296"), "{text}");
    assert!(folder.path().join("out-difference.png").is_file());
}

#[test]
fn the_template_gives_a_picture_of_normals_and_is_never_written_over() {
    let folder = folder();
    let written = Command::new(env!("CARGO_BIN_EXE_shader-lab"))
        .current_dir(&folder)
        .args(["--template", "my.wgsl"])
        .output()
        .expect("the program starts");
    assert!(written.status.success());
    assert_eq!(fs::read_to_string(folder.path().join("my.wgsl")).expect("it was written"), TEMPLATE);
    assert!(report(folder.path(), "my.wgsl").contains("my.wgsl stands in for [kernels/image]"));
    let again = fault(folder.path(), "--template my.wgsl");
    assert!(again.starts_with("Error: my.wgsl: "), "{again}");
}

#[test]
fn a_fault_is_shown_in_the_persons_file_with_a_caret() {
    let folder = folder();
    fs::write(folder.path().join("my.wgsl"), TEMPLATE.replace("my_color(vec3", "my_colr(vec3")).expect("writable");
    let message = fault(folder.path(), "my.wgsl");
    let line = 1 + TEMPLATE.lines().position(|line| line.contains("my_color(vec3_unit")).expect("it is there");
    assert!(message.starts_with(&format!("Error: my.wgsl:{line}:35: ")), "{message}");
    assert!(message.trim_end().ends_with("^^^^^^^"), "{message}");
    assert!(!folder.path().join("out.png").exists());
}

#[test]
fn a_module_that_there_is_not_is_named_with_its_place_and_all_that_there_are() {
    let folder = folder();
    fs::write(folder.path().join("my.wgsl"), "// module: kernels/imgae\nfn f() {}\n").expect("the folder is writable");
    let message = fault(folder.path(), "my.wgsl");
    assert!(message.starts_with("Error: my.wgsl:1:12: no module is called [kernels/imgae]; there are: "), "{message}");
    let shown = "\n1 | // module: kernels/imgae\n               ^^^^^^^^^^^^^\n";
    assert!(message.ends_with(shown), "{message}");
    assert!(MODULES.iter().all(|module| message.contains(module.name)), "{message}");

    // No line says the name of a file.
    fs::write(folder.path().join("torus.wgsl"), "fn f() {}\n").expect("the folder is writable");
    let message = fault(folder.path(), "torus.wgsl");
    assert!(message.starts_with("Error: torus.wgsl: no module is called [torus], as the file is; "), "{message}");
    assert!(MODULES.iter().all(|module| message.contains(module.name)), "{message}");
}

#[test]
fn a_name_missed_elsewhere_still_names_the_persons_file() {
    let folder = folder();
    fs::write(folder.path().join("sphere.wgsl"), "fn nothing() {}\n").expect("the folder is writable");
    let message = fault(folder.path(), "sphere.wgsl");
    assert!(message.contains("\nsphere.wgsl:1: stands in for [sphere], and may lack a name"), "{message}");
}

#[test]
fn constants_are_set_own_ones_too_and_unknown_ones_refused() {
    let folder = folder();
    let own = TEMPLATE.replace("return n * real(0.5)", "return n * real(gain)");
    fs::write(folder.path().join("my.wgsl"), format!("{own}override gain: f32 = 0.5;\n")).expect("writable");
    let plain = report(folder.path(), "my.wgsl");
    let set = report(folder.path(), "my.wgsl --set gain=0.1 --set has_cylinders=false");
    let line = |text: &str| text.lines().find(|line| line.starts_with("from the CPU")).map(str::to_owned);
    assert!(line(&plain).is_some() && line(&plain) != line(&set), "{plain}{set}");
    let message = fault(folder.path(), "my.wgsl --set loudness=1");
    assert!(message.contains("no constant [loudness]; there are: ") && message.contains("gain"), "{message}");
}

#[test]
fn views_of_both_sides_agree_and_show_where_a_module_does_not() {
    let folder = folder();
    let path = folder.path().join("sphere.wgsl");
    fs::write(&path, standard("sphere")).expect("the folder is writable");
    for view in ["lambda", "normal", "object", "side", "steps"] {
        let text = report(folder.path(), &format!("sphere.wgsl --show {view}"));
        assert!(text.contains("0 of 1296 pixels have another bit on their way"), "{text}");
        assert!(folder.path().join(format!("out-{view}.png")).is_file());
    }
    let changed = standard("sphere").replace("(h - root) / a", "(h - root) * (real(1.0) / a)");
    fs::write(&path, changed).expect("the folder is writable");
    let text = report(folder.path(), "sphere.wgsl --show lambda");
    let (_, place) = text.split_once("the first of them --pixel ").unwrap_or_else(|| panic!("{text}"));
    let pixel = place.lines().next().expect("numbers follow");
    let text = report(folder.path(), &format!("sphere.wgsl --pixel {pixel}"));
    assert!(text.contains("<- differs\n") && text.contains("first difference: step 0, lambda\n  CPU "), "{text}");
}

#[test]
fn a_pixel_outside_is_refused() {
    let folder = folder();
    fs::write(folder.path().join("my.wgsl"), TEMPLATE).expect("the folder is writable");
    let message = fault(folder.path(), "my.wgsl --pixel 48 0");
    assert!(message.contains("--pixel: the picture has 48 x 27 pixels"), "{message}");
}

/// A program that ends with its guard, and the lines that it writes.
struct Watched(Child, Receiver<String>);

impl Drop for Watched {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

impl Watched {
    fn start(mut command: Command) -> Self {
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts");
        let (sender, receiver) = mpsc::channel();
        let pipes: [Option<Box<dyn Read + Send>>; 2] = [
            child.stdout.take().map(|pipe| Box::new(pipe) as Box<dyn Read + Send>),
            child.stderr.take().map(|pipe| Box::new(pipe) as Box<dyn Read + Send>),
        ];
        for pipe in pipes.into_iter().flatten() {
            let sender = sender.clone();
            std::thread::spawn(move || {
                BufReader::new(pipe).lines().map_while(Result::ok).all(|line| sender.send(line).is_ok())
            });
        }
        Self(child, receiver)
    }

    fn wait_for(&self, start: &str) -> String {
        loop {
            let line = self.1.recv_timeout(PATIENCE).unwrap_or_else(|_| panic!("no line starts with [{start}]"));
            if line.starts_with(start) {
                return line;
            }
        }
    }
}

#[test]
fn watching_survives_a_broken_shader_and_keeps_the_last_good_picture() {
    let folder = folder();
    let (path, out) = (folder.path().join("my.wgsl"), folder.path().join("out.png"));
    fs::write(&path, TEMPLATE).expect("the folder is writable");
    let mut watched = Watched::start(command(folder.path(), "my.wgsl --watch"));
    watched.wait_for("wrote out-difference.png");
    let good = fs::read(&out).expect("it was written");

    fs::write(&path, format!("{TEMPLATE}nonsense\n")).expect("the folder is writable");
    let line = TEMPLATE.lines().count() + 1;
    watched.wait_for(&format!("Error: my.wgsl:{line}:1: "));
    fs::remove_file(&path).expect("it is there");
    watched.wait_for("Error: my.wgsl: ");
    assert!(watched.0.try_wait().expect("it can be asked").is_none(), "the program goes on");
    assert_eq!(fs::read(&out).expect("it stays"), good);

    fs::write(&path, TEMPLATE.replace("return n *", "return n.zyx *")).expect("the folder is writable");
    watched.wait_for("wrote out-difference.png");
    assert!(fs::read(&out).expect("it was written") != good, "the new picture is another");
}

#[test]
fn watching_survives_a_module_that_is_refused_and_one_that_takes_all_memory() {
    let folder = folder();
    let path = folder.path().join("my.wgsl");
    fs::write(&path, format!("{TEMPLATE}const deep = {}1;\n", "-".repeat(30_000))).expect("the folder is writable");
    let mut watched = Watched::start(command(folder.path(), "my.wgsl --watch"));
    assert!(watched.wait_for("Error: my.wgsl:").contains("more than 500 brackets, operators or branches"));

    // naga compares the elements one by one, and holds them all.
    let bomb = "const many = array<i32, 500000000>();\nconst_assert many == many;\n";
    fs::write(&path, format!("{TEMPLATE}{bomb}")).expect("the folder is writable");
    watched.wait_for("Error: the shader takes too much to compile: naga or the driver ended by signal");
    fs::write(&path, TEMPLATE).expect("the folder is writable");
    watched.wait_for("wrote out-difference.png");
    assert!(watched.0.try_wait().expect("it can be asked").is_none(), "the program goes on");
}

#[cfg(unix)]
mod unix {
    use super::*;

    /// Runs a line of bash in which `$lab` is the program with a module and a scene.
    fn bash(folder: &Path, line: &str) -> Output {
        fs::write(folder.join("my.wgsl"), TEMPLATE).expect("the folder is writable");
        fs::write(folder.join("config"), "image_width: 16\n").expect("the folder is writable");
        fs::copy(repository("scenes/materials/scene.txt"), folder.join("scene")).expect("the folder is writable");
        let mut bash = Command::new("bash");
        bash.current_dir(folder).args(["-c", line]).env("lab", env!("CARGO_BIN_EXE_shader-lab"));
        bash.output().expect("bash starts")
    }

    fn words(output: &Output) -> String {
        format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr))
    }

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("the folder is readable");
        let mut names: Vec<_> =
            entries.map(|entry| entry.expect("it is readable").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    #[test]
    fn a_pipe_as_configuration_is_read_once_and_its_values_count() {
        let folder = folder();
        let output = bash(folder.path(), "$lab my.wgsl --config <(cat config) --scene <(cat scene) --out o.png");
        assert!(output.status.success() && words(&output).contains("\n16 x 9 pixels in "), "{}", words(&output));
    }

    #[test]
    fn endless_files_are_refused() {
        let folder = folder();
        for (config, scene) in [("/dev/zero", "scene"), ("config", "/dev/zero")] {
            let output = bash(folder.path(), &format!("$lab my.wgsl --config {config} --scene {scene} --out o.png"));
            let expected = "Cannot read file [/dev/zero]: it is larger than 16777216 bytes";
            assert!(!output.status.success() && words(&output).contains(expected), "{}", words(&output));
        }
    }

    #[test]
    fn a_device_stays_a_device_and_gets_no_neighbour() {
        let folder = folder();
        let output = bash(folder.path(), "$lab my.wgsl --config config --scene scene --out /dev/null");
        assert!(output.status.success(), "{}", words(&output));
        use std::os::unix::fs::FileTypeExt;
        assert!(fs::metadata("/dev/null").expect("it exists").file_type().is_char_device());
        assert!(!Path::new("/dev/null-difference.png").exists());
    }

    #[test]
    fn a_link_at_a_name_that_was_once_predictable_is_left_alone() {
        let folder = folder();
        let line = "echo kept > precious; ln -s precious o.png.unfinished; \
                    $lab my.wgsl --config config --scene scene --out o.png";
        let output = bash(folder.path(), line);
        assert!(output.status.success(), "{}", words(&output));
        assert_eq!(fs::read_to_string(folder.path().join("precious")).expect("it stands"), "kept\n");
        let expected = ["config", "my.wgsl", "o-difference.png", "o.png", "o.png.unfinished", "precious", "scene"];
        assert_eq!(names(folder.path()), expected);
    }

    #[test]
    fn a_limit_on_file_size_leaves_all_old_pictures() {
        let folder = folder();
        for name in ["o.png", "o-difference.png"] {
            fs::write(folder.path().join(name), "old").expect("the folder is writable");
        }
        // No cache of shaders, which would not fit either.
        let line = "export MESA_SHADER_CACHE_DISABLE=1; ulimit -f 1; echo 'image_width: 99' > config; \
                    $lab my.wgsl --config config --scene scene --out o.png";
        let output = bash(folder.path(), line);
        assert_eq!(output.status.code(), Some(1), "{}", words(&output));
        assert!(words(&output).contains("Cannot write file [o-difference.png]: File too large"), "{}", words(&output));
        for name in ["o.png", "o-difference.png"] {
            assert_eq!(fs::read(folder.path().join(name)).expect("it stands"), b"old", "{name}");
        }
        assert_eq!(names(folder.path()), ["config", "my.wgsl", "o-difference.png", "o.png", "scene"]);
    }

    #[test]
    fn an_input_as_output_is_refused_under_any_name() {
        let folder = folder();
        for out in ["scene", "config", "my.wgsl", "hard", "soft"] {
            let line =
                format!("ln -f scene hard; ln -sf config soft; $lab my.wgsl --config config --scene scene --out {out}");
            let output = bash(folder.path(), &line);
            assert!(!output.status.success(), "{out}");
            assert!(words(&output).contains("it is the same file as the input ["), "{}", words(&output));
        }
    }

    #[test]
    fn a_picture_with_too_many_pixels_is_refused_before_it_is_rendered() {
        let folder = folder();
        let line = "echo 'image_width: 9999' > config; $lab my.wgsl --config config --scene scene --out o.png";
        let output = bash(folder.path(), line);
        assert!(words(&output).contains("more than 8388608; lower image_width"), "{}", words(&output));
    }

    #[test]
    fn names_cannot_command_a_terminal() {
        let folder = folder();
        let line = "cp my.wgsl $'\\e[2Jx\\ny.wgsl'; $lab $'\\e[2Jx\\ny.wgsl' --config $'\\e[0m\\n' --scene s --out o; \
                    $lab $'--\\e[2J' --config $'\\xff'; \
                    $lab $'\\e[2Jx\\ny.wgsl' --config config --scene scene --out o.png";
        let output = bash(folder.path(), line);
        let text = words(&output);
        assert!(output.status.success() && text.contains(r"\u{1b}[2Jx\ny.wgsl stands in for"), "{text}");
        assert!(text.contains(r"Cannot read file [\u{1b}[0m\n]: "), "{text}");
        assert!(!text.contains('\u{1b}'), "{text}");
    }

    #[test]
    fn closed_and_full_outputs_are_no_panic() {
        let folder = folder();
        for (redirection, status) in
            [(">&-", 1), (">/dev/full", 1), ("1</dev/null", 1), ("2>&-", 0), ("<&- 2>/dev/full", 0)]
        {
            let line = format!("$lab --help {redirection}");
            let output = bash(folder.path(), &line);
            assert_eq!(output.status.code(), Some(status), "{redirection}: {}", words(&output));
        }
    }
}
