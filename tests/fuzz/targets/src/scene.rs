//! The libFuzzer program that calls `fuzz_oracles::scene::check`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzz_oracles::scene::check(bytes));
