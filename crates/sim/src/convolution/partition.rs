//! How the past is cut into blocks, and what that takes in memory.

/// Steps whose inputs are summed one by one.
pub const FIRST_BLOCK: usize = 64;

/// Numbers that a sum takes at once, enough for the processor to work in parallel; a block
/// has a multiple of them.
pub(super) const LANES: usize = 8;

/// Blocks of a level in one of the next.
pub(super) const RATIO: usize = 8;

/// A level is worth its transforms if the kernel has this many of its blocks.
const LEAST_BLOCKS: usize = 4;

/// Bytes of a number.
const REAL: f64 = 8.0;

/// Numbers that the plans of a level's transforms hold, and the buffers of the largest
/// level, for each step of a block.
const PLANS: f64 = 16.0;
const BUFFERS: f64 = 16.0;

/// Length of a block, and how many of them of the kernel are kept, of each level for
/// responses of so many taps.
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

/// What [`super::Kernels`] take, bytes: responses between so many sites, each of so
/// many taps.
pub fn kernels_memory(sites: usize, taps: f64) -> f64 {
    let pairs = (sites as f64).powi(2);
    let of_level = |(block, partitions): (usize, usize)| {
        let (block, partitions) = (block as f64, partitions as f64);
        pairs * partitions * 2.0 * block + PLANS * block
    };
    let levels: f64 = partitions(whole(taps)).map(of_level).sum();
    REAL * (levels + pairs * (FIRST_BLOCK + LANES) as f64)
}

/// What a [`super::Convolution`] takes, bytes: the past of so many steps at so many sites,
/// in one plane or two, with kernels of so many taps.
pub fn convolution_memory(sites: usize, planes: usize, taps: f64, steps: f64) -> f64 {
    let channels = (planes * sites) as f64;
    let mut of_channel = steps + FIRST_BLOCK as f64;
    let mut largest = 0.0;
    for (block, _) in partitions(whole(taps)) {
        largest = block as f64;
        of_channel += largest + RATIO as f64 * 2.0 * largest;
    }
    // The blocks of the highest level are all kept.
    of_channel += (steps / largest).ceil() * 2.0 * largest;
    REAL * (channels * of_channel + BUFFERS * largest)
}

/// Taps as a count; more than any machine holds are as many as that.
fn whole(taps: f64) -> usize {
    taps.min(1e15).ceil() as usize
}
