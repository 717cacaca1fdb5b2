//! `generate CONFIG SCENE [option=value]...`: writes a generated scene and a configuration that shows it.
//!
//! Options, with their defaults: `seed=1 objects=100 cylinders=0.5 matte=2 metal=1 refractive=1 extent=10
//! arrangement=scattered` (or `grid`, `degenerate`). The folder `scenes` says how its generated scenes were made.

use std::error::Error;
use std::fs;

use tests::generator::{self, Arrangement, Options};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [config, scene, settings @ ..] = &arguments[..] else {
        return Err("two names are needed: CONFIG and SCENE".into());
    };
    let mut options = Options::default();
    for setting in settings {
        set(&mut options, setting).map_err(|error| format!("{setting}: {error}"))?;
    }
    fs::write(config, tests::write::config(&generator::view(&options)))?;
    fs::write(scene, tests::write::scene(&generator::scene(&options)))?;
    Ok(())
}

fn set(options: &mut Options, setting: &str) -> Result<(), Box<dyn Error>> {
    let (name, value) = setting.split_once('=').ok_or("not an option=value")?;
    match name {
        "seed" => options.seed = value.parse()?,
        "objects" => options.objects = value.parse()?,
        "cylinders" => options.cylinders = value.parse()?,
        "matte" => options.materials[0] = value.parse()?,
        "metal" => options.materials[1] = value.parse()?,
        "refractive" => options.materials[2] = value.parse()?,
        "extent" => options.extent = value.parse()?,
        "arrangement" => {
            options.arrangement = match value {
                "scattered" => Arrangement::Scattered,
                "grid" => Arrangement::Grid,
                "degenerate" => Arrangement::Degenerate,
                _ => return Err("unknown arrangement".into()),
            }
        }
        _ => return Err("unknown option".into()),
    }
    Ok(())
}
