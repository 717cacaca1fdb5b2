//! The table of what has a match: the plugins of both formats that are read, with the parameters that count.

use super::notes::Notes;
use super::plugin::Plugin;

/// A plugin that is read.
struct Row {
    /// Its name: pbrt's begin with a capital letter, Mitsuba's with a small one.
    name: &'static str,
    /// The parameters that are read, or that change nothing in a picture of ours.
    params: &'static str,
    /// What differs in our picture; empty if nothing does.
    differs: &'static str,
}

const fn row(name: &'static str, params: &'static str, differs: &'static str) -> Row {
    Row { name, params, differs }
}

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

const ROWS: [Row; 27] = [
    row("Shape sphere", "radius", ""),
    row("Shape cylinder", "radius zmin zmax", ""),
    row("Shape disk", "radius height", ""),
    row("Material diffuse", "reflectance", MATTE),
    row("Material conductor", "reflectance roughness remaproughness eta k", CONDUCTOR),
    row("Material dielectric", "eta", GLASS),
    row("Camera perspective", "fov screenwindow focaldistance", ""),
    row("Film rgb", "xresolution yresolution filename", ""),
    row("Sampler", "pixelsamples xsamples ysamples", ""),
    row("Integrator path", "maxdepth", ""),
    row("Integrator volpath", "maxdepth", ""),
    row("PixelFilter box", "xradius yradius", ""),
    row("LightSource infinite", "L scale filename", ""),
    row("shape sphere", "center radius to_world", ""),
    row("shape cylinder", "p0 p1 radius to_world", ""),
    row("shape disk", "to_world", ""),
    row("bsdf diffuse", "reflectance", MATTE),
    row("bsdf conductor", "specular_reflectance material eta k", ""),
    row("bsdf roughconductor", "specular_reflectance material eta k alpha distribution", ROUGH),
    row("bsdf dielectric", "int_ior ext_ior", GLASS),
    row("sensor perspective", "fov fov_axis to_world near_clip far_clip", ""),
    row("film hdrfilm", "width height pixel_format component_format", ""),
    row("sampler", "sample_count", ""),
    row("integrator path", "max_depth rr_depth", ""),
    row("rfilter box", "", ""),
    row("emitter constant", "radiance", ""),
    row("emitter envmap", "filename scale to_world", ""),
];

/// The parameters that may hold the colour of a material that is not in the table. The first that is there counts.
pub const COLORS: [&str; 3] = ["reflectance", "diffuse_reflectance", "base_color"];

/// Notes the parameters of `plugin` that have no match and removes them, and notes what differs in our picture. Returns
/// whether the plugin is in the table. A plugin that is not keeps the parameters of all types of its word.
pub fn check(plugin: &mut Plugin, notes: &mut Notes) -> bool {
    let Plugin { name, params, place } = plugin;
    let word = name.split(' ').next();
    // A row of one word is for all types.
    let found = ROWS.iter().find(|row| row.name == name || Some(row.name) == word);
    let is_for = |row: &&Row| found.map_or(row.name.split(' ').next() == word, |found| found.name == row.name);
    let rows: Vec<_> = ROWS.iter().filter(is_for).collect();
    params.retain(|param| {
        let is_read = |row: &&Row| row.params.split(' ').any(|name| name == param.name);
        let is_read = rows.iter().any(is_read) || (found.is_none() && COLORS.contains(&&param.name[..]));
        if !is_read {
            notes.add(param.place, format!("[{}] of {name} has no match; left out", param.name));
        }
        is_read
    });
    if let Some(row) = found.filter(|row| !row.differs.is_empty()) {
        notes.add(*place, row.differs);
    }
    found.is_some()
}
