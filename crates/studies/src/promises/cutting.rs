//! Strings drawn at random above a bit that cuts, and the hardest rock in which steady drilling lasts
//! on each, by the exact criterion ([`linear::regenerative`]).
//!
//! The limit is one of the rock's specific energy, with which torque and weight per depth of cut grow
//! alike: in soft rock any string is steady, and none in hard rock. A rock is looked for first at a
//! depth of cut that is drawn; weight on bit, or feed, are then those of that depth at the limit.

use std::f64::consts::TAU;

use anyhow::{Context, Result, ensure};
use linear::Complex64;
use linear::estimates::torsional_resistance;
use linear::regenerative::{CuttingLoop, SteadyCut};
use linear::steady::rotation_speed;

use super::draw::Draw;
use super::problem::Problem;
use campaign::plan::{Conditions, SteadyDrilling, Sweep};
use campaign::quantities::{Axis, RockConstant};
use campaign::records::{to_kn, to_m_h};

/// Random numbers of the bits: no string has these.
const STREAM: u64 = 1 << 37;

/// The softest rock of the search, MPa, and by what part each is harder than the one before.
const SOFTEST: f64 = 0.2;
const HARDER: f64 = 0.25;

/// Rocks of the search: up to some 200 MPa.
const ROCKS: i32 = 31;

/// The limit is one where steady drilling lasts this factor below it, and not that much above it.
pub const WITHIN: f64 = 1.1;

/// What the hoist opposes motion with, N s/m: a sweep's default.
const HOIST: f64 = 25_000.0;

/// What is set at the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fed {
    /// The weight on bit, by the hook load.
    HookLoad,
    /// The speed at which the string is let down.
    Speed,
}

impl Fed {
    /// The word in the table, and in a sweep file.
    pub fn name(self) -> &'static str {
        match self {
            Fed::HookLoad => "hook-load",
            Fed::Speed => "speed",
        }
    }
}

/// Where steady drilling is about to grow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HardestRock {
    /// Specific energy, MPa.
    pub energy: f64,
    /// Of what grows beyond, Hz.
    pub frequency: f64,
    /// How fast that grows a tenth beyond it, 1/s.
    pub growth: f64,
}

/// A string above a bit that cuts.
#[derive(Debug, Clone, PartialEq)]
pub struct CuttingProblem {
    /// The string, with the scene that its limit is of.
    pub problem: Problem,
    /// What is set at the surface.
    pub fed: Fed,
    /// Number of blades.
    pub blades: usize,
    /// Surface speed, rpm.
    pub speed: f64,
    /// Depth of cut of each blade at the limit, m.
    pub depth: f64,
    /// The limit, or why there is none to compare with.
    pub exact: Result<HardestRock, String>,
    bit: Bit,
    /// At the surface, kN or m/h.
    set: f64,
}

/// The bit, as it is drawn.
#[derive(Debug, Clone, PartialEq)]
struct Bit {
    fed: Fed,
    blades: usize,
    speed: f64,
    depth: f64,
    /// [bit.law] and [bit.cutting], without the energy.
    text: String,
}

impl Bit {
    /// Of the string of a number: weights and speeds by turns.
    fn draw(number: usize, seed: u64) -> Self {
        let mut draw = Draw::new(seed, STREAM + number as u64);
        let fed = match draw.uniform(0.0, 1.0) < 0.5 {
            true => Fed::HookLoad,
            false => Fed::Speed,
        };
        let blades = draw.uniform(3.0, 9.0) as usize;
        let contact = match draw.uniform(0.0, 1.0) < 0.5 {
            true => "grows",
            false => "at-once",
        };
        Self {
            fed,
            blades,
            speed: draw.uniform(40.0, 200.0),
            depth: 1e-3 * draw.log_uniform(0.3, 3.0),
            text: format!(
                "bit_radius_m = {}\ncutting_ratio = {}\nfriction = {}\ncontact_strength_mpa = {}\n\
                 contact_growth = {}\nwear_flat_mm = {}\n\n[bit.cutting]\nblades = {blades}\n\
                 relief_deg = 60\ncontact = \"{contact}\"\n",
                draw.uniform(0.1, 0.2),
                draw.uniform(0.4, 0.8),
                draw.uniform(0.2, 0.8),
                draw.log_uniform(1.0, 60.0),
                draw.uniform(1.0, 6.0),
                draw.log_uniform(0.1, 3.0),
            ),
        }
    }

