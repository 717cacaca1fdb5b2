//! A trial: one rendering with the user's modules, the pictures that it writes, and its report.

use std::fmt::Write as _;

use cpu::{Config, Scene, Vec3};
use shaders::{Composition, Features, Library};

use super::args::Options;
use super::differences::differences;
use super::files::{self, UserModule};
use super::png::Places;
use super::rendered::{self, Rendered};
use super::truth::{Truth, check_size};
use super::{guard, pixel, png};
use crate::difference::difference;
use crate::first_difference;
use crate::picture::depth;
use crate::sampled::Convention;
use crate::sampled::recording::check_samples;
use crate::steps::Follower;
use crate::{Error, Float, Gpu, Picture, features_of, ray_loop};

/// The inputs of a trial, which is one rendering with the user's modules.
#[derive(Clone, Copy, Debug)]
pub struct Trial<'a> {
    /// The device that renders.
    pub gpu: &'a Gpu,
    /// The options of the command line.
    pub options: &'a Options,
    /// The user's modules.
    pub modules: &'a [UserModule],
    /// The picture by the CPU, with which this trial's picture is compared.
    pub truth: &'a Truth,
}

/// The result of a trial: its report, and whether the picture differs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// The text of the report for the user.
    pub report: String,
    /// Whether any bit of the picture differs from the CPU's picture in this precision.
    pub differs: bool,
}

