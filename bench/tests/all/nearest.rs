//! Compares the nearest hits of the program `nearest` with those of every object, and with Embree's if it is installed.
//! Without Embree the tests that need it are shown as ignored.

use bench::nearest::Start;
use bench::nearest::agreement::Agreement;
use bench::nearest::embree::{self, Embree, SingleRay};
use bench::nearest::measure::{Options, measure};
use bench::nearest::ours::Ours;
use bench::nearest::scene::{Setting, free_rays, surface_rays};
use bench::nearest::{NO_PLACE, table};
use cpu::internals::InstructionSet;
use libtest_mimic::Trial;
use test_support::trial;

const SIZES: [usize; 2] = [33, 1_000];

/// Returns the trials.
pub fn trials() -> Vec<Trial> {
    let missing = embree::missing().map(|_| "needs libembree-dev");
    vec![
        trial("our hits are those of every object", None, || Ok(our_hits_are_right()?)),
        trial("without Embree the rows have empty cells", None, || Ok(check_rows(false)?)),
        trial("the hits agree with Embree's", missing, || Ok(hits_agree()?)),
        trial("with Embree the rows have no empty cell", missing, || Ok(check_rows(true)?)),
    ]
}

/// Calls `check` with every scene of the sizes, and with its rays from surfaces and free rays.
fn of_every_scene(rays: usize, check: impl Fn(Setting, &Ours, &[Start]) -> Result<(), String>) -> Result<(), String> {
    for setting in SIZES.into_iter().flat_map(Setting::all) {
        let scene = setting.scene();
        let ours = Ours::new(&scene).map_err(|error| error.to_string())?;
        let starts = surface_rays(rays, &scene, &ours);
        assert!(starts.len() == rays && starts.iter().all(|start| start.from != NO_PLACE), "{setting:?}");
        check(setting, &ours, &starts)?;
        check(setting, &ours, &free_rays(rays, 2))?;
    }
    Ok(())
}

fn our_hits_are_right() -> Result<(), String> {
    of_every_scene(3_000, |setting, ours, starts| {
        let expected = ours.hits_without_structure(starts);
        let hits = expected.iter().filter(|hit| hit.place != NO_PLACE).count();
        assert!(hits > 50 && hits < starts.len() - 50, "{setting:?}: {hits} hits");
        for set in InstructionSet::available() {
            let mut found = Vec::new();
            ours.find(set, &ours.prepare(starts), &mut found);
            assert_eq!(found, expected, "{setting:?}, {}", set.name());
        }
        Ok(())
    })
}

fn hits_agree() -> Result<(), String> {
    of_every_scene(20_000, |setting, ours, starts| {
        let embree = Embree::new(&setting.scene(), "avx2")?;
        let rays: Vec<_> = starts.iter().map(SingleRay::new).collect();
        let mut hits = Vec::new();
        embree.find(&rays, &mut hits);
        let agreement = Agreement::new(starts, &ours.hits(starts), &hits);
        assert!(agreement.is_enough() && agreement.self_hits < starts.len() / 100, "{setting:?}: {agreement:?}");
        Ok(())
    })
}

/// Checks the rows of a scene, measured with or without Embree.
fn check_rows(embree: bool) -> Result<(), String> {
    let sets = vec![("avx2", InstructionSet::fused())];
    let times = measure(Setting::all(SIZES[0])[0], &Options { rounds: 1, rays: 1_000, sets, embree })?;
    assert_eq!(times.len(), 2, "surfaces and free rays");
    for row in times.iter().map(table::row) {
        assert!(table::HEAD.lines().all(|line| line.matches('|').count() == row.matches('|').count()), "{row}");
        assert_eq!(row.contains("| |"), !embree, "{row}");
    }
    Ok(())
}
