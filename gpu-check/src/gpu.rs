//! An open device: opening it, its limits, and its errors.

use std::fmt;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use shaders::{Composition, Precision};
use wgpu::{
    Adapter, AdapterInfo, Backend, Device, DeviceDescriptor, DeviceType, ErrorFilter, Features, Limits, PollType, Queue,
};

use crate::form::Form;
use crate::{Error, adapter};

/// An open device of an adapter.
#[derive(Debug)]
pub struct Gpu {
    pub(crate) device: Device,
    pub(crate) queue: Queue,
    info: AdapterInfo,
    /// The form that was asked for.
    form: Form,
    /// The reason why the device was lost; `None` as long as it is not lost.
    lost: Arc<Mutex<Option<String>>>,
    /// Time limit of a run.
    patience: Duration,
}

/// Time limit of a run, unless [`Gpu::with_patience`] sets another limit.
pub const PATIENCE: Duration = Duration::from_secs(120);

/// Number of bytes of address space that must be free before a driver is loaded. lavapipe, its compiler and their
/// threads use most of it. With less, the driver may end the process when an allocation fails.
const ROOM: usize = 768 << 20;

/// Returns an error if [`ROOM`] bytes of address space are not free. It reserves the bytes and frees them.
fn check_room() -> Result<(), Error> {
    let mut room = Vec::<u8>::new();
    let asked = room.try_reserve_exact(ROOM);
    // Without this, the compiler would remove the allocation, because its memory is not used.
    std::hint::black_box(&room);
    asked.map_err(|_| Error::OutOfMemory {
        cause: format!("the driver needs {} MiB of address space, see ulimit -v", ROOM >> 20),
    })
}

impl Gpu {
    /// Opens the adapter of [`adapter::choose`]. If the adapter supports f64 in shaders, it is switched on.
    ///
    /// # Errors
    /// [`Error::NoAdapter`], [`Error::NoDevice`], or [`Error::OutOfMemory`] if the address space is too small; then no
    /// driver is loaded.
    pub fn open() -> Result<Self, Error> {
        check_room()?;
        Self::of(&adapter::choose()?, Features::all())
    }

    /// Opens as [`Self::open`] does, but without f64, as if the adapter had none.
    ///
    /// # Errors
    /// The errors of [`Self::open`].
    pub fn open_without_f64() -> Result<Self, Error> {
        check_room()?;
        Self::of(&adapter::choose()?, !Features::SHADER_F64)
    }

    /// Returns this device with another form of its shaders. A device that is opened has [`Form::AsWritten`].
    #[must_use]
    pub fn with_form(self, form: Form) -> Self {
        Self { form, ..self }
    }

