//! The data that the page loads: the picture's buffers, the shader's files, and the cases and results of the formulas.
//! All numbers are f32.

use std::collections::BTreeMap;

use cpu::{Config, Scene};
use shaders::{Library, Precision};

use crate::head::{Part, head};
use crate::kernels::KERNELS;
use crate::packed::buffer;
use crate::{Error, Formulas, Gpu, Kernel, Picture, Renderer, features_of};

/// Number of random cases of each formula. They follow its edge cases.
const RANDOM: usize = 1 << 14;

/// Returns all data of a page that shows `scene`. The keys are the names that the page requests.
///
/// # Errors
/// The errors of [`Renderer::render`].
pub fn collect(gpu: &Gpu, config: &Config, scene: &Scene) -> Result<BTreeMap<String, Vec<u8>>, Error> {
    let picture = Picture::<f32>::new(config, scene)?;
    let features = features_of(config, scene)?;
    let library = Library::standard();
    let rendering = Renderer::<f32>::new(gpu, &library, &features)?.render(&picture)?;
    let (width, height, pixels) = (picture.size.width(), picture.size.height(), picture.size.pixels());
    let all = Part::Pixels { first: 0, count: pixels as u32 };
    let constants: Vec<_> = features.constants().iter().map(|(name, value)| format!("{name:?}: {value}")).collect();
    // Rust's {:?} of a text is valid JSON if the text has no control characters other than line ends and tabs.
    let facts = format!(
        "{{\"width\": {width}, \"height\": {height}, \"pixels\": {pixels}, \"gamma\": {}, \"depth\": {}, \
         \"driver\": {:?}, \"constants\": {{{}}}}}",
        config.gamma,
        features.max_depth,
        gpu.to_string(),
        constants.join(", "),
    );
    let image = library.compose("kernels/image", Precision::F32)?;
    let parts = image.parts().map(|(path, source)| format!("{{\"path\": {path:?}, \"source\": {source:?}}}"));
    let mut data = BTreeMap::from([
        ("picture".to_owned(), facts.into_bytes()),
        ("parts".to_owned(), list(parts)),
        ("kernels".to_owned(), list(KERNELS.iter().map(facts_of))),
        ("head".to_owned(), head(&picture, &all, &(0..features.max_depth))),
        ("spheres".to_owned(), buffer(&picture.spheres)),
        ("cylinders".to_owned(), buffer(&picture.cylinders)),
        ("materials".to_owned(), buffer(&picture.materials)),
        ("native".to_owned(), buffer(&rendering.pixels)),
    ]);
    for kernel in &KERNELS {
        let module = kernel.module;
        let source = library.compose(module, Precision::F32)?.source().to_owned();
        let cases = cases(kernel);
        data.insert(format!("expected/{module}"), bytemuck::cast_slice(&expected(kernel, &cases)).to_vec());
        data.insert(format!("flushed/{module}"), bytemuck::cast_slice(&flushed(kernel, &cases)).to_vec());
        data.insert(format!("cases/{module}"), bytemuck::cast_slice(&cases).to_vec());
        data.insert(format!("wgsl/{module}"), source.into_bytes());
    }
    Ok(data)
}

/// Returns the edge cases of a formula and then its random cases, row after row.
#[must_use]
pub fn cases(kernel: &Kernel) -> Vec<f32> {
    let mut cases = kernel.edge_cases::<f32>();
    cases.extend(kernel.random_cases::<f32>(RANDOM, 7));
    cases
}

/// Returns the results of the cases in Rust's f32, row after row.
#[must_use]
pub fn expected(kernel: &Kernel, cases: &[f32]) -> Vec<f32> {
    let mut results = vec![0.0; cases.len() / kernel.inputs * kernel.outputs.len()];
    for (case, result) in cases.chunks(kernel.inputs).zip(results.chunks_mut(kernel.outputs.len())) {
        f32::formula(kernel)(case, result);
    }
    results
}

/// Returns the results of the cases in f32 with subnormal numbers flushed to zero, as WGSL allows a driver to do.
#[must_use]
pub fn flushed(kernel: &Kernel, cases: &[f32]) -> Vec<f32> {
    cases.chunks(kernel.inputs).flat_map(|case| kernel.flushed(case)).collect()
}

fn facts_of(kernel: &Kernel) -> String {
    let (module, inputs, outputs) = (kernel.module, kernel.inputs, kernel.outputs.len());
    let entry = module.trim_start_matches("kernels/");
    format!("{{\"module\": {module:?}, \"entry\": {entry:?}, \"inputs\": {inputs}, \"outputs\": {outputs}}}")
}

fn list(items: impl Iterator<Item = String>) -> Vec<u8> {
    format!("[{}]", items.collect::<Vec<_>>().join(", ")).into_bytes()
}
