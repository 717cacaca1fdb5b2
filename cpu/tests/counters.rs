//! Tests that the renderer does no work that a scene does not need. Each test counts some work, for a scene that needs
//! it and for one that does not.
//!
//! Each thread has counters of its own, and each test runs in a thread of its own.

#![cfg(any(feature = "counters", debug_assertions))]

use std::path::Path;

use cpu::internals::counters::{Counter, reset, snapshot};
use cpu::internals::simd::{Kernel, Simd, SimdF64};
use cpu::internals::{InstructionSet, Prepared};
use cpu::{Aos, Config, Scatter, Scene};

/// The configuration of a small picture: 32 by 18 pixels, 16 samples each, seen from z = -10.
const SMALL: &str = "image_width: 32\nsamples_per_pixel: 16\nfield_of_view: 45\n";
const PIXELS: u64 = 32 * 18;
const SAMPLES: u64 = 16 * PIXELS;

/// Renders a small picture, and returns a function that gives the value of each counter afterwards.
fn count(config: &str, scene: &str) -> impl Fn(Counter) -> u64 + use<> {
    let config = Config::parse(format!("{SMALL}{config}").as_bytes()).expect("the configuration is valid");
    counted(&config, scene)
}

fn counted(config: &Config, scene: &str) -> impl Fn(Counter) -> u64 + use<> {
    let scene = Scene::parse(scene.as_bytes()).expect("the scene is valid");
    let prepared: Prepared<Aos> = Prepared::new(config, &scene, Scatter::Statement).expect("it can be rendered");
    reset();
    cpu::internals::render_with(&prepared, InstructionSet::chosen()).expect("it is small");
    let counts = snapshot();
    move |counter| counts[counter as usize]
}

/// Returns the scene's lines for `count` spheres side by side, all in view.
fn row_of_spheres(count: usize, material: &str) -> String {
    (0..count).map(|at| format!("sphere: {} 0 0 .3 {material}\n", 6.0 * (at as f64 / count as f64 - 0.5))).collect()
}

const MATTE: &str = "matte: m .5 .5 .5\n";
const MIRROR: &str = "metal: m 1 1 1 0\n";
const GLASS: &str = "refractive: g 1.5\n";

#[test]
fn kinds_of_objects_that_are_not_there_are_not_tested() {
    // There are two objects of a kind, so that rays go from one to the other.
    let (spheres, cylinders) =
        ("sphere: -2 0 0 2 m\nsphere: 2 0 0 1.9 m\n", "cylinder: -2 0 0 2 0 3 0 m\ncylinder: 2 0 0 1.9 0 3 0 m\n");
    let both = count("", &format!("{MATTE}{spheres}{cylinders}"));
    assert!(both(Counter::SphereTests) > 100 && both(Counter::CylinderTests) > 100);
    let no_cylinders = count("", &format!("{MATTE}{spheres}"));
    assert!(no_cylinders(Counter::SphereTests) > 100);
    assert_eq!(no_cylinders(Counter::CylinderTests), 0);
    let no_spheres = count("", &format!("{MATTE}{cylinders}"));
    assert!(no_spheres(Counter::CylinderTests) > 100);
    assert_eq!(no_spheres(Counter::SphereTests), 0);
}

#[test]
fn specular_chains_are_traced_only_where_a_surface_refracts() {
    let glass = count("", &format!("{GLASS}sphere: 0 0 0 3 g\n"));
    assert!(glass(Counter::SpecularRays) > 100);
    let matte = count("", &format!("{MATTE}sphere: 0 0 0 3 m\n"));
    assert!(matte(Counter::Hits) > 100);
    assert_eq!(matte(Counter::SpecularRays), 0);
}

