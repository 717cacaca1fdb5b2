//! Writes the results as a Markdown table.

use super::measure::Time;

/// The head of the table.
pub const HEAD: &str = "\
| objects | spheres | ground | rays | set | ours, ns | Embree, ns | ours / Embree | agreement | self-hits |
|--:|---|---|---|---|--:|--:|--:|--:|--:|";

/// Returns a row of the table. Without Embree its last cells are empty.
#[must_use]
pub fn row(Time { setting, from_surfaces, set, ours, embree }: &Time) -> String {
    let spheres = if setting.dense { "dense" } else { "sparse" };
    let ground = if setting.ground { "yes" } else { "no" };
    let rays = if *from_surfaces { "from surfaces" } else { "free" };
    let theirs = embree.map_or("| | | |".to_owned(), |embree| {
        let share = 100.0 * embree.agreement.share();
        format!("{:.0} | {:.2} | {share:.3} % | {} |", embree.time, embree.ratio, embree.agreement.self_hits)
    });
    format!("| {} | {spheres} | {ground} | {rays} | {set} | {ours:.0} | {theirs}", setting.size)
}
