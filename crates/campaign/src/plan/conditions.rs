//! The operating conditions of a case: what the file says, unless an axis does.

use std::collections::BTreeMap;

use crate::design::Design;
use crate::quantities::{Axis, RPM, WallQuantity};
use crate::sweep_file::{FeedName, FileContent, LawTable, Source, SweepFileError};

/// Operating conditions of a case, in the units of their names.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Conditions {
    /// Surface speed, rpm.
    pub surface_speed_rpm: Option<f64>,
    /// Weight on bit, kN.
    pub weight_on_bit_kn: Option<f64>,
    /// Dynamic torque, N m.
    pub torque_dynamic_nm: Option<f64>,
    /// Speed at which the surface lets the string down, m/h.
    pub feed_m_h: Option<f64>,
    /// Lateral impulse in multiples of I₀, by an axis.
    pub impulse_ratio: Option<f64>,
    /// The wall at every site, by axes.
    pub wall: BTreeMap<WallQuantity, f64>,
    /// The wall at some sites, counted from 0 in the order of the file, by axes.
    pub wall_at: BTreeMap<(usize, WallQuantity), f64>,
    /// Static coefficient of friction along the string.
    pub string_friction: Option<f64>,
    /// The dynamic one in parts of that.
    pub string_friction_ratio: Option<f64>,
    /// Its Stribeck speed, rpm.
    pub string_friction_stribeck_rpm: Option<f64>,
    /// T_s by T_d.
    pub torque_static_ratio: Option<f64>,
    /// Speed over which the torque falls from the one to the other, rpm.
    pub torque_decay_rpm: Option<f64>,
    /// The rock's own law, where it has one.
    pub law: Option<LawTable>,
    /// Number of a start that is disturbed by chance, by an axis.
    pub start_number: Option<f64>,
    /// What the friction of every wall is multiplied by, wherever it is given.
    pub friction_factor: Option<f64>,
}

impl Conditions {
    /// These conditions with one of them changed. Weight on bit and torque
    /// replace one another.
    pub fn with(&self, axis: Axis, value: f64) -> Self {
        let mut changed = self.clone();
        match axis {
            Axis::SurfaceSpeedRpm => changed.surface_speed_rpm = Some(value),
            Axis::WeightOnBitKn => {
                changed.weight_on_bit_kn = Some(value);
                changed.torque_dynamic_nm = None;
            }
            Axis::TorqueDynamicNm => {
                changed.torque_dynamic_nm = Some(value);
                changed.weight_on_bit_kn = None;
            }
            Axis::FeedMH => changed.feed_m_h = Some(value),
            Axis::ImpulseRatio => changed.impulse_ratio = Some(value),
            Axis::Wall(quantity) => {
                changed.wall.insert(quantity, value);
            }
            Axis::WallAtSite { site, quantity } => {
                changed.wall_at.insert((site, quantity), value);
            }
            Axis::StringFriction => changed.string_friction = Some(value),
            Axis::StringFrictionRatio => changed.string_friction_ratio = Some(value),
            Axis::StringFrictionSpeed => changed.string_friction_stribeck_rpm = Some(value),
            Axis::TorqueStaticRatio => changed.torque_static_ratio = Some(value),
            Axis::TorqueDecay => changed.torque_decay_rpm = Some(value),
            Axis::Rock(constant) => {
                let place = changed.law.as_mut().and_then(|law| law.constant(constant));
                place.into_iter().for_each(|place| *place = value);
            }
            Axis::StartNumber => changed.start_number = Some(value),
            // Part of the setting.
            Axis::String(_) => {}
        }
        changed
    }

    /// These conditions with the given values along axes.
    pub fn along(&self, axes: &[Axis], values: &[f64]) -> Self {
        let axes = axes.iter().zip(values);
        axes.fold(self.clone(), |conditions, (&axis, &value)| {
            conditions.with(axis, value)
        })
    }

    /// The value along an axis, where it is known.
    pub fn value(&self, axis: Axis) -> Option<f64> {
        match axis {
            Axis::SurfaceSpeedRpm => self.surface_speed_rpm,
            Axis::WeightOnBitKn => self.weight_on_bit_kn,
            Axis::TorqueDynamicNm => self.torque_dynamic_nm,
            Axis::FeedMH => self.feed_m_h,
            Axis::ImpulseRatio => self.impulse_ratio,
            Axis::Wall(quantity) => self.wall.get(&quantity).copied(),
            Axis::WallAtSite { site, quantity } => self.wall_at.get(&(site, quantity)).copied(),
            Axis::StringFriction => self.string_friction,
            Axis::StringFrictionRatio => self.string_friction_ratio,
            Axis::StringFrictionSpeed => self.string_friction_stribeck_rpm,
            Axis::TorqueStaticRatio => self.torque_static_ratio,
            Axis::TorqueDecay => self.torque_decay_rpm,
            Axis::Rock(constant) => self.law?.constant(constant).copied(),
            Axis::StartNumber => self.start_number,
            Axis::String(_) => None,
        }
    }

