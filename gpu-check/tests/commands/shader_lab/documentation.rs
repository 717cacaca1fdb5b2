//! Checks that the commands in docs/shader-lab.md print the figures that the page shows. The figures are lavapipe's, so
//! with another driver nothing is compared.

use super::*;

/// Returns the page, or `None` if the driver is another one than lavapipe.
fn page() -> Option<String> {
    if !common::gpu().is_lavapipe() {
        println!("the figures are lavapipe's, so nothing is compared");
        return None;
    }
    Some(fs::read_to_string(project_root().join("docs/shader-lab.md")).expect("it is committed"))
}

/// Returns what the program prints for a scene of the folder `scenes` and the module `module`, in which `from` is
/// replaced by `to`.
fn shown(scene: &str, module: &str, [from, to]: [&str; 2], options: &str) -> String {
    let (folder, text) = (Folder::new(), standard(module));
    assert_eq!(text.matches(from).count(), 1);
    folder.write(&format!("{module}.wgsl"), text.replace(from, to));
    let config = project_root().join("scenes").join(scene).join("config.txt");
    let mut command = command_for(scene, &config, &folder, &format!("{module}.wgsl {options}"));
    let output = command.output().expect("the program starts");
    assert!(output.status.success(), "{}", words(&output));
    String::from_utf8(output.stdout).expect("it is text")
}

/// Returns the lines of the first code block in `text` that has a line beginning with `start`.
fn block<'a>(text: &'a str, start: &str) -> Vec<&'a str> {
    let blocks = text.split("```\n").skip(1).step_by(2).map(|block| block.lines().collect::<Vec<_>>());
    let mut found = blocks.filter(|lines| lines.iter().any(|line| line.starts_with(start)));
    found.next().unwrap_or_else(|| panic!("docs/shader-lab.md shows no [{start}]"))
}

/// Fails if a line of a page's output was not printed, or if there are fewer than `least`. Lines with times and
/// versions may differ.
fn check_lines(lines: &[&str], said: &str, least: usize) {
    let is_stable = |line: &&str| !line.starts_with("in f64 on") && !line.contains(" to compile; ") && *line != "  ...";
    let stable: Vec<_> = lines.iter().copied().filter(is_stable).collect();
    assert!(stable.len() >= least, "{lines:?}");
    for line in stable {
        assert!(
            said.contains(&format!("{line}\n")),
            "docs/shader-lab.md has [{line}], but the command prints:\n{said}"
        );
    }
}

#[test]
fn the_figures_of_the_example_with_random_numbers_are_what_its_command_prints() {
    let Some(docs) = page() else { return };
    let (from, to) = ("vector / sqrt(length_squared) * extent", "vector * (real(1.0) / sqrt(length_squared)) * extent");
    assert!(docs.contains(&format!("return ScatterVector({to}, next);")));
    assert!(docs.contains("scatter_vectors.wgsl --samples --scatter published"));
    let said = shown("grid", "scatter_vectors", [from, to], "--samples --scatter published");
    check_lines(&block(&docs, "8 samples for each pixel, "), &said, 4);
}

#[test]
fn the_figures_of_the_documentation_are_what_its_commands_print() {
    let Some(docs) = page() else { return };
    let (from, to) = ("let near = (h - root) / a;", "let near = (h - root) * (real(1.0) / a);");
    assert!(docs.contains(to));
    let shown = |options: &str| shown("materials", "sphere", [from, to], options);
    check_lines(&block(&docs, "from the CPU in f64: "), &shown(""), 4);
    let (lines, said) = (block(&docs, "pixel "), shown("--first-difference"));
    assert!(
        lines.len() >= 15 && said.ends_with(&(lines.join("\n") + "\n")),
        "{lines:?}, but the command prints:\n{said}"
    );
    let (_, pixel) = docs.split_once("`--pixel ").expect("the page has an example");
    let (pixel, _) = pixel.split_once('`').expect("it ends");
    assert!(lines[0].starts_with(&format!("pixel {pixel}: ")), "{pixel}: {lines:?}");
    check_lines(&block(&docs, "step 0 "), &shown(&format!("--pixel {pixel}")), 7);
}
