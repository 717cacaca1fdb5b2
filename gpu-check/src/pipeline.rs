//! Compiles kernels for a device and runs them.

mod buffers;

use std::sync::mpsc;
use std::time::{Duration, Instant};

use shaders::{Composition, Precision};
use wgpu::util::DownloadBuffer;
use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindGroupLayoutDescriptor, Buffer,
    CommandEncoderDescriptor, ComputePassDescriptor, ComputePipeline, ComputePipelineDescriptor,
    PipelineCompilationOptions, PipelineLayoutDescriptor,
};

use crate::form::Formed;
use crate::{Error, Gpu};
use buffers::{SENTINEL, create, layout_entry, wait};

/// Number of invocations in a workgroup of every kernel.
const WORKGROUP: u64 = 64;
/// Largest number of invocations in one run, because WebGPU allows 65,535 workgroups in a dimension.
pub const MAX_INVOCATIONS: u64 = 65_535 * WORKGROUP;

/// The content of one buffer. A list of contents is in the order of the bindings' numbers.
#[derive(Clone, Copy, Debug)]
pub enum Content<'a> {
    /// Bytes that the kernel reads, in every run.
    Input(&'a [u8]),
    /// Bytes that the kernel reads. Several runs follow each other, and each has its own entry.
    Inputs(&'a [Vec<u8>]),
    /// A buffer of this many bytes for intermediate values of the kernel.
    Scratch(u64),
    /// A buffer of this many bytes for results. The kernel must write all of them.
    Output(u64),
    /// A buffer of this many bytes for results, which are zero before the run. The kernel may write a part of them.
    Record(u64),
}

/// A kernel that is compiled for a device.
#[derive(Debug)]
pub struct Pipeline {
    name: &'static str,
    precision: Precision,
    pipeline: ComputePipeline,
    layout: BindGroupLayout,
    /// The numbers of the bindings, in ascending order.
    bindings: Vec<u32>,
}

/// The results of one call of [`Pipeline::run`].
#[derive(Clone, Debug)]
pub struct Run {
    /// The contents of all [`Content::Output`] and [`Content::Record`] buffers, in the order of their bindings.
    pub outputs: Vec<Vec<u8>>,
    /// The time from submitting the work until the device has finished it, without the transfers.
    pub time: Duration,
}

impl Content<'_> {
    /// Returns the number of runs for which there is content.
    const fn runs(&self) -> usize {
        match self {
            Self::Inputs(each) => each.len(),
            _ => 1,
        }
    }
}

impl Pipeline {
    /// Compiles the only entry point of `composition`. `constants` are names and values of its pipeline-overridable
    /// constants.
    ///
    /// # Errors
    /// [`Error::Shader`] with the place in the module's file, [`Error::Refused`] if the shader does not declare one of
    /// the names, or an error of the driver.
    pub fn new(gpu: &Gpu, composition: &Composition, constants: &[(&str, f64)]) -> Result<Self, Error> {
        let formed = Formed::new(composition, constants, gpu.form_of(composition))?;
        formed.check_limits(&gpu.device.limits())?;
        let shader = &formed.shader;
        let constants: Vec<_> = formed.constants.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        let mut entries: Vec<_> = shader.bindings().map(layout_entry).collect();
        entries.sort_unstable_by_key(|entry| entry.binding);
        let bindings = entries.iter().map(|entry| entry.binding).collect();
        gpu.scoped(|| {
            let name = composition.root();
            let layout = gpu
                .device
                .create_bind_group_layout(&BindGroupLayoutDescriptor { label: Some(name), entries: &entries });
            let pipeline_layout = gpu.device.create_pipeline_layout(&PipelineLayoutDescriptor {
                label: Some(name),
                bind_group_layouts: &[Some(&layout)],
                ..PipelineLayoutDescriptor::default()
            });
            let module = formed.module(&gpu.device, name);
            let compilation_options =
                PipelineCompilationOptions { constants: &constants, ..PipelineCompilationOptions::default() };
            let pipeline = gpu.device.create_compute_pipeline(&ComputePipelineDescriptor {
                label: Some(name),
                layout: Some(&pipeline_layout),
                module: &module,
                entry_point: None,
                compilation_options,
                cache: None,
            });
            Self { name, precision: composition.precision(), pipeline, layout, bindings }
        })
    }

    /// Makes the driver compile the kernel to machine code, without an invocation. It submits a run of 0 invocations,
    /// because lavapipe creates machine code only for a run.
    ///
    /// # Errors
    /// [`Error::Timeout`], or an error of the driver.
    pub fn warm_up(&self, gpu: &Gpu) -> Result<(), Error> {
        gpu.check_lost()?;
        let contents = vec![Content::Scratch(0); self.bindings.len()];
        gpu.scoped(|| self.dispatch(gpu, &contents, 0))?.1.map(drop)
    }

