//! The modes in words and numbers.

use linear::SurfaceSupport;

use super::found::{ModeFamily, Modes};
use super::speeds::Excitation;
use campaign::quantities::{LENGTH, Units};
use campaign::words::{counted, short, wrapped};

/// A number of the lowest modes of each kind, and the critical speeds.
pub fn describe(found: &[Modes], excitation: &Excitation, count: usize, units: Units) -> String {
    let mut text = "\nmodes without damping, bit free, no contact with the wall\n".to_owned();
    for modes in found {
        let heading = format!("{}, {}", modes.of.words(), held(&modes.of, units));
        text += &wrapped(&heading, 2, 4);
        let damping = modes.damping.iter().flatten().map(|_| "damping".to_owned());
        let orders = excitation.orders.iter();
        let speeds = orders.map(|order| format!("rpm, {order}×"));
        text += &line("mode", "Hz", speeds.chain(damping.take(1)));
        let lowest = modes.frequencies.iter().zip(&modes.damping).take(count);
        for (index, (&frequency, damping)) in lowest.enumerate() {
            let speed = |order: &f64| short(Excitation::meets(*order, frequency));
            let damping = damping.map(|ratio| format!("{:.2} %", 100.0 * ratio));
            let cells = excitation.orders.iter().map(speed).chain(damping);
            text += &line(&(index + 1).to_string(), &short(frequency), cells);
        }
        text += &further(modes, excitation);
    }
    text
}

/// Cells in columns, as wide for titles as for numbers.
fn line(number: &str, frequency: &str, cells: impl Iterator<Item = String>) -> String {
    let cells: String = cells.map(|cell| format!("{cell:<8} ")).collect();
    let line = format!("    {number:<5}{frequency:<10}{cells}");
    line.trim_end().to_owned() + "\n"
}

/// What holds it.
fn held(of: &ModeFamily, units: Units) -> String {
    let support = |support: SurfaceSupport| match support {
        SurfaceSupport::Clamped => "surface clamped",
        SurfaceSupport::Pinned => "surface pinned",
        SurfaceSupport::Free => "surface free",
    };
    match of {
        ModeFamily::Torsion => "surface held at its speed".to_owned(),
        ModeFamily::Axial(None) => "surface held".to_owned(),
        ModeFamily::Axial(Some(0.0)) => "hanging from its hoist, free to move".to_owned(),
        ModeFamily::Axial(Some(mass)) => {
            format!("hanging from its hoist, with {} kg", short(*mass))
        }
        ModeFamily::Bending(of_surface) => support(*of_surface).to_owned(),
        ModeFamily::BelowHeld(place) => {
            let place = units.of(&LENGTH).text(*place, 1);
            format!("held {place} from the bit, and above")
        }
        ModeFamily::BetweenHeld(places) => {
            let length = units.of(&LENGTH);
            let places = places.iter().map(|place| short(length.number(*place)));
            format!(
                "pinned at {} {} from the bit, without the string above",
                places.collect::<Vec<_>>().join(", "),
                length.name
            )
        }
    }
}

/// How many there are, and how many speeds are critical.
fn further(modes: &Modes, excitation: &Excitation) -> String {
    let [least, most] = excitation.speeds.map(short);
    let below = |it: &&f64| **it < excitation.highest();
    let excited = modes.frequencies.iter().filter(below).count() + modes.left_out;
    let critical = excitation.orders.iter().map(|&order| {
        let met = modes.frequencies.iter();
        let met = met.filter(|it| excitation.critical(order, **it).is_some());
        format!("{} by {order}×", met.count())
    });
    let critical = critical.collect::<Vec<_>>().join(", ");
    let of = if excitation.are_of_sweep {
        ", as in the sweep"
    } else {
        ""
    };
    let mut text = format!(
        "{excited} below {} Hz; critical from {least} to {most} rpm{of}: {critical}",
        short(excitation.highest())
    );
    if modes.left_out > 0 {
        let listed = modes.frequencies.len();
        text += &format!("; of these the {listed} lowest are listed and counted as critical");
    }
    if modes.rigid > 0 {
        text += &format!("; plus {}", counted(modes.rigid, "rigid-body mode"));
    }
    if modes.buckled > 0 {
        text += &format!("; plus {}", counted(modes.buckled, "buckled mode"));
    }
    wrapped(&text, 4, 6)
}
