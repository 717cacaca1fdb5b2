//! Writes the sizes of structure members into a text that naga has written.
//!
//! naga's writer writes a member's name and type only. Where the next member is further away than the type asks for,
//! the member needs the attribute `@size`. Alignments need no attribute, because a size can express every distance.

use std::fmt::Write;

use naga::proc::Layouter;
use naga::{Module, StructMember, TypeInner};

/// Returns `text`, which naga has written from `module`, with the attributes that keep the offsets of all members.
///
/// # Errors
/// A message if the text does not have the structures of the module, in their order.
pub fn with_sizes(module: &Module, text: &str) -> Result<String, String> {
    let mut layouter = Layouter::default();
    layouter.update(module.to_ctx()).map_err(|error| error.to_string())?;
    let mut result = String::with_capacity(text.len());
    let mut lines = text.lines();
    for (handle, ty) in module.types.iter() {
        let TypeInner::Struct { members, span } = &ty.inner else { continue };
        if module.special_types.predeclared_types.values().any(|predeclared| *predeclared == handle) {
            continue;
        }
        // Everything up to the line that begins the structure is copied, and that line too.
        loop {
            let line = lines.next().ok_or("a structure is missing in naga's text")?;
            result.push_str(line);
            result.push('\n');
            if line.starts_with("struct ") {
                break;
            }
        }
        for (place, member) in members.iter().enumerate() {
            let line = lines.next().ok_or("a member is missing in naga's text")?;
            let own = size(module, &layouter, members, place, *span).filter(|_| member.binding.is_none());
            let body = line.trim_start();
            let indent = &line[..line.len() - body.len()];
            let attribute = own.map_or(String::new(), |size| format!("@size({size}) "));
            writeln!(result, "{indent}{attribute}{body}").map_err(|error| error.to_string())?;
        }
    }
    for line in lines {
        result.push_str(line);
        result.push('\n');
    }
    Ok(result)
}

/// Returns the size that the member number `place` needs, or `None` if its type has the right size.
fn size(module: &Module, layouter: &Layouter, members: &[StructMember], place: usize, span: u32) -> Option<u32> {
    let member = &members[place];
    let end = member.offset + layouter[member.ty].size;
    let (natural, next) = match members.get(place + 1) {
        Some(next) => (layouter[next.ty].alignment.round_up(end), next.offset),
        None => {
            let alignment = members.iter().map(|member| layouter[member.ty].alignment).max()?;
            (alignment.round_up(end), span)
        }
    };
    let is_dynamic = matches!(module.types[member.ty].inner, TypeInner::Array { size: naga::ArraySize::Dynamic, .. });
    (natural != next && !is_dynamic).then(|| next - member.offset)
}
