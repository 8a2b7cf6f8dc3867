//! How the past is cut into blocks.

/// Steps whose inputs are summed one by one.
pub const FIRST_BLOCK: usize = 64;

/// Numbers that a sum takes at once, enough for the processor to work in parallel; a block
/// has a multiple of them.
pub(super) const LANES: usize = 8;

/// Blocks of a level in one of the next.
pub(super) const RATIO: usize = 8;

/// A level is worth its transforms if the kernel has this many of its blocks.
const LEAST_BLOCKS: usize = 4;

/// Length of a block, and how many of them of the kernel are kept, of each level for responses of a
/// number of taps.
pub(super) fn partitions(longest: usize) -> impl Iterator<Item = (usize, usize)> {
    let is_last = move |block: usize| RATIO * LEAST_BLOCKS * block > longest;
    let blocks = std::iter::successors(Some(FIRST_BLOCK), move |&block| {
        (!is_last(block)).then_some(RATIO * block)
    });
    blocks.map(move |block| {
        let partitions = if is_last(block) {
            longest.div_ceil(block).max(1)
        } else {
            RATIO - 1
        };
        (block, partitions)
    })
}
