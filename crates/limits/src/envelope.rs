//! The least of several lines at each place of an axis.

/// The least of several lines, each with its own ends.
///
/// ```
/// use limits::Envelope;
///
/// let lines = [vec![(10.0, 0.2), (20.0, 0.4)], vec![(15.0, 0.1), (30.0, 0.1)]];
/// let envelope = Envelope::new(&lines);
/// assert!((envelope.at(12.5).unwrap_or(f64::NAN) - 0.25).abs() < 1e-12);
/// assert_eq!((envelope.at(18.0), envelope.at(40.0)), (Some(0.1), None));
/// assert_eq!(envelope.least(), Some(0.1));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Envelope {
    /// Where any line has a point, in ascending order.
    places: Vec<f64>,
    /// The least at both ends of every stretch between two places, where a line
    /// crosses it.
    stretches: Vec<Option<[f64; 2]>>,
    /// The least of all points.
    least: Option<f64>,
}

/// Places that differ by a smaller part are the same but for rounding.
const SAME_PLACE: f64 = 1e-9;

impl Envelope {
    /// Of lines by their points, place and value, in any direction along the axis.
    pub fn new(lines: &[Vec<(f64, f64)>]) -> Self {
        let points = || lines.iter().flatten();
        let mut places: Vec<f64> = points().map(|point| point.0).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        let mut envelope = Self {
            stretches: vec![None; places.len().saturating_sub(1)],
            places,
            least: points().map(|point| point.1).min_by(f64::total_cmp),
        };
        for ends in lines.iter().flat_map(|line| line.windows(2)) {
            let (from, to) = if ends[0].0 <= ends[1].0 {
                (ends[0], ends[1])
            } else {
                (ends[1], ends[0])
            };
            envelope.lower(from, to);
        }
        envelope
    }

    fn lower(&mut self, from: (f64, f64), to: (f64, f64)) {
        let value = |place: f64| from.1 + (to.1 - from.1) * (place - from.0) / (to.0 - from.0);
        let first = self.places.partition_point(|&place| place < from.0);
        let end = self.places.partition_point(|&place| place < to.0);
        for stretch in first..end {
            let own = [self.places[stretch], self.places[stretch + 1]].map(value);
            let least = self.stretches[stretch].get_or_insert(own);
            *least = [least[0].min(own[0]), least[1].min(own[1])];
        }
    }

    /// The least of all lines anywhere.
    pub fn least(&self) -> Option<f64> {
        self.least
    }

    /// The least of the lines at a place; none where there is none. Lines that all are
    /// single points are asked for at no other place.
    pub fn at(&self, place: f64) -> Option<f64> {
        let (&first, &last) = (self.places.first()?, self.places.last()?);
        if first == last {
            return self.least;
        }
        let slack = SAME_PLACE * place.abs();
        if place < first - slack || place > last + slack {
            return None;
        }
        let place = place.clamp(first, last);
        let next = self.places.partition_point(|&other| other < place);
        // A place of a point ends one stretch and begins the next.
        let touching = [
            next.checked_sub(1),
            (self.places[next] == place).then_some(next),
        ];
        let values = touching.into_iter().flatten().filter_map(|stretch| {
            let [start, end] = (*self.stretches.get(stretch)?)?;
            let [from, to] = [self.places[stretch], self.places[stretch + 1]];
            Some(start + (end - start) * (place - from) / (to - from))
        });
        values.min_by(f64::total_cmp)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_read_between_its_points() {
        let envelope = Envelope::new(&[vec![(1.0, 10.0), (2.0, 20.0), (4.0, 0.0)]]);
        let at = |place| envelope.at(place);
        let values = [at(1.0), at(1.5), at(2.0), at(3.0), at(4.0)];
        assert_eq!(values, [10.0, 15.0, 20.0, 10.0, 0.0].map(Some));
        assert_eq!([at(1.0 - 1e-15), at(4.0 + 1e-15)], [Some(10.0), Some(0.0)]);
        assert_eq!([at(0.9), at(4.1)], [None, None]);
        assert_eq!(Envelope::new(&[]).at(1.0), None);
        assert_eq!(
            Envelope::new(&[vec![(1.0, 3.0)], vec![(1.0, 2.0)]]).at(1.0),
            Some(2.0)
        );
    }

    #[test]
    fn the_least_of_lines_has_gaps_where_none_is() {
        let lines = [
            vec![(0.0, 3.0), (4.0, 3.0)],
            vec![(3.0, 2.0), (1.0, 2.0)],
            vec![(6.0, 5.0), (8.0, 7.0)],
        ];
        let envelope = Envelope::new(&lines);
        let at = [0.5, 1.0, 2.0, 3.0, 3.5, 5.0, 7.0].map(|place| envelope.at(place));
        let expected = [
            Some(3.0),
            Some(2.0),
            Some(2.0),
            Some(2.0),
            Some(3.0),
            None,
            Some(6.0),
        ];
        assert_eq!(at, expected);
        assert_eq!(envelope.least(), Some(2.0));
    }
}
