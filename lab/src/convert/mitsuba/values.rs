//! Reads the values in an element: attributes, parameters and transforms.

use cpu::Vec3;
use roxmltree::Node;

use super::Reader;
use crate::convert::notes::{Fault, Place};
use crate::convert::plugin::{Param, Plugin, number};
use crate::convert::transform::Transform;

/// The elements that are parameters.
const PARAMETERS: [&str; 10] =
    ["float", "integer", "boolean", "string", "rgb", "spectrum", "point", "vector", "texture", "transform"];

/// Whether an element is a parameter.
pub(super) fn is_parameter(node: &Node<'_, '_>) -> bool {
    PARAMETERS.contains(&node.tag_name().name())
}

impl Reader<'_> {
    /// Returns the line of an element.
    pub(super) fn place(&self, node: Node<'_, '_>) -> Place {
        (0, 1 + self.line_ends.partition_point(|&end| end < node.range().start))
    }

    /// Returns an attribute, in which each `$name` is replaced by the default of this name.
    pub(super) fn attribute(&self, node: Node<'_, '_>, name: &str) -> Result<Option<String>, Fault> {
        let Some(text) = node.attribute(name) else { return Ok(None) };
        let mut parts = text.split('$');
        let mut replaced = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let is_end = |letter: char| !letter.is_alphanumeric() && letter != '_';
            let (name, after) = part.split_at(part.find(is_end).unwrap_or(part.len()));
            let value = self.defaults.get(name).ok_or_else(|| {
                let remedy = format!("add <default name=\"{name}\" value=\"...\"/> at the start of the scene");
                (self.place(node), format!("${name} has no value; {remedy}"))
            })?;
            replaced.extend([value, after]);
        }
        Ok(Some(replaced))
    }

    /// Returns an attribute that must be there.
    pub(super) fn required(&self, node: Node<'_, '_>, name: &str) -> Result<String, Fault> {
        let missing = || (self.place(node), format!("<{}> needs the attribute {name}", node.tag_name().name()));
        self.attribute(node, name)?.ok_or_else(missing)
    }

    /// Returns the plugin of an element, with its parameters.
    pub(super) fn plugin(&self, node: Node<'_, '_>) -> Result<Plugin, Fault> {
        let name = format!("{} {}", node.tag_name().name(), self.required(node, "type")?);
        let mut params = Vec::new();
        for child in node.children().filter(is_parameter) {
            let kind = child.tag_name().name();
            let name = self.required(child, "name")?;
            let words = match kind {
                "transform" | "texture" => Vec::new(),
                "string" | "boolean" => vec![self.required(child, "value")?],
                _ => self.words(child)?,
            };
            params.push(Param { kind: kind.to_owned(), name, words, place: self.place(child) });
        }
        Ok(Plugin { name, params, place: self.place(node) })
    }

    /// Returns the numbers of the attribute `value`, or of `x`, `y` and `z` if it is missing.
    fn words(&self, node: Node<'_, '_>) -> Result<Vec<String>, Fault> {
        let names = ["x", "y", "z"];
        if node.has_attribute("value") || !names.iter().any(|name| node.has_attribute(*name)) {
            return self.split(node, "value");
        }
        let none = if node.has_tag_name("scale") { "1" } else { "0" };
        names.iter().map(|name| Ok(self.attribute(node, name)?.unwrap_or_else(|| none.to_owned()))).collect()
    }

    fn split(&self, node: Node<'_, '_>, name: &str) -> Result<Vec<String>, Fault> {
        let text = self.required(node, name)?;
        let words = text.split(|letter: char| letter == ',' || letter.is_whitespace());
        Ok(words.filter(|word| !word.is_empty()).map(str::to_owned).collect())
    }

    /// Returns the transform of an element with the name `to_world`.
    pub(super) fn to_world(&self, node: Node<'_, '_>) -> Result<Transform, Fault> {
        let mut all = Transform::IDENTITY;
        let is_it =
            |child: &Node<'_, '_>| child.has_tag_name("transform") && child.attribute("name") == Some("to_world");
        let steps = node.children().filter(is_it).flat_map(|child| child.children()).filter(Node::is_element);
        for (at, step) in steps.enumerate() {
            let vector = || Ok(Vec3::from(self.numbers(step, self.words(step)?)?));
            let one = match step.tag_name().name() {
                "translate" => Transform::translate(vector()?),
                "scale" => Transform::scale(vector()?.to_array()),
                "rotate" => {
                    let angle = number(&self.required(step, "angle")?, self.place(step))?;
                    Transform::rotate(vector()?, angle)
                }
                "lookat" => {
                    let point = |name| Ok(Vec3::from(self.numbers(step, self.split(step, name)?)?));
                    Transform::look_at([point("origin")?, point("target")?, point("up")?])
                }
                "matrix" => {
                    let rows: [f64; 16] = self.numbers(step, self.words(step)?)?;
                    Transform::matrix(std::array::from_fn(|at| rows[4 * (at % 4) + at / 4]))
                        .ok_or_else(|| (self.place(step), "the last row of a matrix must be 0 0 0 1".to_owned()))?
                }
                other => {
                    let text = format!("<{other}> is no translate, rotate, scale, lookat or matrix");
                    return Err((self.place(step), text));
                }
            };
            all = if at == 0 { one } else { one.then_inner(&all) };
        }
        Ok(all)
    }

    /// Returns `N` numbers. A single one stands for `N` equal ones.
    fn numbers<const N: usize>(&self, node: Node<'_, '_>, words: Vec<String>) -> Result<[f64; N], Fault> {
        let place = self.place(node);
        let words = if words.len() == 1 { vec![words[0].clone(); N] } else { words };
        let numbers = words.iter().map(|word| number(word, place)).collect::<Result<Vec<_>, _>>()?;
        numbers.try_into().map_err(|_| (place, format!("{N} numbers are needed here")))
    }
}
