//! Measures what each mechanism of the renderer gains: many scenes, rendered in turn with the renderer's own choice and
//! with one mechanism less, or with another structure or instruction set in place of the chosen one.

use std::path::Path;

use cpu::internals::accel::{
    choice::Accel, choice::Structure, extent::Extent, may_hit::target::targets, object::count,
};
use cpu::internals::{InstructionSet, Prepared, render_with};
use cpu::{Aos, Config, Error, Material, Scatter, Scene};
use format::digest::sha256;
use generator::{Arrangement, Options};
use measure::clock::own_seconds;
use measure::statistics::Median;
use measure::turns::{in_turn, ratio, turns_of};

use super::scenes;
use crate::{Failure, engine, interrupt, terminal};

/// A mechanism with a ratio below this loses time, and its cell is bold.
const LOSES: f64 = 0.98;

/// Largest number of objects for which every ray is tested against every object.
const MOST_IN_TURN: usize = 300;

/// A change of a prepared scene. It returns false if the scene does not have the mechanism.
type Change = fn(&mut Prepared<Aos>, &Scene) -> Result<bool, Error>;

/// The mechanisms, each with the change that takes it away or replaces it.
const CHANGES: &[(&str, Change)] = &[
    // Measures the noise: chance, and the place of a prepared scene in memory.
    ("no change", |_, _| Ok(true)),
    ("small scene or flat filter, against BVH", |prepared, scene| {
        let chosen = matches!(prepared.accel, Accel::SmallScene(_) | Accel::FlatFilter(_));
        replace(prepared, scene, chosen, Structure::Bvh(None))
    }),
    ("small scene or BVH, against flat filter", |prepared, scene| {
        let fits = count(&prepared.objects) <= 64 && !matches!(prepared.accel, Accel::FlatFilter(_));
        replace(prepared, scene, fits, Structure::FlatFilter)
    }),
    ("boxes of floats, against bytes", |prepared, scene| {
        let is_wide = matches!(prepared.accel, Accel::Bvh(_));
        replace(prepared, scene, is_wide, Structure::LargeBvh)
    }),
    ("sphere leaves", |prepared, scene| {
        let has = matches!(&prepared.accel, Accel::Bvh(bvh) if bvh.sphere_leaf_count() > 0);
        replace(prepared, scene, has, Structure::Bvh(Some(false)))
    }),
    ("boxes, against sphere leaves", |prepared, scene| {
        let has_boxes = matches!(&prepared.accel, Accel::Bvh(bvh) if bvh.sphere_leaf_count() == 0);
        replace(prepared, scene, has_boxes, Structure::Bvh(Some(true)))
    }),
    ("collapsed root", |prepared, _| Ok(prepared.accel.without_collapsed_root())),
    ("lookahead or objects in lanes, against the other", |prepared, _| Ok(prepared.accel.swap_lookahead())),
    ("isolated objects, overlaps", |prepared, _| Ok(prepared.accel.without_isolation())),
    ("chains in lanes", |prepared, scene| {
        let refracts = scene.materials.iter().any(|material| matches!(material, Material::Refractive { .. }));
        Ok(!std::mem::take(&mut prepared.chain_targets).is_empty() && refracts)
    }),
    ("culling, background pixels", |prepared, _| {
        let fits = count(&prepared.objects) <= MOST_IN_TURN;
        Ok(fits && std::mem::take(&mut prepared.moderate))
    }),
    ("last rays that hit", |prepared, _| Ok(std::mem::take(&mut prepared.scatters_everywhere))),
];

/// Replaces the structure, if `fits` is set, which is returned.
fn replace(prepared: &mut Prepared<Aos>, scene: &Scene, fits: bool, structure: Structure) -> Result<bool, Error> {
    if fits {
        let extent = Extent::new(&prepared.objects, &prepared.camera, &scene.materials);
        prepared.accel = Accel::of(structure, &mut prepared.objects, &extent)?;
        // The new structure has reordered the objects.
        prepared.chain_targets = targets(&prepared.objects, &extent)?;
    }
    Ok(fits)
}

