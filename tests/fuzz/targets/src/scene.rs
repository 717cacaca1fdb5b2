//! libFuzzer's way into `fuzz_oracles::scene`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzz_oracles::scene::check(bytes));
