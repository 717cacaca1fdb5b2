//! Reads the values of directives: texts, numbers, parameters and transforms.

use std::collections::HashMap;

use cpu::Vec3;

use super::Reader;
use crate::convert::notes::{Fault, Place};
use crate::convert::plugin::{Param, Plugin, number, shown};
use crate::convert::transform::Transform;

impl Reader<'_> {
    /// Reads the numbers of a transform that is applied before the current one.
    pub(super) fn inner(&mut self, word: &str, place: Place) -> Result<Transform, Fault> {
        Ok(match word {
            "Translate" => Transform::translate(self.numbers()?.into()),
            "Scale" => Transform::scale(self.numbers()?),
            "Rotate" => {
                let [degrees, x, y, z] = self.numbers()?;
                Transform::rotate(Vec3::new(x, y, z), degrees)
            }
            "LookAt" => {
                let view = [self.numbers()?, self.numbers()?, self.numbers()?].map(Vec3::from);
                Transform { view: Some(view), ..Transform::look_at(view).inverse() }
            }
            _ => self.matrix(place)?,
        })
    }

    /// Reads the type and the parameters of a plugin.
    pub(super) fn plugin(&mut self, word: &str, place: Place) -> Result<Plugin, Fault> {
        let name = format!("{word} {}", self.text()?);
        let mut params = Vec::new();
        while self.tokens.peek().is_some_and(|token| token.starts_with('"')) {
            let declared = self.text()?;
            let place = self.tokens.last;
            let advice = "write a type and a name, as in \"float radius\"";
            let fault = || (place, format!("[{}] is no parameter; {advice}", shown(&declared)));
            let (kind, name) = declared.trim().split_once(char::is_whitespace).ok_or_else(fault)?;
            let (kind, name) = (kind.to_owned(), name.trim().to_owned());
            params.push(Param { kind, name, words: self.values()?, place });
        }
        Ok(Plugin { name, params, place })
    }

    /// Reads a value, or those between brackets.
    fn values(&mut self) -> Result<Vec<String>, Fault> {
        let (first, mut values) = (self.tokens.take()?.0, Vec::new());
        if first != "[" {
            return Ok(vec![first.trim_start_matches('"').to_owned()]);
        }
        loop {
            match self.tokens.take()? {
                (token, _) if token == "]" => return Ok(values),
                (token, place) if token == "[" => return Err((place, "a ] is needed before this [".to_owned())),
                (token, _) => values.push(token.trim_start_matches('"').to_owned()),
            }
        }
    }

    /// Reads `N` numbers, which may stand between brackets.
    pub(super) fn numbers<const N: usize>(&mut self) -> Result<[f64; N], Fault> {
        let mut numbers = [0.0; N];
        let is_list = self.tokens.peek() == Some("[") && self.tokens.take().is_ok();
        for value in &mut numbers {
            let (token, place) = self.tokens.take()?;
            *value = number(&token, place)?;
        }
        match if is_list { self.tokens.take()? } else { return Ok(numbers) } {
            (token, _) if token == "]" => Ok(numbers),
            (_, place) => Err((place, format!("a ] is needed here, after {N} numbers"))),
        }
    }

    pub(super) fn matrix(&mut self, place: Place) -> Result<Transform, Fault> {
        Transform::matrix(self.numbers()?).ok_or((place, "the last column of the matrix must be 0 0 0 1".to_owned()))
    }

    pub(super) fn text(&mut self) -> Result<String, Fault> {
        let (token, place) = self.tokens.take()?;
        let text = token.strip_prefix('"').map(str::to_owned);
        text.ok_or_else(|| (place, format!("[{}] stands here, and a text in \" is needed", shown(&token))))
    }
}

/// Returns the value in `all` that has a name of the file. `word` is the directive that names it.
pub(super) fn named<T: Copy>(name: &str, all: &HashMap<String, T>, word: &str, place: Place) -> Result<T, Fault> {
    let fault = || (place, format!("{word}: nothing of the name [{}] is defined above this line", shown(name)));
    all.get(name).copied().ok_or_else(fault)
}
