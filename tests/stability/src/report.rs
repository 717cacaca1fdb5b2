//! Writes the measured figures as tables of comma-separated values (CSV).

use std::fmt::Write;

use crate::measure::Row;
use crate::observed::Counts;

/// A section of a table: the measured figures of one regime.
#[derive(Clone, Debug)]
pub struct Section {
    /// The rows of the table, one for each implementation.
    pub rows: Vec<Row>,
    /// Two shares of the cases, from 0 to 1: those that need the compensated formulas, and those that need
    /// dyadic arithmetic.
    pub fallbacks: [f64; 2],
}

/// The row of one picture in the table of pictures.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Name of the picture.
    pub name: String,
    /// Counts of the intersections with spheres and with cylinders together.
    pub counts: Counts,
    /// Whether the picture with exact intersections has the bytes of the picture with the plain formulas.
    pub same_bytes: bool,
}

/// Returns the errors of all kinds of objects as CSV, for every regime and implementation. They are the same in every
/// run with the same seed. The times, which differ from run to run, are in [`costs`].
#[must_use]
pub fn errors(kinds: &[(&str, &[Section])]) -> String {
    let mut text = String::from(
        "object,regime,implementation,cases,hits,wrong,wrong_hit,wrong_part,wrong_root,wrong_beyond_8uS,wrong_side,\
         lambda_p50,lambda_p999,lambda_max,surface_p50,surface_max,compensated,dyadic\n",
    );
    for (kind, sections) in kinds {
        for Section { rows, fallbacks: [compensated, dyadic] } in *sections {
            for row in rows {
                let [median, high, most] = row.lambda_error;
                let [near, far] = row.surface_error;
                let [hit, part, root] = row.faults;
                let beyond = row.wrong_beyond_noise.map_or(String::new(), |count| count.to_string());
                // Writing to a `String` never fails, so errors are ignored.
                let _ = writeln!(
                    text,
                    "{kind},\"{}\",{},{},{},{},{hit},{part},{root},{beyond},{},{median:e},{high:e},{most:e},{near:e},{far:e},\
                     {compensated},{dyadic}",
                    row.regime,
                    row.method,
                    row.cases,
                    row.hits,
                    row.wrong(),
                    row.wrong_side
                );
            }
        }
    }
    text
}

/// Returns the time of one intersection in nanoseconds as CSV, for every regime and implementation.
#[must_use]
pub fn costs(kinds: &[(&str, &[Section])]) -> String {
    let mut text = String::from("object,regime,implementation,nanoseconds\n");
    for (kind, sections) in kinds {
        for row in sections.iter().flat_map(|section| &section.rows) {
            let _ = writeln!(text, "{kind},\"{}\",{},{:.1}", row.regime, row.method, row.nanoseconds);
        }
    }
    text
}

/// Returns shares of wrong decisions as CSV, for every implementation and radius. `wrong` has the name of each
/// implementation, with its share for each of the `radii`.
#[must_use]
pub fn large_spheres(radii: &[f64], wrong: &[(&str, Vec<f64>)]) -> String {
    let mut text = String::from("implementation,radius,wrong_share\n");
    for (method, shares) in wrong {
        for (radius, share) in radii.iter().zip(shares) {
            let _ = writeln!(text, "{method},{radius:e},{share}");
        }
    }
    text
}

/// Returns the counts of the pictures as CSV.
#[must_use]
pub fn pictures(pictures: &[Picture]) -> String {
    let mut text = String::from("picture,tests,uncertain,hits,same_bits,other_decisions,same_bytes\n");
    for Picture { name, counts, same_bytes } in pictures {
        let Counts { tests, uncertain, hits, same_bits, other_decision } = counts;
        let name = quoted(name);
        let _ = writeln!(text, "{name},{tests},{uncertain},{hits},{same_bits},{other_decision},{same_bytes}");
    }
    text
}

/// Returns a text as a field of CSV, in quotation marks.
#[must_use]
pub fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_field_with_quotation_marks_doubles_them() {
        assert_eq!(quoted("a \"b\", c"), "\"a \"\"b\"\", c\"");
    }

    #[test]
    fn every_table_has_a_head_and_a_row_for_each_measurement() {
        let row = |method| Row { regime: "ordinary", method, nanoseconds: 12.34, ..Row::default() };
        let sections = [Section {
            rows: vec![row("plain f64"), Row { faults: [1, 2, 3], ..row("exact f64") }],
            fallbacks: [0.25, 0.0],
        }];
        let kinds: [(&str, &[Section]); 1] = [("sphere", &sections)];
        assert!(errors(&kinds).ends_with("sphere,\"ordinary\",exact f64,0,0,6,1,2,3,,0,0e0,0e0,0e0,0e0,0e0,0.25,0\n"));
        assert!(costs(&kinds).ends_with("sphere,\"ordinary\",exact f64,12.3\n"));
        let large = large_spheres(&[1.0, 10.0], &[("exact f64", vec![0.0, 0.5])]);
        assert!(large.ends_with("\nexact f64,1e0,0\nexact f64,1e1,0.5\n"));
        let picture = Picture { name: "a".into(), counts: Counts::default(), same_bytes: true };
        assert!(pictures(&[picture]).ends_with("\n\"a\",0,0,0,0,0,true\n"));
    }
}
