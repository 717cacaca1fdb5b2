//! Buffers: how they are bound and filled, and waiting for what is written into them.

use wgpu::{
    BindGroupLayoutEntry, BindingType, Buffer, BufferBindingType, BufferDescriptor, BufferUsages, PollType,
    ShaderStages,
};

use super::Content;
use crate::{Error, Gpu};

/// What an output holds before the kernel writes it: no formula gives this by accident.
pub const SENTINEL: u8 = 0xA5;
/// What an empty buffer is given, since none may be empty: more than any structure takes.
const SMALLEST: usize = 256;

/// How a binding of the shader is bound.
pub fn layout_entry(binding: shaders::Binding) -> BindGroupLayoutEntry {
    BindGroupLayoutEntry {
        binding: binding.number,
        visibility: ShaderStages::COMPUTE,
        ty: BindingType::Buffer {
            ty: BufferBindingType::Storage { read_only: !binding.written },
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    }
}

/// A buffer with its content. It is written through the queue and not mapped: mapping panics on a lost device.
pub fn create(gpu: &Gpu, content: Content<'_>, run: usize) -> Buffer {
    let filler;
    let (size, bytes) = match content {
        Content::Input([]) => (SMALLEST, &[][..]),
        Content::Input(bytes) => (bytes.len(), bytes),
        Content::Inputs(each) => (each[run].len(), &each[run][..]),
        Content::Scratch(size) => ((size as usize).max(SMALLEST), &[][..]),
        Content::Output(size) => {
            filler = vec![SENTINEL; size as usize];
            (filler.len(), &filler[..])
        }
    };
    let buffer = gpu.device.create_buffer(&BufferDescriptor {
        label: None,
        size: size as u64,
        usage: BufferUsages::STORAGE | BufferUsages::COPY_SRC | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.queue.write_buffer(&buffer, 0, bytes);
    buffer
}

/// Waits until the device has done all that it was given.
pub fn wait(gpu: &Gpu) -> Result<(), Error> {
    let poll = PollType::Wait { submission_index: None, timeout: Some(gpu.patience()) };
    match gpu.device.poll(poll) {
        Ok(_) => gpu.check_lost(),
        Err(_) => gpu.check_lost().and(Err(Error::Timeout { seconds: gpu.patience().as_secs() })),
    }
}
