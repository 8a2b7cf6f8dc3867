//! The modes as pictures: a Campbell diagram, and shapes side by side.

use super::found::Modes;
use super::speeds::{Excitation, frequency};
use campaign::quantities::{LENGTH, Units};
use campaign::words::short;
use plot::{Axis, CampbellPanel, Look, Multiple, Picture, Series, campbell, multiples};

/// How much higher than the lowest mode the diagram of one whose modes all are above the
/// excitation is.
const ROOM: f64 = 1.1;

/// Natural frequencies and multiples of the surface speed.
pub fn campbell_picture(
    look: &Look,
    title: &str,
    found: &[Modes],
    excitation: &Excitation,
) -> Picture {
    let panels: Vec<_> = (found.iter().map(|modes| panel(modes, excitation))).collect();
    let title = format!("{title}: critical speeds (Campbell diagram)");
    let words = ["natural frequency, with its number", "critical"];
    campbell(look, &title, words, &panels)
}

fn panel(modes: &Modes, excitation: &Excitation) -> CampbellPanel {
    let lowest = modes.frequencies.first().copied().unwrap_or(0.0);
    let highest = excitation.highest().max(ROOM * lowest);
    let shown = modes.frequencies.iter().copied();
    let series = |order: f64, points: Vec<(f64, f64)>| Series::new(format!("{order}×"), points);
    let line = |&order: &f64| {
        let ends = excitation
            .speeds
            .map(|speed| (speed, frequency(order, speed)));
        series(order, ends.to_vec())
    };
    let met = |&order: &f64| {
        let met = modes
            .frequencies
            .iter()
            .filter_map(|&frequency| Some((excitation.critical(order, frequency)?, frequency)));
        series(order, met.collect())
    };
    CampbellPanel {
        title: titled(modes.of.words()),
        axes: ["Surface speed Ω (rpm)", "Frequency f (Hz)"].map(Axis::linear),
        natural: shown.take_while(|it| *it <= highest).collect(),
        orders: excitation.orders.iter().map(line).collect(),
        crossings: excitation.orders.iter().map(met).collect(),
    }
}

/// Shapes of the lowest modes along the string.
pub fn shape_picture(look: &Look, title: &str, found: &[Modes], units: Units) -> Picture {
    let length = units.of(&LENGTH);
    let panels = found.iter().flat_map(|modes| {
        let titled = titled(modes.of.short_words());
        let length = &length;
        let shapes = modes.shapes.iter().zip(&modes.frequencies).enumerate();
        shapes.map(move |(index, (shape, frequency))| Multiple {
            title: format!("{titled} {}: {} Hz", index + 1, short(*frequency)),
            points: (shape.depths.iter().map(|depth| length.number(*depth)))
                .zip(shape.amplitudes.iter().copied())
                .collect(),
        })
    });
    let depth = format!("Depth ({})", length.name);
    let axes = [&depth, "Amplitude / greatest"].map(Axis::linear);
    let panels: Vec<_> = panels.collect();
    multiples(look, &format!("{title}: mode shapes"), &axes, &panels)
}

fn titled(words: &str) -> String {
    let (first, rest) = words.split_at(1);
    first.to_uppercase() + rest
}
