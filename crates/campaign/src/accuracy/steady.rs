//! Where steady drilling of a bit that cuts is lost near a case: exactly, and as a method steps it.
//!
//! What grows less than a hundredfold in the time of the case does not count: no label shows it.

use linear::regenerative::{CuttingLoop, SteadyCut};
use sim::SteppedLoop;

use crate::engine::MethodSystem;
use crate::plan::{Bit, Conditions, Setting};

/// What small motion grows by until it shows.
const GROWN: f64 = 100.0;

/// Growth (1/s) that shows within a time, s.
pub fn growth_within(duration: f64) -> f64 {
    GROWN.ln() / duration
}

/// Whether small motion about steady drilling grows on a string, under conditions.
pub struct Exact<'a> {
    setting: &'a Setting,
    bit: &'a Bit,
    cutting: CuttingLoop<'a>,
}

impl<'a> Exact<'a> {
    /// What grows faster than this, 1/s. `stiffest` are conditions under which the cut is about as stiff as it
    /// gets. `None` where blades are uneven or the string cannot be cut up.
    pub fn new(
        setting: &'a Setting,
        bit: &'a Bit,
        growth: f64,
        stiffest: &Conditions,
    ) -> Option<Self> {
        let cut = setting.steady_drilling(bit, stiffest)?.1?;
        let cutting = setting.cutting_loop().ok()??.faster_than(growth);
        Some(Self {
            setting,
            bit,
            cutting: cutting.sampled_for(&cut),
        })
    }

    /// Whether it grows; `None` where the bit does not drill, or resonances are too sharp.
    pub fn grows(&self, conditions: &Conditions) -> Option<bool> {
        let cut = cut_of(self.setting, self.bit, conditions)?;
        Some(self.cutting.growing(&cut)? > 0)
    }
}

/// The same in the steps of a method.
pub struct Stepped<'a> {
    setting: &'a Setting,
    bit: &'a Bit,
    cutting: SteppedLoop,
}

impl<'a> Stepped<'a> {
    /// What grows faster than this, 1/s, under no conditions with a slower bit than under `slowest`.
    pub fn new(
        system: &'a MethodSystem,
        bit: &'a Bit,
        growth: f64,
        slowest: &Conditions,
    ) -> Option<Self> {
        let setting = &system.setting;
        let cut = cut_of(setting, bit, slowest)?;
        Some(Self {
            setting,
            bit,
            cutting: SteppedLoop::new(&system.responses, growth, cut.delay)?,
        })
    }

    /// Whether it grows; `None` where the bit does not drill.
    pub fn grows(&self, conditions: &Conditions) -> Option<bool> {
        let cut = cut_of(self.setting, self.bit, conditions)?;
        Some(self.cutting.growing(&cut) > 0)
    }
}

fn cut_of(setting: &Setting, bit: &Bit, conditions: &Conditions) -> Option<SteadyCut> {
    setting.steady_drilling(bit, conditions)?.1
}
