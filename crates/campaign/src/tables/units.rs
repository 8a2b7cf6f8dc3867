//! Units as people write them in the headings of columns.

use crate::quantities::{FOOT, INCH, POUND, POUND_FORCE};

/// Standard acceleration of free fall, by which a weight has a mass, m/s².
const GRAVITY: f64 = 9.806_65;

/// The foot of surveys in the United States, m.
const US_SURVEY_FOOT: f64 = 1200.0 / 3937.0;

/// What units measure. Numbers of a column become m, kg, kg/m, °, s, rpm and N m.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// m.
    Length,
    /// kg, or the weight in air of as much.
    Mass,
    /// kg/m.
    LinearMass,
    /// Degrees.
    Angle,
    /// s.
    Time,
    /// rpm.
    RotationSpeed,
    /// N m.
    Torque,
}

/// A unit: its names, the first as in messages and the others as [`plain`] has them; and what
/// numbers in it are multiplied by.
struct Unit {
    names: &'static [&'static str],
    dimension: Dimension,
    factor: f64,
}

const fn unit(dimension: Dimension, names: &'static [&'static str], factor: f64) -> Unit {
    Unit {
        names,
        dimension,
        factor,
    }
}

const UNITS: [Unit; 37] = [
    unit(
        Dimension::Length,
        &[
            "m", "meter", "meters", "metre", "metres", "mtr", "mtrs", "m_md", "mmd", "m_rkb",
            "mrkb", "m_kb", "mkb", "m_rt", "mrt", "m_bdf", "mbdf", "m_df", "mdf",
        ],
        1.0,
    ),
    unit(
        Dimension::Length,
        &[
            "ft", "foot", "feet", "ft_md", "ftmd", "ft_rkb", "ftrkb", "ft_kb", "ftkb", "ft_rt",
            "ftrt", "ft_bdf", "ftbdf", "ft_df", "ftdf", "int_ft", "ift",
        ],
        FOOT,
    ),
    unit(Dimension::Length, &["in", "inch", "inches", "ins"], INCH),
    unit(
        Dimension::Length,
        &[
            "mm",
            "millimeter",
            "millimeters",
            "millimetre",
            "millimetres",
        ],
        1e-3,
    ),
    unit(Dimension::Length, &["cm"], 1e-2),
    unit(
        Dimension::Mass,
        &["kg", "kgs", "kilogram", "kilograms", "kgf"],
        1.0,
    ),
    unit(
        Dimension::Mass,
        &["lb", "lbs", "lbm", "lbf", "lbsf", "pound", "pounds"],
        POUND,
    ),
    unit(
        Dimension::Mass,
        &[
            "klb", "klbs", "klbm", "klbf", "kip", "kips", "k_lbs", "k_lb", "k_lbf", "1000_lbs",
            "1000_lb", "1000_lbf",
        ],
        1e3 * POUND,
    ),
    unit(
        Dimension::Mass,
        &[
            "t",
            "te",
            "tonne",
            "tonnes",
            "mt",
            "ton_metric",
            "metric_ton",
            "metric_tons",
        ],
        1e3,
    ),
    unit(Dimension::Mass, &["N", "newton", "newtons"], 1.0 / GRAVITY),
    unit(
        Dimension::Mass,
        &["daN", "decanewton", "decanewtons"],
        10.0 / GRAVITY,
    ),
    unit(
        Dimension::Mass,
        &["kN", "kilonewton", "kilonewtons"],
        1e3 / GRAVITY,
    ),
    unit(
        Dimension::LinearMass,
        &[
            "kg/m",
            "kg_m",
            "kgs_per_m",
            "kgf_per_m",
            "kg_per_meter",
            "kg_per_metre",
        ],
        1.0,
    ),
    unit(
        Dimension::LinearMass,
        &[
            "lb/ft",
            "lb_ft",
            "lbs_per_ft",
            "lbs_ft",
            "lbm_per_ft",
            "lbf_per_ft",
            "lb_per_foot",
            "lbs_per_foot",
            "ppf",
            "lbpf",
        ],
        POUND / FOOT,
    ),
    unit(Dimension::LinearMass, &["N/m"], 1.0 / GRAVITY),
    unit(Dimension::LinearMass, &["kN/m"], 1e3 / GRAVITY),
    unit(Dimension::LinearMass, &["daN/m"], 10.0 / GRAVITY),
    unit(
        Dimension::Angle,
        &["deg", "degs", "degree", "degrees", "dega", "dd"],
        1.0,
    ),
    unit(
        Dimension::Angle,
        &["rad", "rads", "radian", "radians"],
        180.0 / std::f64::consts::PI,
    ),
    unit(
        Dimension::Time,
        &["s", "sec", "secs", "second", "seconds"],
        1.0,
    ),
    unit(
        Dimension::Time,
        &["ms", "msec", "millisecond", "milliseconds"],
        1e-3,
    ),
    unit(Dimension::Time, &["min", "mins", "minute", "minutes"], 60.0),
    unit(
        Dimension::Time,
        &["h", "hr", "hrs", "hour", "hours"],
        3600.0,
    ),
    unit(
        Dimension::RotationSpeed,
        &[
            "rpm",
            "r_per_min",
            "rev_per_min",
            "revs_per_min",
            "r_p_m",
            "1_per_min",
        ],
        1.0,
    ),
    unit(
        Dimension::RotationSpeed,
        &["rad/s", "rad_s", "rads_per_s", "rad_per_sec"],
        60.0 / std::f64::consts::TAU,
    ),
    unit(
        Dimension::RotationSpeed,
        &["rps", "rev_per_s", "r_per_s", "rev_per_sec"],
        60.0,
    ),
    unit(Dimension::RotationSpeed, &["deg/s", "deg_s"], 1.0 / 6.0),
    unit(Dimension::Torque, &["N m", "nm"], 1.0),
    unit(Dimension::Torque, &["daN m", "danm"], 10.0),
    unit(Dimension::Torque, &["kN m", "knm"], 1e3),
    unit(
        Dimension::Torque,
        &[
            "lbf ft", "ft_lbf", "ft_lb", "ft_lbs", "lb_ft", "lbs_ft", "ftlbf", "ftlb", "ftlbs",
            "lbft", "lbfft",
        ],
        POUND_FORCE * FOOT,
    ),
    unit(
        Dimension::Torque,
        &[
            "klbf ft",
            "kft_lbf",
            "kft_lb",
            "kft_lbs",
            "k_ft_lbf",
            "k_ft_lb",
            "k_ft_lbs",
            "klb_ft",
            "klbs_ft",
            "kftlb",
            "kftlbs",
            "kftlbf",
            "ft_kip",
            "ft_kips",
            "kip_ft",
            "ft_klb",
            "ft_klbf",
            "ft_klbs",
            "1000_ft_lbs",
            "1000_ft_lb",
            "1000_ft_lbf",
        ],
        1e3 * POUND_FORCE * FOOT,
    ),
    unit(Dimension::Torque, &["kgf m", "kgm", "kg_m"], GRAVITY),
    unit(
        Dimension::Torque,
        &["in lbf", "in_lb", "in_lbs", "lbf_in", "lb_in"],
        POUND_FORCE * INCH,
    ),
    unit(
        Dimension::LinearMass,
        &[
            "klbf/ft",
            "klb_per_ft",
            "klbf_per_ft",
            "kip_per_ft",
            "kips_per_ft",
        ],
        1e3 * POUND / FOOT,
    ),
    unit(Dimension::Length, &["km"], 1e3),
    unit(
        Dimension::Length,
        &[
            "US ft",
            "usft",
            "ftus",
            "ft_us",
            "us_feet",
            "us_survey_ft",
            "us_survey_feet",
            "sft",
        ],
        US_SURVEY_FOOT,
    ),
];

