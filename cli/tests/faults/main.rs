//! Faults from outside: signals, little memory, inputs that are not files, and two programs at once. Afterwards the
//! output is the complete old picture or the complete new one, and every error is a message and an exit status.

#![cfg(unix)]

mod inputs;
mod kills;
mod loads;
mod memory;
mod together;
mod workshop;
