//! Checks that the commands in docs/shader-lab.md print the figures that the page shows.

use super::*;

/// Returns the lines of the first code block in `text` that has a line beginning with `start`.
fn block<'a>(text: &'a str, start: &str) -> Vec<&'a str> {
    let blocks = text.split("```\n").skip(1).step_by(2).map(|block| block.lines().collect::<Vec<_>>());
    let mut found = blocks.filter(|lines| lines.iter().any(|line| line.starts_with(start)));
    found.next().unwrap_or_else(|| panic!("docs/shader-lab.md shows no [{start}]"))
}

#[test]
fn the_figures_of_the_documentation_are_what_its_commands_print() {
    if !common::gpu().is_lavapipe() {
        println!("the figures are lavapipe's, so nothing was compared");
        return;
    }
    let docs = fs::read_to_string(repository("docs/shader-lab.md")).expect("it is committed");
    let folder = Folder::new();
    let changed = "let near = (h - root) * (real(1.0) / a);";
    assert!(docs.contains(changed));
    let sphere = standard("sphere").replace("let near = (h - root) / a;", changed);
    fs::write(folder.file("sphere.wgsl"), sphere).expect("the folder is writable");
    let shown = |options: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_shader-lab"))
            .current_dir(&folder)
            .args(["sphere.wgsl", "--config"])
            .arg(repository("scenes/materials/config.txt"))
            .arg("--scene")
            .arg(repository("scenes/materials/scene.txt"))
            .args(["--out", "out.png"])
            .args(options)
            .output()
            .expect("the program starts");
        String::from_utf8(output.stdout).expect("it is text")
    };
    let said = shown(&[]);
    // Lines with times and versions may differ from the page. All other lines must be printed.
    let stable = |line: &&&str| !line.starts_with("in f64 on") && !line.contains(" to compile; ");
    let lines = block(&docs, "from the CPU in f64: ");
    assert!(lines.iter().filter(stable).count() >= 4, "{lines:?}");
    for line in lines.iter().filter(stable) {
        assert!(
            said.contains(&format!("{line}\n")),
            "docs/shader-lab.md has [{line}], but the command prints:\n{said}"
        );
    }
    let (_, pixel) = docs.split_once("`--pixel ").expect("the page has an example");
    let (pixel, _) = pixel.split_once('`').expect("it ends");
    let views = shown(&["--show", "lambda"]);
    assert!(views.contains(&format!("the first of them --pixel {pixel}\n")), "{pixel}: {views}");
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
