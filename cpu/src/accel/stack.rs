//! The traversal stack: the nodes that wait to be visited.

/// Number of entries for which the stack has room, more than a traversal can need. A visit removes one entry and adds
/// at most 16, so a level of the tree adds at most 15. There are at most 45 levels: 16 that the builder splits by area,
/// 28 in which it halves at most 2^32 objects until at most 16 are left, and one more. So 1 + 15 * 45 = 676 entries
/// suffice.
pub const MOST_PENDING: usize = 1024;

/// A stack of nodes: the index of each node, and the lambda at which the ray enters its box. The traversal stores the
/// number of entries, `depth`. The stack is reused for all rays, because clearing it would cost more than a visit.
#[derive(Clone, Debug)]
pub struct Stack([(u32, f32); MOST_PENDING]);

impl Stack {
    /// A stack without entries.
    pub const EMPTY: Self = Self([(0, 0.0); MOST_PENDING]);

    /// Adds a node among the entries from index `first` on, which stay sorted by distance, so that the nearest is
    /// popped first. Increments `depth`.
    #[inline(always)]
    pub(crate) fn push_sorted(&mut self, depth: &mut usize, first: usize, entry: (u32, f32)) {
        debug_assert!(*depth < MOST_PENDING, "a tree is deeper than `MOST_PENDING` assumes");
        // The minimum tells the compiler that every index is valid.
        let mut place = (*depth).min(MOST_PENDING - 1);
        while place > first && self.0[place - 1].1 < entry.1 {
            self.0[place] = self.0[place - 1];
            place -= 1;
        }
        self.0[place] = entry;
        *depth += 1;
    }

    /// Removes and returns the last entry, and decrements `depth`, which must not be 0.
    #[inline(always)]
    pub(crate) fn pop(&self, depth: &mut usize) -> (u32, f32) {
        debug_assert!(*depth > 0);
        *depth -= 1;
        self.0[*depth % MOST_PENDING]
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
