//! One rendering with a person's modules: the pictures it writes and what it has to say.

use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;

use cpu::Vec3;
use shaders::Features;

use super::args::Options;
use super::files::{self, UserModule};
use super::progress::Progress;
use super::truth::Truth;
use super::view::{View, mark};
use super::{pixel, png};
use crate::difference::difference;
use crate::steps::Follower;
use crate::{Error, Float, Gpu, Picture, Renderer, features_of};

/// What one trial is made from.
#[derive(Clone, Copy, Debug)]
pub struct Trial<'a> {
    /// Where it runs.
    pub gpu: &'a Gpu,
    /// What was asked for.
    pub options: &'a Options,
    /// The person's modules.
    pub modules: &'a [UserModule],
    /// What it is held against.
    pub truth: &'a Truth,
}

/// What a trial found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// The report for a person.
    pub report: String,
    /// Whether a bit of the picture differs from the CPU's in the same precision.
    pub differs: bool,
}

/// A precision that trials are made in: where to find what it is held against.
pub trait Held: Float {
    /// The CPU's picture in this precision.
    fn picture(truth: &Truth) -> &[Vec3<Self>];
}

impl Held for f64 {
    fn picture(truth: &Truth) -> &[Vec3] {
        &truth.wide
    }
}

impl Held for f32 {
    fn picture(truth: &Truth) -> &[Vec3<Self>] {
        truth.single()
    }
}

impl Trial<'_> {
    /// Renders, writes the pictures and gives the report.
    ///
    /// # Errors
    /// [`Error::Shader`] with the place in the person's file, or what the device finds wrong.
    pub fn run<T: Held>(&self) -> Result<Outcome, Error> {
        let Self { gpu, options, modules, truth } = *self;
        let out = &options.out;
        let library = files::library(modules)?;
        let (features, own) =
            options.apply(features_of(&truth.config, &truth.scene)?).map_err(|message| Error::Request { message })?;
        self.check_constants::<T>(&own)?;
        let start = Instant::now();
        let renderer = Renderer::<T>::with_constants(gpu, &library, &features, &own)?;
        let compiled = start.elapsed();
        let picture = Picture::<T>::new(&truth.config, &truth.scene)?;
        let mut progress = Progress::start();
        let rendering = renderer.render_telling(&picture, |done, of| {
            if let Some(text) = progress.tell(done, of) {
                eprintln!("{text}");
            }
        })?;
        let mut report = format!("in {} on {gpu}\n", T::PRECISION);
        for UserModule { name, path, .. } in modules {
            let _ = writeln!(report, "{} stands in for [{name}]", path.display());
        }
        let size = rendering.size;
        let _ = writeln!(
            report,
            "{} x {} pixels in {:.1?}, after {compiled:.1?} to compile; the CPU took {:.1?}, one core, the definition",
            size.width(),
            size.height(),
            rendering.time,
            truth.time,
        );
        let held = T::picture(truth);
        let apart = difference(&rendering.pixels, held);
        let _ = writeln!(report, "from the CPU in {}: {apart}", T::PRECISION);
        if size_of::<T>() < size_of::<f64>() {
            let _ = writeln!(report, "from the CPU in f64: {}", difference(&rendering.pixels, &truth.wide));
        }
        match options.view {
            None => {
                let [by_wgsl, by_cpu] =
                    [&rendering.pixels[..], held].map(|pixels| png::bytes(pixels, truth.config.gamma));
                png::write(out, size, &by_wgsl)?;
                let _ = writeln!(report, "wrote {}", out.display());
                // Standard output has room for one picture.
                if out != Path::new("-") {
                    let beside = png::beside(out, "difference");
                    let (colors, words) = differences(&rendering.pixels, held);
                    let panels = [("WGSL", &by_wgsl[..]), ("CPU", &by_cpu[..]), (&words, &colors[..])];
                    png::write_canvas(&beside, &annotate::panels(&panels, size.width()))?;
                    let _ = writeln!(report, "wrote {} (WGSL, CPU, their difference)", beside.display());
                }
            }
            Some(View::Difference) => {
                let (colors, words) = differences(&rendering.pixels, held);
                let panel = [(&words[..], &colors[..])];
                png::write_canvas(out, &annotate::panels(&panel, size.width()))?;
                let _ = writeln!(report, "wrote {} (the difference of the colours)", out.display());
            }
            Some(view) => report.push_str(&self.show::<T>(view, &features, &own, &picture)?),
        }
        if let Some([x, y]) = options.pixel {
            if x >= size.width() || y >= size.height() {
                let message = format!("--pixel: the picture has {} x {} pixels", size.width(), size.height());
                return Err(Error::Request { message });
            }
            let index = y * size.width() + x;
            report.push_str(&self.follow(index, &features, &own, &picture)?);
            report.push_str(&pixel::colors(held[index].to_array(), rendering.pixels[index].to_array()));
        }
        Ok(Outcome { report, differs: apart.differing > 0 })
    }

    /// Writes a view of both sides and where their numbers differ.
    fn show<T: Held>(
        &self,
        view: View,
        features: &Features,
        own: &[(&str, f64)],
        picture: &Picture<T>,
    ) -> Result<String, Error> {
        let depth = if view.is_deep() { features.max_depth } else { features.max_depth.min(1) };
        let features = Features { max_depth: depth, ..*features };
        let follower = Follower::<T>::new(self.gpu, &files::library(self.modules)?, &features, own)?;
        let by_cpu = Picture { max_depth: depth, ..picture.clone() };
        let (mut wgsl, mut cpu, mut marks) = (Vec::new(), Vec::new(), Vec::new());
        follower.follow(picture, 0, picture.size.pixels(), |index, steps| {
            let expected = by_cpu.steps(index);
            wgsl.push(view.color(steps, depth));
            cpu.push(view.color(&expected, depth));
            marks.push(mark(&expected, steps));
        })?;
        let out = &self.options.out;
        png::write(out, picture.size, &wgsl)?;
        let count = marks.iter().filter(|mark| **mark != [0; 3]).count();
        let total = marks.len();
        let first = marks.iter().position(|mark| *mark != [0; 3]).map(|index| {
            let width = picture.size.width();
            format!(", the first of them --pixel {} {}", index % width, index / width)
        });
        let first = first.unwrap_or_default();
        let mut text = format!("{count} of {total} pixels have another bit on their way{first}\n");
        let _ = writeln!(text, "wrote {} ({view} by WGSL)", out.display());
        if out != Path::new("-") {
            let both = png::beside(out, &view.to_string());
            let [by_wgsl, by_cpu] = ["WGSL", "CPU"].map(|side| format!("{view}, {side}"));
            let panels = [(&by_wgsl[..], &wgsl[..]), (&by_cpu, &cpu), ("white: another bit", &marks)];
            png::write_canvas(&both, &annotate::panels(&panels, picture.size.width()))?;
            let words = "by WGSL, by the CPU, and white where any number's bits differ";
            let _ = writeln!(text, "wrote {} ({view} {words})", both.display());
        }
        Ok(text)
    }

    /// The way of the pixel at `index` on both sides.
    fn follow<T: Held>(
        &self,
        index: usize,
        features: &Features,
        own: &[(&str, f64)],
        picture: &Picture<T>,
    ) -> Result<String, Error> {
        let follower = Follower::<T>::new(self.gpu, &files::library(self.modules)?, features, own)?;
        let expected = Picture { max_depth: features.max_depth, ..picture.clone() }.steps(index);
        let mut text = String::new();
        follower.follow(picture, index, 1, |_, steps| text = pixel::side_by_side(&expected, steps))?;
        Ok(text)
    }

    /// An error for a constant that no module declares.
    fn check_constants<T: Held>(&self, own: &[(&str, f64)]) -> Result<(), Error> {
        let shader = files::library(self.modules)?.compose("kernels/image", T::PRECISION)?.validate()?;
        let known: Vec<_> =
            shader.module.overrides.iter().filter_map(|(_, constant)| constant.name.as_deref()).collect();
        match own.iter().find(|(name, _)| !known.contains(name)) {
            None => Ok(()),
            Some((name, _)) => {
                let message = format!("--set: there is no constant [{name}]; there are: {}", known.join(", "));
                Err(Error::Request { message })
            }
        }
    }
}

