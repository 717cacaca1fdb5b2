//! Keeps the names by which a program knows a module: those of overrides and of entry points.
//!
//! naga's writer makes all names of a text different, and adds an underscore to a name that ends with a digit. A name
//! that nothing outside of the module knows may change so; these may not.

use naga::Module;

/// Renames everything else in `module` that has the name of an override or of an entry point.
pub fn free(module: &mut Module) {
    let overrides = module.overrides.iter().filter_map(|(_, constant)| constant.name.clone());
    let known: Vec<_> = overrides.chain(module.entry_points.iter().map(|entry| entry.name.clone())).collect();
    let change = |name: &mut Option<String>| {
        if let Some(name) = name.as_mut().filter(|name| known.contains(name)) {
            name.push_str("_inside");
        }
    };
    module.constants.iter_mut().for_each(|(_, constant)| change(&mut constant.name));
    module.global_variables.iter_mut().for_each(|(_, variable)| change(&mut variable.name));
    module.functions.iter_mut().for_each(|(_, function)| change(&mut function.name));
    let functions = module.functions.iter_mut().map(|(_, function)| function);
    for function in functions.chain(module.entry_points.iter_mut().map(|entry| &mut entry.function)) {
        function.arguments.iter_mut().for_each(|argument| change(&mut argument.name));
        function.local_variables.iter_mut().for_each(|(_, local)| change(&mut local.name));
        for name in function.named_expressions.values_mut() {
            if known.contains(name) {
                name.push_str("_inside");
            }
        }
    }
}

/// Returns `text`, which naga has written from `module`, with the names of the module's overrides and entry points.
///
/// # Errors
/// A message if something else in the text has such a name.
pub fn restore(module: &Module, text: &str) -> Result<String, String> {
    let written: Vec<_> = written(text).collect();
    let overrides = module.overrides.iter().filter_map(|(_, constant)| constant.name.as_deref());
    let wanted = overrides.chain(module.entry_points.iter().map(|entry| entry.name.as_str()));
    let mut text = text.to_owned();
    for (written, wanted) in written.iter().zip(wanted).filter(|(written, wanted)| *written != wanted) {
        if words(&text).any(|word| word == wanted) {
            return Err(format!("`{wanted}` would be the name of two things"));
        }
        text = words(&text).map(|word| if word == *written { wanted } else { word }).collect();
    }
    Ok(text)
}

/// Returns the names of the overrides and of the entry points in a text of naga's writer, in their order.
fn written(text: &str) -> impl Iterator<Item = &str> {
    let mut is_entry = false;
    text.lines().filter_map(move |line| {
        let was_entry = std::mem::replace(&mut is_entry, line.starts_with('@') && !line.contains(" var"));
        let name = match line.strip_prefix("fn ").filter(|_| was_entry) {
            Some(rest) => rest.split('(').next(),
            None => {
                let (attributes, rest) = line.split_once("override ")?;
                let is_declaration = attributes.is_empty() || attributes.starts_with("@id(");
                rest.split(':').next().filter(|_| is_declaration)
            }
        };
        if line.starts_with('@') && line.contains("override ") {
            is_entry = false;
        }
        name
    })
}

/// Divides a text into words and what stands between them.
fn words(text: &str) -> impl Iterator<Item = &str> {
    let is_word = |character: char| character.is_alphanumeric() || character == '_';
    let mut rest = text;
    std::iter::from_fn(move || {
        let first = rest.chars().next()?;
        let end = rest.find(|character| is_word(character) != is_word(first)).unwrap_or(rest.len());
        let (word, after) = rest.split_at(end);
        rest = after;
        Some(word)
    })
}
