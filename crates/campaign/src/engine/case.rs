//! One case: its values and its scene.

use linear::SteadyMotion;
use sim::{Axial, BitTorque, Lateral, PipeFriction, Scene, Start, Wall};
use statics::{StaticState, StaticsError};

use super::case_error::CaseError;
use super::timing::timing_by_rule;
use crate::plan::{
    Begins, Conditions, ImpulseAmount, LateralSettings, LyingStart, Setting, Starts, Sweep,
};
use crate::sweep_file::{AutoOr, StartName};

/// One case of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Its number, from 0.
    pub index: usize,
    /// Its values along the design's axes.
    pub values: Vec<f64>,
    /// T_d, N m, where the bit is modelled.
    pub torque_dynamic_nm: Option<f64>,
    /// Under which conditions.
    pub conditions: Conditions,
    /// How it begins,
    pub starts: Starts,
    /// and whether it is the second of both ways.
    is_begun_otherwise: bool,
    /// What is simulated.
    pub scene: Scene,
}

impl Case {
    /// Case `index` of a sweep, whose string is that of `setting`.
    ///
    /// # Errors
    /// Where a rock's table does not reach its weight on bit.
    pub fn of(sweep: &Sweep, setting: &Setting, index: usize) -> Result<Self, CaseError> {
        let values = sweep.design.values(index);
        let conditions = sweep.conditions_at(&values);
        Self::under(sweep, setting, index, values, &conditions)
            .map_err(|reason| CaseError::Numbered(index, Box::new(reason)))
    }

    /// A case under given conditions, which may differ from the design's.
    ///
    /// # Errors
    /// As [`Case::of`].
    pub fn under(
        sweep: &Sweep,
        setting: &Setting,
        index: usize,
        values: Vec<f64>,
        conditions: &Conditions,
    ) -> Result<Self, CaseError> {
        let surface_speed = conditions.surface_speed();
        let surface_speed = surface_speed.ok_or(CaseError::Missing("surface speed"))?;
        let (torque_dynamic_nm, bit) = match &sweep.bit {
            None => (None, None),
            Some(bit) if setting.cutting.is_some() => (bit.torque_dynamic(conditions)?, None),
            Some(bit) => {
                let torque = bit.torque_dynamic(conditions)?;
                let torque = torque.ok_or(CaseError::Missing("torque"))?;
                (Some(torque), Some(conditions.torques(torque)))
            }
        };
        let friction = friction_along(setting, conditions)?;
        let all = together(bit, &friction);
        let drilled = drilled(sweep, setting, conditions, surface_speed)?;
        let (start, axial) = match drilled {
            Some((start, axial)) => (start, Some(axial)),
            None => (
                sweep.starts.first(setting, surface_speed, bit.as_ref()),
                None,
            ),
        };
        let lying_start = sweep.starts.lying(surface_speed);
        let mut timing = timing_by_rule(
            setting,
            surface_speed,
            all.as_ref(),
            &start,
            axial.as_ref().map(|axial| &axial.cutting),
        );
        timing.duration = match sweep.time {
            AutoOr::Given(duration) => duration,
            // What is compared is simulated.
            AutoOr::Auto => timing.duration.max(sweep.data.compared_until()),
        };
        Ok(Self {
            index,
            values,
            torque_dynamic_nm,
            conditions: conditions.clone(),
            starts: sweep.starts,
            is_begun_otherwise: false,
            scene: Scene {
                surface_speed,
                start,
                bit,
                friction,
                axial,
                lateral: (setting.lateral.as_ref())
                    .map(|settings| lateral_scene(setting, settings, conditions, lying_start))
                    .transpose()?,
                timing,
            },
        })
    }

    /// The same case with other sites.
    ///
    /// # Errors
    /// Where one of them has no friction.
    pub fn at_sites_of(&self, setting: &Setting) -> Result<Self, CaseError> {
        let lateral = setting.lateral.as_ref();
        let begins = self.starts.lying(self.scene.surface_speed);
        let lateral =
            lateral.map(|settings| lateral_scene(setting, settings, &self.conditions, begins));
        let mut case = self.clone();
        case.scene.lateral = lateral.transpose()?;
        case.scene.friction = friction_along(setting, &self.conditions)?;
        Ok(case)
    }

    /// How the string of a setting lies in its hole as the case begins, if it does.
    ///
    /// # Errors
    /// Where there is no such state.
    pub fn lying(&self, setting: &Setting) -> Result<Option<StaticState>, StaticsError> {
        let lies = setting.lying.as_ref().zip(setting.lateral.as_ref());
        let state = lies.zip(self.scene.lateral.as_ref());
        let state = state.map(|((lying, settings), scene)| {
            let at = (&setting.string, &setting.sites);
            let begins = self.starts.lying(self.scene.surface_speed);
            lying.state(at, (settings, &self.conditions), &scene.walls, begins)
        });
        state.transpose()
    }

    /// The motion that it begins with at the sites of a setting.
    pub fn start_of(&self, setting: &Setting) -> Start {
        if self.scene.axial.is_some() {
            return at_sites(&self.scene.start, setting.sites.len());
        }
        let (speed, bit) = (self.scene.surface_speed, self.scene.bit.as_ref());
        let first = || self.starts.first(setting, speed, bit);
        let second = self
            .is_begun_otherwise
            .then(|| self.starts.second(setting, speed, bit));
        second.flatten().unwrap_or_else(first)
    }

    /// Case that lasts a number of times as long.
    pub(super) fn lasting(&self, times: f64) -> Self {
        let mut case = self.clone();
        case.scene.timing.duration *= times;
        case
    }