    /// The first part of a sweep file, with what is set at the surface (kN or m/h), in rocks between
    /// two.
    fn scene(&self, set: f64, [soft, hard]: [f64; 2]) -> String {
        let axis = format!("rock_specific_energy_mpa = {{ values = [{soft}, {hard}] }}");
        self.scene_along(set, soft, &axis)
    }

    /// The same in one rock (MPa), along an axis of the design.
    fn scene_along(&self, set: f64, rock: f64, axis: &str) -> String {
        let kind = self.fed.name();
        let (weight, feed) = match self.fed {
            Fed::HookLoad => (
                format!("weight_on_bit_kn = {set}\n"),
                format!("hoist_damping_ns_m = {HOIST}\n"),
            ),
            Fed::Speed => (String::new(), format!("feed_m_h = {set}\n")),
        };
        let speed = match axis.starts_with("surface_speed_rpm") {
            true => String::new(),
            false => format!("surface_speed_rpm = {}\n", self.speed),
        };
        format!(
            "start = \"smooth\"\n{speed}\n[bit]\nrock = \"law\"\n{weight}\n[bit.law]\n\
             specific_energy_mpa = {rock}\n{}\n[feed]\nkind = \"{kind}\"\n{feed}\n[design]\n\
             kind = \"grid\"\n\n[design.axes]\n{axis}\n\n",
            self.text
        )
    }
}

impl CuttingProblem {
    /// The problem of a number.
    ///
    /// # Errors
    /// Where the string is invalid.
    pub fn draw(number: usize, seed: u64) -> Result<Self> {
        let bit = Bit::draw(number, seed);
        let problem = Problem::draw_for_cutting(number, seed)?;
        let problem = problem.with_scene(bit.scene(1.0, [SOFTEST, SOFTEST * WITHIN]));
        let mut drawn = Self {
            problem,
            fed: bit.fed,
            blades: bit.blades,
            speed: bit.speed,
            depth: bit.depth,
            exact: Err(String::new()),
            bit: bit.clone(),
            set: 0.0,
        };
        let found = drawn.find_limit(&bit);
        drawn.exact = found.map_err(|reason| format!("{reason:#}"));
        Ok(drawn)
    }

    /// The same in a rock (MPa), at two surface speeds that are a part of one apart from its own, below and
    /// above, in cases of a time, s.
    pub(super) fn at_speeds(&self, rock: f64, part: f64, time: f64) -> Problem {
        let [slow, fast] = [1.0 - part, 1.0 + part].map(|factor| factor * self.speed);
        let axis = format!("surface_speed_rpm = {{ values = [{slow}, {fast}] }}");
        let scene = self.bit.scene_along(self.set, rock, &axis);
        (self.problem).with_scene(format!("time_s = {time}\n{scene}"))
    }

