//! The values of the options of `render`: settings, and a part of the picture.

use std::ffi::OsStr;

use clap::builder::{PossibleValue, StringValueParser, TypedValueParser};
use clap::{Arg, Command};

/// Takes any text as a setting, and offers the keys to the scripts that complete a command line.
#[derive(Clone)]
pub struct Setting;

impl TypedValueParser for Setting {
    type Value = String;

    fn parse_ref(&self, command: &Command, argument: Option<&Arg>, value: &OsStr) -> Result<String, clap::Error> {
        StringValueParser::new().parse_ref(command, argument, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let keys = format::CONFIG.iter().map(|line| line.tag.replace(':', "="));
        Some(Box::new(keys.map(PossibleValue::new)))
    }
}

/// Returns the part of a picture in a text: its column, row, width and height.
pub fn parse_crop(text: &str) -> Result<[usize; 4], String> {
    let numbers: Option<Vec<usize>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    let part = numbers.and_then(|numbers| <[usize; 4]>::try_from(numbers).ok());
    part.filter(|[.., width, height]| *width > 0 && *height > 0)
        .ok_or_else(|| "four numbers are needed, COLUMN,ROW,WIDTH,HEIGHT, the last two positive".to_owned())
}

/// Returns the number of rows to render for a part of the picture (x, y, width, height): all rows down to the last one
/// of the part. Returns an error if the part goes beyond the picture.
pub fn rows_of([x, y, part_width, part_height]: [usize; 4], width: usize, height: usize) -> Result<usize, String> {
    let within = |start: usize, length: usize, all| start.checked_add(length).filter(|&end| end <= all);
    match (within(x, part_width, width), within(y, part_height, height)) {
        (Some(_), Some(rows)) => Ok(rows),
        _ => Err(format!("--crop goes beyond the picture of {width} x {height} pixels")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_is_four_numbers() {
        assert_eq!(parse_crop("1,2,3,4"), Ok([1, 2, 3, 4]));
        for text in ["", "1,2,3", "1,2,3,4,5", "1,2,0,4", "1,2,3,x", "-1,2,3,4", "1,2,3,4,x"] {
            assert!(parse_crop(text).is_err(), "{text}");
        }
    }

    #[test]
    fn only_the_rows_down_to_the_part_are_needed() {
        assert_eq!(rows_of([1, 2, 3, 4], 4, 9), Ok(6));
        assert!(rows_of([2, 0, 3, 1], 4, 9).is_err());
        assert!(rows_of([0, 9, 1, 1], 4, 9).is_err());
        assert!(rows_of([0, 0, 1, usize::MAX], 4, 9).is_err());
    }
}
