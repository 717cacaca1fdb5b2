//! Grades `render-aos`, `render-soa`, the literal program in C++, and five faulty variants of it.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use libtest_mimic::{Failed, Trial};
use test_support::folder::Folder;
use test_support::{project_root, trial};

/// The first line of the literal program's `main`, which then checks its arguments.
const MAIN: (&str, &str) = (
    "renderer r; config& c",
    "if (argc != 4) { std::cerr << \"Error: Invalid number of arguments: \" << argc - 1 << \"\\n\"; return 1; } \
     renderer r; config& c",
);

/// The names of the variants, what is replaced in the source, and the faults of arguments and of pictures.
const VARIANTS: [(&str, (&str, &str), [&str; 2]); 6] = [
    ("literal", ("", ""), ["", ""]),
    ("message", ("Error: Invalid", "Error: Wrong"), ["wrong_message", ""]),
    (
        "order",
        (
            "double x = r.draw(r.rrng, -.5, .5), y = r.draw(r.rrng, -.5, .5)",
            "double y = r.draw(r.rrng, -.5, .5), x = r.draw(r.rrng, -.5, .5)",
        ),
        ["", "wrong_picture"],
    ),
    ("crash", ("sum = sum / c.samples", "std::abort()"), ["", "crash"]),
    (
        "slow",
        ("sum = sum / c.samples", "for (volatile int go = W == 160; go;); sum = sum / c.samples"),
        ["", "time_out"],
    ),
    ("none", ("out(argv[3])", "out(\"/dev/null\")"), ["", "no_picture"]),
];

/// Returns the test. It needs g++, and the two programs beside `render-lab`.
pub fn trials() -> Vec<Trial> {
    let has_compiler = Command::new("g++").arg("--version").output().is_ok_and(|output| output.status.success());
    let beside = Path::new(env!("CARGO_BIN_EXE_render-lab")).with_file_name("render-soa").is_file();
    let missing = match (has_compiler, beside) {
        (false, _) => Some("needs g++"),
        (_, false) => Some("needs cargo build -p cli"),
        _ => None,
    };
    vec![trial("grade::faulty_programs_are_told_apart", missing, faulty_programs_are_told_apart)]
}

fn faulty_programs_are_told_apart() -> Result<(), Failed> {
    let folder = Folder::with_scene("image_width: 200\nsamples_per_pixel: 50\n", "matte: m 1 0 0\nsphere: 0 0 0 3 m\n");
    let literal = std::fs::read_to_string(project_root().join("tests/literal/literal.cpp"))?;
    let mut toml =
        "[points]\nenergy = 0\n[[scene]]\nname = 's'\nconfig = 'config.txt'\nscene = 'scene.txt'\n".to_owned();
    for (name, (from, to), _) in VARIANTS {
        std::fs::create_dir(folder.file(name))?;
        let source = literal.replace(MAIN.0, MAIN.1);
        assert!(source.contains(from) && source != literal, "{name}");
        folder.write(&format!("{name}/render.cpp"), if from.is_empty() { source } else { source.replace(from, to) });
        let build = "g++ -std=c++20 -O2 -ffp-contract=off render.cpp -o render";
        writeln!(toml, "[[program]]\nname = '{name}'\nbuild = '{build}'\ncommand = ['./render']")?;
    }
    for name in ["render-aos", "render-soa"] {
        let path = Path::new(env!("CARGO_BIN_EXE_render-lab")).with_file_name(name);
        writeln!(toml, "[[program]]\nname = '{name}'\nfolder = '.'\ncommand = ['{}']", path.display())?;
    }
    folder.write("grade.toml", toml);
    let [html, csv, keep] = ["g.html", "g.csv", "keep"].map(|name| folder.name(name));
    let mut command = Command::new(env!("CARGO_BIN_EXE_render-lab"));
    command.env_remove("RENDER_REFERENCE_DIR").arg("grade").arg(folder.path()).arg("--json");
    command.args(["--seconds", "4", "--rounds", "3", "--language", "es"]);
    let output = command.args(["--html", &html, "--csv", &csv, "--keep", &keep]).output()?;
    let grades: serde_json::Value = serde_json::from_slice(&output.stdout).map_err(|_| format!("{output:?}"))?;
    let list = |value: &serde_json::Value| value.as_array().cloned().unwrap_or_default();
    let mut totals = BTreeMap::new();
    let ours = [("render-aos", ["", ""]), ("render-soa", ["", ""])];
    let expected = VARIANTS.iter().map(|(name, _, kinds)| (*name, *kinds)).chain(ours);
    for ((name, kinds), graded) in expected.zip(list(&grades["programs"])) {
        assert_eq!(graded["program"], name);
        for (group, expected) in ["arguments", "pictures"].into_iter().zip(kinds) {
            let cases = list(&graded["report"]["cases"]).into_iter().filter(|case| case["group"] == group);
            let faults = cases.flat_map(|case| list(&case["faults"]));
            let mut found: Vec<_> = faults.filter_map(|fault| fault["kind"].as_str().map(str::to_owned)).collect();
            found.dedup();
            assert_eq!(found.join(" "), expected, "{name}: {group}");
        }
        assert_eq!(graded["times"][0].is_null(), ["crash", "none"].contains(&name), "{name}");
        totals.insert(name, graded["total"].as_f64().ok_or("a number")?);
    }
    assert!(totals["render-aos"] > totals["literal"] && totals["literal"] > totals["crash"], "{totals:?}");
    let rows = String::from_utf8(folder.read("g.csv"))?;
    assert!(rows.starts_with("programa,puntos sobre 10,") && rows.lines().count() == 9, "{rows}");
    let page = String::from_utf8(folder.read("g.html"))?;
    assert!(page.contains("<svg role=\"img\"") && page.contains("imagen incorrecta") && !page.contains("href=\"http"));
    Ok(())
}
