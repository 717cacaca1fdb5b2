//! libFuzzer's way into `fuzz_oracles::picture`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzz_oracles::picture::check(bytes));
