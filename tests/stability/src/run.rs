//! Runs the stress test: every regime with every implementation, whole pictures, and spheres of growing radius.

use cpu::reference::intersect::Plain;
use cpu::{Aos, Config, Error, Image, Layout, Scatter, Scene};

use crate::measure::{Judged, Row};
use crate::methods::{self, Failure, Method, PLAIN};
use crate::observed::{Observed, take_counts};
use crate::regimes::{Regime, large};
use crate::report::{Picture, Section};

/// Measures the implementations `methods` with `count` cases of each regime. Returns a section for each regime.
///
/// # Errors
/// The errors of [`Method::answer`] and [`Method::stopwatch`], and a regime with fewer than one hit in 50 cases, which
/// measures nothing.
pub fn sections(
    methods: &[Box<dyn Method>],
    regimes: &[Regime],
    seed: u64,
    count: usize,
) -> Result<Vec<Section>, Failure> {
    let section = |regime: &Regime| {
        let judged = Judged::new(regime.name, regime.cases(seed, count));
        let rows = methods.iter().map(|method| judged.measure(method.as_ref())).collect::<Result<Vec<_>, _>>()?;
        if let Some(row) = rows.iter().find(|row| row.hits * 50 < row.cases) {
            return Err(format!("{}: only {} hits of {}", row.regime, row.hits, row.cases).into());
        }
        Ok(Section { rows, fallbacks: judged.fallbacks() })
    };
    regimes.iter().map(section).collect()
}

/// Renders a picture with exact intersections, and counts the decisions of the filter. Renders it again with the plain
/// formulas, and compares the bytes of both.
///
/// # Errors
/// The errors of [`cpu::reference::render`].
pub fn picture(name: &str, config: &Config, scene: &Scene, scatter: Scatter) -> Result<Picture, Error> {
    type Pixels = <Aos as Layout>::Image;
    let _ = take_counts();
    let exact: Pixels = cpu::reference::render_with::<_, Observed>(config, scene, scatter)?;
    let counts = take_counts();
    let plain: Pixels = cpu::reference::render_with::<_, Plain>(config, scene, scatter)?;
    let same_bytes = (0..exact.size().pixels()).all(|index| exact.pixel(index) == plain.pixel(index));
    Ok(Picture { name: name.into(), counts, same_bytes })
}

/// The prefix in the name of an implementation in WGSL. The name of the implementation with its formulas in Rust
/// follows.
pub const WGSL: &str = "WGSL ";

/// Shares of wrong decisions for rays that leave spheres of growing radius.
#[derive(Clone, Debug)]
pub struct LargeSpheres {
    /// The radii, in rising order.
    pub radii: Vec<f64>,
    /// Each implementation's name, with its share of wrong decisions (from 0 to 1) for each radius.
    pub wrong: Vec<(&'static str, Vec<f64>)>,
}

impl LargeSpheres {
    /// Measures the implementations `methods` with `count` rays for each radius.
    ///
    /// # Errors
    /// The errors of [`Method::answer`] and [`Method::stopwatch`].
    pub fn new(methods: &[Box<dyn Method>], seed: u64, count: usize) -> Result<Self, Failure> {
        let radii: Vec<f64> = (0..=18).map(|half_decades| 10.0_f64.powf(f64::from(half_decades) / 2.0)).collect();
        let mut wrong: Vec<(&'static str, Vec<f64>)> = Vec::new();
        for &radius in &radii {
            let judged = Judged::new("large spheres", large(radius, seed, count));
            for method in methods {
                let row = judged.measure(method.as_ref())?;
                let share = row.wrong() as f64 / row.cases as f64;
                match wrong.iter_mut().find(|(name, _)| *name == row.method) {
                    Some((_, shares)) => shares.push(share),
                    None => wrong.push((row.method, vec![share])),
                }
            }
        }
        Ok(Self { radii, wrong })
    }

    /// Returns the largest radius up to which every share of wrong decisions of `method` is at most `share`, or 0 if
    /// there is none.
    #[must_use]
    pub fn limit(&self, method: &str, share: f64) -> f64 {
        let shares = self.wrong.iter().find(|(name, _)| *name == method).map(|(_, shares)| shares.as_slice());
        let good = shares.unwrap_or_default().iter().take_while(|&&wrong| wrong <= share).count();
        good.checked_sub(1).map_or(0.0, |last| self.radii[last])
    }
}

/// Returns the rows of implementations in WGSL whose figures differ from those of their formulas in Rust. Times are not
/// compared.
#[must_use]
pub fn parted_from_their_twins(sections: &[Section]) -> Vec<&Row> {
    let figures = |row: &Row| Row { method: "", nanoseconds: 0.0, ..row.clone() };
    let parted = |section: &Section, row: &Row| {
        let twin = row.method.strip_prefix(WGSL);
        let twin = twin.and_then(|name| section.rows.iter().find(|row| row.method == name));
        twin.is_some_and(|twin| figures(twin) != figures(row))
    };
    sections.iter().flat_map(|section| section.rows.iter().filter(move |row| parted(section, row))).collect()
}

/// Bounds of the relative error of lambda that docs/accuracy.md proves: the first for spheres, the second for
/// cylinders. The bound for cylinders is that of the caps, which is larger than that of the side.
pub const PROVEN_ERRORS: [f64; 2] = [5.9e-12, 6.0e-10];

/// Checks the sections of one kind of object. The exact intersections must never decide wrongly, and their largest
/// error of lambda must be at most `proven_error`. The projected form must not decide wrongly beyond 8uS. Returns the
/// number of wrong decisions of the plain formulas.
///
/// # Errors
/// A line for each regime and implementation that fails. It begins with `kind`, the name of the objects.
pub fn check(kind: &str, sections: &[Section], proven_error: f64) -> Result<usize, String> {
    let (mut plain_wrong, mut failures) = (0, Vec::new());
    for row in sections.iter().flat_map(|section| &section.rows) {
        let (wrong, [.., most]) = (row.wrong(), row.lambda_error);
        if row.method == PLAIN {
            plain_wrong += wrong;
        }
        if row.method == methods::EXACT && (wrong > 0 || most > proven_error) {
            let [hit, part, root] = row.faults;
            failures.push(format!(
                "{kind}, {}, {}: {hit} wrong hits, {part} wrong parts and {root} wrong roots; largest error of lambda {most:e}, \
                 proved {proven_error:e}",
                row.regime, row.method
            ));
        }
        let is_projected = row.method.ends_with(methods::PROJECTED);
        if let (true, Some(beyond @ 1..)) = (is_projected, row.wrong_beyond_noise) {
            failures.push(format!("{kind}, {}, {}: {beyond} wrong beyond 8uS", row.regime, row.method));
        }
    }
    if failures.is_empty() { Ok(plain_wrong) } else { Err(failures.join("\n")) }
}

#[cfg(test)]
mod tests;
