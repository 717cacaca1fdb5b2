//! The traversal stack: the nodes that wait to be visited.

/// Most entries during a traversal: 15 for each level, and the builder bounds the levels.
pub const CAPACITY: usize = 512;

/// Indices and distances of nodes. The traversal keeps the number of entries. The stack is kept between rays, because
/// clearing it would cost more than a visit.
#[derive(Clone, Debug)]
pub struct Stack([(u32, f32); CAPACITY]);

impl Stack {
    /// No entries.
    pub const EMPTY: Self = Self([(0, 0.0); CAPACITY]);

    /// Pushes a node below those entries from `first` on that are nearer, so that the nearest is popped first.
    #[inline(always)]
    pub fn push_sorted(&mut self, depth: &mut usize, first: usize, entry: (u32, f32)) {
        let mut place = (*depth).min(CAPACITY - 1);
        while place > first && self.0[place - 1].1 < entry.1 {
            self.0[place] = self.0[place - 1];
            place -= 1;
        }
        self.0[place] = entry;
        *depth += 1;
    }

    /// Removes and returns the entry on top of a stack that is not empty.
    #[inline(always)]
    pub fn pop(&self, depth: &mut usize) -> (u32, f32) {
        *depth -= 1;
        self.0[*depth % CAPACITY]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_child_of_a_node_is_on_top_of_earlier_entries() {
        let (mut stack, mut depth) = (Stack::EMPTY, 0);
        stack.push_sorted(&mut depth, 0, (1, 0.5));
        let first = depth;
        for entry in [(2, 3.0), (3, 1.0), (4, 2.0), (5, 1.0)] {
            stack.push_sorted(&mut depth, first, entry);
        }
        assert_eq!(depth, 5);
        assert_eq!(stack.0[..depth], [(1, 0.5), (2, 3.0), (4, 2.0), (3, 1.0), (5, 1.0)]);
    }
}
