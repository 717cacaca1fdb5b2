//! Converts bytes of a file to text that is safe to print. No character is added or removed, so that carets in the next
//! line stand below the right characters.

/// Returns a piece of a line with a space for each tab, and a question mark for each other control character.
#[must_use]
pub fn line(bytes: &[u8]) -> String {
    let tame = |character: char| match character {
        '\t' => ' ',
        control if control.is_control() => '?',
        other => other,
    };
    String::from_utf8_lossy(bytes).chars().map(tame).collect()
}
