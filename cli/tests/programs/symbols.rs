//! The evaluated programs call no function of the system's mathematical library whose last bits differ between systems.

use std::collections::BTreeSet;

use object::{Object, ObjectSymbol};

use crate::bench::PROGRAMS;

/// The names of functions that are not correctly rounded in every library. Names that end in `f` are for `f32`.
const INACCURATE: [&str; 25] = [
    "acos", "acosh", "asin", "asinh", "atan", "atan2", "atanh", "cbrt", "cos", "cosh", "exp", "exp2", "expm1", "hypot",
    "log", "log10", "log1p", "log2", "pow", "sin", "sincos", "sinh", "tan", "tanh", "tgamma",
];

/// Returns the functions that a program takes from other libraries.
fn imports(program: &str) -> BTreeSet<String> {
    let bytes = std::fs::read(program).expect("the program was built");
    let file = object::File::parse(&*bytes).expect("the program is an ELF file");
    let undefined = file.dynamic_symbols().filter(|symbol| symbol.is_undefined());
    undefined.filter_map(|symbol| symbol.name().ok().map(str::to_owned)).collect()
}

/// Whether a function may give other bits with another library of C.
fn is_inaccurate(name: &str) -> bool {
    INACCURATE.contains(&name.strip_suffix('f').unwrap_or(name)) || INACCURATE.contains(&name)
}

#[test]
fn no_function_of_the_mathematical_library_is_called() {
    for program in PROGRAMS {
        let imports = imports(program);
        assert!(imports.contains("write") && imports.contains("malloc"), "{imports:?}");
        let inaccurate: Vec<_> = imports.iter().filter(|name| is_inaccurate(name)).collect();
        assert!(inaccurate.is_empty(), "{program} calls {inaccurate:?}");
    }
}

#[test]
fn inaccurate_functions_are_known_by_name() {
    assert!(["pow", "tan", "powf", "sincosf", "hypot"].iter().all(|name| is_inaccurate(name)));
    // One rounding, in every library.
    assert!(!["fma", "sqrt", "floor", "write", "f"].iter().any(|name| is_inaccurate(name)));
}
