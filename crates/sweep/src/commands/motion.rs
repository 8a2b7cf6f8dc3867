//! The pictures of simulated cases: histories, orbits, the whole string.

use anyhow::Result;
use linear::BendingRequest;
use linear::elements::reconstruction::reconstruct;
use linear::estimates::stick_slip_times;
use sim::{BitTorque, Trajectory};

use super::plot::axis;
use super::simulate::{Simulation, has_torque};
use super::site_title;
use crate::engine::Case;
use crate::plot::{Orbit, Orbits, Panel, Panels, Reference, Series};
use crate::spec::{LateralSettings, Sweep, to_rpm};

/// The clearance is drawn where motion reaches this part of it.
const CLEARANCE_SHOWN: f64 = 0.2;

/// The way of every site's centre, with the circle of its clearance.
pub fn site_orbits(sweep: &Sweep, simulations: &[Simulation]) -> Orbits {
    let distances = sweep.setting.sites.distances_from_bit().iter().enumerate();
    let walls = sweep
        .setting
        .lateral
        .iter()
        .flat_map(|lateral| &lateral.walls);
    let orbits = distances.zip(walls).map(|((site, &distance), wall)| Orbit {
        x: axis(&format!("x at {} (mm)", site_title(distance))),
        y: axis("y (mm)"),
        series: simulations
            .iter()
            .map(|simulation| Series {
                name: simulation.name.clone(),
                points: simulation.trajectory.positions[site]
                    .iter()
                    .map(|[x, y]| (1e3 * x, 1e3 * y))
                    .collect(),
            })
            .collect(),
        circle: 1e3 * wall.clearance,
    });
    Orbits {
        title: sweep.title.clone(),
        orbits: orbits.collect(),
    }
}

/// Fig. 13: the peak displacement of the whole string, reconstructed by finite
/// elements from the forces at its sites, whatever method gave them.
pub fn along_string(
    sweep: &Sweep,
    lateral: &LateralSettings,
    simulations: &[Simulation],
) -> Result<Panels> {
    let request = BendingRequest {
        sites: sweep.setting.sites.clone(),
        support: lateral.support,
        sampling_frequency: sweep.setting.sampling_frequency,
        longest_time: 0.0,
    };
    let series = simulations
        .iter()
        .map(|simulation| {
            let whole = reconstruct(
                &sweep.setting.string,
                &lateral.bending,
                &request,
                &sweep.content.method.finite_element,
                &simulation.trajectory.forces,
                &[],
            )?;
            let peaks = whole.peaks.iter().map(|peak| 1e3 * peak);
            Ok(Series {
                name: simulation.name.clone(),
                points: whole.depths.iter().copied().zip(peaks).collect(),
            })
        })
        .collect::<Result<Vec<_>>>()?;
    let clearance = lateral.walls.iter().map(|wall| wall.clearance);
    Ok(Panels {
        title: format!("{}: the whole string", sweep.title),
        panels: vec![Panel {
            x: axis("Depth ξ (m)"),
            y: axis("Peak radius (mm)"),
            series,
            references: vec![level(
                1e3 * clearance.fold(f64::INFINITY, f64::min),
                "least clearance",
            )],
        }],
    })
}

