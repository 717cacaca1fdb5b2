//! Reads a configuration line by line, according to the table in the specification, section 3.1.

use cpu::{Config, Vec3};

use super::lines::{lines, positive_integer, real, tokens};

/// Returns the configuration in the text of a file.
///
/// # Errors
/// The message of the first wrong line, without `Error: `.
pub fn parse(text: &[u8]) -> Result<Config, Vec<u8>> {
    let mut config = Config::default();
    for line in lines(text) {
        let places = tokens(line);
        let Some(&(start, end)) = places.first() else { continue };
        let key = &line[start..end];
        let values: Vec<&[u8]> = places[1..].iter().map(|&(start, end)| &line[start..end]).collect();
        let count = match key {
            b"aspect_ratio:" => 2,
            b"camera_position:"
            | b"camera_target:"
            | b"camera_north:"
            | b"background_dark_color:"
            | b"background_light_color:" => 3,
            b"image_width:"
            | b"gamma:"
            | b"field_of_view:"
            | b"samples_per_pixel:"
            | b"max_depth:"
            | b"material_rng_seed:"
            | b"ray_rng_seed:" => 1,
            _ => {
                let colon: &[u8] = if key.last() == Some(&b':') { b"" } else { b":" };
                return Err([b"Unknown configuration key: [", key, colon, b"]"].concat());
            }
        };
        if values.len() < count || assign(&mut config, key, &values[..count]).is_none() {
            return Err([b"Invalid value for key: [", key, b"]\nLine: \"", line, b"\""].concat());
        }
        if values.len() > count {
            let (from, to) = (places[count + 1].0, places[places.len() - 1].1);
            let extra = &line[from..to];
            return Err(
                [b"Extra data after configuration value for key: [", key, b"]\nExtra: \"", extra, b"\""].concat()
            );
        }
    }
    Ok(config)
}

fn assign(config: &mut Config, key: &[u8], values: &[&[u8]]) -> Option<()> {
    let vector = || Some(Vec3::new(real(values[0])?, real(values[1])?, real(values[2])?));
    let color = || vector().filter(|color| color.to_array().iter().all(|&channel| (0.0..=1.0).contains(&channel)));
    match key {
        b"aspect_ratio:" => config.aspect_ratio = [positive_integer(values[0])?, positive_integer(values[1])?],
        b"image_width:" => config.image_width = positive_integer(values[0])?,
        b"gamma:" => config.gamma = real(values[0]).filter(|&gamma| gamma > 0.0)?,
        b"camera_position:" => config.camera_position = vector()?,
        b"camera_target:" => config.camera_target = vector()?,
        b"camera_north:" => config.camera_north = vector()?,
        b"field_of_view:" => config.field_of_view = real(values[0]).filter(|&fov| 0.0 < fov && fov < 180.0)?,
        b"samples_per_pixel:" => config.samples_per_pixel = positive_integer(values[0])?,
        b"max_depth:" => config.max_depth = positive_integer(values[0])?,
        b"material_rng_seed:" => config.material_rng_seed = positive_integer(values[0])?,
        b"ray_rng_seed:" => config.ray_rng_seed = positive_integer(values[0])?,
        b"background_dark_color:" => config.background_dark_color = color()?,
        b"background_light_color:" => config.background_light_color = color()?,
        _ => return None,
    }
    Some(())
}
