//! What is refused, and what is taken over from an earlier string.

mod earlier;
mod misuse;
