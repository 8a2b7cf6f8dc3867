//! Rectangles and polylines in pixels.

/// A place in pixels; y grows downwards.
pub(crate) type Pixel = (f64, f64);

/// A rectangle in pixels.
#[derive(Clone, Copy)]
pub(crate) struct Rect {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

impl Rect {
    /// The rectangle of a given size around a centre.
    pub fn centred((x, y): Pixel, width: f64, height: f64) -> Rect {
        Rect {
            left: x - width / 2.0,
            top: y - height / 2.0,
            right: x + width / 2.0,
            bottom: y + height / 2.0,
        }
    }

    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    pub fn height(&self) -> f64 {
        self.bottom - self.top
    }

    pub fn centre(&self) -> Pixel {
        (
            (self.left + self.right) / 2.0,
            (self.top + self.bottom) / 2.0,
        )
    }

    /// The corners, clockwise from the upper left one.
    pub fn corners(&self) -> [Pixel; 4] {
        [
            (self.left, self.top),
            (self.right, self.top),
            (self.right, self.bottom),
            (self.left, self.bottom),
        ]
    }

    /// The closed line around it.
    pub fn outline(&self) -> [Pixel; 5] {
        let [first, second, third, fourth] = self.corners();
        [first, second, third, fourth, first]
    }

    /// The part of it within another.
    pub fn within(&self, other: Rect) -> Option<Rect> {
        self.overlaps(&other).then(|| Rect {
            left: self.left.max(other.left),
            top: self.top.max(other.top),
            right: self.right.min(other.right),
            bottom: self.bottom.min(other.bottom),
        })
    }

    /// Whether a place is within it, or on its edge.
    pub fn holds(&self, (x, y): Pixel) -> bool {
        (self.left..=self.right).contains(&x) && (self.top..=self.bottom).contains(&y)
    }

    pub fn overlaps(&self, other: &Rect) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    /// The parts of a polyline inside the rectangle.
    pub fn clip(&self, polyline: &[Pixel]) -> Vec<Vec<Pixel>> {
        let mut parts: Vec<Vec<Pixel>> = Vec::new();
        for side in polyline.windows(2) {
            let Some((from, to)) = self.clip_segment(side[0], side[1]) else {
                continue;
            };
            match parts.last_mut() {
                Some(part) if part.last() == Some(&from) => part.push(to),
                _ => parts.push(vec![from, to]),
            }
        }
        parts
    }

    /// The part of a segment inside the rectangle, after Liang and Barsky:
    /// each edge narrows the range of the segment's parameter.
    fn clip_segment(&self, from: Pixel, to: Pixel) -> Option<(Pixel, Pixel)> {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        // How fast the segment leaves through each edge, and how far it is.
        let edges = [
            (-dx, from.0 - self.left),
            (dx, self.right - from.0),
            (-dy, from.1 - self.top),
            (dy, self.bottom - from.1),
        ];
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for (speed, distance) in edges {
            if speed < 0.0 {
                enter = enter.max(distance / speed);
            } else if speed > 0.0 {
                leave = leave.min(distance / speed);
            } else if distance < 0.0 {
                return None;
            }
        }
        let at = |t: f64| (from.0 + t * dx, from.1 + t * dy);
        // The ends stay exactly as they are where nothing is cut off, so that
        // the caller can tell which segments are joined.
        let start = if enter > 0.0 { at(enter) } else { from };
        let end = if leave < 1.0 { at(leave) } else { to };
        (enter <= leave).then_some((start, end))
    }
}

/// Reduces a polyline to at most four points for each run of points within one
/// pixel column: the first, the extremes and the last. What is drawn stays the
/// same up to a pixel, and no peak is lost.
pub(crate) fn thin(polyline: &[Pixel]) -> Vec<Pixel> {
    polyline
        .chunk_by(|a, b| a.0.floor() == b.0.floor())
        .flat_map(thin_column)
        .collect()
}

fn thin_column(run: &[Pixel]) -> Vec<Pixel> {
    let by_height = |a: &usize, b: &usize| run[*a].1.total_cmp(&run[*b].1);
    let extremes = [
        (0..run.len()).min_by(by_height),
        // Of several maxima, `max_by` keeps the last it meets.
        (0..run.len()).rev().max_by(by_height),
    ];
    let mut kept = vec![0, run.len() - 1];
    kept.extend(extremes.into_iter().flatten());
    kept.sort_unstable();
    kept.dedup();
    kept.into_iter().map(|i| run[i]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOX: Rect = Rect {
        left: 0.0,
        top: 0.0,
        right: 10.0,
        bottom: 10.0,
    };

    #[test]
    fn a_line_is_cut_where_it_crosses_the_edges() {
        let parts = BOX.clip(&[
            (-5.0, 5.0),
            (5.0, 5.0),
            (5.0, 20.0),
            (8.0, 20.0),
            (8.0, 8.0),
        ]);
        assert_eq!(
            parts,
            [
                vec![(0.0, 5.0), (5.0, 5.0), (5.0, 10.0)],
                vec![(8.0, 10.0), (8.0, 8.0)],
            ]
        );
    }

    #[test]
    fn a_line_outside_vanishes() {
        assert!(BOX.clip(&[(-5.0, -1.0), (20.0, -1.0)]).is_empty());
        assert!(BOX.clip(&[(-5.0, 3.0), (3.0, -6.0)]).is_empty());
        assert!(BOX.clip(&[(5.0, 5.0)]).is_empty());
    }

    #[test]
    fn thinning_keeps_spikes_ends_and_order() {
        let mut wave: Vec<Pixel> = (0..10_000).map(|i| (f64::from(i) / 100.0, 1.0)).collect();
        wave[5_037].1 = 99.0;
        wave[5_041].1 = -99.0;
        let thinned = thin(&wave);
        assert!(thinned.len() <= 400);
        assert!(thinned.contains(&wave[5_037]) && thinned.contains(&wave[5_041]));
        assert_eq!((thinned[0], thinned.last()), (wave[0], wave.last()));
        assert!(thinned.is_sorted_by(|a, b| a.0 < b.0));
    }
}
