//! Reads the numbers of options.

use std::ops::RangeInclusive;

/// The smallest number above 0.
pub const LEAST: f64 = f64::from_bits(1);

/// Returns a function that reads a number in `range`. For other texts it returns the message that `what` is needed.
pub fn number(
    range: RangeInclusive<f64>,
    what: &'static str,
) -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync {
    move |text| {
        text.parse().ok().filter(|number| range.contains(number)).ok_or_else(|| {
            let has_comma = text.contains(',') && text.replace(',', ".").parse::<f64>().is_ok();
            format!("{what} is needed{}", if has_comma { "; write a decimal point, not a comma" } else { "" })
        })
    }
}

/// Returns the number in `text`.
///
/// # Errors
/// It is not a number above 0, or above a thousand millions.
pub fn above_zero(text: &str) -> Result<f64, String> {
    number(LEAST..=1e9, "a number above 0 and up to 1000000000")(text)
}
