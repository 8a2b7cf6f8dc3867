//! How fast oscillations of a string in bending decay at least, for any modes and supports.
//!
//! To move a tube across its hole takes a force per length f(s) = s (ms + c + D(s)) for each metre
//! of displacement at the Laplace variable s, with its mass m, its damping c and the drag D of
//! viscous mud. In a **corner** of the plane, Re s > −σ and Im s > ω₀, in which Im f > 0 for each
//! tube of the string, the dynamic stiffness of the string has a positive imaginary part too,
//! however it is shaped, held and compressed: bending and tension store energy, and what steel loses
//! only adds. Nothing resonates there, and a function with that property varies slowly.
//!
//! Without viscous mud that is so for σ = c/2m and ω₀ = 0. Mud holds back more what moves faster, so
//! that σ grows with ω₀, and there is a corner for each of a row of ω₀.
//!
//! ```
//! use linear::bending_decay::{BendingDecay, friction_if_carried};
//! use linear::{Bending, Drillstring, Hole, HoleSection, Material, Mud, Section, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7850.0 };
//! let pipe = Tube { length: 100.0, inner_radius: 0.054, outer_radius: 0.0635 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.0)?;
//! let bending = Bending { youngs_modulus: 206e9, damping: 50.0, compression: 0.0 };
//! let decay = BendingDecay::new(&string, &bending);
//! assert_eq!(decay.least(), 50.0 / (2.0 * steel.density * pipe.area()));
//! // A string that its wall carries needs that against its damping.
//! let friction = friction_if_carried(&string, &bending, 20.0);
//! assert!((friction * 20.0 / (2.0 * decay.least()) - 1.0).abs() < 1e-12);
//!
//! // Mud takes more of what is faster.
//! let sections = vec![HoleSection { length: 100.0, radius: 0.108 }];
//! let mud = Mud { density: 1200.0, viscosity: 0.02 };
//! let string = string.in_hole(Hole { sections, mud })?;
//! let decay = BendingDecay::new(&string, &Bending { damping: 0.0, ..bending });
//! assert!(decay.corner_below(20.0).decay_rate > 3.0 * decay.least());
//! # Ok::<(), linear::DrillstringError>(())
//! ```

use num_complex::Complex64;

use crate::bending::Bending;
use crate::drillstring::Drillstring;
use crate::in_mud::{self, Alike};
use crate::loss::mud::Annulus;
use crate::sites::Sites;

/// A mass at a site is as good as one spread over this length, m: the waves of whirl are tens of
/// metres long.
const SPREAD: f64 = 1.0;

/// The ω₀ of strings in viscous mud, rad/s, but for zero: powers of two.
const ABOVE: std::ops::RangeInclusive<i32> = -6..=13;

/// What is so close to the real axis, in parts of a rate, is on it.
const LOWEST: f64 = 1e-3;

/// The sides of a corner are examined at this many places from −σ to 0 …
const LEFT: i32 = 8;

/// … and at powers of √2 of ω₀ to the right.
const RIGHT: std::ops::RangeInclusive<i32> = -8..=14;

/// What is between those places is within this part.
const MARGIN: f64 = 0.98;

/// Rates that are tried, each that part of the one before.
const TRIED: i32 = 400;

/// A part of the plane in which nothing resonates, Re s > −σ and Im s > ω₀.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// ω₀, rad/s.
    pub above: f64,
    /// σ, 1/s.
    pub decay_rate: f64,
    /// σ', 1/s, at most σ: in the corner no dynamic stiffness has a greater argument than
    /// s² + 2σ's. So at a rate ω no whirl needs less friction than 2σ'/ω.
    pub decay_rate_if_carried: f64,
}

impl Corner {
    /// That of no tube.
    fn unbounded(above: f64) -> Self {
        Self {
            above,
            decay_rate: f64::INFINITY,
            decay_rate_if_carried: f64::INFINITY,
        }
    }
}

/// The corners of a string, from ω₀ = 0 on.
#[derive(Debug, Clone, PartialEq)]
pub struct BendingDecay {
    corners: Vec<Corner>,
}

impl BendingDecay {
    /// Of damping that is everywhere at least 2σ times the mass (σ in 1/s).
    pub fn constant(decay_rate: f64) -> Self {
        let corner = Corner {
            above: 0.0,
            decay_rate,
            decay_rate_if_carried: decay_rate,
        };
        Self {
            corners: vec![corner],
        }
    }

    /// Of a string with its mud.
    pub fn new(string: &Drillstring, bending: &Bending) -> Self {
        Self::of(&resistances(string, bending))
    }

