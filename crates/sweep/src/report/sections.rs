//! Results folders in words and tables, section by section.

use sim::{Label, Motion};

use super::analysed::analysed_sections;
use super::bars::{ShareBar, share_bars};
use super::comparison::{FolderComparison, Unlike};
use super::document::{Block, Map, NOTHING, Section, Table, named, note, row_of, table_of};
use super::failures::FailureRow;
use super::limit::{LimitCheck, Limited, SideCounts};
use super::opening::opening;
use super::provenance::{provenance, time};
use super::results::Results;
use campaign::words::{counted, short};

/// Everything there is to say of one folder, or of several side by side;
/// `comparisons` are those of the first with each of the others.
pub fn sections(all: &[Results], comparisons: &[Result<FolderComparison, Unlike>]) -> Vec<Section> {
    let sections = [
        ("In short", opening(all)),
        ("Regime map", maps(all)),
        ("Regimes", regimes(all)),
        ("How often, how surely, what decides", analysed(all)),
        ("Agreement of the methods", agreement(all)),
        ("Cases and the analytic line", limits(all)),
        ("Cases without an answer", failures(all)),
        ("Between the folders", between(all, comparisons)),
        ("How it was computed", computed(all)),
    ];
    let has_content = |section: &Section| !section.1.is_empty();
    sections.into_iter().filter(has_content).collect()
}

fn percentage(part: usize, whole: usize) -> String {
    if whole == 0 {
        return NOTHING.to_owned();
    }
    format!("{:.1} %", 100.0 * part as f64 / whole as f64)
}

fn maps(all: &[Results]) -> Vec<Block> {
    let mut blocks = Vec::new();
    for (place, results) in all.iter().enumerate() {
        let Some(characters) = &results.characters else {
            let text = if results.manifest.map.is_some() {
                "No map: there is no case in this part."
            } else {
                "No map: the cases differ in fewer than two quantities."
            };
            blocks.push(note(all, results, text));
            continue;
        };
        if results.manifest.shard.is_some() {
            let text = "The picture is drawn when the shards are merged.";
            blocks.push(note(all, results, text));
        }
        let live = results.live.as_ref();
        blocks.push(Block::Map(Map {
            caption: named(all, results, &results.manifest.title),
            html: live.map(|live| live.html.clone()),
            cases: live.filter(|live| live.data.is_some()).map(|_| place),
            characters: characters.clone(),
        }));
    }
    blocks
}

/// A table for each motion that any of the folders has labels of.
fn regimes(all: &[Results]) -> Vec<Block> {
    let motions = motions(all);
    let tables = motions.iter().map(|&motion| {
        let caption = match motions.len() {
            1 => "Cases of each regime, by method".to_owned(),
            _ => format!("Cases of each {} regime, by method", motion.adjective()),
        };
        let (html, table) = regimes_of(all, motion, &caption);
        Block::Picture { html, table }
    });
    let found = all.iter().flat_map(|results| {
        let words = results.manifest.tally.notes(results.manifest.sweep.units);
        words.map(|words| note(all, results, format!("{words}.")))
    });
    tables.chain(found).collect()
}

/// The motions that any of the folders has labels of.
fn motions(all: &[Results]) -> Vec<Motion> {
    let has = |motion: &Motion| {
        let mut folders = all.iter();
        folders.any(|results| results.manifest.tally.motions().contains(motion))
    };
    Motion::ALL.into_iter().filter(has).collect()
}

/// How much of each regime, in bars and in a table.
fn regimes_of(all: &[Results], motion: Motion, caption: &str) -> (String, Table) {
    let is_found = |label: &Label| {
        all.iter().any(|results| {
            let mut methods = results.methods().into_iter();
            methods.any(|method| results.count(method, *label) > 0)
        })
    };
    let labels: Vec<Label> = Label::all(motion).into_iter().filter(is_found).collect();
    let words: Vec<String> = (labels.iter())
        .map(|label| label.name().replace('_', " "))
        .collect();
    let header: Vec<&str> = ["method"]
        .into_iter()
        .chain(words.iter().map(String::as_str))
        .chain(["no answer"])
        .collect();
    let mut table = table_of(all, caption, &header);
    let mut bars = Vec::new();
    for results in all {
        for method in results.methods() {
            let counts = labels.iter().map(|label| results.count(method, *label));
            let failed = results.failures.by_method.get(method).copied().unwrap_or(0);
            let counts: Vec<usize> = counts.chain([failed]).collect();
            bars.push(ShareBar {
                name: named(all, results, method),
                parts: (labels.iter().map(|label| label.name()))
                    .chain(["failed"])
                    .zip(counts.iter().copied())
                    .collect(),
            });
            let cells = counts.iter().map(|count| count.to_string());
            let cells = [method.to_owned()].into_iter().chain(cells).collect();
            table.rows.push(row_of(all, results, cells));
        }
    }
    (share_bars(caption, &bars), table)
}

