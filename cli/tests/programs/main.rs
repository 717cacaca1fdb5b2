//! Tests of the built programs as their users see them: arguments, messages, exit status and files.
//!
//! Every check runs both programs. Tests that need special rights are in `machine.rs`. Tests of whole pictures are in
//! `digests.rs`.

mod arguments;
mod bench;
mod configuration_errors;
mod input_files;
mod outputs;
mod pictures;
mod scene_errors;
