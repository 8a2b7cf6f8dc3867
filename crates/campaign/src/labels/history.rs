//! The motion of a case as named columns with units, a row a step.

use linear::Sites;
use sim::Trajectory;
use sim::laws::cutting::CutStep;

use crate::records::{to_kn, to_m_h, to_mm, to_rpm};

/// One of them.
pub struct HistoryColumn {
    /// Its name, with the unit.
    pub name: String,
    /// A number a step.
    pub values: Vec<f64>,
}

/// A number in SI in the unit of its column.
type InUnit = fn(f64) -> f64;

/// The columns of a motion at these sites. The torque on bit is counted positive against the
/// rotation, as drillers do.
pub fn history_columns(sites: &Sites, motion: &Trajectory) -> Vec<HistoryColumn> {
    let names: Vec<String> = (sites.distances_from_bit().iter())
        .map(|&distance| site_name(distance))
        .collect();
    let column = |name: String, values: &[f64], unit: InUnit| HistoryColumn {
        name,
        values: values.iter().map(|&value| unit(value)).collect(),
    };
    let same = |value: f64| value;
    let mut columns = vec![column("time_s".to_owned(), &motion.times, same)];
    columns.extend(
        (names.iter().zip(&motion.speeds))
            .map(|(site, speeds)| column(format!("{site}_speed_rpm"), speeds, to_rpm)),
    );
    let driven: [(&str, &[f64], InUnit); 4] = [
        ("torque_on_bit_nm", &motion.bit_torque, |torque| -torque),
        ("mud_motor_torque_nm", &motion.mud_motor_torque, same),
        ("motor_torque_nm", &motion.surface_torque, same),
        ("surface_speed_rpm", &motion.surface_speed, to_rpm),
    ];
    let known = driven
        .into_iter()
        .filter(|(_, values, _)| !values.is_empty());
    columns.extend(known.map(|(name, values, unit)| column(name.to_owned(), values, unit)));
    let of_cut = |name: &str, value: fn(&CutStep) -> f64| HistoryColumn {
        name: name.to_owned(),
        values: motion.cut.iter().map(value).collect(),
    };
    if !motion.cut.is_empty() {
        columns.extend([
            of_cut("weight_on_bit_kn", |cut| to_kn(cut.weight)),
            of_cut("rate_of_penetration_m_h", |cut| to_m_h(cut.rate)),
            of_cut("depth_of_cut_mm", |cut| to_mm(cut.depth_of_cut)),
            of_cut("bit_turns", |cut| cut.angle / std::f64::consts::TAU),
            of_cut("bit_depth_mm", |cut| to_mm(cut.depth)),
            of_cut("rock_depth_mm", |cut| to_mm(cut.rock_left())),
        ]);
    }
    let between_walls = motion.positions.iter().zip(&motion.wall_forces);
    for (site, (positions, forces)) in names.iter().zip(between_walls) {
        let of = |name: &str, vectors: &[[f64; 2]], axis: usize, unit: InUnit| HistoryColumn {
            name: format!("{site}_{name}"),
            values: vectors.iter().map(|vector| unit(vector[axis])).collect(),
        };
        columns.extend([
            of("x_mm", positions, 0, to_mm),
            of("y_mm", positions, 1, to_mm),
            of("wall_force_x_n", forces, 0, same),
            of("wall_force_y_n", forces, 1, same),
        ]);
    }
    columns
}

fn site_name(distance: f64) -> String {
    if distance == 0.0 {
        "bit".to_owned()
    } else {
        format!("{distance}m_above_bit")
    }
}
