//! Finds the deviations that explain a program's pictures of the [`cases`](crate::cases).
//!
//! The cases are taken in their order. As long as the deviations found so far give the program's pictures, the next
//! case follows. If a picture differs, each deviation that shows in this case and in none before is tried, and each two
//! of them. So two deviations of different stages are mostly found one after the other. Fewer deviations are tried
//! first, and equal bytes before nearly equal ones.

use std::cmp::Ordering;
use std::collections::{HashMap, HashSet};

use cpu::{Error, Scatter};

use crate::cases::Case;
use crate::develop::Picture;
use crate::renderer::Renderer;
use crate::rules::{Rules, Variant, table};

/// Deviations that together explain all pictures, and the number of bytes that differ, as by another rounding of the
/// last bit. There are no deviations for a program that follows the statement.
pub type Found = (Vec<Variant>, usize);

/// The share of a picture's bytes that may differ if no deviation gives equal bytes: one in so many.
const NEARLY: usize = 200;

/// Most deviations that are looked for together, and most of them that are not permitted.
const MOST: [usize; 2] = [3, 2];

/// The search for deviations. It keeps what it has rendered, so a second search is faster.
#[derive(Debug)]
pub struct Search<'a> {
    cases: &'a [Case],
    variants: Vec<Variant>,
    /// The pictures with one deviation or none, by the place of the deviation and the case.
    drawn: HashMap<(Option<usize>, usize), Picture>,
    /// The pictures of the program that is searched.
    pictures: Vec<Picture>,
    /// Number of bytes of the program's picture that differ, by the places of the deviations and the case.
    counts: HashMap<(Vec<usize>, usize), usize>,
    /// Whether one byte in [`NEARLY`] may differ.
    nearly: bool,
}

impl<'a> Search<'a> {
    /// Prepares a search.
    #[must_use]
    pub fn new(cases: &'a [Case]) -> Self {
        let (pictures, drawn, counts) = (Vec::new(), HashMap::new(), HashMap::new());
        Self { cases, variants: table(), drawn, pictures, counts, nearly: false }
    }