#[test]
fn random_vectors_are_drawn_only_where_a_surface_scatters_around_a_direction() {
    let sphere = "sphere: -2 0 0 2 m\nsphere: 2 0 0 2 m\n";
    for mirror in ["metal: m 1 1 1 0\n", "refractive: m 1.5\n"] {
        let smooth = count("", &format!("{mirror}{sphere}"));
        assert!(smooth(Counter::Hits) > 100);
        assert_eq!(smooth(Counter::MaterialDraws), 0, "{mirror}");
    }
    for rough in [MATTE, "metal: m 1 1 1 .01\n"] {
        let spread = count("", &format!("{rough}{sphere}"));
        assert!(spread(Counter::ScatterSamples) > 100);
        assert!(spread(Counter::MaterialDraws) >= 3 * spread(Counter::ScatterSamples), "{rough}");
    }
}

#[test]
fn with_a_depth_of_one_no_ray_leaves_a_surface_and_no_vector_is_drawn() {
    for material in [MATTE, "refractive: m 1.5\n"] {
        let scene = format!("{material}sphere: -2 0 0 2 m\nsphere: 2 0 0 2 m\n");
        let one = count("max_depth: 1\n", &scene);
        assert!(one(Counter::Hits) > 100);
        let rays = |counted: &dyn Fn(Counter) -> u64| counted(Counter::PathRays) + counted(Counter::SpecularRays);
        assert_eq!((rays(&one), one(Counter::MaterialDraws)), (0, 0), "{material}");
        assert!(rays(&count("max_depth: 2\n", &scene)) > 100, "{material}");
    }
}

#[test]
fn the_last_surface_of_a_path_takes_its_vector_and_sends_no_ray() {
    // Inside a mirror every ray hits a surface, so every path reaches the maximum depth.
    let closed = count("max_depth: 3\n", &format!("{MIRROR}sphere: 0 0 0 100 m\n"));
    assert_eq!(closed(Counter::MaxDepthReached), SAMPLES);
    assert_eq!(closed(Counter::ScatterSamples), 3 * SAMPLES);
    assert_eq!(closed(Counter::PathRays), 2 * SAMPLES);
    let open = count("max_depth: 3\n", &format!("{MIRROR}sphere: 0 0 0 3 m\n"));
    assert!(open(Counter::ScatterSamples) > 100);
    assert_eq!(open(Counter::MaxDepthReached), 0, "rays leave a ball at once");
    assert_eq!(open(Counter::PathRays), open(Counter::ScatterSamples), "each vector has its ray");
}

#[test]
fn unused_materials_cost_nothing() {
    let scene = format!("{MATTE}metal: wild 1 1 1 1e300\n{}", row_of_spheres(20, "m"));
    let unused = count("", &scene);
    assert!(unused(Counter::PathRays) > 20);
    assert_eq!(unused(Counter::UnfilteredTests), 0, "the filter is trusted");
    let used = count("", &format!("{scene}sphere: 0 -9 0 1 wild\n"));
    assert_eq!(used(Counter::UnfilteredTests), 21 * used(Counter::PathRays), "it is not, with so large a diffusion");
}

#[test]
fn pixels_that_no_object_reaches_are_known_without_rays() {
    // The pixels are so small that the gradient hardly changes within one.
    let colors = "background_dark_color: .2 .4 .8\nbackground_light_color: .9 .8 .7\n";
    let view = &format!("image_width: 480\nsamples_per_pixel: 2\n{colors}");
    let pixels = 480 * 270;
    let corner = count(view, &format!("{MATTE}sphere: 3 1 0 .5 m\n"));
    let known = corner(Counter::BackgroundPixels);
    assert!(known > pixels / 2, "{known} of {pixels}");
    assert!(corner(Counter::CameraRays) <= 2 * (pixels - known));
    assert!(corner(Counter::RayDrawsSkipped) > 2 * known, "most without drawing their jitter");
    assert_eq!(corner(Counter::RayDrawsSkipped) + corner(Counter::RayDraws), 4 * pixels);
    // The blue of the default background is 1 at both ends.
    let default = count("image_width: 480\nsamples_per_pixel: 2\n", &format!("{MATTE}sphere: 3 1 0 .5 m\n"));
    assert!(default(Counter::BackgroundPixels) > pixels / 2, "{} of {pixels}", default(Counter::BackgroundPixels));
    let full = count(view, &format!("{MATTE}sphere: 0 0 0 100 m\n"));
    assert_eq!((full(Counter::BackgroundPixels), full(Counter::CameraRays)), (0, 2 * pixels));
    assert_eq!((full(Counter::RayDrawsSkipped), full(Counter::RayDraws)), (0, 4 * pixels));
}

