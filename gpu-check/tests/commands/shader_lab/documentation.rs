//! Checks that the commands in docs/shader-lab.md print the figures that the page shows.

use super::*;

/// Returns the lines of the first code block in `text` that has a line beginning with `start`.
fn block<'a>(text: &'a str, start: &str) -> Vec<&'a str> {
    let blocks = text.split("```\n").skip(1).step_by(2).map(|block| block.lines().collect::<Vec<_>>());
    let mut found = blocks.filter(|lines| lines.iter().any(|line| line.starts_with(start)));
    found.next().unwrap_or_else(|| panic!("docs/shader-lab.md shows no [{start}]"))
}

/// Fails if a line of a page's output was not printed. Lines with times and versions may differ.
fn check_lines(lines: &[&str], said: &str) {
    let stable = |line: &&&str| !line.starts_with("in f64 on") && !line.contains(" to compile; ");
    assert!(lines.iter().filter(stable).count() >= 4, "{lines:?}");
    for line in lines.iter().filter(stable) {
        assert!(
            said.contains(&format!("{line}\n")),
            "docs/shader-lab.md has [{line}], but the command prints:\n{said}"
        );
    }
}

#[test]
fn the_figures_of_the_example_with_random_numbers_are_what_its_command_prints() {
    if !common::gpu().is_lavapipe() {
        println!("the figures are lavapipe's, so nothing was compared");
        return;
    }
    let docs = fs::read_to_string(project_root().join("docs/shader-lab.md")).expect("it is committed");
    let (from, to) = ("vector / sqrt(length_squared) * extent", "vector * (real(1.0) / sqrt(length_squared)) * extent");
    assert!(docs.contains(&format!("return ScatterVector({to}, next);")));
    assert!(docs.contains("scatter_vectors.wgsl --samples --scatter published"));
    let folder = Folder::new();
    let text = standard("scatter_vectors");
    assert_eq!(text.matches(from).count(), 1);
    fs::write(folder.file("scatter_vectors.wgsl"), text.replace(from, to)).expect("the folder is writable");
    let mut command = Command::new(env!("CARGO_BIN_EXE_shader-lab"));
    command.current_dir(&folder).args("scatter_vectors.wgsl --samples --scatter published --config".split(' '));
    command
        .arg(project_root().join("scenes/grid/config.txt"))
        .arg("--scene")
        .arg(project_root().join("scenes/grid/scene.txt"));
    let output = command.args(["--out", "out.png"]).output().expect("the program starts");
    let said = String::from_utf8(output.stdout).expect("it is text");
    check_lines(&block(&docs, "8 samples for each pixel, "), &said);
}

#[test]
fn the_figures_of_the_documentation_are_what_its_commands_print() {
    if !common::gpu().is_lavapipe() {
        println!("the figures are lavapipe's, so nothing was compared");
        return;
    }
    let docs = fs::read_to_string(project_root().join("docs/shader-lab.md")).expect("it is committed");
    let folder = Folder::new();
    let changed = "let near = (h - root) * (real(1.0) / a);";
    assert!(docs.contains(changed));
    let sphere = standard("sphere").replace("let near = (h - root) / a;", changed);
    fs::write(folder.file("sphere.wgsl"), sphere).expect("the folder is writable");
    let shown = |options: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_shader-lab"))
            .current_dir(&folder)
            .args(["sphere.wgsl", "--config"])
            .arg(project_root().join("scenes/materials/config.txt"))
            .arg("--scene")
            .arg(project_root().join("scenes/materials/scene.txt"))
            .args(["--out", "out.png"])
            .args(options)
            .output()
            .expect("the program starts");
        String::from_utf8(output.stdout).expect("it is text")
    };
    let said = shown(&[]);
    check_lines(&block(&docs, "from the CPU in f64: "), &said);
    let said = shown(&["--first-difference"]);
    let lines = block(&docs, "pixel ");
    assert!(
        lines.len() >= 15 && said.ends_with(&(lines.join("\n") + "\n")),
        "{lines:?}, but the command prints:\n{said}"
    );
    let (_, pixel) = docs.split_once("`--pixel ").expect("the page has an example");
    let (pixel, _) = pixel.split_once('`').expect("it ends");
    assert!(lines[0].starts_with(&format!("pixel {pixel}: ")), "{pixel}: {lines:?}");
    let numbers: Vec<_> = pixel.split(' ').collect();
    let said = shown(&[&["--pixel"], &numbers[..]].concat());
    let lines = block(&docs, "step 0 ");
    assert!(lines.len() >= 8, "{lines:?}");
    for line in lines.iter().filter(|line| line.trim() != "...") {
        assert!(
            said.contains(&format!("{line}\n")),
            "docs/shader-lab.md has [{line}], but the command prints:\n{said}"
        );
    }
}
