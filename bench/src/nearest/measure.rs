//! Measures both sides in turn.

use ::measure::statistics::Median;
use ::measure::turns::{compare, seconds_of};
use cpu::internals::InstructionSet;

use super::Start;
use super::agreement::Agreement;
use super::embree::{Embree, SingleRay};
use super::ours::Ours;
use super::scene::{Setting, free_rays, surface_rays};

/// What is measured, beside the scenes.
#[derive(Clone, Debug)]
pub struct Options {
    /// Number of measurements of each time, at least 1.
    pub rounds: usize,
    /// Number of rays in each measurement, at least 1.
    pub rays: usize,
    /// The instruction sets: each with its name, which is Embree's too.
    pub sets: Vec<(&'static str, InstructionSet)>,
    /// Whether Embree is measured too.
    pub embree: bool,
}

/// The time of the rays of one kind in a scene, with one instruction set.
#[derive(Clone, Debug)]
pub struct Time {
    /// The scene.
    pub setting: Setting,
    /// Whether the rays start on surfaces.
    pub from_surfaces: bool,
    /// Name of the instruction set.
    pub set: &'static str,
    /// Median of our user time, in ns a ray.
    pub ours: f64,
    /// What is known of Embree, if it is measured.
    pub embree: Option<Embrees>,
}

/// Embree's part of a [`Time`].
#[derive(Clone, Copy, Debug)]
pub struct Embrees {
    /// Median of Embree's user time, in ns a ray.
    pub time: f64,
    /// Median of the rounds' ratios ours / Embree.
    pub ratio: f64,
    /// How many hits are the same.
    pub agreement: Agreement,
}

/// Measures a scene: for each instruction set the rays from surfaces, then the free ones.
///
/// # Errors
/// A message if memory is short, if Embree reports an error, or if hardly a ray of the scene hits.
pub fn measure(setting: Setting, options: &Options) -> Result<Vec<Time>, String> {
    let scene = setting.scene();
    let our_scene = Ours::new(&scene).map_err(|error| error.to_string())?;
    let starts = [surface_rays(options.rays, &scene, &our_scene), free_rays(options.rays, 2)];
    if starts[0].len() < options.rays {
        return Err(format!("{setting:?}: too few rays hit; choose fewer --rays"));
    }
    let mut times = Vec::new();
    for &(name, set) in &options.sets {
        let embree = if options.embree { Some(Embree::new(&scene, name)?) } else { None };
        for (starts, from_surfaces) in starts.iter().zip([true, false]) {
            let (ours, embree) = rays(&our_scene, set, embree.as_ref(), starts, options.rounds);
            times.push(Time { setting, from_surfaces, set: name, ours, embree });
        }
    }
    Ok(times)
}

/// Returns our time in ns a ray, and Embree's part if `embree` is given. The rounds alternate.
fn rays(
    ours: &Ours,
    set: InstructionSet,
    embree: Option<&Embree>,
    starts: &[Start],
    rounds: usize,
) -> (f64, Option<Embrees>) {
    let prepared = ours.prepare(starts);
    let mut our_hits = Vec::with_capacity(starts.len());
    let mut find = || ours.find(set, &prepared, std::hint::black_box(&mut our_hits));
    let ns = |seconds: f64| seconds * 1e9 / starts.len() as f64;
    let Some(embree) = embree else {
        return (ns(Median::of(&(0..rounds).map(|_| seconds_of(&mut find)).collect::<Vec<_>>()).median), None);
    };
    let single: Vec<_> = starts.iter().map(SingleRay::new).collect();
    let mut hits = Vec::with_capacity(starts.len());
    let find_embree = || embree.find(&single, std::hint::black_box(&mut hits));
    let [embree_time, our_time, ratio] = compare(rounds, find_embree, find);
    let agreement = Agreement::new(starts, &our_hits, &hits);
    (ns(our_time), Some(Embrees { time: ns(embree_time), ratio, agreement }))
}
