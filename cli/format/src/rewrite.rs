//! Writes a line of an input file as it would be valid, if one change makes it so.

use cpu::internals::input::text::{Tokens, parse_real, trim};

use crate::{Field, Line, Words};

/// Length of the longest line that a hint repeats, in bytes.
const LONGEST: usize = 200;

const KEY: Words = ["a colon follows the key, and a blank the colon", "tras la clave va «:», y después un espacio"];
/// What to do about a comment.
pub const COMMENT: Words =
    ["the files have no comments, so leave it out", "los archivos no tienen comentarios; quítelo"];
/// What begins a comment in other languages: after anything, and after a blank alone.
pub const MARKS: [&[&str]; 2] = [&["#", "//", "/*"], &[";", "%", "--", "!", "<!--", "(*", "{-", "REM"]];
/// Decimal commas: those of Europe, Arabic and Chinese.
const COMMAS: [char; 3] = [',', '٫', '，'];
const BLANKS: Words = ["separate numbers by blanks alone", "separe los números solo con espacios"];

/// Corrects the values of a line of the format.
type Change = fn(&str, &Line) -> String;

/// What people often write instead of values, in the order in which it is tried: what to do instead, and a function
/// that does so in the values of a line.
const CHANGES: [(Words, Change); 7] = [
    (KEY, |values, _| values.to_owned()),
    (["write a decimal point, not a comma", "escriba un punto decimal, no una coma"], |values, line| {
        if !values.split_whitespace().any(has_fraction) {
            return values.to_owned();
        }
        each(values, line, |field, token| {
            let token = std::str::from_utf8(token).ok()?.trim_end_matches([',', ';']);
            Some(if field == Field::Name { token.to_owned() } else { token.replace(COMMAS, ".") })
        })
    }),
    (BLANKS, |values, line| {
        let mut tokens = values.split_whitespace();
        // With blanks beside it, 0,5 is one number.
        if tokens.clone().nth(1).is_some() && tokens.any(|token| token.matches(',').count() == 1 && has_fraction(token))
        {
            return values.to_owned();
        }
        let is_config = line.fields.iter().all(|field| *field != Field::Name);
        values.replace(|sign| ",;()[]{}<>\"'".contains(sign) || (is_config && ":/x×".contains(sign)), " ")
    }),
    (["write digits alone", "escriba solo cifras"], |values, line| {
        each(values, line, |field, token| {
            let value = parse_real(token).filter(|value| field == Field::Count && value.fract() == 0.0)?;
            // 1.000 may stand for a thousand.
            let is_clear = token.iter().rev().position(|byte| *byte == b'.') != Some(3);
            is_clear.then(|| format!("{value:.0}"))
        })
    }),
    (["write the number without its unit", "escriba el número sin su unidad"], |values, line| {
        each(values, line, |field, token| {
            let token =
                std::str::from_utf8(token).ok().filter(|token| field != Field::Name && !token.contains("rad"))?;
            Some(token.trim_end_matches(|sign: char| sign == '°' || sign.is_alphabetic()).to_owned())
        })
    }),
    (["the minus sign is -", "el signo menos es -"], |values, _| {
        values.replace(['\u{2010}', '\u{2011}', '\u{2012}', '–', '—', '―', '−', '﹣', '－'], "-")
    }),
    (["channels go from 0 to 1, not to 255", "los canales van de 0 a 1, no a 255"], |values, line| {
        each(values, line, |field, token| {
            let channel: u8 = std::str::from_utf8(token).ok().filter(|_| field == Field::Share)?.parse().ok()?;
            Some(format!("{}", (f64::from(channel) / 0.255).round() / 1000.0))
        })
    }),
];

/// Whether a digit follows a decimal comma of the token.
fn has_fraction(token: &str) -> bool {
    token.split(COMMAS).skip(1).any(|rest| rest.starts_with(|sign: char| sign.is_ascii_digit()))
}

/// Returns the values of a line, each as `change` returns it for its field and token, or unchanged if that is `None`.
fn each(values: &str, line: &Line, change: impl Fn(Field, &[u8]) -> Option<String>) -> String {
    let fields = line.fields.iter().copied().chain(std::iter::repeat(Field::Name));
    let changed = values.split_whitespace().zip(fields);
    let changed = changed.map(|(token, field)| change(field, token.as_bytes()).unwrap_or_else(|| token.to_owned()));
    changed.collect::<Vec<_>>().join(" ")
}

/// Whether `values` are valid values of `line`, except that a material may be unknown.
fn is_valid(line: &Line, values: &str) -> bool {
    let tokens: Vec<_> = Tokens::new(values.as_bytes()).collect();
    tokens.len() == line.fields.len() && line.fields.iter().zip(tokens).all(|(field, token)| field.accepts(token))
}

/// Returns what to do and the line as it would be valid, if one of [`CHANGES`] makes `text` valid. `find_line` returns
/// the format for a tag.
pub fn line(text: &[u8], find_line: impl Fn(&str) -> Option<&'static Line>) -> Option<(Words, String)> {
    let text = std::str::from_utf8(trim(text)).ok().filter(|text| text.len() <= LONGEST)?;
    let (key, rest) = text.split_at(text.find([':', '=', ' ', '\t'])?);
    let line = find_line(&format!("{}:", key.trim_matches(['"', '\''])))?;
    let rest = rest.trim_start();
    let rest = rest.strip_prefix([':', '=']).unwrap_or(rest);
    let cut = |values: &str, mark: &str| values.split(mark).next().unwrap_or_default().trim().to_owned();
    let narrow = MARKS[0].iter().fold(rest.trim().to_owned(), |values, mark| cut(&values, mark));
    let wide = MARKS[1]
        .iter()
        .fold(narrow.clone(), |values, mark| cut(&cut(&values, &format!(" {mark}")), &format!("\t{mark}")));
    let tried = [&narrow, &wide].into_iter().flat_map(|values| {
        let has_comment = values != rest.trim();
        CHANGES.iter().map(move |(words, change)| {
            (if has_comment && *words == KEY { COMMENT } else { *words }, change(values, line))
        })
    });
    let (words, values) = tried.into_iter().find(|(_, values)| is_valid(line, values))?;
    let valid = values.split_whitespace().fold(line.tag.to_owned(), |line, token| line + " " + token);
    (valid != text).then_some((words, valid))
}
