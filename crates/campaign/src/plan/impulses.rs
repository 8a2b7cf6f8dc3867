//! Lateral impulses.

use super::sites::Places;
use crate::quantities::in_digits;
use crate::sweep_file::{ImpulseTable, Source, SweepFileError};

/// More than any impulse, N s: a site whose I₀ is larger cannot reach its wall.
pub const LARGEST_IMPULSE: f64 = 1e9;

/// What pushes the string for longer is no impulse, s.
const LONGEST_IMPULSE: f64 = 100.0;

/// An impulse, but for what a case says of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpulseSettings {
    /// The site it acts on.
    pub site: usize,
    /// Its amount.
    pub amount: ImpulseAmount,
    /// When it begins, s.
    pub start: f64,
    /// How long it lasts, s.
    pub duration: f64,
    /// Its direction, rad.
    pub direction: f64,
}

/// How strong an impulse is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ImpulseAmount {
    /// In N s.
    NewtonSeconds(f64),
    /// In multiples of I₀; none where every case gives it.
    Ratio(Option<f64>),
}

impl ImpulseSettings {
    /// Whether its amount is in multiples of I₀.
    pub fn is_relative(&self) -> bool {
        matches!(self.amount, ImpulseAmount::Ratio(_))
    }

    /// The impulse of this amount.
    pub fn with_amount(&self, amount: f64) -> sim::Impulse {
        sim::Impulse {
            site: self.site,
            amount,
            start: self.start,
            duration: self.duration,
            direction: self.direction,
        }
    }
}

/// An impulse of the file.
///
/// # Errors
/// Where it is invalid.
pub fn resolve(
    source: &Source,
    index: usize,
    table: &ImpulseTable,
    places: &Places,
    ratio_by_axis: bool,
) -> Result<ImpulseSettings, SweepFileError> {
    let key = |name: &str| format!("impulses[{index}].{name}");
    let place = table.distance_from_bit_m;
    let site = places.site_of(source, &key("distance_from_bit_m"), place)?;
    let start = source.within(&key("start_s"), table.start_s, 0.0, 1e6, "s")?;
    let duration = table.duration_s;
    let message = format!("{duration} s: the impulse ends before it starts");
    let is_nothing = duration.is_nan() || duration <= 0.0;
    source.refuse_if(is_nothing, &key("duration_s"), message)?;
    let message = format!(
        "{} s: an impulse lasts {LONGEST_IMPULSE} s at most; is it in another unit?",
        in_digits(duration)
    );
    source.refuse_if(duration > LONGEST_IMPULSE, &key("duration_s"), message)?;
    let direction = table.direction_deg;
    let direction = source.within(&key("direction_deg"), direction, -360.0, 360.0, "°")?;
    let within = |name, value, unit| source.within(&key(name), value, 0.0, LARGEST_IMPULSE, unit);
    let amount = match (table.amount_ns, table.ratio) {
        (Some(amount), None) => ImpulseAmount::NewtonSeconds(within("amount_ns", amount, "N s")?),
        (None, Some(ratio)) => ImpulseAmount::Ratio(Some(within("ratio", ratio, "")?)),
        (None, None) if ratio_by_axis => ImpulseAmount::Ratio(None),
        _ => {
            let message = "needs either `amount_ns` or `ratio`, or the axis impulse_ratio";
            return Err(source.error(&format!("impulses[{index}]"), message));
        }
    };
    Ok(ImpulseSettings {
        site,
        amount,
        start,
        duration,
        direction: direction.to_radians(),
    })
}
