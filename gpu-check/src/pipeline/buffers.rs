//! Binds and fills buffers, and waits until the device has written them.

use wgpu::{
    BindGroupLayoutEntry, BindingType, Buffer, BufferBindingType, BufferDescriptor, BufferUsages, PollType,
    ShaderStages,
};

use super::Content;
use crate::{Error, Gpu};

/// The value of every byte of an output before the kernel writes it. No formula gives a number of these bytes by
/// accident.
pub const SENTINEL: u8 = 0xA5;
/// Size in bytes of a buffer without content, since no buffer may be empty. It is more than any structure takes.
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

/// A buffer with its content for the run number `run`. The content is written through the queue, since mapping the
/// buffer would panic on a lost device.
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

/// Waits until the device has done all submitted work, or the limit on its time is reached.
pub fn wait(gpu: &Gpu) -> Result<(), Error> {
    let poll = PollType::Wait { submission_index: None, timeout: Some(gpu.patience()) };
    match gpu.device.poll(poll) {
        Ok(_) => gpu.check_lost(),
        Err(_) => gpu.check_lost().and(Err(Error::Timeout { seconds: gpu.patience().as_secs() })),
    }
}
