//! What the module exports: buffers for what is asked and answered, and the call between them.
//!
//! The script writes a request (JSON, UTF-8) where `input(length)` points to, calls `answer()`,
//! and reads the `words` (JSON, UTF-8) and the `numbers` (f64) of the answer; both stay until
//! the next call. Where the call traps, `words` say why, and the module is to be made anew.

// Their names are for the script; each is the only one of its name.
#![allow(unsafe_code)]

use std::cell::RefCell;
use std::panic::PanicHookInfo;
use std::sync::Once;

use crate::engine::{Answer, Engine};

thread_local! {
    static ENGINE: RefCell<Engine> = RefCell::default();
    static INPUT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static ANSWER: RefCell<Answer> = RefCell::default();
}

static HOOK: Once = Once::new();

/// Where a request of a number of bytes is to be written.
#[unsafe(no_mangle)]
pub extern "C" fn input(length: usize) -> *mut u8 {
    INPUT.with_borrow_mut(|input| {
        input.clear();
        input.resize(length, 0);
        input.as_mut_ptr()
    })
}

/// Answers the request.
#[unsafe(no_mangle)]
pub extern "C" fn answer() {
    HOOK.call_once(|| std::panic::set_hook(Box::new(tell)));
    let input = INPUT.take();
    let answer = ENGINE.with_borrow_mut(|engine| engine.answer(&input));
    ANSWER.set(answer);
}

/// Where the words of the answer are.
#[unsafe(no_mangle)]
pub extern "C" fn words() -> *const u8 {
    ANSWER.with_borrow(|answer| answer.words.as_ptr())
}

/// How many bytes they have.
#[unsafe(no_mangle)]
pub extern "C" fn words_length() -> usize {
    ANSWER.with_borrow(|answer| answer.words.len())
}

/// Where the numbers of the answer are.
#[unsafe(no_mangle)]
pub extern "C" fn numbers() -> *const f64 {
    ANSWER.with_borrow(|answer| answer.numbers.as_ptr())
}

/// How many numbers there are.
#[unsafe(no_mangle)]
pub extern "C" fn numbers_length() -> usize {
    ANSWER.with_borrow(|answer| answer.numbers.len())
}

/// Leaves the words of a panic as the answer: the call itself does not come back.
fn tell(panic: &PanicHookInfo) {
    ANSWER.set(Answer::error(&format!("the engine failed: {panic}")));
}
