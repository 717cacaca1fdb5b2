//! A picture of where two pictures differ.

use crate::difference::of_pixels;
use crate::picture::{Picture, with_room};

/// Colours from no difference to the largest, dark to light, so that it reads in grey too (after the map "inferno").
const COLORS: [[u8; 3]; 6] = [[0, 0, 4], [66, 10, 104], [147, 38, 103], [221, 81, 58], [252, 165, 10], [252, 255, 164]];

/// The differences of two pictures of one size as colours, `scale` levels being the brightest.
///
/// # Errors
/// There is too little memory for it.
pub fn heatmap(first: &Picture, second: &Picture, scale: f64) -> Result<Picture, String> {
    let pairs = first.pixels.iter().zip(&second.pixels);
    let mut pixels = with_room(first.pixels.len())?;
    pixels.extend(pairs.map(|(&a, &b)| color(if scale > 0.0 { of_pixels(a, b) / scale } else { 0.0 })));
    Ok(Picture { width: first.width, height: first.height, pixels })
}

/// The colour at `position` from 0 to 1 along the map.
fn color(position: f64) -> [u8; 3] {
    let place = position.clamp(0.0, 1.0) * (COLORS.len() - 1) as f64;
    let below = (place as usize).min(COLORS.len() - 2);
    let share = place - below as f64;
    std::array::from_fn(|channel| {
        let [low, high] = [below, below + 1].map(|index| f64::from(COLORS[index][channel]));
        (low + (high - low) * share).round() as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_map_goes_from_dark_to_light() {
        let brightness = |position| color(position).iter().map(|&channel| u32::from(channel)).sum::<u32>();
        let steps: Vec<_> = (0..=20).map(|step| brightness(f64::from(step) / 20.0)).collect();
        assert!(steps.is_sorted(), "{steps:?}");
        assert_eq!((color(0.0), color(1.0), color(7.0)), (COLORS[0], COLORS[5], COLORS[5]));
    }

    #[test]
    fn equal_pixels_are_dark_and_the_largest_difference_is_light() {
        let first = Picture { width: 2, height: 1, pixels: vec![[5; 3], [5; 3]] };
        let second = Picture { width: 2, height: 1, pixels: vec![[5; 3], [9; 3]] };
        assert_eq!(heatmap(&first, &second, 4.0).expect("it is small").pixels, [COLORS[0], COLORS[5]]);
        assert_eq!(heatmap(&first, &first, 0.0).expect("it is small").pixels, [COLORS[0], COLORS[0]]);
    }
}
