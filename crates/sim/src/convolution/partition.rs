//! How the past is cut into blocks.

/// Steps whose inputs are summed one by one.
pub const FIRST_BLOCK: usize = 64;

/// Numbers that a sum takes at once, enough for the processor to work in parallel; a block
/// has a multiple of them.
pub(super) const LANES: usize = 8;

/// Numbers that the taps of a first block take, with a lane of zeros before them.
pub(super) const RECENT: usize = LANES + FIRST_BLOCK;

/// From this many sites on, products of spectra, whose number grows as the square of that of the
/// sites, take longer than transforms: more levels, which save products, are worth theirs.
const MANY_SITES: usize = 8;

/// How the kernels of all pairs of sites are cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Partition {
    /// Blocks of a level in one of the next.
    pub ratio: usize,
    /// A level is worth its transforms if the kernel has this many of its blocks.
    least_blocks: usize,
}

impl Partition {
    /// That of a number of sites.
    pub fn of(sites: usize) -> Self {
        let [ratio, least_blocks] = if sites < MANY_SITES { [8, 4] } else { [4, 2] };
        Self {
            ratio,
            least_blocks,
        }
    }

    /// Length of a block, and how many of them of the kernel are kept, of each level for responses
    /// of a number of taps.
    pub fn levels(self, longest: usize) -> impl Iterator<Item = (usize, usize)> {
        let Self {
            ratio,
            least_blocks,
        } = self;
        let is_last = move |block: usize| ratio * least_blocks * block > longest;
        let blocks = std::iter::successors(Some(FIRST_BLOCK), move |&block| {
            (!is_last(block)).then_some(ratio * block)
        });
        blocks.map(move |block| {
            let partitions = if is_last(block) {
                longest.div_ceil(block).max(1)
            } else {
                ratio - 1
            };
            (block, partitions)
        })
    }
}
