//! The life of a pixel, as a WebAssembly module of its own: the page loads it when a pixel is explained.
//!
//! The caller asks for room for both texts with [`room`], and writes them there. Then it calls [`explain`], and reads
//! JSON at [`result`].

#![allow(unsafe_code, reason = "a name in the module's interface must be unique, which the compiler cannot check")]

use std::sync::{Mutex, MutexGuard, PoisonError};

use cpu::{Config, Error, Scatter, Scene};
use literal::explain::life;
use serde_json::{Value, json};

/// The configuration, the scene and the result of the last call. A module has one thread, so nothing waits for the
/// lock.
static STATE: Mutex<[Vec<u8>; 3]> = Mutex::new([const { Vec::new() }; 3]);

fn state() -> MutexGuard<'static, [Vec<u8>; 3]> {
    STATE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Makes room for `length` bytes of the configuration (`text` is 0) or of the scene (1), and returns its address.
#[unsafe(no_mangle)]
pub extern "C" fn room(text: usize, length: usize) -> *mut u8 {
    match state().get_mut(text) {
        Some(bytes) => {
            *bytes = vec![0; length];
            bytes.as_mut_ptr()
        }
        None => std::ptr::null_mut(),
    }
}

/// Makes the result the life of a pixel with the events of one sample, and returns the number of its bytes. `vectors`
/// is the number of random vectors that surfaces take before the pixel's row, or NaN if it is unknown.
///
/// The result has the fields of [`life`], and tells the last sample instead of one beyond it. After an error it has
/// `message` alone, and for a pixel that does not exist it is `null`.
#[unsafe(no_mangle)]
pub extern "C" fn explain(column: usize, row: usize, sample: usize, vectors: f64) -> usize {
    let mut state = state();
    let known = (!vectors.is_nan()).then_some(vectors as u64);
    let found = told(&state[0], &state[1], known, [column, row], sample);
    let value = found.unwrap_or_else(|error| json!({ "message": error.to_string() }));
    state[2] = value.to_string().into_bytes();
    state[2].len()
}

/// Returns the address of the result.
#[unsafe(no_mangle)]
pub extern "C" fn result() -> *const u8 {
    state()[2].as_ptr()
}

fn told(config: &[u8], scene: &[u8], vectors: Option<u64>, pixel: [usize; 2], sample: usize) -> Result<Value, Error> {
    let (config, scene) = (Config::parse(config)?, Scene::parse(scene)?);
    let Some(mut life) = life(&config, &scene, Scatter::Statement, vectors, pixel)? else { return Ok(Value::Null) };
    let count = life["samples"].as_array().map_or(0, Vec::len);
    let of_sample = life["samples"].get_mut(sample.min(count.saturating_sub(1)));
    life["samples"] = of_sample.map_or(Value::Null, Value::take);
    Ok(life)
}