#[test]
fn with_equal_background_colours_no_jitter_is_drawn() {
    // The pixels are so large that a gradient's bytes differ within each.
    let view = "image_width: 8\nfield_of_view: 90\n";
    let equal = "background_dark_color: .3 .5 .7\nbackground_light_color: .3 .5 .7\n";
    let one_color = count(&format!("{view}{equal}"), "");
    assert_eq!(one_color(Counter::BackgroundPixels), 8 * 4);
    assert_eq!((one_color(Counter::RayDraws), one_color(Counter::CameraRays)), (0, 0));
    let gradient = count(view, "");
    assert!(gradient(Counter::RayDraws) > 0 && gradient(Counter::CameraRays) > 0);
    assert!(gradient(Counter::BackgroundPixels) < 8 * 4);
}

#[test]
fn primary_rays_are_tested_against_objects_near_their_span_alone() {
    let near = count("", &format!("{MATTE}{}", row_of_spheres(100, "m")));
    let (left, all) = (near(Counter::SpanCandidates), near(Counter::SpanObjects));
    assert!(near(Counter::CameraRays) > 100);
    // A row of spheres fills one or two of 18 rows.
    assert!(left > 0 && left < all / 5, "{left} of {all}");
    assert!(near(Counter::CameraRayTests) < 100 * SAMPLES / 5);
    // Concentric spheres reach wherever the largest does.
    let concentric: String = (0..100).map(|at| format!("sphere: 0 0 0 {} m\n", 50 + at)).collect();
    let everywhere = count("", &format!("{MATTE}{concentric}"));
    assert_eq!(everywhere(Counter::SpanCandidates), everywhere(Counter::SpanObjects));
    assert_eq!(everywhere(Counter::CameraRayTests), 100 * SAMPLES);
}

#[test]
fn rays_are_tested_against_a_small_part_of_many_objects() {
    // The scenes of spheres get a small scene, a flat filter and a BVH. Only a BVH has nodes to visit. Of its collapsed
    // root, all boxes together would lead to more than 20 visits a ray.
    for (objects, has_tree) in [(8, false), (60, false), (1000, true)] {
        let text = format!("{MATTE}{}", row_of_spheres(objects, "m"));
        let skipped = count("", &text);
        let (rays, tests) = (skipped(Counter::PathRays), skipped(Counter::SphereTests));
        assert!(rays > 20 && tests < rays * objects as u64 / 4, "{tests} tests by {rays} rays of {objects} objects");
        let visits = skipped(Counter::NodeVisits);
        assert!(visits < 20 * rays && (visits > 0) == has_tree, "{visits} visits of nodes by {rays} rays");
        assert_eq!(skipped(Counter::UnfilteredTests), 0);
        // All objects are cylinders, or every other one, for which 60 objects get a flat filter too.
        let spheres = row_of_spheres(objects, "m");
        for step in [1, 2] {
            let line = |(at, line): (usize, &str)| match at % step {
                0 => line.replace("sphere", "cylinder").replace(" .3 m", " .3 0 .6 0 m\n"),
                _ => format!("{line}\n"),
            };
            let tubes: String = spheres.lines().enumerate().map(line).collect();
            let tubes = count("", &format!("{MATTE}{tubes}"));
            let (rays, tests) = (tubes(Counter::PathRays), tubes(Counter::CylinderTests));
            assert!(
                rays > 20 && tests < rays * objects as u64 / 4,
                "{tests} tests by {rays} rays of {objects} objects"
            );
        }
        // The added grain of dust is too small for conservative tests, so it is apart, and every ray tests it.
        let dusty = count("", &format!("{text}sphere: 0 9 0 1e-9 m\n"));
        let (rays, tests) = (dusty(Counter::PathRays), dusty(Counter::SphereTests));
        assert!(tests < rays * (objects as u64 / 4 + 1), "{tests} tests by {rays} rays of {objects} objects and dust");
        assert_eq!(dusty(Counter::UnfilteredTests), rays);
    }
}

