//! The page that shows two pictures: with a slider, blinking, or their difference, with zoom.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use colorous::{INFERNO, VIRIDIS};
use minijinja::context;

use super::Pair;
use crate::Failure;
use crate::heatmap::{NOTHING, color_at};
use crate::picture::floats::Floats;
use crate::picture::{Picture, spare, with_room};
use crate::template::filled;

/// Number of steps of the page's colour maps. The page interpolates between them.
const STEPS: usize = 32;
/// Largest number of pixels of a picture on a page. A browser shows larger pictures slowly, and the page takes memory
/// for the pictures and their texts.
const MOST_PIXELS: usize = 1 << 24;

/// Returns a page that shows two pictures with these names. `figures` is the text below them, in HTML.
///
/// # Errors
/// A message if the pictures are too large for a page or for memory.
pub(super) fn page(pair: &Pair, [first, second]: [String; 2], figures: &str) -> Result<String, Failure> {
    let pixels = match pair {
        Pair::Pictures([first, _]) => first.width * first.height,
        Pair::Numbers([first, _]) => first.width * first.height,
    };
    if pixels > MOST_PIXELS {
        return Err(
            format!("--html: a page has pictures of at most {MOST_PIXELS} pixels; choose a part by --crop").into()
        );
    }
    // Compressed pictures, their text in base 64, and the page twice. Texts of numbers are held three times more.
    spare(match pair {
        Pair::Pictures(_) => 64 * pixels,
        Pair::Numbers([first, _]) => (64 + 48 * first.channels) * pixels,
    })?;
    let (drawn, numbers, range);
    let (pictures, channels) = match pair {
        Pair::Pictures(pictures) => {
            (range, numbers) = ((0.0, 255.0), Vec::new());
            (pictures, 3)
        }
        Pair::Numbers([first, second]) => {
            let ranges = [first.range(), second.range()];
            range = (ranges[0].0.min(ranges[1].0), ranges[0].1.max(ranges[1].1));
            drawn = [draw(first, range)?, draw(second, range)?];
            numbers = [first, second].map(base_64).to_vec();
            (&drawn, first.channels)
        }
    };
    let addresses = format!("{:?}", [pictures[0].address()?, pictures[1].address()?]);
    let steps = |map| (0..=STEPS).map(|step| color_at(map, step as f64 / STEPS as f64)).collect::<Vec<_>>();
    let values = context! {
        first, second, addresses, channels, figures,
        numbers => format!("{numbers:?}"),
        low => range.0.to_string(), high => range.1.to_string(),
        // A scale of values is shown for numbers of one channel.
        has_scale => channels == 1,
        colors => format!("{:?}", steps(INFERNO)),
        scale => format!("{:?}", steps(VIRIDIS)),
    };
    Ok(filled(include_str!("../../../templates/compare.html"), values)? + "\n")
}

/// Draws numbers: one channel by the colours of a scale, three as red, green and blue. No number is grey.
fn draw(floats: &Floats, (low, high): (f32, f32)) -> Result<Picture, String> {
    let share = |value: f32| if high > low { f64::from((value - low) / (high - low)) } else { 0.0 };
    let mut pixels = with_room(floats.width * floats.height)?;
    pixels.extend(floats.values.chunks_exact(floats.channels).map(|pixel| match *pixel {
        _ if !pixel.iter().all(|value| value.is_finite()) => NOTHING,
        [value] => color_at(VIRIDIS, share(value)),
        _ => [0, 1, 2].map(|channel| (255.0 * share(pixel[channel])) as u8),
    }));
    Ok(Picture { width: floats.width, height: floats.height, pixels })
}

fn base_64(floats: &Floats) -> String {
    BASE64_STANDARD.encode(floats.values.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<_>>())
}
