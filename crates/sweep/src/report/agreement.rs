//! Whether the methods agree.

use serde::{Serialize, Serializer};

use crate::map::symbol_of;
use plot::Symbol;
use results::folder::CaseRows;
use sim::Motion;

/// Cases on which methods differ that are kept to be listed.
const MOST_LISTED: usize = 30;

/// How far the methods agree on the same cases.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Agreement {
    /// Every two methods.
    pub pairs: Vec<Pair>,
    /// Of each motion, what its map shows.
    #[serde(serialize_with = "by_motion")]
    pub shown: Vec<(Motion, Shown)>,
    /// Cases on which answers differ.
    pub differing: usize,
    /// The first of them, whose values are along the axes of the sweep.
    #[serde(skip)]
    pub listed: Vec<CaseRows>,
}

/// How many cases a map shows by each symbol.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Shown {
    /// Every method finds sustained vibration.
    #[serde(rename = "all_sustained")]
    pub circles: usize,
    /// No method does.
    #[serde(rename = "none_sustained")]
    pub crosses: usize,
    /// The methods differ.
    #[serde(rename = "methods_differ")]
    pub squares: usize,
    /// The start decides.
    #[serde(rename = "bistable")]
    pub diamonds: usize,
    /// Every method finds less than sustained vibration: snaking.
    #[serde(rename = "all_snaking")]
    pub triangles: usize,
    /// Not drawn: some method has no answer, or an undetermined one.
    #[serde(rename = "undetermined")]
    pub undrawn: usize,
}

fn by_motion<S: Serializer>(shown: &[(Motion, Shown)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(shown.iter().copied())
}

impl Shown {
    fn count(&mut self, symbol: Option<Symbol>) {
        let place = match symbol {
            Some(Symbol::Circle | Symbol::Disc) => &mut self.circles,
            Some(Symbol::Cross | Symbol::HeavyCross) => &mut self.crosses,
            Some(Symbol::Square) => &mut self.squares,
            Some(Symbol::Diamond | Symbol::FilledDiamond) => &mut self.diamonds,
            Some(Symbol::Triangle) => &mut self.triangles,
            None => &mut self.undrawn,
        };
        *place += 1;
    }
}

/// Two methods.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
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
            shown: motions
                .iter()
                .map(|&motion| (motion, Shown::default()))
                .collect(),
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
            counts.count(symbol_of(case, *motion));
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
    use results::folder::LabelRow;

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
        agreement.add(&case(["bistable"; 3]));
        agreement.add(&case(["bistable", "bistable", "stick_slip"]));
        let shown = Shown {
            crosses: 1,
            squares: 1,
            diamonds: 1,
            undrawn: 2,
            ..Shown::default()
        };
        assert_eq!(agreement.shown, [(Motion::Torsion, shown)]);
        assert_eq!((agreement.differing, agreement.listed.len()), (3, 3));
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
