//! A sweep file, the cases of its design, and how each of them is answered.
//!
//! ```text
//! my-sweep.toml ──> sweep_file  its keys, with those of its bases, and where each stands
//!                   plan     all of it in SI, or refused with its line
//!                    │
//!                  design    the cases: a grid, random points, a list
//!                    │
//!                  engine    linear systems built once ───────────────> crate `linear`
//!                    │       cases over all cores, each handed on ────> crate `sim`
//!                  records   what became of each, and the table of its columns
//!                  labels    the rows of `labels.csv`
//! ```
//!
//! [`Campaign`] is the way through all of it: opened from a sweep file, its method chosen where an
//! accuracy is asked for, its linear systems built by a `Recipe`, single cases followed to the end
//! of their time (`follow`), all of them run. The command line, Python and the page are thin over it.
//!
//! There is no equation here: the string is the business of `linear`, its motion that of
//! `sim`. Nor is there a command, a results folder or a picture: those are the shells around
//! this crate, `sweep` for the command line among them. `quantities` is the table of what a
//! design may vary, `memory` refuses what would take too much of it, `threads` are as many as a
//! cluster allots, `trace` follows limits over two axes and `rounds` says which cases that wants
//! next, `run` is what a run builds before its first case, `words` are for people.
//!
//! It is the inside of one program in several crates: items follow what the shells need, and
//! promise nothing to others. The libraries are `linear`, `sim` and `statics`.
//!
//! A sweep from its text to its labels, the text of a file being what
//! [`read_text`](text_file::read_text) has of it:
//!
//! ```
//! use std::sync::Mutex;
//!
//! use campaign::engine::{RunOptions, Shard};
//! use campaign::memory::Limit;
//! use campaign::{Campaign, Run};
//!
//! let text = r#"
//! methods = ["quadrature"]
//! [string]
//! shear_modulus_gpa = 80
//! density_kg_m3 = 7840
//! torsional_damping_nms_rad_m = 1
//! [[string.sections]]
//! name = "pipe"
//! repeat = 50
//! parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.1 }]
//! [bit]
//! rock = "sandstone"
//! [design]
//! kind = "grid"
//! [design.axes]
//! surface_speed_rpm = { values = [0.2, 60] }
//! weight_on_bit_kn = { values = [50] }
//! "#;
//! let campaign = Campaign::open("my.toml".as_ref(), &[], &|_, _| Ok(text.to_owned()))?;
//! let survey = campaign.survey()?;
//! let systems = campaign.build(&survey, RunOptions::default(), &Limit::of(None))?;
//! let run = Run {
//!     shard: Shard::WHOLE,
//!     options: RunOptions::default(),
//!     is_done: &|_, _| false,
//!     earlier: &|_| Ok(()),
//!     expect: &|_| {},
//!     stops: &|| false,
//! };
//! let labels = Mutex::new(vec![String::new(); 2]);
//! campaign.run(&systems, &run, &|record| {
//!     let outcome = record.outcome.map_err(|failure| anyhow::anyhow!("{}", failure.text()))?;
//!     let mut labels = labels.lock().map_err(|_| anyhow::anyhow!("a thread stopped"))?;
//!     labels[record.case] = outcome.labels().to_string();
//!     Ok(())
//! })?;
//! // Below the line of Eq. 74, and far above it.
//! assert_eq!(labels.into_inner()?, ["stick_slip", "smooth"]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod accuracy;
pub mod allotted;
mod campaign;
pub mod dependence;
pub mod design;
pub mod engine;
pub mod follow;
pub mod labels;
pub mod memory;
pub mod plan;
pub mod printable;
pub mod quantities;
pub mod records;
pub mod rounds;
pub mod run;
pub mod snaking_above;
pub mod static_string;
pub mod sweep_file;
pub mod tables;
pub mod text_file;
pub mod threads;
pub mod trace;
pub mod words;

pub use campaign::{Campaign, NoRun, NoteRecord, Run, SurveyError};
pub use numerics::random;
