//! Tables of permutations that compress and expand lanes, for which AVX2 has no instructions.

/// A number for each half of four lanes: AVX2 permutes only 32-bit lanes by a variable.
#[repr(align(32))]
pub struct Halves(pub [u32; 8]);

/// Added to the numbers of a selected lane. A permutation uses the lowest three bits alone, a blend the highest.
const SELECTED: u32 = 1 << 31;

/// By the bits that select lanes: the halves of the selected lanes, in order.
pub static COMPRESSING: [Halves; 16] = table(false);
/// By the bits that select lanes: in each half of a selected lane its place among them, and [`SELECTED`].
pub static EXPANDING: [Halves; 16] = table(true);

const fn table(is_expanding: bool) -> [Halves; 16] {
    let mut table = [const { Halves([0; 8]) }; 16];
    let mut bits = 0;
    while bits < 16 {
        let (mut half, mut place) = (0, 0);
        while half < 8 {
            if bits >> (half / 2) & 1 == 1 {
                let (at, number) = if is_expanding { (half, place as u32 + SELECTED) } else { (place, half as u32) };
                table[bits].0[at] = number;
                place += 1;
            }
            half += 1;
        }
        bits += 1;
    }
    table
}
