//! Bends of the well that no pipe goes through: a survey with a station that was typed wrong.

use super::sweep::Sweep;
use crate::words::counted;

/// By which the surface of pipe of the strongest grade, S-135, is stretched where it yields:
/// 931 MPa in steel of 207 GPa.
const YIELD_STRAIN: f64 = 0.0045;

impl Sweep {
    /// What is doubtful about the course of the well: bends so sharp that even the slimmest part of
    /// the string would yield there.
    pub(super) fn doubts_about_well(&self) -> Option<String> {
        let file = self.content.well.as_ref()?.survey.as_ref()?;
        let survey = self.data.survey.as_ref()?;
        let parts = self
            .setting
            .string
            .sections()
            .iter()
            .flat_map(|it| &it.parts);
        let slimmest = parts
            .map(|part| part.outer_radius)
            .fold(f64::INFINITY, f64::min);
        let stations = survey.stations();
        let bends = stations.windows(2).map(|pair| {
            let [from, to] = [0, 1].map(|index: usize| pair[index].measured_depth);
            (from, to, survey.turn_rate(0.5 * (from + to)))
        });
        let sharp: Vec<_> = bends
            .filter(|bend| slimmest * bend.2 > YIELD_STRAIN)
            .collect();
        let sharper = |one: &(f64, f64, f64), other: &(f64, f64, f64)| one.2.total_cmp(&other.2);
        let (from, to, rate) = sharp.iter().copied().max_by(sharper)?;
        let length = self.content.units.of(&crate::quantities::LENGTH);
        let more = match sharp.len() - 1 {
            0 => String::new(),
            others => format!(", and {} more", counted(others, "such bend")),
        };
        Some(format!(
            "{file}: the well turns by {:.3}° between {} and {}{more}: there even the slimmest part of \
             the string would bend until it yields; is a station wrong?",
            (rate * (to - from)).to_degrees(),
            length.text(from, 2),
            length.text(to, 2),
        ))
    }
}
