//! The page itself: one file, with everything in it.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::Result;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use campaign::labels::LabelTable;
use campaign::plan::{StringFriction, Sweep};
use campaign::quantities::{Axis, FORCE, TORQUE, WIDTH};
use campaign::records::{Certainty, Record};
use campaign::sweep_file::FileContent;
use campaign::words::{file_word, short, site_title};
use linear::Method;
use results::folder::column_words;
use serde_json::json;

use super::controls::Control;
use super::whirl::{self, LimitLine};
use crate::report::{Table, escaped, policy, shown, table};

const STYLE: [&str; 3] = [
    include_str!("../report/page.css"),
    include_str!("../page/plot.css"),
    include_str!("../page/explore.css"),
];
const SCRIPTS: [&str; 4] = [
    include_str!("../page/engine.js"),
    include_str!("../page/plot.js"),
    include_str!("../page/zoom.js"),
    include_str!("../page/explore.js"),
];
const ENGINE: &[u8] = include_bytes!("../page/engine.wasm.gz");

/// Steps of a bit that cuts that take a page about a second.
const STEPS_OF_A_SECOND: f64 = 3e5;

/// Quickest to build where the string changes as a slider moves.
const QUICK: &str = "quadrature";

/// Of the methods of a sweep, by their places: the one that its page simulates by, and one that takes
/// minutes to build in a browser. It is the first of the file, but of a string with friction all along
/// it one without a lattice of waves in each piece.
pub fn methods_of_page(sweep: &Sweep) -> (usize, Option<usize>) {
    let rubs = sweep.setting.friction.is_some();
    let is_slow = |method: &Method| rubs && matches!(method, Method::Held | Method::Poles);
    let slow = sweep.methods.iter().position(is_slow);
    let quick = sweep.methods.iter().position(|method| !is_slow(method));
    (quick.unwrap_or(0), slow)
}

/// What a page is made of.
pub struct Explored<'a> {
    /// The sweep file.
    pub file: &'a Path,
    /// The sweep.
    pub sweep: &'a Sweep,
    /// The method that the page simulates by.
    pub method: &'static str,
    /// A method of the sweep file that takes minutes to build in a browser.
    pub slow: Option<&'static str>,
    /// Every text that was read for it.
    pub texts: BTreeMap<String, String>,
    /// How long the case lasts, s.
    pub duration: f64,
    /// What can be changed.
    pub controls: &'a [Control],
    /// The limits of whirl between walls.
    pub whirl: Option<Vec<LimitLine>>,
    /// The row of the case that the page begins with.
    pub row: &'a Record,
    /// Its motion as a PNG file, for readers without scripts.
    pub picture: &'a [u8],
}

/// The page.
///
/// # Errors
/// None that a sweep that was read could cause.
pub fn page(explored: &Explored) -> Result<String> {
    let title = escaped(&explored.sweep.title);
    let style = STYLE.concat();
    // Nothing in it ends the element that it stands in.
    let data = data(explored)?.to_string().replace('<', "\\u003c");
    let still = still(explored);
    let engine = STANDARD.encode(ENGINE);
    let scripts = SCRIPTS.concat();
    let policy = policy(&scripts);
    let program = escaped(crate::program::PROGRAM);
    Ok(format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <link rel=\"icon\" href=\"data:,\">\n<title>{title}</title>\n<style>\n{style}</style>\n\
         </head>\n<body>\n<header><h1>{title}</h1></header>\n<main>\n\
         <p id=\"status\" role=\"status\"></p>\n{still}{LIVE}</main>\n\
         <footer><p>Made by {program}.</p></footer>\n\
         <script type=\"application/json\" id=\"data\">{data}</script>\n\
         <script type=\"text/plain\" id=\"engine\">{engine}</script>\n\
         <script>{scripts}</script>\n</body>\n</html>\n"
    ))
}

/// What scripts bring to life.
const LIVE: &str = r#"<div id="live" hidden>
<div class="explore">
<div class="seen"><p id="regime" aria-live="polite"></p>
<p id="side" aria-live="polite"></p>
<div id="lead"></div></div>
<section class="changed" aria-label="What can be changed"><div id="controls"></div>
<p><button id="reset" type="button">As in the file</button></p>
<div id="map" role="application" tabindex="0" aria-label="Map with the place of this case: drag it, or move it by arrow keys"></div>
<p id="lines" class="note" hidden></p></section>
<section id="motion" class="charts" aria-label="Its motion"></section>
</div>
<p><label for="command">The same in a terminal</label> <input id="command" readonly>
<button id="copy" type="button">Copy as command</button></p>
<div class="scroll" role="region" aria-label="Row of the case" tabindex="0"><table><caption><span>Numbers of the case, in the units of the file</span></caption><tbody id="row"></tbody></table></div>
</div>
"#;

