//! Measures both sides in turn.

use ::measure::statistics::Median;
use ::measure::turns::{compare, seconds_of};
use cpu::internals::InstructionSet;
use serde::Serialize;

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
#[derive(Clone, Debug, Serialize)]
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
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Embrees {
    /// Median of Embree's user time, in ns a ray.
    pub time: f64,
    /// Median of the rounds' ratios ours / Embree.
    pub ratio: f64,
    /// How many hits are the same.
    pub agreement: Agreement,
}

/// Time and memory of building a structure.
#[derive(Clone, Debug, Serialize)]
pub struct Build {
    /// The scene.
    pub setting: Setting,
    /// Median of the time of our structure, in ns an object.
    pub ours: f64,
    /// Bytes an object of our structure, and of our records of the objects.
    pub ours_bytes: [f64; 2],
    /// Median of the time of Embree's structure in ns an object, and its bytes an object with the objects. It has the
    /// first instruction set of the options.
    pub embree: Option<[f64; 2]>,
}

/// The result of the comparison.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Results {
    /// The time of a ray, for each scene, each kind of rays and each instruction set.
    pub times: Vec<Time>,
    /// Time and memory of the structures, for each scene.
    pub builds: Vec<Build>,
}

impl Results {
    /// Measures a scene, and adds the results.
    ///
    /// # Errors
    /// A message if memory is short, if Embree reports an error, or if hardly a ray of the scene hits.
    pub fn add(&mut self, setting: Setting, options: &Options) -> Result<(), String> {
        let scene = setting.scene();
        let build = || Ours::new(&scene).map_err(|error| error.to_string());
        let ours = build()?;
        let starts = [surface_rays(options.rays, &scene, &ours), free_rays(options.rays, 2)];
        if starts[0].len() < options.rays {
            return Err(format!("{setting:?}: too few rays hit; choose fewer --rays"));
        }
        let (mut our_builds, mut embree_builds, mut embree_bytes) = (vec![ours.build_seconds], Vec::new(), 0);
        for &(name, set) in &options.sets {
            let embree = if options.embree { Some(Embree::new(&scene, name)?) } else { None };
            if let Some(embree) = embree.as_ref().filter(|_| embree_builds.is_empty()) {
                (embree_builds, embree_bytes) = (vec![embree.build_seconds], embree.bytes());
            }
            for (starts, from_surfaces) in starts.iter().zip([true, false]) {
                let (ours, embree) = rays(&ours, set, embree.as_ref(), starts, options.rounds);
                self.times.push(Time { setting, from_surfaces, set: name, ours, embree });
            }
        }
        for _ in 1..options.rounds {
            our_builds.push(build()?.build_seconds);
            if options.embree {
                embree_builds.push(Embree::new(&scene, options.sets[0].0)?.build_seconds);
            }
        }
        let an_object = |amount: f64| amount / scene.objects.len() as f64;
        self.builds.push(Build {
            setting,
            ours: an_object(Median::of(&our_builds).median * 1e9),
            ours_bytes: [ours.bytes(), ours.record_bytes()].map(|bytes| an_object(bytes as f64)),
            embree: options
                .embree
                .then(|| [Median::of(&embree_builds).median * 1e9, embree_bytes as f64].map(an_object)),
        });
        Ok(())
    }

    /// Returns the times for which too few hits agree with Embree's.
    pub fn disagreements(&self) -> impl Iterator<Item = &Time> {
        self.times.iter().filter(|time| time.embree.is_some_and(|embree| !embree.agreement.is_enough()))
    }
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
