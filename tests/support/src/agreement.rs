//! Checks that the renderer agrees with the reference: with every layout and every instruction set of this machine, it
//! must give the reference's bytes, and the bits of its means.

use cpu::internals::layout::aos::AosImage;
use cpu::internals::{InstructionSet, Limits, Prepared, render_linear, render_with};
use cpu::reference::intersect::Exact;
use cpu::{Aos, Config, Error, Image, Renderable, Scatter, Scene, Soa, Vec3};

use generator::write;

/// All conventions for the random vectors that scatter light.
pub const SCATTERS: [Scatter; 3] = [Scatter::Statement, Scatter::Published, Scatter::Deterministic];

/// A picture that the reference has rendered.
#[derive(Clone, Debug)]
pub struct Picture {
    /// The image with the bytes of the pixels.
    pub image: AosImage,
    /// The bits of the means from which the bytes are computed, for each channel of each pixel. All NaN are stored as
    /// one bit pattern.
    pub means: Vec<[u64; 3]>,
}

/// Renders a scene with the reference, and with the renderer in both layouts and every instruction set of this machine.
/// Returns the reference's picture. Returns `None` if both refuse the scene with equal messages.
///
/// # Errors
/// A text with the first difference between the renderer and the reference, and with both files.
pub fn equals_reference(config: &Config, scene: &Scene, scatter: Scatter) -> Result<Option<Picture>, String> {
    let expected = reference(config, scene, scatter).map_err(|error| error.to_string());
    agrees::<Aos>(config, scene, scatter, &expected)
        .and_then(|()| agrees::<Soa>(config, scene, scatter, &expected))
        .map_err(|difference| format!("{scatter:?}: {difference}\n{}", files(config, scene)))?;
    Ok(expected.ok())
}

/// Returns the configuration and the scene as the text of two files, which can be rendered again.
#[must_use]
pub fn files(config: &Config, scene: &Scene) -> String {
    format!("config.txt:\n{}scene.txt:\n{}", write::config(config), write::scene(scene))
}

/// Returns a text about the differences between two pictures, or `None` if they are equal. The text has the number of
/// different pixels and the first of them, or both sizes if these differ.
#[must_use]
pub fn difference(actual: &impl Image, expected: &impl Image) -> Option<String> {
    if actual.size() != expected.size() {
        return Some(format!("the size is {:?}, not {:?}", actual.size(), expected.size()));
    }
    let pixels = expected.size().pixels();
    let differing: Vec<_> = (0..pixels).filter(|&index| actual.pixel(index) != expected.pixel(index)).collect();
    let &first = differing.first()?;
    let (actual, expected) = (actual.pixel(first), expected.pixel(first));
    Some(format!("{} of {pixels} pixels differ; pixel {first} is {actual:?}, not {expected:?}", differing.len()))
}

/// Returns the picture of the reference with exact intersections.
///
/// # Errors
/// The errors of the reference.
pub fn reference(config: &Config, scene: &Scene, scatter: Scatter) -> Result<Picture, Error> {
    let image = cpu::reference::render_with::<AosImage, Exact>(config, scene, scatter)?;
    let mut means = Vec::new();
    cpu::reference::render_linear::<Exact>(config, scene, scatter, |_, mean| means.push(bits(mean)))?;
    Ok(Picture { image, means })
}

fn agrees<L: Renderable>(
    config: &Config,
    scene: &Scene,
    scatter: Scatter,
    expected: &Result<Picture, String>,
) -> Result<(), String> {
    let prepared = Prepared::<L>::new(config, scene, scatter).map_err(|error| error.to_string());
    let (prepared, expected) = match (prepared, expected) {
        (Ok(prepared), Ok(expected)) => (prepared, expected),
        (Err(real), Err(reference)) if real == *reference => return Ok(()),
        (real, reference) => {
            return Err(format!("{:?} where the reference says {:?}", real.err(), reference.as_ref().err()));
        }
    };
    for set in InstructionSet::available() {
        let image = render_with(&prepared, set).map_err(|error| error.to_string())?;
        let mut means = vec![[0; 3]; expected.means.len()];
        let pixel = |index, mean| means[index] = bits(mean);
        render_linear(&prepared, set, &Limits::default(), pixel).map_err(|error| error.to_string())?;
        let differing = (0..means.len()).find(|&index| means[index] != expected.means[index]);
        let found = difference(&image, &expected.image)
            .or(differing.map(|index| format!("the mean of pixel {index} has other bits")));
        if let Some(difference) = found {
            return Err(format!("{}, {}: {difference}", std::any::type_name::<L>(), set.name()));
        }
    }
    Ok(())
}

/// Returns the bits of a mean. All NaN get one bit pattern.
fn bits(mean: Vec3) -> [u64; 3] {
    mean.to_array().map(|channel| if channel.is_nan() { f64::NAN.to_bits() } else { channel.to_bits() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use cpu::{Rgb, Size};

    #[test]
    fn one_byte_is_a_difference() {
        let size = Size::new(3, 2).expect("it is small");
        let black = AosImage::black(size).expect("it is small");
        let mut other = AosImage::black(size).expect("it is small");
        assert_eq!(difference(&other, &black), None);
        other.set_pixel(4, Rgb { red: 0, green: 0, blue: 1 });
        let text = difference(&other, &black).expect("a byte differs");
        assert!(text.starts_with("1 of 6 pixels differ; pixel 4 is "), "{text}");
        let small = AosImage::black(Size::new(2, 2).expect("it is small")).expect("it is small");
        assert!(difference(&small, &black).is_some());
    }

    #[test]
    fn a_renderer_of_another_scene_does_not_agree() {
        let config = Config { image_width: 4, samples_per_pixel: 2, ..Config::default() };
        let sphere = "matte: m .5 .5 .5\nsphere: 0 0 0 1 m\n";
        let [scene, other] = [sphere, "matte: m .5 .5 .6\nsphere: 0 0 0 1 m\n"]
            .map(|text| Scene::parse(text.as_bytes()).expect("the scene is valid"));
        let config = Config { camera_position: Vec3::new(0.0, 0.0, -3.0), ..config };
        assert!(equals_reference(&config, &scene, Scatter::Statement).is_ok_and(|picture| picture.is_some()));
        let expected = reference(&config, &other, Scatter::Statement).map_err(|error| error.to_string());
        assert!(agrees::<Aos>(&config, &scene, Scatter::Statement, &expected).is_err());
    }

    #[test]
    fn a_refusal_with_the_same_words_is_agreement() {
        let config = Config { camera_target: Config::default().camera_position, ..Config::default() };
        let answer = equals_reference(&config, &Scene::default(), Scatter::Statement);
        assert!(answer.is_ok_and(|picture| picture.is_none()));
    }
}