    /// Runs the kernel with `contents` bound in the order of the bindings' numbers. It runs once, or once for each
    /// entry of a [`Content::Inputs`].
    ///
    /// # Errors
    /// [`Error::TooLarge`], [`Error::Timeout`], [`Error::Unwritten`], or an error of the driver.
    ///
    /// # Panics
    /// If `invocations` is more than [`MAX_INVOCATIONS`].
    pub fn run(&self, gpu: &Gpu, contents: &[Content<'_>], invocations: u64) -> Result<Run, Error> {
        assert!(invocations <= MAX_INVOCATIONS, "{invocations} invocations are more than a run may have");
        gpu.check_lost()?;
        self.check_sizes(gpu, contents)?;
        let (buffers, time) = gpu.scoped(|| self.dispatch(gpu, contents, invocations))?;
        let mut outputs = Vec::new();
        for (buffer, content) in buffers.iter().zip(contents) {
            if matches!(content, Content::Output(_) | Content::Record(_)) {
                let bytes = Self::read(gpu, buffer)?;
                if matches!(content, Content::Output(_)) {
                    self.check_written(&bytes)?;
                }
                outputs.push(bytes);
            }
        }
        Ok(Run { outputs, time: time? })
    }

    fn check_sizes(&self, gpu: &Gpu, contents: &[Content<'_>]) -> Result<(), Error> {
        let limit = gpu.binding_limit();
        for content in contents {
            let (what, bytes) = match content {
                Content::Input(bytes) => ("an input", bytes.len() as u64),
                Content::Inputs(each) => ("an input", each.iter().map(Vec::len).max().unwrap_or(0) as u64),
                Content::Scratch(bytes) => ("the materials that attenuate each path", *bytes),
                Content::Output(bytes) | Content::Record(bytes) => ("an output", *bytes),
            };
            if bytes > limit {
                return Err(Error::TooLarge { what, bytes, limit });
            }
        }
        Ok(())
    }

    /// Creates the buffers and does all runs. Returns the buffers of the first run, whose outputs can be read, and the
    /// time of all runs.
    fn dispatch(
        &self,
        gpu: &Gpu,
        contents: &[Content<'_>],
        invocations: u64,
    ) -> (Vec<Buffer>, Result<Duration, Error>) {
        let runs = contents.iter().map(|content| content.runs()).max().unwrap_or(1);
        let first: Vec<_> = contents.iter().map(|content| create(gpu, *content, 0)).collect();
        let mut encoder = gpu.device.create_command_encoder(&CommandEncoderDescriptor { label: Some(self.name) });
        {
            let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor::default());
            pass.set_pipeline(&self.pipeline);
            for run in 0..runs {
                let own = contents.iter().zip(&first).map(|(content, buffer)| match content {
                    Content::Inputs(_) => create(gpu, *content, run),
                    _ => buffer.clone(),
                });
                pass.set_bind_group(0, &self.bind(gpu, &own.collect::<Vec<_>>()), &[]);
                pass.dispatch_workgroups(invocations.div_ceil(WORKGROUP) as u32, 1, 1);
            }
        }
        let start = Instant::now();
        gpu.queue.submit([encoder.finish()]);
        let time = wait(gpu).map(|()| start.elapsed());
        (first, time)
    }

    fn bind(&self, gpu: &Gpu, buffers: &[Buffer]) -> BindGroup {
        let entries = self.bindings.iter().zip(buffers);
        let entries =
            entries.map(|(&binding, buffer)| BindGroupEntry { binding, resource: buffer.as_entire_binding() });
        gpu.device.create_bind_group(&BindGroupDescriptor {
            label: Some(self.name),
            layout: &self.layout,
            entries: &entries.collect::<Vec<_>>(),
        })
    }

    fn read(gpu: &Gpu, buffer: &Buffer) -> Result<Vec<u8>, Error> {
        let (sender, receiver) = mpsc::channel();
        gpu.scoped(|| {
            // The receiver is there until the device has answered or is lost.
            let send = move |bytes| drop(sender.send(bytes));
            DownloadBuffer::read_buffer(&gpu.device, &gpu.queue, &buffer.slice(..), send);
        })?;
        wait(gpu)?;
        match receiver.recv() {
            Ok(Ok(bytes)) => Ok(bytes.to_vec()),
            Ok(Err(error)) => Err(Error::Refused { cause: error.to_string() }),
            Err(error) => Err(Error::Refused { cause: error.to_string() }),
        }
    }

    /// Returns an error if a number of the output still has the bytes that it had before the run.
    fn check_written(&self, bytes: &[u8]) -> Result<(), Error> {
        let width = match self.precision {
            Precision::F32 => size_of::<f32>(),
            Precision::F64 => size_of::<f64>(),
        };
        let untouched = |number: &&[u8]| number.iter().all(|byte| *byte == SENTINEL);
        match bytes.chunks(width).filter(untouched).count() {
            0 => Ok(()),
            count => Err(Error::Unwritten { kernel: self.name.to_owned(), count }),
        }
    }
}
