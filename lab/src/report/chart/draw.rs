//! Draws the legend, logarithmic axes, lines, dots and markers of a chart.

use plotters::coord::Shift;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::{Chart, LEFT, LEGEND_ROW, LETTER, Point, Series, TITLE, WIDTH};
use crate::report::style::{GRID, INK, SERIES};

const FONT: i32 = 17;
/// Largest number of ticks on a horizontal axis.
const MOST_TICKS: usize = 7;
/// The margins at the left and at the right, in pixels.
const MARGINS: i32 = 12 + 36;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// The pixel coordinates of each marker in its area, and the values of its point as words.
pub type Hints = Vec<((i32, i32), String)>;

impl Chart {
    pub(super) fn draw_head(&self, area: &Area<'_>, legend: &[(u32, i32)]) -> Result<(), Box<dyn std::error::Error>> {
        let text = |size: i32| ("sans-serif", size).into_font().color(&INK);
        area.draw(&Text::new(self.title.clone(), (LEFT, 8), text(19)))?;
        for (series, &(row, x)) in self.series.iter().zip(legend) {
            let y = (TITLE + LEGEND_ROW * row + LEGEND_ROW / 2) as i32;
            let style = color(series);
            if self.rows.is_empty() {
                let stroke = if series.is_guide { style.stroke_width(1) } else { style.stroke_width(2) };
                area.draw(&PathElement::new([(x, y), (x + 24, y)], stroke))?;
            }
            if !series.is_guide {
                draw_marker(area, series.color, (x + 12, y))?;
            }
            let left = Pos::new(HPos::Left, VPos::Center);
            area.draw(&Text::new(series.name.clone(), (x + 29, y), text(FONT).pos(left)))?;
        }
        Ok(())
    }

    pub(super) fn draw_lines(&self, area: &Area<'_>) -> Result<Hints, Box<dyn std::error::Error>> {
        let mut hints = Hints::new();
        let ends = || self.series.iter().flat_map(|series| &series.points).flat_map(Point::ends);
        let x = range(ends().map(|(x, _)| x), 1.25);
        let y = range(ends().map(|(_, y)| y), 1.35);
        let mut chart = builder(area, 78).build_cartesian_2d(Logarithmic(x), Logarithmic(y))?;
        self.draw_mesh(&mut chart, MOST_TICKS)?;
        for series in &self.series {
            let style = color(series);
            let path: Vec<_> = series.points.iter().map(|point| (point.x, point.y)).collect();
            if series.is_guide {
                chart.draw_series(DashedLineSeries::new(path, 5, 4, style.stroke_width(1)))?;
                continue;
            }
            chart.draw_series(LineSeries::new(path, style.stroke_width(2)))?;
            for point in &series.points {
                if point.bounds.is_some() {
                    chart.draw_series([PathElement::new(point.ends(), style.stroke_width(1))])?;
                }
                let place = relative(chart.backend_coord(&(point.x, point.y)), area);
                draw_marker(area, series.color, place)?;
                hints.push((place, self.words(series, point)));
            }
        }
        Ok(hints)
    }

    pub(super) fn draw_dots(&self, area: &Area<'_>) -> Result<Hints, Box<dyn std::error::Error>> {
        let mut hints = Hints::new();
        let ends = self.series.iter().flat_map(|series| &series.points).flat_map(Point::ends);
        let x = range(ends.map(|(x, _)| x), 1.15);
        let count = self.rows.len() as f64;
        let longest = self.rows.iter().map(|name| name.chars().count()).max().unwrap_or(0);
        // The names of the report's rows fit in 150 pixels.
        let names = 150.max(LETTER * longest as i32);
        let mut chart = builder(area, names).build_cartesian_2d(Logarithmic(x.clone()), count + 0.5..0.5)?;
        // Longer names leave less room for the numbers of the axis.
        let letters = [x.start, x.end].map(|end| (self.x.format)(end).chars().count());
        // The ends have more letters than the round numbers between them, so these do not touch.
        let room = (WIDTH as i32 - MARGINS - names) / (LETTER * letters[0].max(letters[1]).max(1) as i32);
        self.draw_mesh(&mut chart, room.clamp(3, MOST_TICKS as i32) as usize)?;
        for (index, name) in self.rows.iter().enumerate() {
            let (_, y) = relative(chart.backend_coord(&(1.0, index as f64 + 1.0)), area);
            let style = ("sans-serif", FONT).into_font().color(&INK).pos(Pos::new(HPos::Right, VPos::Center));
            area.draw(&Text::new(name.clone(), (names + 4, y), style))?;
        }
        for (index, series) in self.series.iter().enumerate() {
            // Each series has its own height within a row, so that no marker covers another.
            let shift = (index as f64 - (self.series.len() - 1) as f64 / 2.0) * 0.9 / self.series.len() as f64;
            for point in &series.points {
                let shifted = Point { y: point.y + shift, ..*point };
                if shifted.bounds.is_some() {
                    chart.draw_series([PathElement::new(shifted.ends(), color(series).stroke_width(1))])?;
                }
                let place = relative(chart.backend_coord(&(shifted.x, shifted.y)), area);
                draw_marker(area, series.color, place)?;
                hints.push((place, self.words(series, point)));
            }
        }
        Ok(hints)
    }

