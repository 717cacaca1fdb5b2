//! Draws a chart with logarithmic axes as SVG: lines with markers and bounds, or rows of dots.

mod draw;

use plotters::prelude::*;

use crate::template::{escape, printable};

/// A chart: its texts, its axes and its data.
#[derive(Clone, Debug)]
pub struct Chart {
    /// Name of the chart's file, without an ending.
    pub name: String,
    /// Heading above the chart.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The series that are drawn, in the order of the legend.
    pub series: Vec<Series>,
    /// Names of the rows in a chart of dots; empty in a chart of lines. In a chart of dots, the `y` of a point is the
    /// number of its row, counted from 1 at the top.
    pub rows: Vec<String>,
}

/// An axis: its label, and the format of the numbers at its ticks.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// The quantity on the axis, with its unit.
    pub label: &'static str,
    /// Converts a number to the text at a tick.
    pub format: fn(f64) -> String,
}

/// A series: points that have one colour and are joined by a line.
#[derive(Clone, Debug)]
pub struct Series {
    /// Name of the series in the legend.
    pub name: String,
    /// Index of the colour in [`super::style::SERIES`], and of the marker's shape.
    pub color: usize,
    /// Whether the series shows a law instead of data. It is then drawn as a thin dashed line without markers.
    pub is_guide: bool,
    /// The points of the series, in the order of the line.
    pub points: Vec<Point>,
}

/// A measured point of a chart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Horizontal coordinate.
    pub x: f64,
    /// Vertical coordinate.
    pub y: f64,
    /// Bounds of the measured coordinate; `None` if no bar is drawn.
    pub bounds: Option<Bounds>,
}

/// Lower and upper bound of one coordinate of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bounds {
    /// Bounds of the horizontal coordinate.
    Horizontal(f64, f64),
    /// Bounds of the vertical coordinate.
    Vertical(f64, f64),
}

impl Point {
    /// Returns both ends of the bar that shows the bounds. If there are no bounds, both ends are the point itself.
    ///
    /// A logarithmic axis cannot show some bounds, such as 0. Such a bound is replaced by the point, so half of the bar
    /// is drawn.
    pub fn ends(&self) -> [(f64, f64); 2] {
        let shown = |bound: f64, point: f64| if bound > 0.0 && bound.is_finite() { bound } else { point };
        match self.bounds {
            None => [(self.x, self.y); 2],
            Some(Bounds::Horizontal(low, high)) => [low, high].map(|bound| (shown(bound, self.x), self.y)),
            Some(Bounds::Vertical(low, high)) => [low, high].map(|bound| (self.x, shown(bound, self.y))),
        }
    }
}

/// Width in pixels. Two charts side by side on a page of paper then have letters of 8 points.
const WIDTH: u32 = 480;
const LEGEND_ROW: u32 = 22;
const TITLE: u32 = 34;
const LEFT: i32 = 14;
/// Approximate width of a letter in pixels. Only the line breaks of the legend depend on it.
const LETTER: i32 = 8;

impl Chart {
    /// Returns the chart as the text of an SVG file.
    ///
    /// # Errors
    /// An error if the chart has no point, or if a coordinate is not positive and finite.
    pub fn draw(&self) -> Result<String, String> {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let is_shown = |value: f64| value > 0.0 && value.is_finite();
        if points().next().is_none() || !points().all(|point| is_shown(point.x) && is_shown(point.y)) {
            return Err(format!(
                "the chart {:?} has no points, or some that are not positive; correct the data",
                self.name
            ));
        }
        self.with_printable_text().draw_checked()
    }

    /// Returns a copy of the chart in which each character that SVG does not allow is replaced.
    fn with_printable_text(&self) -> Self {
        let mut chart = self.clone();
        chart.title = printable(&chart.title);
        chart.rows.iter_mut().for_each(|row| *row = printable(row));
        chart.series.iter_mut().for_each(|series| series.name = printable(&series.name));
        chart
    }

    fn draw_checked(&self) -> Result<String, String> {
        let legend = self.legend();
        let rows = legend.iter().map(|&(row, _)| row + 1).max().unwrap_or(0);
        let head = TITLE + LEGEND_ROW * rows;
        // Each row is high enough for the markers of all series, 11 pixels each.
        let row = (11 * self.series.len() as u32).max(34);
        let body = if self.rows.is_empty() { 300 } else { 80 + row * self.rows.len() as u32 };
        let mut svg = String::new();
        let hints = {
            let root = SVGBackend::with_string(&mut svg, (WIDTH, head + body)).into_drawing_area();
            let (top, bottom) = root.split_vertically(head);
            self.draw_head(&top, &legend).map_err(|error| error.to_string())?;
            let drawn = if self.rows.is_empty() { self.draw_lines(&bottom) } else { self.draw_dots(&bottom) };
            let hints = drawn.map_err(|error| error.to_string())?;
            root.present().map_err(|error| error.to_string())?;
            hints
        };
        // A browser shows the title of the element below the pointer.
        let hints: String = hints.iter().map(|((x, y), text)| hint(*x, *y + head as i32, text)).collect();
        svg = svg.replace("</svg>", &format!("{hints}</svg>"));
        // Without a fixed size, a browser scales the chart to its container. Screen readers read the label aloud.
        let size = format!("width=\"{WIDTH}\" height=\"{}\" ", head + body);
        let label = format!("aria-label=\"{}\" viewBox", escape(&self.title));
        Ok(svg.replacen(&size, "role=\"img\" ", 1).replacen("viewBox", &label, 1))
    }