    fn of(adapter: &Adapter, allowed: Features) -> Result<Self, Error> {
        let info = adapter.get_info();
        // The limits of the WebGPU standard, which browsers have too. One limit is 128 MiB for a binding. Only pictures
        // with random numbers in a hierarchy bind one buffer more than the standard's 8, if the adapter has them.
        let buffers = adapter.limits().max_storage_buffers_per_shader_stage.clamp(8, 9);
        let descriptor = DeviceDescriptor {
            required_features: adapter.features() & allowed & (Features::SHADER_F64 | Features::PASSTHROUGH_SHADERS),
            required_limits: Limits { max_storage_buffers_per_shader_stage: buffers, ..Limits::default() },
            ..DeviceDescriptor::default()
        };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))
            .map_err(|error| Error::NoDevice { adapter: info.name.clone(), cause: error.to_string() })?;
        let lost = Arc::new(Mutex::new(None));
        let place = Arc::clone(&lost);
        device.set_device_lost_callback(move |reason, message| {
            if let Ok(mut lost) = place.lock() {
                *lost = Some(format!("{reason:?} {message}").trim_end().to_owned());
            }
        });
        Ok(Self { device, queue, info, form: Form::AsWritten, lost, patience: PATIENCE })
    }

    /// Returns this device with the time limit `patience` for a run, instead of [`PATIENCE`].
    #[must_use]
    pub fn with_patience(self, patience: Duration) -> Self {
        Self { patience, ..self }
    }

    /// Whether the driver calculates on the CPU.
    pub(crate) fn is_cpu(&self) -> bool {
        self.info.device_type == DeviceType::Cpu
    }

    /// Returns the time limit of a run.
    pub(crate) fn patience(&self) -> Duration {
        self.patience
    }

    /// Returns the adapter's name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.info.name
    }

    /// Returns the name of the driver, its version and its interface.
    #[must_use]
    pub fn driver(&self) -> String {
        let AdapterInfo { driver, driver_info, backend, .. } = &self.info;
        format!("{driver} {driver_info}, {backend}")
    }

    /// Whether the driver is lavapipe, the default.
    #[must_use]
    pub fn is_lavapipe(&self) -> bool {
        self.info.driver == "llvmpipe"
    }

    /// Whether shaders can use f64.
    #[must_use]
    pub fn has_f64(&self) -> bool {
        self.device.features().contains(Features::SHADER_F64)
    }

    /// Returns the form that was asked for.
    #[must_use]
    pub const fn wanted_form(&self) -> Form {
        self.form
    }

    /// Returns the form in which this device gets `composition`: integers if they already calculate its f64.
    #[must_use]
    pub fn form_of(&self, composition: &Composition) -> Form {
        if composition.is_lowered() { Form::ByIntegers } else { self.form(composition.precision()) }
    }

    /// Returns the form in which this device gets shaders of a precision: the one that was asked for; integers for f64
    /// if the device lacks it; WGSL if its driver takes no SPIR-V. Integers replace f64 only: f32 is as written then.
    #[must_use]
    pub fn form(&self, precision: Precision) -> Form {
        let passes_spir_v =
            self.device.features().contains(Features::PASSTHROUGH_SHADERS) && self.info.backend == Backend::Vulkan;
        match self.form {
            form if precision == Precision::F64 && (form == Form::ByIntegers || !self.has_f64()) => Form::ByIntegers,
            Form::AsWritten | Form::ByIntegers if passes_spir_v => Form::AsWritten,
            _ => Form::AsDriverLikes,
        }
    }

    /// Returns the largest number of bytes that one binding may have.
    #[must_use]
    pub fn binding_limit(&self) -> u64 {
        self.device.limits().max_storage_buffer_binding_size
    }

    /// Destroys the device. Later runs return [`Error::DeviceLost`].
    pub fn close(&self) {
        self.device.destroy();
        // This poll calls the callback for a lost device. Its own result is not needed.
        let _ = self.device.poll(PollType::Poll);
    }

    /// Calls `work`, and returns its result, or an error if wgpu reports an error during the call.
    pub(crate) fn scoped<R>(&self, work: impl FnOnce() -> R) -> Result<R, Error> {
        let validation = self.device.push_error_scope(ErrorFilter::Validation);
        let memory = self.device.push_error_scope(ErrorFilter::OutOfMemory);
        let internal = self.device.push_error_scope(ErrorFilter::Internal);
        let result = work();
        let (internal, memory, validation) = (internal.pop(), memory.pop(), validation.pop());
        let memory = pollster::block_on(memory).map(|error| error.to_string());
        let other = pollster::block_on(internal).or(pollster::block_on(validation)).map(|error| error.to_string());
        self.check_lost()?;
        match (memory, other) {
            (Some(cause), _) => Err(Error::OutOfMemory { cause }),
            (None, Some(cause)) => Err(Error::Refused { cause }),
            (None, None) => Ok(result),
        }
    }

    /// Returns an error if the device was lost.
    pub(crate) fn check_lost(&self) -> Result<(), Error> {
        let lost = self.lost.lock().map(|lost| lost.clone()).unwrap_or_else(|_| Some("unknown".to_owned()));
        match lost {
            Some(cause) => Err(Error::DeviceLost { cause }),
            None => Ok(()),
        }
    }
}

impl fmt::Display for Gpu {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let f64 = if self.has_f64() { "with f64" } else { "without f64" };
        write!(f, "{}, driver {}, {f64}", self.name(), self.driver())?;
        match Precision::ALL.map(|precision| (precision, self.form(precision))) {
            [(_, one), (_, other)] if one == other => write!(f, ", {one}"),
            forms => forms.into_iter().try_for_each(|(precision, form)| write!(f, ", {precision} {form}")),
        }
    }
}
