//! A chart with logarithmic axes, as SVG: lines with markers and bounds, or a column of dots.

use plotters::coord::Shift;
use plotters::coord::ranged1d::{Ranged, ValueFormatter};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::axis::{Logarithmic, range};
use super::style::{GRID, INK, SERIES};

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
    /// Which of [`SERIES`]' colours, and which marker, it has.
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
    /// Bounds of what was measured: vertical for lines, horizontal for dots.
    pub bounds: Option<(f64, f64)>,
}

const WIDTH: u32 = 600;
const LEGEND_ROW: u32 = 22;
const TITLE: u32 = 34;
const LEFT: i32 = 14;
const FONT: i32 = 17;
/// Width of a letter, near enough: only the legend's line breaks depend on it.
const LETTER: i32 = 8;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

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
        let body = if self.rows.is_empty() { 330 } else { 80 + 34 * self.rows.len() as u32 };
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

    fn draw_head(&self, area: &Area<'_>, legend: &[(u32, i32)]) -> Result<(), Box<dyn std::error::Error>> {
        let text = |size: i32| ("sans-serif", size).into_font().color(&INK);
        area.draw(&Text::new(self.title.clone(), (LEFT, 8), text(21)))?;
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

    fn draw_lines(&self, area: &Area<'_>) -> Result<(), Box<dyn std::error::Error>> {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let x = range(points().map(|point| point.x), 1.25);
        let ends = |point: &Point| point.bounds.map_or([point.y; 2], |(low, high)| [low, high]);
        let y = range(points().flat_map(ends), 1.35);
        let mut chart = ChartBuilder::on(area)
            .margin_left(12)
            .margin_right(36)
            .margin_top(6)
            .x_label_area_size(48)
            .y_label_area_size(78)
            .build_cartesian_2d(Logarithmic(x), Logarithmic(y))?;
        self.draw_mesh(&mut chart)?;
        for series in &self.series {
            let style = color(series);
            let path: Vec<_> = series.points.iter().map(|point| (point.x, point.y)).collect();
            if series.is_guide {
                chart.draw_series(DashedLineSeries::new(path, 5, 4, style.stroke_width(1)))?;
                continue;
            }
            chart.draw_series(LineSeries::new(path, style.stroke_width(2)))?;
            for point in &series.points {
                if let Some((low, high)) = point.bounds {
                    let bar = PathElement::new([(point.x, low), (point.x, high)], style.stroke_width(1));
                    chart.draw_series([bar])?;
                }
                draw_marker(area, series.color, chart.backend_coord(&(point.x, point.y)).relative_to(area))?;
            }
        }
        Ok(())
    }

    fn draw_dots(&self, area: &Area<'_>) -> Result<(), Box<dyn std::error::Error>> {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let ends = |point: &Point| point.bounds.map_or([point.x; 2], |(low, high)| [low, high]);
        let x = range(points().flat_map(ends), 1.15);
        let count = self.rows.len() as f64;
        let mut chart = ChartBuilder::on(area)
            .margin_left(12)
            .margin_right(36)
            .margin_top(6)
            .x_label_area_size(48)
            .y_label_area_size(150)
            .build_cartesian_2d(Logarithmic(x), count + 0.5..0.5)?;
        self.draw_mesh(&mut chart)?;
        for (index, name) in self.rows.iter().enumerate() {
            let (_, y) = chart.backend_coord(&(1.0, index as f64 + 1.0)).relative_to(area);
            let style = ("sans-serif", FONT).into_font().color(&INK).pos(Pos::new(HPos::Right, VPos::Center));
            area.draw(&Text::new(name.clone(), (154, y), style))?;
        }
        for series in &self.series {
            for point in &series.points {
                if let Some((low, high)) = point.bounds {
                    let bar = PathElement::new([(low, point.y), (high, point.y)], color(series).stroke_width(1));
                    chart.draw_series([bar])?;
                }
                draw_marker(area, series.color, chart.backend_coord(&(point.x, point.y)).relative_to(area))?;
            }
        }
        Ok(())
    }

    /// Axes and grid; the vertical axis without numbers where rows have names instead.
    fn draw_mesh<X, Y>(
        &self,
        chart: &mut ChartContext<'_, SVGBackend<'_>, Cartesian2d<X, Y>>,
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
            .x_labels(7)
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

/// A place of the whole picture as a place of one of its areas.
trait RelativeTo {
    fn relative_to(self, area: &Area<'_>) -> (i32, i32);
}

impl RelativeTo for (i32, i32) {
    fn relative_to(self, area: &Area<'_>) -> (i32, i32) {
        let (left, top) = area.get_base_pixel();
        (self.0 - left, self.1 - top)
    }
}

fn color(series: &Series) -> RGBColor {
    if series.is_guide { INK } else { SERIES[series.color % SERIES.len()].0 }
}

/// Colours alone would not do for everyone: each has a shape as well.
fn draw_marker(area: &Area<'_>, color: usize, (x, y): (i32, i32)) -> Result<(), Box<dyn std::error::Error>> {
    let style = SERIES[color % SERIES.len()].0;
    let hollow = style.stroke_width(2);
    match color % SERIES.len() {
        0 => area.draw(&Rectangle::new([(x - 4, y - 4), (x + 4, y + 4)], style.filled()))?,
        1 => area.draw(&Circle::new((x, y), 5, style.filled()))?,
        2 => area.draw(&Polygon::new([(x, y - 6), (x + 6, y + 5), (x - 6, y + 5)], style.filled()))?,
        3 => area.draw(&Polygon::new([(x, y - 6), (x + 6, y), (x, y + 6), (x - 6, y)], style.filled()))?,
        4 => area.draw(&Circle::new((x, y), 5, hollow))?,
        5 => area.draw(&Rectangle::new([(x - 4, y - 4), (x + 4, y + 4)], hollow))?,
        _ => area.draw(&Polygon::new([(x, y + 6), (x + 6, y - 5), (x - 6, y - 5)], style.filled()))?,
    }
    Ok(())
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
        let points = [1.0, 10.0, 100.0].map(|x| Point { x, y: 2.0 * x, bounds: Some((x, 3.0 * x)) });
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
