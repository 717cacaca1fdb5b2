//! Converts names in older files of results to the names in use since November 2026, so that these files can still be
//! read.

use super::Results;

/// Old and new endings of the names of the implementations of the intersections.
const IMPLEMENTATIONS: [(&str, &str); 3] =
    [("textbook f64", "plain f64"), ("certified f64", "exact f64"), ("textbook f32", "plain f32")];

/// Old and new endings of the names of the implementations of the renderer.
const ENGINES: [(&str, &str); 1] = [("-textbook", "-plain")];

/// Old and new names of what is switched off in a [`super::Gain`].
const GAINS: [(&str, &str); 2] = [("no certificate", "plain formulas"), ("literal renderer", "reference")];

/// If `text` ends with an old name of `names`, replaces that ending by the new name.
fn replace(text: &mut String, names: &[(&str, &str)]) {
    for (old, new) in names {
        if let Some(start) = text.strip_suffix(old) {
            *text = format!("{start}{new}");
        }
    }
}

impl Results {
    /// Replaces all names of older versions by the present names.
    pub(super) fn rename(&mut self) {
        let timings = self.timings.iter_mut().map(|timing| &mut timing.setting.engine);
        let omitted = self.omitted.iter_mut().map(|omitted| &mut omitted.setting.engine);
        let growth = self.growth.iter_mut().map(|growth| &mut growth.engine);
        let energy = self.energy.iter_mut().map(|energy| &mut energy.engine);
        timings.chain(omitted).chain(growth).chain(energy).for_each(|engine| replace(engine, &ENGINES));
        for intersection in &mut self.intersections {
            replace(&mut intersection.trial.implementation, &IMPLEMENTATIONS);
        }
        for gain in &mut self.gains {
            replace(&mut gain.without, &GAINS);
        }
    }
}

#[cfg(test)]
mod tests {
    use test_support::folder::Folder;

    use super::super::tests::{results, timing};
    use super::super::{Intersection, Trial};
    use crate::bench::results::Gain;
    use measure::statistics::Median;

    #[test]
    fn files_of_older_programs_have_the_names_of_today() {
        let mut old = results(vec![timing("aos-avx2-textbook", 1, &[1.0]), timing("aos-avx2", 1, &[1.0])]);
        let intersection = |name: &str| {
            let [object, rays, implementation] = ["sphere", "hard", name].map(str::to_owned);
            let trial = Trial { object, rays, implementation, seed: 1 };
            let median = Median::of(&[1.0]);
            Intersection { trial, cases: 1, wrong: 0, lambda_error: [0.0; 3], nanoseconds: vec![1.0], median }
        };
        let names = ["textbook f64", "certified f64", "textbook f32", "projected f32"];
        old.intersections = names.map(intersection).to_vec();
        let (scene, without) = ("grid".to_owned(), "literal renderer".to_owned());
        old.gains = vec![Gain { scene, without, ratio: 2.0, low: 1.0, high: 3.0 }];
        let folder = Folder::new();
        let path = folder.file("old.json");
        old.write(&path, output::Options::default()).expect("the folder is writable");
        let read = super::Results::read(&path).expect("it was written");
        let engines: Vec<_> = read.timings.iter().map(|timing| timing.setting.engine.as_str()).collect();
        assert_eq!(engines, ["aos-avx2-plain", "aos-avx2"]);
        let methods: Vec<_> = read.intersections.iter().map(|one| one.trial.implementation.as_str()).collect();
        assert_eq!(methods, ["plain f64", "exact f64", "plain f32", "projected f32"]);
        assert_eq!(read.gains[0].without, "reference");
        let today = crate::bench::intersections::METHODS;
        assert!(methods.iter().all(|name| today.contains(name)), "{today:?}");
    }
}
