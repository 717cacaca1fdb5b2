//! Draws what camera rays hit, in false colours, so that the user sees where two implementations differ.

use std::fmt;

use clap::ValueEnum;

use crate::Float;
use crate::steps::{Step, first_difference};

/// The property of each pixel that is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum View {
    /// The lambda of the hit. Nearer hits are lighter.
    Lambda,
    /// The unit normal that faces the ray. Its components x, y and z from -1 to 1 become red, green and blue from 0 to
    /// 255.
    Normal,
    /// The object, in one colour for each object.
    Object,
    /// The part of the object: side, top or bottom, in three hues. The colour is dark if the ray comes from inside.
    Side,
    /// The number of surfaces that the path hits: black for 0, then red and yellow, and white for the maximum depth.
    Steps,
    /// The difference of the colours, on a logarithmic scale.
    Difference,
}

impl View {
    /// Returns the colour of a pixel whose path has the steps `steps`. `depth` is the maximum depth of the picture.
    #[must_use]
    pub fn color<T: Float>(self, steps: &[Step<T>], depth: u32) -> [u8; 3] {
        let wide = |number: T| number.wide();
        if self == Self::Steps {
            return heat(surfaces(steps) as f64 / f64::from(depth.max(1)));
        }
        let Some(step) = steps.first().filter(|step| wide(step.is_hit()) == 1.0) else { return [0; 3] };
        match self {
            Self::Lambda => [grey(1.0 / (1.0 + wide(step.lambda()) / 4.0)); 3],
            Self::Normal => {
                let normal = step.normal().map(wide);
                let length = normal.iter().map(|component| component * component).sum::<f64>().sqrt();
                normal.map(|component| grey(component / length / 2.0 + 0.5))
            }
            Self::Object => hue(wide(step.object()) as u64),
            _ => {
                let light =
                    [[255, 176, 64], [64, 200, 120], [90, 140, 255]][wide(step.part()).clamp(0.0, 2.0) as usize];
                if wide(step.front()) == 1.0 { light } else { light.map(|channel: u8| channel / 3) }
            }
        }
    }

    /// Whether the view needs more than the first step of each path.
    #[must_use]
    pub fn is_deep(self) -> bool {
        self == Self::Steps
    }
}

/// Returns the number of surfaces that a path hits.
fn surfaces<T: Float>(steps: &[Step<T>]) -> usize {
    steps.iter().take_while(|step| step.is_hit().wide() == 1.0).count()
}

/// Returns white if any number of the two paths differs in its bits, and otherwise black.
#[must_use]
pub fn mark<T: Float>(one: &[Step<T>], other: &[Step<T>]) -> [u8; 3] {
    let differs = one.len() != other.len() || one.iter().zip(other).any(|(a, b)| first_difference(a, b).is_some());
    if differs { [255; 3] } else { [0; 3] }
}

fn grey(share: f64) -> u8 {
    (255.0 * share) as u8
}

fn heat(share: f64) -> [u8; 3] {
    [0.0, 1.0, 2.0].map(|place| grey((3.0 * share - place).clamp(0.0, 1.0)))
}

/// Returns the colour of an object. Objects that follow each other in the file have clearly different colours.
fn hue(object: u64) -> [u8; 3] {
    let scattered = (object + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    [56, 48, 40].map(|shift| 64 + ((scattered >> shift) as u8) / 4 * 3)
}

/// Writes the name of the view on the command line.
impl fmt::Display for View {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.to_possible_value().as_ref().map_or("", |value| value.get_name()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::steps::NAMES;

    fn step(numbers: &[(&str, f64)]) -> Step<f64> {
        let mut step = Step([0.0; NAMES.len()]);
        for (name, value) in numbers {
            step.0[NAMES.iter().position(|known| known == name).expect("the name exists")] = *value;
        }
        step
    }

    #[test]
    fn a_normal_is_a_colour() {
        let steps = [step(&[("is_hit", 1.0), ("normal.x", -2.0)])];
        assert_eq!(View::Normal.color(&steps, 5), [0, 127, 127]);
    }

    #[test]
    fn neighbours_in_the_file_have_different_colours() {
        let color = |object| View::Object.color(&[step(&[("is_hit", 1.0), ("object", object)])], 5);
        assert!(color(0.0) != color(1.0) && color(1.0) != color(2.0) && color(0.0) != color(2.0));
    }

    #[test]
    fn the_background_is_black_and_steps_are_counted() {
        let (hit, missed) = (step(&[("is_hit", 1.0)]), step(&[]));
        assert_eq!(View::Lambda.color(&[missed], 2), [0; 3]);
        assert_eq!(View::Steps.color(&[hit, missed], 3), [255, 0, 0]);
        assert_eq!(View::Steps.color(&[hit, hit], 2), [255; 3]);
    }

    #[test]
    fn one_bit_is_marked() {
        let (one, other) = (step(&[("lambda", 1.0)]), step(&[("lambda", 1.0_f64.next_up())]));
        assert_eq!((mark(&[one], &[one]), mark(&[one], &[other])), ([0; 3], [255; 3]));
    }
}