    /// Draws the axes and the grid, with at most `most` numbers on the horizontal axis. In a chart of dots the vertical
    /// axis has no numbers, because its rows have names.
    fn draw_mesh<X, Y>(
        &self,
        chart: &mut ChartContext<'_, SVGBackend<'_>, Cartesian2d<X, Y>>,
        most: usize,
    ) -> Result<(), Box<dyn std::error::Error>>
    where
        X: Ranged<ValueType = f64> + ValueFormatter<f64>,
        Y: Ranged<ValueType = f64> + ValueFormatter<f64>,
    {
        let text = ("sans-serif", FONT).into_font().color(&INK);
        let (x_format, y_format) = (|x: &f64| (self.x.format)(*x), |y: &f64| (self.y.format)(*y));
        let mut mesh = chart.configure_mesh();
        mesh.label_style(text.clone())
            .axis_desc_style(text)
            .axis_style(INK.stroke_width(1))
            .bold_line_style(GRID.stroke_width(1))
            .light_line_style(TRANSPARENT)
            .x_labels(most)
            .x_desc(self.x.label)
            .x_label_formatter(&x_format)
            .y_label_formatter(&y_format);
        if self.rows.is_empty() {
            mesh.y_labels(9).y_desc(self.y.label);
        } else {
            mesh.y_labels(0).disable_y_mesh();
        }
        Ok(mesh.draw()?)
    }
}

/// Returns the builder of a chart, whose labels at the left have `left` pixels.
fn builder<'a, 'b>(area: &'a Area<'b>, left: i32) -> ChartBuilder<'a, 'b, SVGBackend<'b>> {
    let mut builder = ChartBuilder::on(area);
    builder.margin_left(12).margin_right(36).margin_top(6).x_label_area_size(48).y_label_area_size(left);
    builder
}

/// Converts a point's pixel coordinates in the whole picture to its pixel coordinates in one area of the picture.
fn relative((x, y): (i32, i32), area: &Area<'_>) -> (i32, i32) {
    let (left, top) = area.get_base_pixel();
    (x - left, y - top)
}

fn color(series: &Series) -> RGBColor {
    if series.is_guide { INK } else { SERIES[series.color % SERIES.len()].0 }
}

/// Draws the marker of a series. Each colour has its shape, because some readers cannot tell the colours apart.
fn draw_marker(area: &Area<'_>, color: usize, (x, y): (i32, i32)) -> Result<(), Box<dyn std::error::Error>> {
    let solid = SERIES[color % SERIES.len()].0;
    // After all colours were used once, each gets another shape.
    let shape = (color + color / SERIES.len()) % SERIES.len();
    // Half the width in pixels, and less for shapes that look larger.
    let (size, up, small) = (6, 5, 4);
    // Filled markers are 60 % opaque, so that points below them are seen.
    let is_hollow = matches!(shape, 4 | 5 | 7);
    let style = if is_hollow { solid.stroke_width(2) } else { solid.mix(0.6).filled() };
    let corners = match shape {
        1 | 4 => return Ok(area.draw(&Circle::new((x, y), up, style))?),
        0 | 5 => return Ok(area.draw(&Rectangle::new([(x - small, y - small), (x + small, y + small)], style))?),
        2 => vec![(x, y - size), (x + size, y + up), (x - size, y + up)],
        6 => vec![(x, y + size), (x + size, y - up), (x - size, y - up)],
        _ => vec![(x, y - size), (x + size, y), (x, y + size), (x - size, y)],
    };
    if style.filled {
        area.draw(&Polygon::new(corners, style))?;
    } else {
        let closed = [&corners[..], &corners[..1]].concat();
        area.draw(&PathElement::new(closed, style))?;
    }
    Ok(())
}

