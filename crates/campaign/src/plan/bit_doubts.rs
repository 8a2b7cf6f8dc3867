//! What is doubtful at the bit: a weight that the string does not have, a rock for another bit.

use linear::Mud;
use linear::well::HangingString;

use super::contacts::StringInHole;
use super::hole::{self, PA_S_PER_CP};
use super::sweep::Sweep;
use crate::quantities::{Axis, FORCE, INCH};
use crate::sweep_file::{RockName, ToolKind};

/// Diameter of the bit that the rocks of the program are for, m.
const OF_ROCKS: f64 = 0.3;

/// A bit that differs from that by a larger fraction is warned of.
const ALIKE: f64 = 0.15;

impl Sweep {
    /// What is doubtful at the bit.
    pub(super) fn doubts_about_bit(&self) -> Vec<String> {
        [self.weight_is_doubtful(), self.rock_is_doubtful()]
            .into_iter()
            .flatten()
            .collect()
    }

    /// Radius with which the bit drills (m), where there is one and its gauge, its name or its hole say
    /// it.
    pub fn bit_radius(&self) -> Option<f64> {
        let string = &self.setting.string;
        let hole = hole::sections(&self.source, &self.content, string.length()).ok()?;
        let in_hole = StringInHole {
            string,
            sections: &self.content.string.sections,
            hole: &hole,
            drills: self.content.bit.is_some(),
        };
        in_hole.bit_radius()
    }

    /// Of a weight on bit that all of the string does not have.
    fn weight_is_doubtful(&self) -> Option<String> {
        let ends = self.design.ends(Axis::WeightOnBitKn);
        let most = ends.map(|[_, most]| most);
        let most = 1e3 * most.or(self.conditions.weight_on_bit_kn)?;
        let mud = (self.content.mud).map(|mud| Mud {
            density: mud.density_kg_m3,
            viscosity: PA_S_PER_CP * mud.viscosity_cp,
        });
        let survey = self.data.survey.as_deref();
        let along = HangingString::new(&self.setting.string, survey, mud).weight();
        let unit = self.content.units.of(&FORCE);
        let [most_kn, along_kn] = [most, along].map(|force| unit.text(1e-3 * force, 1));
        (most > along).then(|| {
            format!(
                "a weight on bit of {most_kn} is more than all of the string weighs along its well, \
                 {along_kn}"
            )
        })
    }

    /// Of a rock of the program, where a sheet has a bit of another size.
    fn rock_is_doubtful(&self) -> Option<String> {
        let rock = self.content.bit.as_ref()?.rock?;
        if !matches!(rock, RockName::Sandstone | RockName::Shale) {
            return None;
        }
        let sheet = self.sheet.as_ref()?;
        let bit = sheet
            .rows
            .iter()
            .position(|row| row.kind == ToolKind::Bit)?;
        let section = self.setting.string.sections().get(bit)?;
        let widest = section.parts.iter().map(|part| part.outer_radius);
        let radius = self.bit_radius().into_iter().chain(widest);
        let diameter = 2.0 * radius.fold(0.0, f64::max);
        let differs = (diameter / OF_ROCKS - 1.0).abs() > ALIKE;
        differs.then(|| {
            format!(
                "{}:{}: the bit is {:.3} in wide, and the rocks of this program are for one of {:.1} in: \
                 its torque at a weight is about {:.2} of theirs; give `rock = \"law\"` or a table",
                sheet.file,
                sheet.rows[bit].line,
                diameter / INCH,
                OF_ROCKS / INCH,
                diameter / OF_ROCKS
            )
        })
    }
}
