//! What a design may vary.

/// A quantity that a design varies, named as in result files.
///
/// Those of the string come first: in a grid the first axis changes slowest, so
/// that the cases of one string are neighbours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Axis {
    /// A quantity of the string itself.
    String(StringAxis),
    /// Surface speed Ω, rpm.
    SurfaceSpeedRpm,
    /// Weight on bit W, kN.
    WeightOnBitKn,
    /// Dynamic torque T_d, N m.
    TorqueDynamicNm,
    /// Speed at which the surface lets the string down, m/h.
    FeedMH,
    /// Lateral impulse in multiples of I₀.
    ImpulseRatio,
    /// A quantity of the borehole wall, at every site.
    Wall(WallQuantity),
    /// The same at one site, independent of its value at every site.
    WallAtSite {
        /// Which site, counted from 0 in the order of the file.
        site: usize,
        /// Which quantity.
        quantity: WallQuantity,
    },
    /// Static coefficient of friction along the string.
    StringFriction,
    /// The dynamic coefficient in parts of that.
    StringFrictionRatio,
    /// Stribeck speed of that friction, rpm.
    StringFrictionSpeed,
    /// Static torque T_s by dynamic torque T_d.
    TorqueStaticRatio,
    /// Speed over which the torque falls from the one to the other, rpm.
    TorqueDecay,
    /// A constant of the rock's own law.
    Rock(RockConstant),
    /// Number of a start that is disturbed by chance; its whole part counts.
    StartNumber,
}

/// A quantity of the borehole wall. The exponent of Hertz' law is not among them: it is always 3/2.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum WallQuantity {
    /// Clearance c between string and wall.
    Clearance,
    /// Hertzian stiffness k_c.
    Stiffness,
    /// Coefficient of friction μ₀, static where it falls.
    Friction,
    /// Dynamic coefficient in parts of that.
    DynamicRatio,
    /// Stribeck speed of sliding.
    StribeckSpeed,
}

impl WallQuantity {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Clearance,
        Self::Stiffness,
        Self::Friction,
        Self::DynamicRatio,
        Self::StribeckSpeed,
    ];

    /// Its key in a sweep file, which is the name of its axis at every site.
    pub fn key(self) -> &'static str {
        match self {
            Self::Clearance => "clearance_mm",
            Self::Stiffness => "stiffness_gn_m15",
            Self::Friction => "friction",
            Self::DynamicRatio => "friction_dynamic_ratio",
            Self::StribeckSpeed => "friction_stribeck_m_s",
        }
    }
}

/// A constant of a rock's own law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum RockConstant {
    /// Radius of the bit.
    BitRadius,
    /// Intrinsic specific energy ε.
    SpecificEnergy,
    /// Ratio ζ of the cutting forces.
    CuttingRatio,
    /// Friction μγ at the wear flats.
    Friction,
    /// Contact strength σ.
    ContactStrength,
    /// Contact growth κ.
    ContactGrowth,
    /// Wear-flat length ℓ.
    WearFlat,
    /// Weight on bit from which cuttings are cleared poorly.
    PoorCleaningFrom,
    /// Torque per weight on bit beyond.
    PoorCleaningSlope,
}

impl RockConstant {
    /// All of them.
    pub const ALL: [Self; 9] = [
        Self::BitRadius,
        Self::SpecificEnergy,
        Self::CuttingRatio,
        Self::Friction,
        Self::ContactStrength,
        Self::ContactGrowth,
        Self::WearFlat,
        Self::PoorCleaningFrom,
        Self::PoorCleaningSlope,
    ];
}