    /// What axes say of the wall at a site of the file, or at another: what one says of this site
    /// alone goes before what another says of every site.
    pub fn of_wall(&self, site: Option<usize>, quantity: WallQuantity) -> Option<f64> {
        let own = site.and_then(|site| self.value(Axis::WallAtSite { site, quantity }));
        own.or_else(|| self.value(Axis::Wall(quantity)))
    }

    /// Surface speed, rad/s.
    pub fn surface_speed(&self) -> Option<f64> {
        self.surface_speed_rpm.map(|speed| speed * RPM)
    }

    /// Whether every case knows its value along an axis.
    pub fn has(&self, axis: Axis, design: &Design) -> bool {
        self.value(axis).is_some() || design.axes().contains(&axis)
    }
}

/// What the file says of the conditions; where the surface was recorded, its speed is in parts
/// of this.
///
/// # Errors
/// Where a value is refused.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    recorded_rpm: Option<f64>,
) -> Result<Conditions, SweepFileError> {
    let (bit, friction) = (content.bit.as_ref(), content.string_friction.as_ref());
    let conditions = Conditions {
        surface_speed_rpm: recorded_rpm.or(content.surface_speed_rpm),
        string_friction: friction.and_then(|friction| friction.static_coefficient),
        string_friction_ratio: friction.map(|friction| friction.dynamic_ratio),
        string_friction_stribeck_rpm: friction.map(|friction| friction.stribeck_rpm),
        weight_on_bit_kn: bit.and_then(|bit| bit.weight_on_bit_kn),
        torque_dynamic_nm: bit.and_then(|bit| bit.torque_dynamic_nm),
        feed_m_h: content.feed.and_then(|feed| feed.feed_m_h),
        torque_static_ratio: bit.map(|bit| bit.torque_static_ratio),
        torque_decay_rpm: bit.map(|bit| bit.torque_decay_rpm),
        law: bit.and_then(|bit| bit.law),
        ..Conditions::default()
    };
    for (key, axis) in [
        ("surface_speed_rpm", Axis::SurfaceSpeedRpm),
        ("bit.weight_on_bit_kn", Axis::WeightOnBitKn),
        ("bit.torque_dynamic_nm", Axis::TorqueDynamicNm),
        ("feed.feed_m_h", Axis::FeedMH),
        ("string_friction.static_coefficient", Axis::StringFriction),
        ("string_friction.dynamic_ratio", Axis::StringFrictionRatio),
        ("string_friction.stribeck_rpm", Axis::StringFrictionSpeed),
        ("bit.torque_static_ratio", Axis::TorqueStaticRatio),
        ("bit.torque_decay_rpm", Axis::TorqueDecay),
    ] {
        if let Some(value) = conditions.value(axis) {
            source.check_axis(key, axis, value)?;
        }
    }
    let has_both = conditions.weight_on_bit_kn.is_some() && conditions.torque_dynamic_nm.is_some();
    let message = "give the torque itself or a weight on bit, not both";
    source.refuse_if(has_both, "bit.torque_dynamic_nm", message)?;
    Ok(conditions)
}

