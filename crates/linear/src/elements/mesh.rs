//! The string divided into elements, with a node at every change of tube and
//! at every site.

use crate::drillstring::{Drillstring, Sites, Tube};

/// Elements from the surface down; node 0 is the surface, node i + 1 the
/// bottom of element i.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Each element as the piece of tube it covers.
    pub elements: Vec<Tube>,
    /// The node of each site, from the surface down.
    pub site_nodes: Vec<usize>,
}

impl Mesh {
    /// Divides the string into elements so short that one cell of the
    /// drillpipe (a pipe and its joint) has `elements_per_cell` of them; every
    /// tube has at least one.
    pub fn new(string: &Drillstring, sites: &Sites, elements_per_cell: usize) -> Self {
        let mut elements = Vec::new();
        let mut site_nodes = Vec::with_capacity(sites.len());
        let longest = string.drillpipe().cell_length() / elements_per_cell as f64;
        for span in string.spans(sites) {
            for run in &span.runs {
                for _ in 0..run.repeat {
                    for part in &run.parts {
                        divide(part, longest, &mut elements);
                    }
                }
            }
            if site_nodes.len() < sites.len() {
                site_nodes.push(elements.len());
            }
        }
        Self {
            elements,
            site_nodes,
        }
    }

    /// Depth of every node below the surface, m.
    pub fn depths(&self) -> Vec<f64> {
        let below = self.elements.iter().scan(0.0, |depth, element| {
            *depth += element.length;
            Some(*depth)
        });
        std::iter::once(0.0).chain(below).collect()
    }

    /// Number of nodes, the surface included.
    pub fn nodes(&self) -> usize {
        self.elements.len() + 1
    }
}

/// Equal elements no longer than `longest`, up to rounding.
fn divide(tube: &Tube, longest: f64, elements: &mut Vec<Tube>) {
    let count = (tube.length / longest - 1e-6).ceil().max(1.0);
    let element = Tube {
        length: tube.length / count,
        ..*tube
    };
    elements.extend(std::iter::repeat_n(element, count as usize));
}
