//! The built programs, as their users see them: arguments, messages, exit status, files.
//!
//! Every check runs both programs. What needs certain rights is in `machine.rs`, whole pictures in `digests.rs`.

mod arguments;
mod bench;
mod configuration_errors;
mod input_files;
mod outputs;
mod pictures;
mod scene_errors;
