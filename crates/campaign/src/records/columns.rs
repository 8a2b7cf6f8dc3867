//! The columns of results, each in one row of one table: its name with the unit, what it holds,
//! its words for people, what it measures, and how it follows from a record.

use sim::{Label, Motion};

use super::column::{
    Group, ResultColumn, count, flag, number, text, to_g, to_kn, to_kn_m, to_m_h, to_mm, to_mpa,
    to_rpm, to_turns,
};
use super::field::Field;
use super::verdict::MotionVerdict;

/// How the columns of what cases are held against begin.
pub const MISFIT: &str = "misfit_";

/// Columns by the names of earlier versions, and as they are called now.
pub const RENAMED: [(&str, &str); 6] = [
    ("foretold", "predicted"),
    ("acceleration_peak_g", "acceleration_step_peak_g"),
    ("acceleration_rms_g", "acceleration_step_rms_g"),
    (
        "tangential_acceleration_peak_g",
        "tangential_acceleration_step_peak_g",
    ),
    (
        "axial_acceleration_peak_g",
        "axial_acceleration_step_peak_g",
    ),
    ("axial_acceleration_rms_g", "axial_acceleration_step_rms_g"),
];

/// The name that a column has now, by that or an earlier one.
pub fn name_now(name: &str) -> &str {
    let renamed = RENAMED.iter().find(|(old, _)| *old == name);
    renamed.map_or(name, |(_, new)| new)
}

/// Whether a column of this name says what a run has found, or of which row, and is no axis.
pub fn is_of_results(name: &str) -> bool {
    let is_first = ["case", "method"].contains(&name);
    is_first || name.starts_with(MISFIT) || ResultColumn::named(name).is_some()
}