    /// Corners of a string with its mud and the masses at its sites, each as if it were spread over a
    /// metre of any tube.
    pub fn with_masses(string: &Drillstring, bending: &Bending, sites: &Sites) -> Self {
        let mut resistances = resistances(string, bending);
        let greatest = sites.masses().iter().copied().fold(0.0, f64::max);
        if greatest > 0.0 {
            let heavier = |tube: &Resistance| Resistance {
                mass: tube.mass + greatest / SPREAD,
                ..*tube
            };
            let heavier: Vec<_> = resistances.iter().map(heavier).collect();
            resistances.extend(heavier);
        }
        Self::of(&resistances)
    }

    fn of(resistances: &[Resistance]) -> Self {
        if resistances.iter().all(|tube| tube.mud.is_none()) {
            let rates = resistances.iter().map(Resistance::constant_rate);
            return Self::constant(rates.fold(f64::INFINITY, f64::min));
        }
        let above = ABOVE.map(|power| 2f64.powi(power));
        let corners = std::iter::once(0.0).chain(above).map(|above| {
            let of_tubes = resistances.iter().map(|tube| tube.corner(above));
            of_tubes.fold(Corner::unbounded(above), |least, tube| Corner {
                above,
                decay_rate: least.decay_rate.min(tube.decay_rate),
                decay_rate_if_carried: least.decay_rate_if_carried.min(tube.decay_rate_if_carried),
            })
        });
        Self {
            corners: corners.collect(),
        }
    }

    /// σ of all oscillations, however slow, 1/s.
    pub fn least(&self) -> f64 {
        self.corners[0].decay_rate
    }

    /// The fastest of the corners that begin at a rate (rad/s) or below.
    pub fn corner_below(&self, rate: f64) -> &Corner {
        let below = self.corners.partition_point(|corner| corner.above <= rate);
        &self.corners[below.saturating_sub(1)]
    }
}

/// The friction with which a string whirls that its wall carries everywhere, so that it goes round
/// as a whole at a rate (rad/s): what its damping and mud take over what it is pressed with, of
/// the tube of which that is least.
pub fn friction_if_carried(string: &Drillstring, bending: &Bending, rate: f64) -> f64 {
    let resistances = resistances(string, bending);
    let ratios = resistances.iter().map(|tube| {
        let resistance = tube.per_speed(Complex64::new(0.0, rate));
        resistance.re / resistance.im
    });
    ratios.fold(f64::INFINITY, f64::min)
}

/// What holds back a tube that moves across its hole.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Resistance {
    /// m, kg/m: without viscous mud with that which moves aside.
    mass: f64,
    /// c, N s/m².
    damping: f64,
    mud: Option<Annulus>,
}

/// Those of a string, each once.
fn resistances(string: &Drillstring, bending: &Bending) -> Vec<Resistance> {
    let mut all: Vec<Resistance> = Vec::new();
    for tube in in_mud::tubes(string) {
        let resistance = Resistance::of(string, bending, &tube);
        if !all.contains(&resistance) {
            all.push(resistance);
        }
    }
    all
}

impl Resistance {
    fn of(string: &Drillstring, bending: &Bending, alike: &Alike) -> Self {
        Self {
            mass: match alike.mud {
                None => string.mass_sideways(&alike.tube, alike.hole_radius),
                Some(_) => string.mass_with_bore(&alike.tube),
            },
            damping: bending.damping,
            mud: alike.mud,
        }
    }

    /// f(s)/s, N s/m per m.
    fn per_speed(&self, s: Complex64) -> Complex64 {
        let drag = (self.mud).map_or(Complex64::ZERO, |mud| mud.against_moving(s));
        s * self.mass + self.damping + drag
    }

    /// c/2m, 1/s.
    fn constant_rate(&self) -> f64 {
        self.damping / (2.0 * self.mass)
    }

    /// That of this tube alone.
    fn corner(&self, above: f64) -> Corner {
        let Some(mud) = &self.mud else {
            let rate = self.constant_rate();
            return Corner {
                above,
                decay_rate: rate,
                decay_rate_if_carried: rate,
            };
        };
        // Right of the poles of the drag Im f/Im s is least on the real axis, and rises along it.
        let most = mud.least_decay_rate_of_vorticity();
        let of_all = self.decay_rate(LOWEST * most, most);
        // Above ω₀ a corner no wider than that has nothing sharper than ω₀ on its side.
        let of_fast = if above > 0.0 {
            self.decay_rate(above, above)
        } else {
            0.0
        };
        if of_all >= of_fast {
            return Corner {
                above,
                decay_rate: of_all,
                decay_rate_if_carried: of_all,
            };
        }
        Corner {
            above,
            decay_rate: of_fast,
            decay_rate_if_carried: self.decay_rate_if_carried(above, of_fast),
        }
    }