/// What scripts work with.
fn data(explored: &Explored) -> Result<serde_json::Value> {
    let Explored {
        sweep, controls, ..
    } = explored;
    let path = explored.file.display().to_string();
    let own = sweep.methods.iter().map(|method| method.name());
    let own: Vec<&str> = own.collect();
    let methods = [QUICK].into_iter().filter(|quick| !own.contains(quick));
    let mut opening = json!({
        "path": path,
        "texts": explored.texts,
        "methods": methods.collect::<Vec<_>>(),
    });
    // What was chosen for an accuracy, or read from a workbook, is in no text; and engines of earlier
    // versions do not know a name.
    if sweep.choice.is_some() || sweep.sheet.is_some() || sweep.content.name.is_some() {
        let content = FileContent {
            name: None,
            ..sweep.content.clone()
        };
        opening["sweep"] = serde_json::to_value(&content)?;
    }
    let case = explored.row.case;
    let place = |wanted: &[Axis]| {
        let control = controls
            .iter()
            .find(|control| wanted.contains(&control.axis));
        control.map(|control| control.axis)
    };
    let torque = place(&[Axis::WeightOnBitKn, Axis::TorqueDynamicNm]);
    let stick_slip = torque.zip(place(&[Axis::SurfaceSpeedRpm]));
    let cuts = sweep.setting.cutting.is_some();
    let has_limit = sweep.setting.lateral.is_none() && sweep.setting.friction.is_none();
    let stick_slip = stick_slip.filter(|_| has_limit && sweep.setting.has_stick_slip_limit());
    let drilling = place(&[Axis::WeightOnBitKn, Axis::FeedMH]).zip(place(&[Axis::SurfaceSpeedRpm]));
    let drilling = drilling.filter(|_| cuts);
    // That of stick-slip is found in the page, for each string anew; of a bit that cuts it is a place to
    // drag the case to.
    let map = match (&explored.whirl, drilling) {
        (_, Some((set, speed))) => {
            let lines: [LimitLine; 0] = [];
            Some(json!({ "of": "drilling", "axes": [set, speed], "lines": lines }))
        }
        (Some(lines), None) => Some(json!({ "of": "whirl", "axes": whirl::AXES, "lines": lines })),
        (None, None) => {
            stick_slip.map(|(torque, speed)| json!({ "of": "stick_slip", "axes": [torque, speed] }))
        }
    };
    let units = sweep.content.units;
    let sites = sweep.setting.sites.distances_from_bit().iter();
    let header = LabelTable::of(sweep).header();
    let columns = header.split(',').map(|name| {
        let (words, unit) = column_words(name, units);
        let mut column = shown(&unit);
        column["words"] = words.into();
        (name.to_owned(), column)
    });
    Ok(json!({
        "sites": sites.map(|site| site_title(*site, units)).collect::<Vec<_>>(),
        "columns": columns.collect::<serde_json::Map<_, _>>(),
        "opening": opening,
        "case": case,
        "method": explored.method,
        "quick": QUICK,
        "slow": explored.slow,
        "why": why_long(explored),
        "controls": controls,
        "torque": shown(&units.of(&TORQUE).kilo()),
        "width": shown(&units.of(&WIDTH)),
        "force": shown(&units.of(&FORCE)),
        "map": map,
        "command": format!("sweep simulate {} --case {case} --methods {}", file_word(&path), explored.method),
    }))
}

/// Why a case takes long, for who waits: of a string that rubs, or above a bit that cuts.
fn why_long(explored: &Explored) -> Option<String> {
    let sweep = explored.sweep;
    let rubs = sweep.setting.friction.as_ref().map(why_rubbing_is_long);
    let steps = explored.duration * sweep.highest_frequency();
    let is_long = sweep.setting.cutting.is_some() && steps > STEPS_OF_A_SECOND;
    let cuts = is_long.then(|| {
        format!(
            "A bit that cuts is followed to the end of its {} s, {:.0} thousand steps in torsion and along \
             the axis, which takes seconds in a page. A shorter `time_s` takes less.",
            short(explored.duration),
            1e-3 * steps
        )
    });
    rubs.or(cuts)
}

/// Of a string with friction along it.
fn why_rubbing_is_long(friction: &StringFriction) -> String {
    format!(
        "With friction along it the string is stepped in {} pieces, for some of its longest periods: a \
         case of a long well takes seconds in a page. Fewer `pieces` and a shorter `time_s` take less.",
        friction.pieces()
    )
}

/// The case as it is in the file, for readers without scripts.
fn still(explored: &Explored) -> String {
    let labels = LabelTable::of(explored.sweep);
    let row = labels.row(explored.row, Certainty::default());
    let header = labels.header();
    let units = explored.sweep.content.units;
    let mut numbers = Table::new("The case as it is in the file", ["what", "value"]);
    let cells = header
        .split(',')
        .zip(row.split(','))
        .filter(|(_, text)| !text.is_empty());
    numbers.rows = cells
        .map(|(name, text)| {
            let (words, unit) = column_words(name, units);
            let what = match unit.name.as_str() {
                "" => words,
                unit => format!("{words} ({unit})"),
            };
            let value = match text.parse() {
                Ok(value) => short(unit.number(value)),
                Err(_) => text.replace('_', " "),
            };
            vec![what, value]
        })
        .collect();
    let picture = STANDARD.encode(explored.picture);
    format!(
        "<div id=\"still\">\n<noscript><p>Scripts are off here: this is the case as it is in the \
         file, and nothing can be moved.</p></noscript>\n{}\
         <img alt=\"Motion of the case\" src=\"data:image/png;base64,{picture}\">\n</div>\n",
        table(&numbers)
    )
}
