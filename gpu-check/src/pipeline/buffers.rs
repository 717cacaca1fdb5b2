//! Creates and fills the buffers of a kernel, and waits until the device has written them.

use std::time::{Duration, Instant};

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
    let (start, used) = (Instant::now(), processor_time());
    let patience = gpu.patience();
    loop {
        let poll = PollType::Wait { submission_index: None, timeout: Some(patience) };
        let is_done = gpu.device.poll(poll).is_ok();
        gpu.check_lost()?;
        if is_done {
            return Ok(());
        }
        let used = gpu.is_cpu().then(|| processor_time().saturating_sub(used));
        if is_over(start.elapsed(), used, patience) {
            return Err(Error::Timeout { seconds: patience.as_secs() });
        }
    }
}

/// Whether a run is over its time limit `patience`. A driver that calculates on the CPU, whose processor time is
/// `used`, shares it with other programs. So on a busy machine it has more time, but not without end.
fn is_over(elapsed: Duration, used: Option<Duration>, patience: Duration) -> bool {
    elapsed >= patience && used.is_none_or(|used| used >= patience || elapsed >= 30 * patience)
}

/// Returns the processor time of this process.
#[cfg(unix)]
fn processor_time() -> Duration {
    use nix::sys::resource::{UsageWho, getrusage};
    use nix::sys::time::TimeValLike as _;

    let time = getrusage(UsageWho::RUSAGE_SELF).map(|usage| usage.user_time() + usage.system_time());
    time.map_or(Duration::ZERO, |time| Duration::from_micros(u64::try_from(time.num_microseconds()).unwrap_or(0)))
}

/// Returns zero, because this system is not asked for the processor time of this process.
#[cfg(not(unix))]
fn processor_time() -> Duration {
    Duration::ZERO
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_busy_machine_gives_a_driver_on_the_cpu_more_time() {
        let seconds = |seconds: u64| Duration::from_secs(seconds);
        for (elapsed, used, is_expected) in [
            (9, None, false),
            (10, None, true),
            (10, Some(9), false),
            (299, Some(9), false),
            (300, Some(9), true),
            (12, Some(10), true),
        ] {
            let over = is_over(seconds(elapsed), used.map(seconds), seconds(10));
            assert_eq!(over, is_expected, "{elapsed} s, of which {used:?} s are processor time");
        }
    }
}
