//! The sections on time and provenance: what the results depend on, and how long they
//! took.

use super::document::{Block, NOTHING, Table, row_of, table_of};
use super::results::Results;
use campaign::engine::is_unstable;
use campaign::quantities::{IMPULSE, Unit};
use campaign::words::short;
use results::folder::MethodRecord;

/// How long it took.
pub fn time(all: &[Results]) -> Vec<Block> {
    let caption = "Whole runs, from start to end: the last part of one that was stopped, the sum \
                   of merged shards";
    let mut runs = table_of(all, caption, &["simulations", "threads", "time"]);
    let header = [
        "method",
        "built in",
        "length of responses, steps",
        "margin in torsion",
        "in bending",
        "in axial motion",
        "I₀",
    ];
    let mut systems = table_of(all, "The linear system of each method", &header);
    for results in all {
        let manifest = &results.manifest;
        let [threads, time] = match results.tables.so_far {
            None => [
                manifest.threads.to_string(),
                format!("{:.2} s", manifest.wall_seconds),
            ],
            Some(_) => [NOTHING.to_owned(), NOTHING.to_owned()],
        };
        let cells = vec![manifest.tally.rows.to_string(), threads, time];
        runs.rows.push(row_of(all, results, cells));
        let impulse = manifest.sweep.units.of(&IMPULSE);
        for method in &manifest.methods {
            let cells = system_row(method, &impulse);
            systems.rows.push(row_of(all, results, cells));
        }
    }
    let mut blocks = vec![Block::Table(runs), Block::Table(systems)];
    let varied = all.iter().filter(|results| results.manifest.strings > 1);
    blocks.extend(varied.map(|results| {
        Block::Text(format!(
            "{} has {} distinct strings, each with its own systems; those above are of the \
             string as the sweep file says it.",
            results.name, results.manifest.strings
        ))
    }));
    blocks
}

/// A method with its I₀ in a unit.
fn system_row(method: &MethodRecord, impulse: &Unit) -> Vec<String> {
    let margin = |margin: Option<f64>| match margin {
        None => NOTHING.to_owned(),
        Some(margin) if is_unstable(margin) => format!("{}: chatters", short(margin)),
        Some(margin) => short(margin),
    };
    let impulses = method.least_impulses_ns.iter();
    let impulses =
        impulses.map(|least| format!("{} {}", short(impulse.number(*least)), impulse.name));
    let impulses = impulses.collect::<Vec<_>>().join(", ");
    let known = |text: Option<String>| text.unwrap_or_else(|| NOTHING.to_owned());
    vec![
        method.method.clone(),
        known(method.build_seconds.map(|time| format!("{time:.3} s"))),
        method.taps.to_string(),
        margin(method.positive_real_margin),
        margin(method.bending_margin),
        margin(method.axial_margin),
        known(Some(impulses).filter(|list| !list.is_empty())),
    ]
}

/// What the results depend on.
pub fn provenance(all: &[Results]) -> Vec<Block> {
    let names = all.iter().map(|results| results.name.as_str());
    let header = ["of"].into_iter().chain(names);
    let mut table = Table::new("What the results depend on", header);
    let mut row = |name: &str, cell: &dyn Fn(&Results) -> String| {
        let cells = [name.to_owned()].into_iter().chain(all.iter().map(cell));
        table.rows.push(cells.collect());
    };
    row("program", &|results| results.manifest.program.clone());
    row("platform", &|results| results.manifest.platform.clone());
    row("sweep", &|results| results.manifest.name.clone());
    row("hash of the sweep", &|results| {
        results.manifest.meaning_sha256.clone()
    });
    row("seed", &|results| {
        let seed = results.manifest.seed;
        seed.map_or_else(|| NOTHING.to_owned(), |seed| seed.to_string())
    });
    row("sampling frequency", &|results| {
        let frequency = short(results.manifest.sampling_frequency_hz);
        let why = if results.manifest.sampling_frequency_by_rule {
            "by rule"
        } else {
            "as given"
        };
        let of_methods = results.manifest.methods.iter().filter_map(|method| {
            let own = short(method.sampling_frequency_hz?);
            Some(format!(", {own} Hz by {} for whirl", method.method))
        });
        format!("{frequency} Hz, {why}{}", of_methods.collect::<String>())
    });
    row("simulated", &|results| {
        let until = if results.manifest.options.full {
            "every case to its end"
        } else {
            "until certain or settled"
        };
        until.to_owned()
    });
    let mut blocks = vec![Block::Table(table)];
    blocks.extend(all.iter().map(|results| Block::Folded {
        title: format!("The sweep of {} as it was run, in SI units", results.name),
        text: format!("{:#}", serde_json::json!(results.manifest.sweep)),
    }));
    blocks
}