/// A number type in which [`Truth`] has the CPU's picture, so that trials can be made in it.
pub trait Held: Float {
    /// Returns the CPU's picture in this precision.
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

/// Checks whether the options fit the configuration and the scene. It is called before the picture is rendered, so that
/// an error comes early.
///
/// # Errors
/// [`Error::Request`] for a pixel outside the picture or a constant that is refused, [`Error::TooManyIterations`] if
/// one surface of a path already takes too many iterations.
pub fn check(options: &Options, modules: &[UserModule], config: &Config, scene: &Scene) -> Result<(), Error> {
    check_size(config)?;
    if options.samples {
        check_samples(config)?;
    }
    let size = config.image_size().map_err(cpu::internals::input::error::Error::from)?;
    if let Some([x, y]) = options.pixel()
        && (x >= size.width() || y >= size.height())
    {
        let message = format!("--pixel: the picture has {} x {} pixels", size.width(), size.height());
        return Err(Error::Request { message });
    }
    let (features, _) = options.apply(features_of(config, scene)?).map_err(|message| Error::Request { message })?;
    let objects = scene.objects.len();
    let deepest = depth(config)?.max(features.max_depth);
    let tries = options.convention().map_or(0, Convention::tries);
    ray_loop::check(objects, files::has_hierarchy(modules, objects), deepest, tries)
}

impl Trial<'_> {
    /// Renders with the user's modules, writes the pictures and returns the report.
    ///
    /// # Errors
    /// [`Error::Shader`] with the place in the user's file, or another error of the options, the modules, the files or
    /// the device.
    pub fn run<T: Held>(&self, places: Places) -> Result<Outcome, Error> {
        let Self { gpu, options, modules, truth } = *self;
        let Places { out, difference: beside } = places;
        let library = files::library(modules, truth.scene.objects.len())?;
        let (features, own) =
            options.apply(features_of(&truth.config, &truth.scene)?).map_err(|message| Error::Request { message })?;
        let kernel = rendered::check_modules(gpu, &library, modules, truth, T::PRECISION)?;
        let composition = library.compose(kernel, T::PRECISION)?;
        guard::check(gpu, &composition, &constants(&features, &own))?;
        // This process parses the modules only after the separate process has done so within its limits.
        check_constants(&composition, &own)?;
        let picture = Picture::<T>::new(&truth.config, &truth.scene)?;
        let Rendered { rendering, compiled, words } =
            rendered::render(gpu, &library, (&features, &own), &picture, truth)?;
        let mut report = format!("in {} on {gpu}\n", T::PRECISION);
        for UserModule { name, path, .. } in modules {
            let _ = writeln!(report, "{} stands in for [{name}]", files::shown(path));
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
        if let Some((text, _)) = &words {
            report.push_str(text);
        }
        let held = T::picture(truth);
        let apart = difference(&rendering.pixels, held);
        let _ = writeln!(report, "from the CPU in {}: {apart}", T::PRECISION);
        if size_of::<T>() < size_of::<f64>() {
            let _ = writeln!(report, "from the CPU in f64: {}", difference(&rendering.pixels, &truth.wide));
        }
        let [by_wgsl, by_cpu] = [&rendering.pixels[..], held].map(|pixels| png::bytes(pixels, truth.config.gamma));
        let _ = writeln!(report, "wrote {}", out.name());
        if let Some(place) = beside {
            let (colors, words) = differences(&rendering.pixels, held);
            let panels = [("WGSL", &by_wgsl[..]), ("CPU", &by_cpu[..]), (&words, &colors[..])];
            let _ = writeln!(report, "wrote {} (WGSL, CPU, their difference)", place.name());
            place.write_panels(&panels, size.width())?;
        }
        out.write(size, &by_wgsl)?;
        if let Some([x, y]) = options.pixel() {
            let index = y * size.width() + x;
            report.push_str(&self.follow(index, &library, (&features, &own), &picture)?);
            report.push_str(&pixel::colors(held[index].to_array(), rendering.pixels[index].to_array()));
        }
        if options.first_difference {
            let text = match apart.first {
                Some(index) => self.first_difference(index, &library, (&features, &own), &picture)?,
                None => "no pixel differs, so there is no first difference\n".to_owned(),
            };
            report.push_str(&text);
        }
        // In f32 a path may take other words than in f64, from which the recording is made.
        let is_wide = size_of::<T>() == size_of::<f64>();
        let disagrees = is_wide && words.is_some_and(|(_, disagreeing)| disagreeing > 0);
        Ok(Outcome { report, differs: apart.differing > 0 || disagrees })
    }

    /// Returns the path of the pixel at `index`, by the CPU and by WGSL, as text. The kernel is compiled in the
    /// separate process first.
    fn follow<T: Held>(
        &self,
        index: usize,
        library: &Library,
        (features, own): (&Features, &[(&str, f64)]),
        picture: &Picture<T>,
    ) -> Result<String, Error> {
        guard::check(self.gpu, &library.compose("kernels/steps", T::PRECISION)?, &constants(features, own))?;
        let follower = Follower::<T>::new(self.gpu, library, features, own)?;
        let expected = Picture { max_depth: features.max_depth, ..picture.clone() }.steps(index);
        let steps = follower.follow(picture, index, 1)?.concat();
        Ok(pixel::side_by_side(&expected, &steps))
    }

    /// Returns the function in which the pixel at `index` leaves the CPU, as text.
    fn first_difference<T: Held>(
        &self,
        index: usize,
        library: &Library,
        constants: (&Features, &[(&str, f64)]),
        picture: &Picture<T>,
    ) -> Result<String, Error> {
        let located = first_difference::of_pixel(self.gpu, library, constants, picture, index)?;
        let width = picture.size.width();
        let text = match located {
            Some((trace, found)) => first_difference::report::report(&trace, &found)?,
            // The trace changes what the driver compiles.
            None => "with a trace of all calls no bit of this pixel differs\n".to_owned(),
        };
        Ok(format!("pixel {} {}: {text}", index % width, index / width))
    }
}

/// Returns an error if `own` has a constant that no module declares.
fn check_constants(composition: &Composition, own: &[(&str, f64)]) -> Result<(), Error> {
    let shader = composition.validate()?;
    let known: Vec<_> = shader.module.overrides.iter().filter_map(|(_, constant)| constant.name.as_deref()).collect();
    match own.iter().find(|(name, _)| !known.contains(name)) {
        None => Ok(()),
        Some((name, _)) => {
            let message = format!("--set: there is no constant [{name}]; there are: {}", known.join(", "));
            Err(Error::Request { message })
        }
    }
}

fn constants<'a>(features: &Features, own: &[(&'a str, f64)]) -> Vec<(&'a str, f64)> {
    [&features.constants()[..], own].concat()
}