/// Of random cases, with the name of the folder before where there are several.
fn analysed(all: &[Results]) -> Vec<Block> {
    let mut found = Vec::new();
    for results in all {
        let Some(analysed) = &results.analysed else {
            continue;
        };
        if all.len() > 1 {
            found.push(Block::Text(format!("{}:", results.name)));
        }
        let (counts, blocks) = (&analysed.counts, &analysed.blocks);
        let sections = analysed_sections(&results.manifest, counts, blocks, None);
        found.extend(sections.into_iter().flat_map(|(_, content)| content));
    }
    found
}

fn agreement(all: &[Results]) -> Vec<Block> {
    let mut blocks = Vec::new();
    let header = ["methods", "same labels", "of cases", "part"];
    let mut pairs = table_of(all, "Cases on which two methods agree", &header);
    let has_two = motions(all).len() > 1;
    let mut shown = all.iter().flat_map(|results| &results.agreement.shown);
    let depends_on_start = shown.any(|(_, shown)| shown.diamonds > 0);
    let motion = has_two.then_some("motion");
    let bistable = depends_on_start.then_some("bistable");
    let header: Vec<&str> = (motion.into_iter())
        .chain(["all sustained", "none", "methods differ", "undetermined"])
        .chain(bistable)
        .collect();
    let mut symbols = table_of(all, "Cases by what the map is about", &header);
    for results in all {
        let agreement = &results.agreement;
        for pair in &agreement.pairs {
            let cells = vec![
                pair.methods.join(" and "),
                pair.same.to_string(),
                pair.compared.to_string(),
                percentage(pair.same, pair.compared),
            ];
            pairs.rows.push(row_of(all, results, cells));
        }
        for (motion, shown) in &agreement.shown {
            let motion = has_two.then(|| motion.adjective().to_owned());
            let counts = [shown.circles, shown.crosses, shown.squares, shown.undrawn];
            let bistable = depends_on_start.then_some(shown.diamonds);
            let counts = counts.into_iter().chain(bistable);
            let cells = (motion.into_iter())
                .chain(counts.map(|count| count.to_string()))
                .collect();
            symbols.rows.push(row_of(all, results, cells));
        }
    }
    if !pairs.rows.is_empty() {
        blocks.push(Block::Table(pairs));
    }
    blocks.extend(certain(all));
    blocks.push(folded(symbols));
    let differing = all.iter().filter(|results| results.agreement.differing > 0);
    blocks.extend(differing.map(|results| folded(differing_cases(all, results))));
    blocks
}

/// A table that a page folds.
fn folded(table: Table) -> Block {
    Block::Details {
        title: table.caption.clone(),
        blocks: vec![Block::Table(table)],
    }
}

/// How many labels are certain, where any folder tells that.
fn certain(all: &[Results]) -> Option<Block> {
    let header = [
        "motion",
        "methods",
        "sampled at",
        "certain",
        "of cases",
        "part",
    ];
    let mut table = table_of(all, "Cases whose label is certain", &header);
    for results in all {
        let manifest = &results.manifest;
        let Some(by) = &manifest.certified_by else {
            continue;
        };
        let cases = manifest.cases_here();
        for motion in manifest.tally.motions() {
            let certain = manifest.tally.certified(motion);
            let cells = vec![
                motion.adjective().to_owned(),
                by.methods.join(" and "),
                by.frequencies(),
                certain.to_string(),
                cases.to_string(),
                percentage(certain, cases),
            ];
            table.rows.push(row_of(all, results, cells));
        }
    }
    (!table.rows.is_empty()).then_some(Block::Table(table))
}

fn differing_cases(all: &[Results], results: &Results) -> Table {
    let agreement = &results.agreement;
    let mut header = vec!["case".to_owned()];
    let (axes, units) = (&results.manifest.axes, results.manifest.sweep.units);
    header.extend(axes.iter().map(|axis| axis.name_in(units)));
    header.extend(results.methods().into_iter().map(str::to_owned));
    let caption = format!(
        "Cases on which the methods differ{}",
        extent(agreement.listed.len(), agreement.differing)
    );
    let mut table = Table::new(named(all, results, caption), header);
    for case in &agreement.listed {
        let mut cells = vec![case.case.to_string()];
        let values = axes.iter().zip(&case.values);
        cells.extend(values.map(|(axis, &value)| short(axis.unit(units).number(value))));
        cells.extend(results.methods().into_iter().map(|method| {
            let row = case.rows.iter().find(|row| row.method == method);
            row.map_or_else(|| NOTHING.to_owned(), |row| row.labels.to_string())
        }));
        table.rows.push(cells);
    }
    table
}

/// How many are listed of how many there are.
fn extent(listed: usize, all: usize) -> String {
    if listed < all {
        format!(", the first {listed} of {all}")
    } else {
        format!(", all {all}")
    }
}

