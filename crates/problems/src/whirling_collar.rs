//! A collar that whirls, by explicit steps of lumped masses: an answer that shares nothing with responses
//! of a string and laws of a wall.

use std::f64::consts::PI;

/// Distance between the masses, m.
pub const SPACING: f64 = 0.25;

/// Length of a step, s.
const STEP: f64 = 2e-5;

/// Time from the beginning of the hit, s.
pub const AFTER_HIT: f64 = 8.0;

/// Of that the last part decides, s.
const WINDOW: f64 = 2.0;

/// Duration of the hit, s.
pub const HIT: f64 = 0.02;

/// A collar that hangs clamped in a hole, turns, and is hit at its free end; it touches the wall at its sites.
#[derive(Debug)]
pub struct Collar {
    /// Length, m: a whole number of [`SPACING`].
    pub length: f64,
    /// Inner and outer radius, m.
    pub radii: [f64; 2],
    /// Radius with which it touches, m.
    pub contact_radius: f64,
    /// Distributed damping sideways, N s/m per metre.
    pub damping: f64,
    /// Clearance c, m.
    pub clearance: f64,
    /// Hertzian stiffness k_c of the wall, N/m^(3/2).
    pub stiffness: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Speed of the surface, rpm.
    pub rpm: f64,
    /// Impulse of the hit, N s.
    pub hit: f64,
    /// Sites, m from the free end, in masses.
    pub sites: Vec<f64>,
}

/// Shear modulus G, Pa.
pub const SHEAR_MODULUS: f64 = 80e9;
/// Young's modulus E, Pa.
pub const YOUNGS_MODULUS: f64 = 206e9;
/// Density of steel, kg/m³.
pub const DENSITY: f64 = 7850.0;
/// Distributed damping in torsion, N m s/rad per metre.
pub const TORSIONAL_DAMPING: f64 = 200.0;

impl Collar {
    /// Rate of backward whirl in the closing window, turns a second, of the fastest site that is in contact
    /// for most of it; `None` where none goes round.
    pub fn whirl(&self) -> Option<f64> {
        let mut masses = Masses::new(self);
        let steps = (AFTER_HIT / STEP) as usize;
        let from = ((AFTER_HIT - WINDOW) / STEP) as usize;
        let count = self.sites.len();
        let (mut touched, mut turned) = (vec![0; count], vec![0.0; count]);
        for step in 0..steps {
            let time = step as f64 * STEP;
            let hit = match time < HIT {
                true => self.hit * (1.0 - (2.0 * PI * time / HIT).cos()) / HIT,
                false => 0.0,
            };
            masses.swing(hit);
            for site in 0..count {
                let node = masses.sites[site];
                let touches = masses.touch(node);
                let [x, y] = masses.place[node];
                let [to_x, to_y] = [0, 1]
                    .map(|axis| masses.place[node][axis] + STEP * masses.velocity[node][axis]);
                if step >= from {
                    touched[site] += usize::from(touches);
                    turned[site] += (x * to_y - y * to_x).atan2(x * to_x + y * to_y);
                }
            }
            masses.advance();
        }
        let rates = touched.iter().zip(turned).filter_map(|(touched, turned)| {
            let whirls = 2 * touched > steps - from && turned < -2.0 * PI;
            whirls.then_some(-turned / (2.0 * PI * WINDOW))
        });
        rates.reduce(f64::max)
    }
}

/// The collar as masses on a beam and on a shaft, from its free end to where it is clamped.
struct Masses<'a> {
    collar: &'a Collar,
    /// Speed of the surface, rad/s.
    speed: f64,
    /// EI/h³, N/m; and GJ/h, N m/rad.
    bends: f64,
    twists: f64,
    /// Of each, half at the free end: kg, kg m².
    masses: Vec<[f64; 2]>,
    /// The masses at its sites.
    sites: Vec<usize>,
    place: Vec<[f64; 2]>,
    velocity: Vec<[f64; 2]>,
    force: Vec<[f64; 2]>,
    /// Beyond even rotation, rad and rad/s.
    twist: Vec<f64>,
    spin: Vec<f64>,
}

