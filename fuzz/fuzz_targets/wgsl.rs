//! libFuzzer's way into `hostile::wgsl`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| hostile::wgsl::check(bytes));
