//! The picture of motion over time.

use anyhow::Result;
use linear::estimates::stick_slip_times;
use sim::{BitTorque, Trajectory};

use super::marks::{level, shown_clearance};
use super::simulation::{Simulation, has_torque};
use crate::engine::Case;
use crate::plan::{LateralSettings, Sweep, to_rpm};
use crate::plot::{Across, Axis, Panel, Panels, Picture, Reference, Series, panels};
use crate::words::site_title;

/// With lateral motion, the radius of every site (Figs. 10 to 16); else its
/// speed and the torque on the bit. As in the paper, the difference between the
/// first two methods is beneath.
///
/// # Errors
/// Where it cannot be drawn.
pub fn history_picture(
    sweep: &Sweep,
    cases: &[Case],
    simulations: &[Simulation],
) -> Result<Picture> {
    let histories = Histories {
        sweep,
        cases,
        simulations,
        step: 1.0 / sweep.setting.sampling_frequency,
    };
    panels(&Panels {
        title: sweep.title.clone(),
        panels: match &sweep.setting.lateral {
            Some(lateral) => histories.radii(lateral),
            None => histories.speeds_and_torque(),
        },
    })
}

/// What is drawn over time.
struct Histories<'a> {
    sweep: &'a Sweep,
    cases: &'a [Case],
    simulations: &'a [Simulation],
    step: f64,
}

impl Histories<'_> {
    fn panel(&self, label: &str, series: Vec<Series>, references: Vec<Reference>) -> Panel {
        Panel {
            x: Axis::linear("Time t (s)"),
            y: Axis::linear(label),
            series,
            references,
        }
    }

    /// A series over the time of a simulation; each case has its own.
    fn series(&self, name: &str, of: &Simulation, values: &dyn Fn(usize) -> f64) -> Series {
        let speeds = of.trajectory.speeds.first();
        Series {
            name: name.to_owned(),
            points: (0..speeds.map_or(0, Vec::len))
                .map(|index| (index as f64 * self.step, values(index)))
                .collect(),
        }
    }

    fn of_each(&self, values: &dyn Fn(&Trajectory, usize) -> f64) -> Vec<Series> {
        let series = self.simulations.iter().map(|simulation| {
            let of_step = |index| values(&simulation.trajectory, index);
            self.series(&simulation.name, simulation, &of_step)
        });
        series.collect()
    }

    /// Between the first two methods, where there is one case.
    fn difference(&self, label: &str, values: &dyn Fn(&Trajectory, usize) -> f64) -> Option<Panel> {
        let ([_], [first, second, ..]) = (self.cases, self.simulations) else {
            return None;
        };
        let name = format!("{} − {}", first.name, second.name);
        let series = self.series(&name, first, &|index| {
            values(&first.trajectory, index) - values(&second.trajectory, index)
        });
        Some(self.panel(label, vec![series], Vec::new()))
    }

    fn radii(&self, lateral: &LateralSettings) -> Vec<Panel> {
        let distances = self.sweep.setting.sites.distances_from_bit().iter();
        let mut list: Vec<Panel> = distances
            .zip(&lateral.walls)
            .enumerate()
            .map(|(site, (&distance, wall))| {
                let radii = self.of_each(&|trajectory, index| radius_mm(trajectory, site, index));
                let points = radii.iter().flat_map(|series| &series.points);
                let clearance = shown_clearance(wall.clearance, points.map(|point| point.1));
                let wall = clearance.map(|clearance| level(clearance, "clearance"));
                let label = format!("Radius at {} (mm)", site_title(distance));
                self.panel(&label, radii, wall.into_iter().collect())
            })
            .collect();
        let lowest = self.sweep.setting.sites.len() - 1;
        let distance = self.sweep.setting.sites.distances_from_bit()[lowest];
        list.extend(self.difference(
            &format!("Difference in radius at {} (mm)", site_title(distance)),
            &|trajectory, index| radius_mm(trajectory, lowest, index),
        ));
        list
    }

    fn speeds_and_torque(&self) -> Vec<Panel> {
        let mut list = Vec::new();
        let distances = self.sweep.setting.sites.distances_from_bit().iter();
        for (site, &distance) in distances.enumerate().rev() {
            let label = if distance == 0.0 {
                "Bit speed (rpm)".to_owned()
            } else {
                format!("Speed {distance} m above the bit (rpm)")
            };
            list.push(self.panel(
                &label,
                self.of_each(&|trajectory, index| to_rpm(trajectory.speeds[site][index])),
                levels(self.cases, "Ω", |case| {
                    Some(to_rpm(case.scene.surface_speed))
                }),
            ));
        }
        if let Some(bit_speed) = list.first_mut() {
            bit_speed.references.extend(self.first_slips());
        }
        if has_torque(self.simulations) {
            list.push(self.torque());
        }
        let bit = self.sweep.setting.sites.len() - 1;
        list.extend(
            self.difference("Difference in bit speed (rpm)", &|trajectory, index| {
                to_rpm(trajectory.speeds[bit][index])
            }),
        );
        list
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
                at: times.first_slip,
                name: "τ₁".to_owned(),
            })
        })
    }

    fn torque(&self) -> Panel {
        let limit = |of: fn(BitTorque) -> f64| move |case: &Case| Some(1e-3 * of(case.scene.bit?));
        let mut limits = levels(self.cases, "Tₛ", limit(|bit| bit.torque_static));
        limits.extend(levels(self.cases, "T_d", limit(|bit| bit.torque_dynamic)));
        self.panel(
            "Torque on bit (kN m)",
            self.of_each(&|trajectory, index| -1e-3 * trajectory.bit_torque[index]),
            limits,
        )
    }
}

fn radius_mm(trajectory: &Trajectory, site: usize, index: usize) -> f64 {
    let [x, y] = trajectory.positions[site][index];
    1e3 * x.hypot(y)
}

/// A level of every case, each value once.
fn levels(cases: &[Case], name: &str, of: impl Fn(&Case) -> Option<f64>) -> Vec<Reference> {
    let mut values: Vec<f64> = cases.iter().filter_map(of).collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values.into_iter().map(|value| level(value, name)).collect()
}
