//! Runs `shader-lab` from bash, with pipes, devices, links, and streams that cannot be written.

use super::*;

/// Runs a line of bash, in which `$lab` is the path of the program. The working folder has a module, a configuration
/// and a scene.
fn bash(folder: &Folder, line: &str) -> Output {
    folder.write("my.wgsl", TEMPLATE);
    folder.write("config", "image_width: 16\n");
    fs::copy(project_root().join("scenes/materials/scene.txt"), folder.file("scene")).expect("the folder is writable");
    let mut bash = test_support::running::bash();
    // Without this, bash would split a path with blanks.
    let line = format!("IFS=$'\\n'; {line}");
    bash.current_dir(folder).args(["-c", &line]).env("lab", env!("CARGO_BIN_EXE_shader-lab"));
    bash.output().expect("bash starts")
}

#[test]
fn a_pipe_as_configuration_is_read_once_and_its_values_count() {
    let folder = Folder::new();
    let output = bash(&folder, "$lab my.wgsl --config <(cat config) --scene <(cat scene) --out o.png");
    assert!(output.status.success() && words(&output).contains("\n16 x 9 pixels in "), "{}", words(&output));
}

#[test]
fn a_dash_is_standard_input_and_output() {
    let output = bash(&Folder::new(), "$lab - --config config --scene scene --out - < my.wgsl");
    assert!(output.status.success(), "{}", words(&output));
    let head = b"P6\n16 9\n255\n";
    assert!(output.stdout.starts_with(head) && output.stdout.len() == head.len() + 3 * 16 * 9);
}

#[test]
fn the_command_that_the_template_names_can_be_copied() {
    let folder = Folder::new();
    // Outside of the checkout the program does not find its example.
    if !Path::new(env!("CARGO_BIN_EXE_shader-lab")).starts_with(project_root()) {
        std::os::unix::fs::symlink(project_root().join("scenes"), folder.file("scenes")).expect("it is free");
    }
    let line = r#"$lab --template "my normals.wgsl" > said && eval "$(tail -n 1 said | sed 's/ --watch//')""#;
    let output = bash(&folder, line);
    assert!(output.status.success() && folder.file("out.png").exists(), "{}", words(&output));
}

#[test]
fn an_input_as_output_is_refused_under_any_name() {
    let folder = Folder::new();
    // OUT must have the ending of a picture, so a link names the module.
    for out in ["scene", "config", "hard", "soft", "module.png"] {
        let links = "ln -f scene hard; ln -sf config soft; ln -sf my.wgsl module.png";
        let line = format!("{links}; $lab my.wgsl --config config --scene scene --out {out}");
        let output = bash(&folder, &line);
        assert!(!output.status.success(), "{out}");
        assert!(words(&output).contains("it is the same file as the input ["), "{}", words(&output));
    }
}

#[test]
fn names_cannot_command_a_terminal() {
    let folder = Folder::new();
    let line = "cp my.wgsl $'\\e[2Jx\\ny.wgsl'; $lab $'\\e[2Jx\\ny.wgsl' --config $'\\e[0m\\n' --scene s --out o; \
                $lab $'--\\e[2J' --config $'\\xff'; \
                $lab $'\\e[2Jx\\ny.wgsl' --config config --scene scene --out o.png";
    let output = bash(&folder, line);
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
        let output = bash(&folder, &line);
        assert_eq!(output.status.code(), Some(status), "{redirection}: {}", words(&output));
    }
}