    /// The σ up to which Im f > 0 on the line Im s = ω₀, and so above it, for Im f/Im s rises with
    /// Im s; or what is asked for at most. Zero where rounding hides the drag, in a hole that all but
    /// fits.
    fn decay_rate(&self, above: f64, most: f64) -> f64 {
        let resistance = self.per_speed(Complex64::new(0.0, above));
        let greatest = most.min(0.5 * above * resistance.re / resistance.im);
        let rates = (1..=TRIED).map(|step| greatest * MARGIN.powi(step));
        rates
            .filter(|rate| *rate > 0.0)
            .find(|rate| {
                let wider = rate / MARGIN;
                left(wider).all(|x| self.is_passive(Complex64::new(x, above)))
            })
            .unwrap_or(0.0)
    }

    fn is_passive(&self, s: Complex64) -> bool {
        (s * self.per_speed(s)).im > 0.0
    }

    /// The σ' of a corner. The arguments of f and of s² + 2σ's are harmonic in it, so that they need
    /// to be compared on its sides alone; on the left one f has less than π, the other more.
    fn decay_rate_if_carried(&self, above: f64, decay_rate: f64) -> f64 {
        let right = RIGHT.map(|power| above * 2f64.powf(0.5 * f64::from(power)));
        let rates = left(decay_rate).chain(right).map(|x| {
            let resistance = self.per_speed(Complex64::new(x, above));
            0.5 * (above * resistance.re / resistance.im - x)
        });
        MARGIN * rates.fold(decay_rate, f64::min)
    }
}

