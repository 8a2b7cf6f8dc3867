//! The lateral regime of a case and the measures behind it (Sections 5.2.2,
//! 5.2.3 and 5.3).
//!
//! A case is labelled by the site that is in contact longest:
//!
//! ```
//! use sim::{Label, LateralRegime, Motion};
//!
//! let labels = LateralRegime::ALL.map(LateralRegime::name);
//! assert_eq!(labels, ["no_contact", "transient_contact", "backward_whirl", "forward_whirl"]);
//! // A touch that does not last is no whirl.
//! let is_whirl = |regime: LateralRegime| Label::Lateral(regime).is_sustained();
//! assert_eq!(is_whirl(LateralRegime::TransientContact), Some(false));
//! assert_eq!(is_whirl(LateralRegime::BackwardWhirl), Some(true));
//! assert_eq!(Label::of_name("forward_whirl").map(Label::motion), Some(Motion::Lateral));
//! ```

use serde::{Deserialize, Serialize};

use super::rules::Rules;
use super::turning::Turning;
use crate::laws::contact::{Contact, Touch};
use crate::sampling::Sampling;
use crate::words::with_words;

with_words! {
    /// How the string moved laterally.
    #[non_exhaustive]
    pub enum LateralRegime {
        /// No site ever touched the wall.
        NoContact = "no_contact",
        /// Some site touched the wall; none whirls in the closing window: none is in
        /// contact for most of it and goes round.
        TransientContact = "transient_contact",
        /// Some site whirls against the rotation.
        BackwardWhirl = "backward_whirl",
        /// Some site whirls with the rotation.
        ForwardWhirl = "forward_whirl",
    }
}

/// What a person would ask of the lateral motion: of the site that decides the
/// label, the one that is in contact longest in the closing window.
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
    /// Mean radial displacement in the closing window, m.
    pub mean_radius: f64,
    /// Mean normal force while in contact in the closing window, N.
    pub mean_normal_force: f64,
    /// Steps of all sites that had several solutions.
    pub ambiguous_steps: usize,
}

impl LateralMeasures {
    /// What may be no number, with its name.
    pub(crate) fn numbers(&self) -> [(&'static str, f64); 4] {
        [
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
    closing_from: usize,
    step: usize,
    first_contact: Option<usize>,
    ambiguous: usize,
    closing: Vec<SiteSums>,
    /// Squares of the largest radii, m².
    furthest: Vec<f64>,
}

impl WallWatch {
    pub(crate) fn new(
        rules: Rules,
        sites: usize,
        sampling: Sampling,
        steps: usize,
        closing_window: f64,
    ) -> Self {
        let window = (closing_window * sampling.frequency).round() as usize;
        Self {
            rules,
            sampling,
            closing_from: steps.saturating_sub(window.max(1)),
            step: 0,
            first_contact: None,
            ambiguous: 0,
            closing: vec![SiteSums::default(); sites],
            furthest: vec![0.0; sites],
        }
    }

    pub(crate) fn see(&mut self, contacts: &[Contact]) {
        for (site, contact) in contacts.iter().enumerate() {
            self.see_site(self.step, site, contact);
            self.ambiguous += usize::from(contact.ambiguous);
            if contact.touches() {
                self.first_contact.get_or_insert(self.step);
            }
        }
        self.step += 1;
    }

    fn see_site(&mut self, step: usize, site: usize, contact: &Contact) {
        let [x, y] = contact.position;
        self.furthest[site] = self.furthest[site].max(x * x + y * y);
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
        let most = closing.iter().map(|sums| sums.contact).max().unwrap_or(0);
        // The lowest of equals: the bit, where nothing touches.
        let site = (closing.iter())
            .rposition(|sums| sums.contact == most)
            .unwrap_or(0);
        let (sums, steps) = (closing[site], steps as f64);
        let angle = sums.turning.angle();
        let contact_fraction = sums.contact as f64 / steps;
        let in_contact = (sums.contact as f64).max(1.0);
        let regime = match self.first_contact {
            None => LateralRegime::NoContact,
            Some(_) if contact_fraction <= self.rules.mostly || angle == 0.0 => {
                LateralRegime::TransientContact
            }
            Some(_) if angle < 0.0 => LateralRegime::BackwardWhirl,
            Some(_) => LateralRegime::ForwardWhirl,
        };
        LateralMeasures {
            regime,
            site,
            first_contact: self.first_contact.map(|step| self.sampling.time_of(step)),
            peak_radius: self.furthest[site].sqrt(),
            contact_fraction,
            rolling_fraction: sums.rolling as f64 / in_contact,
            precession_rate: angle * self.sampling.frequency / steps,
            mean_radius: sums.radius / steps,
            mean_normal_force: sums.normal_force / in_contact,
            ambiguous_steps: self.ambiguous,
        }
    }
}
