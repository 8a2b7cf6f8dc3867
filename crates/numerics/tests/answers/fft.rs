//! A thread keeps its last plans: at most half a million samples in each direction.

use std::sync::Arc;

use numerics::fft::forward;

const MOST_KEPT: usize = 1 << 19;

#[test]
fn the_last_plans_are_kept_and_no_more() {
    let (short, longer) = (forward(100), forward(200));
    assert!(Arc::ptr_eq(&short, &forward(100)));
    // What was asked for last stays.
    let long = forward(MOST_KEPT - 100);
    assert!(Arc::ptr_eq(&short, &forward(100)));
    assert!(Arc::ptr_eq(&long, &forward(MOST_KEPT - 100)));
    assert!(!Arc::ptr_eq(&longer, &forward(200)));
    // What is longer than all is not kept.
    assert!(!Arc::ptr_eq(
        &forward(MOST_KEPT + 1),
        &forward(MOST_KEPT + 1)
    ));
}
