//! Runs the suite's checks with fewer cases, one after the other, until one of them notices an error.

use cpu::{Ray, Vec3};
use gpu_check::closest_hits::closest_hits;
use gpu_check::difference::{Difference, difference};
use gpu_check::first_difference::{self, Located};
use gpu_check::sampled::{Convention, Recording, SampleRenderer, SampledRendering};
use gpu_check::{Error, Float, Gpu, Picture, features_of};
use shaders::{Features, Library, Precision};
use stability::random::Random;

use super::crafted::{self, Crafted};
use super::mutant::Mutant;
use crate::common::{self, Accuracy};
use crate::hierarchy::random;
use crate::kernels::kernel::{Kernel, Tally};
use crate::pictures::{by_reference, prepared};
use crate::sampled::record;
use crate::scenes::{self, Case};
use crate::{exact, kernels};

/// Number of random cases of each kernel.
const RANDOM_CASES: usize = 1 << 14;
/// Number of cases of each kind for an exact kernel.
const EXACT_CASES: usize = 1 << 12;
/// Number of random scenes.
const RANDOM_SCENES: u64 = 6;
/// Limit on the number of pixels times objects of one picture; see [`Case::within`].
const TESTS: usize = 500_000;
/// Number of random scenes whose pictures have random numbers.
const SAMPLED_SCENES: u64 = 4;
/// Maximum depth of these pictures. It is one number, so that one pipeline renders all of them.
const SAMPLED_DEPTH: u32 = 9;
/// Limit on the number of samples times objects of these pictures.
const SAMPLED_TESTS: usize = 200_000;

/// Number of random scenes for rays, and of rays in each of them.
const RAY_SCENES: usize = 4;
const RAYS: usize = 1 << 14;

/// The module that only some libraries compose.
const HIERARCHY: &str = "hierarchy";

/// The cases and pictures of the checks, prepared once for all mutants.
#[derive(Debug)]
pub struct Examiner<'a> {
    gpu: &'a Gpu,
    kernels: Vec<(Kernel<f64>, Vec<f64>)>,
    pictures: Vec<(Case, Vec<Vec3>)>,
    sampled: Vec<(Case, Recording)>,
    crafted: Vec<Crafted>,
    rays: Vec<Rays>,
}

/// Rays in f32, where the boxes of a hierarchy have the largest margins, with their hits in Rust. If the f32 of the
/// device is not that of IEEE 754, they are its own hits, by the loop over all objects.
type Rays = (Picture<f32>, Vec<Ray<f32>>, Vec<[f32; 3]>);

impl<'a> Examiner<'a> {
    /// Prepares the cases of all kernels, and the reference's pictures of all scenes.
    ///
    /// # Errors
    /// [`Error::Scene`] if a scene cannot be rendered.
    pub fn new(gpu: &'a Gpu) -> Result<Self, Error> {
        let plain = kernels::all().map(|kernel| (kernel, kernel.rows(RANDOM_CASES, 44)));
        let exact = exact::all().map(|kernel| (kernel, kernel.rows(EXACT_CASES, 44)));
        let kernels = plain.into_iter().chain(exact).collect();
        let scenes = scenes::edges().into_iter().chain((0..RANDOM_SCENES).map(scenes::random));
        let scenes = scenes.chain([scenes::long_paths()]).map(|case| case.within(TESTS));
        let pictures = scenes.map(|case| (by_reference(&case), case));
        let pictures = pictures.map(|(means, case)| (case, means)).collect();
        let sampled = (0..SAMPLED_SCENES).flat_map(|seed| {
            let mut case = scenes::random(seed);
            (case.config.samples_per_pixel, case.config.max_depth) = (7, SAMPLED_DEPTH.into());
            let case = case.within(SAMPLED_TESTS / 7);
            Convention::ALL.map(|convention| (case.clone(), record(&case, convention)))
        });
        let long = (scenes::long_paths(), record(&scenes::long_paths(), Convention::Statement));
        let sampled = sampled.chain([long]).collect();
        let mut draws = Random::new(45);
        let accuracy = common::accuracy(gpu);
        let rays = (0..RAY_SCENES).map(|number| {
            let (picture, rays) = random::rays(&mut draws, number, RAYS);
            let hits = match accuracy {
                Accuracy::Ieee => rays.iter().map(|ray| hit(&picture, ray)).collect(),
                Accuracy::Wgsl => closest_hits(gpu, &Library::standard(), &picture, &rays)?,
            };
            Ok::<_, Error>((picture, rays, hits))
        });
        let rays = rays.collect::<Result<_, _>>()?;
        Ok(Self { gpu, kernels, pictures, sampled, crafted: crafted::all()?, rays })
    }

    /// Returns a description of the first check that notices `mutant`, or `None` if no check does.
    ///
    /// # Errors
    /// An error of the device or of the mutant's WGSL, so that no check could run.
    pub fn notice(&self, mutant: &Mutant) -> Result<Option<String>, Error> {
        match self.examine(&mutant.library()?, Some(&mutant.module)) {
            // A ray that gives up leaves its pixel unwritten.
            Err(error @ Error::Unwritten { .. }) => Ok(Some(error.to_string())),
            examined => examined,
        }
    }

