//! What is refused, and how.

mod misuse;
