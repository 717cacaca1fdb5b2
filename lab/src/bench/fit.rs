//! Fits power laws through measured points, and interpolates between points.

use serde::{Deserialize, Serialize};

/// The power law `y = factor * x^exponent`, fitted by least squares on the logarithms of measured points.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PowerLaw {
    /// The exponent, which is the slope on logarithmic axes.
    pub exponent: f64,
    /// Standard error of the exponent, from the residuals. `None` if only two points were fitted, because they leave no
    /// residual.
    pub exponent_error: Option<f64>,
    /// The factor of the law, which is its `y` at `x = 1`.
    pub factor: f64,
    /// Number of points that were fitted.
    pub points: usize,
}

impl PowerLaw {
    /// Fits the law to the points of `points` whose two coordinates are positive. Returns `None` if these have fewer
    /// than two different `x`.
    pub fn through(points: &[(f64, f64)]) -> Option<Self> {
        let logs: Vec<_> = points.iter().filter(|(x, y)| *x > 0.0 && *y > 0.0).map(|(x, y)| (x.ln(), y.ln())).collect();
        let count = logs.len() as f64;
        let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / count;
        let (x_mean, y_mean) = (mean(|point| point.0), mean(|point| point.1));
        let sum = |of: &dyn Fn(f64, f64) -> f64| logs.iter().map(|&(x, y)| of(x - x_mean, y - y_mean)).sum::<f64>();
        let variance = sum(&|x, _| x * x);
        if logs.len() < 2 || variance <= 0.0 {
            return None;
        }
        let exponent = sum(&|x, y| x * y) / variance;
        let residual = sum(&|x, y| (y - exponent * x) * (y - exponent * x));
        Some(Self {
            exponent,
            exponent_error: (logs.len() > 2).then(|| (residual / (count - 2.0) / variance).sqrt()),
            factor: (y_mean - exponent * x_mean).exp(),
            points: logs.len(),
        })
    }
}

/// Returns the `x` at which a curve through `points` falls to `y`, or `None` if `y` is not between the `y` of two
/// neighbouring points. Between two points the curve is straight on logarithmic axes. The points must be ordered by
/// falling `y`.
pub fn reaches(points: &[(f64, f64)], y: f64) -> Option<f64> {
    points.windows(2).find_map(|pair| {
        let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
        (y <= y0 && y >= y1 && y0 > y1).then(|| {
            let share = (y0.ln() - y.ln()) / (y0.ln() - y1.ln());
            (x0.ln() + share * (x1.ln() - x0.ln())).exp()
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_exact_law_is_found_without_error() {
        let points: Vec<_> = [1.0, 2.0, 4.0, 8.0_f64].map(|x| (x, 3.0 * x.powf(-0.5))).to_vec();
        let law = PowerLaw::through(&points).expect("four points");
        assert!((law.exponent + 0.5).abs() < 1e-12 && (law.factor - 3.0).abs() < 1e-12, "{law:?}");
        assert!(law.exponent_error.is_some_and(|error| error < 1e-12), "{law:?}");
    }

    #[test]
    fn scatter_about_the_law_is_its_error() {
        // The logarithms of x are 0, 1, 2 and those of y are 0, 1.5, 2. So the slope is 1, and the residuals are -1/6,
        // 1/3, -1/6 with a sum of squares of 1/6. The standard error squared is this sum divided by 1 (3 points minus
        // 2) and by 2 (the sum of squares of x about its mean), which is 1/12.
        let e = std::f64::consts::E;
        let law = PowerLaw::through(&[(1.0, 1.0), (e, e.powf(1.5)), (e * e, e * e)]).expect("three points");
        assert!((law.exponent - 1.0).abs() < 1e-12);
        assert!((law.exponent_error.expect("three points") - (1.0_f64 / 12.0).sqrt()).abs() < 1e-12, "{law:?}");
    }

    #[test]
    fn no_law_goes_through_one_point() {
        assert_eq!(PowerLaw::through(&[(2.0, 1.0), (2.0, 3.0)]), None);
        assert_eq!(PowerLaw::through(&[(2.0, 1.0), (3.0, 0.0)]), None);
        assert_eq!(PowerLaw::through(&[(1.0, 1.0), (2.0, 2.0)]).expect("two").exponent_error, None);
    }

    #[test]
    fn a_curve_reaches_what_lies_between_its_points() {
        let points = [(1.0, 8.0), (4.0, 4.0), (16.0, 2.0)];
        assert_eq!(reaches(&points, 4.0), Some(4.0));
        assert!(reaches(&points, 8.0_f64.sqrt()).is_some_and(|x| (x - 8.0).abs() < 1e-12));
        assert_eq!((reaches(&points, 9.0), reaches(&points, 1.0)), (None, None));
    }
}
