//! The lateral regime of a case and the measures behind it (Sections 5.2.2,
//! 5.2.3 and 5.3).
//!
//! A site whirls that is in contact for most of the closing window and goes round while it is; how
//! often it has to is [`Rules::least_turns`]. A case is labelled by the whirling site that is in
//! contact longest; where none whirls, its measures are those of the site in contact longest:
//!
//! ```
//! use sim::{Label, LateralRegime, Motion};
//!
//! let labels = LateralRegime::ALL.map(LateralRegime::name);
//! assert_eq!(labels[..4], ["no_contact", "transient_contact", "backward_whirl", "forward_whirl"]);
//! // Of strings that lie on the low side of their hole, which may whirl, too.
//! assert_eq!(labels[4..], ["low_side", "snaking", "fading_swing"]);
//! // A touch that does not last, or that does not go round, is no whirl.
//! let is_whirl = |regime: LateralRegime| Label::Lateral(regime).is_sustained();
//! assert_eq!(is_whirl(LateralRegime::TransientContact), Some(false));
//! assert_eq!(is_whirl(LateralRegime::BackwardWhirl), Some(true));
//! assert_eq!(Label::of_name("forward_whirl").map(Label::motion), Some(Motion::Lateral));
//! ```

use serde::{Deserialize, Serialize};

use super::rules::Rules;
use super::shocks::{ShockMeasures, ShockWatch};
use super::swing::{Swing, SwingWatch};
use super::turning::Turning;
use crate::laws::contact::{Contact, Touch, WallLaw};
use crate::lying::Lying;
use crate::sampling::Sampling;
use crate::scene::Lateral;
use crate::words::with_words;

with_words! {
    /// How the string moved laterally.
    #[non_exhaustive]
    pub enum LateralRegime {
        /// No site ever touched the wall.
        NoContact = "no_contact",
        /// Some site touched the wall; none whirls in the closing window: each that is in
        /// contact for most of it lies on its wall, and does not go round.
        TransientContact = "transient_contact",
        /// Some site whirls against the rotation.
        BackwardWhirl = "backward_whirl",
        /// Some site whirls with the rotation.
        ForwardWhirl = "forward_whirl",
        /// The string lies on the low side of its hole, no site swinging by more than a little.
        LowSide = "low_side",
        /// It swings to either side of where it lies, and does not go round.
        Snaking = "snaking",
        /// It swings so, ever less, as far as it is followed: undetermined.
        FadingSwing = "fading_swing",
    }
}

/// What a person would ask of the lateral motion, of the site that decides the label.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct LateralMeasures {
    /// The regime.
    pub regime: LateralRegime,
    /// The site, from the surface down.
    pub site: usize,
    /// First touch of any site, s.
    pub first_contact: Option<f64>,
    /// Largest radial displacement, m.
    pub peak_radius: f64,
    /// Part of the closing window in contact.
    pub contact_fraction: f64,
    /// Part of that contact in rolling.
    pub rolling_fraction: f64,
    /// Mean rate at which the centre goes round in the closing window, rad/s;
    /// positive with the rotation; zero for motion in a plane.
    pub precession_rate: f64,
    /// What whirl goes round at, at least, rad/s; zero in records of earlier versions.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub least_precession_rate: f64,
    /// Mean radial displacement in the closing window, m.
    pub mean_radius: f64,
    /// Mean normal force while in contact in the closing window, N.
    pub mean_normal_force: f64,
    /// Steps of all sites that had several solutions.
    pub ambiguous_steps: usize,
    /// The hardest push into a wall in all the time, at any site; none without a push.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hardest: Option<Push>,
    /// How a string that lies in its hole swings there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lying: Option<LyingMeasures>,
    /// What tools in the string feel, where that is measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shocks: Option<ShockMeasures>,
}

/// A push of the string into its wall.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Push {
    /// Normal force of the wall, N.
    pub normal_force: f64,
    /// The site, from the surface down.
    pub site: usize,
}

