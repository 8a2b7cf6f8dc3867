//! A regime map in characters.

use crate::map::{Cells, Extent};
use sim::Motion;

use campaign::quantities::Axis;
use campaign::sweep_file::Spacing;
use campaign::words::short;
use plot::{CellFill, Symbol};

/// The map with its axes and what the characters mean.
pub fn character_map(cells: &Cells, extent: &Extent, motion: Motion, [x, y]: [Axis; 2]) -> String {
    let [columns, rows] = cells.size();
    let shown = |axis: Axis, ends: [f64; 2]| {
        let unit = axis.unit(extent.units);
        ends.map(|end| short(unit.number(end)))
    };
    let [bottom, top] = shown(y, extent.ranges[1]);
    let margin = bottom.len().max(top.len());
    let title = |axis: Axis, spacing: Spacing| match spacing {
        Spacing::Linear => axis.title(extent.units),
        Spacing::Log => format!("{}, logarithmic", axis.title(extent.units)),
    };
    let mut text = format!("{}\n", title(y, extent.spacing[1]));
    for row in (0..rows).rev() {
        let label = match row {
            0 => &bottom,
            row if row == rows - 1 => &top,
            _ => "",
        };
        let line: String = (0..columns)
            .map(|column| cells.symbol(column, row).map_or(' ', character))
            .collect();
        text += &format!("{label:>margin$} |{}\n", line.trim_end());
    }
    let [left, right] = shown(x, extent.ranges[0]);
    let room = columns.saturating_sub(left.len() + right.len()).max(1);
    let indent = " ".repeat(margin);
    text += &format!("{indent} +{}\n", "-".repeat(columns));
    text += &format!("{indent}  {left}{}{right}\n", " ".repeat(room));
    text += &format!("{indent}  {}\n\n", title(x, extent.spacing[0]));
    text += &legend(cells, motion);
    if cells.are_shared() {
        text += "A character stands for most of the cases in its cell.\n";
    }
    text
}

/// What the characters on the map mean.
fn legend(cells: &Cells, motion: Motion) -> String {
    let joined = cells.joined();
    let keys: String = (Symbol::meanings(
        (motion.regimes(), motion.lesser_regime()),
        " by all methods",
    )
    .into_iter())
    .filter(|(symbol, _)| {
        let fill = CellFill::Symbol(*symbol);
        joined.iter().any(|cell| cell.fill == fill)
    })
    .map(|(symbol, meaning)| format!("{} {meaning}\n", character(symbol)))
    .collect();
    if keys.is_empty() {
        return "No case has an answer.\n".to_owned();
    }
    keys
}

/// As unlike each other as characters can be.
fn character(symbol: Symbol) -> char {
    match symbol {
        Symbol::Circle | Symbol::Disc => 'O',
        Symbol::Cross | Symbol::HeavyCross => '.',
        Symbol::Square => '#',
        Symbol::Diamond | Symbol::FilledDiamond => '?',
        Symbol::Triangle => '^',
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_map_has_its_first_row_at_the_bottom() {
        let extent = Extent::example([&[0.02, 0.6], &[5.0, 100.0]], 3);
        let mut cells = Cells::new(&extent, [64, 20]);
        cells.add([0.02, 100.0], Symbol::Circle);
        cells.add([0.6, 100.0], Symbol::Square);
        cells.add([0.6, 5.0], Symbol::Cross);
        let text = character_map(
            &cells,
            &extent,
            Motion::Torsion,
            [Axis::SurfaceSpeedRpm, Axis::WeightOnBitKn],
        );
        let lines: Vec<&str> = text.lines().take(4).collect();
        assert_eq!(
            lines,
            ["Weight on bit W (kN)", "100 |O#", "  5 | .", "    +--"]
        );
        assert!(!text.contains("stands for most"), "{text}");
    }

    #[test]
    fn an_uneven_grid_has_a_column_for_each_value_and_shared_ones_are_marked() {
        let speeds = [1.0, 2.0, 4.0, 1000.0];
        let extent = Extent::example([&speeds, &[5.0]], 4);
        let mut cells = Cells::new(&extent, [64, 20]);
        let map = |cells: &Cells| character_map(cells, &extent, Motion::Torsion, extent.axes);
        for speed in speeds {
            cells.add([speed, 5.0], Symbol::Circle);
        }
        let text = map(&cells);
        assert!(text.contains("5 |OOOO\n"), "{text}");
        assert!(!text.contains("stands for most"), "{text}");
        // As many cases as cells, but two in one of them.
        let mut cells = Cells::new(&extent, [64, 20]);
        for speed in [1.0, 1.0, 4.0, 1000.0] {
            cells.add([speed, 5.0], Symbol::Circle);
        }
        assert!(map(&cells).contains("stands for most"));
    }
}
