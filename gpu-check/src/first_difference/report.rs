//! Finds the lines of a first difference, and formats it for users.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use shaders::{CallTrace, Library};

use super::{FirstDifference, Unequal};
use crate::shader_lab::pixel::bits;
use crate::{Error, Float};

/// A place in a module: its file, and a line of it.
pub type Place = (String, usize);

/// The places of a first difference.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Places {
    /// The functions that may be wrong, with their first and last lines.
    pub functions: Vec<(String, [Place; 2])>,
    /// The lines in these functions whose text is not in the shipped modules, or all such lines if none is in these
    /// functions.
    pub changed: Vec<Place>,
}

impl Places {
    /// Returns the places of `found`.
    ///
    /// # Errors
    /// The errors of [`Library::compose`].
    pub fn new<T>(trace: &CallTrace, found: &FirstDifference<T>) -> Result<Self, Error> {
        let place = |line: usize| {
            let (file, line) = trace.composition.origin(line);
            (file.to_owned(), line)
        };
        let suspects: Vec<_> = match found {
            FirstDifference::Call { function, inside, .. } => [function].into_iter().chain(inside).collect(),
            FirstDifference::Rest { without_twin } => without_twin.iter().collect(),
        };
        let of = |name: &String| trace.functions.iter().find(|function| function.name == *name);
        let functions: Vec<_> = suspects.into_iter().filter_map(of).collect();
        let changed = changed_lines(trace)?;
        let is_inside =
            |line: &usize| functions.iter().any(|function| (function.lines[0]..=function.lines[1]).contains(line));
        let inside: Vec<_> = changed.iter().copied().filter(is_inside).collect();
        let changed = if inside.is_empty() { changed } else { inside };
        Ok(Self {
            functions: functions.iter().map(|function| (function.name.clone(), function.lines.map(place))).collect(),
            changed: changed.into_iter().map(place).collect(),
        })
    }
}

/// Returns the lines of the composition whose text is in no line of the shipped modules.
fn changed_lines(trace: &CallTrace) -> Result<Vec<usize>, Error> {
    let composition = &trace.composition;
    let shipped = Library::standard().compose(composition.root(), composition.precision())?;
    let known: BTreeSet<_> = shipped.source().lines().map(str::trim).collect();
    let is_known = |text: &str| known.contains(text.replace("_called(", "(").trim());
    let lines = (1..).zip(composition.source().lines().take(trace.own_lines));
    Ok(lines.filter(|(_, text)| !is_known(text)).map(|(line, _)| line).collect())
}

/// Returns the first difference as text for users, with its places.
///
/// # Errors
/// The errors of [`Places::new`].
pub fn report<T: Float>(trace: &CallTrace, found: &FirstDifference<T>) -> Result<String, Error> {
    let Places { functions, changed } = Places::new(trace, found)?;
    let mut text = String::new();
    match found {
        FirstDifference::Call { function, inside, arguments, number } => {
            let at = functions.first().map_or_else(String::new, |(_, [(file, line), _])| format!(", {file}:{line}"));
            let _ = writeln!(text, "first difference: the result of {function}{at}");
            if !inside.is_empty() {
                let _ = writeln!(text, "  or of what it calls: {}", inside.join(", "));
            }
            for (name, value) in arguments {
                let _ = writeln!(text, "  {name:<28} {value:?}");
            }
            text.push_str(&unequal(number));
        }
        FirstDifference::Rest { without_twin } => {
            text.push_str(
                "every call that Rust can repeat has its result; the difference is in the statements around\n",
            );
            if !without_twin.is_empty() {
                let _ = writeln!(text, "  or in what Rust cannot repeat: {}", without_twin.join(", "));
            }
        }
    }
    match &changed[..] {
        [] => text.push_str("no line differs from the shipped modules, so the driver computes something else\n"),
        lines => {
            let places: Vec<_> = lines.iter().take(SHOWN).map(|(file, line)| format!("{file}:{line}")).collect();
            let more = if lines.len() > SHOWN { ", ..." } else { "" };
            let _ = writeln!(text, "changed lines: {}{more}", places.join(", "));
        }
    }
    Ok(text)
}

/// Largest number of changed lines that a report shows.
const SHOWN: usize = 10;

/// Returns a number by the CPU and by WGSL as text, with its bits.
fn unequal<T: Float>(Unequal { name, cpu, wgsl }: &Unequal<T>) -> String {
    format!("  {name:<28} CPU {cpu:?}, WGSL {wgsl:?}\n{}", bits(*cpu, *wgsl))
}
