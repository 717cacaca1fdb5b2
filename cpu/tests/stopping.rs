//! A picture that is asked to stop ends soon, at any depth and any number of samples.

use std::ops::ControlFlow;
use std::sync::atomic::Ordering;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::{Duration, Instant};

use cpu::internals::{Ended, InstructionSet, Limits, Prepared, render_from};
use cpu::{Aos, Config, Image, Layout, Scatter, Scene};

/// Time after which a picture counts as one that does not stop, long enough for a busy machine.
const PATIENCE: Duration = Duration::from_secs(120);

/// Returns the time that the renderer may take to stop: `RENDER_STOP_MS` milliseconds. The promise is 100 ms. Without
/// the variable there is no limit but [`PATIENCE`], because the machine may be busy.
fn soon() -> Duration {
    let milliseconds = std::env::var("RENDER_STOP_MS").map(|text| text.parse().expect("RENDER_STOP_MS is a number"));
    milliseconds.map_or(PATIENCE, Duration::from_millis)
}

/// Starts a picture that would take longer than anyone waits, checks that it is being rendered, and stops it.
fn stops(config: &str, scene: &str) {
    let config = format!("image_width: 1\naspect_ratio: 1 1\n{config}");
    let config = Config::parse(config.as_bytes()).expect("it is valid");
    let scene = Scene::parse(scene.as_bytes()).expect("it is valid");
    let prepared = Prepared::<Aos>::new(&config, &scene, Scatter::Statement).expect("there is enough memory");
    for set in InstructionSet::available() {
        let limits = Limits { surfaces: 1 << 20, ..Limits::prompt(scene.objects.len()) };
        std::thread::scope(|scope| {
            let (sender, receiver) = mpsc::channel();
            let (prepared, limits) = (&prepared, &limits);
            scope.spawn(move || {
                let mut image = <Aos as Layout>::Image::black(prepared.size).expect("it is small");
                let ended =
                    render_from(prepared, set, limits, (0, &[]), &mut image, |_, _, _| ControlFlow::Continue(()));
                let _ = sender.send(ended.expect("there is enough memory"));
            });
            let early = receiver.recv_timeout(Duration::from_millis(50));
            assert_eq!(early, Err(RecvTimeoutError::Timeout), "it is being rendered");
            assert!(!limits.is_stopped());
            limits.stop.store(true, Ordering::Relaxed);
            assert!(limits.is_stopped());
            let start = Instant::now();
            let Ok(ended) = receiver.recv_timeout(PATIENCE) else {
                // The picture would go on, so the process must end.
                eprintln!("{set:?} does not stop");
                std::process::abort();
            };
            assert_eq!(ended, Some(Ended::Stopped), "{set:?}");
            assert!(start.elapsed() < soon(), "{set:?} took {:?}", start.elapsed());
        });
    }
}

/// Objects far away, which choose another structure for finding the nearest object.
fn far(count: usize) -> String {
    (0..count).map(|number| format!("sphere: {} 900 0 1 m\n", 3 * number)).collect()
}

const DEEP: &str = "samples_per_pixel: 1\nmax_depth: 1000000000000000000\n";

#[test]
fn a_pixel_with_most_samples_stops() {
    let samples = "samples_per_pixel: 9000000000000000000\n";
    stops(samples, "");
    for count in [0, 5, 20, 200] {
        stops(samples, &format!("matte: m .5 .5 .5\nsphere: 0 0 0 1 m\n{}", far(count)));
    }
}

/// Inside of a glass sphere, close to its surface, a ray is reflected for ever.
const GLASS: &str = "refractive: g 1.5\nmatte: m 1 1 1\nsphere: 0 0 0 10 g\n";

#[test]
fn a_sample_that_stays_in_glass_stops() {
    let config =
        format!("{DEEP}camera_position: 9.9 0 0\ncamera_target: 9.9 1 0\ncamera_north: 0 0 1\nfield_of_view: 1\n");
    for count in [0, 5, 20, 200] {
        stops(&config, &format!("{GLASS}{}", far(count)));
    }
}

