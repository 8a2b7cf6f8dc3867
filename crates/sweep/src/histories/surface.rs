//! Pictures of what a bit that cuts does to its rock: how deep it cuts, by the angle of its turn, one
//! turn next to the other; and the surface that its blades leave, one pass below the other.

use std::f64::consts::TAU;

use sim::laws::cutting::CutStep;
use sim::{Blades, Trajectory};

use super::marks::style;
use campaign::engine::{Case, Simulation};
use campaign::plan::Sweep;
use campaign::quantities::{Unit, WIDTH};
use plot::{Axis, LevelClasses, LevelPanel, Look, Panel, Picture, Series, level_chart, panels};

/// Simulations that are drawn, each with a panel.
const MOST: usize = 4;

/// The last turns that are shown.
const TURNS: usize = 60;

/// Parts of a turn by which a depth of cut is shown.
const PARTS: usize = 120;

/// The last passes of a blade that are shown, and the points of each.
const PASSES: usize = 24;
const POINTS: usize = 240;

/// The depth of cut over the last whole turns; none where no bit turns once.
pub fn cut_picture(look: &Look, sweep: &Sweep, simulations: &[Simulation]) -> Option<Picture> {
    let unit = sweep.content.units.of(&WIDTH);
    let shown = simulations.iter().filter_map(|simulation| {
        let ground = Ground::of(&simulation.trajectory);
        let turns = ground.last(TAU, TURNS)?;
        Some((simulation, ground, turns))
    });
    let panels = shown.take(MOST).map(|(simulation, ground, [first, end])| {
        let levels = (first..end).flat_map(|turn| {
            let angles = (0..PARTS).map(move |part| part_of_turn(turn, part));
            angles.map(|angle| unit.number(1e3 * ground.at(angle, |step| step.depth_of_cut)))
        });
        LevelPanel {
            title: format!("Depth of cut, {}", simulation.name),
            axes: ["Turn of the bit", "Angle in the turn (°)"].map(Axis::linear),
            edges: [
                (first..=end).map(|turn| turn as f64).collect(),
                (0..=PARTS)
                    .map(|part| 360.0 * part as f64 / PARTS as f64)
                    .collect(),
            ],
            levels: levels.collect(),
            scale: format!("Depth of cut ({})", unit.name),
            classes: LevelClasses::Even,
        }
    });
    let panels: Vec<LevelPanel> = panels.collect();
    let note = "Of each blade, the mean of all. The lightest is off bottom. What one blade leaves the \
                next one finds: a pattern that is there again a blade later feeds itself.";
    (!panels.is_empty()).then(|| level_chart(look, &sweep.title, &panels, note))
}

/// The rock that the last passes of blades left; none where no blade passes once.
pub fn surface_picture(
    look: &Look,
    sweep: &Sweep,
    cases: &[Case],
    simulations: &[Simulation],
) -> Option<Picture> {
    let unit = sweep.content.units.of(&WIDTH);
    let shown = simulations.iter().filter_map(|simulation| {
        let case = cases.iter().find(|case| case.index == simulation.case)?;
        let blades = &case.scene.axial.as_ref()?.cutting.blades;
        let points = Ground::of(&simulation.trajectory).passes(width_of_pass(blades), &unit)?;
        let series = Series {
            name: simulation.name.clone(),
            style: style(simulation, simulations),
            points,
        };
        let across = match blades {
            Blades::Even(_) => "Angle from where a blade began (°)",
            _ => "Angle in the turn (°)",
        };
        Some(Panel {
            axes: [across, &format!("Height of the rock ({})", unit.name)].map(Axis::linear),
            series: vec![series],
            references: Vec::new(),
            walls: Vec::new(),
            is_difference: false,
        })
    });
    let list: Vec<Panel> = shown.take(MOST).collect();
    let title = format!("{}: the rock after the last {PASSES} passes", sweep.title);
    (!list.is_empty()).then(|| panels(look, &title, &list))
}

/// The angle from where a blade is to where the rock was left by the one before: blades that are even
/// pass alike, of others a turn is the least after which all is as before.
fn width_of_pass(blades: &Blades) -> f64 {
    match blades {
        Blades::Even(count) => TAU / *count as f64,
        _ => TAU,
    }
}

/// The middle of a part of a turn, rad.
fn part_of_turn(turn: usize, part: usize) -> f64 {
    TAU * (turn as f64 + (part as f64 + 0.5) / PARTS as f64)
}

/// Steps in which a bit turned further than ever before, by its angle.
struct Ground<'a> {
    steps: Vec<&'a CutStep>,
}

