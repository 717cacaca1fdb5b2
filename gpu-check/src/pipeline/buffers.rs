//! Creates and fills the buffers of a kernel, and waits until the device has written them.

use wgpu::{
    BindGroupLayoutEntry, BindingType, Buffer, BufferBindingType, BufferDescriptor, BufferSize, BufferUsages, PollType,
    ShaderStages,
};

use super::Content;
use crate::{Error, Gpu};

/// The value of every byte of an output before the kernel writes it. No formula is expected to give a number whose
/// bytes all have this value.
pub const SENTINEL: u8 = 0xA5;
/// Size in bytes of a buffer without content, because no buffer may be empty. It is larger than any structure in the
/// shaders.
const SMALLEST: usize = 256;

/// Returns the entry of the bind group's layout for a binding of the shader.
pub fn layout_entry(binding: shaders::Binding) -> BindGroupLayoutEntry {
    BindGroupLayoutEntry {
        binding: binding.number,
        visibility: ShaderStages::COMPUTE,
        ty: BindingType::Buffer {
            ty: BufferBindingType::Storage { read_only: !binding.written },
            has_dynamic_offset: false,
            min_binding_size: BufferSize::new(binding.least_bytes),
        },
        count: None,
    }
}

/// Returns a new buffer with its content for run number `run`. The queue writes the content, because mapping the buffer
/// would panic if the device was lost.
pub fn create(gpu: &Gpu, content: Content<'_>, run: usize) -> Buffer {
    let filler;
    let (size, bytes) = match content {
        Content::Input([]) => (SMALLEST, &[][..]),
        Content::Input(bytes) => (bytes.len(), bytes),
        Content::Inputs(each) => (each[run].len(), &each[run][..]),
        // wgpu fills a new buffer with zeros.
        Content::Scratch(size) | Content::Record(size) => ((size as usize).max(SMALLEST), &[][..]),
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

/// Waits until the device has finished all submitted work. Returns an error after the time limit of the device, or if
/// the device was lost.
pub fn wait(gpu: &Gpu) -> Result<(), Error> {
    let poll = PollType::Wait { submission_index: None, timeout: Some(gpu.patience()) };
    match gpu.device.poll(poll) {
        Ok(_) => gpu.check_lost(),
        Err(_) => gpu.check_lost().and(Err(Error::Timeout { seconds: gpu.patience().as_secs() })),
    }
}
