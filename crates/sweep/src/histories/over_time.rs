//! The picture of motion over time.

use linear::estimates::stick_slip_times;
use sim::{BitTorque, Trajectory};

use super::known::{has_surface_speed, has_surface_torque, has_torque};
use super::marks::{each_once, level, shown_clearances, style};
use campaign::engine::{Case, Simulation};
use campaign::plan::{Comparison, Sweep};
use campaign::quantities::{FORCE, TORQUE, Unit, Units, WIDTH};
use campaign::records::to_rpm;
use campaign::sweep_file::TraceName;
use campaign::words::site_title;
use plot::{Across, Axis, Look, Panel, Picture, Reference, Series, panels};

/// With lateral motion, the radius of every site (Figs. 10 to 16); else its
/// speed and the torque on the bit; the torque that turns the surface where it is followed. As in the paper, the difference between the
/// first two methods is beneath.
pub fn history_picture(
    look: &Look,
    sweep: &Sweep,
    cases: &[Case],
    simulations: &[Simulation],
) -> Picture {
    let histories = Histories {
        sweep,
        cases,
        simulations,
    };
    let list = match &sweep.setting.lateral {
        Some(_) => histories.radii(),
        None => histories.speeds_and_torque(),
    };
    panels(look, &sweep.title, &list)
}

/// What is drawn over time.
struct Histories<'a> {
    sweep: &'a Sweep,
    cases: &'a [Case],
    simulations: &'a [Simulation],
}