    /// Returns the deviations that explain `pictures`, one of each case. There are several results if several sets of
    /// equal size explain the pictures equally well, and none if no set of known deviations does.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub fn explain(&mut self, pictures: &[Picture]) -> Result<Vec<Found>, Error> {
        self.pictures = pictures.to_vec();
        self.counts.clear();
        for (nearly, size) in [false, true].into_iter().flat_map(|nearly| (0..=MOST[0]).map(move |size| (nearly, size)))
        {
            self.nearly = nearly;
            let mut found = Vec::new();
            self.extend(&mut Vec::new(), 0, size, &mut found)?;
            if let Some(least) = found.iter().map(|&(_, differing)| differing).min() {
                found.retain(|&(_, differing)| differing == least);
                return Ok(found);
            }
        }
        Ok(Vec::new())
    }

    /// Returns the first case in which the picture of the last search is not the statement's, nor nearly.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub fn first_wrong(&mut self) -> Result<Option<&'a Case>, Error> {
        for case in 0..self.pictures.len() {
            if self.count(&[], case)? > self.pictures[case].pixels.len() * 3 / NEARLY {
                return Ok(Some(&self.cases[case]));
            }
        }
        Ok(None)
    }

    /// Adds to `found` all sets that have the deviations of `set`, exactly `room` more, and the program's pictures.
    /// `set` must have the pictures of all cases before `case`.
    fn extend(&mut self, set: &mut Vec<usize>, from: usize, room: usize, found: &mut Vec<Found>) -> Result<(), Error> {
        let mut case = from;
        while case < self.pictures.len() && self.count(set, case)? <= self.allowed(case) {
            case += 1;
        }
        if room == 0 && case == self.pictures.len() {
            let counts: Result<Vec<_>, _> = (0..case).map(|case| self.count(set, case)).collect();
            let counts = counts?;
            if (0..case).all(|case| counts[case] <= self.allowed(case)) {
                let mut variants: Vec<_> = set.iter().map(|&at| self.variants[at].clone()).collect();
                variants.sort_by_key(|variant| variant.name);
                // Two deviations may be found together, and one after the other.
                if found.iter().all(|(known, _)| *known != variants) {
                    found.push((variants, counts.iter().sum()));
                }
            }
        }
        if room == 0 || case == self.pictures.len() {
            return Ok(());
        }
        let (mut here, mut later) = (Vec::new(), Vec::new());
        for place in 0..self.variants.len() {
            match self.first_shown(place, case)? {
                Ordering::Equal => here.push(place),
                // A bias may hide another limit, which alone shows in an earlier case.
                Ordering::Less if self.variants[place].name != "limit" => {}
                // Deviations of surfaces cannot show without objects. Elsewhere one may show with another, not alone.
                _ if self.cases[case].scene.objects.is_empty() => {}
                _ => later.push(place),
            }
        }
        for (at, &first) in here.iter().enumerate() {
            let seconds = here[at + 1..].iter().chain(&later).map(|&second| Some(second)).filter(|_| room > 1);
            for second in [None].into_iter().chain(seconds) {
                let old = set.len();
                set.push(first);
                set.extend(second);
                if self.is_allowed(set) && self.count(set, case)? <= self.allowed(case) {
                    self.extend(set, case + 1, room + old - set.len(), found)?;
                }
                set.truncate(old);
            }
        }
        Ok(())
    }

    /// Returns how many bytes of a case may differ.
    fn allowed(&self, case: usize) -> usize {
        if self.nearly { self.pictures[case].pixels.len() * 3 / NEARLY } else { 0 }
    }

    /// Returns how many bytes of the program's picture differ from that with the deviations at these places.
    fn count(&mut self, set: &[usize], case: usize) -> Result<usize, Error> {
        let key = (set.to_vec(), case);
        if !self.counts.contains_key(&key) {
            let picture = self.picture(set, case)?;
            self.counts.insert(key.clone(), differing(&picture, &self.pictures[case]));
        }
        Ok(self.counts[&key])
    }

    /// Compares the first case in which a deviation shows alone with `case`.
    fn first_shown(&mut self, place: usize, case: usize) -> Result<Ordering, Error> {
        for earlier in 0..=case {
            let [with, without] = [self.picture(&[place], earlier)?, self.picture(&[], earlier)?];
            if differing(&with, &without) > self.allowed(earlier) {
                return Ok(earlier.cmp(&case));
            }
        }
        Ok(Ordering::Greater)
    }

    /// Whether the set has one value of each deviation, and not too many faults.
    fn is_allowed(&self, set: &[usize]) -> bool {
        let faults = set.iter().filter(|&&place| !self.variants[place].permitted).count();
        let names: HashSet<_> = set.iter().map(|&place| self.variants[place].name).collect();
        names.len() == set.len() && faults <= MOST[1]
    }

    /// Returns the picture of a case with the deviations at these places.
    fn picture(&mut self, set: &[usize], case: usize) -> Result<Picture, Error> {
        let key = (set.first().copied(), case);
        if let Some(picture) = self.drawn.get(&key).filter(|_| set.len() < 2) {
            return Ok(picture.clone());
        }
        let rules = Rules::with(set.iter().map(|&place| &self.variants[place]));
        let Case { config, scene, .. } = &self.cases[case];
        let picture = Renderer::new(config, scene, Scatter::Statement, rules)?.picture()?;
        if set.len() < 2 {
            self.drawn.insert(key, picture.clone());
        }
        Ok(picture)
    }
}

/// Returns the number of bytes that differ. Of two sizes all bytes differ.
fn differing(left: &Picture, right: &Picture) -> usize {
    let differ = |(left, right): &(&u8, &u8)| left != right;
    match (left.width, left.height) == (right.width, right.height) {
        true => left.pixels.as_flattened().iter().zip(right.pixels.as_flattened()).filter(differ).count(),
        false => usize::MAX,
    }
}
