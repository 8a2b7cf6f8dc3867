//! The frequencies themselves, by bisection on their count.

use super::bending::{self, Stretch};
use super::rod;
use crate::bending::{Bending, SurfaceSupport};
use crate::channel::Channel;
use crate::drillstring::Drillstring;
use crate::error::{BuildError, DrillstringError};
use crate::parallel;
use crate::sites::Sites;

/// A frequency is known to this part of it; two that differ by less are equal.
const SAME_FREQUENCY: f64 = 1e-10;

/// What is slower than this part of the slowest that stiffness could bring back is brought back
/// by nothing.
const NOTHING: f64 = 1e-2;

/// Numbers next to one another that are tried where nothing can be counted at one.
const TRIES: usize = 8;

/// A string without damping whose natural frequencies are counted.
#[derive(Debug, Clone)]
pub struct NaturalFrequencies {
    pub(super) string: Drillstring,
    pub(super) motion: Motion,
    /// Nothing that is brought back swings more slowly, rad/s.
    slowest: f64,
}

/// How it swings.
#[derive(Debug, Clone)]
pub(super) enum Motion {
    /// As a rod that twists, or stretches; of one that hangs, the mass that its upper end moves with,
    /// kg.
    Rod { hanging: Option<f64> },
    Bending {
        bending: Bending,
        support: SurfaceSupport,
        /// The string from its top down.
        stretches: Vec<Stretch>,
        /// Where it is held, if it is: then its top is the uppermost of them.
        held: Option<Sites>,
    },
}

/// Frequencies (rad/s) between which some are, with how many are below either.
#[derive(Debug, Clone, Copy)]
struct Bracket {
    ends: [f64; 2],
    below: [usize; 2],
}

impl NaturalFrequencies {
    /// Those of a string in torsion, its surface held, with any drive and damping.
    ///
    /// # Errors
    /// Where the string cannot be cut up.
    pub fn torsion(string: &Drillstring) -> Result<Self, BuildError> {
        let sections = string.sections().to_vec();
        let string = Drillstring::new(string.material(), sections, 0.0)?;
        Ok(Self::of_rod(string, None))
    }

    /// Those of a string along its axis, with any damping, as a rod that stretches
    /// ([`crate::Axial::rod`]). Where it hangs from a hoist the upper end is free to move with the
    /// mass of that, which is one mode without a restoring force; else it is held.
    ///
    /// # Errors
    /// Where the string cannot be cut up.
    pub fn axial(rod: &Drillstring) -> Result<Self, BuildError> {
        let hanging = rod.top_drive().map(|hoist| hoist.inertia);
        Ok(Self::of_rod(rod.undamped()?, hanging))
    }

    fn of_rod(string: Drillstring, hanging: Option<f64>) -> Self {
        Self {
            slowest: NOTHING * rod::least(&string),
            string,
            motion: Motion::Rod { hanging },
        }
    }

    /// Those of a string in bending, with any damping, under its axial force and in its mud.
    ///
    /// # Errors
    /// Where it cannot bend so.
    pub fn bending(
        string: &Drillstring,
        bending: &Bending,
        support: SurfaceSupport,
    ) -> Result<Self, BuildError> {
        bending.check()?;
        let undamped = Bending {
            damping: 0.0,
            ..*bending
        };
        Ok(Self {
            slowest: NOTHING * bending::least(string, &undamped),
            string: string.clone(),
            motion: Motion::Bending {
                bending: undamped,
                support,
                stretches: stretches(string, &Sites::bit(), 0)?,
                held: None,
            },
        })
    }

    /// Those in bending of a string that is held, for instance by stabilisers: without displacement
    /// and free to turn. What is above the uppermost of these places is left out.
    ///
    /// # Errors
    /// Where the string cannot bend so, or the places are not on it.
    pub fn held(string: &Drillstring, bending: &Bending, held: &Sites) -> Result<Self, BuildError> {
        let mut whole = Self::bending(string, bending, SurfaceSupport::Pinned)?;
        if let Motion::Bending {
            stretches: all,
            held: places,
            ..
        } = &mut whole.motion
        {
            *all = stretches(string, held, held.len())?;
            all.remove(0);
            *places = Some(held.clone());
        }
        Ok(whole)
    }

    /// Natural frequencies below an angular frequency (rad/s, positive), among them the motions
    /// without a restoring force.
    ///
    /// # Errors
    /// Where the string's constants are so extreme that its waves have no size.
    pub fn below(&self, omega: f64) -> Result<usize, BuildError> {
        let count = |omega: f64| match &self.motion {
            Motion::Rod { hanging } => rod::below(&self.string, *hanging, omega),
            Motion::Bending {
                bending,
                support,
                stretches,
                ..
            } => bending::below(&self.string, (bending, *support), stretches, omega),
        };
        let next_up = |omega: &f64| Some(f64::from_bits(omega.to_bits() + 1));
        let tried = std::iter::successors(Some(omega), next_up);
        let mut counts = tried.take(TRIES).filter_map(count);
        counts.next().ok_or(BuildError::NotFinite {
            method: "exact waves",
        })
    }

