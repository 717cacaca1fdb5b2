//! libFuzzer's way into `hostile::render`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| hostile::render::check(bytes));
