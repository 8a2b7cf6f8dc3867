//! Where contacts are, and where else a string is hit.

/// Places nearer than this, m, are one.
pub const SAME_PLACE: f64 = 1e-3;

/// A range of the string, m from the bit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Its lower end.
    pub from: f64,
    /// Its upper end.
    pub to: f64,
}

impl Range {
    /// Its length, m.
    pub fn length(&self) -> f64 {
        self.to - self.from
    }

    /// Distances from the bit (m) of a number of places at even distances, the first at the lower
    /// end and the last as far below the upper end as any is below the next: twice as many are the
    /// same and one more between each two.
    pub fn even(&self, count: usize) -> Vec<f64> {
        let place = |index: usize| self.from + self.length() * (index as f64 / count as f64);
        (0..count).map(place).collect()
    }
}

/// Places with others that are not among them.
pub fn with_others(places: &[f64], others: &[f64]) -> Vec<f64> {
    let mut all = places.to_vec();
    for other in others {
        if index_of(&all, *other).is_none() {
            all.push(*other);
        }
    }
    all
}

/// Which of some places one is.
pub fn index_of(places: &[f64], place: f64) -> Option<usize> {
    (places.iter()).position(|other| (other - place).abs() <= SAME_PLACE)
}

#[cfg(test)]
mod tests {
    use super::*;

    const RANGE: Range = Range {
        from: 5.0,
        to: 205.0,
    };

    #[test]
    fn twice_as_many_contacts_leave_those_where_they_are() {
        assert_eq!(RANGE.even(4), [5.0, 55.0, 105.0, 155.0]);
        for count in [1, 3, 16] {
            let (few, many) = (RANGE.even(count), RANGE.even(2 * count));
            assert!(few.iter().all(|place| index_of(&many, *place).is_some()));
            assert_eq!(with_others(&many, &few), many);
        }
    }

    #[test]
    fn other_places_are_added_once() {
        assert_eq!(
            with_others(&[5.0, 55.0], &[55.0004, 7.0, 7.0]),
            [5.0, 55.0, 7.0]
        );
    }
}