    /// Returns the values of a point of a series as words.
    fn words(&self, series: &Series, point: &Point) -> String {
        let row = self.rows.get((point.y.round() as usize).wrapping_sub(1));
        let y = row.cloned().unwrap_or_else(|| format!("{}: {}", self.y.label, (self.y.format)(point.y)));
        let (format, bounds) = match point.bounds {
            None => return format!("{}\n{y}\n{}: {}", series.name, self.x.label, (self.x.format)(point.x)),
            Some(Bounds::Horizontal(low, high)) => (self.x.format, [low, high]),
            Some(Bounds::Vertical(low, high)) => (self.y.format, [low, high]),
        };
        let [low, high] = bounds.map(format);
        format!("{}\n{y}\n{}: {}\n{low} – {high}", series.name, self.x.label, (self.x.format)(point.x))
    }

    /// Returns the position of each entry of the legend: the number of its row, and its left end in pixels.
    fn legend(&self) -> Vec<(u32, i32)> {
        let (mut row, mut x) = (0, LEFT);
        let mut places = Vec::new();
        for series in &self.series {
            let width = 36 + LETTER * series.name.chars().count() as i32;
            if x + width > WIDTH as i32 && x > LEFT {
                (row, x) = (row + 1, LEFT);
            }
            places.push((row, x));
            x += width;
        }
        places
    }
}

/// Returns an element that is not seen, and that tells `text` where the pointer is near the marker at `x` and `y`.
fn hint(x: i32, y: i32, text: &str) -> String {
    let text = text.split('\n').map(escape).collect::<Vec<_>>().join("\n");
    format!(
        "<rect x=\"{}\" y=\"{}\" width=\"16\" height=\"16\" opacity=\"0\"><title>{text}</title></rect>\n",
        x - 8,
        y - 8
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(points: Vec<Point>) -> Chart {
        let axis = Axis { label: "time in s", format: |value| format!("{value}") };
        let series = vec![Series { name: "a & b".to_owned(), color: 1, is_guide: false, points }];
        Chart { name: "c".to_owned(), title: "Less < more".to_owned(), x: axis, y: axis, series, rows: Vec::new() }
    }

    #[test]
    fn a_chart_is_an_svg_that_scales() {
        let points = [1.0, 10.0, 100.0].map(|x| Point { x, y: 2.0 * x, bounds: Some(Bounds::Vertical(x, 3.0 * x)) });
        let svg = chart(points.to_vec()).draw().expect("there are points");
        assert!(svg.starts_with("<svg role=\"img\" aria-label=\"Less &lt; more\" viewBox=\"0 0 480 "), "{svg}");
        assert!(svg.contains("time in s") && svg.contains("a &amp; b") && svg.contains("\n100\n"), "{svg}");
        assert_eq!(svg.matches("<circle").count(), 4, "three points and the legend");
        let hint = "<title>a &amp; b\ntime in s: 20\ntime in s: 10\n10 – 30</title>";
        assert!(svg.matches("<title>").count() == 3 && svg.contains(hint), "{svg}");
    }

    #[test]
    fn what_a_logarithmic_axis_cannot_show_is_refused() {
        assert!(chart(Vec::new()).draw().is_err());
        for (x, y) in [(0.0, 1.0), (1.0, -1.0), (f64::NAN, 1.0), (1.0, f64::INFINITY)] {
            assert!(chart(vec![Point { x, y, bounds: None }]).draw().is_err(), "{x} {y}");
        }
    }

    #[test]
    fn a_bound_of_zero_takes_half_the_bar_and_the_largest_numbers_are_drawn() {
        let far = [5e-324, f64::MAX].map(|x| Point { x, y: x, bounds: Some(Bounds::Vertical(x, x)) });
        assert!(chart(far.to_vec()).draw().is_ok());
        for bounds in
            [Bounds::Vertical(0.0, 3.0), Bounds::Horizontal(-1.0, f64::INFINITY), Bounds::Vertical(f64::NAN, 3.0)]
        {
            let point = Point { x: 1.0, y: 2.0, bounds: Some(bounds) };
            assert!(point.ends().iter().all(|(x, y)| *x > 0.0 && *y > 0.0 && x.is_finite() && y.is_finite()));
            assert!(chart(vec![point]).draw().is_ok(), "{bounds:?}");
        }
    }

    #[test]
    fn control_characters_and_quotes_leave_valid_svg() {
        let mut chart = chart(vec![Point { x: 1.0, y: 2.0, bounds: None }]);
        chart.title = "a\0b\u{1b}\" onload=\"x".to_owned();
        chart.series[0].name = "s\u{8}\u{ffff}".to_owned();
        let svg = chart.draw().expect("there is a point");
        assert!(svg.contains("aria-label=\"a\u{fffd}b\u{fffd}&quot; onload=&quot;x\""), "{svg}");
        assert!(svg.contains("s\u{fffd}\u{fffd}"), "{svg}");
        assert!(!svg.chars().any(|c| c.is_control() && c != '\n'), "{svg}");
    }
}
