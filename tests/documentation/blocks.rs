//! The blocks of figures in pages. Each is made from a file of docs/measurements, so no page differs from its data.
//!
//! A block stands between a line `<!-- figures: NAME -->` and a line `<!-- end -->`. `docs/refresh` measures, and then
//! writes the blocks by `BLESS=1 cargo test -p tests --test documentation blocks`.

#[path = "blocks/accuracy.rs"]
mod accuracy;

use std::fmt::Write;

use crate::project::Project;

const START: &str = "<!-- figures: ";
const END: &str = "<!-- end -->\n";

/// A row of a file that `bench/compare` printed: the scene, and the median, least and largest ratio.
struct Row {
    scene: String,
    ratios: [f64; 3],
}

/// Returns the rows of each command of a file, in the order of the file.
fn commands(file: &str) -> Vec<Vec<Row>> {
    let row = |line: &str| {
        let (scene, rest) = line.split_once(".txt: ")?;
        let (median, rest) = rest.split_once(" (")?;
        let (low, rest) = rest.split_once(" to ")?;
        let high = rest.split(',').next()?;
        let [median, low, high] = [median, low, high].map(|number| number.parse().ok());
        let scene = scene.strip_suffix("/scene").unwrap_or(scene).to_owned();
        Some(Row { scene, ratios: [median?, low?, high?] })
    };
    file.split("\n$ ").skip(1).map(|command| command.lines().skip(1).filter_map(row).collect()).collect()
}

/// Returns the sentence below a table: when, where and with which commit its file was measured. The first line of the
/// file has this.
fn source(name: &str, file: &str) -> String {
    let head = file.lines().next().and_then(|line| line.strip_prefix("# ")).expect("a file begins with its machine");
    let [date, processor, processors, ..] = head.splitn(4, ", ").collect::<Vec<_>>()[..] else {
        panic!("{name}: the head has no processor: {head}")
    };
    let commit = head.rsplit_once("commit ").expect("the head names the commit").1;
    format!("`docs/refresh {name}`, {date}, {processor}, {processors}, commit {commit}.\n")
}

/// Returns a ratio with two digits, or whole from 100 on.
fn rounded(ratio: f64) -> String {
    match ratio {
        100.0.. => format!("{ratio:.0}"),
        10.0.. => format!("{ratio:.1}"),
        _ => format!("{ratio:.2}"),
    }
}

/// Returns the table of how many times as fast as other programs the renderer is, for the scenes for which `is_shown`.
fn speed(project: &Project, is_shown: impl Fn(&str) -> bool) -> String {
    let file = project.text("docs/measurements/speed.txt");
    let [reference, literal] = &commands(&file)[..] else { panic!("speed.txt has two comparisons") };
    let mut table =
        "| Scene | Times as fast as the reference | as a literal program in C++ |\n|---|--:|--:|\n".to_owned();
    for (slow, other) in reference.iter().zip(literal).filter(|(slow, _)| is_shown(&slow.scene)) {
        assert_eq!(slow.scene, other.scene, "both programs are compared on the same scenes");
        let cell = |row: &Row| {
            let [median, low, high] = row.ratios.map(rounded);
            format!("{median} ({low} to {high})")
        };
        let _ = writeln!(table, "| `{}` | {} | {} |", slow.scene, cell(slow), cell(other));
    }
    table + "\n" + &source("speed", &file)
}

/// Returns the table of the time with other instruction sets and with structures of arrays, as a multiple of the time.
fn sets(project: &Project) -> String {
    let file = project.text("docs/measurements/sets.txt");
    let commands = commands(&file);
    let name = |head: &str| {
        let set = head.split_once("--base-set ").and_then(|(_, rest)| rest.split(' ').next());
        set.map_or_else(|| "structures of arrays".to_owned(), |set| format!("`{set}`"))
    };
    let names: Vec<_> = file.split("\n$ ").skip(1).map(name).collect();
    assert_eq!(names.len(), commands.len());
    let mut table = format!("| Scene | {} |\n|---|{}\n", names.join(" | "), "--:|".repeat(names.len()));
    for (index, row) in commands[0].iter().enumerate() {
        let cells: Vec<_> = commands.iter().map(|rows| rounded(rows[index].ratios[0])).collect();
        let _ = writeln!(table, "| `{}` | {} |", row.scene, cells.join(" | "));
    }
    table + "\n" + &source("sets", &file)
}