impl<'a> Ground<'a> {
    fn of(motion: &'a Trajectory) -> Self {
        let mut furthest = f64::NEG_INFINITY;
        let is_new = |step: &&CutStep| {
            let is_new = step.angle > furthest;
            furthest = furthest.max(step.angle);
            is_new
        };
        Self {
            steps: motion.cut.iter().filter(is_new).collect(),
        }
    }

    /// The last whole pieces of an angle that the bit turned through, at most a number of them, from the first
    /// to behind the last.
    fn last(&self, angle: f64, most: usize) -> Option<[usize; 2]> {
        let end = (self.steps.last()?.angle / angle) as usize;
        (end > 0).then(|| [end.saturating_sub(most), end])
    }

    /// What is known of each step, between both around an angle.
    fn at(&self, angle: f64, value: fn(&CutStep) -> f64) -> f64 {
        let above = self.steps.partition_point(|step| step.angle < angle);
        let above = above.clamp(1, self.steps.len() - 1);
        let [low, high] = [self.steps[above - 1], self.steps[above]];
        let part = (angle - low.angle) / (high.angle - low.angle);
        let part = part.clamp(0.0, 1.0);
        value(low) + part * (value(high) - value(low))
    }

    /// The rock after each of the last passes, higher where it is less deep, from the first that is
    /// shown; with gaps between passes.
    fn passes(&self, width: f64, unit: &Unit) -> Option<Vec<(f64, f64)>> {
        let [first, end] = self.last(width, PASSES)?;
        let rock = |angle: f64| self.at(angle, CutStep::rock_left);
        let top = rock(first as f64 * width);
        let points = (first..end).flat_map(|pass| {
            let line = (0..=POINTS).map(move |point| {
                let along = width * point as f64 / POINTS as f64;
                (along, pass as f64 * width + along)
            });
            let line = line
                .map(|(along, angle)| (along.to_degrees(), unit.number(1e3 * (top - rock(angle)))));
            line.chain([(f64::NAN, f64::NAN)])
        });
        Some(points.collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A bit of `blades` that turns evenly and stands still and turns back a little at times, and
    /// cuts as deep as a function of its angle.
    fn motion(depth: impl Fn(f64) -> f64) -> Trajectory {
        let angles = (0..4000).map(|step| {
            let turned = 0.02 * f64::from(step);
            turned - 0.3 * (turned.floor() % 2.0) * turned.fract()
        });
        let cut = angles.map(|angle| {
            let mut step = CutStep::default();
            step.angle = angle;
            step.depth = depth(angle);
            step.depth_of_cut = 1e-3;
            step
        });
        Trajectory {
            cut: cut.collect(),
            ..Trajectory::default()
        }
    }

    #[test]
    fn turns_are_whole_and_the_last_ones() {
        let motion = motion(|_| 0.0);
        let ground = Ground::of(&motion);
        assert!(
            ground
                .steps
                .windows(2)
                .all(|pair| pair[0].angle < pair[1].angle)
        );
        // 80 rad are twelve turns and a part.
        assert_eq!(ground.last(TAU, TURNS), Some([0, 12]));
        assert_eq!(ground.last(TAU, 5), Some([7, 12]));
        assert_eq!(ground.last(100.0, 5), None);
    }

    #[test]
    fn rock_is_as_deep_as_the_angle_says_in_every_pass() {
        let advance = 2e-3;
        let motion = motion(|angle| advance * angle);
        let blades = Blades::Even(4);
        let width = width_of_pass(&blades);
        let unit = campaign::quantities::Units::default().of(&WIDTH);
        let points = Ground::of(&motion).passes(width, &unit).unwrap();
        let passes: Vec<&[(f64, f64)]> = points.split(|point| point.0.is_nan()).collect();
        assert_eq!(passes.len(), PASSES + 1);
        for (pass, line) in passes[..PASSES].iter().enumerate() {
            for (degrees, height) in *line {
                let angle = pass as f64 * width + degrees.to_radians();
                assert!(
                    (height + 1e3 * advance * angle).abs() < 1e-6,
                    "{pass} {degrees}"
                );
            }
        }
        assert_eq!(width_of_pass(&Blades::Uneven(vec![TAU / 4.0; 4])), TAU);
    }

    #[test]
    fn a_bit_off_bottom_leaves_the_rock_that_it_found() {
        let mut step = CutStep::default();
        step.depth = 3.0;
        step.depth_of_cut = 0.5;
        assert_eq!(step.rock_left(), 3.0);
        step.depth_of_cut = -0.5;
        assert_eq!(step.rock_left(), 3.5);
    }
}
