//! A string that lies in its hole is modelled sideways a little further than its highest site. Above, it is
//! taken to lie there: where it is pushed by more than pipe on the low side bears, it does not.

use linear::well::PressedLength;
use serde::Serialize;
use statics::closed_forms::buckling::of_lying_string;

use crate::engine::Clearances;
use crate::plan::{Conditions, Setting};
use crate::quantities::{FORCE, LENGTH, Units};

/// Joints weigh on pipe from as far off, m: half a cell of drillpipe.
const JOINTS_WITHIN: f64 = 5.0;

/// Where a string snakes above what is modelled of it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SnakingAbove {
    /// The lowest and the highest place where it does.
    pub from_bit_m: [f64; 2],
    /// What it is pushed with where that is farthest beyond what it bears.
    pub pushed_kn: f64,
    /// What it bears there lying on the low side: 2 √(EI q/c).
    pub bears_kn: f64,
}

impl SnakingAbove {
    /// Of the string of a setting under conditions, if it snakes there.
    pub fn of(setting: &Setting, conditions: &Conditions) -> Option<Self> {
        let modelled = setting.string.bending_length();
        let length = setting.string.length();
        let (lying, lateral) = (setting.lying.as_ref()?, setting.lateral.as_ref()?);
        let places = setting.sites.distances_from_bit().iter();
        let sites = places.zip(&lateral.walls);
        let sites = sites.map(|(place, wall)| (*place, wall.in_case(conditions).clearance));
        let clearances = Clearances::around(setting, conditions, sites)?;
        let all = lying.along(&setting.string, (lateral, conditions));
        let bears = |it: &PressedLength| {
            let [from, to] = [-JOINTS_WITHIN, JOINTS_WITHIN]
                .map(|off| all.partition_point(|other| other.depth < it.depth + off));
            let (pressing, long) = (all[from..to].iter())
                .map(|other| (other.load * other.length, other.length))
                .fold((0.0, 0.0), |sum, it| (sum.0 + it.0, sum.1 + it.1));
            let [(section, part), _] = setting.string.parts_around(length - it.depth);
            let tube = setting.string.sections()[section].parts[part];
            // Pipe lies on its joints.
            let clearance = clearances.at(it.depth)? + tube.outer_radius - it.radius;
            let rigidity = lateral.bending.youngs_modulus * tube.second_moment();
            (clearance > 0.0).then(|| of_lying_string(rigidity, pressing / long, clearance))
        };
        let above = all.partition_point(|it| length - it.depth > modelled);
        let above = &all[..above];
        let pushed = above.iter().filter(|it| it.tension < 0.0);
        let snaking: Vec<_> = pushed
            .filter_map(|it| Some((it, bears(it)?)))
            .filter(|(it, bears)| -it.tension > *bears)
            .collect();
        let part = |(it, bears): &&(&PressedLength, f64)| -it.tension / bears;
        let (most, bears) = snaking
            .iter()
            .max_by(|one, other| part(one).total_cmp(&part(other)))?;
        Some(Self {
            from_bit_m: [snaking.last()?, snaking.first()?].map(|(it, _)| length - it.depth),
            pushed_kn: -1e-3 * most.tension,
            bears_kn: 1e-3 * bears,
        })
    }

    /// What it does, and what helps, in units.
    pub fn words(&self, units: Units) -> String {
        let [force, length] = [&FORCE, &LENGTH].map(|twin| units.of(twin));
        let [from, to] = self.from_bit_m.map(|place| length.text(place, 0));
        let [pushed, bears] = [self.pushed_kn, self.bears_kn].map(|it| force.text(it, 1));
        format!(
            "the string snakes above what is modelled sideways, between {from} and {to} from the bit, pushed \
             with {pushed} where it bears {bears}: labels are of what is below, and a larger `sites_to_m` \
             models more"
        )
    }
}