    /// Returns a description of the first check that notices an error in `library`, or `None` if no check does. With a
    /// `module`, only checks whose kernel needs it are run.
    ///
    /// # Errors
    /// An error of the device or of the library's WGSL.
    pub fn examine(&self, library: &Library, module: Option<&str>) -> Result<Option<String>, Error> {
        let runs = |kernel: &str| module.map_or(Ok(true), |module| runs(kernel, module));
        for (kernel, cases) in &self.kernels {
            if runs(kernel.module)? {
                let tally = kernel.check(self.gpu, &kernel.compile(self.gpu, library)?, cases)?;
                if tally.differing > 0 {
                    let Tally { name, differing, cases, .. } = tally;
                    return Ok(Some(format!("{name}, {differing} of {cases} cases")));
                }
            }
        }
        let library = if module == Some(HIERARCHY) { &library.clone().in_hierarchy() } else { library };
        if runs("kernels/rays")?
            && let Some(noticed) = self.examine_rays(library)?
        {
            return Ok(Some(noticed));
        }
        if runs("kernels/image")?
            && let Some((case, found)) = self.differing_picture(library)?
        {
            return Ok(Some(format!("picture of {}, {} of {} pixels", case.name, found.differing, found.pixels)));
        }
        if runs("kernels/samples")? || runs("kernels/means")? {
            return self.examine_samples(library);
        }
        Ok(None)
    }

    /// Returns the first difference that `library` has in a pixel of a picture in deterministic mode, or `None` if
    /// there is none, or if only the scene with long paths shows one: the search traces a pixel in one run.
    ///
    /// # Errors
    /// An error of the device or of the library's WGSL.
    pub fn first_difference(&self, library: &Library, module: &str) -> Result<Option<Located<f64>>, Error> {
        if runs("kernels/image", module)?
            && let Some((case, Difference { first: Some(index), .. })) = self.differing_picture(library)?
            && case.scene.objects.len() < scenes::LONG_PATHS
        {
            let features = features_of(&case.config, &case.scene)?;
            let picture = Picture::new(&case.config, &case.scene)?;
            return first_difference::of_pixel(self.gpu, library, (&features, &[]), &picture, index);
        }
        Ok(None)
    }

    /// Examines the closest hits of random rays.
    fn examine_rays(&self, library: &Library) -> Result<Option<String>, Error> {
        for (picture, rays, expected) in &self.rays {
            let hits = closest_hits(self.gpu, library, picture, rays)?;
            let is_same =
                |(one, other): &(&[f32; 3], &[f32; 3])| one.iter().zip(*other).all(|(one, other)| one.same(*other));
            let differing = hits.iter().zip(expected).filter(|pair| !is_same(pair)).count();
            if differing > 0 {
                return Ok(Some(format!("closest hits, {differing} of {} rays", rays.len())));
            }
        }
        Ok(None)
    }

    /// Returns the first case whose picture in deterministic mode differs from the reference's.
    fn differing_picture(&self, library: &Library) -> Result<Option<(&Case, Difference)>, Error> {
        for (case, expected) in &self.pictures {
            let (renderer, picture) = prepared::<f64>(self.gpu, library, case)?;
            let found = difference(&renderer.render(&picture)?.pixels, expected);
            if found.differing > 0 {
                return Ok(Some((case, found)));
            }
        }
        Ok(None)
    }

    /// Examines pictures with random numbers. They are rendered in several runs, which begin and end within a pixel.
    fn examine_samples(&self, library: &Library) -> Result<Option<String>, Error> {
        let renderer = |depth: u32| SampleRenderer::<f64>::new(self.gpu, library, &Features::all(depth), &[]);
        let noticed = |name: &str, rendering: &SampledRendering<f64>, recording: &Recording| {
            let (found, disagreeing) = (difference(&rendering.pixels, &recording.means), rendering.disagreeing);
            let Difference { differing, pixels, .. } = found;
            let text = format!("samples of {name}, {differing} of {pixels} pixels, words of {disagreeing} paths");
            (differing > 0 || disagreeing > 0).then_some(text)
        };
        let long = renderer(SAMPLED_DEPTH)?;
        for (case, recording) in &self.sampled {
            let rendering = long.render(&Picture::new(&case.config, &case.scene)?, recording)?;
            if let Some(text) = noticed(&case.name, &rendering, recording) {
                return Ok(Some(text));
            }
        }
        let short = renderer(crafted::MAX_DEPTH)?;
        for Crafted { name, picture, recording, streams } in &self.crafted {
            let rendering = short.render_from(picture, recording, streams.clone(), |_, _| ())?;
            if let Some(text) = noticed(name, &rendering, recording) {
                return Ok(Some(text));
            }
        }
        Ok(None)
    }
}

/// Returns lambda, order and part of the ray's closest hit in Rust.
fn hit(picture: &Picture<f32>, ray: &Ray<f32>) -> [f32; 3] {
    picture.closest_hit(ray).map_or([-1.0; 3], |found| [found.lambda, found.order as f32, found.part as f32])
}

/// Whether the kernel `kernel` needs the module `module`.
fn runs(kernel: &str, module: &str) -> Result<bool, Error> {
    const MARK: &str = "// This module is part of it.";
    let mut marked = Library::standard();
    let source = format!("{MARK}\n{}", marked.source(module)?);
    marked.replace(module, module, source)?;
    let marked = if module == HIERARCHY { marked.in_hierarchy() } else { marked };
    Ok(marked.compose(kernel, Precision::F64)?.source().contains(MARK))
}
