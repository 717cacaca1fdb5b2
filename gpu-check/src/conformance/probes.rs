//! The list of all probes, by topic. Each is an operation or a rewriting on which the port's exactness depends, or the
//! program of a report in `docs/upstream`.

mod arithmetic;
mod comparison;
mod conversion;
mod functions;
mod integer;
mod loops;
mod rewriting;
mod subnormal;

use super::probe::Probe;

/// Returns all probes, in the order of the table.
#[must_use]
pub fn all() -> Vec<Probe> {
    let groups = [
        ("rewriting", rewriting::probes()),
        ("arithmetic", arithmetic::probes()),
        ("subnormal", subnormal::probes()),
        ("comparison", comparison::probes()),
        ("conversion", conversion::probes()),
        ("integer", integer::probes()),
        ("loop", loops::probes()),
        ("function", functions::probes()),
    ];
    let of_group = |(group, probes): (&'static str, Vec<Probe>)| probes.into_iter().map(move |probe| (group, probe));
    groups.into_iter().flat_map(of_group).map(|(group, probe)| Probe { group, ..probe }).collect()
}
