//! Draws plots as SVG without a library. A plot has groups of marks above a logarithmic scale, or lines.

use std::fmt::Write;

/// The marks of one implementation in a plot.
#[derive(Clone, Debug)]
pub struct Series {
    /// Name in the legend.
    pub name: String,
    /// Colour of the marks, in the notation of SVG.
    pub color: &'static str,
    /// A value for each category of the plot, or `None` for a category without a mark.
    pub values: Vec<Option<f64>>,
    /// Index of the series whose values should be equal. If it is given, the marks of this series are rings around the
    /// marks of that series. In [`Plot::series`], series of rings come after all other series.
    pub around: Option<usize>,
}

/// Colours of the series. They differ in brightness too, so that colour-blind readers can distinguish them.
pub const COLORS: [&str; 4] = ["#d62728", "#1f4fb4", "#f0a030", "#59a14f"];

/// A plot: its texts, its scale and its series.
#[derive(Clone, Debug)]
pub struct Plot {
    /// Title above the plot.
    pub title: String,
    /// Label of the vertical axis.
    pub axis: String,
    /// The exponents of the lowest and the highest power of ten on the vertical axis. Smaller values are drawn at the
    /// bottom.
    pub decades: (i32, i32),
    /// Names of the categories, from left to right. A name may be empty.
    pub categories: Vec<String>,
    /// The series, in the order of the legend.
    pub series: Vec<Series>,
    /// Whether a line joins the marks of a series. If so, the categories are positions on a horizontal axis.
    pub joined: bool,
}

const WIDTH: f64 = 960.0;
const HEIGHT: f64 = 500.0;
const LEFT: f64 = 80.0;
const RIGHT: f64 = 20.0;
const TOP: f64 = 86.0;
const BOTTOM: f64 = 110.0;

impl Plot {
    fn height_of(&self, value: f64) -> f64 {
        let (low, high) = (f64::from(self.decades.0), f64::from(self.decades.1));
        let share = ((value.log10() - low) / (high - low)).clamp(0.0, 1.0);
        HEIGHT - BOTTOM - share * (HEIGHT - TOP - BOTTOM)
    }

    fn middle_of(&self, category: usize) -> f64 {
        LEFT + (category as f64 + 0.5) * (WIDTH - LEFT - RIGHT) / self.categories.len() as f64
    }

    /// Returns the plot as the text of an SVG file.
    #[must_use]
    pub fn svg(&self) -> String {
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" \
             font-size=\"12\">\n<rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"white\"/>\n\
             <text x=\"{LEFT}\" y=\"22\" font-size=\"16\">{}</text>\n",
            self.title
        );
        self.scale(&mut text);
        for (index, series) in self.series.iter().enumerate() {
            self.legend(&mut text, index, series);
            self.marks(&mut text, index, series);
        }
        text.push_str("</svg>\n");
        text
    }

    fn scale(&self, text: &mut String) {
        // Writing to a `String` never fails, so errors are ignored.
        for decade in self.decades.0..=self.decades.1 {
            let y = self.height_of(10.0_f64.powi(decade));
            let _ = writeln!(text, "<path d=\"M{LEFT} {y:.1}H{}\" stroke=\"#ddd\"/>", WIDTH - RIGHT);
            let every = (self.decades.1 - self.decades.0) / 10 + 1;
            if (decade - self.decades.0) % every == 0 {
                let _ = writeln!(
                    text,
                    "<text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">1e{decade}</text>",
                    LEFT - 6.0,
                    y + 4.0
                );
            }
        }
        let middle = (TOP + HEIGHT - BOTTOM) / 2.0;
        let _ = writeln!(
            text,
            "<text x=\"18\" y=\"{middle}\" transform=\"rotate(-90 18 {middle})\" text-anchor=\"middle\">{}</text>",
            self.axis
        );
        for (index, category) in self.categories.iter().enumerate() {
            let (x, y) = (self.middle_of(index), HEIGHT - BOTTOM + 16.0);
            let _ = writeln!(
                text,
                "<text x=\"{x:.1}\" y=\"{y}\" transform=\"rotate(-25 {x:.1} {y})\" text-anchor=\"end\">{category}</text>"
            );
        }
    }

    /// Returns the column of series number `index`, in the legend and in each group of marks.
    fn column(&self, index: usize) -> f64 {
        self.series[index].around.unwrap_or(index) as f64
    }

    fn legend(&self, text: &mut String, index: usize, series: &Series) {
        let (x, y) = (LEFT + 6.0 + 200.0 * self.column(index), if series.around.is_some() { 64.0 } else { 43.0 });
        mark(text, (x, y), series);
        let _ = writeln!(text, "<text x=\"{}\" y=\"{}\">{}</text>", x + 14.0, y + 4.0, series.name);
    }

    fn marks(&self, text: &mut String, index: usize, series: &Series) {
        let spread = (WIDTH - LEFT - RIGHT) / self.categories.len() as f64 * 0.7;
        let columns = self.series.iter().filter(|series| series.around.is_none()).count();
        let place = (self.column(index) + 0.5) / columns as f64 - 0.5;
        let offset = if self.joined { 0.0 } else { place * spread };
        let places: Vec<(f64, f64)> = (0..)
            .zip(&series.values)
            .filter_map(|(category, value)| Some((self.middle_of(category) + offset, self.height_of((*value)?))))
            .collect();
        let color = series.color;
        if self.joined && series.around.is_none() {
            let points: Vec<String> = places.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
            let points = points.join(" ");
            let _ =
                writeln!(text, "<polyline points=\"{points}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"2\"/>");
        }
        for (x, y) in places {
            if !self.joined && series.around.is_none() {
                let foot = HEIGHT - BOTTOM;
                let _ = writeln!(
                    text,
                    "<path d=\"M{x:.1} {foot}V{y:.1}\" stroke=\"{color}\" stroke-width=\"3\" stroke-opacity=\".35\"/>"
                );
            }
            mark(text, (x, y), series);
        }
    }
}

/// Draws the mark of `series` at the point (`x`, `y`): a dot, or a ring around a dot.
fn mark(text: &mut String, (x, y): (f64, f64), series: &Series) {
    let color = series.color;
    let look = match series.around {
        None => format!("r=\"4\" fill=\"{color}\""),
        Some(_) => format!("r=\"6.5\" fill=\"none\" stroke=\"{color}\" stroke-width=\"1.5\""),
    };
    let _ = writeln!(text, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" {look}/>");
}
