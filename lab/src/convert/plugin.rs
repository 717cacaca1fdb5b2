//! Plugins: the shapes, materials, lights and so on of a scene, with their parameters, as both formats have them.

use cpu::Vec3;
use cpu::internals::input::text::parse_real;

use super::notes::{Fault, Notes, Place};

/// A parameter of a plugin.
#[derive(Clone, Debug)]
pub struct Param {
    /// Its type, such as `float`, `rgb` or `texture`.
    pub kind: String,
    /// Its name.
    pub name: String,
    /// Its numbers as they are written, or one text.
    pub words: Vec<String>,
    /// Its line.
    pub place: Place,
}

/// A plugin with its parameters.
#[derive(Clone, Debug)]
pub struct Plugin {
    /// The word of the format and the type, such as `Shape sphere` in pbrt or `shape sphere` in Mitsuba.
    pub name: String,
    /// All parameters, in the order of the file.
    pub params: Vec<Param>,
    /// The line on which it begins.
    pub place: Place,
}

/// Returns the start of a text, for messages. Characters that are not seen are escaped.
pub fn shown(text: &str) -> String {
    format::hint::shown(text.chars().take(40).collect::<String>().as_bytes())
}

/// Returns the number that `word` is.
///
/// # Errors
/// A fault at `place` if it is none, is not finite or overflows.
pub fn number(word: &str, place: Place) -> Result<f64, Fault> {
    parse_real(word.as_bytes())
        .ok_or_else(|| (place, format!("[{}] is not a finite number; write one such as 1, -0.5 or 1e-3", shown(word))))
}

impl Plugin {
    /// Returns the type: the second word of the name.
    pub fn kind(&self) -> &str {
        self.name.split_once(' ').map_or("", |(_, kind)| kind)
    }

    /// Returns the parameter of this name.
    pub fn param(&self, name: &str) -> Option<&Param> {
        self.params.iter().find(|param| param.name == name)
    }

    /// Returns the line of the parameter of this name, or that of the plugin if it is missing.
    pub fn place_of(&self, name: &str) -> Place {
        self.param(name).map_or(self.place, |param| param.place)
    }

    /// Returns the text of a parameter.
    pub fn text(&self, name: &str) -> Option<&str> {
        self.param(name)?.words.first().map(String::as_str)
    }

    /// Returns the `N` numbers of a parameter, or `default` if it is missing.
    ///
    /// # Errors
    /// A fault if there are not as many numbers.
    pub fn numbers<const N: usize>(&self, name: &str, default: [f64; N]) -> Result<[f64; N], Fault> {
        let Some(param) = self.param(name) else { return Ok(default) };
        let numbers = param.words.iter().map(|word| number(word, param.place)).collect::<Result<Vec<_>, _>>()?;
        let count = numbers.len();
        numbers.try_into().map_err(|_| (param.place, format!("[{name}] has {count} numbers, and {N} are needed")))
    }

    /// Returns the number of a parameter, or `default` if it is missing.
    ///
    /// # Errors
    /// Those of [`Plugin::numbers`].
    pub fn real(&self, name: &str, default: f64) -> Result<f64, Fault> {
        Ok(self.numbers(name, [default])?[0])
    }

    /// Returns the whole number of a parameter, or `default` if it is missing.
    ///
    /// # Errors
    /// A fault if it is not written with digits alone, or not from `least` to 2^64 - 1.
    pub fn whole(&self, name: &str, default: u64, least: u64) -> Result<u64, Fault> {
        let Some(param) = self.param(name) else { return Ok(default) };
        let number = if let [word] = &param.words[..] { word.parse().ok() } else { None };
        let text =
            || format!("[{name}] must be one whole number, at least {least}, and is [{}]", param.words.join(" "));
        number.filter(|&number| number >= least).ok_or_else(|| (param.place, text()))
    }

    /// Returns the colour of a parameter: three numbers, one number, or `#rrggbb`. A texture or a spectrum has no
    /// match, so `default` takes its place.
    ///
    /// # Errors
    /// A fault if a number is wrong.
    pub fn color(&self, name: &str, default: [f64; 3], notes: &mut Notes) -> Result<Vec3, Fault> {
        let Some(param) = self.param(name) else { return Ok(default.into()) };
        let hex = param.words.first().and_then(|word| word.strip_prefix('#'));
        if let ("rgb", Some(hex)) = (&param.kind[..], hex) {
            let is_valid = hex.len() == 6 && hex.bytes().all(|digit| digit.is_ascii_hexdigit());
            let hex = u32::from_str_radix(hex, 16).ok().filter(|_| is_valid && param.words.len() == 1);
            let fault = || (param.place, format!("[{name}] is no colour; write #rrggbb or three numbers"));
            let hex = hex.ok_or_else(fault)?;
            let linear = |byte: u32| {
                let value = f64::from(byte & 255) / 255.0;
                if value <= 0.040_45 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
            };
            return Ok(Vec3::new(linear(hex >> 16), linear(hex >> 8), linear(hex)));
        }
        if !matches!((&param.kind[..], param.words.len()), ("rgb", 1 | 3) | ("float" | "integer" | "spectrum", 1))
            || param.words[0].parse::<f64>().is_err()
        {
            let [r, g, b] = default;
            let instead = if r == g && g == b { r.to_string() } else { format!("{r} {g} {b}") };
            notes.add(param.place, format!("{} [{name}] has no match; {instead} takes its place", param.kind));
            return Ok(default.into());
        }
        let of = |at: usize| number(&param.words[at.min(param.words.len() - 1)], param.place);
        Ok(Vec3::new(of(0)?, of(1)?, of(2)?))
    }
}
