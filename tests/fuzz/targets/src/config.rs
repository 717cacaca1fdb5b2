//! libFuzzer's way into `fuzz_oracles::config`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzz_oracles::config::check(bytes));
