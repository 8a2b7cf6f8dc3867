//! Quantities that are set in vain.

use crate::plan::{ImpulseSettings, Sweep};
use crate::quantities::{Axis, StringAxis};

/// Why nothing in a sweep depends on a quantity, where nothing does: setting it would be in vain.
pub fn unused_reason(sweep: &Sweep, axis: Axis) -> Option<&'static str> {
    let lateral = sweep.setting.lateral.as_ref();
    let mut impulses = lateral.iter().flat_map(|lateral| &lateral.impulses);
    let has_ratio = impulses.any(ImpulseSettings::is_relative);
    match axis {
        Axis::WeightOnBitKn | Axis::TorqueDynamicNm if sweep.bit.is_none() => {
            Some("the bit is free in this sweep")
        }
        Axis::Wall(_)
        | Axis::WallAtSite { .. }
        | Axis::String(StringAxis::BendingDamping | StringAxis::Compression)
            if lateral.is_none() =>
        {
            Some("there is no wall in this sweep")
        }
        Axis::WallAtSite { site, .. } if site >= sweep.content.sites.len() => {
            Some("the file has no such site; they are counted from 0")
        }
        Axis::TorqueStaticRatio | Axis::TorqueDecay if sweep.bit.is_none() => {
            Some("the bit is free in this sweep")
        }
        Axis::FeedMH if sweep.conditions.feed_m_h.is_none() => {
            Some("nothing is let down at a set speed in this sweep")
        }
        Axis::StartNumber if sweep.setting.cutting.is_none() => {
            Some("no start is disturbed by chance in this sweep: its bit has no [bit.cutting]")
        }
        Axis::Rock(_) if sweep.conditions.value(axis).is_none() => {
            Some("the rock of this sweep has no such constant")
        }
        Axis::ImpulseRatio if !has_ratio => Some("no impulse of this sweep is in multiples of I₀"),
        _ => None,
    }
}
