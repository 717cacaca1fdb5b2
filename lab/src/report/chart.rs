//! A chart with logarithmic axes, as SVG: lines with markers and bounds, or a column of dots.

mod draw;

use plotters::prelude::*;

/// What a chart shows.
#[derive(Clone, Debug)]
pub struct Chart {
    /// Name of its file.
    pub name: String,
    /// Heading.
    pub title: String,
    /// What the horizontal axis has, with its unit.
    pub x: Axis,
    /// What the vertical axis has, with its unit.
    pub y: Axis,
    /// What is drawn, in the order of the legend.
    pub series: Vec<Series>,
    /// Names of the rows of a column of dots, whose `y` counts rows from the top; empty for lines.
    pub rows: Vec<String>,
}

/// An axis: its words, and how its numbers are written.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// What it has, with its unit.
    pub label: &'static str,
    /// A number in words.
    pub format: fn(f64) -> String,
}

/// Points that belong together.
#[derive(Clone, Debug)]
pub struct Series {
    /// Its name in the legend.
    pub name: String,
    /// Which of [`super::style::SERIES`]' colours, and which marker, it has.
    pub color: usize,
    /// A guide to the eye: a thin dashed line without markers.
    pub is_guide: bool,
    /// The points.
    pub points: Vec<Point>,
}

/// A measured point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Horizontal.
    pub x: f64,
    /// Vertical.
    pub y: f64,
    /// Bounds of what was measured.
    pub bounds: Option<Bounds>,
}

/// Lower and upper bound of a coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bounds {
    /// Of the horizontal one.
    Horizontal(f64, f64),
    /// Of the vertical one.
    Vertical(f64, f64),
}

impl Point {
    /// Both ends of the bar that shows its bounds; both the point itself without any.
    #[must_use]
    pub fn ends(&self) -> [(f64, f64); 2] {
        match self.bounds {
            None => [(self.x, self.y); 2],
            Some(Bounds::Horizontal(low, high)) => [(low, self.y), (high, self.y)],
            Some(Bounds::Vertical(low, high)) => [(self.x, low), (self.x, high)],
        }
    }
}

const WIDTH: u32 = 600;
const LEGEND_ROW: u32 = 22;
const TITLE: u32 = 34;
const LEFT: i32 = 14;
/// Width of a letter, near enough: only the legend's line breaks depend on it.
const LETTER: i32 = 8;

impl Chart {
    /// The chart as SVG.
    ///
    /// # Errors
    /// It has no point, or something that a logarithmic axis cannot show.
    pub fn draw(&self) -> Result<String, String> {
        let points = || self.series.iter().flat_map(|series| &series.points);
        if points().next().is_none() || points().any(|point| point.x <= 0.0 || point.y <= 0.0) {
            return Err(format!("the chart {} has no points, or some that are not positive", self.name));
        }
        let legend = self.legend();
        let rows = legend.iter().map(|&(row, _)| row + 1).max().unwrap_or(0);
        let head = TITLE + LEGEND_ROW * rows;
        // Room in each row for a marker of every series.
        let row = (11 * self.series.len() as u32).max(34);
        let body = if self.rows.is_empty() { 330 } else { 80 + row * self.rows.len() as u32 };
        let mut svg = String::new();
        {
            let root = SVGBackend::with_string(&mut svg, (WIDTH, head + body)).into_drawing_area();
            let (top, bottom) = root.split_vertically(head);
            self.draw_head(&top, &legend).map_err(|error| error.to_string())?;
            if self.rows.is_empty() { self.draw_lines(&bottom) } else { self.draw_dots(&bottom) }
                .map_err(|error| error.to_string())?;
            root.present().map_err(|error| error.to_string())?;
        }
        // Scaled to where it is shown, and named for those who do not see it.
        let size = format!("width=\"{WIDTH}\" height=\"{}\" ", head + body);
        let title = self.title.replace('&', "&amp;").replace('<', "&lt;");
        Ok(svg.replacen(&size, "role=\"img\" ", 1).replacen("viewBox", &format!("aria-label=\"{title}\" viewBox"), 1))
    }

    /// Row and left end of each entry of the legend.
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
        assert!(svg.starts_with("<svg role=\"img\" aria-label=\"Less &lt; more\" viewBox=\"0 0 600 "), "{svg}");
        assert!(svg.contains("time in s") && svg.contains("a &amp; b") && svg.contains("\n100\n"), "{svg}");
        assert_eq!(svg.matches("<circle").count(), 4, "three points and the legend");
    }

    #[test]
    fn what_a_logarithmic_axis_cannot_show_is_refused() {
        assert!(chart(Vec::new()).draw().is_err());
        assert!(chart(vec![Point { x: 0.0, y: 1.0, bounds: None }]).draw().is_err());
    }
}