/// A quantity of the string that a design varies: each value needs a separate linear system.
/// Sections, parts and sites are counted from 0, in the order of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum StringAxis {
    /// Distributed torsional damping c_t.
    TorsionalDamping,
    /// Distributed lateral damping c_b.
    BendingDamping,
    /// Pre-compression C.
    Compression,
    /// Number of cells of a section.
    Repeat {
        /// Which section.
        section: usize,
    },
    /// A measure of a tube.
    Tube {
        /// Which section.
        section: usize,
        /// Which part of its cell.
        part: usize,
        /// Which measure.
        measure: TubeMeasure,
    },
    /// The place of a site; impulses and masses there go with it.
    SitePlace {
        /// Which site.
        site: usize,
    },
    /// Moment of inertia of the top drive.
    DriveInertia,
    /// K_p of its controller.
    ProportionalGain,
    /// K_i of its controller.
    IntegralGain,
    /// Density of the mud.
    MudDensity,
    /// Its viscosity.
    MudViscosity,
    /// Loss factor η of the material and its joints.
    LossFactor,
    /// An eccentric mass.
    EccentricMass {
        /// Which one.
        mass: usize,
    },
    /// Its offset from the string's centre.
    EccentricOffset {
        /// Of which one.
        mass: usize,
    },
}

/// A measure of a tube.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum TubeMeasure {
    /// Its length.
    Length,
    /// Its internal radius.
    InnerRadius,
    /// Its external radius.
    OuterRadius,
}

impl TubeMeasure {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Length, Self::InnerRadius, Self::OuterRadius];

    /// Its key in a sweep file.
    pub fn key(self) -> &'static str {
        match self {
            Self::Length => "length_m",
            Self::InnerRadius => "inner_radius_m",
            Self::OuterRadius => "outer_radius_m",
        }
    }
}

impl Axis {
    /// Friction μ₀ of the borehole wall at every site.
    pub const FRICTION: Self = Self::Wall(WallQuantity::Friction);

    /// Whether it is a quantity of the string.
    pub fn is_of_string(self) -> bool {
        matches!(self, Axis::String(_))
    }

    /// Whether it changes the string: its quantities do, and the weight on bit where that pushes
    /// it.
    pub fn changes_string(self, weight_pushes: bool) -> bool {
        self.is_of_string() || (weight_pushes && self == Axis::WeightOnBitKn)
    }

    /// Whether it changes what a weight on bit or a torque means for the bit: each of its values
    /// has its own limit of stick-slip.
    pub fn changes_bit(self) -> bool {
        matches!(self, Axis::TorqueStaticRatio | Axis::Rock(_))
    }

    /// Whether it is a quantity of the wall, at every site or at one.
    pub fn is_of_wall(self) -> bool {
        matches!(self, Axis::Wall(_) | Axis::WallAtSite { .. })
    }

    /// Whether each of its values has its own limit of whirl, over the friction of every site. How
    /// friction falls does not matter: what rolls needs the static coefficient, what slides no
    /// less.
    pub fn changes_whirl_limit(self) -> bool {
        use WallQuantity::{Clearance, Friction, Stiffness};
        matches!(
            self,
            Axis::Wall(Clearance | Stiffness)
                | Axis::WallAtSite {
                    quantity: Clearance | Stiffness | Friction,
                    ..
                }
        )
    }

    /// Whether only whole numbers make sense.
    pub fn is_counted(self) -> bool {
        matches!(self, Axis::String(StringAxis::Repeat { .. }))
    }

    /// The numbers in its name, and zeros.
    pub(super) fn numbers(mut self) -> [usize; 2] {
        self.numbers_mut()
            .map(|number| number.map_or(0, |number| *number))
    }

    /// The axis of the same kind with these numbers in its name.
    pub(super) fn with_numbers(mut self, numbers: [usize; 2]) -> Self {
        for (slot, number) in self.numbers_mut().into_iter().zip(numbers) {
            if let Some(slot) = slot {
                *slot = number;
            }
        }
        self
    }

    fn numbers_mut(&mut self) -> [Option<&mut usize>; 2] {
        match self {
            Axis::String(StringAxis::Repeat { section }) => [Some(section), None],
            Axis::String(StringAxis::Tube { section, part, .. }) => [Some(section), Some(part)],
            Axis::String(StringAxis::SitePlace { site }) | Axis::WallAtSite { site, .. } => {
                [Some(site), None]
            }
            Axis::String(
                StringAxis::EccentricMass { mass } | StringAxis::EccentricOffset { mass },
            ) => [Some(mass), None],
            _ => [None, None],
        }
    }
}
