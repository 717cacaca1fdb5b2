//! Permutations that move the selected lanes to the front ("compress"). AVX2 has no instruction for this.

/// A permutation of the eight 32-bit halves of four lanes: the index of the half that moves to each place. AVX2 has no
/// instruction that permutes 64-bit lanes by a variable.
#[repr(align(32))]
pub struct Halves(pub [u32; 8]);

/// The permutation for each selection of lanes. The index has a bit for each lane, which is 1 if the lane is selected.
/// The halves of the selected lanes come first, in order.
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