/// With lateral motion, the radius of every site (Figs. 10 to 16); else its
/// speed, torque on the bit, and, as in the paper, the difference between the
/// first two methods beneath.
pub fn history_panels(
    sweep: &Sweep,
    cases: &[Case],
    simulations: &[Simulation],
    step: f64,
) -> Panels {
    let series = |name: &str, values: &dyn Fn(usize) -> f64, count: usize| Series {
        name: name.to_owned(),
        points: (0..count)
            .map(|index| (index as f64 * step, values(index)))
            .collect(),
    };
    let of_each = |values: &dyn Fn(&Trajectory, usize) -> f64| -> Vec<Series> {
        simulations
            .iter()
            .map(|simulation| {
                let trajectory = &simulation.trajectory;
                let count = trajectory.speeds[0].len();
                series(&simulation.name, &|index| values(trajectory, index), count)
            })
            .collect()
    };
    let panel = |label: &str, series, references| Panel {
        x: axis("Time t (s)"),
        y: axis(label),
        series,
        references,
    };
    let mut list: Vec<Panel> = Vec::new();
    if let Some(lateral) = &sweep.setting.lateral {
        let sites = sweep
            .setting
            .sites
            .distances_from_bit()
            .iter()
            .zip(&lateral.walls);
        for (site, (&distance, wall)) in sites.enumerate() {
            let radii = of_each(&|trajectory, index| {
                let [x, y] = trajectory.positions[site][index];
                1e3 * x.hypot(y)
            });
            let clearance = 1e3 * wall.clearance;
            let points = radii.iter().flat_map(|series| &series.points);
            let furthest = points.fold(0.0, |most: f64, point| most.max(point.1));
            // Motion far from the wall would not be seen beside it.
            let shows_wall = furthest > CLEARANCE_SHOWN * clearance;
            list.push(panel(
                &format!("Radius at {} (mm)", site_title(distance)),
                radii,
                shows_wall
                    .then(|| level(clearance, "clearance"))
                    .into_iter()
                    .collect(),
            ));
        }
        return Panels {
            title: sweep.title.clone(),
            panels: list,
        };
    }
    for (site, &distance) in sweep
        .setting
        .sites
        .distances_from_bit()
        .iter()
        .enumerate()
        .rev()
    {
        let label = if distance == 0.0 {
            "Bit speed (rpm)".to_owned()
        } else {
            format!("Speed {distance} m above the bit (rpm)")
        };
        list.push(panel(
            &label,
            of_each(&|trajectory, index| to_rpm(trajectory.speeds[site][index])),
            levels(cases, "Ω", |case| Some(to_rpm(case.scene.surface_speed))),
        ));
    }
    if let Some(bit_speed) = list.first_mut() {
        let first_slips = cases.iter().filter_map(|case| {
            let bit = case.scene.bit?;
            let speed = case.scene.surface_speed;
            let times = stick_slip_times(
                &sweep.setting.string,
                speed,
                bit.torque_static,
                bit.torque_dynamic,
            );
            Some(Reference::Vertical {
                x: times.first_slip,
                name: "τ₁".to_owned(),
            })
        });
        bit_speed.references.extend(first_slips);
    }
    if has_torque(simulations) {
        let limit = |of: fn(BitTorque) -> f64| move |case: &Case| Some(1e-3 * of(case.scene.bit?));
        let mut limits = levels(cases, "Tₛ", limit(|bit| bit.torque_static));
        limits.extend(levels(cases, "T_d", limit(|bit| bit.torque_dynamic)));
        list.push(panel(
            "Torque on bit (kN m)",
            of_each(&|trajectory, index| -1e-3 * trajectory.bit_torque[index]),
            limits,
        ));
    }
    if let ([_], [first, second, ..]) = (cases, simulations) {
        let bit = sweep.setting.sites.len() - 1;
        let (one, other) = (
            &first.trajectory.speeds[bit],
            &second.trajectory.speeds[bit],
        );
        let name = format!("{} − {}", first.name, second.name);
        let difference = series(&name, &|index| to_rpm(one[index] - other[index]), one.len());
        list.push(panel(
            "Difference in bit speed (rpm)",
            vec![difference],
            Vec::new(),
        ));
    }
    Panels {
        title: sweep.title.clone(),
        panels: list,
    }
}

/// A level of every case, each value once.
fn levels(cases: &[Case], name: &str, of: impl Fn(&Case) -> Option<f64>) -> Vec<Reference> {
    let mut values: Vec<f64> = cases.iter().filter_map(of).collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values.into_iter().map(|value| level(value, name)).collect()
}

fn level(y: f64, name: &str) -> Reference {
    Reference::Horizontal {
        y,
        name: name.to_owned(),
    }
}
