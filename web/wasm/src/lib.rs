//! The renderer as a WebAssembly module. Its functions take and return numbers alone, so it needs no generated glue.
//!
//! The caller asks for room for the two texts with [`room`], and writes them there. Then it calls [`check`] or
//! [`render`], and reads the file or the message at [`result`]. Any call may move the memory, so the caller asks for an
//! address after the call. The caller gives the module the functions in `page`, which [`render`] calls for every row.
//! `tests/platforms/render.mjs` and `web/site` are callers.

#![allow(unsafe_code, reason = "a name in the module's interface must be unique, which the compiler cannot check")]

mod fault;
mod live;
mod page;
mod picture;
mod seen;
mod state;
mod texts;

use std::sync::{Mutex, MutexGuard, PoisonError};

use cpu::internals::InstructionSet;
use cpu::{Aos, Scatter, Soa};
use format::hint::Language;

use crate::fault::Fault;
use crate::live::Live;
use crate::state::State;

/// The texts and the result of the last call. A module has one thread, so nothing waits for the lock.
static STATE: Mutex<State> = Mutex::new(State::new());

fn state() -> MutexGuard<'static, State> {
    STATE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Makes room for `length` bytes of the configuration (`text` is 0) or of the scene (1), and returns its address.
///
/// The room is filled with zeros. Another `text` gets the address 0.
#[unsafe(no_mangle)]
pub extern "C" fn room(text: usize, length: usize) -> *mut u8 {
    match state().texts.get_mut(text) {
        Some(bytes) => {
            *bytes = vec![0; length];
            bytes.as_mut_ptr()
        }
        None => std::ptr::null_mut(),
    }
}

/// Checks the configuration (`text` is 0) or the scene, and returns the number of its faults, at most 20. [`fault_at`]
/// chooses one of them.
#[unsafe(no_mangle)]
pub extern "C" fn check(text: usize) -> usize {
    let mut state = state();
    state.faults = state.faults_of(text);
    state.faults.len()
}

/// Makes the result the message of fault number `index` of the last [`check`], as after [`render`]. The functions from
/// [`fault()`] gives its place and its hints.
#[unsafe(no_mangle)]
pub extern "C" fn fault_at(index: usize) {
    let mut state = state();
    if let Some(fault) = state.faults.get(index).cloned() {
        state.store(fault);
    }
}

/// Renders the two texts, and returns 0 for a picture and 1 for an error.
///
/// The result is then a PPM file, or a message without `Error: ` before it and without a line end. `layout` is 0 for
/// arrays of structures, 1 for structures of arrays. `is_published` is 1 for the scatter vectors of the published
/// images, 0 for the statement's. `is_portable` is 1 to render without the module's 128-bit lanes.
#[unsafe(no_mangle)]
pub extern "C" fn render(layout: u32, is_published: u32, is_portable: u32) -> u32 {
    let scatter = if is_published == 0 { Scatter::Statement } else { Scatter::Published };
    let set = if is_portable == 0 { InstructionSet::best() } else { InstructionSet::Portable };
    with_state(|state| match layout {
        0 => picture::file::<Aos>(state, scatter, set),
        _ => picture::file::<Soa>(state, scatter, set),
    })
}

/// Replaces the result by its SHA-256 digest, in lower-case hexadecimal digits.
#[unsafe(no_mangle)]
pub extern "C" fn digest() {
    let mut state = state();
    state.result = format::digest::sha256(&state.result).into_bytes();
}

/// Makes the result the table of the lines of a configuration (`text` is 0) or of a scene. `render-lab help config` and
/// `help scene` print the same tables. Each line has fields with tabs between them: tag, values, default and meaning.
#[unsafe(no_mangle)]
pub extern "C" fn table(text: usize) {
    let lines = if text == 0 { &format::CONFIG[..] } else { &format::SCENE[..] };
    let rows = lines
        .iter()
        .map(|line| [line.tag, line.values, line.default, line.meaning, &line.values_in(Language::Spanish)].join("\t"));
    state().result = rows.collect::<Vec<_>>().join("\n").into_bytes();
}

