//! When motion counts as a regime, and when a simulation may end before its time.
//!
//! Other rules than the usual ones differ in what they change:
//!
//! ```
//! use sim::watch::rules::Rules;
//!
//! let strict = Rules { settling_tolerance: 1e-3, ..Rules::USUAL };
//! assert_eq!(strict.repeated, Rules::USUAL.repeated);
//! assert!(strict.settling_tolerance < Rules::USUAL.settling_tolerance);
//! ```

/// Cycles of stick-slip that have to agree for it to be settled.
pub(crate) const AGREEING_CYCLES: usize = 3;

/// A centre that passes the middle this near, in parts of the largest radius, goes
/// through it: far less than any wall is round to, and far more than rounding.
pub(crate) const THROUGH_THE_MIDDLE: f64 = 1e-9;

/// Every other tolerance of regimes and of ending early.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rules {
    /// Recaptures that make stick-slip: near the limit one may be the echo of the
    /// first slip and a second its consequence; a third repeats.
    pub repeated: usize,
    /// A bit that cuts, and was stuck, slips once it turns faster than this part of the surface
    /// speed: what it cuts holds it near standstill without holding it fast, so that it creeps and
    /// stops many times in one stick. As it turns with the surface in the mean, a slip is faster
    /// than that.
    pub creeping: f64,
    /// The part of the closing window that a whirling site spends in contact.
    pub mostly: f64,
    /// The part of the closing window that a bit which bounces is off bottom.
    pub off_bottom: f64,
    /// A whirling site goes round this many times at least while the surface turns once. An
    /// eccentric mass takes it round once, rolling and sliding whirl go round faster, both held by
    /// the forces of their rate. A string that lies on its wall, with a free swing too slow to take it
    /// off, creeps along it with millinewtons: on random strings by 0.002 turns at most, where
    /// whirl that lasts has 1.8 or more (`val_no_simulated_whirl_has_less_friction_than_it_needs`).
    pub least_turns: f64,
    /// A string that lies in its hole whirls if it goes round the middle at least so often in the
    /// closing window.
    pub least_turns_of_lying: f64,
    /// One that does not, and swings by more than this to either side, rad, snakes.
    pub snaking: f64,
    /// A bit that turns for this part of what it remembers, in per cent, may turn for
    /// ever: a wave has come and gone several times.
    pub turning_for: usize,
    /// Motion has settled if its measures, at their latest rate of change, change by no more than
    /// this until the end of the time: the radius relative to the clearance, the others to
    /// themselves.
    pub settling_tolerance: f64,
    /// Means of whirl are taken over this time, s.
    pub window: f64,
    /// Means that have to agree, one after the other.
    pub agreeing_windows: usize,
    /// A rolling site that settles uses no more than this part of its friction.
    pub rolling_margin: f64,
    /// A free site that settles keeps within this part of its clearance.
    pub free_margin: f64,
}

impl Rules {
    /// Those by which this program classifies regimes.
    pub const USUAL: Rules = Rules {
        repeated: 3,
        creeping: 0.5,
        mostly: 0.5,
        off_bottom: 1e-3,
        least_turns: 0.1,
        least_turns_of_lying: 1.0,
        snaking: std::f64::consts::PI / 180.0,
        turning_for: 10,
        settling_tolerance: 1e-2,
        window: 0.25,
        agreeing_windows: 4,
        rolling_margin: 0.98,
        free_margin: 0.95,
    };
}
