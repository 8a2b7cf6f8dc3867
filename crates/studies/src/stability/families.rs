//! Which cells the atlas has.

use clap::ValueEnum;
use linear::Method;
use linear::method::{FiniteElement, Transform};

use campaign::accuracy::methods::{Parameters, hilbert};

/// A part of the atlas.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Family {
    /// The digital filter in sticking: sampling frequency and length of transform
    Hilbert,
    /// The plain inverse transform in sticking: the same
    DirectIdft,
    /// Newmark's scheme in sticking: γ and sampling frequency
    Newmark,
    /// Both formulas of convolution quadrature, and held loads, in sticking
    Formulas,
    /// Strings from one section of drillpipe to 2000
    Sections,
    /// Backward whirl against walls from soft to rigid
    Stiffness,
    /// Two sites of contact, from far apart to closer than a sample's travel
    Sites,
    /// A million steps of sticking
    LongSticking,
    /// A million steps of whirl
    LongWhirl,
    /// The digital filter in bending: how much of the displacement it loses
    Tail,
    /// The limit of stick-slip on jointed pipe with collars, lightly damped
    Joints,
}

impl Family {
    /// All parts, in the order of the table.
    pub fn all() -> &'static [Family] {
        Self::value_variants()
    }

    /// The name in the table and on the command line.
    pub fn name(self) -> String {
        let value = self.to_possible_value();
        value.map_or_else(String::new, |value| value.get_name().to_owned())
    }
}

/// How the string's response is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Approach {
    /// By a linear method.
    Method(Method),
    /// Frequency responses by products of transfer matrices.
    TransferProducts,
    /// Frequency responses by joined stiffnesses.
    JoinedStiffnesses,
}

impl Approach {
    /// The name in the table.
    pub fn name(self) -> &'static str {
        match self {
            Approach::Method(method) => method.name(),
            Approach::TransferProducts => "transfer-products",
            Approach::JoinedStiffnesses => "joined-stiffnesses",
        }
    }
}

/// One setting of one method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cell {
    /// The part of the atlas it belongs to.
    pub family: Family,
    /// How the response is found.
    pub approach: Approach,
    /// Sampling frequency, Hz.
    pub sampling_frequency: f64,
    /// Contact stiffness, N/m^(3/2), where there is a wall.
    pub stiffness: Option<f64>,
    /// Distance between two sites, m, where there are two.
    pub site_spacing: Option<f64>,
    /// Sections of drillpipe, where they are not the paper's 90.
    pub sections: Option<usize>,
    /// Steps simulated, where they are not the scene's own.
    pub steps: Option<usize>,
}

impl Cell {
    /// The parameters of its method.
    pub fn parameters(&self) -> Parameters {
        match self.approach {
            Approach::Method(method) => Parameters::of(&method),
            _ => Parameters::default(),
        }
    }

    /// The method, with its parameter where that is not the usual one.
    pub fn method_name(&self) -> String {
        let (name, parameters) = (self.approach.name(), self.parameters());
        match (parameters.transform_s, parameters.gamma) {
            (Some(seconds), _) => format!("{name}, {seconds} s"),
            (None, Some(gamma)) => format!("{name}, γ = {gamma}"),
            (None, None) => name.to_owned(),
        }
    }

    /// Whether another cell, its neighbour, has the same linear responses: only
    /// its wall differs.
    pub fn shares_responses(&self, other: &Cell) -> bool {
        let with_its_wall = Cell {
            stiffness: self.stiffness,
            ..*other
        };
        *self == with_its_wall
    }
}

const SAMPLING_FREQUENCIES: [f64; 5] = [160.0, 320.0, 640.0, 1280.0, 2560.0];
const JOINTS_FREQUENCIES: [f64; 7] = [160.0, 320.0, 640.0, 1280.0, 2560.0, 5120.0, 10_240.0];
const TRANSFORMS: [f64; 9] = [2.0, 3.0, 4.0, 6.0, 8.0, 10.0, 14.0, 20.0, 40.0];
const GAMMAS: [f64; 10] = [0.5, 0.502, 0.505, 0.51, 0.515, 0.52, 0.54, 0.56, 0.58, 0.6];
const STIFFNESSES: [f64; 8] = [1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, f64::INFINITY];
const SPACINGS: [f64; 10] = [10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01];
const SECTIONS: [usize; 8] = [1, 3, 10, 30, 100, 300, 1000, 2000];
const TAIL_TRANSFORMS: [f64; 6] = [10.0, 20.0, 40.0, 80.0, 160.0, 320.0];

/// Finite elements of longer strings take minutes.
const MOST_SECTIONS_OF_ELEMENTS: usize = 300;