/// All columns of results, in their order. Those of what cases are held against, which a sweep
/// names itself, follow [`Group::Wall`].
pub static COLUMNS: &[ResultColumn] = &[
    text("torsion", "Torsion", |row| row.label(Motion::Torsion)).of(Motion::Torsion),
    text("lateral", "Lateral motion", |row| {
        row.label(Motion::Lateral)
    })
    .of(Motion::Lateral),
    number("first_slip_s", "s", "First slip at", |row| {
        row.torsion().and_then(|it| it.first_slip).into()
    })
    .of(Motion::Torsion),
    number("period_s", "s", "Period of stick-slip", |row| {
        row.torsion().and_then(|it| it.period).into()
    })
    .of(Motion::Torsion)
    .measure(),
    number("slip_time_s", "s", "Time slipping in a period", |row| {
        row.torsion().and_then(|it| it.slip_time).into()
    })
    .of(Motion::Torsion),
    count("sticks", "Times the bit stuck", |row| {
        row.torsion().map(|it| it.sticks).into()
    })
    .of(Motion::Torsion)
    .measure(),
    number("bit_speed_peak_rpm", "rpm", "Greatest bit speed", |row| {
        row.torsion().map(|it| to_rpm(it.peak_speed)).into()
    })
    .of(Motion::Torsion)
    .measure(),
    number(
        "bit_speed_closing_rpm",
        "rpm",
        "Mean bit speed in the closing window",
        |row| row.torsion().map(|it| to_rpm(it.closing_speed)).into(),
    )
    .of(Motion::Torsion)
    .measure(),
    number("stick_slip_severity", "", "Severity of stick-slip", |row| {
        row.torsion().and_then(|it| it.severity).into()
    })
    .of(Motion::Torsion)
    .measure()
    .severity(),
    number(
        STICK_SLIP_MARGIN,
        "rpm",
        "Speed above the one-slip estimate (Eq. 74)",
        |row| row.record.above_limit.map(to_rpm).into(),
    )
    .of(Motion::Torsion)
    .measure(),
    number(
        "site_from_bit_m",
        "m",
        "Site that decides, from the bit",
        |row| row.lateral().and(row.record.site_from_bit_m).into(),
    )
    .of(Motion::Lateral),
    number("first_contact_s", "s", "First contact at", |row| {
        row.lateral().and_then(|it| it.first_contact).into()
    })
    .of(Motion::Lateral),
    number("peak_radius_mm", "mm", "Greatest radius", |row| {
        row.lateral().map(|it| to_mm(it.peak_radius)).into()
    })
    .of(Motion::Lateral)
    .measure(),
    number(
        "mean_radius_mm",
        "mm",
        "Mean radius in the closing window",
        |row| row.lateral().map(|it| to_mm(it.mean_radius)).into(),
    )
    .of(Motion::Lateral)
    .measure(),
    number(
        "contact_fraction",
        "",
        "Share of the closing window in contact",
        |row| row.lateral().map(|it| it.contact_fraction).into(),
    )
    .of(Motion::Lateral)
    .measure()
    .severity(),
    number(
        "rolling_fraction",
        "",
        "Share of that contact in rolling",
        |row| row.lateral().map(|it| it.rolling_fraction).into(),
    )
    .of(Motion::Lateral)
    .measure(),
    number(
        "precession_turns_per_s",
        "turns/s",
        "Rate of precession, backward below zero",
        |row| row.lateral().map(|it| to_turns(it.precession_rate)).into(),
    )
    .of(Motion::Lateral)
    .measure(),
    number(
        "normal_force_mean_kn",
        "kN",
        "Mean contact force while in contact",
        |row| row.lateral().map(|it| to_kn(it.mean_normal_force)).into(),
    )
    .of(Motion::Lateral)
    .measure(),
    count(
        "ambiguous_steps",
        "Steps with more than one answer",
        |row| row.lateral().map(|it| it.ambiguous_steps).into(),
    )
    .of(Motion::Lateral),
    text("predicted", "Label predicted when it had settled", |row| {
        let predicted = row.outcome.and_then(|outcome| outcome.predicted);
        predicted.map(Label::name).into()
    }),
    number("simulated_s", "s", "Simulated", |row| {
        row.outcome.map(|outcome| outcome.simulated).into()
    }),
    text("ended", "Ended", |row| {
        row.outcome.map(|outcome| outcome.ended.name()).into()
    }),
    text("status", "Status", |row| {
        row.outcome.map_or(FAILED, |_| DONE).into()
    }),
    text("axial", "Axial motion", |row| row.label(Motion::Axial))
        .of(Motion::Axial)
        .group(Group::Cutting),
    number(
        "rate_of_penetration_m_h",
        "m/h",
        "Mean rate of penetration in the closing window",
        |row| row.axial().map(|it| to_m_h(it.rate_of_penetration)).into(),
    )
    .of(Motion::Axial)
    .group(Group::Cutting)
    .measure()
    .severity(),
    number(
        "rate_of_penetration_ratio",
        "",
        "Rate of penetration by that of steady drilling",
        |row| row.axial().and_then(|it| it.part_of_steady).into(),
    )
    .of(Motion::Axial)
    .group(Group::Cutting)
    .measure(),
    number(
        "off_bottom_fraction",
        "",
        "Share of the closing window off bottom",
        |row| row.axial().map(|it| it.off_bottom).into(),
    )
    .of(Motion::Axial)
    .group(Group::Cutting)
    .measure()
    .severity(),
    number(
        "axial_rest_fraction",
        "",
        "Share of the closing window in which the bit turns and rests on its flats, going neither down nor up",
        |row| row.axial().map(|it| it.at_rest).into(),
    )
    .of(Motion::Axial)
    .group(Group::Cutting)
    .measure(),
    number(
        "turns_back_fraction",
        "",
        "Share of the closing window in which the bit turns back",
        |row| row.axial().map(|it| it.turns_back).into(),
    )
    .of(Motion::Axial)
    .group(Group::Cutting)
    .measure(),
    number(
        "weight_mean_kn",
        "kN",
        "Mean weight on bit in the closing window",
        |row| row.axial().map(|it| to_kn(it.mean_weight)).into(),
    )
    .of(Motion::Axial)
    .group(Group::Cutting)
    .measure(),
    number(
        "weight_peak_kn",
        "kN",
        "Greatest weight on bit in the closing window",
        |row| row.axial().map(|it| to_kn(it.peak_weight)).into(),
    )
    .of(Motion::Axial)
    .group(Group::Cutting)
    .measure(),
    number(
        "depth_of_cut_peak_mm",
        "mm",
        "Greatest depth of cut of a blade in the closing window",
        |row| row.axial().map(|it| to_mm(it.peak_depth_of_cut)).into(),
    )
    .of(Motion::Axial)
    .group(Group::Cutting)
    .measure(),
    number(
        "axial_acceleration_band_peak_g",
        "g",
        "Greatest acceleration along the axis within the band, in the closing window",
        |row| row.axial_in_band().map(|it| to_g(it.peak)).into(),
    )
    .of(Motion::Axial)
    .group(Group::Cutting)
    .measure()
    .severity(),
    number(
        "axial_acceleration_band_rms_g",
        "g",
        "Acceleration along the axis within the band, root mean square over the closing window",
        |row| row.axial_in_band().map(|it| to_g(it.rms)).into(),
    )
    .of(Motion::Axial)
    .group(Group::Cutting)
    .measure()
    .severity(),
    number(
        "axial_acceleration_band_hz",
        "Hz",
        "Band of the acceleration along the axis",
        |row| row.axial_in_band().map(|it| it.band).into(),
    )
    .of(Motion::Axial)
    .group(Group::Cutting),
    number(
        "axial_acceleration_step_peak_g",
        "g",
        "Greatest acceleration along the axis between steps, in the closing window",
        |row| row.axial_acceleration().map(|it| to_g(it.step_peak)).into(),
    )
    .of(Motion::Axial)
    .group(Group::Cutting)
    .measure(),
    number(
        "axial_acceleration_step_rms_g",
        "g",
        "Acceleration along the axis between steps, root mean square over the closing window",
        |row| row.axial_acceleration().map(|it| to_g(it.step_rms)).into(),
    )
    .of(Motion::Axial)
    .group(Group::Cutting)
    .measure(),
    number(
        "climb_deg",
        "deg",
        "Mean angle from the low side in the closing window",
        |row| row.lying().map(|it| it.climb.to_degrees()).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Lying)
    .measure(),
    number(
        "swing_deg",
        "deg",
        "Swing to either side of the mean angle",
        |row| row.lying().map(|it| it.swing_amplitude.to_degrees()).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Lying)
    .measure()
    .severity(),
    number(
        "swing_frequency_hz",
        "Hz",
        "Frequency of the swing",
        |row| row.lying().map(|it| it.swing_frequency).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Lying)
    .measure(),
    number(
        "greatest_angle_deg",
        "deg",
        "Greatest angle of any site from the low side",
        |row| row.lying().map(|it| it.greatest_angle.to_degrees()).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Lying)
    .measure(),
    number(
        "acceleration_band_peak_g",
        "g",
        "Greatest acceleration sideways within the band, in the closing window",
        |row| row.sideways().map(|it| to_g(it.peak)).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Shocks)
    .measure()
    .severity(),
    number(
        "acceleration_band_rms_g",
        "g",
        "Root mean square of the acceleration sideways there",
        |row| row.sideways().map(|it| to_g(it.rms)).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Shocks)
    .measure(),
    number(
        "tangential_acceleration_band_peak_g",
        "g",
        "Greatest acceleration there along the string's surface within the band",
        |row| row.tangential().map(|it| to_g(it.peak)).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Shocks)
    .measure(),
    number(
        "tangential_acceleration_band_rms_g",
        "g",
        "Root mean square of the acceleration there along the string's surface",
        |row| row.tangential().map(|it| to_g(it.rms)).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Shocks)
    .measure(),
    number(
        "acceleration_band_hz",
        "Hz",
        "Band of the accelerations there",
        |row| row.sideways().map(|it| it.band).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Shocks),
    number(
        "lateral_shocks_per_s",
        "shocks/s",
        "Rate of shocks sideways there",
        |row| row.shocks().map(|it| it.shocks_per_second).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Shocks)
    .measure(),
    number(
        "acceleration_from_bit_m",
        "m",
        "Place of the greatest acceleration sideways, from the bit",
        |row| row.shocks().and(row.record.shock_from_bit_m).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Shocks),
    number(
        "acceleration_step_peak_g",
        "g",
        "Greatest acceleration sideways there between steps",
        |row| row.shocks().map(|it| to_g(it.step_peak)).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Shocks)
    .measure(),
    number(
        "acceleration_step_rms_g",
        "g",
        "Root mean square of the acceleration sideways there between steps",
        |row| row.shocks().map(|it| to_g(it.step_rms)).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Shocks)
    .measure(),
    number(
        "tangential_acceleration_step_peak_g",
        "g",
        "Greatest acceleration there along the string's surface between steps",
        |row| row.shocks().map(|it| to_g(it.tangential_step_peak)).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Shocks)
    .measure(),
    number(
        "bending_moment_peak_kn_m",
        "kN m",
        "Greatest bending moment in the closing window",
        |row| row.stress().map(|it| to_kn_m(it.moment.value)).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Stress)
    .measure(),
    number(
        "bending_moment_from_bit_m",
        "m",
        "Place of the greatest bending moment, from the bit",
        |row| row.stress().map(|it| it.moment.from_bit).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Stress),
    number(
        "bending_stress_peak_mpa",
        "MPa",
        "Greatest bending stress in the closing window",
        |row| row.stress().map(|it| to_mpa(it.bending.value)).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Stress)
    .measure(),
    number(
        "bending_stress_amplitude_mpa",
        "MPa",
        "Greatest amplitude of bending stress at a point of the turning string",
        |row| row.stress().map(|it| to_mpa(it.amplitude.value)).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Stress)
    .measure()
    .severity(),
    number(
        "bending_stress_from_bit_m",
        "m",
        "Place of the greatest bending stress, from the bit",
        |row| row.stress().map(|it| it.bending.from_bit).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Stress),
    number(
        "von_mises_peak_mpa",
        "MPa",
        "Greatest von Mises stress in the closing window",
        |row| row.stress().map(|it| to_mpa(it.von_mises.value)).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Stress)
    .measure(),
    number(
        "von_mises_from_bit_m",
        "m",
        "Place of the greatest von Mises stress, from the bit",
        |row| row.stress().map(|it| it.von_mises.from_bit).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Stress),
    number(
        "surface_torque_peak_nm",
        "N m",
        "Greatest torque at the surface",
        |row| row.surface().map(|it| it.peak_torque).into(),
    )
    .group(Group::Surface)
    .measure(),
    number(
        "surface_torque_least_nm",
        "N m",
        "Least torque at the surface in the closing window",
        |row| row.surface().map(|it| it.least_torque).into(),
    )
    .group(Group::Surface),
    number(
        "surface_torque_mean_nm",
        "N m",
        "Mean torque at the surface in the closing window",
        |row| row.surface().map(|it| it.mean_torque).into(),
    )
    .group(Group::Surface),
    number(
        "surface_torque_greatest_nm",
        "N m",
        "Greatest torque at the surface in the closing window",
        |row| row.surface().map(|it| it.greatest_torque).into(),
    )
    .group(Group::Surface)
    .measure(),
    number(
        "string_torque_peak_nm",
        "N m",
        "Greatest torque along the string",
        |row| row.string_torque().map(|it| it.peak_torque).into(),
    )
    .group(Group::String)
    .measure(),
    number(
        "string_torque_peak_from_bit_m",
        "m",
        "Place of the greatest torque along the string, from the bit",
        |row| row.string_torque().map(|it| it.from_bit).into(),
    )
    .group(Group::String),
    flag(
        MOTOR_STALLED,
        "Mud motor stalls in the closing window",
        |row| row.motor_stalled().into(),
    )
    .of(Motion::Torsion)
    .group(Group::Motor),
    number(
        "motor_stalled_fraction",
        "",
        "Share of the closing window in which the mud motor stalls",
        |row| row.motor_stalled_fraction().into(),
    )
    .of(Motion::Torsion)
    .group(Group::Motor)
    .measure(),
    number(
        PUSH_COLUMNS[0],
        "mm",
        "Greatest depth to which a wall gives way",
        |row| row.wall_push().map(|it| to_mm(it.depth)).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Wall)
    .measure(),
    number(
        PUSH_COLUMNS[1],
        "m",
        "Place of the greatest depth to which a wall gives way, from the bit",
        |row| row.wall_push().map(|it| it.from_bit).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Wall),
    number(PUSH_COLUMNS[2], "kN", "Normal force there", |row| {
        row.wall_push().and_then(|it| it.force).map(to_kn).into()
    })
    .of(Motion::Lateral)
    .group(Group::Wall)
    .measure(),
    number(
        PUSH_COLUMNS[3],
        "MPa",
        "Mean pressure on the wall there",
        |row| {
            row.wall_push()
                .and_then(|it| it.pressure)
                .map(to_mpa)
                .into()
        },
    )
    .of(Motion::Lateral)
    .group(Group::Wall)
    .measure(),
    flag(
        PUSH_COLUMNS[4],
        "Rock of the wall would break there",
        |row| row.wall_push().and_then(|it| it.breaks).into(),
    )
    .of(Motion::Lateral)
    .group(Group::Wall),
    text("finer_torsion", "Torsion by shorter steps", |row| {
        row.finer_label(Motion::Torsion)
    })
    .of(Motion::Torsion)
    .group(Group::Certificate),
    text("finer_lateral", "Lateral motion by shorter steps", |row| {
        row.finer_label(Motion::Lateral)
    })
    .of(Motion::Lateral)
    .group(Group::Certificate),
    number(
        "finer_stick_slip_margin_rpm",
        "rpm",
        "Speed above the one-slip estimate (Eq. 74) by shorter steps",
        |row| match row.finer(Motion::Torsion) {
            Some(MotionVerdict::Torsion { above_limit, .. }) => above_limit.map(to_rpm).into(),
            _ => Field::Nothing,
        },
    )
    .of(Motion::Torsion)
    .group(Group::Certificate),
    number(
        "finer_contact_fraction",
        "",
        "Share of the closing window in contact by shorter steps",
        |row| match row.finer(Motion::Lateral) {
            Some(MotionVerdict::Lateral {
                contact_fraction, ..
            }) => contact_fraction.into(),
            _ => Field::Nothing,
        },
    )
    .of(Motion::Lateral)
    .group(Group::Certificate),
    number(
        "finer_precession_turns_per_s",
        "turns/s",
        "Rate of precession by shorter steps",
        |row| match row.finer(Motion::Lateral) {
            Some(MotionVerdict::Lateral {
                precession_rate, ..
            }) => to_turns(precession_rate).into(),
            _ => Field::Nothing,
        },
    )
    .of(Motion::Lateral)
    .group(Group::Certificate),
    flag("torsion_certified", "Label of torsion is certain", |row| {
        row.certainty[Motion::Torsion].into()
    })
    .of(Motion::Torsion)
    .group(Group::Certificate),
    flag(
        "lateral_certified",
        "Label of lateral motion is certain",
        |row| row.certainty[Motion::Lateral].into(),
    )
    .of(Motion::Lateral)
    .group(Group::Certificate),
    flag(
        "nearby_torsion_agrees",
        "Same label of torsion at speeds up to 10 % lower and higher",
        |row| row.record.agrees_nearby.into(),
    )
    .of(Motion::Torsion)
    .group(Group::Certificate),
    number(
        "finer_normal_force_mean_kn",
        "kN",
        "Mean contact force by shorter steps",
        |row| match row.finer(Motion::Lateral) {
            Some(MotionVerdict::Lateral {
                mean_normal_force, ..
            }) => mean_normal_force.map(to_kn).into(),
            _ => Field::Nothing,
        },
    )
    .of(Motion::Lateral)
    .group(Group::Certificate),
    flag(
        WHIRL_AGREES,
        "Rate and force of whirl are alike by all that certify",
        |row| row.certainty.whirl_agrees.into(),
    )
    .of(Motion::Lateral)
    .group(Group::Certificate),
    number(
        "finer_swing_deg",
        "deg",
        "Swing to either side of the mean angle by shorter steps",
        |row| match row.finer(Motion::Lateral) {
            Some(MotionVerdict::Lateral {
                swing_amplitude, ..
            }) => swing_amplitude.map(f64::to_degrees).into(),
            _ => Field::Nothing,
        },
    )
    .of(Motion::Lateral)
    .group(Group::Certificate),
    text(
        "torsion_from_stuck",
        "Torsion after the bit was held",
        |row| row.record.by_start.map(|it| it.stuck.name()).into(),
    )
    .of(Motion::Torsion)
    .group(Group::Starts),
    text(
        "torsion_from_smooth",
        "Torsion after smooth rotation",
        |row| row.record.by_start.map(|it| it.smooth.name()).into(),
    )
    .of(Motion::Torsion)
    .group(Group::Starts),
    text(FOUND_SITES, "Sites found, m from the bit", |row| {
        row.found_sites()
    })
    .group(Group::Found),
    count(FOUND_ROUNDS, "Times run again for sites", |row| {
        row.record.found.as_ref().map(|found| found.rounds).into()
    })
    .group(Group::Found),
];

