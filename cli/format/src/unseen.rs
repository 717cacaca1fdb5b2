//! Finds characters that are not seen, or that look like a space, in a line of an input file.

use std::ops::Range;

use crate::Words;

const SPACE: Words = ["write a space instead of it", "escriba un espacio en su lugar"];
const DELETE: Words = ["delete it", "bórrelo"];
const LINE_END: Words =
    ["end each line with LF or CRLF; CR alone ends none", "termine cada línea con LF o CRLF, no con CR"];
const ENCODING: Words = ["save the file as UTF-8 without byte order mark", "guarde el archivo en UTF-8 sin BOM"];
const UTF_16: Words =
    ["save the file as UTF-8; PowerShell's > writes UTF-16", "guárdelo en UTF-8; > de PowerShell es UTF-16"];

/// A character that is not seen, and where it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unseen {
    /// The bytes of the character, as offsets from the start of the text.
    pub span: Range<usize>,
    /// The character.
    pub character: char,
    /// The name of the character.
    pub what: Words,
    /// What to do about it.
    pub remedy: Words,
}

/// Returns the name of a character that is not seen, and what to do about it. Returns `None` for any other character
/// and for a tab.
#[must_use]
pub fn name(character: char) -> Option<(Words, Words)> {
    Some(match character {
        '\0' => (["a zero byte", "un byte nulo"], UTF_16),
        '\r' => (["a carriage return", "un retorno de carro"], LINE_END),
        '\u{85}' | '\u{2028}' | '\u{2029}' => (["a line separator", "un separador de líneas"], LINE_END),
        '\u{feff}' => (["a byte order mark", "una marca de orden de bytes (BOM)"], ENCODING),
        '\u{a0}' | '\u{2007}' | '\u{202f}' => (["a no-break space", "un espacio de no separación"], SPACE),
        '\u{1680}' | '\u{2000}'..='\u{200a}' | '\u{205f}' | '\u{2800}' | '\u{3000}' | '\u{3164}' => {
            (["a space of another width", "un espacio de otra anchura"], SPACE)
        }
        '\u{200b}' => (["a zero-width space", "un espacio de anchura cero"], DELETE),
        '\u{ad}'
        | '\u{34f}'
        | '\u{61c}'
        | '\u{115f}'..='\u{1160}'
        | '\u{17b4}'..='\u{17b5}'
        | '\u{180b}'..='\u{180f}'
        | '\u{200c}'..='\u{200f}'
        | '\u{202a}'..='\u{202e}'
        | '\u{2060}'..='\u{206f}'
        | '\u{fe00}'..='\u{fe0f}'
        | '\u{ffa0}'
        | '\u{fff0}'..='\u{fffb}'
        | '\u{1bca0}'..='\u{1bca3}'
        | '\u{1d173}'..='\u{1d17a}'
        | '\u{e0000}'..='\u{e0fff}' => (["a character without width", "un carácter sin anchura"], DELETE),
        '\t' => return None,
        control if control.is_control() => (["a control character", "un carácter de control"], DELETE),
        _ => return None,
    })
}

/// Returns the byte order mark, or the zero byte of UTF-16, at the start of a file that is not plain UTF-8.
#[must_use]
pub fn mark(file: &[u8]) -> Option<Unseen> {
    let is_mark = |unseen: &Unseen| match unseen.character {
        '\u{feff}' => unseen.span.start == 0,
        character => character == '\0' && unseen.span.start < 2,
    };
    find(&file[..file.len().min(4)]).filter(is_mark)
}

/// Returns the first character of `text` that is not seen. It may be the byte order mark of UTF-16.
#[must_use]
pub fn find(text: &[u8]) -> Option<Unseen> {
    let found = |start, length, character| {
        let (what, remedy) = name(character)?;
        Some(Unseen { span: start..start + length, character, what, remedy })
    };
    if matches!(text, [0xff, 0xfe, ..] | [0xfe, 0xff, ..]) {
        let what = ["the byte order mark of UTF-16", "la marca de orden de bytes de UTF-16"];
        return Some(Unseen { span: 0..2, character: '\u{feff}', what, remedy: UTF_16 });
    }
    let mut start = 0;
    for chunk in text.utf8_chunks() {
        let (valid, invalid) = (chunk.valid(), chunk.invalid());
        let seek = |(offset, letter): (usize, char)| found(start + offset, letter.len_utf8(), letter);
        if let Some(unseen) = valid.char_indices().find_map(seek) {
            return Some(unseen);
        }
        start += valid.len();
        // In ISO 8859-1 and in the code page of Windows, this byte is a no-break space.
        if invalid == [0xa0] {
            return found(start, 1, '\u{a0}');
        }
        start += invalid.len();
    }
    None
}
