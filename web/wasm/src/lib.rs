//! The renderer as a WebAssembly module. Its functions take and return numbers alone, so it needs no generated glue.
//!
//! The caller asks for room for the two texts with [`room`], writes them there, calls [`render`], and reads the file or
//! the message at [`result`]. Any call may move the memory, so the caller asks for an address after the call.
//! `tests/platforms/call.js` is a caller.

#![allow(unsafe_code, reason = "a name in the module's interface must be unique, which the compiler cannot check")]

use std::sync::{Mutex, MutexGuard, PoisonError};

use cpu::internals::{InstructionSet, Prepared, render_with};
use cpu::{Aos, Config, Error, Layout, Scatter, Scene, Soa};

/// The texts and the result of one rendering. A module has one thread, so nothing waits for the lock.
static STATE: Mutex<State> = Mutex::new(State { texts: [Vec::new(), Vec::new()], result: Vec::new() });

struct State {
    texts: [Vec<u8>; 2],
    result: Vec<u8>,
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

/// Renders the two texts, and returns 0 for a picture and 1 for an error.
///
/// The result is then a PPM file, or a message without `Error: ` before it and without a line end. `layout` is 0 for
/// arrays of structures, 1 for structures of arrays. `is_published` is 1 for the scatter vectors of the published
/// images, 0 for the statement's. `is_portable` is 1 to render without the module's 128-bit lanes.
#[unsafe(no_mangle)]
pub extern "C" fn render(layout: u32, is_published: u32, is_portable: u32) -> u32 {
    let mut state = state();
    let scatter = if is_published == 0 { Scatter::Statement } else { Scatter::Published };
    let set = if is_portable == 0 { InstructionSet::best() } else { InstructionSet::Portable };
    let file = if layout == 0 { file::<Aos>(&state, scatter, set) } else { file::<Soa>(&state, scatter, set) };
    let status = u32::from(file.is_err());
    state.result = file.unwrap_or_else(|error| error.message());
    status
}

/// Returns the address of the result of [`render`].
#[unsafe(no_mangle)]
pub extern "C" fn result() -> *const u8 {
    state().result.as_ptr()
}

/// Returns the number of bytes of the result of [`render`].
#[unsafe(no_mangle)]
pub extern "C" fn result_length() -> usize {
    state().result.len()
}

fn state() -> MutexGuard<'static, State> {
    STATE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Returns the picture of the two texts as a PPM file.
fn file<L: Layout>(state: &State, scatter: Scatter, set: InstructionSet) -> Result<Vec<u8>, Error> {
    let [config, scene] = &state.texts;
    let (config, scene) = (Config::parse(&**config)?, Scene::parse(&**scene)?);
    let image = render_with(&Prepared::<L>::new(&config, &scene, scatter)?, set)?;
    let mut bytes = Vec::new();
    cpu::write_ppm(&image, &mut bytes)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn write(text: usize, bytes: &[u8]) {
        assert!(!room(text, bytes.len()).is_null());
        state().texts[text].copy_from_slice(bytes);
    }

    /// One test, because the functions share their state.
    #[test]
    fn texts_become_a_file_or_a_message() {
        write(0, b"image_width: 8\naspect_ratio: 1 1\ncamera_position: 0 0 -3\n");
        write(1, b"matte: grey .5 .5 .5\nsphere: 0 0 0 1 grey\n");
        let mut files = Vec::new();
        for (layout, is_published, is_portable) in [(0, 0, 0), (1, 0, 0), (0, 0, 1), (0, 1, 0)] {
            assert_eq!(render(layout, is_published, is_portable), 0);
            assert_eq!(result_length(), state().result.len());
            files.push(state().result.clone());
        }
        assert!(files[0].starts_with(b"P3\n8 8\n255\n"));
        assert!(files[0] == files[1] && files[0] == files[2] && files[0] != files[3]);
        write(1, b"triangle: 1\n");
        assert_eq!(render(0, 0, 0), 1);
        assert_eq!(state().result, b"Unknown scene entity: triangle");
        assert!(room(2, 1).is_null());
    }
}
