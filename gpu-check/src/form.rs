//! The form in which a device gets a shader: it decides who may rewrite the arithmetic.

use std::fmt;
use std::str::FromStr;

use shaders::as_written::{SpirV, spirv};
use shaders::lower::Arithmetic;
use shaders::{Composition, Validated};
use wgpu::{
    Device, Limits, PassthroughShaderEntryPoint, ShaderModule, ShaderModuleDescriptor,
    ShaderModuleDescriptorPassthrough, ShaderSource,
};

use crate::Error;

/// The form in which a device gets a shader.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// SPIR-V in which every floating-point operation is to be done as it is written; see [`shaders::as_written`].
    AsWritten,
    /// WGSL, whose operations the driver may rewrite as it likes.
    AsDriverLikes,
    /// WGSL without f64: integers calculate it; see [`shaders::lower`].
    ByIntegers,
}

impl Form {
    /// All forms.
    pub const ALL: [Self; 3] = [Self::AsWritten, Self::AsDriverLikes, Self::ByIntegers];
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::AsWritten => "as written",
            Self::AsDriverLikes => "as the driver likes",
            Self::ByIntegers => "by integers",
        })
    }
}

impl FromStr for Form {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Self::ALL.into_iter().find(|form| form.to_string() == text).ok_or_else(|| format!("there is no form [{text}]"))
    }
}

/// A shader in the form in which a device gets it.
pub(crate) struct Formed {
    /// The parsed and validated shader.
    pub shader: Validated,
    /// The values of the overrides that the source still has.
    pub constants: Vec<(String, f64)>,
    source: Source,
}

enum Source {
    SpirV(SpirV),
    Wgsl(String),
}

impl Formed {
    /// Returns `composition` in `form`, with `constants` as the values of its overrides.
    ///
    /// # Errors
    /// [`Error::Shader`] with the place in the module's file.
    pub fn new(composition: &Composition, constants: &[(&str, f64)], form: Form) -> Result<Self, Error> {
        let lowers = form == Form::ByIntegers && composition.needs_f64();
        let lowered = lowers.then(|| composition.lowered(&Arithmetic::standard())).transpose()?;
        let composition = lowered.as_ref().unwrap_or(composition);
        let shader = composition.validate()?;
        let (source, constants) = match form {
            Form::AsWritten => (Source::SpirV(spirv(&shader, constants)?), Vec::new()),
            Form::AsDriverLikes | Form::ByIntegers => {
                let constants = constants.iter().map(|&(name, value)| (name.to_owned(), value)).collect();
                (Source::Wgsl(composition.source().to_owned()), constants)
            }
        };
        Ok(Self { shader, constants, source })
    }

    /// Checks the limits on a workgroup, because wgpu does not check those of words that are passed through.
    ///
    /// # Errors
    /// [`Error::Refused`] that names the limit.
    pub fn check_limits(&self, limits: &Limits) -> Result<(), Error> {
        let Source::SpirV(SpirV { workgroup_size: [x, y, z], workgroup_bytes, .. }) = self.source else {
            return Ok(());
        };
        let of_all = u64::from(x) * u64::from(y) * u64::from(z);
        let checks = [
            ("invocations along x", u64::from(x), limits.max_compute_workgroup_size_x),
            ("invocations along y", u64::from(y), limits.max_compute_workgroup_size_y),
            ("invocations along z", u64::from(z), limits.max_compute_workgroup_size_z),
            ("invocations", of_all, limits.max_compute_invocations_per_workgroup),
            ("bytes", workgroup_bytes, limits.max_compute_workgroup_storage_size),
        ];
        match checks.into_iter().find(|(_, actual, most)| *actual > u64::from(*most)) {
            None => Ok(()),
            Some((what, actual, most)) => {
                Err(Error::Refused { cause: format!("a workgroup has {actual} {what}, and may have {most}") })
            }
        }
    }

    /// Gives the shader, whose name for messages is `name`, to the driver.
    pub fn module(&self, device: &Device, name: &str) -> ShaderModule {
        let label = Some(name);
        match &self.source {
            Source::Wgsl(text) => {
                device.create_shader_module(ShaderModuleDescriptor { label, source: ShaderSource::Wgsl(text.into()) })
            }
            Source::SpirV(SpirV { words, entry, workgroup_size: [x, y, z], .. }) => {
                let entry = PassthroughShaderEntryPoint { name: entry.into(), workgroup_size: (*x, *y, *z) };
                let words = Some(words.into());
                pass_through(
                    device,
                    ShaderModuleDescriptorPassthrough {
                        label,
                        entry_points: vec![entry].into(),
                        spirv: words,
                        ..Default::default()
                    },
                )
            }
        }
    }
}

/// Gives words of SPIR-V to the driver unseen.
#[expect(unsafe_code, reason = "wgpu has no safe function for SPIR-V that it did not write itself")]
fn pass_through(device: &Device, descriptor: ShaderModuleDescriptorPassthrough<'_>) -> ShaderModule {
    // SAFETY: the driver must get a valid module that fits the pipeline. naga has validated the module and written the
    // words, with a check of every index, and `shaders::as_written` has added decorations only, each to the result of
    // an instruction that may have it. All bindings are storage buffers; the layout is made from the same module, and
    // has the least size of each buffer, which wgpu checks. `check_limits` has checked the workgroup. The features that
    // the words need are f64 at most, and a device without it gets integers. Tests parse the words, and compare with
    // the same shaders as WGSL, which wgpu translates itself.
    unsafe { device.create_shader_module_passthrough(descriptor) }
}
