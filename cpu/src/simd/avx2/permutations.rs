//! The permutations that compress lanes, for which AVX2 has no instruction.

/// A number for each half of four lanes: AVX2 permutes only 32-bit lanes by a variable.
#[repr(align(32))]
pub struct Halves(pub [u32; 8]);

/// By the bits that select lanes: the halves of the selected lanes, in order.
pub static COMPRESSING: [Halves; 16] = {
    let mut table = [const { Halves([0; 8]) }; 16];
    let mut bits = 0;
    while bits < 16 {
        let (mut half, mut place) = (0, 0);
        while half < 8 {
            if bits >> (half / 2) & 1 == 1 {
                table[bits].0[place] = half as u32;
                place += 1;
            }
            half += 1;
        }
        bits += 1;
    }
    table
};
