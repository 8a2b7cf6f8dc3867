//! Sweep files at the ends of what every key allows.

use std::fmt::Write;

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

/// Steps of a case whose sampling frequency and time are both drawn: what takes long
/// by right is not drawn, so that what takes long is a mistake.
const MOST_STEPS: f64 = 2e4;

/// Elements of a drawn mesh, for the same reason.
const MOST_ELEMENTS: f64 = 2e4;

/// Draws from ranges, and their ends more often than anything else.
pub struct Random(ChaCha8Rng);

impl Random {
    /// Of one number, and of nothing else.
    pub fn of(number: u64) -> Self {
        Self(ChaCha8Rng::seed_from_u64(number))
    }

    /// 0 up to 1.
    fn part(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn happens(&mut self, probability: f64) -> bool {
        self.part() < probability
    }

    fn below(&mut self, count: usize) -> usize {
        (self.part() * count as f64) as usize
    }

    fn pick<'a>(&mut self, choices: &[&'a str]) -> &'a str {
        choices[self.below(choices.len())]
    }

    /// A number of a range: an end, or any order of magnitude between.
    fn number(&mut self, low: f64, high: f64) -> f64 {
        if low < 0.0 {
            return match self.below(2) {
                0 => -self.number(0.0, -low),
                _ => self.number(0.0, high),
            };
        }
        match self.below(6) {
            0 => low,
            1 => high,
            _ => {
                let least = low.max(high * 1e-15);
                least * (high / least).powf(self.part())
            }
        }
    }

    fn count(&mut self, low: f64, high: f64) -> f64 {
        self.number(low, high).floor()
    }
}

/// What the tables of a file have to agree on.
struct Drawn {
    chooses: bool,
    /// Hz and s; of those that the program chooses, a guess.
    frequency: f64,
    time: f64,
    cuts: bool,
    bends: bool,
    sites: Vec<f64>,
    relative: bool,
}

/// A sweep file: valid key by key, though not always as a whole.
pub fn sweep_file(random: &mut Random) -> String {
    let (sections, length, cells) = sections(random);
    let bends = random.happens(0.5);
    let cuts = !bends || random.happens(0.5);
    let mut drawn = Drawn {
        chooses: random.happens(0.03),
        frequency: 640.0,
        time: 10.0,
        cuts,
        bends,
        sites: sites(random, length),
        relative: random.happens(0.5),
    };
    let mut text = head(random, &mut drawn);
    text += &string(random, bends, &sections);
    if cuts {
        text += &bit(random);
    }
    if bends {
        text += &wall(random, &drawn);
    }
    if !drawn.chooses {
        text += &methods(random, cells);
    }
    text += &design(random, &drawn);
    text
}

fn head(random: &mut Random, drawn: &mut Drawn) -> String {
    let mut text = format!("surface_speed_rpm = {:e}\n", random.number(1e-4, 1e4));
    if drawn.chooses {
        writeln!(text, "accuracy = {:e}", random.number(1e-4, 0.5)).unwrap();
    } else {
        let all = [
            "quadrature",
            "hilbert",
            "finite-element",
            "trapezoidal",
            "direct-idft",
        ];
        let first = random.pick(&all);
        let second = random.pick(&all);
        if first == second || random.happens(0.6) {
            writeln!(text, "methods = [\"{first}\"]").unwrap();
        } else {
            writeln!(text, "methods = [\"{first}\", \"{second}\"]").unwrap();
        }
        if random.happens(0.7) {
            drawn.frequency = random.number(1.0, 1e6);
            writeln!(text, "sampling_frequency_hz = {:e}", drawn.frequency).unwrap();
        }
    }
    if random.happens(0.8) {
        let longest = if random.happens(0.1) {
            1e6
        } else {
            MOST_STEPS / drawn.frequency
        };
        drawn.time = random.number(1e-3, longest.clamp(2e-3, 1e6));
        writeln!(text, "time_s = {:e}", drawn.time).unwrap();
    }
    text
}

