//! The default sampling frequency follows from a string, not from how it is written down.

use linear::sampling::{Steps, frequency_for_fronts};
use linear::{Drillstring, Material, Section, Tube};
use proptest::prelude::*;

const STEEL: Material = Material {
    shear_modulus: 80e9,
    density: 7840.0,
};

/// A tube from its length and outer radius, m.
fn tube(length: f64, outer_radius: f64) -> Tube {
    Tube {
        length,
        inner_radius: 0.04,
        outer_radius,
    }
}

fn string(sections: Vec<Section>) -> Drillstring {
    Drillstring::new(STEEL, sections, 1.0).unwrap()
}

/// The same tube in pieces that end at these parts of it.
fn cut(whole: Tube, at: &[f64]) -> Vec<Tube> {
    let mut ends: Vec<f64> = at.to_vec();
    ends.push(1.0);
    ends.sort_by(f64::total_cmp);
    let mut from = 0.0;
    let pieces = ends.iter().map(|end| {
        let length = (end - from) * whole.length;
        from = *end;
        Tube { length, ..whole }
    });
    pieces.filter(|piece| piece.length > 1e-3).collect()
}

fn once(parts: Vec<Tube>) -> Section {
    Section { repeat: 1, parts }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]

    /// Whole tubes, the same cut anywhere, and cells gathered in any number of sections.
    #[test]
    fn val_a_string_divided_at_random_has_the_same_frequency(
        pipe in 8.0..12.0f64,
        joint in 0.3..0.7f64,
        cells in 4usize..40,
        gathered in 1usize..4,
        collar in 20.0..200.0f64,
        cuts in prop::collection::vec(0.05..0.95f64, 0..5),
    ) {
        let cell = [tube(pipe, 0.06), tube(joint, 0.08)];
        let collar = tube(collar, 0.1);
        let whole = string(vec![
            Section { repeat: cells, parts: cell.to_vec() },
            once(vec![collar]),
        ]);
        let of_cuts: Vec<Tube> = cell.iter().flat_map(|part| cut(*part, &cuts)).collect();
        let first = cells / (gathered + 1);
        let mut sections = vec![Section { repeat: cells - first, parts: of_cuts }];
        if first > 0 {
            sections.push(Section { repeat: first, parts: cell.to_vec() });
        }
        sections.push(once(cut(collar, &cuts)));
        let divided = string(sections);
        let [one, other] = [&whole, &divided].map(|it| Steps::for_fronts(it).unwrap());
        prop_assert_eq!(one.per_travel, other.per_travel);
        let [one, other] = [&whole, &divided].map(|it| frequency_for_fronts(it).unwrap());
        prop_assert!((one / other - 1.0).abs() < 1e-9, "{} {}", one, other);
    }

    /// Plain pipe as one part or as cells of any length.
    #[test]
    fn val_equal_cells_have_the_frequency_of_one_tube(
        length in 200.0..3000.0f64,
        cells in 2usize..200,
    ) {
        let one = string(vec![once(vec![tube(length, 0.06)]), once(vec![tube(90.0, 0.1)])]);
        let part = tube(length / cells as f64, 0.06);
        let many = string(vec![
            Section { repeat: cells, parts: vec![part] },
            once(vec![tube(90.0, 0.1)]),
        ]);
        let [one, many] = [&one, &many].map(|it| Steps::for_fronts(it).unwrap().per_travel);
        prop_assert_eq!(one, many);
    }
}
