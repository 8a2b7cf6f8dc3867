//! The limit of a mud motor: the weight on bit from which on it stalls.

use super::asked::WindowAsked;
use super::chart::{Drawn, Source};
use super::simulated::AXES;
use super::standing::Standing;
use campaign::plan::Sweep;
use campaign::words::short;
use limits::motor_stalls;

/// The limit within ranges of weight on bit (kN) and surface speed (rpm), by the chart of the motor
/// and the law of the bit; none without a motor, or where cases differ in more than these.
pub fn limit(
    sweep: &Sweep,
    [weights, speeds]: [[f64; 2]; 2],
    asked: &WindowAsked,
) -> Option<Source<'static>> {
    let bit = sweep.bit.as_ref()?;
    // A limit just beyond the map is near to its edge.
    let margin = asked.margin;
    let range = [weights[0], weights[1] / (1.0 - margin)];
    let stalls: Vec<_> = motor_stalls(sweep, bit, AXES[0], (range, speeds)).collect();
    if stalls.is_empty() {
        return None;
    }
    let from = |stall: &(f64, Option<f64>)| stall.1.unwrap_or(f64::INFINITY);
    let least = stalls.iter().map(from).fold(f64::INFINITY, f64::min);
    let most = stalls.iter().map(from).fold(0.0, f64::max);
    let extent = match (least <= weights[0], least.is_finite()) {
        (true, _) => "on the whole map".to_owned(),
        (_, true) => format!("from {} kN on", short(least)),
        (_, false) => "nowhere on the map".to_owned(),
    };
    let line = stalls
        .iter()
        .filter_map(|&(speed, from)| Some([from?, speed]));
    let line =
        line.filter(|[from, _]| (weights[0]..=weights[1]).contains(from) && *from > weights[0]);
    Some(Source {
        name: "stall of the mud motor".to_owned(),
        description: format!(
            "{extent}, by its chart and the torque of the bit; margin: {} %",
            short(100.0 * margin)
        ),
        edges: Default::default(),
        drawn: Drawn::Lines(vec![line.collect()]),
        standing: Box::new(move |[[low, high], _]| {
            Standing::above([-high, -low], -most, -(1.0 - margin) * least)
        }),
    })
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    /// A motor that a bit of 100 N m per kN stalls at 60 kN.
    fn standing(weights: [f64; 2]) -> Standing {
        let text = "surface_speed_rpm = 120\nmethods = [\"held\"]\n\
            [string]\nshear_modulus_gpa = 79.3\ndensity_kg_m3 = 7850\n\
            torsional_damping_nms_rad_m = 0.03\n\
            sections = [{ repeat = 100, parts = [{ length_m = 10, inner_radius_m = 0.05, \
            outer_radius_m = 0.06 }] }]\n\
            [bit]\nrock = \"table\"\ntable_kn_nm = [[0, 0], [200, 20000]]\n\
            torque_static_ratio = 1.2\n\
            [motor]\nspeed_rpm = 100\nstall_torque_kn_m = 6\n\
            [design]\nkind = \"grid\"\n[design.axes]\n\
            weight_on_bit_kn = { from = 20, to = 100, count = 3 }\n";
        let sweep = Sweep::read_from(Path::new("sweep.toml"), &[], &|_, _| Ok(text.to_owned()));
        let asked = WindowAsked {
            orders: vec![1.0],
            held_at: None,
            margin: 0.1,
            risk: 0.05,
            bins: 8,
            accept_chatter: false,
        };
        let ranges = [[20.0, 100.0], [60.0, 180.0]];
        let limit = limit(&sweep.unwrap(), ranges, &asked).unwrap();
        assert!(
            limit.description.starts_with("from 60 kN on"),
            "{}",
            limit.description
        );
        (limit.standing)([weights, [60.0, 180.0]])
    }

    #[test]
    fn what_stalls_the_motor_is_not_safe() {
        assert_eq!(standing([20.0, 53.9]), Standing::Clear);
        assert_eq!(standing([50.0, 54.1]), Standing::Near);
        assert_eq!(standing([59.0, 61.0]), Standing::Near);
        assert_eq!(standing([60.1, 99.0]), Standing::Against);
    }
}
