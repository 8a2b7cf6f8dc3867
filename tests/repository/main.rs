//! The repository itself: its structure, its dependencies, its front page and its guide.

mod dependencies;
mod front;
mod guide;
mod layout;
mod names;
mod snippets;
mod structure;
mod words;

#[allow(dead_code, reason = "other test programs use more of it")]
#[path = "../support/mod.rs"]
mod support;
