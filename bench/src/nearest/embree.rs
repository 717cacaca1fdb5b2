//! Embree's side of the comparison: spheres in single precision, in a structure of the highest quality.
//!
//! Embree's library is loaded when it is first used, so nothing needs it to be built. The declarations are those of
//! `rtcore.h` of Embree 3, in Debian's package `libembree-dev`.

#![allow(unsafe_code, reason = "a library in C++ is loaded and called")]

use std::ffi::{CString, c_char, c_int, c_uint, c_void};
use std::ptr::{null, null_mut};
use std::sync::OnceLock;

use cpu::internals::geometry::ray::LAMBDA_MIN;
use cpu::{Scene, Shape, Vec3};
use libloading::Library;

use super::{NearestHit, Start};

/// The file name of the library, as the system's loader finds it.
const LIBRARY: &str = "libembree3.so.3";

/// `RTC_GEOMETRY_TYPE_SPHERE_POINT`: spheres, each given by its centre and radius.
const SPHERES: c_int = 50;
/// `RTC_BUFFER_TYPE_VERTEX`, and `RTC_FORMAT_FLOAT4`: four numbers in single precision for each sphere.
const VERTICES: c_int = 1;
const FOUR_FLOATS: c_int = 0x9004;
/// `RTC_BUILD_QUALITY_HIGH`.
const HIGH_QUALITY: c_int = 2;

/// `RTCRayHit`. The fields up to `flags` are the ray, and the others are the hit. Embree writes `far` and the hit if
/// there is one. Otherwise `sphere` keeps its first value, which is [`NO_PLACE`](super::NO_PLACE).
#[repr(C, align(16))]
struct RayHit {
    origin: [f32; 3],
    near: f32,
    direction: [f32; 3],
    time: f32,
    far: f32,
    mask: c_uint,
    id: c_uint,
    flags: c_uint,
    normal: [f32; 3],
    coordinates: [f32; 2],
    sphere: c_uint,
    geometry: c_uint,
    instance: c_uint,
}

/// `RTCIntersectContext`. The last field is there if Embree was built with `EMBREE_MIN_WIDTH`, and ignored otherwise.
#[repr(C)]
struct Context {
    flags: c_int,
    filter: *const c_void,
    instance: c_uint,
    min_width: f32,
}

type Pointer = *mut c_void;

/// Declares [`Functions`], with a field for each function of the library, and loads them.
macro_rules! functions {
    ($($name:ident: fn($($argument:ty),*) $(-> $result:ty)?;)+) => {
        /// The functions of the library.
        #[allow(non_snake_case, reason = "the names are Embree's")]
        struct Functions {
            $($name: unsafe extern "C" fn($($argument),*) $(-> $result)?,)+
            /// The library must stay loaded as long as the functions are used.
            _library: Library,
        }

        impl Functions {
            fn load() -> Result<Self, libloading::Error> {
                // SAFETY: the library's initialisation has no preconditions, and the functions of this major version
                // have these types in its headers.
                unsafe {
                    let library = Library::new(LIBRARY)?;
                    Ok(Self { $($name: *library.get(concat!(stringify!($name), "\0").as_bytes())?,)+ _library: library })
                }
            }
        }
    };
}

functions! {
    rtcNewDevice: fn(*const c_char) -> Pointer;
    rtcGetDeviceError: fn(Pointer) -> c_int;
    rtcReleaseDevice: fn(Pointer);
    rtcNewGeometry: fn(Pointer, c_int) -> Pointer;
    rtcSetNewGeometryBuffer: fn(Pointer, c_int, c_uint, c_int, usize, usize) -> Pointer;
    rtcCommitGeometry: fn(Pointer);
    rtcReleaseGeometry: fn(Pointer);
    rtcNewScene: fn(Pointer) -> Pointer;
    rtcSetSceneBuildQuality: fn(Pointer, c_int);
    rtcAttachGeometry: fn(Pointer, Pointer) -> c_uint;
    rtcCommitScene: fn(Pointer);
    rtcReleaseScene: fn(Pointer);
    rtcIntersect1: fn(Pointer, *mut Context, *mut RayHit);
}

/// Returns the functions of the library, which is loaded once and stays loaded.
fn functions() -> Result<&'static Functions, &'static str> {
    static FUNCTIONS: OnceLock<Option<Functions>> = OnceLock::new();
    let missing = "libembree-dev is not installed: libembree3.so.3 cannot be loaded";
    FUNCTIONS.get_or_init(|| Functions::load().ok()).as_ref().ok_or(missing)
}

/// Returns why Embree cannot be used, or `None` if it can.
#[must_use]
pub fn missing() -> Option<&'static str> {
    functions().err()
}

