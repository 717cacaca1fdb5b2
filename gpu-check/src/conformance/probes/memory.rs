//! Indices in range and out of range.

use crate::conformance::draft::Draft;
use crate::conformance::inputs::words;
use crate::conformance::probe::Probe;
use crate::conformance::reading::{Allowed, Kind};

/// Text for indices out of range.
const OUTSIDE: &str = "WGSL: out of range, a load gives any element of the variable or 0, and a store writes \
                       any element or nothing";

/// The content of the arrays and vectors of the programs.
const ELEMENTS: [u32; 4] = [11, 22, 33, 44];

pub fn probes() -> Vec<Probe> {
    let array = "var numbers = array<u32, 4>(11u, 22u, 33u, 44u);\n";
    let vector = "var numbers = vec4<u32>(11u, 22u, 33u, 44u);\n";
    let constant = "const NUMBERS = array<u32, 4>(11u, 22u, 33u, 44u);\n";
    let private = "var<private> numbers: array<u32, 4> = array<u32, 4>(11u, 22u, 33u, 44u);\n";
    vec![
        load("array-load", "numbers[a]", ["", array]),
        load("private-array-load", "numbers[a]", [private, ""]),
        load("constant-array-load", "NUMBERS[a]", [constant, ""]),
        load("vector-load", "numbers[a]", ["", vector]),
        store("array-store", STORE_ARRAY),
        store("vector-store", STORE_VECTOR),
        buffer(),
    ]
}

/// Indices of which half are in range.
fn indices() -> Vec<[u32; 1]> {
    let outside = [4, 5, 100, 0x7fff_ffff, 0x8000_0000, 0xffff_fffe];
    words::<1>(&outside).into_iter().enumerate().map(|(row, [a])| if row % 2 == 0 { [a % 4] } else { [a] }).collect()
}

fn load(name: &str, result: &'static str, [declarations, statements]: [&'static str; 2]) -> Probe {
    let at = |index: u32| ELEMENTS.get(index as usize).copied();
    Draft::new(name, result, indices(), move |[a]: [u32; 1]| at(a).unwrap_or(0))
        .code(declarations, statements)
        .rule(OUTSIDE)
        .rewriting("the last element", move |[a]| at(a.min(3)).unwrap_or(0))
        .reading("any element", Kind::Rewriting, move |[a]| match at(a) {
            Some(element) => Allowed::only(element),
            None => Allowed::any_of(ELEMENTS.into_iter().chain([0])),
        })
        .done()
}

/// A program that stores 1,000 at an index, and returns a number that shows where it is.
fn store(name: &str, statements: &'static str) -> Probe {
    let stored = |index: usize| {
        let mut numbers = ELEMENTS;
        if let Some(number) = numbers.get_mut(index) {
            *number = 1000;
        }
        numbers.into_iter().enumerate().map(|(place, number)| number * 100_u32.pow(place as u32)).sum::<u32>()
    };
    Draft::new(name, "numbers[0] + numbers[1] * 100u + numbers[2] * 10000u + numbers[3] * 1000000u", indices(), {
        move |[a]: [u32; 1]| stored(a as usize)
    })
    .code("", statements)
    .rule(OUTSIDE)
    .rewriting("the last element", move |[a]| stored(a.min(3) as usize))
    .reading("any element", Kind::Rewriting, move |[a]| match a {
        0..=3 => Allowed::only(stored(a as usize)),
        _ => Allowed::any_of((0..=4).map(stored)),
    })
    .done()
}

const STORE_ARRAY: &str = "var numbers = array<u32, 4>(11u, 22u, 33u, 44u);\nnumbers[a] = 1000u;\n";
const STORE_VECTOR: &str = "var numbers = vec4<u32>(11u, 22u, 33u, 44u);\nnumbers[a] = 1000u;\n";

/// A program that loads from the buffer of its inputs, at the index that each input gives.
fn buffer() -> Probe {
    let cases = indices();
    let all: Vec<u32> = cases.iter().map(|[a]| *a).collect();
    let at = move |index: u32| all.get(index as usize).copied();
    let (last, any) = (at.clone(), at.clone());
    Draft::new("buffer-load", "input[a]", cases.clone(), move |[a]: [u32; 1]| at(a).unwrap_or(0))
        .rule(OUTSIDE)
        .rewriting("the last element", {
            let count = cases.len() as u32;
            move |[a]| last(a.min(count - 1)).unwrap_or(0)
        })
        .reading("any element", Kind::Rewriting, move |[a]| match any(a) {
            Some(element) => Allowed::only(element),
            None => Allowed::any_of(cases.iter().map(|[a]| *a).chain([0])),
        })
        .done()
}
