//! The cases of the colour of a ray that hits no object.

use super::special::{DIRECTIONS, Row, any_size, direction, once_in, pairs, rows};

/// Returns two colours and a direction for each case.
pub fn cases(count: usize, seed: u64) -> Vec<f64> {
    let edges = |rows: &mut Row| {
        let colors = [[0.0; 3], [1.0; 3], [0.25, 0.5, 1.0], [5e-324, 1e-40, 0.1]];
        for dark in colors {
            for light in colors {
                for direction in DIRECTIONS {
                    rows.vector(dark).vector(light).vector(direction);
                }
                for (number, other) in pairs() {
                    rows.vector(dark).vector(light).vector([0.0, number, other]);
                }
            }
        }
    };
    rows(count, seed, edges, |random, row| {
        for _ in 0..6 {
            row.number(random.uniform(0.0, 1.0));
        }
        let size = if once_in(random, 4.0) { any_size(random, -18.0, 18.0) } else { 1.0 };
        row.vector(direction(random) * size);
    })
}
