//! The page of `compare --html`: both pictures in one file, with a slider, blinking, their difference, and zoom.

use colorous::INFERNO;

use crate::heatmap::color_at;
use crate::picture::Picture;
use crate::report::html::escape;

/// Number of steps of the page's colour map. The page interpolates between them.
const STEPS: usize = 32;

/// Returns the page that compares two pictures with these names. `figures` is the text below them.
///
/// # Errors
/// An error if a picture is too large for a PNG.
pub fn page(pictures: [&Picture; 2], names: [String; 2], figures: &str) -> Result<String, String> {
    let addresses: Vec<_> = pictures
        .iter()
        .map(|picture| picture.address())
        .collect::<Result<_, _>>()
        .map_err(|error| error.to_string())?;
    let colors: Vec<_> = (0..=STEPS).map(|step| color_at(INFERNO, step as f64 / STEPS as f64)).collect();
    let [first, second] = names.map(|name| escape(&name));
    let parts = [
        first,
        second,
        format!("{addresses:?}"),
        format!("{colors:?}"),
        figures.lines().map(escape).collect::<Vec<_>>().join("\n"),
    ];
    // The places of the parts are marked by @1@ to @5@ in their order. What is filled in is not searched again.
    let mut page = String::new();
    let mut rest = include_str!("../../../pages/compare.html");
    for (part, number) in parts.iter().zip(1..) {
        let (before, after) = rest.split_once(&format!("@{number}@")).ok_or("the page lacks a place")?;
        page.push_str(before);
        page.push_str(part);
        rest = after;
    }
    Ok(page + rest)
}
