//! The string cut at its sites: what the waves and the elements join or assemble between
//! two neighbouring nodes.

use crate::channel::Channel;
use crate::drillstring::{Drillstring, SAME_PLACE, Section, Tube};
use crate::error::DrillstringError;
use crate::sites::Sites;
use crate::surroundings::{Stretch, Surroundings};

/// The string between two neighbouring nodes, from the top down.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Span {
    pub(crate) runs: Vec<Section>,
}

/// A part of a span with the same around it, from the top down.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Surrounded {
    pub(crate) around: Surroundings,
    pub(crate) runs: Vec<Section>,
}

/// A span by its parts with the same around each, from the top down.
pub(crate) type SurroundedSpan = Vec<Surrounded>;

impl Drillstring {
    /// The spans, in bending cut where what is around the string changes, and without what is held
    /// above; in torsion what is around matters only where mud is viscous, and then the hole alone.
    pub(crate) fn surrounded_spans(
        &self,
        channel: Channel,
        sites: &Sites,
    ) -> Result<Vec<SurroundedSpan>, DrillstringError> {
        let mut spans = self.spans(sites)?;
        let mut stretches = match channel {
            Channel::Torsion | Channel::Axial => self.mud_around(),
            Channel::Bending => self.surroundings(),
        };
        if channel == Channel::Bending {
            self.leave_out_what_is_held(sites, (&mut spans, &mut stretches))?;
        }
        let spans = spans.into_iter();
        let last = stretches.pop().map(|last| last.around).unwrap_or_default();
        if stretches.is_empty() {
            let whole = |Span { runs }| vec![Surrounded { around: last, runs }];
            return Ok(spans.map(whole).collect());
        }
        // The last extends to the end, also after rounding.
        stretches.push(Stretch {
            length: f64::INFINITY,
            around: last,
        });
        let same_place = SAME_PLACE * self.length();
        let mut stretches = stretches.into_iter().peekable();
        let mut cut = |Span { mut runs }: Span| {
            let mut left: f64 = runs.iter().map(Section::length).sum();
            runs.reverse();
            let mut parts = Vec::new();
            while left > same_place {
                let Some(stretch) = stretches.peek_mut() else {
                    break;
                };
                let (around, length) = (stretch.around, stretch.length.min(left));
                let Span { runs } = cut_off_top(&mut runs, length, same_place);
                parts.push(Surrounded { around, runs });
                left -= length;
                stretch.length -= length;
                if stretch.length <= same_place {
                    stretches.next();
                }
            }
            parts
        };
        Ok(spans.map(&mut cut).collect())
    }

    /// Leaves out what is held sideways: the top of the uppermost span, and what is around it.
    fn leave_out_what_is_held(
        &self,
        sites: &Sites,
        (spans, stretches): (&mut [Span], &mut Vec<Stretch>),
    ) -> Result<(), DrillstringError> {
        let (bends, same_place) = (self.bending_length(), self.same_place());
        let depth = self.length() - bends;
        if depth <= same_place {
            return Ok(());
        }
        let distance = sites.distances_from_bit()[0];
        if distance > bends - same_place {
            return Err(DrillstringError::SiteHeld { distance, bends });
        }
        let runs = &mut spans[0].runs;
        runs.reverse();
        cut_off_top(runs, depth, same_place);
        runs.reverse();
        let mut left = depth;
        stretches.retain_mut(|stretch| {
            let held = stretch.length.min(left);
            left -= held;
            stretch.length -= held;
            stretch.length > same_place
        });
        Ok(())
    }

    /// The string cut at the sites: one span above each site, and one more
    /// below the last where that is not the bit. Sites of another string may not
    /// be places of this one.
    pub(crate) fn spans(&self, sites: &Sites) -> Result<Vec<Span>, DrillstringError> {
        sites.check(self)?;
        let mut below: Vec<Section> = self.sections().iter().rev().cloned().collect();
        let mut depth = 0.0;
        let mut spans: Vec<Span> = Vec::with_capacity(sites.len() + 1);
        for site in sites.depths(self) {
            spans.push(cut_off_top(
                &mut below,
                site - depth,
                SAME_PLACE * self.length(),
            ));
            depth = site;
        }
        if sites.bit_site().is_some() {
            // Rounding may have left a sliver; the bit ends the string.
            let left: f64 = below.iter().map(Section::length).sum();
            debug_assert!(left <= sites.len() as f64 * SAME_PLACE * self.length());
        } else {
            below.reverse();
            spans.push(Span { runs: below });
        }
        Ok(spans)
    }
}

/// Takes `length` metres off the top of a string held upside down (its top
/// section last, where it is cheap to take).
fn cut_off_top(upside_down: &mut Vec<Section>, length: f64, same_place: f64) -> Span {
    let mut runs = Vec::new();
    let mut left = length;
    while left > same_place {
        let Some(section) = upside_down.pop() else {
            break;
        };
        let cell = section.cell_length();
        let whole = (((left + same_place) / cell).floor() as usize).min(section.repeat);
        let Section { repeat, parts } = section;
        if whole == 0 {
            let (above, beneath) = cut_cell(&parts, left, same_place);
            push_cells(upside_down, repeat - 1, parts);
            push_cells(upside_down, 1, beneath);
            push_cells(&mut runs, 1, above);
            break;
        }
        push_cells(upside_down, repeat - whole, parts.clone());
        push_cells(&mut runs, whole, parts);
        left -= whole as f64 * cell;
    }
    Span { runs }
}

fn push_cells(runs: &mut Vec<Section>, repeat: usize, parts: Vec<Tube>) {
    if repeat > 0 && !parts.is_empty() {
        runs.push(Section { repeat, parts });
    }
}

/// One cell cut `length` metres below its top, without slivers.
fn cut_cell(parts: &[Tube], length: f64, same_place: f64) -> (Vec<Tube>, Vec<Tube>) {
    let (mut above, mut beneath) = (Vec::new(), Vec::new());
    let mut left = length;
    for &part in parts {
        let taken = left.clamp(0.0, part.length);
        for (piece, side) in [(taken, &mut above), (part.length - taken, &mut beneath)] {
            if piece > same_place {
                side.push(Tube {
                    length: piece,
                    ..part
                });
            }
        }
        left -= part.length;
    }
    (above, beneath)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::academic;

    fn spans(distances: &[f64]) -> Vec<Span> {
        let string = academic::string();
        let sites = Sites::new(&string, distances).unwrap();
        string.spans(&sites).unwrap()
    }

    fn assert_lengths(spans: &[Span], expected: &[f64]) {
        let length = |span: &Span| span.runs.iter().map(Section::length).sum::<f64>();
        assert_eq!(spans.len(), expected.len());
        for (span, expected) in spans.iter().zip(expected) {
            assert!((length(span) - expected).abs() < 1e-9, "{span:?}");
        }
    }

    #[test]
    fn spans_between_sites_have_the_distances_between_them() {
        assert_lengths(&spans(&[0.0, 33.3, 170.0]), &[830.0, 136.7, 33.3]);
    }

    #[test]
    fn what_hangs_below_the_last_site_is_a_separate_span() {
        assert_lengths(&spans(&[25.0]), &[975.0, 25.0]);
    }

    #[test]
    fn a_cut_at_a_joint_leaves_no_sliver() {
        for span in spans(&[100.5, 0.0]) {
            let mut parts = span.runs.iter().flat_map(|run| &run.parts);
            assert!(parts.all(|part| part.length > 0.5 - 1e-9));
        }
    }
}