/// What a person would ask of a string that lies in its hole, of the site that decides the label.
/// Angles are from the low side, positive where the string climbs against its rotation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct LyingMeasures {
    /// Mean angle in the closing window, rad.
    pub climb: f64,
    /// Half of what lies between the least and the greatest angle in it, rad.
    pub swing_amplitude: f64,
    /// How often it swings to and fro, Hz; zero where it does not.
    pub swing_frequency: f64,
    /// Greatest angle of any site away from the low side in all, rad.
    pub greatest_angle: f64,
    /// Whether it snakes ever less: longer simulated, it may lie still.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub fades: bool,
}

fn is_zero(rate: &f64) -> bool {
    *rate == 0.0
}

impl LateralMeasures {
    /// What may be no number, with its name.
    pub(crate) fn numbers(&self) -> [(&'static str, f64); 6] {
        [
            (
                "greatest angle from the low side",
                self.lying.map_or(0.0, |it| it.greatest_angle),
            ),
            (
                "greatest acceleration",
                self.shocks
                    .map_or(0.0, |it| it.step_peak + it.tangential_step_peak),
            ),
            ("largest radius", self.peak_radius),
            ("mean radius in the closing window", self.mean_radius),
            ("rate of precession", self.precession_rate),
            (
                "mean normal force in the closing window",
                self.mean_normal_force,
            ),
        ]
    }
}

/// What one site did over some steps.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct SiteSums {
    /// Steps in contact.
    pub(crate) contact: usize,
    /// Steps of that in rolling.
    pub(crate) rolling: usize,
    /// How it went round.
    pub(crate) turning: Turning,
    /// Sum of radii, m.
    pub(crate) radius: f64,
    /// Sum of normal forces, N.
    pub(crate) normal_force: f64,
}

impl SiteSums {
    /// Of no steps yet, at a place, m.
    pub(crate) fn at(place: [f64; 2]) -> Self {
        Self {
            turning: Turning::at(place),
            ..Self::default()
        }
    }

    /// One more step; the square of the largest radius so far is given, m².
    pub(crate) fn see(&mut self, contact: &Contact, largest_square: f64) {
        let [x, y] = contact.position;
        self.contact += usize::from(contact.touches());
        self.rolling += usize::from(contact.touch == Touch::Rolling);
        self.turning.go(contact.position, largest_square);
        self.radius += (x * x + y * y).sqrt();
        self.normal_force += contact.normal_force;
    }
}

/// Watches all sites step by step.
#[derive(Debug, Clone)]
pub(crate) struct WallWatch {
    rules: Rules,
    sampling: Sampling,
    /// Of whirl, rad/s.
    least_precession_rate: f64,
    closing_from: usize,
    step: usize,
    first_contact: Option<usize>,
    ambiguous: usize,
    closing: Vec<SiteSums>,
    /// Squares of the largest radii, m².
    furthest: Vec<f64>,
    /// Greatest normal force at each site so far, N.
    greatest_forces: Vec<f64>,
    surface_speed: f64,
    steps: usize,
    /// Of a string that lies in its hole.
    swings: Option<SwingWatch>,
    /// Where accelerations are measured.
    shocks: Option<ShockWatch>,
}

impl WallWatch {
    pub(crate) fn new(
        rules: Rules,
        sites: usize,
        surface_speed: f64,
        sampling: Sampling,
        (steps, closing_window): (usize, f64),
    ) -> Self {
        let window = (closing_window * sampling.frequency).round() as usize;
        Self {
            rules,
            sampling,
            least_precession_rate: rules.least_turns * surface_speed.abs(),
            closing_from: steps.saturating_sub(window.max(1)),
            step: 0,
            first_contact: None,
            ambiguous: 0,
            closing: vec![SiteSums::default(); sites],
            furthest: vec![0.0; sites],
            greatest_forces: vec![0.0; sites],
            surface_speed,
            steps,
            swings: None,
            shocks: None,
        }
    }

