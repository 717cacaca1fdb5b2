//! Nodes of the tree that wait to be visited.

/// Most nodes that wait during a traversal: 15 a level, and the builder bounds the levels.
pub const MOST: usize = 512;

/// Nodes that wait, with their distances; kept between rays, for clearing it would cost more than a visit.
#[derive(Clone, Debug)]
pub struct Stack(pub(super) Waiting);

/// Their indices and distances; how many, a traversal counts.
pub type Waiting = [(u32, f32); MOST];

impl Stack {
    /// Nothing waits.
    pub const EMPTY: Self = Self([(0, 0.0); MOST]);
}

/// Puts a node on top of `waiting` others, but below those from `first` on that are nearer: so the nearest is taken
/// first.
#[inline(always)]
pub fn wait(stack: &mut Waiting, waiting: &mut usize, first: usize, entry: (u32, f32)) {
    let mut place = (*waiting).min(MOST - 1);
    while place > first && stack[place - 1].1 < entry.1 {
        stack[place] = stack[place - 1];
        place -= 1;
    }
    stack[place] = entry;
    *waiting += 1;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_of_a_node_is_on_top_of_what_waited_before() {
        let (Stack(mut stack), mut waiting) = (Stack::EMPTY, 0);
        wait(&mut stack, &mut waiting, 0, (1, 0.5));
        let first = waiting;
        for entry in [(2, 3.0), (3, 1.0), (4, 2.0), (5, 1.0)] {
            wait(&mut stack, &mut waiting, first, entry);
        }
        assert_eq!(waiting, 5);
        assert_eq!(stack[..waiting], [(1, 0.5), (2, 3.0), (4, 2.0), (3, 1.0), (5, 1.0)]);
    }
}
