//! The cases of the camera ray of a pixel.

use super::special::{Row, once_in, pairs, rows};

/// Returns a camera, a row, a column and an offset for each case.
pub fn cases(count: usize, seed: u64) -> Vec<f64> {
    let edges = |rows: &mut Row| {
        for (number, other) in pairs() {
            for place in [[0.0, 0.0, -0.5, -0.5], [0.0, 1e9, 0.0, 0.5], [16_777_217.0, 3.0, 0.25, -0.0]] {
                rows.vector([number, 1.0, -10.0]).vector([other, -5.0, number]);
                rows.vector([other, 0.0, 1e-9]).vector([-0.0, number, 0.0]);
                rows.0.extend(place);
            }
        }
    };
    rows(count, seed, edges, |random, row| {
        for extent in [20.0, 20.0, 0.1, 0.1] {
            row.vector(random.cube(extent));
        }
        row.number(random.uniform(0.0, 4096.0).floor()).number(random.uniform(0.0, 4096.0).floor());
        let middle = once_in(random, 4.0);
        for _ in 0..2 {
            row.number(if middle { 0.0 } else { random.uniform(-0.5, 0.5) });
        }
    })
}