/// Of the paper's string, Hz.
const USUAL_FREQUENCY: f64 = 640.0;

/// Wall of Fig. 12, N/m^(3/2).
const USUAL_STIFFNESS: f64 = 1e9;

const MILLION: usize = 1_000_000;

fn elements(gamma: f64) -> Method {
    Method::FiniteElement(FiniteElement {
        gamma,
        ..FiniteElement::default()
    })
}

/// Good and failing ones, at a sampling frequency and transform that suits the
/// paper's string.
fn all_methods() -> [Method; 8] {
    [
        Method::Quadrature,
        Method::Held,
        Method::Hilbert(Transform::default()),
        elements(0.52),
        Method::Trapezoidal,
        hilbert(4.0),
        elements(0.5),
        Method::DirectIdft(Transform::default()),
    ]
}

/// Finite elements that are not damped ring for the whole of a million steps, and
/// take minutes to build: the trapezoidal rule stands for them.
fn long_methods() -> impl Iterator<Item = Method> {
    all_methods()
        .into_iter()
        .filter(|method| *method != elements(0.5))
}

/// The cells of a part of the atlas: each of its methods, with each setting that strains
/// it.
pub fn cells(family: Family) -> Vec<Cell> {
    let direct = |seconds| {
        let seconds = Some(seconds);
        Method::DirectIdft(Transform { seconds })
    };
    let methods = match family {
        Family::Sections => return sections(),
        Family::Hilbert => TRANSFORMS.map(hilbert).to_vec(),
        Family::DirectIdft => TRANSFORMS.map(direct).to_vec(),
        Family::Newmark => GAMMAS.map(elements).to_vec(),
        Family::Formulas => vec![Method::Quadrature, Method::Held, Method::Trapezoidal],
        Family::Stiffness | Family::Sites => all_methods().to_vec(),
        Family::Joints => vec![
            Method::Held,
            Method::Quadrature,
            Method::Hilbert(Transform::default()),
            elements(0.52),
        ],
        Family::LongSticking | Family::LongWhirl => long_methods().collect(),
        Family::Tail => (TAIL_TRANSFORMS.map(hilbert).into_iter())
            .chain([elements(0.52), Method::Held])
            .collect(),
    };
    (methods.into_iter())
        .flat_map(|method| strained(usual(family, Approach::Method(method))))
        .collect()
}

fn usual(family: Family, approach: Approach) -> Cell {
    Cell {
        family,
        approach,
        sampling_frequency: USUAL_FREQUENCY,
        stiffness: None,
        site_spacing: None,
        sections: None,
        steps: None,
    }
}

/// A cell in the settings of its family, one after the other.
fn strained(cell: Cell) -> Vec<Cell> {
    let at_frequency = |sampling_frequency| Cell {
        sampling_frequency,
        ..cell
    };
    let against = |stiffness| Cell {
        stiffness: Some(stiffness),
        ..cell
    };
    let apart = |site_spacing| Cell {
        site_spacing: Some(site_spacing),
        ..against(USUAL_STIFFNESS)
    };
    let long = |cell| Cell {
        steps: Some(MILLION),
        ..cell
    };
    match cell.family {
        Family::Stiffness => STIFFNESSES.map(against).to_vec(),
        Family::Sites => SPACINGS.map(apart).to_vec(),
        Family::LongSticking => vec![long(cell)],
        Family::LongWhirl => vec![long(against(USUAL_STIFFNESS))],
        Family::Sections | Family::Tail => vec![cell],
        Family::Joints => JOINTS_FREQUENCIES.map(at_frequency).to_vec(),
        _ => SAMPLING_FREQUENCIES.map(at_frequency).to_vec(),
    }
}

/// Every approach to strings of ever more sections.
fn sections() -> Vec<Cell> {
    let methods = [
        Method::Quadrature,
        Method::Held,
        Method::Hilbert(Transform::default()),
        elements(0.52),
        Method::Trapezoidal,
        Method::DirectIdft(Transform::default()),
    ];
    let approaches = (methods.into_iter().map(Approach::Method))
        .chain([Approach::JoinedStiffnesses, Approach::TransferProducts]);
    approaches
        .flat_map(|approach| SECTIONS.map(|sections| (approach, sections)))
        .filter(|(approach, sections)| {
            let by_elements = matches!(approach, Approach::Method(Method::FiniteElement(_)));
            !by_elements || *sections <= MOST_SECTIONS_OF_ELEMENTS
        })
        .map(|(approach, sections)| Cell {
            sections: Some(sections),
            ..usual(Family::Sections, approach)
        })
        .collect()
}
