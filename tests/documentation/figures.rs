//! Checks figures that stand in two places: in the files of docs/measurements and in the pages, and in the report's two
//! languages.

use crate::markdown::Page;
use crate::project::Project;

/// Returns the ratios in a file that `docs/refresh` wrote: for each command a list, in the order of the file.
fn ratios(file: &str) -> Vec<Vec<f64>> {
    let of = |line: &str| line.split_once(".txt: ")?.1.split(' ').next()?.parse().ok();
    file.split("\n$ ").skip(1).map(|command| command.lines().skip(1).filter_map(of).collect()).collect()
}

/// Whether `cell` shows `ratio` rounded: to hundredths if `hundredths` is true, and to two digits otherwise.
fn is_rounded(cell: &str, ratio: f64, hundredths: bool) -> bool {
    let unit = if hundredths { 0.01 } else { 10_f64.powf(ratio.log10().floor() - 1.0) };
    cell.parse::<f64>().is_ok_and(|shown| (shown - ratio).abs() <= 0.51 * unit)
}

/// Returns the cells of the row whose first cell is `name`, without that cell. There is at least one.
fn row(page: &Page, name: &str) -> Vec<String> {
    let row = page.rows.iter().find(|row| row[0] == name).unwrap_or_else(|| panic!("there is no row [{name}]"));
    assert!(row.len() > 1, "the row [{name}] has no figure");
    row[1..].to_vec()
}

/// The workloads of docs/measurements.md, in the order of docs/measurements/speed.txt.
const WORKLOADS: [&str; 10] = [
    "case 1",
    "case 2",
    "case 3",
    "case 4",
    "scenes/spheres",
    "scenes/cylinders",
    "scenes/materials",
    "scenes/grid, 101 objects",
    "1,000 objects",
    "scenes/ten-thousand",
];

#[test]
fn pages_have_the_figures_of_the_measurements() {
    let project = Project::read();
    let page = Page::parse(&project.text("docs/measurements.md"));
    let speed = project.text("docs/measurements/speed.txt");
    let [reference, literal] = &ratios(&speed)[..] else { panic!("two programs are compared") };
    for (index, name) in WORKLOADS.into_iter().enumerate() {
        let cells = row(&page, name);
        let is_right =
            [reference, literal].into_iter().zip(&cells).all(|(all, cell)| is_rounded(cell, all[index], false));
        assert!(is_right, "{name}: {cells:?}, but measured {} and {}", reference[index], literal[index]);
    }
    let sets = ratios(&project.text("docs/measurements/sets.txt"));
    let names = ["avx512", "avx2", "portable", "structures of arrays"];
    assert!(sets.len() >= names.len(), "docs/measurements/sets.txt lacks a set");
    for (name, all) in names.into_iter().zip(&sets) {
        let cells = row(&page, name);
        let is_right = [0, 1, 2, 3, 8].into_iter().zip(&cells).all(|(index, cell)| is_rounded(cell, all[index], true));
        assert!(is_right, "{name}: {cells:?}, but measured {all:?}");
    }
    // The cells, as the prose of other pages has them.
    let cell = |name: &str| row(&page, name)[0].trim_end_matches(".0").to_owned();
    let [one, two, three, four, spheres, .., thousand, most] = WORKLOADS.map(cell);
    let readme = project.text("README.md");
    let example = speed.split("scenes/spheres/scene.txt: ").nth(1).and_then(|text| text.split(", 5 rounds").next());
    for text in [
        example.expect("the example is measured").to_owned() + ")",
        format!("{one}, {two}, {three} and {four} times as fast, and {thousand} times with 1,000 objects"),
    ] {
        assert!(readme.contains(&text), "README.md does not have [{text}]");
    }
    let performance = project.text("docs/performance.md");
    let text = format!("is {spheres} to {most} times as fast as the reference");
    assert!(performance.contains(&text), "docs/performance.md does not have [{text}]");
}

/// Returns all numbers in `text`, sorted as text, so that two languages can be compared. `thousands` and `decimals` are
/// the separators of the language: the first is left out, and a point replaces the second.
fn numbers(text: &str, thousands: char, decimals: char) -> Vec<String> {
    let letters: Vec<char> = text.chars().collect();
    let is_digit = |index: usize| letters.get(index).is_some_and(char::is_ascii_digit);
    let is_inside =
        |index: usize| [thousands, decimals, '.'].contains(&letters[index]) && index > 0 && is_digit(index - 1);
    let kept =
        |index: usize| if is_digit(index) || is_inside(index) && is_digit(index + 1) { letters[index] } else { ' ' };
    let text: String = (0..letters.len()).map(kept).filter(|letter| *letter != thousands).collect();
    let mut found: Vec<_> = text.replace(decimals, ".").split_whitespace().map(str::to_owned).collect();
    found.sort_unstable();
    found
}

#[test]
fn the_report_has_the_same_figures_in_both_languages() {
    let project = Project::read();
    let english = numbers(&project.text("docs/report/english.typ"), ',', '.');
    let spanish = numbers(&project.text("docs/report/spanish.typ"), '~', ',');
    assert!(english.len() > 200, "{english:?}");
    let differs = english.iter().zip(&spanish).find(|(one, other)| one != other);
    assert_eq!((differs, english.len()), (None, spanish.len()));
}

#[test]
fn other_figures_are_found() {
    assert!(is_rounded("5.0", 4.967, false) && is_rounded("250", 254.5, false) && is_rounded("1.01", 1.009, true));
    assert!(!is_rounded("5.1", 4.967, false) && !is_rounded("240", 254.5, false) && !is_rounded("1.02", 1.009, true));
    assert_eq!(numbers("From 1,000 to 2.5, 3.", ',', '.'), numbers("De 1~000 a 2,5, 3.", '~', ','));
    assert_eq!(numbers("section 4.1", ',', '.'), numbers("sección 4.1", '~', ','));
    assert_ne!(numbers("16 %", ',', '.'), numbers("1,6 %", '~', ','));
}