/// Returns the address of the result of the last call.
#[unsafe(no_mangle)]
pub extern "C" fn result() -> *const u8 {
    state().result.as_ptr()
}

/// Returns the number of bytes of the result of the last call.
#[unsafe(no_mangle)]
pub extern "C" fn result_length() -> usize {
    state().result.len()
}

/// Makes the place and the hints of the last fault the result, as JSON: `text`, `line`, `column`, `length` and `hints`.
#[unsafe(no_mangle)]
pub extern "C" fn fault() {
    let mut state = state();
    // Serialising numbers and texts into memory never fails.
    state.result = serde_json::to_vec(&state.fault).unwrap_or_default();
}

/// Reads both texts for the shaders, and returns 0, or 1 with a fault as after [`fault_at`].
#[unsafe(no_mangle)]
pub extern "C" fn prepare() -> u32 {
    with_state(|state| {
        state.live = Some(Live::new(state.config()?, state.scene()?)?);
        Ok(Vec::new())
    })
}

/// Reads the configuration again for the shaders, and keeps the scene of the last [`prepare`]. Returns 0, or 1 with a
/// fault as after [`fault_at`].
#[unsafe(no_mangle)]
pub extern "C" fn aim() -> u32 {
    with_state(|state| {
        let mut live = state.live.take().ok_or_else(unprepared)?;
        let aimed = state.config().and_then(|config| live.aim(config));
        state.live = Some(live);
        aimed.map(|()| Vec::new())
    })
}

/// Makes the result a buffer for the shaders if `part` is 0 to 3, the binding in `shaders/wgsl/picture.wgsl`, or 8,
/// that of the hierarchy. For 4 the result is a JSON text with facts about the picture. Returns 0, or 1 with a fault as
/// after [`fault_at`].
#[unsafe(no_mangle)]
pub extern "C" fn packed(part: u32) -> u32 {
    with_state(|state| {
        let live = state.live.as_ref().ok_or_else(unprepared)?;
        if part == 4 { live.facts() } else { Ok(live.packed(part)) }
    })
}

/// Makes the result a picture in deterministic mode, as f64. `kind` is 0 for the three linear colours of each pixel by
/// the exact renderer, 1 for those by the twin of the shaders in f32, and 2 for what the exact rays hit
/// (`seen::Seen`). Returns 0, or 1 with a fault as after [`fault_at`].
#[unsafe(no_mangle)]
pub extern "C" fn truth(kind: u32) -> u32 {
    with_state(|state| state.live.as_ref().ok_or_else(unprepared)?.truth(kind))
}

/// Makes the result the steps of a pixel's path by the twin in f32: for each step as many f32 as [`step_names`] has
/// names. Returns 0, or 1 with a fault as after [`fault_at`].
#[unsafe(no_mangle)]
pub extern "C" fn steps(pixel: usize) -> u32 {
    with_state(|state| Ok(state.live.as_ref().ok_or_else(unprepared)?.steps(pixel)))
}

/// Makes the result the names of a step's numbers, with line ends between them.
#[unsafe(no_mangle)]
pub extern "C" fn step_names() {
    state().result = twin::steps::NAMES.join("\n").into_bytes();
}

/// Makes the result a JSON list of the WGSL modules.
#[unsafe(no_mangle)]
pub extern "C" fn wgsl() {
    state().result = texts::json();
}

/// The fault of a call that needs an earlier call of [`prepare`].
fn unprepared() -> Fault {
    Fault::own("no scene is prepared".to_owned(), "no hay ninguna escena preparada", 2)
}

/// Stores what `act` returns as the result, or its fault, and returns 0 or 1.
fn with_state(act: impl FnOnce(&mut State) -> Result<Vec<u8>, Fault>) -> u32 {
    let mut state = state();
    match act(&mut state) {
        Ok(result) => {
            state.result = result;
            0
        }
        Err(fault) => {
            state.store(fault);
            1
        }
    }
}

#[cfg(test)]
mod tests;
