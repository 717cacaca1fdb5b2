//! The list of all probes, by topic.

mod comparison;
mod control;
mod conversion;
mod division;
mod extrema;
mod functions;
mod integer;
mod memory;
mod rewriting;
mod rounding;
mod subnormal;

use super::probe::Probe;

/// Returns all probes, in the order of the table.
#[must_use]
pub fn all() -> Vec<Probe> {
    let groups = [
        ("rewriting", rewriting::probes()),
        ("subnormal", subnormal::probes()),
        ("division and root", division::probes()),
        ("rounding", rounding::probes()),
        ("conversion", conversion::probes()),
        ("minimum and maximum", extrema::probes()),
        ("comparison", comparison::probes()),
        ("functions", functions::probes()),
        ("integer", integer::probes()),
        ("memory", memory::probes()),
        ("control flow", control::probes()),
    ];
    let of_group = |(group, probes): (&'static str, Vec<Probe>)| probes.into_iter().map(move |probe| (group, probe));
    groups.into_iter().flat_map(of_group).map(|(group, probe)| Probe { group, ..probe }).collect()
}

/// Text for results that IEEE 754 fixes to the bit, and WGSL up to the direction of rounding.
const CORRECTLY_ROUNDED: &str = "IEEE 754: correctly rounded. WGSL 15.7.4: correctly rounded, up or down";
