//! Lines along which a field has a level, of its values at the points of a lattice.

use campaign::trace::{LimitLine, join, pieces};

/// Lines on which the field has a level, by places in units of the lattice: through the squares
/// whose four corners all have a value, linear along their sides. Values are column by column; a
/// closed line ends where it begins.
pub fn contour(
    [columns, rows]: [usize; 2],
    values: &[Option<f64>],
    level: f64,
) -> Vec<Vec<[f64; 2]>> {
    let value = |[column, row]: [usize; 2]| values[column * rows + row];
    let squares = (1..columns).flat_map(|right| (1..rows).map(move |top| [right - 1, top - 1]));
    let through = squares.flat_map(|[x, y]| {
        let corners = [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]].map(value);
        match corners {
            [Some(a), Some(b), Some(c), Some(d)] => {
                pieces([x, y], [a, b, c, d].map(|value| value >= level))
            }
            _ => Vec::new(),
        }
    });
    let exact = |line: LimitLine| line.into_iter().map(|half| crossing(half, value, level));
    join(through)
        .into_iter()
        .map(|line| exact(line).collect())
        .collect()
}

/// Where the field has the level between two neighbours, whose middle has a place twice this.
fn crossing(twice: [usize; 2], value: impl Fn([usize; 2]) -> Option<f64>, level: f64) -> [f64; 2] {
    let low = twice.map(|place| place / 2);
    let high = twice.map(|place| place.div_ceil(2));
    let part = match (value(low), value(high)) {
        (Some(from), Some(to)) if from != to => (level - from) / (to - from),
        _ => 0.5,
    };
    [0, 1].map(|axis| low[axis] as f64 + part * (high[axis] - low[axis]) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [usize; 2] = [9, 7];

    fn field(of: impl Fn(f64, f64) -> f64) -> Vec<Option<f64>> {
        let [columns, rows] = SIZE;
        let places = (0..columns).flat_map(|x| (0..rows).map(move |y| (x as f64, y as f64)));
        places.map(|(x, y)| Some(of(x, y))).collect()
    }

    /// Linear interpolation is exact.
    #[test]
    fn a_plane_has_one_straight_line_from_side_to_side() {
        let plane = |x: f64, y: f64| 0.11 * x + 0.07 * y;
        let lines = contour(SIZE, &field(plane), 0.5);
        assert_eq!(lines.len(), 1);
        for &[x, y] in &lines[0] {
            assert!((plane(x, y) - 0.5).abs() < 1e-12, "{x} {y}");
        }
        // From where it enters at the right of the top, x = 8/11, to y = 0, x = 50/11.
        let mut ends = [lines[0][0], lines[0][lines[0].len() - 1]];
        ends.sort_by(|one, other| one[0].total_cmp(&other[0]));
        for (end, expected) in ends.iter().zip([[8.0 / 11.0, 6.0], [50.0 / 11.0, 0.0]]) {
            let off = (end[0] - expected[0]).abs() + (end[1] - expected[1]).abs();
            assert!(off < 1e-12, "{end:?}");
        }
    }

    /// Between neighbours the distance from a point bends by at most 1/8r, where r is at least 1.8
    /// along sides that the line crosses.
    #[test]
    fn a_cone_has_one_closed_line_near_its_circle() {
        let radius = |x: f64, y: f64| (x - 4.1).hypot(y - 2.9);
        let lines = contour(SIZE, &field(radius), 2.3);
        assert_eq!(lines.len(), 1);
        let line = &lines[0];
        assert_eq!(line[0], line[line.len() - 1]);
        for &[x, y] in line {
            let off = radius(x, y) - 2.3;
            assert!(off.abs() < 1.0 / (8.0 * 1.8), "{x} {y}: {off}");
        }
        let area: f64 = line
            .windows(2)
            .map(|pair| 0.5 * (pair[0][0] * pair[1][1] - pair[1][0] * pair[0][1]))
            .sum();
        let circle = std::f64::consts::PI * 2.3 * 2.3;
        assert!((area.abs() / circle - 1.0).abs() < 0.08, "{area}");
    }

    #[test]
    fn a_line_ends_at_what_is_not_known_and_a_level_not_reached_has_none() {
        let mut values = field(|x, _| x);
        assert_eq!(contour(SIZE, &values, 9.0), Vec::<Vec<[f64; 2]>>::new());
        assert_eq!(contour(SIZE, &values, 3.5)[0].len(), 7);
        // In the middle of the column to the left of the line.
        values[3 * SIZE[1] + 3] = None;
        let mut heights: Vec<Vec<f64>> = contour(SIZE, &values, 3.5)
            .iter()
            .map(|line| line.iter().map(|place| place[1]).collect())
            .collect();
        heights
            .iter_mut()
            .for_each(|line| line.sort_by(f64::total_cmp));
        assert_eq!(heights, [[0.0, 1.0, 2.0], [4.0, 5.0, 6.0]]);
    }

    /// Two corners that are opposite are cut off each.
    #[test]
    fn a_saddle_has_two_lines() {
        let values = [1.0, 0.0, 0.0, 1.0].map(Some);
        let lines = contour([2, 2], &values, 0.25);
        assert_eq!(lines.len(), 2);
        for place in lines.iter().flatten() {
            let [x, y] = *place;
            assert!([x, 1.0 - x].contains(&0.75) || [y, 1.0 - y].contains(&0.75));
        }
    }
}
