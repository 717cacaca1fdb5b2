//! Translates a valid shader into the languages of Vulkan, Metal, Direct3D and OpenGL.
//!
//! This module decides which languages can calculate in f64. naga's own checks are not enough: its Metal writer panics
//! on f64, and its HLSL writer emits code whose `sqrt` silently rounds to f32.

mod text;

use std::borrow::Cow;
use std::fmt;

use naga::back::PipelineConstants;
use naga::back::pipeline_constants::process_overrides;
use naga::valid::ModuleInfo;
use naga::{Module, ShaderStage};

use crate::{Error, Features, Precision, Validated};

/// A language into which naga translates shaders.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// SPIR-V 1.0, for Vulkan.
    SpirV,
    /// Metal Shading Language 2.0, for Apple's systems.
    Msl,
    /// High Level Shading Language, shader model 5.1, for Direct3D 12.
    Hlsl,
    /// GLSL 4.30, for desktop OpenGL.
    Glsl430,
    /// GLSL ES 3.10, for OpenGL ES.
    GlslEs310,
}

/// A shader, translated into the language of a target.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Translation {
    /// The words of a SPIR-V module.
    Words(Vec<u32>),
    /// The text of the translation, for all other targets.
    Text(String),
}

impl Target {
    /// All target languages.
    pub const ALL: [Self; 5] = [Self::SpirV, Self::Msl, Self::Hlsl, Self::Glsl430, Self::GlslEs310];

    /// Returns the reason why the target cannot calculate in `precision`, or `None` if it can.
    #[must_use]
    pub const fn obstacle(self, precision: Precision) -> Option<&'static str> {
        match (self, precision) {
            (_, Precision::F32) | (Self::SpirV | Self::Glsl430, Precision::F64) => None,
            (Self::Msl, Precision::F64) => Some("Metal has no 64-bit floating point type"),
            (Self::Hlsl, Precision::F64) => Some("the square root of HLSL takes 32 bits only and would round silently"),
            (Self::GlslEs310, Precision::F64) => Some("OpenGL ES has no 64-bit floating point type"),
        }
    }

    /// Returns the usual ending of the name of a file in this language, without the dot.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::SpirV => "spvasm",
            Self::Msl => "metal",
            Self::Hlsl => "hlsl",
            Self::Glsl430 => "430.comp",
            Self::GlslEs310 => "es310.comp",
        }
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::SpirV => "SPIR-V",
            Self::Msl => "Metal",
            Self::Hlsl => "HLSL",
            Self::Glsl430 => "GLSL 4.30",
            Self::GlslEs310 => "GLSL ES 3.10",
        })
    }
}

/// Translates the only entry point of `shader` into the language of `target`. Constants of the shader that `features`
/// names get the values in `features`.
///
/// # Errors
/// [`Error::Unsupported`] if the target lacks the precision; [`Error::Write`] if naga cannot write the shader, or if it
/// does not have exactly one entry point.
pub fn translate(shader: &Validated, target: Target, features: &Features) -> Result<Translation, Error> {
    let precision = shader.precision;
    if let Some(reason) = target.obstacle(precision).filter(|_| shader.needs_f64) {
        return Err(Error::Unsupported { target, precision, reason });
    }
    let failed = failed(target);
    let has = |name: &str| shader.module.overrides.iter().any(|(_, constant)| constant.name.as_deref() == Some(name));
    let constants =
        features.constants().into_iter().filter(|(name, _)| has(name)).map(|(name, value)| (name.to_owned(), value));
    let (module, info, entry) = with_constants(shader, constants.collect()).map_err(&failed)?;
    let input = text::Input { module: &module, info: &info, entry };
    let result = match target {
        Target::SpirV => return input.spirv().map(Translation::Words).map_err(failed),
        Target::Msl => input.msl(),
        Target::Hlsl => input.hlsl(),
        Target::Glsl430 => input.glsl(naga::back::glsl::Version::Desktop(430)),
        Target::GlslEs310 => input.glsl(naga::back::glsl::Version::new_gles(310)),
    };
    result.map(Translation::Text).map_err(failed)
}

/// Returns a function that makes an error of naga's message.
pub(crate) fn failed(target: Target) -> impl Fn(String) -> Error {
    move |message| Error::Write { target, message }
}

/// Returns the module of `shader` with `constants` in the place of its overrides, what naga's writers need to know
/// about it, and the name of its only entry point.
///
/// # Errors
/// A message if there is not exactly one entry point, or if `constants` do not fit the overrides.
pub(crate) fn with_constants(
    shader: &Validated,
    constants: PipelineConstants,
) -> Result<(Cow<'_, Module>, Cow<'_, ModuleInfo>, &str), String> {
    let entries = shader.entry_points();
    let [entry] = entries[..] else {
        return Err(format!("it has {} entry points and needs one", entries.len()));
    };
    let stage = Some((ShaderStage::Compute, entry));
    let (module, info) =
        process_overrides(&shader.module, &shader.info, stage, &constants).map_err(|error| error.to_string())?;
    Ok((module, info, entry))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Library;

    fn image(precision: Precision) -> Validated {
        let composition = Library::standard().compose("kernels/image", precision).expect("it exists");
        composition.validate().expect("it is valid")
    }

    #[test]
    fn a_target_without_f64_says_so() {
        let shader = image(Precision::F64);
        let refused = Target::ALL.into_iter().filter(|target| target.obstacle(Precision::F64).is_some());
        let messages: Vec<_> = refused
            .map(|target| translate(&shader, target, &Features::all(5)).expect_err("it is refused").to_string())
            .collect();
        assert_eq!(
            messages,
            [
                "Metal cannot take f64: Metal has no 64-bit floating point type; compose for f32 instead",
                "HLSL cannot take f64: the square root of HLSL takes 32 bits only and would round silently; \
                 compose for f32 instead",
                "GLSL ES 3.10 cannot take f64: OpenGL ES has no 64-bit floating point type; compose for f32 instead",
            ]
        );
    }

    #[test]
    fn the_value_of_a_feature_changes_the_translation() {
        let shader = image(Precision::F32);
        let text = |features| match translate(&shader, Target::Glsl430, &features).expect("it is f32") {
            Translation::Text(text) => text,
            Translation::Words(_) => panic!("GLSL is a text"),
        };
        let all = Features::all(5);
        let without = Features { max_depth: 7, ..all };
        assert_ne!(text(all), text(without));
    }
}