    /// Counts that finding one frequency takes, at most about: each halves where it may be.
    pub const COUNTS: usize = 40;

    /// Pieces that are gone through to count those below an angular frequency (rad/s).
    pub fn pieces(&self, omega: f64) -> f64 {
        match &self.motion {
            Motion::Rod { .. } => self.string.tubes().map(|(count, _)| count).sum(),
            Motion::Bending {
                bending, stretches, ..
            } => bending::pieces(&self.string, bending, stretches, omega),
        }
    }

    /// Modes without a restoring force: those of a rigid body, and those in which the string
    /// buckles.
    ///
    /// # Errors
    /// As [`NaturalFrequencies::below`].
    pub fn unrestored(&self) -> Result<usize, BuildError> {
        self.below(self.slowest)
    }

    /// All natural frequencies below an angular frequency (rad/s), from the lowest up, rad/s,
    /// without those that have no restoring force; equal ones are repeated.
    ///
    /// # Errors
    /// As [`NaturalFrequencies::below`].
    pub fn all_below(&self, omega: f64) -> Result<Vec<f64>, BuildError> {
        let ends = [self.slowest, omega.max(self.slowest)];
        let below = [self.below(ends[0])?, self.below(ends[1])?];
        let mut brackets = vec![Bracket { ends, below }];
        brackets.retain(Bracket::has_some);
        while brackets.iter().any(Bracket::is_wide) {
            let halves = parallel::each(brackets, |it| self.halved(it)).into_iter();
            brackets = halves.collect::<Result<Vec<_>, _>>()?.concat();
        }
        let found = brackets.iter().flat_map(|bracket| {
            let [low, high] = bracket.ends;
            let [before, after] = bracket.below;
            std::iter::repeat_n(0.5 * (low + high), after - before)
        });
        Ok(found.collect())
    }

    /// The lowest natural frequencies, `count` of them, rad/s, as [`NaturalFrequencies::all_below`]
    /// has them.
    ///
    /// # Errors
    /// As [`NaturalFrequencies::below`].
    pub fn lowest(&self, count: usize) -> Result<Vec<f64>, BuildError> {
        let wanted = self.unrestored()? + count;
        let mut high = 2.0 * self.slowest;
        while self.below(high)? < wanted {
            high *= 2.0;
        }
        let mut found = self.all_below(high)?;
        found.truncate(count);
        Ok(found)
    }

    fn halved(&self, bracket: Bracket) -> Result<Vec<Bracket>, BuildError> {
        if !bracket.is_wide() {
            return Ok(vec![bracket]);
        }
        let ([low, high], [before, after]) = (bracket.ends, bracket.below);
        let middle = if high > 4.0 * low {
            (low * high).sqrt()
        } else {
            0.5 * (low + high)
        };
        // Where several coincide, rounding alone may add or remove one.
        let between = self.below(middle)?.clamp(before, after);
        let lower = Bracket {
            ends: [low, middle],
            below: [before, between],
        };
        let upper = Bracket {
            ends: [middle, high],
            below: [between, after],
        };
        let halves = [lower, upper].into_iter();
        Ok(halves.filter(Bracket::has_some).collect())
    }
}

impl Bracket {
    fn has_some(&self) -> bool {
        self.below[0] < self.below[1]
    }

    fn is_wide(&self) -> bool {
        let [low, high] = self.ends;
        high - low > SAME_FREQUENCY * high
    }
}

/// The string between its surface, its sites and the bit; of the sites the first `held` are held.
fn stretches(
    string: &Drillstring,
    sites: &Sites,
    held: usize,
) -> Result<Vec<Stretch>, DrillstringError> {
    let spans = string.surrounded_spans(Channel::Bending, sites)?;
    let spans = spans.into_iter().enumerate();
    let stretch = |(site, span)| Stretch {
        span,
        ends_held: site < held,
    };
    Ok(spans.map(stretch).collect())
}

/// Lateral natural frequencies below an angular frequency (rad/s), from the lowest up, rad/s, of
/// the string below the uppermost of the places that hold it without displacement, such as
/// stabilisers and the bit: an eccentric string that turns as fast as one of them is at a critical
/// speed. At each place it is free to turn; what is above them is left out.
///
/// # Errors
/// Where the string cannot bend so, or the places are not on it.
pub fn held_lateral_frequencies_below(
    string: &Drillstring,
    bending: &Bending,
    held: &Sites,
    omega: f64,
) -> Result<Vec<f64>, BuildError> {
    NaturalFrequencies::held(string, bending, held)?.all_below(omega)
}