#[test]
fn a_sample_in_glass_of_many_objects_stops_though_each_ray_is_tested_against_all() {
    let camera = "camera_position: 9.9 0 0\ncamera_target: 9.9 1 0\ncamera_north: 0 0 1\n";
    // The magnitude of the last object leaves no faster structure.
    let scene = format!("{GLASS}{}sphere: 1e150 0 0 1e149 g\n", "sphere: 0 0 0 10 g\n".repeat(20_000));
    stops(&format!("samples_per_pixel: 9000000000000000000\nmax_depth: 1000\n{camera}"), &scene);
}

#[test]
fn prompt_limits_change_no_byte() {
    let materials = "matte: m .5 .6 .7\nmetal: s .9 .8 .7 .2\nrefractive: g 1.5\n";
    let config = "image_width: 24\naspect_ratio: 2 1\nsamples_per_pixel: 70\nmax_depth: 9\n";
    for count in [1, 5, 30] {
        let object = |number: usize| {
            let (x, material) = (1.5 * number as f64 - count as f64, ["m", "s", "g"][number % 3]);
            format!("sphere: {x} 0 {} 1 {material}\n", number % 4)
        };
        let scene = materials.to_owned() + &(0..count).map(object).collect::<String>();
        let config = Config::parse(config.as_bytes()).expect("it is valid");
        let scene = Scene::parse(scene.as_bytes()).expect("it is valid");
        let prepared = Prepared::<Aos>::new(&config, &scene, Scatter::Statement).expect("memory is enough");
        let [usual, prompt] = [Limits::default(), Limits::prompt(usize::MAX)].map(|limits| {
            let mut image = <Aos as Layout>::Image::black(prepared.size).expect("it is small");
            let set = InstructionSet::chosen();
            let ended = render_from(&prepared, set, &limits, (0, &[]), &mut image, |_, _, _| ControlFlow::Continue(()));
            assert_eq!(ended.expect("memory is enough"), None);
            let mut ppm = Vec::new();
            cpu::write_ppm(&image, &mut ppm).expect("memory is enough");
            ppm
        });
        assert!(usual == prompt && usual.len() > 24 * 12 * 6, "{count} objects");
    }
}

#[test]
fn a_path_along_a_glass_fibre_stops() {
    // The ray is reflected by the mirror at one end of the fibre, and then a million times by the glass.
    let camera = "camera_position: 0 0 0\ncamera_target: 0 .3 -1\ncamera_north: 0 1 0\nfield_of_view: .001\n";
    let fibre = "refractive: g 1.5\nmetal: m 1 1 1 0\ncylinder: 0 0 4999990 1 0 0 10000000 g\n";
    for count in [0, 5, 20, 200] {
        stops(&format!("{DEEP}{camera}"), &format!("{fibre}cylinder: 0 0 -5.5 .99 0 0 1 m\n{}", far(count)));
    }
}

#[test]
fn a_path_between_mirrors_ends_at_the_limit_of_its_surfaces() {
    for (surfaces, depth, expected) in [
        (20_000, 20_002, None),
        (20_000, 20_003, Some(Ended::TooManySurfaces)),
        (20_000, 1_u64 << 60, Some(Ended::TooManySurfaces)),
        (usize::MAX, 40_000, None),
    ] {
        for count in [0, 5, 20, 200] {
            let config = format!("image_width: 1\naspect_ratio: 1 1\nsamples_per_pixel: 1\nmax_depth: {depth}\n");
            let scene = format!("metal: m 1 1 1 0\nsphere: 0 0 -10 100 m\n{}", far(count).replace(" 900 ", " 90000 "));
            let config = Config::parse(config.as_bytes()).expect("it is valid");
            let scene = Scene::parse(scene.as_bytes()).expect("it is valid");
            let prepared = Prepared::<Aos>::new(&config, &scene, Scatter::Statement).expect("memory is enough");
            let limits = Limits { surfaces, ..Limits::default() };
            let mut image = <Aos as Layout>::Image::black(prepared.size).expect("it is small");
            let set = InstructionSet::chosen();
            let ended = render_from(&prepared, set, &limits, (0, &[]), &mut image, |_, _, _| ControlFlow::Continue(()));
            assert_eq!(ended.expect("memory is enough"), expected, "{surfaces} {depth} {count}");
        }
    }
}
