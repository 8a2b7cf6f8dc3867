//! Bands of accelerations that the sampling frequency does not hold.

use sim::{USUAL_BAND, highest_band};

use super::lateral::LateralSettings;
use super::sweep::Sweep;

impl Sweep {
    /// Bands that the sampling frequency does not hold.
    pub(super) fn doubts_about_bands(&self) -> Vec<String> {
        let setting = &self.setting;
        let is_shaken = |lateral: &LateralSettings| lateral.shocks.is_some();
        let is_measured =
            setting.cutting.is_some() || setting.lateral.as_ref().is_some_and(is_shaken);
        let of_sites = [USUAL_BAND];
        let bands = match setting.tools.as_slice() {
            [] if is_measured => of_sites.as_slice(),
            _ => setting.tool_bands.as_slice(),
        };
        let highest = highest_band(setting.sampling_frequency);
        let widest = bands.iter().copied().fold(0.0, f64::max);
        let is_held = widest <= highest;
        let doubt = (!is_held).then(|| {
            let wanted = (widest / highest * setting.sampling_frequency).ceil();
            format!(
                "accelerations are measured within {highest:.1} Hz, a quarter of the sampling frequency, \
                 and not within {widest:.1} Hz: `sampling_frequency_hz` of {wanted:.0} or more holds that"
            )
        });
        doubt.into_iter().collect()
    }
}
