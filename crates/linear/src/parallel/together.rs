//! The loops over all cores of this machine.

use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

/// Threads that loops are shared among.
pub fn threads() -> usize {
    rayon::current_num_threads()
}

/// Calls `work` with every number below `count`. It is not generic: what rayon makes of a loop is
/// compiled once, and not for every loop again.
fn for_each(count: usize, at_once: usize, work: &(dyn Fn(usize) + Sync)) {
    let numbers = (0..count).into_par_iter().with_min_len(at_once);
    numbers.for_each(work);
}

/// What one thread puts down for another to take.
struct Place<Item>(Mutex<Option<Item>>);

impl<Item> Place<Item> {
    fn of(item: Option<Item>) -> Self {
        Self(Mutex::new(item))
    }

    fn put(&self, item: Item) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(item);
    }

    /// What is there; a panic where nothing is.
    fn take(&self) -> Item {
        let mut place = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        place
            .take()
            .expect("each place is filled once, and emptied once")
    }
}

/// The `answer` for every number below `count`; a thread takes at least `at_once` of them at a
/// time.
pub fn map<Answer: Send>(
    count: usize,
    at_once: usize,
    answer: impl Fn(usize) -> Answer + Sync + Send,
) -> Vec<Answer> {
    let places: Vec<Place<Answer>> = (0..count).map(|_| Place::of(None)).collect();
    for_each(count, at_once, &|number| places[number].put(answer(number)));
    places.iter().map(Place::take).collect()
}

/// What `answer` says of each item.
pub fn each<Item: Send, Answer: Send>(
    items: Vec<Item>,
    answer: impl Fn(Item) -> Answer + Sync + Send,
) -> Vec<Answer> {
    let items: Vec<Place<Item>> = (items.into_iter())
        .map(|item| Place::of(Some(item)))
        .collect();
    map(items.len(), 1, |number| answer(items[number].take()))
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

/// Answer of work whose own loops wait for no other work of these threads, on as many others; `None`
/// where the system gives no more threads. What others wait for has to be done so: a thread that
/// waits for a part of its work may else begin another piece, which then waits for that work.
pub fn apart<Answer: Send>(work: impl FnOnce() -> Answer + Send) -> Option<Answer> {
    let count = threads();
    std::thread::scope(|scope| {
        let begun = std::thread::Builder::new().spawn_scoped(scope, || {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build();
            Some(pool.ok()?.install(work))
        });
        begun.ok()?.join().ok()?
    })
}