/// The column of the speed above the one-slip estimate of stick-slip (Eq. 74).
pub const STICK_SLIP_MARGIN: &str = "stick_slip_margin_rpm";
/// The columns of the hardest push into a wall: its depth, its place, force and mean pressure there,
/// and whether that breaks the rock.
pub const PUSH_COLUMNS: [&str; 5] = [
    "wall_penetration_mm",
    "wall_penetration_from_bit_m",
    "wall_force_kn",
    "wall_pressure_mpa",
    "wall_breaks",
];
/// The column of whether the mud motor stalls.
pub const MOTOR_STALLED: &str = "motor_stalled";
/// The column of whether rate and force of whirl are alike by all that certify.
pub const WHIRL_AGREES: &str = "whirl_rate_and_force_agree";
/// The column of the sites that were found.
pub const FOUND_SITES: &str = "found_sites_from_bit_m";
/// That of how often a case was run again for them.
pub const FOUND_ROUNDS: &str = "found_rounds";

/// The status of a case with an answer.
const DONE: &str = "ok";
/// That of one without.
pub const FAILED: &str = "failed";

/// The end of the names of such columns.
const CERTIFIED: &str = "_certified";

impl ResultColumn {
    /// The column of a name, or of an earlier one.
    pub fn named(name: &str) -> Option<&'static Self> {
        let name = name_now(name);
        COLUMNS.iter().find(|column| column.name == name)
    }

    /// The column of whether the label of a motion is certain.
    pub fn certainty_of(motion: Motion) -> &'static str {
        let of_motion = COLUMNS.iter().filter(|it| it.motion == Some(motion));
        let mut names = of_motion.map(|it| it.name);
        let certified = names.find(|name| name.ends_with(CERTIFIED));
        certified.unwrap_or(CERTIFIED)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantities::Units;

    #[test]
    fn a_name_is_that_of_one_column() {
        for column in COLUMNS {
            let named = ResultColumn::named(column.name).unwrap();
            assert!(std::ptr::eq(named, column), "{}", column.name);
        }
    }

    #[test]
    fn every_motion_has_a_label_and_a_certainty() {
        for motion in Motion::ALL {
            let motion_of = |name| ResultColumn::named(name).and_then(|column| column.motion);
            assert_eq!(motion_of(ResultColumn::label_of(motion)), Some(motion));
            // A bit that cuts is never certain.
            let certain = Some(motion).filter(|motion| *motion != Motion::Axial);
            assert_eq!(motion_of(ResultColumn::certainty_of(motion)), certain);
        }
    }

    /// A number is written in the unit that its name ends in.
    #[test]
    fn names_end_in_units() {
        for column in COLUMNS.iter().filter(|column| !column.unit.is_empty()) {
            let ending = match column.unit {
                "N m" => "nm".to_owned(),
                "kN m" => "kn_m".to_owned(),
                "m/h" => "m_h".to_owned(),
                unit => unit.to_lowercase().replace('/', "_per_"),
            };
            let stem = column.name.strip_suffix(&ending);
            assert!(
                stem.is_some_and(|stem| stem.ends_with('_')),
                "{}",
                column.name
            );
        }
    }

    /// What the words say of each is what its name says; a test of motions holds the names.
    #[test]
    fn words_say_what_names_say() {
        for column in COLUMNS {
            for (part, word) in [
                ("peak_rpm", "greatest"),
                ("peak_nm", "greatest"),
                ("peak_radius", "greatest"),
                ("greatest", "greatest"),
                ("least", "least"),
                ("mean", "mean"),
                ("closing", "mean"),
                ("fraction", "share"),
                ("severity", "severity"),
            ] {
                let says = column.words.to_lowercase().contains(word);
                assert!(!column.name.contains(part) || says, "{}", column.name);
            }
        }
    }

    #[test]
    fn numbers_are_in_the_units_that_are_shown() {
        let unit = |name| ResultColumn::named(name).unwrap().unit(Units::Field);
        let place = unit("string_torque_peak_from_bit_m");
        assert_eq!(place.name, "ft");
        assert!((place.number(1.0) - 1.0 / 0.3048).abs() < 1e-12);
        assert_eq!(unit("stick_slip_margin_rpm").name, "rpm");
        assert_eq!(unit("contact_fraction").name, "");
    }
}
