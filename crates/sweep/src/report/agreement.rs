//! Whether the methods agree.

use crate::map::symbol_of;
use crate::output::{CaseRows, Motion};

/// Cases on which methods differ that are kept to be listed.
const MOST_LISTED: usize = 30;

/// How far the methods agree on the same cases.
#[derive(Debug, Clone, PartialEq)]
pub struct Agreement {
    /// Every two methods.
    pub pairs: Vec<Pair>,
    /// Of each motion, cases drawn on its map as circle, cross and square, and those not
    /// drawn: some method has no answer, or one that tells nothing.
    pub shown: Vec<(Motion, [usize; 4])>,
    /// Cases on which answers differ.
    pub differing: usize,
    /// The first of them.
    pub listed: Vec<CaseRows>,
}

/// Two methods.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pair {
    /// Their names.
    pub methods: [String; 2],
    /// Cases that both answer.
    pub compared: usize,
    /// Those on which both labels, of torsion and lateral, are the same.
    pub same: usize,
}

impl Agreement {
    /// Of these methods and motions, without a case.
    pub fn new(methods: &[&str], motions: &[Motion]) -> Self {
        let pairs = methods.iter().enumerate().flat_map(|(index, one)| {
            methods[index + 1..].iter().map(move |other| Pair {
                methods: [one, other].map(|name| (*name).to_owned()),
                compared: 0,
                same: 0,
            })
        });
        Self {
            pairs: pairs.collect(),
            shown: motions.iter().map(|&motion| (motion, [0; 4])).collect(),
            differing: 0,
            listed: Vec::new(),
        }
    }

    /// Adds a case.
    pub fn add(&mut self, case: &CaseRows) {
        for pair in &mut self.pairs {
            let answer = |name: &str| {
                let mut rows = case.rows.iter();
                rows.find(|row| row.method == name && row.labels.is_answer())
            };
            if let (Some(one), Some(other)) = (answer(&pair.methods[0]), answer(&pair.methods[1])) {
                pair.compared += 1;
                pair.same += usize::from(one.labels == other.labels);
            }
        }
        for (motion, counts) in &mut self.shown {
            counts[symbol_of(case, *motion).map_or(3, |symbol| symbol as usize)] += 1;
        }
        if case.differs() {
            self.differing += 1;
            if self.listed.len() < MOST_LISTED {
                self.listed.push(case.clone());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::LabelRow;

    fn case(labels: [&str; 3]) -> CaseRows {
        let rows = ["a", "b", "c"].iter().zip(labels);
        CaseRows {
            case: 0,
            values: Vec::new(),
            rows: rows
                .map(|(method, label)| LabelRow::example(method, label))
                .collect(),
        }
    }

    #[test]
    fn pairs_are_compared_where_both_answer() {
        let mut agreement = Agreement::new(&["a", "b", "c"], &[Motion::Torsion]);
        agreement.add(&case(["smooth", "smooth", "smooth"]));
        agreement.add(&case(["smooth", "stick_slip", ""]));
        agreement.add(&case(["stuck", "stick_slip", "stick_slip"]));
        let counts: Vec<_> = (agreement.pairs.iter())
            .map(|pair| (pair.methods.concat(), pair.same, pair.compared))
            .collect();
        let expected = [("ab", 1, 3), ("ac", 1, 2), ("bc", 2, 2)];
        assert_eq!(counts, expected.map(|(a, b, c)| (a.to_owned(), b, c)));
        assert_eq!(agreement.shown, [(Motion::Torsion, [0, 1, 0, 2])]);
        assert_eq!((agreement.differing, agreement.listed.len()), (2, 2));
    }

    #[test]
    fn the_list_of_differing_cases_does_not_grow_without_end() {
        let mut agreement = Agreement::new(&["a", "b", "c"], &[Motion::Torsion]);
        for _ in 0..1000 {
            agreement.add(&case(["smooth", "stick_slip", "smooth"]));
        }
        assert_eq!(agreement.differing, 1000);
        assert_eq!(agreement.listed.len(), MOST_LISTED);
    }
}
