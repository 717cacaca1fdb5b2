//! Lanes put together, put apart and selected by bits, which AVX2 has no instructions for: tables of permutations.

/// A number for each half of four lanes: the set has no permutation of whole lanes by a variable.
#[repr(align(32))]
pub struct Halves(pub [u32; 8]);

/// By the bits that select lanes: the selected ones in order.
pub static COMPRESSED: [Halves; 16] = tables().0;
/// By the bits that select lanes: in each selected one its place among them.
pub static EXPANDED: [Halves; 16] = tables().1;
/// By the bits that select lanes: all ones in these.
pub static SELECTED: [Halves; 16] = tables().2;

const fn tables() -> ([Halves; 16], [Halves; 16], [Halves; 16]) {
    let (mut compressed, mut expanded, mut selected) =
        ([const { Halves([0; 8]) }; 16], [const { Halves([0; 8]) }; 16], [const { Halves([0; 8]) }; 16]);
    let mut bits = 0;
    while bits < 16 {
        let (mut lane, mut count) = (0, 0);
        while lane < 4 {
            if bits >> lane & 1 == 1 {
                let mut half = 0;
                while half < 2 {
                    compressed[bits].0[2 * count + half] = (2 * lane + half) as u32;
                    expanded[bits].0[2 * lane + half] = (2 * count + half) as u32;
                    selected[bits].0[2 * lane + half] = u32::MAX;
                    half += 1;
                }
                count += 1;
            }
            lane += 1;
        }
        bits += 1;
    }
    (compressed, expanded, selected)
}
