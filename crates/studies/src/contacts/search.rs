//! The least friction at which something lasts, where it may come and go with friction: a scan,
//! then halvings of the lowest step from none to some.

/// Frictions of the scan: each √2 times the one before, from 0.0125 to 3.2.
pub const SCANNED: usize = 17;

/// Halvings of the step in the scan: what is left is 1.1 % wide.
pub const HALVINGS: usize = 5;

/// The least friction of the scan.
const LEAST: f64 = 0.0125;

/// The frictions of the scan, rising.
pub fn scan() -> impl Iterator<Item = f64> {
    (0..SCANNED).map(|step| LEAST * 2f64.powf(0.5 * step as f64))
}

/// Where something begins to last.
#[derive(Debug, Clone, PartialEq)]
pub struct Least<Lasting> {
    /// The least friction known at which it does, and what it is there; none where it lasts at no
    /// friction of the scan.
    pub lasts: Option<(f64, Lasting)>,
    /// The greatest friction known below that at which it does not; none where it lasts at the
    /// least of the scan.
    pub does_not: Option<f64>,
    /// Frictions of the scan above.
    pub above: usize,
    /// At how many of these it does not last: none where it does from a limit on.
    pub above_without: usize,
}

impl<Lasting> Least<Lasting> {
    /// From what the scan saw at each of its frictions, rising, and sees at others.
    ///
    /// # Errors
    /// What `seen` says of a friction.
    pub fn find<E>(
        scanned: Vec<(f64, Option<Lasting>)>,
        seen: impl Fn(f64) -> Result<Option<Lasting>, E>,
    ) -> Result<Self, E> {
        let mut least = Self {
            lasts: None,
            does_not: None,
            above: 0,
            above_without: 0,
        };
        for (friction, lasting) in scanned {
            match (lasting, &least.lasts) {
                (Some(lasting), None) => least.lasts = Some((friction, lasting)),
                (None, None) => least.does_not = Some(friction),
                (lasting, Some(_)) => {
                    least.above += 1;
                    least.above_without += usize::from(lasting.is_none());
                }
            }
        }
        for _ in 0..HALVINGS {
            let (Some((lasts, _)), Some(does_not)) = (&least.lasts, least.does_not) else {
                break;
            };
            let middle = (lasts * does_not).sqrt();
            match seen(middle)? {
                Some(lasting) => least.lasts = Some((middle, lasting)),
                None => least.does_not = Some(middle),
            }
        }
        Ok(least)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is found of something that lasts at these frictions, and is there its friction.
    fn found(lasts: impl Fn(f64) -> bool) -> Least<f64> {
        let seen = |friction| lasts(friction).then_some(friction);
        let scanned = scan().map(|friction| (friction, seen(friction))).collect();
        let found = Least::find(scanned, |friction| Ok::<_, ()>(seen(friction)));
        found.unwrap()
    }

    #[test]
    fn a_limit_is_bracketed_to_its_tolerance() {
        for limit in [0.0507, 0.3, 1.17, 3.1] {
            let least = found(|friction| friction >= limit);
            let (lasts, there) = least.lasts.unwrap();
            let does_not = least.does_not.unwrap();
            assert_eq!(lasts, there);
            assert!(does_not < limit && limit <= lasts, "{limit}");
            assert!(lasts / does_not < 1.011, "{limit}");
            assert_eq!(least.above_without, 0);
        }
    }

    #[test]
    fn of_several_limits_the_lowest_is_found_and_what_is_above_is_counted() {
        let least = found(|friction| (0.3..0.5).contains(&friction) || friction > 1.5);
        assert!((least.does_not.unwrap()..=least.lasts.unwrap().0).contains(&0.3));
        // 0.4 is the first; 0.57, 0.8 and 1.13 are without; 1.6, 2.26 and 3.2 are not.
        assert_eq!((least.above, least.above_without), (6, 3));
    }

    #[test]
    fn what_lasts_everywhere_or_nowhere_has_an_open_bracket() {
        let always = found(|_| true);
        assert_eq!(
            (always.lasts, always.does_not),
            (Some((LEAST, LEAST)), None)
        );
        let never = found(|_| false);
        assert_eq!((never.lasts, never.above), (None, 0));
        assert!((never.does_not.unwrap() - 3.2).abs() < 1e-12);
    }

    #[test]
    fn a_friction_without_an_answer_leaves_none() {
        let scanned = scan().map(|it| (it, (it > 1.0).then_some(()))).collect();
        assert_eq!(
            Least::<()>::find(scanned, |_| Err("no answer")),
            Err("no answer")
        );
    }
}