/// Returns the range of `values`, extended at both ends by the factor `room`.
fn range(values: impl Iterator<Item = f64>, room: f64) -> std::ops::Range<f64> {
    let (low, high) = values.fold((f64::INFINITY, 0.0_f64), |(low, high), value| (low.min(value), high.max(value)));
    // The division may give 0 and the multiplication infinity, so the ends are limited to positive finite numbers.
    (low / room).max(f64::MIN_POSITIVE / 2.0_f64.powi(52))..(high * room).min(f64::MAX)
}

/// A logarithmic axis with round ticks. The ticks are 1, 2 and 5 in each decade. If these are fewer than two, they are
/// all multiples of one round step. If these are too many, they are 1 and 3, then the powers of ten, then every second,
/// third or fifth power of ten.
struct Logarithmic(std::ops::Range<f64>);

impl Ranged for Logarithmic {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        let share = (value.ln() - self.0.start.ln()) / (self.0.end.ln() - self.0.start.ln());
        from + (f64::from(to - from) * share).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        ticks(&self.0, hint.max_num_points())
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.0.clone()
    }
}

impl ValueFormatter<f64> for Logarithmic {}

fn ticks(range: &std::ops::Range<f64>, most: usize) -> Vec<f64> {
    // Limited to the powers of ten that an `f64` can hold, because the range may begin at 0 or end at infinity.
    let bounded = |decade: f64| (decade as i32).clamp(-323, 308);
    let decades = bounded(range.start.log10().floor())..=bounded(range.end.log10().ceil());
    let with = |steps: &[f64]| -> Vec<f64> {
        let all = decades.clone().flat_map(|decade| steps.iter().map(move |step| step * 10_f64.powi(decade)));
        all.filter(|tick| range.contains(tick)).collect()
    };
    let every = |count: i32| -> Vec<f64> {
        let powers = decades.clone().filter(|decade| decade % count == 0).map(|decade| 10_f64.powi(decade));
        powers.filter(|tick| range.contains(tick)).collect()
    };
    let few = with(&[1.0, 2.0, 5.0]);
    if few.len() < 2 {
        // The step is the same on both sides of a power of ten, so that no two labels come near each other.
        let unit = 10_f64.powi(bounded(range.end.log10().floor()) - 2);
        let multiples = |step: f64| -> Vec<f64> {
            let first = (range.start / (step * unit)).ceil();
            let count = (range.end / (step * unit) - first).clamp(0.0, 1000.0) as i32;
            let all = (0..=count).map(|index| (first + f64::from(index)) * step * unit);
            all.filter(|tick| range.contains(tick)).collect()
        };
        let sets = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0].map(multiples);
        if let Some(fine) = sets.into_iter().find(|ticks| ticks.len() <= most && ticks.len() > 1) {
            return fine;
        }
    }
    let sets = [few, with(&[1.0, 3.0]), every(1), every(2), every(3)];
    sets.into_iter().find(|ticks| ticks.len() <= most).unwrap_or_else(|| every(5))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_from_zero_has_no_more_decades_than_there_are_numbers() {
        for range in [0.0..1.0, 1.0..f64::INFINITY, f64::NAN..1.0, range([5e-324, f64::MAX].into_iter(), 2.0)] {
            assert!(ticks(&range, 9).len() <= 640);
        }
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(ticks(&(0.9..60.0), 9), [1.0, 2.0, 5.0, 10.0, 20.0, 50.0]);
        assert_eq!(ticks(&(0.9..60.0), 4), [1.0, 3.0, 10.0, 30.0]);
        assert_eq!(ticks(&(3.4..4.8), 4), [3.5, 4.0, 4.5]);
        let close = |range, expected: &[f64]| {
            let found = ticks(&range, 7);
            let are_close = found.iter().zip(expected).all(|(one, other)| (one - other).abs() < 1e-12);
            assert!(found.len() == expected.len() && are_close, "{found:?}");
        };
        close(0.94..1.07, &[0.94, 0.96, 0.98, 1.0, 1.02, 1.04, 1.06]);
        close(0.6..1.9, &[0.6, 0.8, 1.0, 1.2, 1.4, 1.6, 1.8]);
        assert_eq!(ticks(&(0.9e-9..1.1), 4), [1e-9, 1e-6, 1e-3, 1.0]);
        assert_eq!(ticks(&(0.9..11000.0), 5), [1.0, 10.0, 100.0, 1000.0, 10000.0]);
    }
}