/// The sections as text, the string's length, m, and its number of cells.
fn sections(random: &mut Random) -> (String, f64, f64) {
    let (mut text, mut length, mut cells) = (String::new(), 0.0, 0.0);
    for _ in 0..1 + random.below(3) {
        let repeat = random.count(1.0, 300.0);
        let mut parts = Vec::new();
        for _ in 0..1 + random.below(2) {
            let part = random.number(1e-3, 2e4 / repeat / 6.0);
            let outer = random.number(1e-3, 2.0);
            let inner = outer * random.number(0.0, 0.999);
            length += part * repeat;
            parts.push(format!(
                "{{ length_m = {part:e}, inner_radius_m = {inner:e}, outer_radius_m = {outer:e} }}"
            ));
        }
        cells += repeat;
        let parts = parts.join(", ");
        writeln!(
            text,
            "[[string.sections]]\nrepeat = {repeat}\nparts = [{parts}]"
        )
        .unwrap();
    }
    (text, length, cells)
}

fn string(random: &mut Random, bends: bool, sections: &str) -> String {
    let mut text = format!(
        "[string]\nshear_modulus_gpa = {:e}\ndensity_kg_m3 = {:e}\n\
         torsional_damping_nms_rad_m = {:e}\n",
        random.number(0.1, 1e3),
        random.number(1e2, 3e4),
        damping(random, 1e5),
    );
    if bends {
        write!(
            text,
            "[string.bending]\nyoungs_modulus_gpa = {:e}\ndamping_ns_m2 = {:e}\n\
             compression_kn = {:e}\nsurface = \"{}\"\n",
            random.number(0.1, 1e3),
            damping(random, 1e7),
            if random.happens(0.5) {
                0.0
            } else {
                random.number(-1e5, 1e5)
            },
            random.pick(&["free", "pinned", "clamped"]),
        )
        .unwrap();
    }
    text + sections
}

/// None makes responses that never end, for which there is no memory.
fn damping(random: &mut Random, most: f64) -> f64 {
    if random.happens(0.1) {
        random.number(0.0, most)
    } else {
        random.number(1e-7 * most, most)
    }
}

fn bit(random: &mut Random) -> String {
    let ratio = random.number(1.0, 10.0);
    let mut text = format!("[bit]\ntorque_static_ratio = {ratio:e}\n");
    if random.happens(0.5) {
        writeln!(text, "torque_dynamic_nm = {:e}", random.number(0.0, 1e7)).unwrap();
        return text;
    }
    let rock = random.pick(&["sandstone", "shale", "law", "table"]);
    let weight = random.number(0.0, 2e3);
    writeln!(text, "rock = \"{rock}\"\nweight_on_bit_kn = {weight:e}").unwrap();
    match rock {
        "table" => writeln!(text, "table_kn_nm = [[0, 0], [1e3, 9e6], [2e3, 1e7]]").unwrap(),
        "law" => {
            writeln!(text, "[bit.law]").unwrap();
            let keys = [
                ("bit_radius_m", 1e-3, 2.0),
                ("specific_energy_mpa", 0.1, 1e4),
                ("cutting_ratio", 0.01, 10.0),
                ("friction", 0.0, 10.0),
                ("contact_strength_mpa", 0.1, 1e4),
                ("contact_growth", 1e-3, 1e3),
                ("wear_flat_mm", 1e-3, 1e3),
            ];
            for (key, low, high) in keys {
                writeln!(text, "{key} = {:e}", random.number(low, high)).unwrap();
            }
        }
        _ => {}
    }
    text
}

/// The bit, and some other places.
fn sites(random: &mut Random, length: f64) -> Vec<f64> {
    let most = if random.happens(0.05) { 30 } else { 4 };
    let others = (0..random.below(most)).map(|_| random.number(1e-3 * length, 0.999 * length));
    let mut sites: Vec<f64> = [0.0].into_iter().chain(others).collect();
    sites.sort_by(f64::total_cmp);
    sites.dedup();
    sites
}