/// How far each pixel's channels are apart at most, as colours on a scale of their own, and the words for the scale.
///
/// The scale is logarithmic, from the smallest difference to the largest: roundings differ by many orders of magnitude.
/// Pixels without a difference are black; what is no number on one side only has the last colour.
fn differences<T: Float>(one: &[Vec3<T>], other: &[Vec3<T>]) -> (Vec<[u8; 3]>, String) {
    /// The smallest difference has this place of the map, so that it is told from none.
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
    fn the_smallest_differences_are_seen_on_a_scale_of_their_own() {
        let one = [Vec3::ZERO; 4];
        let other = [0.0, 1e-16, 1e-13, 1e-10].map(|apart| Vec3::new(0.0, apart, 0.0));
        let (colors, words) = differences(&one, &other);
        let light = brightness(&colors);
        assert!(light[0] < 10 && light[1] > 100 && light[2] > light[1] + 100 && light[3] > light[2] + 100, "{light:?}");
        assert_eq!(words, "difference: none black, 1e-16 dark, 1e-10 light");
    }

    #[test]
    fn equal_pictures_are_black_and_what_is_no_number_is_light() {
        let one = [Vec3::ZERO, Vec3::ZERO];
        let (colors, words) = differences(&one, &one);
        assert!(brightness(&colors).iter().all(|&light| light < 10));
        assert_eq!(words, "difference: none");
        let (colors, _) = differences(&one, &[Vec3::new(f64::NAN, 0.0, 0.0), Vec3::new(1e-9, 0.0, 0.0)]);
        assert_eq!(colors[0], colors[1], "one difference alone has the last colour too");
        assert!(brightness(&colors)[0] > 500);
    }
}
