//! Colours, names and numbers, in the form in which charts and pages show them.

use plotters::style::RGBColor;

use crate::format::{Words, hint::Language};

/// Colour of text, axes and ticks. Charts are drawn in the colours for white paper; [`for_screen`] replaces them by the
/// colours of the page.
pub const INK: RGBColor = RGBColor(0x26, 0x26, 0x2B);
/// Colour of the grid lines.
pub const GRID: RGBColor = RGBColor(0xDC, 0xDC, 0xE2);
/// Colours of the series, each with its replacement for a dark page. They follow Okabe and Ito, so most colour-blind
/// readers can distinguish them.
pub const SERIES: [(RGBColor, &str); 8] = [
    (RGBColor(0x5C, 0x5C, 0x66), "#A9A9B4"),
    (RGBColor(0x00, 0x72, 0xB2), "#56B4E9"),
    (RGBColor(0xD5, 0x5E, 0x00), "#F08A3C"),
    (RGBColor(0x00, 0x8A, 0x63), "#35C79A"),
    (RGBColor(0xAA, 0x45, 0x83), "#DD8DBB"),
    (RGBColor(0x9A, 0x73, 0x00), "#E0B93A"),
    (RGBColor(0x7A, 0x1F, 0x1F), "#E38383"),
    (RGBColor(0x4B, 0x3F, 0xB5), "#A79CF0"),
];

/// Returns a colour in the notation of SVG, such as `#26262B`.
pub fn hex(RGBColor(red, green, blue): RGBColor) -> String {
    format!("#{red:02X}{green:02X}{blue:02X}")
}

/// Returns the SVG of a chart in which CSS variables replace its colours, so that the chart follows the light or dark
/// colours of the page.
pub fn for_screen(svg: &str) -> String {
    let mut svg = svg.replace(&hex(INK), "currentColor").replace(&hex(GRID), "var(--grid)");
    for (index, (color, _)) in SERIES.iter().enumerate() {
        svg = svg.replace(&hex(*color), &format!("var(--series-{index})"));
    }
    svg
}

/// Returns the definitions of the CSS variables that [`for_screen`] uses, with the values for a light page, or for a
/// dark page if `dark`.
pub fn variables(dark: bool) -> String {
    let tone = |(color, dark_tone): &(RGBColor, &str)| if dark { (*dark_tone).to_owned() } else { hex(*color) };
    let grid = if dark { "#3A3A42".to_owned() } else { hex(GRID) };
    let series = SERIES.iter().map(tone).enumerate().map(|(index, tone)| format!("--series-{index}:{tone};"));
    format!("--grid:{grid};{}", series.collect::<String>())
}

/// Returns a text that explains the implementation with this name.
pub fn engine_meaning(engine: &str, language: Language) -> String {
    let (layout, set) = engine.split_once('-').unwrap_or((engine, ""));
    let words: Words = match layout {
        "reference" => [
            "follows the definition line by line and tries every object for every ray; the yardstick",
            "sigue la definición línea a línea y prueba todos los objetos para cada rayo; la vara de medir",
        ],
        "aos" => ["arrays of structures, {}", "arrays de estructuras, {}"],
        "soa" => ["structures of arrays, {}", "estructuras de arrays, {}"],
        _ => return engine.to_owned(),
    };
    let set_words: Words = match set {
        "portable" => ["without explicit vector instructions", "sin instrucciones vectoriales explícitas"],
        "avx2" => ["AVX2: vectors of 256 bits", "AVX2: vectores de 256 bits"],
        "avx512" => [
            "AVX-512: vectors of 512 bits, but of 256 for the paths of small scenes",
            "AVX-512: vectores de 512 bits, pero de 256 para los caminos de escenas pequeñas",
        ],
        "avx512-throughout" => ["AVX-512: vectors of 512 bits throughout", "AVX-512: vectores de 512 bits en todo"],
        _ => ["{} instructions", "instrucciones {}"],
    };
    language.say(words, &[&language.say(set_words, &[set])])
}

/// Returns the value of a parameter in words, as in `1 sample`, `10 objects` or `64 pixels wide`.
pub fn setting(parameter: &str, value: u64, language: Language) -> String {
    let words: Words = match (parameter, value) {
        ("samples", 1) => ["{} sample", "{} muestra"],
        ("samples", _) => ["{} samples", "{} muestras"],
        ("objects", 1) => ["{} object", "{} objeto"],
        ("objects", _) => ["{} objects", "{} objetos"],
        ("density", _) => ["{} objects in the same view", "{} objetos en la misma vista"],
        ("width", _) => ["{} pixels wide", "{} píxeles de ancho"],
        _ => return format!("{} {value}", parameter_name(parameter, language)),
    };
    language.say(words, &[&value.to_string()])
}

