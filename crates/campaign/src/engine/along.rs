//! What a motion did at places along the string that are no sites, found after a case of the forces that it
//! was stepped by.

use anyhow::Result;
use linear::elements::reconstruction::WholeString;
use linear::{BendingPoles, Budget, BuildError, PlacePlan, PlaceQuantity, Tube};
use sim::{AtPlaces, Trajectory};

use super::case_error::CaseError;
use super::stepped::stepped_by;
use super::system_plan::SystemPlan;
use crate::plan::Setting;

/// A quantity at places along a string, as a method finds it.
#[derive(Debug)]
pub(super) struct Along {
    quantity: PlaceQuantity,
    /// Responses; none where elements are stepped once more.
    by: Option<AtPlaces>,
}

/// The string of a method that steps its elements.
fn stepped_string<'a>(plan: &SystemPlan<'a>) -> Option<WholeString<'a>> {
    let (lateral, parameters) = stepped_by(plan.setting, plan.method)?;
    Some(WholeString {
        string: &plan.setting.string,
        bending: &lateral.bending,
        support: lateral.support,
        sites: &plan.setting.sites,
        sampling_frequency: plan.setting.sampling_frequency,
        parameters,
    })
}

impl Along {
    /// Asks for what it takes of a budget at places (m from the bit), and returns the bytes of a case.
    ///
    /// # Errors
    /// Where it cannot be built, or is more than is left.
    pub(super) fn ask(
        plan: &SystemPlan,
        (quantity, places): (PlaceQuantity, &[f64]),
        budget: &Budget,
    ) -> Result<f64, BuildError> {
        if places.is_empty() {
            return Ok(0.0);
        }
        if let Some(whole) = stepped_string(plan) {
            return Ok(whole.need_at_places(places.len(), plan.steps()).peak);
        }
        let request = plan.request();
        let wanted = (quantity, places);
        let responses = PlacePlan::new(&plan.setting.string, plan.method, &request, wanted)?;
        let passing = budget.part();
        responses.ask(&passing)?;
        let count = (places.len(), plan.setting.sites.len());
        AtPlaces::ask(count, responses.taps(), budget)?;
        Ok(AtPlaces::bytes_of_motion(
            count,
            responses.taps(),
            plan.steps(),
        ))
    }

    /// Builds it at places (m from the bit), of the poles of the string where it has any and they show it; `None`
    /// where there are none.
    ///
    /// # Errors
    /// Where the method does not treat the string.
    pub(super) fn build(
        plan: &SystemPlan,
        (quantity, places): (PlaceQuantity, &[f64]),
        poles: Option<&BendingPoles>,
    ) -> Result<Option<Self>> {
        if places.is_empty() {
            return Ok(None);
        }
        if stepped_string(plan).is_some() {
            return Ok(Some(Self { quantity, by: None }));
        }
        let shown =
            poles.filter(|it| quantity == PlaceQuantity::Displacement && it.places() == places);
        let responses = match shown {
            Some(poles) => poles.place_responses(plan.longest_time)?,
            None => {
                let (request, wanted) = (plan.request(), (quantity, places));
                let string = &plan.setting.string;
                let responses = PlacePlan::new(string, plan.method, &request, wanted)?;
                responses.build(&Budget::unlimited())?
            }
        };
        let by = Some(AtPlaces::new(responses)?);
        Ok(Some(Self { quantity, by }))
    }

    /// The quantity along x and along y at the same places in all steps of a motion from one on: by how much
    /// it differs from that of the string at rest.
    ///
    /// # Errors
    /// Where it cannot be found.
    pub(super) fn of(
        &self,
        plan: &SystemPlan,
        places: &[f64],
        motion: &Trajectory,
        from: usize,
    ) -> Result<Vec<[Vec<f64>; 2]>, CaseError> {
        let failed = |error: anyhow::Error| CaseError::Responses(error);
        if let Some(responses) = &self.by {
            let found = responses.of(&motion.forces, from);
            return found.map_err(|error| failed(error.into()));
        }
        let Some(whole) = stepped_string(plan) else {
            return Ok(Vec::new());
        };
        // Stepped elements need no springs.
        let free = plan.setting.sites.without_springs();
        let whole = WholeString {
            sites: &free,
            ..whole
        };
        let found = match self.quantity {
            PlaceQuantity::Displacement => whole.displacements(&motion.forces, places, from),
            PlaceQuantity::Moment => whole.moments(&motion.forces, places, from),
        };
        found.map_err(|error| failed(error.into()))
    }
}

/// The first step of a closing window (s) of a motion.
pub(super) fn closing_from(motion: &Trajectory, window: f64, sampling_frequency: f64) -> usize {
    let steps = (window * sampling_frequency).round() as usize;
    motion.times.len().saturating_sub(steps.max(1))
}

/// The tubes that meet at a distance from the bit (m), or twice the same.
pub(super) fn tubes_at(setting: &Setting, place: f64) -> [Tube; 2] {
    let sections = setting.string.sections();
    let parts = setting.string.parts_around(place);
    parts.map(|(section, part)| sections[section].parts[part])
}
