//! libFuzzer's way into `fuzz_oracles::render`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzz_oracles::render::check(bytes));
