//! libFuzzer's way into `fuzz_oracles::wgsl`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzz_oracles::wgsl::check(bytes));
