//! The engine in a browser's page, compiled to WebAssembly: the cases of a sweep followed as
//! `sweep simulate` follows them, by the same crates.
//!
//! ```text
//! page's script ──JSON──> exports ──> request ──> engine ──> campaign, linear, sim
//!               <──JSON, numbers──────────────────┘
//! ```
//!
//! The script's side is `crates/sweep/src/page/engine.js`; what it may ask is in `request`.

mod engine;
mod exports;
mod opening;
mod request;

pub use engine::{Answer, Engine};
