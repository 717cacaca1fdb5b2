//! Writes the results as two Markdown tables.

use std::fmt::Write;

use super::measure::{Build, Results, Time};
use super::scene::Setting;

/// Returns the tables: the times of the rays, then the structures.
#[must_use]
pub fn markdown(results: &Results) -> String {
    let mut text = "| objects | spheres | ground | rays | set | ours, ns | Embree, ns | ours / Embree | agreement | \
                    self-hits |\n|--:|---|---|---|---|--:|--:|--:|--:|--:|\n"
        .to_owned();
    for Time { setting, from_surfaces, set, ours, embree } in &results.times {
        let rays = if *from_surfaces { "from surfaces" } else { "free" };
        let theirs = embree.map_or("| | | |".to_owned(), |embree| {
            let share = 100.0 * embree.agreement.share();
            format!("{:.0} | {:.2} | {share:.3} % | {} |", embree.time, embree.ratio, embree.agreement.self_hits)
        });
        let _ = writeln!(text, "{} {rays} | {set} | {ours:.0} | {theirs}", scene(setting));
    }
    text += "\n| objects | spheres | ground | build an object: ours, ns | Embree, ns | ours / Embree | bytes an object: \
             our structure | our records | Embree, all |\n|--:|---|---|--:|--:|--:|--:|--:|--:|\n";
    for Build { setting, ours, ours_bytes: [structure, records], embree } in &results.builds {
        let [time, ratio, bytes] = embree.map_or([const { String::new() }; 3], |[time, bytes]| {
            [format!("{time:.0}"), format!("{:.2}", ours / time), format!("{bytes:.0}")]
        });
        let _ = writeln!(
            text,
            "{} {ours:.0} | {time} | {ratio} | {structure:.0} | {records:.0} | {bytes} |",
            scene(setting)
        );
    }
    text
}

/// Returns the first three cells of a row, which name the scene.
fn scene(&Setting { size, dense, ground }: &Setting) -> String {
    format!("| {size} | {} | {} |", if dense { "dense" } else { "sparse" }, if ground { "yes" } else { "no" })
}
