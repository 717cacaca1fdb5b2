//! Runs `shader-lab` from bash, with pipes, devices, links, and streams that cannot be written.

use super::*;

/// Runs a line of bash, in which `$lab` is the path of the program. The working folder has a module, a configuration
/// and a scene.
fn bash(folder: &Path, line: &str) -> Output {
    fs::write(folder.join("my.wgsl"), TEMPLATE).expect("the folder is writable");
    fs::write(folder.join("config"), "image_width: 16\n").expect("the folder is writable");
    fs::copy(repository("scenes/materials/scene.txt"), folder.join("scene")).expect("the folder is writable");
    let mut bash = Command::new("bash");
    bash.current_dir(folder).args(["-c", line]).env("lab", env!("CARGO_BIN_EXE_shader-lab"));
    bash.output().expect("bash starts")
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
    let folder = Folder::new();
    let output = bash(folder.path(), "$lab my.wgsl --config <(cat config) --scene <(cat scene) --out o.png");
    assert!(output.status.success() && words(&output).contains("\n16 x 9 pixels in "), "{}", words(&output));
}

#[test]
fn a_device_stays_a_device_and_no_file_is_written_beside_it() {
    let folder = Folder::new();
    let output = bash(folder.path(), "$lab my.wgsl --config config --scene scene --out /dev/null");
    assert!(output.status.success(), "{}", words(&output));
    use std::os::unix::fs::FileTypeExt;
    assert!(fs::metadata("/dev/null").expect("it exists").file_type().is_char_device());
    assert!(!Path::new("/dev/null-difference.png").exists());
}

#[test]
fn a_link_at_a_name_that_was_once_predictable_is_left_alone() {
    let folder = Folder::new();
    let line = "echo kept > precious; ln -s precious o.png.unfinished; \
                $lab my.wgsl --config config --scene scene --out o.png";
    let output = bash(folder.path(), line);
    assert!(output.status.success(), "{}", words(&output));
    assert_eq!(fs::read_to_string(folder.file("precious")).expect("it stands"), "kept\n");
    let expected = ["config", "my.wgsl", "o-difference.png", "o.png", "o.png.unfinished", "precious", "scene"];
    assert_eq!(names(folder.path()), expected);
}

#[test]
fn a_limit_on_file_size_leaves_all_old_pictures() {
    let folder = Folder::new();
    for name in ["o.png", "o-difference.png"] {
        fs::write(folder.file(name), "old").expect("the folder is writable");
    }
    // The driver's shader cache is off, because its files would exceed the limit too.
    let line = "export MESA_SHADER_CACHE_DISABLE=1; ulimit -f 1; echo 'image_width: 99' > config; \
                $lab my.wgsl --config config --scene scene --out o.png";
    let output = bash(folder.path(), line);
    assert_eq!(output.status.code(), Some(2), "{}", words(&output));
    assert!(words(&output).contains("Cannot write file [o-difference.png]: File too large"), "{}", words(&output));
    for name in ["o.png", "o-difference.png"] {
        assert_eq!(fs::read(folder.file(name)).expect("it stands"), b"old", "{name}");
    }
    assert_eq!(names(folder.path()), ["config", "my.wgsl", "o-difference.png", "o.png", "scene"]);
}

#[test]
fn an_input_as_output_is_refused_under_any_name() {
    let folder = Folder::new();
    // OUT must have the ending of a picture, so a link names the module.
    for out in ["scene", "config", "hard", "soft", "module.png"] {
        let links = "ln -f scene hard; ln -sf config soft; ln -sf my.wgsl module.png";
        let line = format!("{links}; $lab my.wgsl --config config --scene scene --out {out}");
        let output = bash(folder.path(), &line);
        assert!(!output.status.success(), "{out}");
        assert!(words(&output).contains("it is the same file as the input ["), "{}", words(&output));
    }
}

#[test]
fn a_socket_as_output_is_refused_before_the_cpu_renders() {
    let folder = Folder::new();
    for name in ["o", "o-difference.png"] {
        let listener = std::os::unix::net::UnixListener::bind(folder.file(name)).expect("the folder is writable");
        let out = if name == "o" { "o" } else { "o.png" };
        let output = bash(folder.path(), &format!("$lab my.wgsl --config config --scene scene --out {out}"));
        let text = words(&output);
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(text.contains(&format!("Cannot write file [{name}]: ")) && !text.contains("the CPU renders"), "{text}");
        drop(listener);
    }
}

#[test]
fn a_picture_with_too_many_pixels_is_refused_before_it_is_rendered() {
    let folder = Folder::new();
    let line = "echo 'image_width: 9999' > config; $lab my.wgsl --config config --scene scene --out o.png";
    let output = bash(folder.path(), line);
    assert!(words(&output).contains("more than 8388608; lower image_width"), "{}", words(&output));
}

#[test]
fn names_cannot_command_a_terminal() {
    let folder = Folder::new();
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
    let folder = Folder::new();
    for (redirection, status) in
        [(">&-", 2), (">/dev/full", 2), ("1</dev/null", 2), ("2>&-", 0), ("<&- 2>/dev/full", 0)]
    {
        let line = format!("$lab --help {redirection}");
        let output = bash(folder.path(), &line);
        assert_eq!(output.status.code(), Some(status), "{redirection}: {}", words(&output));
    }
}
