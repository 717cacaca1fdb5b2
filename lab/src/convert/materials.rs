//! Materials of both formats as ours.

use cpu::{Material, Vec3};

use super::matches;
use super::notes::{Fault, Notes, Place};
use super::plugin::{Plugin, shown};

/// Colours of metals that both formats know by name.
const METALS: [(&str, [f64; 3]); 4] =
    [("Ag", [0.97, 0.96, 0.91]), ("Al", [0.91, 0.92, 0.92]), ("Au", [1.0, 0.78, 0.34]), ("Cu", [0.95, 0.64, 0.54])];

/// Returns the material that matches `plugin` best. Notes what differs.
///
/// # Errors
/// A fault if a number is wrong.
pub fn matching(plugin: &mut Plugin, notes: &mut Notes) -> Result<Material, Fault> {
    if !matches::check(plugin, notes) {
        let text = format!("{} has no match; metal, refractive or matte of its colour takes its place", plugin.name);
        notes.add(plugin.place, text);
    }
    let (is_mitsuba, kind) = (plugin.name.starts_with("bsdf"), plugin.kind());
    if kind.contains("conductor") {
        let reflectance = limited(metal(plugin, is_mitsuba, notes)?, plugin.place, notes);
        let (name, default) =
            (if is_mitsuba { "alpha" } else { "roughness" }, if kind == "conductor" { 0.0 } else { 0.1 });
        let alpha = match plugin.color(name, [default; 3], notes)?.x {
            roughness if !is_mitsuba && plugin.text("remaproughness") != Some("false") => roughness.sqrt(),
            alpha => alpha,
        };
        if alpha > 0.0 && !is_mitsuba {
            notes.add(plugin.place, matches::ROUGH);
        }
        let fault = || (plugin.place_of(name), "the roughness must be a number of at least 0".to_owned());
        return (alpha >= 0.0).then_some(Material::Metal { reflectance, diffusion: 2.0 * alpha }).ok_or_else(fault);
    }
    if kind.contains("dielectric") {
        let mut index = |name, default: f64| Ok(plugin.color(name, [default; 3], notes)?.x);
        let index =
            if is_mitsuba { index("int_ior", 1.5046)? / index("ext_ior", 1.000277)? } else { index("eta", 1.5)? };
        let name = if is_mitsuba { "int_ior" } else { "eta" };
        let fault = || (plugin.place_of(name), "the refractive index must be a number above 0".to_owned());
        let is_valid = index > 0.0 && index.is_finite();
        return is_valid.then_some(Material::Refractive { index }).ok_or_else(fault);
    }
    let name = matches::COLORS.into_iter().find(|name| plugin.param(name).is_some()).unwrap_or_default();
    let color = plugin.color(name, [0.5; 3], notes)?;
    Ok(Material::Matte { reflectance: limited(color, plugin.place_of(name), notes) })
}

/// Returns the colour of a metal: as it is given, by its name, or by its refractive index eta + ik.
fn metal(plugin: &Plugin, is_mitsuba: bool, notes: &mut Notes) -> Result<Vec3, Fault> {
    if plugin.param("reflectance").is_some() {
        return plugin.color("reflectance", [0.5; 3], notes);
    }
    let named = if is_mitsuba { plugin.text("material") } else { plugin.text("eta").or(Some("metal-Cu-eta")) };
    let preset = METALS.iter().find(|(name, _)| named.is_some_and(|text| text.split('-').any(|part| part == *name)));
    if let (true, None, Some(text)) = (is_mitsuba, preset, named.filter(|text| *text != "none")) {
        let text = format!("the metal [{}] has no match; a perfect mirror takes its place", shown(text));
        notes.add(plugin.place_of("material"), text);
    }
    let color = if let Some(&(_, color)) = preset {
        Vec3::from(color)
    } else {
        // The reflectance of light that falls straight on the metal.
        let (eta, k) = (plugin.color("eta", [0.0; 3], notes)?, plugin.color("k", [1.0; 3], notes)?);
        let part = |sign: f64| eta.map(|n| (n + sign) * (n + sign)) + k.attenuate(k);
        part(-1.0).attenuate(part(1.0).map(|most| 1.0 / most))
    };
    Ok(color.attenuate(plugin.color("specular_reflectance", [1.0; 3], notes)?))
}

/// Returns a colour with channels from 0 to 1, which ours must be. Notes a change.
pub fn limited(color: Vec3, place: Place, notes: &mut Notes) -> Vec3 {
    let limited = color.map(|channel| if channel > 0.0 { channel.min(1.0) } else { 0.0 });
    if limited != color {
        notes.add(place, "a colour is limited to the range from 0 to 1");
    }
    limited
}
