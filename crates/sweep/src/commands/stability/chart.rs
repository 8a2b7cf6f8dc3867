//! The atlas as panels of cells.

use plot::{CellPanel, CellWords, ChartCell, Picture, Seen, cell_chart};
use studies::stability::{Entry, Family, Symptom};

const WORDS: CellWords = CellWords {
    predicted: [
        "predicted: stable",
        "predicted: unstable",
        "the margin says nothing of it",
    ],
    seen: [
        "nothing wrong was seen",
        "fails under a load tuned to the margin",
        "failed in an ordinary scene",
    ],
    framed: "framed: not as predicted",
    number: "number: the smallest margin, or where it says nothing the relative error",
};

/// Draws all families that have cells, each in a panel.
pub fn chart(entries: &[Entry]) -> Picture {
    let panels = Family::all().iter().map(|&family| {
        let of_family = entries.iter().filter(|entry| entry.cell.family == family);
        panel(family, &of_family.collect::<Vec<_>>())
    });
    let panels: Vec<_> = panels.filter(|panel| !panel.cells.is_empty()).collect();
    cell_chart(
        "Where methods fail, and whether their positive-real margin predicts it",
        &WORDS,
        &panels,
    )
}

fn panel(family: Family, entries: &[&Entry]) -> CellPanel {
    let (title, x) = titles(family);
    let (mut columns, mut rows) = (Vec::new(), Vec::new());
    let place = |names: &mut Vec<String>, name: String| {
        names
            .iter()
            .position(|known| *known == name)
            .unwrap_or_else(|| {
                names.push(name);
                names.len() - 1
            })
    };
    let cells = (entries.iter())
        .map(|entry| ChartCell {
            column: place(&mut columns, column_name(family, entry)),
            row: place(&mut rows, row_name(family, entry)),
            predicted_stable: entry.findings.predicted_stable(),
            seen: seen(&entry.findings.symptoms()),
            text: number(entry),
        })
        .collect();
    CellPanel {
        title: title.to_owned(),
        x: x.to_owned(),
        columns,
        rows,
        cells,
    }
}

fn seen(symptoms: &[Symptom]) -> Seen {
    match symptoms {
        [] => Seen::Sound,
        [Symptom::EnergyGained] => Seen::Provoked,
        _ => Seen::Failed,
    }
}

/// Title and name of the columns.
fn titles(family: Family) -> (&'static str, &'static str) {
    match family {
        Family::Hilbert => ("Digital filter, sticking", "length of transform (s)"),
        Family::DirectIdft => (
            "Plain inverse transform, sticking",
            "length of transform (s)",
        ),
        Family::Newmark => ("Newmark's scheme, sticking", "γ"),
        Family::Formulas => (
            "Convolution quadrature and held loads, sticking",
            "sampling frequency (Hz)",
        ),
        Family::Sections => (
            "Strings of drillpipe, held; in bending, their response at 100 Hz",
            "sections of 10 m",
        ),
        Family::Stiffness => ("Backward whirl (Fig. 12)", "contact stiffness (N/m^1.5)"),
        Family::Sites => (
            "Backward whirl, two sites",
            "distance between the sites (m)",
        ),
        Family::LongSticking => ("A million steps of sticking", "sampling frequency (Hz)"),
        Family::LongWhirl => ("A million steps of whirl", "sampling frequency (Hz)"),
        Family::Tail => (
            "Displacement in bending 9 s after an impulse",
            "sampling frequency (Hz)",
        ),
        Family::Joints => (
            "Limit of stick-slip, jointed pipe with collars",
            "sampling frequency (Hz)",
        ),
    }
}

fn column_name(family: Family, entry: &Entry) -> String {
    let cell = &entry.cell;
    let value = match family {
        Family::Hilbert | Family::DirectIdft => cell.parameters().transform_s,
        Family::Newmark => cell.parameters().gamma,
        Family::Stiffness => cell.stiffness,
        Family::Sites => cell.site_spacing,
        Family::Sections => cell.sections.map(|count| count as f64),
        Family::Formulas
        | Family::LongSticking
        | Family::LongWhirl
        | Family::Tail
        | Family::Joints => Some(cell.sampling_frequency),
    };
    match value {
        Some(value) if value.is_infinite() => "rigid".to_owned(),
        Some(value) if value >= 1e6 => format!("{value:e}"),
        Some(value) => value.to_string(),
        None => String::new(),
    }
}

fn row_name(family: Family, entry: &Entry) -> String {
    match family {
        Family::Hilbert | Family::DirectIdft | Family::Newmark => {
            format!("{} Hz", entry.cell.sampling_frequency)
        }
        _ => entry.cell.method_name(),
    }
}

/// Two digits or so.
fn number(entry: &Entry) -> String {
    let findings = &entry.findings;
    let margins = [findings.margin_torsion, findings.margin_bending];
    let margin = margins.into_iter().flatten().reduce(f64::min);
    let Some(value) = findings.error.or(margin) else {
        return String::new();
    };
    let text = match value.abs() {
        size if !size.is_finite() => "∞".to_owned(),
        // Rounding, and what is cut off.
        size if size < 1e-6 => "0".to_owned(),
        size if !(1e-2..1e4).contains(&size) => format!("{value:.0e}"),
        size if size < 1.0 => format!("{value:.2}"),
        size if size < 10.0 => format!("{value:.1}"),
        _ => format!("{value:.0}"),
    };
    text.replace('-', "−")
}
