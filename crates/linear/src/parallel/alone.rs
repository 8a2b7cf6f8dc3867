//! The same loops where there is one thread.

/// Threads that loops are shared among.
pub fn threads() -> usize {
    1
}

/// What `answer` says of every number below `count`.
pub fn map<Answer>(count: usize, _at_once: usize, answer: impl Fn(usize) -> Answer) -> Vec<Answer> {
    (0..count).map(answer).collect()
}

/// What `answer` says of each item.
pub fn each<Item, Answer>(items: Vec<Item>, answer: impl Fn(Item) -> Answer) -> Vec<Answer> {
    items.into_iter().map(answer).collect()
}

/// As [`map`], the answers joined, the earlier first.
pub fn reduce<Answer>(
    count: usize,
    _at_once: usize,
    answer: impl Fn(usize) -> Answer,
    nothing: impl Fn() -> Answer,
    join: impl Fn(Answer, Answer) -> Answer,
) -> Answer {
    (0..count).map(answer).fold(nothing(), join)
}

/// Fills every chunk of `size` items, given with its number, with one scratch.
pub fn chunks_mut<Item, Scratch>(
    items: &mut [Item],
    (size, _at_once): (usize, usize),
    scratch: impl Fn() -> Scratch,
    fill: impl Fn(&mut Scratch, (usize, &mut [Item])),
) {
    let mut scratch = scratch();
    let chunks = items.chunks_mut(size).enumerate();
    chunks.for_each(|chunk| fill(&mut scratch, chunk));
}

/// Works once.
pub fn on_each_thread(work: impl Fn()) {
    work();
}

/// Answer of work that others wait for.
pub fn apart<Answer: Send>(work: impl FnOnce() -> Answer + Send) -> Option<Answer> {
    Some(work())
}
