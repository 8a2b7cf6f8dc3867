//! The neighbours of cases: each axis changed alone, up and down.

use campaign::engine::Case;
use campaign::plan::Sweep;
use campaign::quantities::Axis;
use results::folder::CaseRows;

/// The neighbours of some cases.
pub struct Neighbours {
    /// The place of the case to which each belongs.
    pub of: Vec<usize>,
    /// The values of each along all axes.
    pub values: Vec<Vec<f64>>,
}

/// The cases of a sweep with each of some axes changed by a fraction of its value; a value of zero
/// by that fraction of the greatest of its axis. Invalid values are left out.
pub fn neighbours(sweep: &Sweep, cases: &[CaseRows], axes: &[Axis], margin: f64) -> Neighbours {
    let places = (sweep.design.axes().iter().enumerate())
        .filter(|(_, axis)| axes.contains(axis))
        .map(|(place, _)| (place, greatest(cases, place)));
    let places: Vec<(usize, f64)> = places.collect();
    let (mut of, mut values) = (Vec::new(), Vec::new());
    for (index, case) in cases.iter().enumerate() {
        for &(place, greatest) in &places {
            let value = case.values[place];
            let step = margin * if value == 0.0 { greatest } else { value };
            for changed in [value - step, value + step] {
                let mut moved = case.values.clone();
                moved[place] = changed;
                if step != 0.0 && makes_a_case(sweep, &moved) {
                    of.push(index);
                    values.push(moved);
                }
            }
        }
    }
    Neighbours { of, values }
}

fn greatest(cases: &[CaseRows], place: usize) -> f64 {
    let values = cases.iter().map(|case| case.values[place].abs());
    values.fold(0.0, f64::max)
}

fn makes_a_case(sweep: &Sweep, values: &[f64]) -> bool {
    let mut along = sweep.design.axes().iter().zip(values);
    let Ok(setting) = sweep.setting_at(values) else {
        return false;
    };
    let conditions = sweep.conditions_at(values);
    along.all(|(axis, value)| axis.check(*value).is_ok())
        && Case::under(sweep, &setting, 0, values.to_vec(), &conditions).is_ok()
}