/// Returns the table of how far pictures of permitted and of wrong programs are from the expected ones, in each scene.
/// The first row has the bounds of the scenes.
fn check(project: &Project) -> String {
    let file = project.text("docs/measurements/check.txt");
    // The head of a scene is its name, section, and the bounds of the maximum and of the RMSE.
    let scenes = project.text("lab/src/check/pictures.txt");
    let heads = scenes.lines().filter_map(|line| line.strip_prefix("= "));
    let heads: Vec<Vec<_>> = heads.map(|head| head.split(' ').collect()).collect();
    let names: Vec<_> = heads.iter().map(|head| head[0]).collect();
    let bounds: Vec<_> = heads.iter().map(|head| format!("{}/{}", head[3], head[2])).collect();
    let mut table = format!("| Program | {} |\n|---|{}\n", names.join(" | "), "--:|".repeat(names.len()));
    let _ = writeln!(table, "| bounds of RMSE/maximum | {} |", bounds.join(" | "));
    for line in file.lines() {
        let Some((kind, rest)) = line.split_once(' ').filter(|(kind, _)| ["permitted", "fault"].contains(kind)) else {
            continue;
        };
        let (name, figures) = rest.split_once(": ").expect("a program has figures");
        let figures: Vec<_> = figures.split(", ").filter_map(|figure| figure.split_once(' ')).collect();
        let cell = |scene: &&str| match figures.iter().find(|(other, _)| other == scene) {
            Some((_, figure)) => {
                figure.strip_suffix('!').map_or((*figure).to_owned(), |figure| format!("**{figure}**"))
            }
            None => "-".to_owned(),
        };
        let cells: Vec<_> = names.iter().map(cell).collect();
        let _ = writeln!(table, "| {kind}: `{}` | {} |", name.trim_matches('"'), cells.join(" | "));
    }
    table + "\n" + &source("check", &file)
}

/// Returns the table that the command of a part printed.
fn printed(project: &Project, part: &str) -> String {
    let file = project.text(&format!("docs/measurements/{part}.txt"));
    let rows: String = file.lines().filter(|line| line.starts_with('|')).map(|line| format!("{line}\n")).collect();
    assert!(!rows.is_empty(), "{part}.txt has no table: {file}");
    rows + "\n" + &source(part, &file)
}

/// Returns the text of a block.
fn block(project: &Project, name: &str) -> String {
    match name {
        // A new reader has only the scenes of this project.
        "speed of the bundled scenes" => speed(project, |scene| scene.starts_with("scenes/")),
        "speed" => speed(project, |_| true),
        "sets" => sets(project),
        "accuracy" => accuracy::block(project),
        "check" => check(project),
        "mechanisms" | "slopes" => printed(project, name),
        _ => panic!("there is no block of figures [{name}]"),
    }
}

/// Returns `text` with each block written anew, and the number of blocks.
fn with_blocks(text: &str, block: impl Fn(&str) -> String) -> (String, usize) {
    let mut pieces = text.split(START);
    let mut written = pieces.next().unwrap_or_default().to_owned();
    let mut count = 0;
    for piece in pieces {
        let (name, rest) = piece.split_once(" -->\n").expect("the line of a block ends in -->");
        let (_, rest) = rest.split_once(END).unwrap_or_else(|| panic!("the block [{name}] has no end"));
        written += &format!("{START}{name} -->\n{}{END}{rest}", block(name));
        count += 1;
    }
    (written, count)
}

#[test]
fn the_blocks_of_figures_are_those_of_the_measurements() {
    let project = Project::read();
    let mut count = 0;
    for path in project.with_endings(&["md"]) {
        let text = project.text(path);
        let (written, blocks) = with_blocks(&text, |name| block(&project, name));
        count += blocks;
        if written != text && std::env::var_os("BLESS").is_some() {
            std::fs::write(test_support::project_root().join(path), &written).expect("the page is writable");
            continue;
        }
        assert_eq!(text, written, "{path}: BLESS=1 cargo test -p tests --test documentation blocks writes the figures");
    }
    assert!(count >= 5, "{count} blocks");
}

#[test]
fn all_measurements_come_from_one_processor() {
    let project = Project::read();
    // Only some of the files have parentheses around the family, and Intel's names have others.
    let plain = |name: &str| name.replace(['(', ')'], "");
    let mut processors = Vec::new();
    for path in project.with_endings(&["txt"]).filter(|path| path.starts_with("docs/measurements/")) {
        let text = project.text(path);
        let head = text.lines().next().expect("a file has a head");
        processors.push(plain(head.split(", ").nth(1).expect("a head names the processor")));
    }
    assert!(processors.len() >= 10, "{processors:?}");
    for path in ["docs/report/data/perf.csv", "docs/report/data/sweep.csv"] {
        let text = project.text(path);
        processors.extend(text.lines().skip(1).filter_map(|line| line.rsplit(',').next()).map(plain));
    }
    assert!(processors.iter().all(|name| *name == processors[0]), "{processors:?}");
}

#[test]
fn a_block_is_written_between_its_marks_and_other_text_stays() {
    let page = "One\n<!-- figures: a -->\nold\n<!-- end -->\n<!-- figures: b -->\n<!-- end -->\nlast";
    let (written, count) = with_blocks(page, |name| format!("new {name}\n"));
    assert_eq!(count, 2);
    assert_eq!(
        written,
        "One\n<!-- figures: a -->\nnew a\n<!-- end -->\n<!-- figures: b -->\nnew b\n<!-- end -->\nlast"
    );
    let file = "# 2026-11-28, P (family 1), 2 processors, load 1, rustc 1, commit abc\n# docs/refresh speed\n\n$ command\n\
                scenes/a/scene.txt: 38.120 (34.882 to 39.014, 5 rounds), 0.381 s and 0.010 s\n";
    let rows = &commands(file)[0];
    assert_eq!((rows[0].scene.as_str(), rows[0].ratios), ("scenes/a", [38.12, 34.882, 39.014]));
    assert_eq!(source("speed", file), "`docs/refresh speed`, 2026-11-28, P (family 1), 2 processors, commit abc.\n");
}
