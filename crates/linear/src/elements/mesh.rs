//! The string divided into elements, with a node at every change of tube that is not next to another
//! node, and at every site; in bending from where it is held down.

use crate::channel::Channel;
use crate::drillstring::{Drillstring, Section, Tube};
use crate::error::BuildError;
use crate::sites::Sites;
use crate::spans::SurroundedSpan;
use crate::surroundings::Surroundings;

/// The most elements: 16 million, some gigabytes with their matrices.
const MOST_ELEMENTS: usize = 1 << 24;

/// A shorter piece of a tube, m, is one with its neighbour, but between two sites. An element is the stiffer
/// in bending by the cube of how short it is: of one much shorter, rounding alone would outweigh what
/// holds the string.
const SHORTEST_PIECE: f64 = 2e-3;

/// That is at most this part of the longest element.
const SHORTEST_PART: f64 = 1e-2;

/// Elements from the surface down, or from where the string is held in bending; node 0 is that end,
/// node i + 1 the bottom of element i.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Each element as the piece of tube it covers.
    pub elements: Vec<Tube>,
    /// What is around each, in bending.
    pub(crate) around: Vec<Surroundings>,
    /// The node of each site, from the surface down.
    pub site_nodes: Vec<usize>,
    /// Depth of node 0 below the surface, m.
    top: f64,
}

impl Mesh {
    /// Divides the string into elements so short that one cell of the
    /// drillpipe (a pipe and its joint) has `elements_per_cell` of them; every
    /// tube has at least one.
    ///
    /// # Errors
    /// Where the sites are not the string's, or the elements would be too many.
    pub fn new(
        string: &Drillstring,
        channel: Channel,
        sites: &Sites,
        elements_per_cell: usize,
    ) -> Result<Self, BuildError> {
        if elements_per_cell == 0 {
            return Err(BuildError::Parameter {
                name: "elements_per_cell",
                value: 0.0,
                expected: "at least 1",
            });
        }
        let (mut elements, mut around) = (Vec::new(), Vec::new());
        let mut site_nodes = Vec::with_capacity(sites.len());
        let longest = longest_element(string, elements_per_cell);
        let spans = string.surrounded_spans(channel, sites)?;
        check_number(&spans, longest)?;
        for span in spans {
            for (tube, surroundings) in pieces(&span, longest) {
                let (count, element) = divided(&tube, longest);
                elements.extend(std::iter::repeat_n(element, count));
                around.resize(elements.len(), surroundings);
            }
            if site_nodes.len() < sites.len() {
                site_nodes.push(elements.len());
            }
        }
        Ok(Self {
            elements,
            around,
            site_nodes,
            top: string.length() - length_in(string, channel),
        })
    }

    /// Depth of every node below the surface, m.
    pub fn depths(&self) -> Vec<f64> {
        let below = self.elements.iter().scan(self.top, |depth, element| {
            *depth += element.length;
            Some(*depth)
        });
        std::iter::once(self.top).chain(below).collect()
    }

    /// The elements with what is around each.
    pub(crate) fn elements_around(&self) -> impl Iterator<Item = (&Tube, &Surroundings)> {
        self.elements.iter().zip(&self.around)
    }

    /// Number of nodes, the upper end included.
    pub fn nodes(&self) -> usize {
        self.elements.len() + 1
    }
}

/// Elements of a mesh, at most: every site may cut one in two, and so may what is around
/// the string.
pub(crate) fn most_elements(
    string: &Drillstring,
    channel: Channel,
    sites: &Sites,
    elements_per_cell: usize,
) -> f64 {
    let longest = longest_element(string, elements_per_cell);
    let mut left = length_in(string, channel);
    let of_section = |section: &Section| {
        let cells = (left / section.cell_length()).ceil();
        left -= section.length();
        let of_cell: f64 = (section.parts.iter())
            .map(|tube| elements_of(tube, longest))
            .sum();
        cells.clamp(0.0, section.repeat as f64) * of_cell
    };
    let whole: f64 = string.sections().iter().rev().map(of_section).sum();
    whole + (sites.len() + string.surroundings().len()) as f64
}

/// Length of what moves of a string, down to its bit, m.
fn length_in(string: &Drillstring, channel: Channel) -> f64 {
    match channel {
        Channel::Torsion | Channel::Axial => string.length(),
        Channel::Bending => string.bending_length(),
    }
}

/// Refuses more elements than are made; what is no number of them too.
pub(super) fn check_number(spans: &[SurroundedSpan], longest: f64) -> Result<(), BuildError> {
    let runs = spans.iter().flatten().flat_map(|part| &part.runs);
    let elements: f64 = runs
        .map(|run| {
            let of_cell: f64 = run
                .parts
                .iter()
                .map(|part| elements_of(part, longest))
                .sum();
            run.repeat as f64 * of_cell
        })
        .sum();
    if elements <= MOST_ELEMENTS as f64 {
        return Ok(());
    }
    Err(BuildError::TooManyElements {
        elements,
        most: MOST_ELEMENTS,
    })
}

/// The length (m) that no element of a string is longer than.
pub(super) fn longest_element(string: &Drillstring, elements_per_cell: usize) -> f64 {
    string.drillpipe().cell_length() / elements_per_cell as f64
}

/// The tubes of a span with what is around each. What is very short is one with its neighbour: the
/// ends of parts are not known so well, the sites stay where they are.
fn pieces(span: &SurroundedSpan, longest: f64) -> Vec<(Tube, Surroundings)> {
    let shortest = SHORTEST_PIECE.min(SHORTEST_PART * longest);
    let mut pieces: Vec<(Tube, Surroundings)> = Vec::new();
    for part in span {
        let tubes = part.runs.iter().flat_map(|run| {
            let cells = std::iter::repeat_n(&run.parts, run.repeat);
            cells.flatten()
        });
        for tube in tubes {
            match pieces.last_mut() {
                Some((above, _)) if tube.length < shortest => above.length += tube.length,
                Some(above) if above.0.length < shortest => {
                    let length = above.0.length + tube.length;
                    *above = (Tube { length, ..*tube }, part.around);
                }
                _ => pieces.push((*tube, part.around)),
            }
        }
    }
    pieces
}

/// Equal elements of a tube, no longer than `longest`, up to rounding.
fn elements_of(tube: &Tube, longest: f64) -> f64 {
    (tube.length / longest - 1e-6).ceil().max(1.0)
}

/// A tube as a number of equal elements.
pub(super) fn divided(tube: &Tube, longest: f64) -> (usize, Tube) {
    let count = elements_of(tube, longest);
    let element = Tube {
        length: tube.length / count,
        ..*tube
    };
    (count as usize, element)
}
