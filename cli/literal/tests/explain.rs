//! Checks the lives of pixels: their bytes are those of the picture, and their random numbers are at the places that
//! are told, as the crate `rand_mt` draws them.

use cpu::{Config, Image, Material, Scatter, Scene, Soa, Vec3};
use literal::explain::Walk;
use rand_mt::Mt64;
use serde_json::{Value, json};

/// The first words of a generator.
struct Words(Vec<u64>, Mt64);

impl Words {
    fn new(seed: u64) -> Self {
        Self(Vec::new(), Mt64::new(seed))
    }

    /// Checks that the random numbers are those at `place` and behind, scaled to `[-half, half)`. Returns their number.
    fn check(&mut self, place: &Value, draws: &Value, half: f64) -> usize {
        let (place, draws) = (place.as_u64().expect("a number") as usize, draws.as_array().expect("a list"));
        while self.0.len() < place + draws.len() {
            self.0.push(self.1.next_u64());
        }
        for (word, draw) in self.0[place..].iter().zip(draws) {
            let number = (*word as f64 / 2.0_f64.powi(64)).min(1.0 - 2.0_f64.powi(-53));
            assert_eq!(draw.as_f64(), Some(number * (2.0 * half) - half), "at {place}");
        }
        draws.len()
    }
}

fn vector(value: &Value) -> Vec3 {
    Vec3::from([0, 1, 2].map(|at| value[at].as_f64().expect("a number")))
}

/// Checks that the event of a refractive surface says what the ray does. `u` is the unit direction of its ray.
fn check_refraction(event: &Value, index: f64, u: Vec3) {
    let normal = vector(&event["normal"]);
    let [ratio, sin] = ["ratio", "sin"].map(|name| event["refraction"][name].as_f64().expect("a number"));
    let expected = if event["front"] == true { 1.0 / index } else { index };
    assert_eq!(ratio.to_bits(), expected.to_bits());
    let mirrored = u - normal * (2.0 * u.dot(normal));
    let reflects = vector(&event["direction"]) == mirrored;
    assert_eq!((&event["refraction"]["reflects"], ratio * sin > 1.0), (&json!(reflects), reflects));
}

/// Checks the life of a pixel. Returns the number of random numbers that were compared.
fn check(life: &Value, config: &Config, scene: &Scene, scatter: Scatter, [rays, materials]: &mut [Words; 2]) -> usize {
    let (mut compared, mut samples, mut sum) = (0, 0, Vec3::ZERO);
    let (mut next, mut reflectances, mut least) = (None, Vec::new(), f64::INFINITY);
    let mut direction = Vec3::ZERO;
    let told = life["samples"].as_array().expect("a list").iter();
    for event in told.flat_map(|events| events.as_array().expect("a list")) {
        match event["event"].as_str().expect("a name") {
            "sample" => compared += rays.check(&event["place"], &event["offset"], 0.5),
            "ray" => (least, direction) = (f64::INFINITY, vector(&event["direction"])),
            "candidate" if event["fault"] == "" => least = least.min(event["lambda"].as_f64().expect("a number")),
            "candidate" => {}
            "hit" => {
                assert_eq!(event["lambda"].as_f64(), Some(least), "the least lambda that counts");
                let object = event["object"].as_u64().expect("a number") as usize - 1;
                let material = scene.materials[scene.objects[object].material as usize];
                let half = match material {
                    Material::Metal { diffusion, .. } if scatter == Scatter::Statement => diffusion,
                    _ => 1.0,
                };
                let place = event["place"].as_u64();
                assert!(next.is_none() || next == place, "the places follow one another");
                let draws = materials.check(&event["place"], &event["draws"], half);
                next = place.map(|place| place + draws as u64);
                compared += draws;
                if let Material::Refractive { index } = material {
                    check_refraction(event, index, direction.unit());
                }
                reflectances.push(material.reflectance());
                assert_eq!(vector(&event["reflectance"]), material.reflectance());
            }
            _ => {
                let color = reflectances.drain(..).rev().fold(vector(&event["end"]), Vec3::attenuate);
                assert_eq!(vector(&event["color"]), color);
                assert!(event["reason"] == "background" || vector(&event["end"]) == Vec3::ZERO);
                (sum, samples) = (sum + color, samples + 1);
            }
        }
    }
    assert_eq!(vector(&life["mean"]), sum / f64::from(samples));
    let expected = if scatter == Scatter::Deterministic { 1 } else { config.samples_per_pixel };
    assert_eq!(u64::try_from(samples), Ok(expected));
    compared
}

