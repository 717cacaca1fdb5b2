//! Finds every wrong line of an input file. The parsers of `cpu` stop at the first one, as the statement asks of
//! `render-aos` and `render-soa`.

use std::io::{BufRead, Read};

use cpu::internals::input::text::{Tokens, parse_real};
use cpu::{Config, Error, Scene};

use crate::hint::{Kind, MOST_NAMES};
use crate::place::wrong_token;
use crate::recorder::Recorder;

/// Largest number of wrong lines that a caller shows of a file.
pub const MOST_FAULTS: usize = 20;

/// Calls `tell` with the error of each wrong line, until `tell` returns `false`. A parser has read `input` up to the
/// first wrong line, and has returned the error `first`. At each call the last line of `input` is the wrong line.
///
/// If the definition of a material is wrong, or if a line uses a material that no line defines, later lines may use the
/// material without an error. So one mistake gives one error.
pub fn each<R: BufRead>(
    kind: Kind,
    input: &mut Recorder<R>,
    first: &Error,
    mut tell: impl FnMut(&Error, &Recorder<R>) -> bool,
) {
    let mut later = None;
    loop {
        let error = later.as_ref().unwrap_or(first);
        let (_, line) = input.last_line();
        // An error that is not about a line, such as too little memory, ends the search.
        let is_about_line = wrong_token(error, line).is_some();
        let name = missing(error, line).map(<[u8]>::to_vec);
        if !tell(error, input) || !is_about_line {
            return;
        }
        input.add_name(name);
        // Beyond this number the names of the materials are not known.
        if input.names().len() >= MOST_NAMES {
            return;
        }
        let rest = match kind {
            Kind::Config => Config::parse(&mut *input).map(drop),
            Kind::Scene => {
                let mut names = input.names().to_vec();
                names.sort_unstable();
                names.dedup();
                let defined: Vec<_> = names.iter().map(|name| [b"matte: ", &name[..], b" 0 0 0\n"].concat()).collect();
                Scene::parse(defined.concat().chain(&mut *input)).map(drop)
            }
        };
        match rest {
            Ok(()) => return,
            Err(next) => later = Some(next),
        }
    }
}

/// Returns the name of the material that a wrong line misses, or that it would define if its first word were right.
fn missing<'a>(error: &'a Error, line: &'a [u8]) -> Option<&'a [u8]> {
    match error {
        Error::MaterialNotFound { name, .. } => Some(name),
        Error::UnknownEntity { .. } => Tokens::new(line).nth(1).filter(|name| parse_real(name).is_none()),
        _ => None,
    }
}