    /// The same case as it begins the other way, where it begins both ways.
    pub fn begun_otherwise(&self) -> Option<Self> {
        (self.starts.name == StartName::Both).then(|| Self {
            is_begun_otherwise: true,
            ..self.clone()
        })
    }
}

/// A start at another number of sites, which all turn alike.
fn at_sites(start: &Start, sites: usize) -> Start {
    match start {
        Start::Steady(motion) => Start::Steady(SteadyMotion {
            speeds: vec![motion.speeds.first().copied().unwrap_or_default(); sites],
            ..motion.clone()
        }),
        other => other.clone(),
    }
}

/// The friction of each node of a string that rubs along its well.
fn friction_along(
    setting: &Setting,
    conditions: &Conditions,
) -> Result<Vec<Option<PipeFriction>>, CaseError> {
    let Some(friction) = &setting.friction else {
        return Ok(Vec::new());
    };
    let coefficient = conditions.string_friction;
    let coefficient = coefficient.ok_or(CaseError::Missing("friction of the string"))?;
    let mut along = friction.at_nodes(conditions, coefficient);
    if setting.lying.is_some() {
        // Its sites bear, and rub, what lies between them, and half of what lies between the highest and
        // the upper end of the string at rest. Of a piece that reaches above that, what is above rubs here.
        let places = setting.sites.distances_from_bit();
        let ends = statics::Top::AboveContacts.distance(places, setting.string.length());
        let borne = 0.5 * (places[0] + ends);
        let piece = setting.string.length() / friction.pieces() as f64;
        let nodes = friction.nodes.distances_from_bit().iter();
        for (law, middle) in along.iter_mut().zip(nodes) {
            let above = (0.5 + (middle - borne) / piece).min(1.0);
            *law = law.filter(|_| above > 0.0).map(|law| PipeFriction {
                torque_static: above * law.torque_static,
                torque_dynamic: above * law.torque_dynamic,
                ..law
            });
        }
    }
    Ok(along)
}

/// All torques of a string as one at its bit, where there are any: there they take longest to
/// wind it up.
fn together(bit: Option<BitTorque>, friction: &[Option<PipeFriction>]) -> Option<BitTorque> {
    if friction.is_empty() {
        return bit;
    }
    let of_pipe = |pipe: &PipeFriction| (pipe.torque_static, pipe.torque_dynamic);
    let at_bit = bit.map(|bit| (bit.torque_static, bit.torque_dynamic));
    let limits = friction.iter().flatten().map(of_pipe).chain(at_bit);
    let sum = |one: (f64, f64), other: (f64, f64)| (one.0 + other.0, one.1 + other.1);
    let (torque_static, torque_dynamic) = limits.reduce(sum)?;
    Some(BitTorque {
        torque_static,
        torque_dynamic,
        decay_speed: 0.0,
    })
}

/// How a case with a bit that cuts begins, and its axial part; `None` where the bit does not cut.
fn drilled(
    sweep: &Sweep,
    setting: &Setting,
    conditions: &Conditions,
    surface_speed: f64,
) -> Result<Option<(Start, Axial)>, CaseError> {
    let (Some(settings), Some(bit)) = (&setting.cutting, &sweep.bit) else {
        return Ok(None);
    };
    let law = bit.cutting_law(conditions)?;
    let cutting = settings.bit_in(law.ok_or(CaseError::Missing("law of its rock"))?);
    let feed = settings.feed(conditions);
    let feed = feed.ok_or(CaseError::Missing("weight on bit or feed"))?;
    let steady = settings.steady(
        (&setting.string, setting.motor),
        &cutting,
        surface_speed,
        feed,
    );
    let begins = Begins {
        steadily: sweep.starts.name == StartName::Smooth,
        disturbance: sweep.starts.disturbance,
        number: conditions.start_number,
        rise: setting.profile.rise(),
    };
    let (start, start_rate, kick) = settings.start(
        (&setting.string, &setting.sites),
        &begins,
        (surface_speed, steady),
    );
    Ok(Some((
        start,
        Axial {
            cutting,
            feed,
            start_rate,
            kick,
        },
    )))
}

/// Walls as the case has them, impulses with the case's ratio: amounts
/// relative to I₀ stay so until a method says what its I₀ is.
fn lateral_scene(
    setting: &Setting,
    settings: &LateralSettings,
    conditions: &Conditions,
    begins: LyingStart,
) -> Result<Lateral, CaseError> {
    let walls = settings.walls.iter().map(|wall| {
        let wall = wall.in_case(conditions);
        let factor = conditions.friction_factor.unwrap_or(1.0);
        let friction = wall.friction.ok_or(CaseError::Missing("friction"))?;
        Ok(wall.with_friction(factor * friction))
    });
    let impulses = settings.impulses.iter().map(|impulse| {
        let amount = match impulse.amount {
            ImpulseAmount::NewtonSeconds(amount) => Some(amount),
            ImpulseAmount::Ratio(ratio) => conditions.impulse_ratio.or(ratio),
        };
        Ok(impulse.with_amount(amount.ok_or(CaseError::Missing("ratio of impulse"))?))
    });
    let walls: Vec<Wall> = walls.collect::<Result<_, CaseError>>()?;
    let lying = setting.lying.as_ref().map(|lying| {
        let at = (&setting.string, &setting.sites);
        lying.in_case(at, (settings, conditions), &walls, begins)
    });
    Ok(Lateral {
        walls,
        impulses: impulses.collect::<Result<_, CaseError>>()?,
        eccentric_masses: settings.eccentric_masses.clone(),
        lying: lying.transpose()?,
        // Those of tools are found of the motion.
        shocks: settings.shocks.filter(|_| setting.tools.is_empty()),
    })
}
