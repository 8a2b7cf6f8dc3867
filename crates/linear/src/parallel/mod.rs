//! Loops over all cores, whose answers are in the order of what they loop over, however many
//! cores there are. Without the feature `parallel` there is one: a browser's page has no other.
//!
//! ```
//! use linear::parallel;
//!
//! let cubes = parallel::map(5, 1, |number| number * number * number);
//! assert_eq!(cubes, [0, 1, 8, 27, 64]);
//! ```

#[cfg(not(feature = "parallel"))]
mod alone;
#[cfg(feature = "parallel")]
mod together;

#[cfg(not(feature = "parallel"))]
pub use alone::{apart, chunks_mut, each, map, on_each_thread, reduce, threads};
#[cfg(feature = "parallel")]
pub use together::{apart, chunks_mut, each, map, on_each_thread, reduce, threads};

#[cfg(test)]
mod tests {
    use super::*;

    /// A loop in it may begin no other turn of the outer loop, which would wait for the very work it is
    /// a part of.
    #[test]
    fn what_all_turns_of_a_loop_wait_for_is_done_apart() {
        let shared = std::sync::OnceLock::new();
        let sums = map(64, 1, |_| {
            let sum = || map(1000, 1, |number| number).into_iter().sum::<usize>();
            *shared.get_or_init(|| apart(sum))
        });
        assert_eq!(sums, [Some(499_500); 64]);
    }

    #[test]
    fn answers_are_in_the_order_of_what_is_asked() {
        let squares: Vec<usize> = (0..1000).map(|number| number * number).collect();
        assert_eq!(map(1000, 7, |number| number * number), squares);
        assert_eq!(
            each((0..1000).collect(), |number: usize| number * number),
            squares
        );
        let text = |number: usize| number.to_string();
        let joined: String = (0..1000).map(text).collect();
        assert_eq!(
            reduce(1000, 7, text, String::new, |one, other| one + &other),
            joined
        );
        let mut numbers = vec![0; 1001];
        chunks_mut(
            &mut numbers,
            (2, 3),
            || 0,
            |_, (place, chunk)| chunk.fill(place),
        );
        assert!(
            numbers
                .iter()
                .enumerate()
                .all(|(index, place)| index / 2 == *place)
        );
    }

    #[test]
    fn every_thread_works_once() {
        let count = std::sync::atomic::AtomicUsize::new(0);
        on_each_thread(|| {
            count.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        });
        assert_eq!(count.into_inner(), threads());
    }
}
