//! Checks that every allocation whose size depends on the input may fail, and then returns an error. An allocator
//! refuses the requests of an action one by one, and each time the action must return the error. If the code does not
//! handle a refused request, the process aborts, and the test fails.
//!
//! `cli/tests/faults/memory.rs` limits the memory of whole programs instead.

// An allocator needs unsafe code.
#![allow(unsafe_code)]

use std::alloc::{GlobalAlloc, Layout as Request, System};
use std::cell::Cell;
use std::fmt::Write;
use std::io;
use std::ops::ControlFlow;
use std::ptr;
use std::sync::atomic::{AtomicUsize, Ordering};

use cpu::internals::accel::choice::Accel;
use cpu::internals::accel::extent::Extent;
use cpu::internals::layout::Objects;
use cpu::internals::{Camera, InstructionSet, Prepared};
use cpu::{Aos, Config, Error, Image, Layout, Renderable, Scatter, Scene, Size, Soa};

#[global_allocator]
static REFUSING: Refusing = Refusing { least: AtomicUsize::new(usize::MAX), left: AtomicUsize::new(0) };

thread_local! {
    /// Whether this thread runs the action. The harness of the tests has threads of its own, whose requests are neither
    /// refused nor counted.
    static RUNS_THE_ACTION: Cell<bool> = const { Cell::new(false) };
}

/// An allocator that passes requests to the system's allocator, but refuses one of them.
struct Refusing {
    /// Requests for fewer bytes are neither refused nor counted.
    least: AtomicUsize,
    /// Number of counted requests before the one that is refused.
    left: AtomicUsize,
}

impl Refusing {
    fn refuses(&self, bytes: usize) -> bool {
        // After the refused request the counter wraps around to the largest number, so no other request is refused.
        bytes >= self.least.load(Ordering::Relaxed)
            && RUNS_THE_ACTION.get()
            && self.left.fetch_sub(1, Ordering::Relaxed) == 0
    }
}

// SAFETY: every request that is not refused goes to the system's allocator. An allocator may refuse requests, and
// nothing here allocates or panics.
unsafe impl GlobalAlloc for Refusing {
    unsafe fn alloc(&self, request: Request) -> *mut u8 {
        // SAFETY: the caller keeps the contract of `alloc`, which is that of the system's allocator.
        if self.refuses(request.size()) { ptr::null_mut() } else { unsafe { System.alloc(request) } }
    }

    unsafe fn dealloc(&self, block: *mut u8, request: Request) {
        // SAFETY: the caller keeps the contract of `dealloc`, and all blocks come from the system's allocator.
        unsafe { System.dealloc(block, request) }
    }

    unsafe fn realloc(&self, block: *mut u8, request: Request, bytes: usize) -> *mut u8 {
        // SAFETY: the caller keeps the contract of `realloc`, and all blocks come from the system's allocator.
        if self.refuses(bytes) { ptr::null_mut() } else { unsafe { System.realloc(block, request, bytes) } }
    }
}

/// Runs `action` again and again. The first time, its first request for at least `least` bytes is refused, then its
/// second, and so on. Ends when the action makes no further request, and returns the number of requests. `what` names
/// the action.
fn refused(what: &str, least: usize, mut action: impl FnMut() -> Result<(), Error>) -> usize {
    RUNS_THE_ACTION.set(true);
    for number in 0.. {
        REFUSING.left.store(number, Ordering::Relaxed);
        REFUSING.least.store(least, Ordering::Relaxed);
        let result = action();
        REFUSING.least.store(usize::MAX, Ordering::Relaxed);
        let was_refused = REFUSING.left.load(Ordering::Relaxed) > number;
        match result {
            Ok(()) if !was_refused => return number,
            Err(Error::OutOfMemory { .. }) if was_refused => {}
            Err(Error::Input(error)) if was_refused && error.kind() == io::ErrorKind::OutOfMemory => {}
            other => panic!("{what}, request {number}: {other:?}"),
        }
    }
    unreachable!("there is always one number more")
}

/// Returns the text of a scene with `count` materials, `count` spheres and `count` cylinders.
fn text(count: usize) -> String {
    let mut text = String::new();
    for index in 0..count {
        let (x, z) = (index % 100, index / 100);
        writeln!(text, "matte: m{index} .5 .5 .5").expect("a string takes all text");
        writeln!(text, "sphere: {x} 1 {z} .3 m{index}").expect("a string takes all text");
        writeln!(text, "cylinder: {x} 5 {z} .3 0 1 .1 m{index}").expect("a string takes all text");
    }
    text
}

fn scene(count: usize) -> Scene {
    Scene::parse(text(count).as_bytes()).expect("the scene is valid")
}