/// Returns how many paths the lookahead tests at once with the instruction set of these tests.
fn paths_at_once() -> u64 {
    struct Promptly;
    impl Kernel for Promptly {
        type Output = usize;
        #[inline(always)]
        fn call<S: Simd>(self, simd: S) -> usize {
            simd.run_promptly(Lanes)
        }
    }
    struct Lanes;
    impl Kernel for Lanes {
        type Output = usize;
        #[inline(always)]
        fn call<S: Simd>(self, _: S) -> usize {
            S::F64::LANES
        }
    }
    InstructionSet::chosen().run(Promptly) as u64
}

#[test]
fn paths_that_escape_at_once_are_looked_ahead_together() {
    // Outside of a mirroring ball every reflected ray escapes, so no guess is wrong and each first ray is tested once.
    let lone = count("max_depth: 4\n", &format!("{MIRROR}sphere: 0 0 0 3 m\n"));
    assert!(lone(Counter::PathRays) > 100);
    assert_eq!(lone(Counter::LookaheadRays), lone(Counter::PathRays));
    // Inside of it every ray hits again, so all guesses are wrong: a path fills all lanes when it begins, and the next
    // path does so again. After the first four hits of a row, a path tests no other paths between its hits. The
    // remainder is that of these hits and of the last lanes of each row.
    let closed = count("max_depth: 4\n", &format!("{MIRROR}sphere: 0 0 0 100 m\n"));
    let (tested, expected) = (closed(Counter::LookaheadRays), paths_at_once() * SAMPLES);
    assert!(tested.abs_diff(expected) < SAMPLES / 20, "{tested} first rays, not some {expected}");
}

#[test]
fn the_last_ray_of_a_path_is_not_tested_where_it_starts_inside_an_object() {
    // Inside a sphere most paths end on it. With a refractive object, which takes no random vector, no ray is skipped.
    let room = "matte: w .5 .5 .5\nsphere: 0 0 0 100 w\n";
    let rays = |scene: &str| {
        let counted = count("max_depth: 3\n", scene);
        [Counter::PathRays, Counter::Hits, Counter::SphereTests, Counter::LastRaysSkipped].map(counted)
    };
    let [path_rays, hits, tests, skipped] = rays(room);
    // A ray that is not tested ahead may be tested although it escapes.
    let (least, most) = (hits - SAMPLES, hits - SAMPLES + SAMPLES / 20);
    assert!(skipped > SAMPLES / 2 && (least..most).contains(&(tests + skipped)), "{tests} and {skipped} of {hits}");
    let [glassy_rays, glassy_hits, _, glassy_skipped] = rays(&format!("{room}{GLASS}sphere: 0 200 0 1 g\n"));
    assert_eq!([glassy_rays, glassy_hits, glassy_skipped], [path_rays, hits, 0]);
}

#[test]
fn means_become_bytes_without_a_power() {
    let scene = format!("{MATTE}sphere: 0 0 0 100 m\nsphere: 0 0 0 3 m\n");
    for gamma in ["gamma: 1\n", "gamma: 2.2\n"] {
        assert_eq!(count(gamma, &scene)(Counter::Powers), 0, "no mean is at a boundary");
    }
    // With so large a gamma every boundary underflows, so nearly every mean takes the power function.
    let bright = format!("{MATTE}sphere: 0 -300 0 290 m\n");
    assert!(count("gamma: 1e300\n", &bright)(Counter::Powers) > PIXELS);
}