    /// The same of a string that lies in its hole, where it does.
    pub(crate) fn of_lying(self, lying: Option<&Lying>) -> Self {
        let of = |it| SwingWatch::new(it, self.surface_speed, self.steps, self.closing_from);
        Self {
            swings: lying.map(of),
            ..self
        }
    }

    /// The same, which measures accelerations where the scene asks for these.
    pub(crate) fn of_shocks<W: WallLaw>(self, lateral: &Lateral<W>) -> Self {
        let radii = || lateral.walls.iter().map(WallLaw::radius);
        let rate = self.sampling.frequency;
        let of = |threshold| ShockWatch::at_sites(threshold, radii(), rate, self.closing_from);
        Self {
            shocks: lateral.shocks.map(of),
            ..self
        }
    }

    /// What all sites did in a step, and how fast they turned, rad/s.
    pub(crate) fn see(&mut self, contacts: &[Contact], speeds: impl Iterator<Item = f64>) {
        if let Some(shocks) = &mut self.shocks {
            shocks.see(contacts.iter().map(|contact| contact.position), speeds);
        }
        for (site, contact) in contacts.iter().enumerate() {
            self.see_site(self.step, site, contact);
            self.ambiguous += usize::from(contact.ambiguous);
            if contact.touches() {
                self.first_contact.get_or_insert(self.step);
            }
        }
        self.step += 1;
    }

    #[inline]
    fn see_site(&mut self, step: usize, site: usize, contact: &Contact) {
        let [x, y] = contact.position;
        self.furthest[site] = self.furthest[site].max(x * x + y * y);
        self.greatest_forces[site] = self.greatest_forces[site].max(contact.normal_force);
        if let Some(swings) = &mut self.swings {
            swings.see(step, site, contact, self.furthest[site]);
        }
        if step >= self.closing_from {
            self.closing[site].see(contact, self.furthest[site]);
        } else {
            self.closing[site].turning = Turning::at(contact.position);
        }
    }

    /// The first `count` steps of a block without contact: x and y of every site,
    /// a block each.
    pub(crate) fn see_free_block(&mut self, x: &[f64], y: &[f64], block: usize, count: usize) {
        // Of those before the closing window only the furthest and the last count.
        let early = self.closing_from.saturating_sub(self.step).min(count);
        let sites = x.chunks_exact(block).zip(y.chunks_exact(block));
        for (site, (x, y)) in sites.enumerate() {
            let squares = x[..early].iter().zip(y).map(|(x, y)| x * x + y * y);
            self.furthest[site] = squares.fold(self.furthest[site], f64::max);
            for step in early.saturating_sub(1)..count {
                let contact = Contact {
                    position: [x[step], y[step]],
                    ..Contact::NONE
                };
                self.see_site(self.step + step, site, &contact);
            }
        }
        self.step += count;
    }

    pub(crate) fn measures(&self) -> LateralMeasures {
        let steps = self.step.saturating_sub(self.closing_from).max(1);
        self.measures_of(&self.closing, steps)
    }

