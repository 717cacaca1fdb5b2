//! Draws the differences of two pictures in false colours, on a scale that fits these differences.

use cpu::Vec3;

use crate::Float;

/// Returns a colour for each pixel and a description of the scale. The colour depends on the largest difference of the
/// pixel's channels.
///
/// The scale is logarithmic, from the smallest difference to the largest, because rounding errors differ by many orders
/// of magnitude. Pixels without a difference are black. If a channel is NaN in only one picture, the pixel has the
/// colour of the largest difference.
#[must_use]
pub fn differences<T: Float>(one: &[Vec3<T>], other: &[Vec3<T>]) -> (Vec<[u8; 3]>, String) {
    /// The position of the smallest difference in the colour map, from 0 to 1. It is above 0, so that this difference
    /// does not look black.
    const FIRST: f64 = 0.25;
    let apart = |(one, other): (&Vec3<T>, &Vec3<T>)| {
        let channels = one.to_array().into_iter().zip(other.to_array());
        let distance = |(one, other): (T, T)| match (one.wide() - other.wide()).abs() {
            _ if one.same(other) => 0.0,
            distance if distance.is_nan() => f64::INFINITY,
            distance => distance,
        };
        channels.map(distance).fold(0.0, f64::max)
    };
    let distances: Vec<f64> = one.iter().zip(other).map(apart).collect();
    let counted = || distances.iter().copied().filter(|distance| *distance > 0.0 && distance.is_finite());
    let (least, most) = (counted().fold(f64::INFINITY, f64::min), counted().fold(0.0, f64::max));
    let color = |distance: f64| {
        let share =
            if distance.is_infinite() || least >= most { 1.0 } else { (distance / least).ln() / (most / least).ln() };
        let color =
            colorous::INFERNO.eval_continuous(if distance == 0.0 { 0.0 } else { FIRST + (1.0 - FIRST) * share });
        [color.r, color.g, color.b]
    };
    let words = match most {
        0.0 => "difference: none".to_owned(),
        _ => format!("difference: none black, {least:.0e} dark, {most:.0e} light"),
    };
    (distances.into_iter().map(color).collect(), words)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn brightness(colors: &[[u8; 3]]) -> Vec<u32> {
        colors.iter().map(|color| color.iter().map(|&channel| u32::from(channel)).sum()).collect()
    }

    #[test]
    fn the_smallest_differences_are_visible() {
        let one = [Vec3::ZERO; 4];
        let other = [0.0, 1e-16, 1e-13, 1e-10].map(|apart| Vec3::new(0.0, apart, 0.0));
        let (colors, words) = differences(&one, &other);
        let light = brightness(&colors);
        assert!(light[0] < 10 && light[1] > 100 && light[2] > light[1] + 100 && light[3] > light[2] + 100, "{light:?}");
        assert_eq!(words, "difference: none black, 1e-16 dark, 1e-10 light");
    }

    #[test]
    fn equal_pictures_are_black_and_nan_is_light() {
        let one = [Vec3::ZERO, Vec3::ZERO];
        let (colors, words) = differences(&one, &one);
        assert!(brightness(&colors).iter().all(|&light| light < 10));
        assert_eq!(words, "difference: none");
        let (colors, _) = differences(&one, &[Vec3::new(f64::NAN, 0.0, 0.0), Vec3::new(1e-9, 0.0, 0.0)]);
        assert_eq!(colors[0], colors[1], "one difference alone has the last colour too");
        assert!(brightness(&colors)[0] > 500);
    }
}