#[test]
fn rays_of_a_far_marble_are_uncertain_and_seldom_need_dyadic_arithmetic() {
    let ordinary = count("", &format!("{MATTE}sphere: -2 0 0 2 m\nsphere: 2 0 0 2 m\n"));
    assert!(ordinary(Counter::Hits) > 100);
    assert!(ordinary(Counter::Fallbacks) * 50 < ordinary(Counter::Hits));
    // The sphere is a marble, ten kilometres away and as large as the picture. The rounding error of the squared
    // distance is larger than its discriminant.
    let far = count("field_of_view: 1e-4\n", &format!("{MATTE}sphere: 0 0 9990 .01 m\n"));
    assert!(far(Counter::Hits) > 100);
    assert!(far(Counter::Compensated) > far(Counter::Hits) / 2, "{} are compensated", far(Counter::Compensated));
    assert!(far(Counter::Fallbacks) * 50 < far(Counter::Hits), "{} fallbacks", far(Counter::Fallbacks));
}

#[test]
fn rays_along_a_tube_and_on_a_wide_floor_seldom_need_dyadic_arithmetic() {
    let spheres = "sphere: 0 1 0 1 m\nsphere: 2 .5 0 .5 m\nsphere: -2 .5 1 .5 m\n";
    for scene in ["cylinder: 0 0 0 1 1 2 30 m\n", "cylinder: 0 0 0 1 0 0 30 m\n"] {
        let tube = count("max_depth: 9\nfield_of_view: 1\n", &format!("{MIRROR}{scene}"));
        assert!(tube(Counter::Hits) > 1000);
        assert!(tube(Counter::Fallbacks) * 50 < tube(Counter::Hits), "{}", tube(Counter::Fallbacks));
    }
    for (radius, center) in [(1e3, 0.0), (1e6, 0.0), (1e6, 7e5), (1e9, 0.0)] {
        let floor = format!("{MATTE}cylinder: {center} -1 0 {radius} 0 2 0 m\n{spheres}");
        let floor = count("camera_position: 0 2 -9\n", &floor);
        assert!(floor(Counter::Hits) > 1000);
        assert!(floor(Counter::Fallbacks) * 50 < floor(Counter::Hits), "{radius}: {}", floor(Counter::Fallbacks));
    }
}

/// Prints, for the scenes of the repository, how many hits each step finds, and how many comparisons of near hits each
/// step decides, with ten samples a pixel. In ordinary pictures both are few.
#[test]
fn near_hits_are_few_in_ordinary_pictures() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for name in ["spheres", "cylinders", "grid", "materials", "ten-thousand"] {
        let folder = root.join("scenes").join(name);
        let [config, text] =
            ["config.txt", "scene.txt"].map(|file| std::fs::read_to_string(folder.join(file)).expect("it can be read"));
        let mut config = Config::parse(config.as_bytes()).expect("the configuration is valid");
        config.samples_per_pixel = config.samples_per_pixel.min(10);
        let counted = counted(&config, &text);
        let counts = [Counter::Hits, Counter::Compensated, Counter::Fallbacks, Counter::NearHits].map(&counted);
        let exactly = counted(Counter::NearHitsExactly);
        println!("{name}: [hits, compensated, dyadic, near hits] {counts:?}, exactly {exactly}");
        assert!(1000 * exactly <= counts[0], "{counts:?}, {exactly}");
    }
}