/// Returns the table: a row for each scene, and a column for each mechanism and instruction set. A cell is the time
/// without the mechanism, divided by the time with it, with its bounds. It is bold if the mechanism loses time.
///
/// # Errors
/// An error of the renderer or a file, a change that changes the picture, or [`Failure::Interrupted`].
pub fn table(repeats: usize, quick: bool) -> Result<String, Failure> {
    interrupt::listen();
    measure::busy::warning(measure::busy::load()).iter().for_each(|warning| terminal::note(warning));
    let (own, sets) = (InstructionSet::chosen(), InstructionSet::available());
    let others: Vec<_> = sets.filter(|set| set.name() != own.name()).collect();
    let heads = CHANGES.iter().map(|(name, _)| (*name).to_owned());
    let heads: Vec<_> =
        heads.chain(others.iter().map(|set| format!("{}, against {}", own.name(), set.name()))).collect();
    let mut table = format!("| Scene | {} |\n|---|{}\n", heads.join(" | "), "--:|".repeat(heads.len()));
    for (name, config, scene) in all(quick)? {
        let start = std::time::Instant::now();
        let gains = gains((&config, &scene), (own, &others), repeats)?;
        let cells: Vec<_> = gains.iter().map(|gain| gain.as_ref().map_or_else(String::new, cell)).collect();
        table += &format!("| {name} | {} |\n", cells.join(" | "));
        terminal::note(&format!("{name}: {:.0} s", start.elapsed().as_secs_f64()));
    }
    Ok(table)
}

/// Returns a gain as text. It is bold if the median is below [`LOSES`] and the upper bound below 1.
fn cell(gain: &Median) -> String {
    let text = format!("{:.2} ({:.2} to {:.2})", gain.median, gain.low, gain.high);
    if gain.median < LOSES && gain.high < 1.0 { format!("**{text}**") } else { text }
}

/// Returns the gain of each mechanism, and of the set `own` over each of `others`. A mechanism that the scene does not
/// have has no gain.
fn gains(
    (config, scene): (&Config, &Scene),
    (own, others): (InstructionSet, &[InstructionSet]),
    repeats: usize,
) -> Result<Vec<Option<Median>>, Failure> {
    let new = || Prepared::<Aos>::new(config, scene, Scatter::Statement);
    let mut trials = vec![(new()?, own)];
    let mut place = Vec::new();
    for (_, change) in CHANGES {
        let mut prepared = new()?;
        let has = change(&mut prepared, scene)?;
        place.push(has.then_some(trials.len()));
        trials.extend(has.then_some((prepared, own)));
    }
    for &set in others {
        place.push(Some(trials.len()));
        trials.push((new()?, set));
    }
    let mut turns = Vec::new();
    let mut digest = None;
    for (index, (prepared, set)) in trials.iter().enumerate() {
        interrupt::check()?;
        let before = own_seconds();
        let picture = render_with(prepared, *set)?;
        turns.push(turns_of(own_seconds() - before));
        let own = sha256(&engine::bytes(&picture));
        if *digest.get_or_insert_with(|| own.clone()) != own {
            return Err(format!("trial {index} makes another picture").into());
        }
    }
    let times = in_turn(repeats, &turns, own_seconds, |index| {
        interrupt::check()?;
        let (prepared, set) = &trials[index];
        std::hint::black_box(render_with(prepared, *set)?);
        Ok::<(), Failure>(())
    })?;
    Ok(place.into_iter().map(|place| place.map(|place| ratio(&times[place], &times[0]))).collect())
}

/// The bundled scene whose error is not measured, and so is not in [`scenes`]: configuration and scene.
const CYLINDERS: [&str; 2] =
    [include_str!("../../../scenes/cylinders/config.txt"), include_str!("../../../scenes/cylinders/scene.txt")];

