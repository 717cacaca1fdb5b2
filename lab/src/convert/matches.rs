//! The table of what has a match: the plugins of both formats that are read, with the parameters that count.

use super::notes::Notes;
use super::plugin::Plugin;

/// The note on matte surfaces, for reading and for writing.
pub const MATTE: &str = "matte and diffuse scatter by different rules; they agree with render --scatter published";
/// The note on rough metals, for reading and for writing.
pub const ROUGH: &str = "diffusion and roughness blur by different rules; the diffusion is taken as 2 alpha";
/// The note on pbrt's conductors, for reading and for writing.
pub const CONDUCTOR: &str =
    "metal and pbrt's conductor have the same colour only for light that falls straight on them";
/// The note on glass, for reading and for writing.
pub const GLASS: &str = "refractive lets all light through, and dielectric reflects a part (Fresnel)";
/// The note on cylinders, for reading and for writing.
pub const SIDE: &str =
    "the normal of our cylinder's side is as long as its radius; only a radius of 1 scatters as theirs";

/// The plugins that are read, one in each line: the name, and the parameters that are read, or that change nothing in a
/// picture of ours. The names of pbrt begin with a capital letter, those of Mitsuba with a small one.
const PLUGINS: &str = include_str!("plugins.txt");

/// Returns the note on what differs in our picture of a plugin.
fn difference(name: &str) -> Option<&'static str> {
    match name {
        "Material diffuse" | "bsdf diffuse" => Some(MATTE),
        "Material conductor" => Some(CONDUCTOR),
        "bsdf roughconductor" => Some(ROUGH),
        "Material dielectric" | "bsdf dielectric" => Some(GLASS),
        _ => None,
    }
}

/// The parameters that may hold the colour of a material that is not in the table. The first that is there counts.
pub const COLORS: [&str; 3] = ["reflectance", "diffuse_reflectance", "base_color"];

/// Notes the parameters of `plugin` that have no match and removes them, and notes what differs in our picture. Returns
/// whether the plugin is in the table. A plugin that is not keeps the parameters of all types of its word.
pub fn check(plugin: &mut Plugin, notes: &mut Notes) -> bool {
    let Plugin { name, params, place } = plugin;
    let word = name.split(' ').next();
    let rows: Vec<_> = PLUGINS.lines().filter_map(|line| line.split_once(':')).collect();
    // A row of one word is for all types.
    let found = rows.iter().find(|(of, _)| *of == name.as_str() || Some(*of) == word);
    let is_for = |of: &str| found.map_or(of.split(' ').next() == word, |(found, _)| of == *found);
    params.retain(|param| {
        let is_read = rows.iter().any(|(of, read)| is_for(of) && read.split(' ').any(|name| name == param.name));
        let is_read = is_read || (found.is_none() && COLORS.contains(&&param.name[..]));
        if !is_read {
            notes.add(param.place, format!("[{}] of {name} has no match; left out", param.name));
        }
        is_read
    });
    if let Some(text) = difference(name) {
        notes.add(*place, text);
    }
    found.is_some()
}
