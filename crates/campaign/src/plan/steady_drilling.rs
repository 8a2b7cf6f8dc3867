//! Steady drilling of a string under the conditions of a case, and small motion about it.

use linear::DrillstringError;
use linear::estimates::torsional_resistance;
use linear::regenerative::{CuttingLoop, Rotor, SteadyCut};
use linear::steady::rotation_speed;

use super::bit::Bit;
use super::conditions::Conditions;
use super::cutting::SteadyDrilling;
use super::setting::Setting;

impl Setting {
    /// Steady drilling of the bit under conditions, and as small motion feels it, which is not known where a
    /// motor stalls; `None` where the bit does not cut or does not drill, or the drive has not the torque for it.
    pub fn steady_drilling(
        &self,
        bit: &Bit,
        conditions: &Conditions,
    ) -> Option<(SteadyDrilling, Option<SteadyCut>)> {
        let settings = self.cutting.as_ref()?;
        let cutting = settings.bit_in(bit.cutting_law(conditions).ok()??);
        let feed = settings.feed(conditions)?;
        let speed = conditions.surface_speed()?;
        let (string, motor) = (&self.string, self.motor);
        let steady = settings.steady((string, motor), &cutting, speed, feed);
        let stalls = motor.is_some_and(|motor| steady.torque >= motor.stall_torque);
        let cut = steady.cut(&cutting).filter(|_| !stalls);
        let turned = rotation_speed(string, speed, steady.torque);
        let taken = steady.torque + torsional_resistance(string) * turned.abs();
        let has_torque = self.drive_limit.is_none_or(|limit| taken < limit);
        (steady.rate > 0.0 && has_torque).then_some((steady, cut))
    }

    /// The string above its bit, with the motor between them; `None` where the bit does not cut.
    ///
    /// # Errors
    /// Where the string cannot be cut up.
    pub fn cutting_loop(&self) -> Result<Option<CuttingLoop<'_>>, DrillstringError> {
        let Some(settings) = &self.cutting else {
            return Ok(None);
        };
        let cutting = CuttingLoop::new(&self.string, &settings.rod)?;
        Ok(Some(match self.motor {
            None => cutting,
            Some(motor) => cutting.above_motor(Rotor {
                slip: motor.slip,
                inertia: motor.rotor_inertia,
            }),
        }))
    }
}
