//! Strings in wells, drawn at random: the same for the same number.

use linear::well::{Station, Survey};
use linear::{Drillstring, Hole, HoleSection, Mud, Section, Tube, estimates};

use crate::pipes::STEEL;

/// A string in its well.
#[derive(Debug, Clone)]
pub struct Well {
    /// Uniform, of jointed pipe, or with collars.
    pub string: Drillstring,
    /// Nearly vertical, built to a slope, or to the horizontal; to the bit.
    pub survey: Survey,
}

/// Numbers drawn one after another (G. L. Steele, D. Lea and C. H. Flood, "Fast splittable
/// pseudorandom number generators", *OOPSLA* 2014, 453–472).
#[derive(Debug, Clone)]
pub struct Draw(u64);

impl Draw {
    /// The numbers of a number.
    pub fn new(number: usize) -> Self {
        Self(number as u64)
    }

    /// Uniform between two.
    pub fn uniform(&mut self, from: f64, to: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let fraction = ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1u64 << 53) as f64;
        from + fraction * (to - from)
    }

    /// With a uniform logarithm.
    pub fn log_uniform(&mut self, from: f64, to: f64) -> f64 {
        self.uniform(from.ln(), to.ln()).exp()
    }
}

impl Well {
    /// One of 100 m to 5 km: nine in a row have each string in each well.
    pub fn draw(number: usize, draw: &mut Draw) -> Self {
        let length = draw.log_uniform(100.0, 5000.0);
        let sections = sections(number % 3, length, draw);
        let loss = draw.log_uniform(0.03, 0.7);
        let with = |damping: f64| Drillstring::new(STEEL, sections.clone(), damping);
        // What damping of one takes of a wave that goes through.
        let of_one = with(1.0).map(|string| -estimates::torsional_wave_left(&string).ln());
        let string = of_one.and_then(|of_one| with(loss / of_one));
        let string = string.expect("such sections are a string");
        let survey = survey(number / 3 % 3, string.length(), draw);
        Self { string, survey }
    }
}

/// The same string in a narrow or a wide hole with thin or thick mud, of a material that loses energy.
pub fn with_loss(string: &Drillstring, draw: &mut Draw) -> Drillstring {
    let tubes = string.sections().iter().flat_map(|section| &section.parts);
    let widest = tubes.fold(0.0, |widest: f64, tube| widest.max(tube.outer_radius));
    let hole = Hole {
        sections: vec![HoleSection {
            length: string.length(),
            radius: widest * draw.log_uniform(1.05, 3.0),
        }],
        mud: Mud {
            density: draw.uniform(1000.0, 2000.0),
            viscosity: draw.log_uniform(1e-3, 0.1),
        },
    };
    let loss_factor = draw.log_uniform(1e-4, 0.02);
    let in_mud = string.clone().in_hole(hole);
    let lossy = in_mud.and_then(|string| string.with_loss_factor(loss_factor));
    lossy.expect("the hole is wider than the string")
}

fn sections(shape: usize, length: f64, draw: &mut Draw) -> Vec<Section> {
    let outer_radius = draw.uniform(0.04, 0.085);
    let pipe = Tube {
        length: 9.0,
        inner_radius: outer_radius - draw.uniform(0.008, 0.013),
        outer_radius,
    };
    let joint = Tube {
        length: 0.5,
        outer_radius: outer_radius * draw.uniform(1.15, 1.4),
        ..pipe
    };
    let cells = |parts: Vec<Tube>, length: f64| {
        let cell: f64 = parts.iter().map(|part| part.length).sum();
        Section {
            repeat: (length / cell).round().max(1.0) as usize,
            parts,
        }
    };
    match shape {
        0 => vec![cells(vec![pipe], length)],
        1 => vec![cells(vec![pipe, joint], length)],
        _ => {
            let part = draw.uniform(0.03, 0.25);
            let collar = Tube {
                outer_radius: outer_radius * draw.uniform(1.3, 1.7),
                ..pipe
            };
            vec![
                cells(vec![pipe, joint], (1.0 - part) * length),
                cells(vec![collar], part * length),
            ]
        }
    }
}

fn survey(course: usize, length: f64, draw: &mut Draw) -> Survey {
    let station = |part: f64, inclination: f64, azimuth: f64| Station {
        measured_depth: part * length,
        inclination: f64::to_radians(inclination),
        azimuth: f64::to_radians(azimuth),
    };
    let stations = if course == 0 {
        // As well as one drills straight.
        let count = (length / 100.0).clamp(2.0, 20.0) as usize;
        let at = |index: usize| {
            let (inclination, azimuth) = (draw.uniform(0.2, 3.0), draw.uniform(0.0, 360.0));
            station(index as f64 / count as f64, inclination, azimuth)
        };
        (0..=count).map(at).collect()
    } else {
        let (kick_off, built) = (draw.uniform(0.05, 0.4), draw.uniform(0.45, 0.8));
        let slope = if course == 1 {
            draw.uniform(20.0, 70.0)
        } else {
            90.0
        };
        vec![
            station(0.0, 0.0, 30.0),
            station(kick_off, 0.0, 30.0),
            station(built, slope, draw.uniform(0.0, 60.0)),
            station(1.0, slope, 30.0),
        ]
    };
    Survey::new(stations).expect("such stations are a survey")
}
