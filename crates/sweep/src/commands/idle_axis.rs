//! Quantities that `--set` changes in vain.

use anyhow::{Result, bail};

use super::status::UsageError;
use campaign::plan::{ImpulseSettings, Sweep};
use campaign::quantities::{Axis, StringAxis};

/// Refuses to set what nothing in the sweep depends on.
///
/// # Errors
/// Why nothing does.
pub fn refuse_idle_axis(sweep: &Sweep, axis: Axis) -> Result<()> {
    let lateral = sweep.setting.lateral.as_ref();
    let mut impulses = lateral.iter().flat_map(|lateral| &lateral.impulses);
    let has_ratio = impulses.any(ImpulseSettings::is_relative);
    let why = match axis {
        Axis::WeightOnBitKn | Axis::TorqueDynamicNm if sweep.bit.is_none() => {
            "the bit is free in this sweep"
        }
        Axis::Wall(_)
        | Axis::WallAtSite { .. }
        | Axis::String(StringAxis::BendingDamping | StringAxis::Compression)
            if lateral.is_none() =>
        {
            "there is no wall in this sweep"
        }
        Axis::WallAtSite { site, .. } if site >= sweep.content.sites.len() => {
            "the file has no such site; they are counted from 0"
        }
        Axis::TorqueStaticRatio | Axis::TorqueDecay if sweep.bit.is_none() => {
            "the bit is free in this sweep"
        }
        Axis::Rock(_) if sweep.conditions.value(axis).is_none() => {
            "the rock of this sweep has no such constant"
        }
        Axis::ImpulseRatio if !has_ratio => "no impulse of this sweep is in multiples of I₀",
        _ => return Ok(()),
    };
    bail!(UsageError(format!("--set {}: {why}", axis.name())))
}