impl Histories<'_> {
    fn units(&self) -> Units {
        self.sweep.content.units
    }

    /// The unit of torques, in thousands.
    fn torque_unit(&self) -> Unit {
        self.units().of(&TORQUE).kilo()
    }

    fn panel(&self, label: &str, series: Vec<Series>, references: Vec<Reference>) -> Panel {
        Panel {
            axes: ["Time t (s)", label].map(Axis::linear),
            series,
            references,
            walls: Vec::new(),
            is_difference: false,
        }
    }

    /// A series of each simulation, over its own time.
    fn of_each(&self, values: &dyn Fn(&Trajectory, usize) -> f64) -> Vec<Series> {
        let series = self.simulations.iter().map(|simulation| {
            let motion = &simulation.trajectory;
            Series {
                name: simulation.name.clone(),
                style: style(simulation, self.simulations),
                points: (motion.times.iter().enumerate())
                    .map(|(index, &time)| (time, values(motion, index)))
                    .collect(),
            }
        });
        series.collect()
    }

    /// Between the first two methods of a panel, where there is one case.
    fn difference(&self, label: &str, panel: Option<&Panel>) -> Option<Panel> {
        let ([_], [first, second, ..]) = (self.cases, &panel?.series[..]) else {
            return None;
        };
        let name = format!("{} − {}", first.name, second.name);
        let points = (first.points.iter().enumerate())
            .filter_map(|(step, &(time, value))| {
                Some((time, value - value_at(&second.points, step, time)?))
            })
            .collect();
        Some(Panel {
            is_difference: true,
            ..self.panel(label, vec![Series::new(name, points)], Vec::new())
        })
    }

    fn radii(&self) -> Vec<Panel> {
        let distances = self.sweep.setting.sites.distances_from_bit();
        let (units, width) = (self.units(), self.units().of(&WIDTH));
        let mut list: Vec<Panel> = (distances.iter())
            .enumerate()
            .map(|(site, &distance)| {
                let radii = self.of_each(&|trajectory, index| {
                    let [x, y] = trajectory.positions[site][index];
                    width.number(1e3 * x.hypot(y))
                });
                let points = radii.iter().flat_map(|series| &series.points);
                let at_site = |clearances: &[f64]| clearances.get(site).copied();
                let points = points.map(|point| point.1);
                let clearances = shown_clearances(self.cases, at_site, &width, points);
                let walls = clearances.into_iter().map(|at| level(at, "clearance"));
                let site = site_title(distance, units);
                let label = format!("Radius at {site} ({})", width.name);
                self.panel(&label, radii, walls.collect())
            })
            .collect();
        let lowest = site_title(distances[distances.len() - 1], units);
        let label = format!("Difference in radius at {lowest} ({})", width.name);
        list.extend(self.difference(&label, list.last()));
        list.extend(self.of_cutting());
        list.extend(self.surface_torque());
        list
    }

    fn speeds_and_torque(&self) -> Vec<Panel> {
        let mut list = Vec::new();
        let distances = self.sweep.setting.sites.distances_from_bit().iter();
        for (site, &distance) in distances.enumerate().rev() {
            let label = if distance == 0.0 {
                "Bit speed (rpm)".to_owned()
            } else {
                format!("Speed {} (rpm)", site_title(distance, self.units()))
            };
            let series = self.of_each(&|trajectory, index| to_rpm(trajectory.speeds[site][index]));
            list.push(self.panel(
                &label,
                series,
                levels(self.cases, "Ω", |case| {
                    // What was recorded has its own panel.
                    let is_known = self.sweep.data.surface_speed.is_none();
                    is_known.then(|| to_rpm(case.scene.surface_speed))
                }),
            ));
        }
        let rubs = self.sweep.setting.friction.is_some();
        if let Some(bit_speed) = list.first_mut().filter(|_| !rubs) {
            bit_speed.references.extend(self.first_slips());
        }
        let difference = self.difference("Difference in bit speed (rpm)", list.first());
        if let Some(bit_speed) = list.first_mut() {
            (bit_speed.series).extend(self.recorded(TraceName::BitSpeedRpm, 1.0));
        }
        if has_torque(self.simulations) {
            list.push(self.torque());
        }
        list.extend(self.of_cutting());
        list.extend(self.surface_torque());
        if has_surface_speed(self.simulations) {
            let mut series =
                self.of_each(&|trajectory, index| to_rpm(trajectory.surface_speed[index]));
            series.extend(self.recorded(TraceName::SurfaceSpeedRpm, 1.0));
            list.push(self.panel("Surface speed (rpm)", series, Vec::new()));
        }
        list.extend(difference);
        list
    }

    /// Weight on bit, depth of cut and depth of a bit that cuts.
    fn of_cutting(&self) -> Vec<Panel> {
        let mut simulations = self.simulations.iter();
        if !simulations.all(|simulation| !simulation.trajectory.cut.is_empty()) {
            return Vec::new();
        }
        let (force, width) = (self.units().of(&FORCE), self.units().of(&WIDTH));
        let weights =
            self.of_each(&|trajectory, index| force.number(1e-3 * trajectory.cut[index].weight));
        let depths = self
            .of_each(&|trajectory, index| width.number(1e3 * trajectory.cut[index].depth_of_cut));
        let set = |case: &Case| Some(force.number(case.conditions.weight_on_bit_kn?));
        vec![
            self.panel(
                &format!("Weight on bit ({})", force.name),
                weights,
                levels(self.cases, "set", set),
            ),
            self.panel(
                &format!("Depth of cut ({})", width.name),
                depths,
                Vec::new(),
            ),
            self.panel(
                &format!("Depth of the bit ({})", width.name),
                self.of_each(&|trajectory, index| width.number(1e3 * trajectory.cut[index].depth)),
                Vec::new(),
            ),
        ]
    }

    /// The torque that turns the surface, where it is followed, together with the recorded one.
    fn surface_torque(&self) -> Option<Panel> {
        if !has_surface_torque(self.simulations) {
            return None;
        }
        let unit = self.torque_unit();
        let mut series =
            self.of_each(&|trajectory, index| unit.number(1e-3 * trajectory.surface_torque[index]));
        series.extend(self.recorded(TraceName::SurfaceTorqueNm, unit.number(1e-3)));
        let place = match self.sweep.content.top_drive {
            Some(_) => "of top drive",
            None => "at surface",
        };
        let label = format!("Torque {place} ({})", unit.name);
        Some(self.panel(&label, series, Vec::new()))
    }

    /// What was recorded of a trace, each once, times a factor, for as long as is simulated;
    /// several recordings have the names of what is held against them.
    fn recorded(&self, trace: TraceName, factor: f64) -> Vec<Series> {
        let times = self
            .simulations
            .iter()
            .flat_map(|it| it.trajectory.times.last());
        let end = times.copied().fold(0.0, f64::max);
        let of_trace = (self.sweep.data.comparisons.iter()).filter(|it| it.trace == trace);
        let mut recordings: Vec<(&Comparison, Vec<&str>)> = Vec::new();
        for comparison in of_trace {
            let known = recordings
                .iter_mut()
                .find(|(other, _)| comparison.has_same_recording(other));
            match known {
                Some((_, names)) => names.push(&comparison.name),
                None => recordings.push((comparison, vec![&comparison.name])),
            }
        }
        let is_alone = recordings.len() == 1;
        let series = recordings.iter().map(|(comparison, names)| {
            let name = match is_alone {
                true => comparison.description().to_owned(),
                false => format!("{} ({})", comparison.description(), names.join(", ")),
            };
            let recorded = &comparison.recorded;
            let samples = recorded.times().iter().zip(recorded.values());
            let shown = samples.take_while(|(time, _)| **time <= end);
            let points = shown.map(|(time, value)| (*time, factor * value));
            Series::new(name, points.collect())
        });
        series.collect()
    }

    /// The times of Eq. 72.
    fn first_slips(&self) -> impl Iterator<Item = Reference> {
        self.cases.iter().filter_map(|case| {
            let bit = case.scene.bit?;
            let times = stick_slip_times(
                &self.sweep.setting.string,
                case.scene.surface_speed,
                bit.torque_static,
                bit.torque_dynamic,
            );
            Some(Reference {
                across: Across::X,
                at: times.first_slip + 0.5 * self.sweep.setting.profile.rise(),
                name: "τ₁".to_owned(),
            })
        })
    }

    fn torque(&self) -> Panel {
        let unit = &self.torque_unit();
        let limit = |of: fn(BitTorque) -> f64| {
            move |case: &Case| Some(unit.number(1e-3 * of(case.scene.bit?)))
        };
        let mut limits = levels(self.cases, "T_s", limit(|bit| bit.torque_static));
        limits.extend(levels(self.cases, "T_d", limit(|bit| bit.torque_dynamic)));
        let torques =
            self.of_each(&|trajectory, index| unit.number(-1e-3 * trajectory.bit_torque[index]));
        self.panel(&format!("Torque on bit ({})", unit.name), torques, limits)
    }
}

/// A level of every case, each value once.
fn levels(cases: &[Case], name: &str, of: impl Fn(&Case) -> Option<f64>) -> Vec<Reference> {
    let values = each_once(cases.iter().filter_map(of)).into_iter();
    values.map(|value| level(value, name)).collect()
}

/// A series at a time in one of its steps or between that and the next or the last: methods
/// differ in where in a step their motion is.
fn value_at(points: &[(f64, f64)], step: usize, time: f64) -> Option<f64> {
    let &(now, own) = points.get(step)?;
    let neighbour = if time > now {
        points.get(step + 1)
    } else {
        points[..step].last()
    };
    Some(match neighbour {
        Some(&(then, other)) if time != now => own + (other - own) * (time - now) / (then - now),
        _ => own,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_series_is_straight_between_its_steps() {
        let points = [(0.5, 1.0), (1.5, 3.0), (2.5, 7.0)];
        let found = [(0, 0.0), (1, 1.0), (1, 1.5), (1, 2.0), (2, 3.0), (3, 3.0)];
        let found = found.map(|(step, time)| value_at(&points, step, time));
        let expected = [Some(1.0), Some(2.0), Some(3.0), Some(5.0), Some(7.0), None];
        assert_eq!(found, expected);
    }
}
