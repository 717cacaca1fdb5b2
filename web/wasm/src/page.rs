//! The functions that the caller of the module gives to it. They tell the caller how far a picture is.
//!
//! A caller must not call the module from within these functions, because the module's state is in use then.

#[cfg(target_arch = "wasm32")]
#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// Called before the first row with the size of the picture in pixels.
    pub safe fn begin(width: usize, height: usize);
    /// Called after row number `row`, counted from 0. The row's pixels are at `address`, four bytes each: red, green,
    /// blue and 255. Surfaces have taken `vectors` random vectors so far, which is NaN if this is not known.
    pub safe fn row(row: usize, address: *const u8, vectors: f64);
}

/// The functions of programs that are no WebAssembly module. They record what they were told, for the tests.
#[cfg(not(target_arch = "wasm32"))]
mod recorded {
    use std::sync::Mutex;

    /// The sizes and the numbers of rows, in the order of the calls.
    pub static CALLS: Mutex<Vec<[usize; 2]>> = Mutex::new(Vec::new());

    pub fn begin(width: usize, height: usize) {
        record([width, height]);
    }

    pub fn row(row: usize, address: *const u8, _: f64) {
        record([row, usize::from(!address.is_null())]);
    }

    fn record(call: [usize; 2]) {
        if let Ok(mut calls) = CALLS.lock() {
            calls.push(call);
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
pub use recorded::{begin, row};

#[cfg(all(test, not(target_arch = "wasm32")))]
pub use recorded::CALLS;