    /// The limit; the scene is then that of weight or feed there.
    fn find_limit(&mut self, bit: &Bit) -> Result<HardestRock> {
        let sweep = self.problem.sweep("sampling_frequency_hz = 1000\n")?;
        let settings = (sweep.setting.cutting.as_ref()).context("the bit cuts")?;
        let cutting = CuttingLoop::new(&sweep.setting.string, &settings.rod)?;
        let steady = |energy: f64| at_depth(&sweep, energy, self.depth);
        let unsteady = (0..ROCKS).find_map(|step| {
            let rock = SOFTEST * (1.0 + HARDER).powi(step);
            let grows = (steady(rock).ok()).and_then(|(_, cut)| cutting.growing(&cut));
            (grows != Some(0)).then_some((rock, grows))
        });
        let (above, grows) = unsteady.context("steady drilling lasts in any rock")?;
        ensure!(grows.is_some(), "resonances are too sharp to be followed");
        ensure!(above > SOFTEST, "steady drilling lasts in no rock");
        // Of a rock that does not drill there is no cut, and nothing grows in it.
        let at = |energy: f64| steady(energy).map_or(NO_CUT, |(_, cut)| cut);
        let (energy, _) = cutting
            .limit(at, [above / (1.0 + HARDER), above])
            .context("the limit is not found")?;
        let (drilling, _) = steady(energy)?;
        let set = match self.fed {
            Fed::HookLoad => {
                let resistance = HOIST + torsional_resistance(&settings.rod);
                to_kn(drilling.weight + resistance * drilling.rate)
            }
            Fed::Speed => to_m_h(drilling.rate),
        };
        let ends = [energy / WITHIN, energy * WITHIN];
        self.set = set;
        self.problem = self.problem.with_scene(bit.scene(set, ends));
        // With weight or feed given, the depth of cut changes with the rock.
        let sweep = self.problem.sweep("sampling_frequency_hz = 1000\n")?;
        let at = |energy: f64| cut_in(&sweep, energy).unwrap_or(NO_CUT);
        let roots = ends.map(|energy| cutting.growing(&at(energy)));
        ensure!(
            roots[0] == Some(0) && roots[1] > Some(0),
            "steady drilling is lost more than once"
        );
        let (energy, omega) = (cutting.limit(at, ends)).context("the limit is not found")?;
        let frequency = omega / TAU;
        let growth = growth(&cutting, &at(ends[1]), frequency);
        Ok(HardestRock {
            energy,
            frequency,
            growth: growth.context("no root is found beyond the limit")?,
        })
    }
}

/// Where nothing is cut, nothing is fed back.
const NO_CUT: SteadyCut = SteadyCut {
    delay: 1.0,
    advance: 0.0,
    torque: 0.0,
    weight: 0.0,
};

/// How fast small motion grows, 1/s: the root near a frequency, Hz, at which it grows first.
pub(super) fn growth(cutting: &CuttingLoop, cut: &SteadyCut, frequency: f64) -> Option<f64> {
    let guess = Complex64::new(0.0, TAU * frequency);
    Some(cutting.root(cut, guess)?.re)
}

/// A sweep's conditions in a rock, MPa.
pub(super) fn in_rock(sweep: &Sweep, energy: f64) -> Conditions {
    let axis = Axis::Rock(RockConstant::SpecificEnergy);
    sweep.conditions.with(axis, energy)
}

/// Small motion in a rock (MPa) under the weight or the feed of a sweep.
pub(super) fn cut_in(sweep: &Sweep, energy: f64) -> Result<SteadyCut> {
    let bit = sweep.bit.as_ref().context("there is a bit")?;
    let drilling = sweep.setting.steady_drilling(bit, &in_rock(sweep, energy));
    let (_, cut) = drilling.context("it does not drill")?;
    cut.context("even blades")
}

/// Steady drilling in a rock (MPa) at a depth of cut of each blade (m), and small motion about it.
fn at_depth(sweep: &Sweep, energy: f64, depth: f64) -> Result<(SteadyDrilling, SteadyCut)> {
    let conditions = in_rock(sweep, energy);
    let settings = (sweep.setting.cutting.as_ref()).context("the bit cuts")?;
    let bit = sweep.bit.as_ref().context("there is a bit")?;
    let law = (bit.cutting_law(&conditions)?).context("a rock with constants")?;
    let cutting = settings.bit_in(law);
    let surface = conditions.surface_speed().context("the surface turns")?;
    let [torque, weight] = cutting.steady(depth);
    let speed = rotation_speed(&sweep.setting.string, surface, torque);
    ensure!(speed > 0.0, "the bit does not turn");
    let drilling = SteadyDrilling {
        speed,
        rate: depth * cutting.blades() as f64 * speed / TAU,
        torque,
        weight,
    };
    let cut = drilling.cut(&cutting).context("even blades")?;
    Ok((drilling, cut))
}
