//! Renders the course's cases in WGSL, and compares their means with the reference's and their files with the course's.
//!
//! By default the published pictures of the cases 1 and 2 are rendered. `RENDER_ALL=1` renders all four
//! cases in both conventions, and the published pictures in every form of the shaders, those of the cases 3 and 4 on
//! hardware only. tests/extensive does this. Pictures that are not rendered are shown as ignored. One picture at a time
//! is on the device, so that its time can be reported.
//!
//! The files are made without code of the renderer too: the power is the standard library's, and the text is written
//! here. What the shader shares with the renderer is the parser, the camera's window, the records of objects, and the
//! crate of the generator.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::iter;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use cpu::{Config, Scene};
use gpu_check::difference::difference;
use gpu_check::sampled::{Convention, Recording, SampledRendering};
use gpu_check::{Form, features_of};
use libtest_mimic::{Failed, Trial};
use shaders::Library;
use test_support::everything;
use test_support::golden::{self, Golden};

use crate::common;
use crate::sampled::Case;
use crate::sampled::{Pipelines, Tally, record};

/// Returns a trial for each of the pictures.
pub fn trials() -> Vec<Trial> {
    let folder = golden::reference_folder();
    let missing = (!folder.is_dir()).then(|| format!("needs RENDER_REFERENCE_DIR: no folder {}", folder.display()));
    let goldens = golden::reference(&folder).into_iter();
    let pictures = goldens.flat_map(|golden| {
        let is_quick = ["published/1.ppm", "published/2.ppm"].contains(&&*golden.name);
        let trial = |form: Form, is_default: bool, golden: Golden| {
            let not_all = (!is_default && !everything()).then_some("needs RENDER_ALL=1");
            let name = format!("course::{}, {form}", golden.name);
            test_support::trial(name, missing.as_deref().or(not_all), move || compare(&golden, form))
        };
        let is_in_all_forms = is_quick || (golden.name.starts_with("published/") && is_hardware());
        let other_forms = [Form::ByIntegers, Form::AsDriverLikes].into_iter().filter(move |_| is_in_all_forms);
        let others: Vec<_> = other_forms.map(|form| trial(form, false, golden.clone())).collect();
        iter::once(trial(Form::AsWritten, is_quick, golden)).chain(others)
    });
    pictures.collect()
}

/// Returns the text of the P3 file.
fn ppm(rendering: &SampledRendering<f64>, gamma: f64) -> String {
    let mut text = format!("P3\n{} {}\n255\n", rendering.size.width(), rendering.size.height());
    for mean in &rendering.pixels {
        let [red, green, blue] = mean.to_array().map(|channel| byte(channel, gamma));
        writeln!(text, "{red} {green} {blue}").expect("a text takes all lines");
    }
    text
}

/// Returns the byte of a channel. The power of the standard library is off by less than one unit in the last place. If
/// such an error could change the byte, the test fails, and the power must be computed more precisely.
fn byte(mean: f64, gamma: f64) -> u8 {
    let of_power = |power: f64| (255.0 * power) as u8;
    let power = mean.powf(1.0 / gamma);
    // The powers of 0 and 1 are exact.
    if mean != 0.0 && mean != 1.0 {
        let near = [power.next_down(), power.next_up()].map(of_power);
        assert_eq!(near, [of_power(power); 2], "the power {power} is too close to a boundary between bytes");
    }
    of_power(power)
}

/// Whether a device is chosen that is not the default, which calculates on the CPU.
fn is_hardware() -> bool {
    std::env::var("WGPU_ADAPTER_NAME").is_ok_and(|name| !"llvmpipe".contains(&name.to_lowercase()))
}

/// Returns the recording of `case`. Each is made once, because that takes longer than the device.
fn recording(case: &Case, convention: Convention) -> Arc<Recording> {
    static RECORDINGS: Mutex<BTreeMap<String, Arc<OnceLock<Arc<Recording>>>>> = Mutex::new(BTreeMap::new());
    let place = RECORDINGS.lock().expect("no thread panics with it").entry(case.name.clone()).or_default().clone();
    place.get_or_init(|| Arc::new(record(case, convention))).clone()
}

/// Renders a picture of the course's cases.
fn compare(golden: &Golden, form: Form) -> Result<(), Failed> {
    static DEVICE: Mutex<()> = Mutex::new(());
    let gpu = common::gpu().with_form(form);
    let convention = Convention::ALL.into_iter().find(|convention| convention.scatter() == golden.scatter);
    let convention = convention.ok_or("the picture has another convention")?;
    let (config, scene) = (Config::read(&golden.config)?, Scene::read(&golden.scene)?);
    let case = Case { name: golden.name.clone(), config, scene };
    let features = features_of(&case.config, &case.scene)?;
    let recording = recording(&case, convention);
    let library = Library::standard();
    let rendering = {
        let _alone = DEVICE.lock().unwrap_or_else(PoisonError::into_inner);
        Pipelines::<f64>::new(&gpu, &library).render(&case, &features, &recording)
    };
    let mut tally = Tally::default();
    tally.add(&golden.name, &rendering, &recording);
    let Tally { pixels, samples, words, faults, .. } = tally;
    println!("{}, {form}: {pixels} pixels, {samples} samples, {words} words of scatter vectors", golden.name);
    let [recorded, device] = [recording.time, rendering.time].map(|time| time.as_millis());
    println!("{}, {form}: the recording took {recorded} ms, the device {device} ms", golden.name);
    if form == Form::AsDriverLikes {
        // The driver may change the last bits. A path that goes elsewhere would give more.
        println!("{}, {form}: {faults:?}", golden.name);
        assert!(difference(&rendering.pixels, &recording.means).rmse < 1e-9, "{faults:?}");
        return Ok(());
    }
    assert_eq!(faults, Vec::<String>::new());
    let file = ppm(&rendering, case.config.gamma);
    assert_eq!(golden.digest()?, format::digest::sha256(file.as_bytes()), "{}", golden.name);
    Ok(())
}
