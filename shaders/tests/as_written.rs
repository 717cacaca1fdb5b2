//! Reads the SPIR-V of every kernel, and looks for arithmetic that a driver may rewrite.

use std::collections::BTreeSet;

use rspirv::binary::Disassemble;
use rspirv::dr::{Instruction, Module, Operand, load_words};
use rspirv::spirv::GlslStd450Op::{Ceil, FAbs, FClamp, FMax, FMin, FSign, Floor, Sqrt, Trunc};
use rspirv::spirv::{Decoration, Op, Word};
use shaders::as_written::{DECORATED, spirv};
use shaders::module::MODULES;
use shaders::{Composition, Features, Library, Precision};

/// Instructions whose results have a floating-point type, but that are no arithmetic. Any other is arithmetic here, so
/// that one which [`DECORATED`] lacks is noticed.
const NOT_ARITHMETIC: [Op; 17] = [
    Op::AccessChain,
    Op::Bitcast,
    Op::CompositeConstruct,
    Op::CompositeExtract,
    Op::CompositeInsert,
    Op::ConvertSToF,
    Op::ConvertUToF,
    Op::CopyObject,
    // It rounds, but once, and nothing can be contracted with it.
    Op::FConvert,
    Op::Function,
    Op::FunctionCall,
    Op::FunctionParameter,
    Op::Load,
    Op::Phi,
    Op::Select,
    Op::Undef,
    Op::VectorShuffle,
];

/// Returns the instructions of floating-point arithmetic in `module` that are not decorated.
fn not_decorated(module: &Module) -> Vec<String> {
    let decorated: BTreeSet<_> = module
        .annotations
        .iter()
        .filter(|one| one.operands.get(1) == Some(&Operand::Decoration(Decoration::NoContraction)))
        .map(|one| one.operands[0].unwrap_id_ref())
        .collect();
    let types = &module.types_global_values;
    let definition = |id: Word| types.iter().find(|one| one.result_id == Some(id));
    let is_float = |id: Word| {
        let mut inner = definition(id);
        while let Some(Op::TypeVector | Op::TypeMatrix) = inner.map(|one| one.class.opcode) {
            inner = inner.and_then(|one| definition(one.operands[0].unwrap_id_ref()));
        }
        inner.is_some_and(|one| one.class.opcode == Op::TypeFloat)
    };
    // The instructions of the extended set that kernels may use: the root, and functions that round nothing.
    let extended = [FAbs, FSign, Floor, Ceil, Trunc, Sqrt, FClamp, FMin, FMax].map(|one| one as Word);
    let rounds = |one: &Instruction| match one.class.opcode {
        Op::ExtInst => !extended.contains(&one.operands[1].unwrap_literal_ext_inst_integer()),
        opcode => !NOT_ARITHMETIC.contains(&opcode),
    };
    let is_decorated = |one: &Instruction| one.result_id.is_some_and(|id| decorated.contains(&id));
    let is_missing = |one: &&Instruction| one.result_type.is_some_and(is_float) && rounds(one) && !is_decorated(one);
    let functions = module.functions.iter().flat_map(|function| function.all_inst_iter());
    functions.filter(is_missing).map(Disassemble::disassemble).collect()
}

/// Returns the SPIR-V of a kernel.
fn spirv_module(composition: &Composition) -> Module {
    let shader = composition.validate().unwrap_or_else(|error| panic!("{error}"));
    let constants = Features::all(5).constants();
    let has = |name: &str| shader.module.overrides.iter().any(|(_, constant)| constant.name.as_deref() == Some(name));
    let constants: Vec<_> = constants.into_iter().filter(|(name, _)| has(name)).collect();
    let passed = spirv(&shader, &constants).unwrap_or_else(|error| panic!("{}: {error}", composition.root()));
    assert_eq!(passed.workgroup_size, [64, 1, 1]);
    load_words(passed.words).expect("naga writes valid words")
}

#[test]
fn every_floating_point_result_of_every_kernel_is_decorated() {
    let (mut kernels, mut decorations) = (0, 0);
    for kernel in MODULES.iter().filter(|module| module.name.starts_with("kernels/")) {
        for precision in Precision::ALL {
            for library in [Library::standard(), Library::standard().in_hierarchy()] {
                let composition = library.compose(kernel.name, precision).expect("it exists");
                if composition.validate().is_ok_and(|shader| shader.entry_points().is_empty()) {
                    continue;
                }
                let module = spirv_module(&composition);
                assert_eq!(not_decorated(&module), Vec::<String>::new(), "{} in {precision}", kernel.name);
                kernels += 1;
                decorations += module.annotations.len();
            }
        }
    }
    println!("{kernels} kernels, {decorations} decorations of all kinds");
    assert!(kernels > 40 && decorations > 5_000, "{kernels} kernels, {decorations} decorations");
}

#[test]
fn each_decoration_that_is_left_out_is_noticed() {
    let composition = Library::standard().compose("kernels/exact_sphere", Precision::F64).expect("it exists");
    let whole = spirv_module(&composition);
    let of_arithmetic = |one: &Instruction| one.operands.contains(&Operand::Decoration(Decoration::NoContraction));
    let places: Vec<_> =
        (0..whole.annotations.len()).filter(|place| of_arithmetic(&whole.annotations[*place])).collect();
    for place in &places {
        let mut without = whole.clone();
        without.annotations.remove(*place);
        assert_eq!(not_decorated(&without).len(), 1);
    }
    println!("{} decorations, each is needed", places.len());
    assert!(places.len() > 100);
}

#[test]
fn every_decorated_instruction_is_decorated_in_the_words() {
    // The arithmetic that the kernels do not use.
    let text = "@group(0) @binding(0) var<storage, read_write> x: array<mat2x2<f32>, 3>;
        @compute @workgroup_size(1) fn kernel() {
            let m = x[1] * x[2] * x[0][0][1];
            let v = m * x[0][1] + x[0][0] * m + x[0][0] * x[1][0][1];
            let r = (v.x % x[1][1][1]) / dot(v, x[2][0]) - v.y * v.x;
            x[0] = m;
            x[1] = mat2x2<f32>(v, -v * r);
        }";
    let composition = Composition::of_text(text.to_owned(), Precision::F32);
    let shader = composition.validate().unwrap_or_else(|error| panic!("{error}"));
    let module = load_words(spirv(&shader, &[]).expect("it is valid").words).expect("naga writes valid words");
    assert_eq!(not_decorated(&module), Vec::<String>::new());
    let used: BTreeSet<_> = module.all_inst_iter().map(|one| one.class.opcode as Word).collect();
    // naga writes no outer product and no FMod.
    let unused: Vec<_> = DECORATED.iter().filter(|(op, _)| !used.contains(&(*op as Word))).map(|(op, _)| *op).collect();
    assert_eq!(unused, [Op::FMod, Op::OuterProduct]);
}