/// Returns the name of a parameter of the suite `scale` in words.
pub fn parameter_name(parameter: &str, language: Language) -> &str {
    match (language, parameter) {
        (Language::Spanish, "width") => "anchura",
        (Language::Spanish, "samples") => "muestras",
        (Language::Spanish, "depth") => "profundidad",
        (Language::English, "density") => "objects in the same view",
        (Language::Spanish, "density") => "objetos en la misma vista",
        (Language::Spanish, "objects") => "objetos",
        _ => parameter,
    }
}

/// Formats a time in seconds with a suitable unit and three significant digits.
pub fn seconds(value: f64) -> String {
    let (scaled, unit) = match value {
        value if value >= 0.999_5 => (value, "s"),
        value if value >= 0.999_5e-3 => (value * 1e3, "ms"),
        value => (value * 1e6, "µs"),
    };
    format!("{} {unit}", short(scaled))
}

/// Formats a number with three significant digits, without trailing zeros after the point.
pub fn short(value: f64) -> String {
    let digits = if value == 0.0 { 0 } else { (2 - value.abs().log10().floor() as i32).clamp(0, 6) };
    let text = format!("{value:.*}", digits as usize);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// Returns a text that holds numbers and no other point, with the decimal commas of Spanish if `language` is Spanish.
pub fn localized(text: String, language: Language) -> String {
    match language {
        Language::English => text,
        Language::Spanish => text.replace('.', ","),
    }
}

/// Formats a number as [`short`] does, in a language.
pub fn number(value: f64, language: Language) -> String {
    localized(short(value), language)
}

/// Formats a time as [`seconds`] does, in a language.
pub fn time(value: f64, language: Language) -> String {
    localized(seconds(value), language)
}

/// Returns the parts with `separator` between them, or `None` if there are none.
pub fn joined(parts: impl Iterator<Item = String>, separator: &str) -> Option<String> {
    let parts: Vec<_> = parts.collect();
    (!parts.is_empty()).then(|| parts.join(separator))
}

/// Formats a value and its standard error, both rounded to the first digit of the error. Without a usable error,
/// formats only the value, with [`short`].
pub fn with_error(value: f64, error: Option<f64>, language: Language) -> String {
    let text = match error.filter(|error| *error > 0.0 && error.is_finite()) {
        Some(error) => {
            let places = (-error.log10().floor()).clamp(0.0, 6.0) as usize;
            format!("{value:.places$} ± {error:.places$}")
        }
        None => short(value),
    };
    localized(text, language)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_have_units_that_suit_them() {
        let texts = [12.345, 1.0, 0.999_9, 0.05, 0.001, 0.000_02].map(seconds);
        assert_eq!(texts, ["12.3 s", "1 s", "1 s", "50 ms", "1 ms", "20 µs"]);
    }

    #[test]
    fn one_is_singular() {
        let texts = [("samples", 1), ("samples", 2), ("objects", 1), ("depth", 64)]
            .map(|(of, value)| [Language::English, Language::Spanish].map(|language| setting(of, value, language)));
        assert_eq!(
            texts.concat(),
            ["1 sample", "1 muestra", "2 samples", "2 muestras", "1 object", "1 objeto", "depth 64", "profundidad 64"]
        );
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!([0.0, 0.0123456, 1.5, 1234.5, -0.4987].map(short), ["0", "0.0123", "1.5", "1234", "-0.499"]);
    }

    #[test]
    fn an_error_has_one_digit() {
        let english = |value, error| with_error(value, error, Language::English);
        assert_eq!(english(1.9345, Some(0.0252)), "1.93 ± 0.03");
        assert_eq!(english(-0.498_12, Some(0.002)), "-0.498 ± 0.002");
        assert_eq!((english(0.5, None), english(0.5, Some(0.0))), ("0.5".to_owned(), "0.5".to_owned()));
    }

    #[test]
    fn spanish_numbers_have_decimal_commas() {
        let spanish = Language::Spanish;
        let texts = [number(0.125, spanish), time(0.0125, spanish), with_error(1.9345, Some(0.0252), spanish)];
        assert_eq!(texts, ["0,125", "12,5 ms", "1,93 ± 0,03"]);
    }

    #[test]
    fn a_chart_on_a_page_has_no_colour_of_its_own() {
        let svg = format!("<a fill=\"{}\" stroke=\"{}\" x=\"{}\">", hex(INK), hex(GRID), hex(SERIES[1].0));
        assert_eq!(for_screen(&svg), "<a fill=\"currentColor\" stroke=\"var(--grid)\" x=\"var(--series-1)\">");
        assert!(variables(true).contains("--series-6:#E38383;") && variables(false).contains("--grid:#DCDCE2;"));
    }
}