/// Every case must know its surface speed and, with a bit, its torque.
///
/// # Errors
/// Names what is missing, or there twice.
pub fn are_complete(
    source: &Source,
    content: &FileContent,
    conditions: &Conditions,
    design: &Design,
) -> Result<(), SweepFileError> {
    let has = |axis| conditions.has(axis, design);
    let message = "is needed: give a number, or make it an axis of the design";
    source.refuse_if(!has(Axis::SurfaceSpeedRpm), "surface_speed_rpm", message)?;
    let of_friction = |axis: &&Axis| {
        use Axis::{StringFriction, StringFrictionRatio, StringFrictionSpeed};
        matches!(
            axis,
            StringFriction | StringFrictionRatio | StringFrictionSpeed
        )
    };
    match (
        content.string_friction,
        design.axes().iter().find(of_friction),
    ) {
        (None, Some(axis)) => {
            let message = format!("the axis {} needs a table [string_friction]", axis.name());
            return Err(source.error("design", message));
        }
        (Some(_), _) if !has(Axis::StringFriction) => {
            let message =
                "needs `static_coefficient`, or `string_friction` as an axis of the design";
            return Err(source.error("string_friction", message));
        }
        _ => {}
    }
    let mut of_bit = (design.axes().iter()).filter(|axis| {
        matches!(
            axis,
            Axis::TorqueStaticRatio | Axis::TorqueDecay | Axis::Rock(_)
        )
    });
    if let Some(axis) = of_bit.find(|axis| conditions.value(**axis).is_none()) {
        let needs = match axis {
            Axis::Rock(_) if conditions.law.is_some() => "poor cleaning in [bit.law]",
            Axis::Rock(_) => "a rock with `law`: a table [bit.law]",
            _ => "a table [bit]",
        };
        let key = format!("design.axes.{}", axis.name());
        return Err(source.error(&key, format!("needs {needs}")));
    }
    let cuts = content.has_cutting();
    let is_of_cutting = |axis: &&Axis| matches!(axis, Axis::FeedMH | Axis::StartNumber);
    if let Some(axis) = design.axes().iter().find(is_of_cutting).filter(|_| !cuts) {
        let key = format!("design.axes.{}", axis.name());
        return Err(source.error(&key, "needs a bit with [bit.cutting]"));
    }
    let gives_torque = |axis: &&Axis| matches!(axis, Axis::WeightOnBitKn | Axis::TorqueDynamicNm);
    let mut torques = design.axes().iter().filter(gives_torque);
    let Some(bit) = &content.bit else {
        return torques.next().map_or(Ok(()), |axis| {
            let message = format!("the axis {} needs a table [bit]", axis.name());
            Err(source.error("design", message))
        });
    };
    if bit.cutting.is_some() {
        return is_complete_with_cutting(source, content, conditions, design);
    }
    let has_weight = has(Axis::WeightOnBitKn);
    let message = "a weight on bit needs a rock to give a torque: \
                   `sandstone`, `shale`, `law` or `table`";
    source.refuse_if(has_weight && bit.rock.is_none(), "bit.rock", message)?;
    let message = "weight on bit and torque cannot both be axes: one gives the other";
    source.refuse_if(torques.count() > 1, "design", message)?;
    let message = "needs `torque_dynamic_nm`, or a rock and `weight_on_bit_kn`, \
                   or one of them as an axis of the design";
    source.refuse_if(!has_weight && !has(Axis::TorqueDynamicNm), "bit", message)
}

/// Every case must know what its surface is set to.
///
/// # Errors
/// Names what is missing, or there in vain.
fn is_complete_with_cutting(
    source: &Source,
    content: &FileContent,
    conditions: &Conditions,
    design: &Design,
) -> Result<(), SweepFileError> {
    let has = |axis| conditions.has(axis, design);
    let idle = [
        Axis::TorqueDynamicNm,
        Axis::TorqueStaticRatio,
        Axis::TorqueDecay,
    ];
    if let Some(axis) = design.axes().iter().find(|axis| idle.contains(axis)) {
        let key = format!("design.axes.{}", axis.name());
        let message = "with [bit.cutting] the torque follows from the depth of cut";
        return Err(source.error(&key, message));
    }
    match content.feed.unwrap_or_default().kind {
        FeedName::HookLoad => {
            let message = "needs `weight_on_bit_kn`, or that as an axis of the design";
            source.refuse_if(!has(Axis::WeightOnBitKn), "bit", message)?;
            let message = "the hook load decides how fast the string goes down: leave it out, or \
                           write `kind = \"speed\"` in [feed]";
            let key = match conditions.feed_m_h {
                Some(_) => "feed.feed_m_h",
                None => "design.axes.feed_m_h",
            };
            source.refuse_if(has(Axis::FeedMH), key, message)
        }
        FeedName::Speed => {
            let message = "needs `feed_m_h`, or that as an axis of the design";
            source.refuse_if(!has(Axis::FeedMH), "feed", message)?;
            let message = "the weight on bit follows from the feed: leave it out";
            let key = match conditions.weight_on_bit_kn {
                Some(_) => "bit.weight_on_bit_kn",
                None => "design.axes.weight_on_bit_kn",
            };
            source.refuse_if(has(Axis::WeightOnBitKn), key, message)
        }
    }
}
