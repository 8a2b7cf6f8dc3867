//! Values of arguments, read from what a person wrote.

use std::path::PathBuf;

use clap::builder::{PathBufValueParser, TypedValueParser};
use sim::{Label, Motion};

use campaign::quantities::Axis;
use campaign::sweep_file::{axis_in_units, axis_named};
use campaign::text_file::STANDARD_INPUT;
use studies::tradeoff::Measure;

/// A sweep file: a path, or `-` for standard input.
pub fn sweep_file() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().map(|path| match path.to_str() {
        Some("-") => PathBuf::from(STANDARD_INPUT),
        _ => path,
    })
}

/// A measure of the chart of accuracy against speed.
///
/// # Errors
/// What is wrong with it.
pub fn parse_measure(name: &str) -> Result<Measure, String> {
    Measure::from_name(name).ok_or_else(|| {
        let known = Measure::all().map(Measure::name);
        format!("unknown measure `{name}`; known: {}", known.join(", "))
    })
}

/// A part of a whole, up to a half.
///
/// # Errors
/// What is wrong with it.
pub fn parse_part(text: &str) -> Result<f64, String> {
    let is_part = |part: &f64| (0.0..=0.5).contains(part);
    let part = text.trim().parse().ok().filter(is_part);
    part.ok_or_else(|| format!("`{text}` is not a fraction from 0 to 0.5"))
}

/// A fraction, up to a half, which may be given in per cent.
///
/// # Errors
/// What is wrong with it.
pub fn parse_margin(text: &str) -> Result<f64, String> {
    let number = |text: &str| text.trim().parse::<f64>().ok();
    let part = match text.trim().strip_suffix('%') {
        Some(per_cent) => number(per_cent).map(|it| 0.01 * it),
        None => number(text),
    };
    let part = part.filter(|part| (1e-6..=0.5).contains(part));
    part.ok_or_else(|| format!("`{text}` is not a fraction such as 5% or 0.05, up to 50%"))
}

/// A file that a picture is written to, in the format of its ending.
#[derive(Debug, Clone)]
pub enum PictureFile {
    /// In vectors.
    Svg(PathBuf),
    /// In pixels.
    Png(PathBuf),
}

/// A file with the ending of a picture.
///
/// # Errors
/// What is wrong with it.
pub fn parse_picture(text: &str) -> Result<PictureFile, String> {
    let path = PathBuf::from(text);
    let ending = path.extension().and_then(|ending| ending.to_str());
    match ending.map(str::to_ascii_lowercase).as_deref() {
        Some("svg") => Ok(PictureFile::Svg(path)),
        Some("png") => Ok(PictureFile::Png(path)),
        _ => Err("a picture ends in .svg or .png".to_owned()),
    }
}

/// A length on paper, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Length(f64);

/// The mm of each unit of lengths on paper.
const UNITS: [(&str, f64); 4] = [("mm", 1.0), ("cm", 10.0), ("in", 25.4), ("pt", 25.4 / 72.0)];

impl Length {
    /// In mm.
    pub fn mm(self) -> f64 {
        self.0
    }

    /// In points.
    pub fn points(self) -> f64 {
        self.0 * 72.0 / 25.4
    }
}

/// A length on paper, with its unit.
///
/// # Errors
/// What is wrong with it.
pub fn parse_length(text: &str) -> Result<Length, String> {
    let text = text.trim();
    let of_unit = |(unit, mm): (&str, f64)| {
        let number: f64 = text.strip_suffix(unit)?.trim().parse().ok()?;
        (number > 0.0 && number.is_finite()).then_some(Length(mm * number))
    };
    let length = UNITS.into_iter().find_map(of_unit);
    length.ok_or_else(|| format!("`{text}` is not a length in mm, cm, in or pt, such as 90mm"))
}

/// Both ends of an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisRange(pub [f64; 2]);

/// Both ends of an axis, the lower one first.
///
/// # Errors
/// What is wrong with them.
pub fn parse_range(text: &str) -> Result<AxisRange, String> {
    let ends = text.split_once("..").and_then(|(low, high)| {
        let end = |text: &str| {
            text.trim()
                .parse()
                .ok()
                .filter(|end: &f64| end.abs() < 1e12)
        };
        Some([end(low)?, end(high)?])
    });
    // An axis between numbers closer than this has no ticks.
    let is_range = |[low, high]: &[f64; 2]| {
        let largest = low.abs().max(high.abs());
        high - low > (1e-9 * largest).max(1e-30)
    };
    let range = ends.filter(is_range).map(AxisRange);
    range.ok_or_else(|| format!("`{text}` is not a range such as 0..60, the lower end first"))
}