/// Explains pixels of a picture. Returns their number, and that of the random numbers that were compared.
fn explain(config: &Config, scene: &Scene, scatter: Scatter, pixels: usize) -> [usize; 2] {
    let image = cpu::render::<Soa>(config, scene, scatter).expect("it can be rendered");
    let walk = Walk::new(config, scene, scatter).expect("it can be rendered");
    let mut words = [Words::new(config.ray_rng_seed), Words::new(config.material_rng_seed)];
    let mut choose = Mt64::new(pixels as u64);
    let mut compared = 0;
    for _ in 0..pixels {
        let place = choose.next_u64() as usize % image.size().pixels();
        let pixel = [place % image.size().width(), place / image.size().width()];
        let life = walk.explain(pixel).expect("there is memory").expect("it is a pixel");
        let color = image.pixel(place);
        assert_eq!((&life["pixel"], &life["bytes"]), (&json!(pixel), &json!([color.red, color.green, color.blue])));
        compared += check(&life, config, scene, scatter, &mut words);
    }
    assert!(walk.explain([image.size().width(), 0]).expect("there is memory").is_none());
    [pixels, compared]
}

#[test]
fn a_thousand_pixels_of_the_bundled_scenes_have_their_bytes_and_draws_in_both_conventions() {
    let mut totals = [0; 2];
    for name in ["cylinders", "grid", "listings", "materials", "spheres", "ten-thousand"] {
        let folder = test_support::project_root().join("scenes").join(name);
        let mut config = Config::read(&folder.join("config.txt")).expect("it is valid");
        let scene = Scene::read(&folder.join("scene.txt")).expect("it is valid");
        // The pictures are smaller than those of the files, because every pixel before in a row is traced too.
        let is_large = scene.objects.len() > 1000;
        (config.image_width, config.samples_per_pixel) = if is_large { (32, 2) } else { (72, 4) };
        for scatter in [Scatter::Statement, Scatter::Published] {
            let found = explain(&config, &scene, scatter, if is_large { 10 } else { 100 });
            totals = [totals[0] + found[0], totals[1] + found[1]];
        }
    }
    assert!(totals[0] >= 1000 && totals[1] >= 10_000, "{totals:?}");
}

#[test]
fn pictures_for_which_the_renderer_draws_no_numbers_have_them_too() {
    let parse = |config: &str, scene: &str| {
        (Config::parse(config.as_bytes()).expect("it is valid"), Scene::parse(scene.as_bytes()).expect("it is valid"))
    };
    let small = "image_width: 16\nsamples_per_pixel: 3\ncamera_position: 0 0 -3\n";
    let smooth = "metal: m .9 .8 .7 0\nsphere: 0 0 0 1 m\ncylinder: 1 0 0 .5 0 1 1 m\n";
    for (config, scene) in [
        (format!("{small}max_depth: 1\n"), "matte: m .5 .5 .5\nsphere: 0 0 0 1 m\n"),
        (small.to_owned(), smooth),
        (small.to_owned(), ""),
    ] {
        let (config, scene) = parse(&config, scene);
        for scatter in [Scatter::Statement, Scatter::Published, Scatter::Deterministic] {
            let [_, compared] = explain(&config, &scene, scatter, 40);
            assert!(compared >= 80 || scatter == Scatter::Deterministic, "{compared}");
        }
    }
}

#[test]
fn a_ray_that_leaves_through_a_side_with_a_short_normal_is_told_to_be_reflected() {
    let config = "image_width: 16\nsamples_per_pixel: 2\ncamera_position: 0 0 -4\nmax_depth: 4\n";
    let config = Config::parse(config.as_bytes()).expect("it is valid");
    let scene = Scene::parse(&b"refractive: g 1.5\ncylinder: 0 0 0 .7 0 4 0 g\n"[..]).expect("it is valid");
    let walk = Walk::new(&config, &scene, Scatter::Statement).expect("it can be rendered");
    let life = walk.explain([8, 4]).expect("there is memory").expect("it is a pixel");
    let told = life["samples"].as_array().expect("a list").iter().flat_map(|events| events.as_array().expect("a list"));
    let hits: Vec<_> = told.filter(|event| event["event"] == "hit").collect();
    let leaving: Vec<_> = hits.iter().filter(|event| event["front"] == false).collect();
    assert!(!leaving.is_empty() && leaving.len() < hits.len(), "{life}");
    for event in leaving {
        // The length of the normal is the radius, so even the mirrored ray goes outwards.
        assert!(vector(&event["direction"]).dot(vector(&event["normal"])) < 0.0, "{event}");
        assert_eq!(event["refraction"]["reflects"], true, "{event}");
    }
    check(&life, &config, &scene, Scatter::Statement, &mut [19, 13].map(Words::new));
}