fn config() -> Config {
    Config { image_width: 4, aspect_ratio: [1, 1], samples_per_pixel: 1, ..Config::default() }
}

/// Checks the preparation of a scene in the layout `L`. Its search structure makes at least `least` requests.
fn preparation<L: Renderable>(lines: &str, least: usize) {
    let (config, scene) = (config(), Scene::parse(lines.as_bytes()).expect("the scene is valid"));
    let camera = config.image_size().and_then(|size| Camera::new(&config, size)).expect("there is a picture");
    let mut objects = L::Objects::build(&scene).expect("there is enough memory");
    let extent = Extent::new(&objects, &camera, &scene.materials);
    assert!(extent.moderate, "there is something to prepare");
    assert_eq!(extent.has_tiny, lines.contains("1e-8"), "only the last scene has objects apart from the tree");
    assert!(refused("objects", 1, || L::Objects::build(&scene).map(drop)) >= 2);
    let requests = refused("search", 1, || Accel::new(&mut objects, &extent).map(drop));
    assert!(requests >= least, "only {requests}");
}

/// Smallest size in bytes of a request that is refused while a picture is rendered. Blocks of fixed size are smaller.
/// They do not depend on the input, so they are never refused.
const LEAST: usize = 300_000;

/// Checks the preparation and the rendering of a whole picture in the layout `L`.
fn rendering<L: Renderable>() {
    let (config, scene) = (config(), scene(80_000));
    let prepare = || Prepared::<L>::new(&config, &scene, Scatter::Statement);
    let preparing = refused("preparation", LEAST, || prepare().map(drop));
    assert!(preparing >= 5, "only {preparing}");
    let prepared = prepare().expect("there is enough memory");
    let (set, limits) = (InstructionSet::chosen(), cpu::internals::Limits::default());
    let rendering = refused("rendering", LEAST, || {
        let mut image = L::Image::black(prepared.size)?;
        cpu::internals::render_from(&prepared, set, &limits, (0, &[]), &mut image, |_, _, _| ControlFlow::Break(()))
            .map(drop)
    });
    // The candidates of a row and those of a span.
    assert!(rendering >= 2, "only {rendering}");
    assert!(
        refused("means", LEAST, || cpu::internals::render_linear(&prepared, set, &limits, |_, _| ()).map(drop)) >= 2
    );
}

/// Checks the rendering of a ray inside a mirror, whose path reaches the maximum depth.
fn between_mirrors() {
    let config = Config { image_width: 1, samples_per_pixel: 1, max_depth: 500_000, ..config() };
    let scene = Scene::parse(&b"metal: m 1 1 1 0\nsphere: 0 0 0 20 m\n"[..]).expect("the scene is valid");
    let prepared = Prepared::<Aos>::new(&config, &scene, Scatter::Statement).expect("there is enough memory");
    let render = || cpu::internals::render_with(&prepared, InstructionSet::chosen()).map(drop);
    assert!(refused("path", LEAST, render) >= 3);
    let reference = || {
        cpu::reference::render_linear::<cpu::reference::Plain>(&config, &scene, Scatter::Statement, |_, _| ()).map(drop)
    };
    assert!(refused("path of the reference", LEAST, reference) >= 3);
}

// There is only one test, because requests of a test in another thread would be refused too.
#[test]
fn each_request_that_grows_with_the_input_may_be_refused() {
    let config = "image_width: 4\ngamma: 2\n".as_bytes();
    assert_eq!(refused("configuration", 1, || Config::parse(config).map(drop)), 1, "the line");

    let lines = text(5);
    assert!(refused("scene", 1, || Scene::parse(lines.as_bytes()).map(drop)) >= 1 + 5 + 3, "line, names, lists");
    let scene = scene(5);
    assert_eq!(refused("materials", 1, || scene.materials_in_use().map(drop)), 2);

    let size = Size::new(20, 10).expect("it is small");
    assert_eq!(refused("pixels together", 1, || <Aos as Layout>::Image::black(size).map(drop)), 1);
    assert_eq!(refused("pixels apart", 1, || <Soa as Layout>::Image::black(size).map(drop)), 3);

    // These numbers of objects of each kind give a small scene, a flat filter and a BVH.
    // A small scene has no list. Tiny objects are no part of the BVH, and have a list of their own.
    let tiny = text(200) + &"sphere: 1 9 1 1e-8 m0\n".repeat(200);
    for (lines, least) in [(text(1), 0), (text(20), 1), (text(200), 5), (tiny, 5)] {
        preparation::<Aos>(&lines, least);
        preparation::<Soa>(&lines, least);
    }
    rendering::<Aos>();
    rendering::<Soa>();
    between_mirrors();
}
