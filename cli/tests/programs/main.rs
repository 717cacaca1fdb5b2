//! Tests of the built programs as their users see them: arguments, messages, exit status and files.
//!
//! Every check runs both programs. Tests that need special rights are in `machine.rs`. Tests of whole pictures are in
//! `digests.rs`.

mod arguments;
mod bench;
mod input_files;
mod messages;
mod outputs;
#[cfg(target_os = "linux")]
mod symbols;