fn wall(random: &mut Random, drawn: &Drawn) -> String {
    let mut text = format!(
        "[wall]\nclearance_mm = {:e}\nfriction = {:e}\n",
        random.number(1e-3, 1e3),
        random.number(0.0, 50.0),
    );
    if random.happens(0.7) {
        writeln!(text, "stiffness_gn_m15 = {:e}", random.number(1e-6, 1e6)).unwrap();
    }
    for site in &drawn.sites {
        writeln!(text, "[[sites]]\ndistance_from_bit_m = {site:e}").unwrap();
        if random.happens(0.2) {
            writeln!(text, "clearance_mm = {:e}", random.number(1e-3, 1e3)).unwrap();
        }
    }
    for _ in 0..random.below(3) {
        let site = drawn.sites[random.below(drawn.sites.len())];
        let (key, most) = if drawn.relative {
            ("ratio", 1e9)
        } else {
            ("amount_ns", 1e9)
        };
        let latest = if random.happens(0.03) {
            1e6
        } else {
            0.9 * drawn.time
        };
        let longest = if random.happens(0.03) { 1e308 } else { 100.0 };
        write!(
            text,
            "[[impulses]]\ndistance_from_bit_m = {site:e}\n{key} = {:e}\nstart_s = {:e}\n\
             duration_s = {:e}\ndirection_deg = {:e}\n",
            random.number(0.0, most),
            random.number(0.0, latest),
            random.number((3.0 / drawn.frequency).min(longest), longest),
            random.number(-360.0, 360.0),
        )
        .unwrap();
    }
    for _ in 0..random.below(3) {
        let site = drawn.sites[random.below(drawn.sites.len())];
        write!(
            text,
            "[[eccentric_masses]]\ndistance_from_bit_m = {site:e}\nmass_kg = {:e}\n\
             offset_m = {:e}\n",
            random.number(0.0, 1e6),
            random.number(0.0, 10.0),
        )
        .unwrap();
    }
    text
}

fn methods(random: &mut Random, cells: f64) -> String {
    let mut text = String::new();
    for method in ["hilbert", "direct-idft"] {
        if random.happens(0.2) {
            let transform = random.number(0.01, 1e5);
            writeln!(text, "[method.{method}]\ntransform_s = {transform:e}").unwrap();
        }
    }
    let elements = random
        .count(1.0, 1e4)
        .min((MOST_ELEMENTS / cells).floor())
        .max(1.0);
    writeln!(
        text,
        "[method.finite-element]\nelements_per_cell = {elements}"
    )
    .unwrap();
    if random.happens(0.3) {
        let gamma = random.number(0.5, 1.0);
        writeln!(text, "gamma = {gamma:e}").unwrap();
        if random.happens(0.5) {
            let beta = random.number(gamma / 2.0, 1.0);
            writeln!(text, "beta = {beta:e}").unwrap();
        }
    }
    text
}

fn design(random: &mut Random, drawn: &Drawn) -> String {
    let mut axes = vec![
        ("surface_speed_rpm", 1e-4, 1e4),
        ("torsional_damping_nms_rad_m", 0.0, 1e5),
        ("section_0_part_0_length_m", 1e-3, 100.0),
        ("section_0_part_0_inner_radius_m", 0.0, 2.0),
        ("section_0_part_0_outer_radius_m", 1e-3, 2.0),
    ];
    if drawn.cuts {
        axes.push(("torque_dynamic_nm", 0.0, 1e7));
    }
    if drawn.bends {
        axes.push(("friction", 0.0, 50.0));
        axes.push(("compression_kn", -1e5, 1e5));
        axes.push(("bending_damping_ns_m2", 0.0, 1e7));
        if drawn.relative {
            axes.push(("impulse_ratio", 0.0, 1e6));
        }
    }
    let kind = match random.below(3) {
        0 => return String::new(),
        1 => "grid",
        _ => "monte-carlo",
    };
    let mut text = format!("[design]\nkind = \"{kind}\"\n");
    if kind == "monte-carlo" {
        writeln!(text, "cases = 3\nseed = {}", random.below(1000)).unwrap();
    }
    writeln!(text, "[design.axes]").unwrap();
    for _ in 0..1 + random.below(2) {
        let (name, low, high) = axes.swap_remove(random.below(axes.len()));
        let (one, other) = (random.number(low, high), random.number(low, high));
        let (from, to) = (one.min(other), one.max(other));
        // An end and itself are no range.
        let from = if from < to { from } else { low };
        let to = if from < to { to } else { high };
        if kind == "grid" {
            writeln!(text, "{name} = {{ values = [{from:e}, {to:e}] }}").unwrap();
        } else {
            writeln!(text, "{name} = {{ from = {from:e}, to = {to:e} }}").unwrap();
        }
    }
    text
}
