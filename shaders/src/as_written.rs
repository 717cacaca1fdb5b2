//! Writes SPIR-V whose arithmetic a driver must not contract or reorder.
//!
//! WGSL lets a driver calculate as with real numbers: it may contract `a * b + c` into one operation, replace
//! `(a + b) - a` by `b`, or factor out products. SPIR-V has a decoration that forbids this for one result,
//! `NoContraction` (SPIR-V 1.6, section 3.20). naga cannot write it, so [`spirv`] adds it to naga's words.

use naga::back::spv::{BindingInfo, Options, PipelineOptions, WriterFlags, write_vec};
use naga::proc::{BoundsCheckPolicies, BoundsCheckPolicy};
use naga::{AddressSpace, GlobalVariable, ResourceBinding, ShaderStage};
use rspirv::binary::Assemble;
use rspirv::dr::{Instruction, Operand, load_words};
use rspirv::spirv::{Decoration, Op};

use crate::translate::{failed, with_constants};
use crate::{Error, Target, Validated};

/// The instructions that calculate with floating-point numbers, each with what a driver makes of it without the
/// decoration.
///
/// Not in this list are instructions that round nothing, conversions, which round once, and those of the extended set
/// such as `Sqrt`, whose accuracy is the driver's. On `Fma` of that set the decoration demands a single rounding.
pub const DECORATED: [(Op, &str); 14] = [
    (Op::FNegate, "-(a - b) becomes b - a, which differs in the sign of zero"),
    (Op::FAdd, "(a + b) - a becomes b, and a * b + c one operation"),
    (Op::FSub, "a - (a - b) becomes b, and a * b - c one operation"),
    (Op::FMul, "a * b + a * c becomes a * (b + c), and sqrt(a) * sqrt(a) becomes a"),
    (Op::FDiv, "a / b becomes a * (1 / b), and a / a becomes 1"),
    (Op::FRem, "becomes a quotient and a product, which are then contracted"),
    (Op::FMod, "becomes a quotient and a product, which are then contracted"),
    (Op::VectorTimesScalar, "its products are contracted with sums"),
    (Op::MatrixTimesScalar, "its products are contracted with sums"),
    (Op::VectorTimesMatrix, "its sums of products are contracted and ordered anew"),
    (Op::MatrixTimesVector, "its sums of products are contracted and ordered anew"),
    (Op::MatrixTimesMatrix, "its sums of products are contracted and ordered anew"),
    (Op::OuterProduct, "its products are contracted with sums"),
    (Op::Dot, "its sum of products is contracted and ordered anew"),
];

/// A SPIR-V module with one entry point, for a Vulkan driver.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpirV {
    /// The words of the module.
    pub words: Vec<u32>,
    /// The name of the entry point.
    pub entry: String,
    /// Number of invocations of a workgroup in each dimension.
    pub workgroup_size: [u32; 3],
    /// Number of bytes that the invocations of a workgroup share.
    pub workgroup_bytes: u64,
}

/// Writes the only entry point of `shader` with every result of [`DECORATED`] decorated. Constants of the shader that
/// `constants` names get these values.
///
/// The buffers are numbered from 0 in the order of their numbers, as wgpu numbers them. An index out of range becomes
/// the last one, because wgpu adds no checks to words that are passed through.
///
/// # Errors
/// [`Error::Write`] if `shader` does not have exactly one entry point, binds something else than storage buffers, does
/// not declare one of the constants, or cannot be written by naga.
pub fn spirv(shader: &Validated, constants: &[(&str, f64)]) -> Result<SpirV, Error> {
    let failed = failed(Target::SpirV);
    let is_bound_otherwise = |variable: &GlobalVariable| {
        variable.binding.is_some() && !matches!(variable.space, AddressSpace::Storage { .. })
    };
    if shader.module.global_variables.iter().any(|(_, variable)| is_bound_otherwise(variable)) {
        return Err(failed("it binds something else than storage buffers".to_owned()));
    }
    let constants = constants.iter().map(|(name, value)| ((*name).to_owned(), *value));
    let (module, info, entry) = with_constants(shader, constants.collect()).map_err(&failed)?;
    let mut numbers: Vec<_> = shader.bindings().map(|binding| binding.number).collect();
    numbers.sort_unstable();
    let place = |(number, binding): (u32, u32)| {
        let info = BindingInfo { descriptor_set: 0, binding, binding_array_size: None };
        (ResourceBinding { group: 0, binding: number }, info)
    };
    let bounds_check_policies = BoundsCheckPolicies {
        index: BoundsCheckPolicy::Restrict,
        buffer: BoundsCheckPolicy::Restrict,
        image_load: BoundsCheckPolicy::Restrict,
        binding_array: BoundsCheckPolicy::Restrict,
    };
    let options = Options {
        flags: WriterFlags::empty(),
        fake_missing_bindings: false,
        binding_map: numbers.into_iter().zip(0..).map(place).collect(),
        bounds_check_policies,
        ..Options::default()
    };
    let stage = PipelineOptions { shader_stage: ShaderStage::Compute, entry_point: entry.to_owned() };
    let words = write_vec(&module, &info, &options, Some(&stage)).map_err(|error| failed(error.to_string()))?;
    let words = decorated(&words).map_err(failed)?;
    let workgroup_size = module.entry_points.iter().find(|known| known.name == entry).map(|known| known.workgroup_size);
    let shared = module.global_variables.iter().filter(|(_, variable)| variable.space == AddressSpace::WorkGroup);
    let bytes = |variable: &GlobalVariable| u64::from(module.types[variable.ty].inner.size(module.to_ctx()));
    let workgroup_bytes = shared.map(|(_, variable)| bytes(variable)).sum();
    let workgroup_size = workgroup_size.unwrap_or_default();
    Ok(SpirV { words, entry: entry.to_owned(), workgroup_size, workgroup_bytes })
}

/// Returns the module in `words` with `NoContraction` on every result of [`DECORATED`].
fn decorated(words: &[u32]) -> Result<Vec<u32>, String> {
    let mut module = load_words(words).map_err(|error| error.to_string())?;
    let is_decorated = |instruction: &&Instruction| DECORATED.iter().any(|(op, _)| *op == instruction.class.opcode);
    let results: Vec<_> =
        module.all_inst_iter().filter(is_decorated).filter_map(|instruction| instruction.result_id).collect();
    module.annotations.extend(results.into_iter().map(|result| {
        let operands = vec![Operand::IdRef(result), Operand::Decoration(Decoration::NoContraction)];
        Instruction::new(Op::Decorate, None, None, operands)
    }));
    Ok(module.assemble())
}