/// The generated scenes: the number of objects, the arrangement, and the share of cylinders.
const GENERATED: &[(usize, Arrangement, f64)] = &[
    (1, Arrangement::Scattered, 0.0),
    (2, Arrangement::Grid, 0.5),
    (3, Arrangement::Scattered, 0.5),
    (5, Arrangement::Grid, 0.5),
    (8, Arrangement::Scattered, 0.5),
    (9, Arrangement::Scattered, 0.5),
    (16, Arrangement::Grid, 0.5),
    (16, Arrangement::Scattered, 1.0),
    (30, Arrangement::Scattered, 0.0),
    (40, Arrangement::Grid, 0.5),
    (64, Arrangement::Scattered, 0.5),
    (65, Arrangement::Grid, 0.5),
    (101, Arrangement::Scattered, 0.0),
    (300, Arrangement::Grid, 0.5),
    (1000, Arrangement::Scattered, 0.5),
    (10_000, Arrangement::Grid, 0.0),
    (100_000, Arrangement::Scattered, 0.0),
];

/// Returns all scenes with their names: bundled ones, those of the course if `RENDER_REFERENCE_DIR` names their folder,
/// and generated ones, two of them in a room.
fn all(quick: bool) -> Result<Vec<(String, Config, Scene)>, Failure> {
    let width = if quick { 48 } else { 400 };
    let sized = |config: Config| Config { image_width: width, samples_per_pixel: 4, ..config };
    let (config, scene) = (Config::parse(CYLINDERS[0].as_bytes())?, Scene::parse(CYLINDERS[1].as_bytes())?);
    let mut all = vec![("`scenes/cylinders`".to_owned(), sized(config), scene)];
    for name in scenes::NAMES {
        all.extend(scenes::named(name).map(|(config, scene)| (format!("`scenes/{name}`"), sized(config), scene)));
    }
    if let Some(folder) = std::env::var_os("RENDER_REFERENCE_DIR") {
        for case in 2..=4 {
            let read = |kind: &str| {
                let path = Path::new(&folder).join(format!("{kind}{case}.txt"));
                std::fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))
            };
            let (config, scene) = (Config::parse(&read("config")?[..])?, Scene::parse(&read("scene")?[..])?);
            all.push((format!("case {case}"), sized(config), scene));
        }
    }
    for &(objects, arrangement, cylinders) in GENERATED {
        let options =
            Options { objects, arrangement, cylinders, materials: [3.0, 2.0, 1.0], extent: 8.0, ..Options::default() };
        let place = if arrangement == Arrangement::Grid { "on a ground" } else { "scattered" };
        let kind = if cylinders == 0.0 {
            "spheres"
        } else if cylinders < 1.0 {
            "mixed"
        } else {
            "cylinders"
        };
        let (config, scene) = (sized(generator::view(&options)), generator::scene(&options));
        if matches!(objects, 3 | 30) {
            let room = format!("{}sphere: 0 0 0 60 room\n", generator::write::scene(&scene));
            let scene = Scene::parse(format!("metal: room .8 .8 .8 .3\n{room}").as_bytes())?;
            all.push((format!("{objects} {kind} in a room"), config.clone(), scene));
        }
        all.push((format!("{objects} {kind} {place}"), config, scene));
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_change_keeps_the_picture_and_every_mechanism_is_in_a_scene() {
        let own = InstructionSet::chosen();
        let mut has = vec![false; CHANGES.len()];
        for (name, config, scene) in all(true).expect("the scenes are valid") {
            if scene.objects.len() <= 1000 {
                let gains = gains((&config, &scene), (own, &[]), 1).unwrap_or_else(|_| panic!("{name}"));
                has.iter_mut().zip(gains).for_each(|(has, gain)| *has |= gain.is_some());
            }
        }
        let missing: Vec<_> = CHANGES.iter().zip(&has).filter(|(_, has)| !**has).map(|((name, _), _)| *name).collect();
        assert!(missing.is_empty(), "{missing:?}");
    }

    #[test]
    fn a_loss_is_marked_if_its_bounds_exclude_chance() {
        let gain = |median, low, high| cell(&Median { median, low, high, confidence: 0.95 });
        assert_eq!(gain(0.97, 0.95, 0.99), "**0.97 (0.95 to 0.99)**");
        assert_eq!(gain(0.97, 0.95, 1.01), "0.97 (0.95 to 1.01)");
        assert_eq!(gain(1.2, 1.1, 1.3), "1.20 (1.10 to 1.30)");
    }
}
