//! Fills templates: texts with places for values, in the syntax of Jinja.

use minijinja::syntax::SyntaxConfig;
use minijinja::{Environment, UndefinedBehavior, Value};

/// Returns `template` with the values of `context`, without a line end at its end. The filter `escape` writes a text
/// for HTML.
///
/// # Errors
/// A message if a value is missing, which is an error of the template.
pub fn filled(template: &str, context: Value) -> Result<String, String> {
    // A line that has only a statement or a comment of the template gives no line of text.
    let syntax = SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build();
    let mut environment = Environment::new();
    environment.set_syntax(syntax.map_err(|error| error.to_string())?);
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment.add_filter("escape", |text: &str| escape(text));
    let mut text = environment.render_str(template, context).map_err(|error| error.to_string())?;
    text.truncate(text.trim_ascii_end().len());
    Ok(text)
}

/// Returns `text` for an HTML page, without control characters and with the characters of markup escaped.
pub fn escape(text: &str) -> String {
    printable(text).replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

/// Returns `text`, in which U+FFFD replaces all control characters, U+FFFE and U+FFFF. XML does not allow most of
/// these.
pub fn printable(text: &str) -> String {
    let is_known = |c: char| !c.is_control() && !matches!(c, '\u{fffe}' | '\u{ffff}');
    text.chars().map(|c| if is_known(c) { c } else { char::REPLACEMENT_CHARACTER }).collect()
}
