//! Which cells the atlas has.

use clap::ValueEnum;
use linear::Method;
use linear::method::{FiniteElement, Transform};

/// A part of the atlas.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Family {
    /// The digital filter in sticking: sampling frequency and length of transform
    Hilbert,
    /// The plain inverse transform in sticking: the same
    DirectIdft,
    /// Newmark's scheme in sticking: γ and sampling frequency
    Newmark,
    /// Both formulas of convolution quadrature in sticking
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
}

impl Family {
    /// All parts, in the order of the table.
    pub fn all() -> &'static [Family] {
        Self::value_variants()
    }

    /// The name in the table and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Family::Hilbert => "hilbert",
            Family::DirectIdft => "direct-idft",
            Family::Newmark => "newmark",
            Family::Formulas => "formulas",
            Family::Sections => "sections",
            Family::Stiffness => "stiffness",
            Family::Sites => "sites",
            Family::LongSticking => "long-sticking",
            Family::LongWhirl => "long-whirl",
            Family::Tail => "tail",
        }
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

fn hilbert(seconds: f64) -> Method {
    Method::Hilbert(Transform {
        seconds: Some(seconds),
    })
}

fn elements(gamma: f64) -> Method {
    Method::FiniteElement(FiniteElement {
        gamma,
        ..FiniteElement::default()
    })
}

/// Good and failing ones, at a sampling frequency and transform that suits the
/// paper's string.
fn all_methods() -> [Method; 7] {
    [
        Method::Quadrature,
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

/// The cells of a part of the atlas.
pub fn cells(family: Family) -> Vec<Cell> {
    let usual = |method: Method| Cell {
        family,
        approach: Approach::Method(method),
        sampling_frequency: USUAL_FREQUENCY,
        stiffness: None,
        site_spacing: None,
        sections: None,
        steps: None,
    };
    let at_frequencies = |methods: Vec<Method>| -> Vec<Cell> {
        let pairs = (methods.into_iter())
            .flat_map(|method| SAMPLING_FREQUENCIES.map(|frequency| (method, frequency)));
        pairs
            .map(|(method, sampling_frequency)| Cell {
                sampling_frequency,
                ..usual(method)
            })
            .collect()
    };
    match family {
        Family::Hilbert => at_frequencies(TRANSFORMS.map(hilbert).to_vec()),
        Family::DirectIdft => at_frequencies(
            TRANSFORMS
                .map(|seconds| {
                    Method::DirectIdft(Transform {
                        seconds: Some(seconds),
                    })
                })
                .to_vec(),
        ),
        Family::Newmark => at_frequencies(GAMMAS.map(elements).to_vec()),
        Family::Formulas => at_frequencies(vec![Method::Quadrature, Method::Trapezoidal]),
        Family::Sections => sections(usual),
        Family::Stiffness => (all_methods().into_iter())
            .flat_map(|method| STIFFNESSES.map(|stiffness| (method, stiffness)))
            .map(|(method, stiffness)| Cell {
                stiffness: Some(stiffness),
                ..usual(method)
            })
            .collect(),
        Family::Sites => (all_methods().into_iter())
            .flat_map(|method| SPACINGS.map(|spacing| (method, spacing)))
            .map(|(method, spacing)| Cell {
                stiffness: Some(USUAL_STIFFNESS),
                site_spacing: Some(spacing),
                ..usual(method)
            })
            .collect(),
        Family::LongSticking => long_methods()
            .map(|method| Cell {
                steps: Some(MILLION),
                ..usual(method)
            })
            .collect(),
        Family::LongWhirl => long_methods()
            .map(|method| Cell {
                stiffness: Some(USUAL_STIFFNESS),
                steps: Some(MILLION),
                ..usual(method)
            })
            .collect(),
        Family::Tail => (TAIL_TRANSFORMS.into_iter())
            .map(hilbert)
            .chain([elements(0.52)])
            .map(usual)
            .collect(),
    }
}

fn sections(usual: impl Fn(Method) -> Cell) -> Vec<Cell> {
    let methods = [
        Method::Quadrature,
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
            approach,
            sections: Some(sections),
            ..usual(Method::Quadrature)
        })
        .collect()
}
