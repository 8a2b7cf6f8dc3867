//! The files of a results folder.
//!
//! A folder as `sweep run` leaves it, read back:
//!
//! ```
//! # use std::sync::Mutex;
//! # use campaign::engine::{RunOptions, Shard};
//! # use campaign::memory::Limit;
//! # use campaign::{Campaign, Run};
//! # use results::folder::{About, TableWriter, fingerprint};
//! # use results::log::Header;
//! # let text = r#"
//! # methods = ["quadrature"]
//! # [string]
//! # shear_modulus_gpa = 80
//! # density_kg_m3 = 7840
//! # torsional_damping_nms_rad_m = 1
//! # [[string.sections]]
//! # name = "pipe"
//! # repeat = 50
//! # parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.1 }]
//! # [bit]
//! # rock = "sandstone"
//! # [design]
//! # kind = "grid"
//! # [design.axes]
//! # surface_speed_rpm = { values = [0.2, 60] }
//! # weight_on_bit_kn = { values = [50] }
//! # "#;
//! # let options = RunOptions::default();
//! # let campaign = Campaign::open("my.toml".as_ref(), &[], &|_, _| Ok(text.to_owned()))?;
//! # let systems = campaign.build(&campaign.survey()?, options, &Limit::of(None))?;
//! # let run = Run {
//! #     shard: Shard::WHOLE,
//! #     options,
//! #     is_done: &|_, _| false,
//! #     earlier: &|_| Ok(()),
//! #     expect: &|_| {},
//! #     stops: &|| false,
//! # };
//! # let records = Mutex::new(Vec::new());
//! # campaign.run(&systems, &run, &|record| {
//! #     records.lock().map_err(|_| anyhow::anyhow!("a thread stopped"))?.push(record);
//! #     Ok(())
//! # })?;
//! # let mut records = records.into_inner()?;
//! # records.sort_by_key(|record| record.case);
//! # let temporary = tempfile::tempdir()?;
//! # let folder = temporary.path();
//! # let fingerprint = fingerprint(&campaign.sweep, options)?;
//! # let header = Header::new("example 1.0".to_owned(), Shard::WHOLE, fingerprint);
//! # let about = About::new(&campaign.sweep, "my.toml".as_ref(), &header, options, &systems.methods)?;
//! # let mut writer = TableWriter::create(&about, folder)?;
//! # writer.add(&records)?;
//! # let (tally, files) = writer.finish()?;
//! # let mut manifest = about.manifest.clone();
//! # (manifest.tally, manifest.files) = (tally, files);
//! # let boundary = limits::boundary(&campaign.sweep, &systems.methods)?;
//! # let boundary = limits::boundary_csv(&boundary);
//! # results::files::write_atomically(&folder.join("boundary.csv"), boundary.as_bytes())?;
//! # manifest.note(folder, &["boundary.csv"])?;
//! # manifest.write(folder)?;
//! use campaign::quantities::Axis;
//! use results::analysis::Analysis;
//! use results::folder::{ResultTables, read_cases};
//!
//! let tables = ResultTables::open(folder, |note| println!("{note}"))?;
//! let (axes, labels) = (&tables.manifest.axes, folder.join("labels.csv"));
//! for case in read_cases(&labels, axes)? {
//!     let case = case?;
//!     let expected = if case.values[0] < 1.0 { "stick_slip" } else { "smooth" };
//!     assert_eq!(case.rows[0].labels.to_string(), expected);
//! }
//! let by = [vec![Axis::SurfaceSpeedRpm]];
//! let analysis = Analysis::of(&[folder.to_owned()], &[tables], &by, 2)?;
//! assert_eq!(analysis.counts[0].rows, 2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod about;
mod cases;
mod column_words;
mod failures;
mod integrity;
mod label_row;
mod label_rows;
mod manifest;
mod open;
mod recorded_rows;
mod records;
mod results;
mod tables;
mod tally;
mod trace_summary;
mod typed_rows;

pub use about::About;
pub use cases::{CaseRows, FoundByMethods, read_cases, read_measured_cases};
pub use column_words::column_words;
pub use failures::FAILURES_HEADER;
pub use integrity::{Damage, OF_TRACE, PAPER_MAP, PICTURES, TABLES};
pub use label_row::LabelRow;
pub use label_rows::{LabelColumns, label_rows, misfit_columns, read_labels};
pub use manifest::{Manifest, MethodRecord, differences, fingerprint};
pub use open::{LOG, MANIFEST, NoResults, damaged, refuse_empty};
pub use records::{RECORDS, RecordWriter, read_records};
pub use results::TableWriter;
pub use tables::{ResultTables, SoFar};
pub use tally::Tally;
pub use trace_summary::{LimitSummary, TraceSummary};
pub use typed_rows::{TypedColumns, TypedRow, typed_rows};
