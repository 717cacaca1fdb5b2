//! What the world may do to the programs: kill them, take their disk and their memory, and hand them files that are no
//! files. The old picture stands or the new one does, and every refusal is a message and a status.

#![cfg(unix)]

mod inputs;
mod kills;
mod loads;
mod memory;
mod places;
mod workshop;