    /// The measures of sums over some last steps, which stand for the closing
    /// window.
    pub(crate) fn measures_of(&self, closing: &[SiteSums], steps: usize) -> LateralMeasures {
        let steps = steps as f64;
        let rate = |sums: &SiteSums| sums.turning.angle() * self.sampling.frequency / steps;
        let contact_fraction = |sums: &SiteSums| sums.contact as f64 / steps;
        // What presses on nothing lies on nothing, as in a vertical well.
        let lies = self.first_contact.is_some();
        let (site, regime, lying) = match self.swings.as_ref().filter(|_| lies) {
            None => {
                let (site, regime) = self.hanging(closing, steps);
                (site, regime, None)
            }
            Some(swings) => {
                let (site, regime, swing) = self.lying(swings, closing);
                let furthest = (0..closing.len()).map(|site| swings.furthest(site));
                let measures = LyingMeasures {
                    climb: swing.climb,
                    swing_amplitude: swing.amplitude,
                    swing_frequency: swing.frequency,
                    greatest_angle: furthest.fold(0.0, f64::max),
                    fades: regime == LateralRegime::Snaking && swing.falls,
                };
                (site, regime, Some(measures))
            }
        };
        let sums = &closing[site];
        let in_contact = (sums.contact as f64).max(1.0);
        LateralMeasures {
            hardest: self.hardest(),
            lying,
            shocks: self.shocks.as_ref().and_then(ShockWatch::measures),
            regime,
            site,
            first_contact: self.first_contact.map(|step| self.sampling.time_of(step)),
            peak_radius: self.furthest[site].sqrt(),
            contact_fraction: contact_fraction(sums),
            rolling_fraction: sums.rolling as f64 / in_contact,
            precession_rate: rate(sums),
            least_precession_rate: self.least_precession_rate,
            mean_radius: sums.radius / steps,
            mean_normal_force: sums.normal_force / in_contact,
            ambiguous_steps: self.ambiguous,
        }
    }

    /// The hardest push into a wall so far.
    fn hardest(&self) -> Option<Push> {
        let forces = self.greatest_forces.iter().enumerate();
        let (site, &normal_force) = forces.max_by(|one, other| one.1.total_cmp(other.1))?;
        (normal_force > 0.0).then_some(Push { normal_force, site })
    }

    /// The site that decides, of a string that hangs in the middle of its hole, and the regime.
    fn hanging(&self, closing: &[SiteSums], steps: f64) -> (usize, LateralRegime) {
        let rate = |sums: &SiteSums| sums.turning.angle() * self.sampling.frequency / steps;
        let whirls = |sums: &SiteSums| {
            sums.contact as f64 / steps > self.rules.mostly
                && rate(sums).abs() > self.least_precession_rate
        };
        // The lowest of equals: the bit, where nothing touches.
        let decides = |sums: &SiteSums| (whirls(sums), sums.contact);
        let most = closing.iter().map(decides).max().unwrap_or_default();
        let site = (closing.iter())
            .rposition(|sums| decides(sums) == most)
            .unwrap_or(0);
        let sums = &closing[site];
        let regime = match self.first_contact {
            None => LateralRegime::NoContact,
            Some(_) if !whirls(sums) => LateralRegime::TransientContact,
            Some(_) if rate(sums) < 0.0 => LateralRegime::BackwardWhirl,
            Some(_) => LateralRegime::ForwardWhirl,
        };
        (site, regime)
    }