/// A label of either motion.
///
/// # Errors
/// What is wrong with it.
pub fn parse_regime(name: &str) -> Result<Label, String> {
    let motions = Motion::ALL.into_iter();
    let known: Vec<Label> = motions.flat_map(Label::all).collect();
    let found = known.iter().find(|label| label.name() == name);
    found.copied().ok_or_else(|| {
        let names: Vec<&str> = known.iter().map(|label| label.name()).collect();
        format!("unknown regime `{name}`; known: {}", names.join(", "))
    })
}

/// One axis or two.
#[derive(Debug, Clone)]
pub struct AxesOfCells(pub Vec<Axis>);

/// One axis or two.
///
/// # Errors
/// What is wrong with it.
pub fn parse_axes(text: &str) -> Result<AxesOfCells, String> {
    // Values are not asked for: under its name in field units it is the same axis.
    let axis = |name: &str| match Axis::from_field_name(name.trim()) {
        Some((axis, _)) => Ok(axis),
        None => parse_axis(name),
    };
    let axes = text.split(',').map(axis).collect::<Result<Vec<_>, _>>()?;
    if axes.len() > 2 || (axes.len() == 2 && axes[0] == axes[1]) {
        return Err(format!("`{text}` is not one axis, or two"));
    }
    Ok(AxesOfCells(axes))
}

/// The width of an interval.
///
/// # Errors
/// What is wrong with it.
pub fn parse_width(text: &str) -> Result<f64, String> {
    let is_width = |width: &f64| (1e-5..1.0).contains(width);
    let width = text.parse().ok().filter(is_width);
    width.ok_or_else(|| format!("`{text}` is not a fraction between 0.00001 and 1"))
}

/// A multiple of the surface speed.
///
/// # Errors
/// What is wrong with it.
pub fn parse_order(text: &str) -> Result<f64, String> {
    let is_order = |order: &f64| (0.01..=1000.0).contains(order);
    let order = text.trim().parse().ok().filter(is_order);
    order.ok_or_else(|| format!("`{text}` is not a multiple from 0.01 to 1000"))
}

/// How hard a string is hit.
///
/// # Errors
/// What is wrong with it.
pub fn parse_strength(text: &str) -> Result<f64, String> {
    let is_strength = |strength: &f64| (1e-3..=1e6).contains(strength);
    let strength = text.trim().parse().ok().filter(is_strength);
    strength.ok_or_else(|| format!("`{text}` is not a number from 0.001 to 1000000"))
}

/// An axis by its name.
///
/// # Errors
/// What is wrong with it.
pub fn parse_axis(name: &str) -> Result<Axis, String> {
    axis_named(name.trim()).map_err(|error| error.to_string())
}

/// An axis with its value, in its unit or in another that its name tells.
///
/// # Errors
/// What is wrong with it.
pub fn parse_setting(text: &str) -> Result<(Axis, f64), String> {
    let (name, value) = text.split_once('=').ok_or("expected AXIS=VALUE")?;
    let (axis, factor) = axis_in_units(name.trim()).map_err(|error| error.to_string())?;
    let value = value.trim();
    let number: f64 = value
        .parse()
        .map_err(|_| format!("`{value}` is not a number"))?;
    Ok((axis, factor * number))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_length_is_the_same_in_every_unit() {
        for text in ["90mm", "9 cm", " 255.11811023622047pt"] {
            let length = parse_length(text).expect("a length").mm();
            assert!((length - 90.0).abs() < 1e-9, "{text}: {length}");
        }
        assert_eq!(parse_length("1in"), Ok(Length(25.4)));
        for text in ["90", "mm", "-9mm", "0mm", "9px", "infmm", "1e999mm", ""] {
            assert!(parse_length(text).is_err(), "{text}");
        }
    }

    #[test]
    fn a_range_goes_upwards() {
        assert_eq!(parse_range("-5 .. 0.5"), Ok(AxisRange([-5.0, 0.5])));
        for text in [
            "5..5",
            "6..5",
            "..5",
            "5",
            "0..inf",
            "nan..1",
            "1e11..1e11",
            "0..1e-310",
            "a..b",
        ] {
            assert!(parse_range(text).is_err(), "{text}");
        }
    }
}