#[test]
fn near_hits_are_compared_by_the_first_step_that_decides() {
    let steps = |config: &str, scene: &str| {
        let counted = count(config, &format!("{MATTE}{GLASS}{scene}"));
        assert!(counted(Counter::Hits) > 100);
        [Counter::NearHits, Counter::NearHitsExactly].map(counted)
    };
    let apart = "sphere: -2 0 0 2 m\nsphere: 2 0 0 2 m\ncylinder: 0 3 0 1 0 1 1 m\n";
    assert_eq!(steps("", apart), [0; 2]);
    // Rays inside the glass leave it where it stands on the table.
    let straight = steps("camera_position: 0 3 -9\n", "cylinder: 0 -1 0 9 0 2 0 m\ncylinder: 0 1 0 2 0 2 0 g\n");
    assert!(straight[0] > 100 && straight[1] == 0, "{straight:?}");
    let nested = steps("", "cylinder: 0 0 0 3 1 2 -2 g\ncylinder: 0 0 0 2 -1 -2 2 m\n");
    assert!(nested[0] > 100 && nested[1] == 0, "{nested:?}");
    let stacked = steps("", "cylinder: 0 0 0 3 1 2 -2 g\ncylinder: 1.1 2.2 -2.2 2 1.2 2.4 -2.4 g\n");
    assert!(stacked[0] > 100 && stacked[1] == 0, "{stacked:?}");
    let equal = steps("", "sphere: 0 0 0 3 m\nsphere: 0 0 0 3 g\n");
    assert!(equal[0] > 100 && equal[1] == 0, "{equal:?}");
    let shells = steps("", "sphere: 0 0 0 3 m\nsphere: 0 0 0 2.9999999999 m\n");
    assert!(shells[0] > 100 && shells[1] * 100 < shells[0], "{shells:?}");
    // These surfaces are not nested, so the compensated formulas decide.
    let moved = steps("", "sphere: 0 0 0 3 m\nsphere: 0 1e-10 1e-10 3 m\n");
    assert!(moved[0] > 100 && moved[1] * 100 < moved[0], "{moved:?}");
    let tubes = steps("", "cylinder: 0 0 0 3 1 2 -2 m\ncylinder: 1e-10 1e-10 0 3 1 2 -2 m\n");
    assert!(tubes[0] > 100 && tubes[1] * 100 < tubes[0], "{tubes:?}");
    // The top of the tilted glass and that of the table are the same plane, but their axes have different lengths.
    let tilted = "camera_position: 0 8 -9\n";
    let tilted = steps(tilted, "cylinder: 0 0 0 2 0 2 2 m\ncylinder: 0 .5 .5 2 0 1 1 m\n");
    assert!(tilted[1] > 100, "{tilted:?}");
}

#[test]
fn rays_that_start_near_a_large_sphere_seldom_need_dyadic_arithmetic() {
    let ground =
        count("camera_position: 0 1 -10\n", &format!("{MATTE}sphere: 0 -10000 0 10000 m\nsphere: 0 1 0 1 m\n"));
    assert!(ground(Counter::Compensated) > 1000);
    assert!(ground(Counter::Fallbacks) * 20 < ground(Counter::Compensated));
}

#[test]
fn rays_inside_an_isolated_object_visit_no_node() {
    // A hundred objects get a BVH. In the second scene each object overlaps its neighbours.
    let grid = |radius: f64| -> String {
        let place = |at: u32| 0.4 * (f64::from(at) - 4.5);
        (0..100).map(|at| format!("sphere: {} {} 0 {radius} m\n", place(at % 10), place(at / 10))).collect()
    };
    let visits = |radius: f64| {
        let counts = count("max_depth: 20\n", &format!("{MATTE}{}", grid(radius)));
        assert!(counts(Counter::Hits) > 1000);
        counts(Counter::NodeVisits) as f64 / counts(Counter::PathRays) as f64
    };
    let (isolated, overlapping) = (visits(0.195), visits(0.205));
    assert!(isolated < 0.9 * overlapping, "{isolated} and {overlapping} nodes a ray");
}

#[test]
fn the_entry_into_the_dominant_sphere_is_nearly_always_predicted_right() {
    // Thirty spheres get the flat filter. Each ground sends some rays into itself. Rays in glass are traced in lanes,
    // without a structure, up to 64 objects.
    for ground in ["metal: ground .9 .9 .9 1.5\n", "matte: ground .9 .9 .9\n", GLASS] {
        let name = if ground == GLASS { "g" } else { "ground" };
        let spheres = row_of_spheres(if ground == GLASS { 90 } else { 30 }, "m");
        let text = format!("{MATTE}{ground}sphere: 0 -101 0 100 {name}\n{spheres}");
        let counts = count("samples_per_pixel: 64\n", &text);
        assert!(counts(Counter::PathRays) > 10_000, "{ground}");
        assert!(
            counts(Counter::MispredictedEntries) * 1000 < counts(Counter::PathRays),
            "{ground}: {}",
            counts(Counter::MispredictedEntries)
        );
    }
}
