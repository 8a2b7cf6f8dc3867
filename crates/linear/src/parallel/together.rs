//! The loops over all cores of this machine.

use rayon::prelude::*;

/// Threads that loops are shared among.
pub fn threads() -> usize {
    rayon::current_num_threads()
}

/// The `answer` for every number below `count`; a thread takes at least `at_once` of them at a
/// time.
pub fn map<Answer: Send>(
    count: usize,
    at_once: usize,
    answer: impl Fn(usize) -> Answer + Sync + Send,
) -> Vec<Answer> {
    let numbers = (0..count).into_par_iter().with_min_len(at_once);
    numbers.map(answer).collect()
}

/// What `answer` says of each item.
pub fn each<Item: Send, Answer: Send>(
    items: Vec<Item>,
    answer: impl Fn(Item) -> Answer + Sync + Send,
) -> Vec<Answer> {
    items.into_par_iter().map(answer).collect()
}

/// As [`map`], the answers joined, neighbours with neighbours, the earlier first.
pub fn reduce<Answer: Send>(
    count: usize,
    at_once: usize,
    answer: impl Fn(usize) -> Answer + Sync + Send,
    nothing: impl Fn() -> Answer + Sync + Send,
    join: impl Fn(Answer, Answer) -> Answer + Sync + Send,
) -> Answer {
    let numbers = (0..count).into_par_iter().with_min_len(at_once);
    numbers.map(answer).reduce(nothing, join)
}

/// Fills every chunk of `size` items, given with its number; a thread takes at least `at_once` of
/// them with its own scratch.
pub fn chunks_mut<Item: Send, Scratch>(
    items: &mut [Item],
    (size, at_once): (usize, usize),
    scratch: impl Fn() -> Scratch + Sync + Send,
    fill: impl Fn(&mut Scratch, (usize, &mut [Item])) + Sync + Send,
) {
    let chunks = items.par_chunks_mut(size).enumerate();
    chunks.with_min_len(at_once).for_each_init(scratch, fill);
}

/// Works once on every thread, on all at the same time.
pub fn on_each_thread(work: impl Fn() + Sync) {
    rayon::broadcast(|_| work());
}
