//! What is measured of a case and may be the colour of a map.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::field_units::{FORCE, TORQUE, WIDTH};
use super::units::{Unit, Units};

/// A measure of a case, named as its column of `labels.csv`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Measure {
    /// Largest less least bit speed in the closing window, by twice that of the surface.
    StickSlipSeverity,
    /// How far the surface is above the limit of stick-slip.
    StickSlipMarginRpm,
    /// Greatest speed of the bit.
    BitSpeedPeakRpm,
    /// Its mean speed in the closing window.
    BitSpeedClosingRpm,
    /// Period of stick-slip.
    PeriodS,
    /// How often the bit stuck.
    Sticks,
    /// Greatest radius of the site that decides.
    PeakRadiusMm,
    /// Its mean radius in the closing window.
    MeanRadiusMm,
    /// Share of the closing window in contact.
    ContactFraction,
    /// Share of that contact in rolling.
    RollingFraction,
    /// Rate of precession; backward where negative.
    PrecessionTurnsPerS,
    /// Mean normal force while in contact, in the closing window.
    NormalForceMeanKn,
    /// Greatest torque at the surface.
    SurfaceTorquePeakNm,
    /// Its greatest in the closing window.
    SurfaceTorqueGreatestNm,
    /// Greatest torque along the string.
    StringTorquePeakNm,
}

/// What has to be modelled for a measure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Needs {
    /// A torque at the bit.
    Bit,
    /// A borehole wall.
    Wall,
    /// The torque at the surface.
    SurfaceTorque,
    /// The torque along the string.
    StringTorque,
}

impl Measure {
    /// Its column in `labels.csv`.
    pub fn column(self) -> &'static str {
        match self {
            Self::StickSlipSeverity => "stick_slip_severity",
            Self::StickSlipMarginRpm => "stick_slip_margin_rpm",
            Self::BitSpeedPeakRpm => "bit_speed_peak_rpm",
            Self::BitSpeedClosingRpm => "bit_speed_closing_rpm",
            Self::PeriodS => "period_s",
            Self::Sticks => "sticks",
            Self::PeakRadiusMm => "peak_radius_mm",
            Self::MeanRadiusMm => "mean_radius_mm",
            Self::ContactFraction => "contact_fraction",
            Self::RollingFraction => "rolling_fraction",
            Self::PrecessionTurnsPerS => "precession_turns_per_s",
            Self::NormalForceMeanKn => "normal_force_mean_kn",
            Self::SurfaceTorquePeakNm => "surface_torque_peak_nm",
            Self::SurfaceTorqueGreatestNm => "surface_torque_greatest_nm",
            Self::StringTorquePeakNm => "string_torque_peak_nm",
        }
    }

    /// As a person reads it.
    pub fn words(self) -> &'static str {
        match self {
            Self::StickSlipSeverity => "Severity of stick-slip",
            Self::StickSlipMarginRpm => "Speed above the limit of stick-slip",
            Self::BitSpeedPeakRpm => "Greatest bit speed",
            Self::BitSpeedClosingRpm => "Mean bit speed in the closing window",
            Self::PeriodS => "Period of stick-slip",
            Self::Sticks => "Times the bit stuck",
            Self::PeakRadiusMm => "Greatest radius",
            Self::MeanRadiusMm => "Mean radius in the closing window",
            Self::ContactFraction => "Share of the closing window in contact",
            Self::RollingFraction => "Share of that contact in rolling",
            Self::PrecessionTurnsPerS => "Rate of precession, backward below zero",
            Self::NormalForceMeanKn => "Mean contact force while in contact",
            Self::SurfaceTorquePeakNm => "Greatest torque at the surface",
            Self::SurfaceTorqueGreatestNm => "Greatest torque at the surface in the closing window",
            Self::StringTorquePeakNm => "Greatest torque along the string",
        }
    }

    /// The unit in which it is shown.
    pub fn unit(self, units: Units) -> Unit {
        match self {
            Self::StickSlipMarginRpm | Self::BitSpeedPeakRpm | Self::BitSpeedClosingRpm => {
                Unit::unchanged("rpm")
            }
            Self::PeriodS => Unit::unchanged("s"),
            Self::PeakRadiusMm | Self::MeanRadiusMm => units.of(&WIDTH),
            Self::PrecessionTurnsPerS => Unit::unchanged("turns/s"),
            Self::NormalForceMeanKn => units.of(&FORCE),
            Self::SurfaceTorquePeakNm
            | Self::SurfaceTorqueGreatestNm
            | Self::StringTorquePeakNm => units.of(&TORQUE),
            Self::StickSlipSeverity
            | Self::Sticks
            | Self::ContactFraction
            | Self::RollingFraction => Unit::unchanged(""),
        }
    }

    /// What has to be modelled for it.
    pub fn needs(self) -> Needs {
        match self {
            Self::StickSlipSeverity
            | Self::StickSlipMarginRpm
            | Self::BitSpeedPeakRpm
            | Self::BitSpeedClosingRpm
            | Self::PeriodS
            | Self::Sticks => Needs::Bit,
            Self::PeakRadiusMm
            | Self::MeanRadiusMm
            | Self::ContactFraction
            | Self::RollingFraction
            | Self::PrecessionTurnsPerS
            | Self::NormalForceMeanKn => Needs::Wall,
            Self::SurfaceTorquePeakNm | Self::SurfaceTorqueGreatestNm => Needs::SurfaceTorque,
            Self::StringTorquePeakNm => Needs::StringTorque,
        }
    }
}
