//! What is asked of each configuration.

/// A quantity whose error is charted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Measure {
    /// Fig. 7(a): the bit's speed after a step of the surface's.
    SurfaceStep,
    /// The bit's speed in the end, of the surface's.
    SteadySpeed,
    /// k_eff, N m/rad.
    StaticStiffness,
    /// Δ of Eq. 75, rad/s per N m.
    Undershoot,
    /// Fig. 8(b): time of the first slip, s.
    FirstSlip,
    /// Fig. 8(b): time from slip to slip, s.
    Period,
    /// Fig. 9: Ω/T_d below which stick-slip sustains itself, rpm per kN m.
    StickSlipLimit,
    /// Fig. 7(b): the bit's displacement after a band-limited impulse.
    LateralImpulse,
    /// Fig. 12: radius of backward whirl, m.
    WhirlRadius,
    /// Fig. 12: its rate, turns a second.
    WhirlRate,
    /// Fig. 12: its normal force, N.
    WhirlForce,
    /// Fig. 14: friction above which an impulse of 3 I₀ starts whirl.
    WhirlLimit,
    /// Δ of Eq. 75 of a uniform tube, rad/s per N m.
    TubeUndershoot,
    /// Its Ω/T_d below which stick-slip sustains itself, rpm per kN m.
    TubeStickSlipLimit,
    /// The same by steps that divide the time of a wave along it.
    TubeFittedLimit,
    /// Δ of Eq. 75 of jointed pipe with collars, rad/s per N m.
    JointedUndershoot,
    /// Its Ω/T_d below which stick-slip sustains itself, rpm per kN m.
    JointedStickSlipLimit,
}

/// What a measure is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MeasureSubject {
    /// The paper's string in torsion.
    Torsion,
    /// The paper's string in bending.
    Bending,
    /// A uniform tube in torsion, whose fronts stay sharp.
    Tube,
    /// Jointed pipe with collars in torsion, lightly damped: every joint sends waves back.
    Jointed,
}

impl Measure {
    /// All, in the order of the chart and of the variants, each with its name in the table,
    /// where its value has a unit, and the title of its chart.
    #[rustfmt::skip]
    const ALL: [(Self, &'static str, &'static str); 17] = [
        (Self::SurfaceStep, "surface_step", "Step of surface speed, Fig. 7(a)"),
        (Self::SteadySpeed, "steady_speed_ratio", "Bit speed in the end"),
        (Self::StaticStiffness, "static_stiffness_nm_rad", "Static stiffness k_eff"),
        (Self::Undershoot, "undershoot_rad_s_nm", "Undershoot Δ, Eq. 75"),
        (Self::FirstSlip, "first_slip_s", "First slip, Fig. 8(b)"),
        (Self::Period, "stick_slip_period_s", "Stick-slip period, Fig. 8(b)"),
        (Self::StickSlipLimit, "stick_slip_limit_rpm_knm", "Limit of stick-slip, Fig. 9"),
        (Self::LateralImpulse, "lateral_impulse", "Lateral impulse, Fig. 7(b)"),
        (Self::WhirlRadius, "whirl_radius_m", "Radius of whirl, Fig. 12"),
        (Self::WhirlRate, "whirl_rate_turns_s", "Rate of whirl, Fig. 12"),
        (Self::WhirlForce, "whirl_normal_force_n", "Normal force of whirl, Fig. 12"),
        (Self::WhirlLimit, "whirl_limit_friction", "Limit of whirl at 3 I₀, Fig. 14"),
        (Self::TubeUndershoot, "tube_undershoot_rad_s_nm", "Undershoot Δ, uniform tube"),
        (Self::TubeStickSlipLimit, "tube_stick_slip_limit_rpm_knm", "Limit of stick-slip, uniform tube"),
        (Self::TubeFittedLimit, "tube_fitted_limit_rpm_knm", "The same, L/c in whole steps"),
        (Self::JointedUndershoot, "jointed_undershoot_rad_s_nm", "Undershoot Δ, joints and collars"),
        (Self::JointedStickSlipLimit, "jointed_limit_rpm_knm", "Its limit of stick-slip"),
    ];

    /// All, in the order of the chart.
    pub fn all() -> [Self; 17] {
        Self::ALL.map(|(measure, ..)| measure)
    }

    /// The name in the table, with the unit of its value.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// The title of its chart.
    pub fn title(self) -> &'static str {
        Self::ALL[self as usize].2
    }

    /// What it is of.
    pub fn subject(self) -> MeasureSubject {
        if self < Measure::LateralImpulse {
            MeasureSubject::Torsion
        } else if self < Measure::TubeUndershoot {
            MeasureSubject::Bending
        } else if self < Measure::JointedUndershoot {
            MeasureSubject::Tube
        } else {
            MeasureSubject::Jointed
        }
    }

    /// The measure of a name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::all()
            .into_iter()
            .find(|measure| measure.name() == name)
    }
}