impl<'a> Masses<'a> {
    fn new(collar: &'a Collar) -> Self {
        let [inner, outer] = collar.radii;
        let area = PI * (outer.powi(2) - inner.powi(2));
        let inertia = 0.25 * PI * (outer.powi(4) - inner.powi(4));
        let nodes = (collar.length / SPACING).round() as usize;
        let share = |node: usize| if node == 0 { 0.5 } else { 1.0 };
        let mass =
            |node: usize| [area, 2.0 * inertia].map(|it| share(node) * it * DENSITY * SPACING);
        let sites = collar.sites.iter();
        Self {
            collar,
            speed: collar.rpm * PI / 30.0,
            bends: YOUNGS_MODULUS * inertia / SPACING.powi(3),
            twists: SHEAR_MODULUS * 2.0 * inertia / SPACING,
            masses: (0..=nodes).map(mass).collect(),
            sites: sites
                .map(|distance| (distance / SPACING).round() as usize)
                .collect(),
            place: vec![[0.0; 2]; nodes + 1],
            velocity: vec![[0.0; 2]; nodes + 1],
            force: vec![[0.0; 2]; nodes + 1],
            twist: vec![0.0; nodes + 1],
            spin: vec![0.0; nodes + 1],
        }
    }

    /// Velocities under a hit of the bit (N), bending, twist and damping.
    fn swing(&mut self, hit: f64) {
        self.bend();
        self.force[0][0] += hit;
        for node in 0..self.place.len() - 1 {
            let share = if node == 0 { 0.5 } else { 1.0 };
            let [mass, turning] = self.masses[node];
            let drag = share * self.collar.damping * SPACING;
            for axis in 0..2 {
                let force = self.force[node][axis] - drag * self.velocity[node][axis];
                self.velocity[node][axis] += STEP * force / mass;
            }
            let above = self.twist[node + 1] - self.twist[node];
            let below = node
                .checked_sub(1)
                .map_or(0.0, |it| self.twist[node] - self.twist[it]);
            let drag = share * TORSIONAL_DAMPING * SPACING * self.spin[node];
            self.spin[node] += STEP * (self.twists * (above - below) - drag) / turning;
        }
    }

    /// Forces that follow from the energy of its curvatures.
    fn bend(&mut self) {
        self.force.fill([0.0; 2]);
        let last = self.place.len() - 1;
        for node in 1..last {
            for axis in 0..2 {
                let [below, here, above] =
                    [node - 1, node, node + 1].map(|it| self.place[it][axis]);
                let bent = self.bends * (below - 2.0 * here + above);
                self.force[node - 1][axis] -= bent;
                self.force[node][axis] += 2.0 * bent;
                self.force[node + 1][axis] -= bent;
            }
        }
        // Half of it is bent next to where it is clamped, as its mirror image is.
        for axis in 0..2 {
            self.force[last - 1][axis] -= 2.0 * self.bends * self.place[last - 1][axis];
        }
    }

    /// Velocities under what the wall does to a mass; whether it touches.
    fn touch(&mut self, node: usize) -> bool {
        let collar = self.collar;
        let [x, y] = self.place[node];
        let radius = x.hypot(y);
        let depth = radius - collar.clearance;
        if depth <= 0.0 {
            return false;
        }
        let normal = collar.stiffness * depth.powf(1.5);
        let [mass, turning] = self.masses[node];
        let (out, around) = ([x / radius, y / radius], [-y / radius, x / radius]);
        let velocity = &mut self.velocity[node];
        for axis in 0..2 {
            velocity[axis] -= STEP * normal * out[axis] / mass;
        }
        // The friction that would stop it in this step, or as much as there is.
        let along = velocity[0] * around[0] + velocity[1] * around[1];
        let sliding = collar.contact_radius * (self.speed + self.spin[node]) + along;
        let yields = 1.0 / mass + collar.contact_radius.powi(2) / turning;
        let most = collar.friction * normal;
        let friction = (sliding / (STEP * yields)).clamp(-most, most);
        for axis in 0..2 {
            velocity[axis] -= STEP * friction * around[axis] / mass;
        }
        self.spin[node] -= STEP * friction * collar.contact_radius / turning;
        true
    }

    /// Places at the end of the step.
    fn advance(&mut self) {
        for node in 0..self.place.len() - 1 {
            for axis in 0..2 {
                self.place[node][axis] += STEP * self.velocity[node][axis];
            }
            self.twist[node] += STEP * self.spin[node];
        }
    }
}
