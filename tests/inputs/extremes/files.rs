//! Sweep files at the ends of what every key allows.

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

/// Keys with numbers of their ranges.
fn keys(random: &mut Random, ranges: &[(&str, f64, f64)]) -> String {
    (ranges.iter())
        .map(|&(key, low, high)| format!("{key} = {:e}\n", random.number(low, high)))
        .collect()
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
    let mut text = keys(random, &[("surface_speed_rpm", 1e-4, 1e4)]);
    if drawn.chooses {
        text += &keys(random, &[("accuracy", 1e-4, 0.5)]);
    } else {
        let all = [
            "quadrature",
            "hilbert",
            "finite-element",
            "poles",
            "trapezoidal",
            "direct-idft",
        ];
        let first = random.pick(&all);
        let second = random.pick(&all);
        if first == second || random.happens(0.6) {
            text += &format!("methods = [\"{first}\"]\n");
        } else {
            text += &format!("methods = [\"{first}\", \"{second}\"]\n");
        }
        if random.happens(0.7) {
            drawn.frequency = random.number(1.0, 1e6);
            text += &format!("sampling_frequency_hz = {:e}\n", drawn.frequency);
        }
    }
    if random.happens(0.8) {
        let longest = if random.happens(0.1) {
            1e6
        } else {
            MOST_STEPS / drawn.frequency
        };
        drawn.time = random.number(1e-3, longest.clamp(2e-3, 1e6));
        text += &format!("time_s = {:e}\n", drawn.time);
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
        text += &format!("[[string.sections]]\nrepeat = {repeat}\nparts = [{parts}]\n");
    }
    (text, length, cells)
}

fn string(random: &mut Random, bends: bool, sections: &str) -> String {
    let material = [("shear_modulus_gpa", 0.1, 1e3), ("density_kg_m3", 1e2, 3e4)];
    let mut text = "[string]\n".to_owned() + &keys(random, &material);
    text += &format!("torsional_damping_nms_rad_m = {:e}\n", damping(random, 1e5));
    if bends {
        text += "[string.bending]\n";
        text += &keys(random, &[("youngs_modulus_gpa", 0.1, 1e3)]);
        text += &format!("damping_ns_m2 = {:e}\n", damping(random, 1e7));
        if !random.happens(0.5) {
            text += &keys(random, &[("compression_kn", -1e5, 1e5)]);
        }
        let surface = random.pick(&["free", "pinned", "clamped"]);
        text += &format!("surface = \"{surface}\"\n");
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
    let text = "[bit]\n".to_owned() + &keys(random, &[("torque_static_ratio", 1.0, 10.0)]);
    if random.happens(0.5) {
        return text + &keys(random, &[("torque_dynamic_nm", 0.0, 1e7)]);
    }
    let rock = random.pick(&["sandstone", "shale", "law", "table"]);
    let text = text + &format!("rock = \"{rock}\"\n");
    let text = text + &keys(random, &[("weight_on_bit_kn", 0.0, 2e3)]);
    let law = [
        ("bit_radius_m", 1e-3, 2.0),
        ("specific_energy_mpa", 0.1, 1e4),
        ("cutting_ratio", 0.01, 10.0),
        ("friction", 0.0, 10.0),
        ("contact_strength_mpa", 0.1, 1e4),
        ("contact_growth", 1e-3, 1e3),
        ("wear_flat_mm", 1e-3, 1e3),
    ];
    match rock {
        "table" => text + "table_kn_nm = [[0, 0], [1e3, 9e6], [2e3, 1e7]]\n",
        "law" => text + "[bit.law]\n" + &keys(random, &law),
        _ => text,
    }
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
    let wall = [("clearance_mm", 1e-3, 1e3), ("friction", 0.0, 50.0)];
    let mut text = "[wall]\n".to_owned() + &keys(random, &wall);
    if random.happens(0.7) {
        text += &keys(random, &[("stiffness_gn_m15", 1e-6, 1e6)]);
    }
    if random.happens(0.3) {
        let falls = [
            ("friction_dynamic_ratio", 0.0, 1.0),
            ("friction_stribeck_m_s", 0.0, 100.0),
        ];
        text += &keys(random, &falls);
    }
    for site in &drawn.sites {
        text += &format!("[[sites]]\ndistance_from_bit_m = {site:e}\n");
        if random.happens(0.2) {
            text += &keys(random, &[("clearance_mm", 1e-3, 1e3)]);
        }
    }
    for _ in 0..random.below(3) {
        let site = drawn.sites[random.below(drawn.sites.len())];
        let amount = if drawn.relative { "ratio" } else { "amount_ns" };
        let latest = if random.happens(0.03) {
            1e6
        } else {
            0.9 * drawn.time
        };
        let longest = if random.happens(0.03) { 1e308 } else { 100.0 };
        let impulse = [
            (amount, 0.0, 1e9),
            ("start_s", 0.0, latest),
            ("duration_s", (3.0 / drawn.frequency).min(longest), longest),
            ("direction_deg", -360.0, 360.0),
        ];
        text += &format!("[[impulses]]\ndistance_from_bit_m = {site:e}\n");
        text += &keys(random, &impulse);
    }
    for _ in 0..random.below(3) {
        let site = drawn.sites[random.below(drawn.sites.len())];
        text += &format!("[[eccentric_masses]]\ndistance_from_bit_m = {site:e}\n");
        text += &keys(random, &[("mass_kg", 0.0, 1e6), ("offset_m", 0.0, 10.0)]);
    }
    text
}

fn methods(random: &mut Random, cells: f64) -> String {
    let mut text = String::new();
    for method in ["hilbert", "direct-idft"] {
        if random.happens(0.2) {
            text += &format!("[method.{method}]\n");
            text += &keys(random, &[("transform_s", 0.01, 1e5)]);
        }
    }
    let most = (MOST_ELEMENTS / cells).floor();
    let elements = random.count(1.0, 1e4).min(most).max(1.0);
    text += &format!("[method.finite-element]\nelements_per_cell = {elements}\n");
    if random.happens(0.3) {
        let gamma = random.number(0.5, 1.0);
        text += &format!("gamma = {gamma:e}\n");
        if random.happens(0.5) {
            text += &keys(random, &[("beta", gamma / 2.0, 1.0)]);
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
        axes.extend([
            ("friction", 0.0, 50.0),
            ("compression_kn", -1e5, 1e5),
            ("bending_damping_ns_m2", 0.0, 1e7),
        ]);
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
        text += &format!("cases = 3\nseed = {}\n", random.below(1000));
    }
    text += "[design.axes]\n";
    for _ in 0..1 + random.below(2) {
        let (name, low, high) = axes.swap_remove(random.below(axes.len()));
        let (one, other) = (random.number(low, high), random.number(low, high));
        let (from, to) = (one.min(other), one.max(other));
        // An end and itself are no range.
        let from = if from < to { from } else { low };
        let to = if from < to { to } else { high };
        text += &match kind {
            "grid" => format!("{name} = {{ values = [{from:e}, {to:e}] }}\n"),
            _ => format!("{name} = {{ from = {from:e}, to = {to:e} }}\n"),
        };
    }
    text
}
