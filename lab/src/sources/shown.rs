//! Converts bytes of a file to text that is safe to print. The number of characters stays the same, so that carets in
//! the next line stand below the right characters.

/// Returns a part of a line as text. A space replaces each tab, and a question mark replaces every other control
/// character.
#[must_use]
pub fn line(bytes: &[u8]) -> String {
    let tame = |character: char| match character {
        '\t' => ' ',
        control if control.is_control() => '?',
        other => other,
    };
    String::from_utf8_lossy(bytes).chars().map(tame).collect()
}