    /// The same of one that lies in its hole: of the sites in contact for most of the time, that
    /// which goes round most often; where none does, that which swings furthest; and where none
    /// swings by more than a little, that which bears most.
    fn lying(&self, swings: &SwingWatch, closing: &[SiteSums]) -> (usize, LateralRegime, Swing) {
        let steps = self.step.saturating_sub(self.closing_from).max(1) as f64;
        let touches = |site: &usize| closing[*site].contact as f64 / steps > self.rules.mostly;
        let every = || 0..closing.len();
        let (rate, tolerance) = (self.sampling.frequency, self.rules.settling_tolerance);
        let swing = |site: usize| (site, swings.of_site(site, rate, tolerance));
        let mut found: Vec<(usize, Swing)> = every().filter(touches).map(swing).collect();
        if found.is_empty() {
            found = every().map(swing).collect();
        }
        let goes_round = |it: &Swing| it.turns.abs() >= self.rules.least_turns_of_lying;
        let rank = |(site, it): &(usize, Swing)| {
            if goes_round(it) {
                (2, it.turns.abs())
            } else if it.amplitude > self.rules.snaking {
                (1, it.amplitude)
            } else {
                (0, closing[*site].normal_force)
            }
        };
        let order = |one: &(usize, Swing), other: &(usize, Swing)| {
            let ((one, by), (other, than)) = (rank(one), rank(other));
            one.cmp(&other).then(by.total_cmp(&than))
        };
        let (site, swing) = found.into_iter().max_by(order).unwrap_or_else(|| swing(0));
        let regime = match swing {
            it if goes_round(&it) && it.turns < 0.0 => LateralRegime::ForwardWhirl,
            it if goes_round(&it) => LateralRegime::BackwardWhirl,
            it if it.amplitude > self.rules.snaking => LateralRegime::Snaking,
            _ => LateralRegime::LowSide,
        };
        (site, regime, swing)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    const SPEED: f64 = TAU;
    const RADIUS: f64 = 0.0016;

    /// Goes round at a rate, rad/s, in contact.
    fn along_the_wall(rate: f64, normal_force: f64) -> impl Fn(f64) -> Contact {
        move |time| {
            let (sin, cos) = (rate * time).sin_cos();
            Contact {
                touch: Touch::Sliding,
                position: [RADIUS * cos, RADIUS * sin],
                normal_force,
                ..Contact::NONE
            }
        }
    }

    /// Sites that move so for 10 s while the surface turns at `SPEED`.
    fn seen(sites: &[&dyn Fn(f64) -> Contact]) -> LateralMeasures {
        let sampling = Sampling::new(200.0, 0.0);
        let timed = (2000, 2.0);
        let mut watch = WallWatch::new(Rules::USUAL, sites.len(), SPEED, sampling, timed);
        for step in 0..timed.0 {
            let time = sampling.time_of(step);
            let contacts: Vec<Contact> = sites.iter().map(|site| site(time)).collect();
            watch.see(&contacts, std::iter::empty());
        }
        watch.measures()
    }

    #[test]
    fn what_creeps_along_its_wall_lies_there() {
        for rate in [1e-4, -1e-4, 2e-3, 0.0, 0.09, -0.09] {
            let found = seen(&[&along_the_wall(rate * SPEED, 6e-4)]);
            assert_eq!(found.regime, LateralRegime::TransientContact, "{rate}");
            assert_eq!(found.contact_fraction, 1.0);
            assert!((found.precession_rate - rate * SPEED).abs() <= 1e-6 * rate.abs());
        }
        for (rate, regime) in [
            (0.11, LateralRegime::ForwardWhirl),
            (1.0, LateralRegime::ForwardWhirl),
            (-0.11, LateralRegime::BackwardWhirl),
            (-9.0, LateralRegime::BackwardWhirl),
        ] {
            let found = seen(&[&along_the_wall(rate * SPEED, 6e-4)]);
            assert_eq!(found.regime, regime, "{rate}");
        }
    }

    /// The swing of a string that dies away along its wall: fast at first, and at the end
    /// no longer.
    #[test]
    fn whirl_that_has_died_away_has_another_label() {
        let dying = |time: f64| along_the_wall(-9.0 * SPEED * (-time).exp(), 6e-4)(1.0);
        let found = seen(&[&dying]);
        assert_eq!(found.regime, LateralRegime::TransientContact);
    }

    #[test]
    fn a_site_that_whirls_decides_over_one_that_lies_longer() {
        let leaves = |time: f64| match time.fract() < 0.2 {
            true => Contact {
                normal_force: 0.0,
                touch: Contact::NONE.touch,
                ..along_the_wall(-20.0, 0.0)(time)
            },
            false => along_the_wall(-20.0, 300.0)(time),
        };
        let found = seen(&[&leaves, &along_the_wall(1e-4, 6e-4)]);
        assert_eq!(found.regime, LateralRegime::BackwardWhirl);
        assert_eq!(found.site, 0);
        assert!((found.contact_fraction - 0.8).abs() < 0.01);
    }
}