impl Unit {
    fn is_called(&self, name: &str) -> bool {
        self.names.contains(&name) || plain(self.names[0]) == name
    }
}

impl Dimension {
    /// What numbers in a unit of it are multiplied by, by the [`plain`] name of that.
    pub fn factor(self, name: &str) -> Option<f64> {
        let mut units = UNITS.iter().filter(|unit| unit.dimension == self);
        units
            .find(|unit| unit.is_called(name))
            .map(|unit| unit.factor)
    }

    /// The units that are known, as a person writes them.
    pub fn units(self) -> String {
        let units = UNITS.iter().filter(|unit| unit.dimension == self);
        let names: Vec<&str> = units.map(|unit| unit.names[0]).collect();
        names.join(", ")
    }
}

/// Whether a text is the name of a unit, of any dimension.
pub fn is_unit(name: &str) -> bool {
    UNITS.iter().any(|unit| unit.is_called(name))
}

/// A unit or a name in small letters and digits, with `_` between its words and `_per_` for `/`.
pub fn plain(text: &str) -> String {
    let mut plain = String::new();
    for letter in text.trim().trim_end_matches('.').chars() {
        match letter {
            '°' | 'º' | '˚' => plain.push_str("deg"),
            '"' | '″' | '”' => plain.push_str("in"),
            '\'' | '′' | '’' => plain.push_str("ft"),
            '#' => plain.push_str("lb"),
            '/' => plain.push_str("_per_"),
            letter if letter.is_alphanumeric() => plain.extend(letter.to_lowercase()),
            _ => plain.push('_'),
        }
    }
    let words: Vec<&str> = plain.split('_').filter(|word| !word.is_empty()).collect();
    words.join("_")
}