/// A ray in single precision, as Embree takes it.
#[derive(Clone, Copy, Debug)]
pub struct SingleRay {
    origin: [f32; 3],
    direction: [f32; 3],
}

impl SingleRay {
    /// Returns the ray of `start`, rounded.
    #[must_use]
    pub fn new(start: &Start) -> Self {
        Self { origin: single(start.ray.origin), direction: single(start.ray.direction) }
    }
}

fn single(Vec3 { x, y, z }: Vec3) -> [f32; 3] {
    [x, y, z].map(|value| value as f32)
}

/// A scene in Embree, with its acceleration structure.
pub struct Embree {
    functions: &'static Functions,
    device: Pointer,
    scene: Pointer,
}

impl Embree {
    /// Builds the structure of a scene of spheres in this thread, with an instruction set of Embree, such as `avx2`.
    ///
    /// # Errors
    /// A message if Embree is not installed, or if it reports an error.
    pub fn new(scene: &Scene, set: &str) -> Result<Self, String> {
        let functions = functions()?;
        let configuration = CString::new(format!("threads=1,isa={set}")).map_err(|error| error.to_string())?;
        // SAFETY: the text ends with a null.
        let device = unsafe { (functions.rtcNewDevice)(configuration.as_ptr()) };
        let mut embree = Self { functions, device, scene: null_mut() };
        embree.check("a device")?;
        let count = scene.objects.len();
        // SAFETY: the device is valid, and so is what it returns unless an error is reported. The buffer has room for
        // four numbers for each sphere, and only this thread uses it.
        unsafe {
            embree.scene = (functions.rtcNewScene)(device);
            (functions.rtcSetSceneBuildQuality)(embree.scene, HIGH_QUALITY);
            let geometry = (functions.rtcNewGeometry)(device, SPHERES);
            let buffer = (functions.rtcSetNewGeometryBuffer)(geometry, VERTICES, 0, FOUR_FLOATS, 16, count);
            embree.check("a buffer")?;
            let vertices = std::slice::from_raw_parts_mut(buffer.cast::<[f32; 4]>(), count);
            for (vertex, object) in vertices.iter_mut().zip(&scene.objects) {
                let Shape::Sphere(sphere) = object.shape else { return Err("only spheres are compared".to_owned()) };
                let [x, y, z] = single(sphere.center);
                *vertex = [x, y, z, sphere.radius as f32];
            }
            (functions.rtcCommitGeometry)(geometry);
            (functions.rtcAttachGeometry)(embree.scene, geometry);
            (functions.rtcCommitScene)(embree.scene);
            (functions.rtcReleaseGeometry)(geometry);
        }
        embree.check("a scene")?;
        Ok(embree)
    }

    /// Returns an error if Embree has reported one since the last call.
    fn check(&self, what: &str) -> Result<(), String> {
        // SAFETY: the device is valid, or null, for which Embree returns the error of the thread.
        match unsafe { (self.functions.rtcGetDeviceError)(self.device) } {
            0 => Ok(()),
            number => Err(format!("Embree's error {number} for {what}")),
        }
    }

    /// Finds the nearest hit of each ray. The least lambda is ours.
    pub fn find(&self, rays: &[SingleRay], hits: &mut Vec<NearestHit>) {
        hits.clear();
        // What `rtcInitIntersectContext` writes: the rays are incoherent, there is no filter and no instance.
        let mut context = Context { flags: 0, filter: null(), instance: c_uint::MAX, min_width: 0.0 };
        for &SingleRay { origin, direction } in rays {
            let mut hit = RayHit {
                origin,
                near: LAMBDA_MIN as f32,
                direction,
                time: 0.0,
                far: f32::INFINITY,
                mask: c_uint::MAX,
                id: 0,
                flags: 0,
                normal: [0.0; 3],
                coordinates: [0.0; 2],
                sphere: c_uint::MAX,
                geometry: c_uint::MAX,
                instance: c_uint::MAX,
            };
            // SAFETY: the scene is committed, and the other two arguments are valid for the time of the call.
            unsafe { (self.functions.rtcIntersect1)(self.scene, &raw mut context, &raw mut hit) };
            hits.push(NearestHit { place: hit.sphere, lambda: hit.far.into() });
        }
    }
}

impl Drop for Embree {
    fn drop(&mut self) {
        // SAFETY: both are valid unless they are null, and nothing uses them later.
        unsafe {
            if !self.scene.is_null() {
                (self.functions.rtcReleaseScene)(self.scene);
            }
            if !self.device.is_null() {
                (self.functions.rtcReleaseDevice)(self.device);
            }
        }
    }
}
