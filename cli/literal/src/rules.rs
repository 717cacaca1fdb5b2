//! The table of deviations (`rules.txt`): what people write instead of what the statement says.
//!
//! A deviation is a mistake, or a choice that the statement leaves open, such as the order of the draws. It may have
//! several values, such as several orders. [`Rules`] says which deviations a rendering has. Without any, it follows the
//! statement.

use serde::Serialize;

/// A deviation with one of its values.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Variant {
    /// The name of the deviation, by which the renderer knows it.
    pub name: &'static str,
    /// The value, a number or a choice.
    pub value: f64,
    /// What the program does.
    pub words: String,
    /// The section of the statement with the rule.
    pub section: &'static str,
    /// Whether the statement or the course's own pictures allow it.
    pub permitted: bool,
}

/// Returns all deviations with all their values.
pub fn table() -> Vec<Variant> {
    let lines = include_str!("rules.txt").lines().filter(|line| !line.starts_with('#'));
    let fields = lines.map(|line| line.splitn(4, " | ").collect::<Vec<_>>());
    let entry = |fields: Vec<&'static str>| {
        let &[name, section, words, values] = &fields[..] else { return Vec::new() };
        let variant = |value: &'static str| {
            let (value, label) = value.split_once(" =").unwrap_or((value, value));
            // A \ keeps a blank at the start.
            let words = words.replace("{}", label.trim().trim_start_matches('\\'));
            let (permitted, section) = (section.starts_with('+'), section.trim_start_matches('+'));
            Variant { name, value: value.trim().parse().unwrap_or(f64::NAN), words, section, permitted }
        };
        values.split(';').map(variant).collect()
    };
    fields.flat_map(entry).collect()
}

/// The deviations of a rendering: their names and values.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rules(Vec<(&'static str, f64)>);

impl Rules {
    /// Returns the rules of the statement with these deviations.
    pub fn with<'a>(variants: impl IntoIterator<Item = &'a Variant>) -> Self {
        Self(variants.into_iter().map(|variant| (variant.name, variant.value)).collect())
    }

    /// Returns the value of a deviation, or without it the number or the choice of the statement.
    pub fn or(&self, name: &str, statement: f64) -> f64 {
        self.0.iter().find(|(known, _)| *known == name).map_or(statement, |&(_, value)| value)
    }

    /// Whether there is this deviation.
    pub fn has(&self, name: &str) -> bool {
        self.0.iter().any(|(known, _)| *known == name)
    }

    /// Whether there is this deviation, and its value has the bit `thing`: 1 for the first thing, 2 for the second.
    pub fn covers(&self, name: &str, thing: u32) -> bool {
        self.or(name, 0.0) as u32 & thing != 0
    }
}