/// Places from −σ to 0.
fn left(rate: f64) -> impl Iterator<Item = f64> {
    (0..=LEFT).map(move |step| -rate * f64::from(step) / f64::from(LEFT))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use proptest::prelude::*;

    use super::*;
    use crate::surroundings::{Hole, HoleSection, Mud};
    use crate::{Material, Section, Tube};

    const STEEL: Material = Material {
        shear_modulus: 80e9,
        density: 7850.0,
    };

    fn bending(damping: f64) -> Bending {
        Bending {
            youngs_modulus: 210e9,
            damping,
            compression: 0.0,
        }
    }

    /// c/2m of the heaviest tube, at all rates.
    #[test]
    fn constant_damping_has_one_corner() {
        let tube = |outer_radius| Tube {
            length: 10.0,
            inner_radius: 0.04,
            outer_radius,
        };
        let parts = vec![tube(0.0635), tube(0.1)];
        let string = Drillstring::new(STEEL, vec![Section { repeat: 3, parts }], 1.0).unwrap();
        let decay = BendingDecay::new(&string, &bending(150.0));
        let heaviest = STEEL.density * tube(0.1).area();
        assert_eq!(decay, BendingDecay::constant(150.0 / (2.0 * heaviest)));
        let carried = friction_if_carried(&string, &bending(150.0), 7.0);
        assert!((carried * 7.0 / (2.0 * decay.least()) - 1.0).abs() < 1e-14);
        assert_eq!(
            friction_if_carried(&string, &bending(0.0), 7.0)
                + BendingDecay::new(&string, &bending(0.0)).least(),
            0.0
        );
    }

    /// Pipe with joints or collars, in a narrow or a wide hole with thin or thick mud; with constant
    /// damping in addition, and without.
    fn in_mud() -> impl Strategy<Value = (Drillstring, Bending)> {
        let radii = (0.04..0.09f64, 0.3..0.95f64, 1.0..2.0f64, -2.0..0.7f64);
        let mud = (900.0..2300.0f64, -3.5..0.0f64);
        let damping = prop_oneof![Just(0.0), (-1.0..2.7f64).prop_map(|it| 10f64.powf(it))];
        (radii, mud, damping).prop_map(|((radius, bore, wider, gap), mud, damping)| {
            let tube = |outer_radius| Tube {
                length: 10.0,
                inner_radius: bore * radius,
                outer_radius,
            };
            let parts = vec![tube(radius), tube(wider * radius)];
            let sections = vec![Section { repeat: 3, parts }];
            let hole = Hole {
                sections: vec![HoleSection {
                    length: 60.0,
                    radius: wider * radius * (1.0 + 10f64.powf(gap)),
                }],
                mud: Mud {
                    density: mud.0,
                    viscosity: 10f64.powf(mud.1),
                },
            };
            let string = Drillstring::new(STEEL, sections, 0.0);
            let string = string.and_then(|string| string.in_hole(hole));
            (string.expect("a string in its hole"), bending(damping))
        })
    }

    /// A place in a corner: some σ or ω to the right of its left side, and above the lower.
    fn place(corner: &Corner, [right, above]: [f64; 2]) -> Complex64 {
        let width = corner.decay_rate.max(corner.above);
        Complex64::new(
            10f64.powf(right) * width - corner.decay_rate,
            10f64.powf(above) * width + corner.above,
        )
    }

    /// In a corner no tube feeds what moves it, and none resists with a greater argument than s² +
    /// 2σ's; and it is not much smaller than resistance at its lowest rate lets it be.
    #[test]
    fn in_a_corner_all_tubes_take_energy() {
        let places = prop::collection::vec((-4.0..3.0f64, -6.0..3.0f64), 100);
        proptest!(ProptestConfig::with_cases(200), |((string, bending) in in_mud(), places in places)| {
            let resistances = resistances(&string, &bending);
            let decay = BendingDecay::new(&string, &bending);
            for corner in &decay.corners {
                prop_assert!(corner.decay_rate_if_carried > 0.0 && corner.decay_rate_if_carried <= corner.decay_rate);
                let mut least = f64::INFINITY;
                for tube in &resistances {
                    for (right, above) in &places {
                        let s = place(corner, [*right, *above]);
                        let force = s * tube.per_speed(s);
                        prop_assert!(force.im > 0.0, "{corner:?} {s} {force}");
                        let most = (s * (s + 2.0 * corner.decay_rate_if_carried)).arg().rem_euclid(TAU);
                        prop_assert!(force.arg() <= most + 1e-8, "{corner:?} {s}");
                    }
                    let resistance = tube.per_speed(Complex64::new(0.0, corner.above));
                    least = least.min(0.5 * corner.above * resistance.re / resistance.im);
                }
                // Of what dies within a turn no more is asked.
                if corner.above > 3.0 * least {
                    prop_assert!(corner.decay_rate > 0.5 * least, "{corner:?} {least}");
                    prop_assert!(corner.decay_rate_if_carried > 0.5 * least, "{corner:?} {least}");
                }
            }
            for corners in decay.corners.windows(2) {
                let [slower, faster] = [0, 1].map(|it| corners[it].decay_rate);
                prop_assert!(faster > MARGIN * slower, "{decay:?}");
            }
        });
    }

    /// In a hole that all but fits rounding hides what mud does: the answer is small, or nothing, and
    /// there is one.
    #[test]
    fn a_hole_that_all_but_fits_has_an_answer() {
        let tube = Tube {
            length: 60.0,
            inner_radius: 0.04,
            outer_radius: 0.1,
        };
        for gap in [1e-5, 1e-7, 1e-9, 1e-12] {
            let string = Drillstring::new(
                STEEL,
                vec![Section {
                    repeat: 1,
                    parts: vec![tube],
                }],
                0.0,
            );
            let hole = Hole {
                sections: vec![HoleSection {
                    length: 60.0,
                    radius: 0.1 * (1.0 + gap),
                }],
                mud: Mud {
                    density: 1200.0,
                    viscosity: 0.02,
                },
            };
            let string = string
                .and_then(|string| string.in_hole(hole))
                .expect("it fits");
            let decay = BendingDecay::new(&string, &bending(0.0));
            assert!(
                decay
                    .corners
                    .iter()
                    .all(|corner| { corner.decay_rate.is_finite() && corner.decay_rate >= 0.0 })
            );
        }
    }

    /// A string that goes round as a whole needs no less friction than any corner below says.
    #[test]
    fn a_carried_string_needs_what_its_corners_say() {
        let strategy = (in_mud(), -2.0..3.0f64);
        proptest!(ProptestConfig::with_cases(300), |(((string, bending), rate) in strategy)| {
            let rate = 10f64.powf(rate);
            let friction = friction_if_carried(&string, &bending, rate);
            let decay = BendingDecay::new(&string, &bending);
            for corner in decay.corners.iter().filter(|corner| corner.above <= rate) {
                prop_assert!(friction >= 2.0 * corner.decay_rate_if_carried / rate, "{corner:?}");
            }
        });
    }
}