fn limits(all: &[Results]) -> Vec<Block> {
    let of_folder = |results: &Results| {
        let Some(limits) = &results.limits else {
            let text = "The line is given when the run is finished.";
            let is_running = results.tables.so_far.is_some();
            return is_running.then(|| note(all, results, text));
        };
        let (caption, last) = match limits.limited {
            Limited::StickSlip => (
                "Surface speed in multiples of the one-slip estimate (Eq. 74), which is no limit of \
                 stick-slip; cases as stick-slip / smooth",
                ["highest stick-slip", "lowest smooth"],
            ),
            Limited::Whirl => (
                "Friction in multiples of the least at which backward whirl rolls steadily at \
                 one site; cases as backward whirl / none",
                ["lowest whirl", "highest without"],
            ),
        };
        let header = ["method", "below it", "above it", last[0], last[1]];
        let mut table = Table::new(named(all, results, caption), header);
        table.rows.extend(limits.checks.iter().map(limit_row));
        Some(folded(table))
    };
    let forward = |results: &Results| {
        let contact = results.manifest.forward_contact.as_ref()?;
        let words = contact.words(results.manifest.sweep.units);
        Some(note(all, results, format!("Forward whirl: {words}.")))
    };
    let blocks = all.iter().filter_map(of_folder);
    blocks.chain(all.iter().filter_map(forward)).collect()
}

fn limit_row(check: &LimitCheck) -> Vec<String> {
    let counts = |side: SideCounts| format!("{} / {}", side.vibrating, side.quiet);
    let place = |place: Option<f64>| {
        place.map_or_else(|| NOTHING.to_owned(), |place| format!("{place:.3}"))
    };
    vec![
        check.method.clone(),
        counts(check.below),
        counts(check.above),
        place(check.last_vibrating),
        place(check.last_quiet),
    ]
}

fn failures(all: &[Results]) -> Vec<Block> {
    let of_folder = |results: &Results| {
        let (listed, count) = (&results.failures.listed, results.failures.count());
        if count == 0 {
            return None;
        }
        let caption = format!("Failed simulations{}", extent(listed.len(), count));
        let header = ["case", "method", "reason", "repeat with"];
        let mut table = Table::new(named(all, results, caption), header);
        table.rows.extend(listed.iter().map(failure_cells));
        Some(Block::Table(table))
    };
    all.iter().filter_map(of_folder).collect()
}

fn failure_cells(failure: &FailureRow) -> Vec<String> {
    let FailureRow {
        case,
        method,
        reason,
        repeat_with,
    } = failure;
    vec![
        case.to_string(),
        method.clone(),
        reason.clone(),
        repeat_with.clone(),
    ]
}

fn between(all: &[Results], comparisons: &[Result<FolderComparison, Unlike>]) -> Vec<Block> {
    let mut blocks = Vec::new();
    let Some((first, others)) = all.split_first() else {
        return blocks;
    };
    for (other, comparison) in others.iter().zip(comparisons) {
        let folders = format!("{} and {}", first.name, other.name);
        let compared = match comparison {
            Ok(compared) => compared,
            Err(why) => {
                let text = format!("{folders} are not of the same cases: {why}.");
                blocks.push(Block::Text(text));
                continue;
            }
        };
        let same = compared.rows - compared.different;
        blocks.push(Block::Text(format!(
            "{folders} have the same labels for {same} of {} simulations ({}).",
            compared.rows,
            percentage(same, compared.rows)
        )));
        if compared.listed.is_empty() {
            continue;
        }
        let mut header = ["case", "method"].map(str::to_owned).to_vec();
        let units = first.manifest.sweep.units;
        header.extend((first.manifest.axes.iter()).map(|axis| axis.name_in(units)));
        header.extend([&first.name, &other.name].map(String::clone));
        let listed = extent(compared.listed.len(), compared.different);
        let mut table = Table::new(format!("Labels that differ{listed}"), header);
        table.rows.clone_from(&compared.listed);
        blocks.push(folded(table));
    }
    blocks
}

/// Time and provenance, for who repeats it.
fn computed(all: &[Results]) -> Vec<Block> {
    let settled = all.iter().filter_map(|results| {
        let tally = &results.manifest.tally;
        let words = || {
            format!(
                "Settled, and followed to the end all the same: {}, of which {} with another label \
                 in the end.",
                counted(tally.settled_checked, "simulation"),
                tally.settled_wrong
            )
        };
        (tally.settled_checked > 0).then(|| note(all, results, words()))
    });
    let details = |title: &str, blocks: Vec<Block>| Block::Details {
        title: title.to_owned(),
        blocks,
    };
    vec![
        details("Provenance", provenance(all)),
        details("Time", settled.chain(time(all)).collect()),
    ]
}
