//! The limit of backward whirl on a string with resonances, through the binary: every
//! branch at every site, against the balance of forces and a dense scan of the radius
//! that knows nothing of branches.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use crate::support::{Workplace, with};
use linear::waves::lateral::BendingNetwork;
use linear::{
    Bending, Drillstring, Hole, HoleSection, Material, Mud, Section, Sites, SurfaceSupport, Tube,
};

const DAMPING: f64 = 100.0;
const WALL_STIFFNESS: f64 = 1e9;

/// Outer radius of the collars, where all sites are, m.
const RADIUS: f64 = 0.0826;

/// Distance from the bit and clearance of each site, m.
const SITES: [(f64, f64); 3] = [(0.0, 2e-3), (12.0, 3e-3), (36.0, 5e-3)];

/// A 5-inch string of 3 km with collars.
const SWEEP: &str = r#"surface_speed_rpm = 120
time_s = 0.5
methods = ["quadrature"]
sampling_frequency_hz = 100

[string]
shear_modulus_gpa = 80
density_kg_m3 = 7850
torsional_damping_nms_rad_m = 1

[string.bending]
youngs_modulus_gpa = 210
damping_ns_m2 = 100

[[string.sections]]
repeat = 295
parts = [
    { length_m = 9.0, inner_radius_m = 0.0543, outer_radius_m = 0.0635 },
    { length_m = 0.5, inner_radius_m = 0.0413, outer_radius_m = 0.0841 },
]

[[string.sections]]
repeat = 20
parts = [{ length_m = 9.5, inner_radius_m = 0.0357, outer_radius_m = 0.0826 }]

[wall]
clearance_mm = 5
stiffness_gn_m15 = 1

[[sites]]
distance_from_bit_m = 36

[[sites]]
distance_from_bit_m = 12
clearance_mm = 3

[[sites]]
distance_from_bit_m = 0
clearance_mm = 2

[design]
kind = "grid"

[design.axes]
surface_speed_rpm = { values = [60, 180] }
friction = { values = [0.5, 1] }
"#;

/// Rows of `boundary.csv` that are not of one site alone.
const OF_SEVERAL: [&str; 2] = ["any_sites", "sliding_together"];

/// A row of `boundary.csv`.
#[derive(Debug, Clone)]
struct Row {
    speed: f64,
    friction: f64,
    site: f64,
    radius: f64,
    rate: f64,
    force: f64,
    branch: String,
    motion: String,
    least: String,
}

/// A finished run of a sweep in `results`.
fn run(sweep: &str) -> Workplace {
    let place = Workplace::with_small(sweep);
    let answer = place.sweep(&["run", "small.toml", "--out", "results", "--quiet"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    place
}

/// The rows of a table of a run, by the names of its columns.
fn table(place: &Workplace, name: &str) -> Vec<BTreeMap<String, String>> {
    let reader = csv::Reader::from_path(place.path("results").join(name));
    let rows = reader.unwrap().into_deserialize();
    rows.map(Result::unwrap).collect()
}

/// What there is of each site alone.
fn limit(place: &Workplace) -> Vec<Row> {
    let mut rows = table(place, "boundary.csv");
    rows.retain(|row| !OF_SEVERAL.contains(&row["motion"].as_str()));
    let rows = rows.into_iter().map(|row| {
        assert_eq!(row["sites_from_bit_m"], row["site_from_bit_m"]);
        let number = |name: &str| row[name].parse::<f64>().unwrap();
        Row {
            speed: number("surface_speed_rpm") * TAU / 60.0,
            friction: number("friction"),
            site: number("site_from_bit_m"),
            radius: 1e-3 * number("radius_mm"),
            rate: TAU * number("precession_turns_per_s"),
            force: 1e3 * number("normal_force_kn"),
            branch: row["branch"].clone(),
            motion: row["motion"].clone(),
            least: row["least"].clone(),
        }
    });
    rows.collect()
}

fn rolling(rows: &[Row]) -> Vec<Row> {
    let mut rows = rows.to_vec();
    rows.retain(|row| row.motion == "rolling");
    rows
}

fn clearance(site: f64) -> f64 {
    SITES.iter().find(|known| known.0 == site).unwrap().1
}

/// The least friction of all curves at a speed, by chords.
fn least_at(rows: &[Row], speed: f64) -> Option<f64> {
    let chords = rows.windows(2).filter_map(|ends| {
        let same = (ends[0].site, &ends[0].branch) == (ends[1].site, &ends[1].branch);
        let part = (speed - ends[0].speed) / (ends[1].speed - ends[0].speed);
        (same && (0.0..=1.0).contains(&part))
            .then(|| ends[0].friction + part * (ends[1].friction - ends[0].friction))
    });
    chords.min_by(f64::total_cmp)
}

#[test]
fn val_branches_are_continuous_and_balance_the_forces() {
    let rows = limit(&run(SWEEP));
    let curves = rolling(&rows);
    for (site, _) in SITES {
        let branches = curves.iter().filter(|row| row.site == site);
        assert!(branches.map(|row| &row.branch).max().unwrap() > &"1".to_owned());
    }
    for row in &curves {
        // Ends at the range of the map are on a chord.
        let close = |one: f64, other: f64| (one / other - 1.0).abs() < 0.02;
        assert!(close(row.rate * row.radius, row.speed * RADIUS), "{row:?}");
        let depth = row.radius - clearance(row.site);
        assert!(
            close(WALL_STIFFNESS * depth.powf(1.5), row.force) || depth < 1e-5,
            "{row:?}"
        );
    }
    let mut neighbours = 0;
    for ends in curves.windows(2) {
        if (ends[0].site, &ends[0].branch) == (ends[1].site, &ends[1].branch) {
            let step = ends[0].friction.recip().asinh() - ends[1].friction.recip().asinh();
            assert!(step.abs() < 0.6, "{ends:?}");
            assert!(
                (ends[0].speed / ends[1].speed - 1.0).abs() < 0.2,
                "{ends:?}"
            );
            neighbours += 1;
        }
    }
    assert!(neighbours > 500);
    for row in &curves {
        let least = least_at(&curves, row.speed).unwrap();
        assert_eq!(
            row.least == "true",
            row.friction <= least * (1.0 + 1e-6),
            "{row:?}"
        );
    }
    // Sliding, whirl needs no more friction at a higher speed, and never more than
    // rolling.
    let any: Vec<&Row> = rows
        .iter()
        .filter(|row| row.motion == "rolling_or_sliding")
        .collect();
    assert!(any.windows(2).all(|pair| pair[1].speed >= pair[0].speed));
    assert!(
        any.windows(2)
            .all(|pair| pair[1].friction <= pair[0].friction)
    );
    assert_eq!(any.last().unwrap().speed, 180.0 * TAU / 60.0);
    for row in &curves {
        let least = any.iter().rev().find(|any| any.speed <= row.speed).unwrap();
        assert!(least.friction <= 1.1 * row.friction, "{row:?} {least:?}");
    }
}

/// Where nothing holds the string back there is no limit, and that is said.
#[test]
fn val_a_string_that_nothing_holds_back_has_no_limit() {
    let sweep = with(SWEEP, "damping_ns_m2 = 100", "damping_ns_m2 = 0");
    let place = Workplace::with_small(&sweep);
    let answer = place.sweep(&["run", "small.toml", "--out", "results"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    assert!(answer.errors.contains("`damping_ns_m2`"), "{answer:?}");
    assert!(rolling(&limit(&place)).is_empty());
}

/// Of any sites together: a staircase over the speeds, each step of which is no lower than what
/// the forces at its rate need.
#[test]
fn val_any_sites_need_no_more_than_one() {
    let place = run(SWEEP);
    let mut rows = table(&place, "boundary.csv");
    rows.retain(|row| row["motion"] == "any_sites");
    let number = |row: &BTreeMap<String, String>, name: &str| row[name].parse::<f64>().unwrap();
    assert_eq!(number(&rows[0], "surface_speed_rpm"), 60.0);
    assert_eq!(number(rows.last().unwrap(), "surface_speed_rpm"), 180.0);
    for pair in rows.windows(2) {
        let [before, after] = [0, 1].map(|it| number(&pair[it], "surface_speed_rpm"));
        let [more, less] = [0, 1].map(|it| number(&pair[it], "friction"));
        let falls = before == after && more > less;
        assert!(before <= after && (falls || more == less), "{pair:?}");
    }
    for row in limit(&place) {
        let steps = rows.iter().rev();
        let reported = (steps.map(|step| (number(step, "surface_speed_rpm") * TAU / 60.0, step)))
            .find(|(speed, _)| *speed <= row.speed * (1.0 + 1e-9));
        let reported = number(reported.unwrap().1, "friction");
        assert!(reported <= 1.02 * row.friction, "{row:?} {reported}");
    }
    let together = rows
        .iter()
        .filter(|row| row["sites_from_bit_m"].contains(';'));
    assert!(together.count() > 0);
    for row in &rows {
        assert_eq!(
            (&row["radius_mm"][..], &row["normal_force_kn"][..]),
            ("", "")
        );
        let rate = TAU * number(row, "precession_turns_per_s");
        // No faster than the tightest place lets it, nor slower than damping lets it.
        let fastest = number(row, "surface_speed_rpm") * TAU / 60.0 * RADIUS / SITES[0].1;
        assert!(rate <= fastest * (1.0 + 1e-9), "{row:?}");
    }
}

/// Whirl that slides exists with no less friction than any needs, and with less from speed to
/// speed; no row is given where friction falls with the speed of sliding.
#[test]
fn val_sites_that_slide_together_whirl_with_no_less_than_any_need() {
    let place = run(SWEEP);
    let rows = table(&place, "boundary.csv");
    let number = |row: &BTreeMap<String, String>, name: &str| row[name].parse::<f64>().unwrap();
    let of = |motion: &'static str| rows.iter().filter(move |row| row["motion"] == motion);
    let sliding: Vec<_> = of("sliding_together").collect();
    assert_eq!(number(sliding[0], "surface_speed_rpm"), 60.0);
    let last = sliding[sliding.len() - 1];
    assert_eq!(number(last, "surface_speed_rpm"), 180.0);
    for pair in sliding.windows(2) {
        for (name, sign) in [("surface_speed_rpm", 1.0), ("friction", -1.0)] {
            let [before, after] = [0, 1].map(|it| sign * number(pair[it], name));
            assert!(before <= after, "{pair:?}");
        }
    }
    for row in &sliding {
        let speed = number(row, "surface_speed_rpm");
        let needed = of("any_sites")
            .filter(|step| number(step, "surface_speed_rpm") <= speed)
            .map(|step| number(step, "friction"))
            .fold(f64::INFINITY, f64::min);
        assert!(
            number(row, "friction") > needed / 1.0101,
            "{row:?} {needed}"
        );
    }
    let falling = with(
        SWEEP,
        "clearance_mm = 5\n",
        "clearance_mm = 5\nfriction_dynamic_ratio = 0.5\n",
    );
    let place = run(&falling);
    let rows = table(&place, "boundary.csv");
    assert!(rows.iter().all(|row| row["motion"] != "sliding_together"));
    assert!(rows.iter().any(|row| row["motion"] == "any_sites"));
}

/// Every whirl at one speed: as many as a dense scan finds, at the same radii, with
/// the same friction.
#[test]
fn val_no_whirl_of_a_dense_scan_is_missed() {
    assert!(whirls_of_a_dense_scan(SWEEP, &string(295), DAMPING, 0.0) > 20);
}

/// The same where the string carries an eccentric mass of 700 kg.
#[test]
fn val_no_whirl_with_an_eccentric_mass_is_missed() {
    let place = SITES[0].0;
    let mass = format!(
        "[[eccentric_masses]]\ndistance_from_bit_m = {place}\nmass_kg = 700\noffset_m = 0\n[wall]"
    );
    let sweep = with(SWEEP, "[wall]", &mass);
    assert!(whirls_of_a_dense_scan(&sweep, &string(295), DAMPING, 700.0) > 20);
}

/// The same where nothing but viscous mud holds a shorter string back.
#[test]
fn val_no_whirl_in_mud_alone_is_missed() {
    let string = string(20);
    let hole = Hole {
        sections: vec![HoleSection {
            length: string.length(),
            radius: 0.5 * 8.5 * 0.0254,
        }],
        mud: Mud {
            density: 1400.0,
            viscosity: 0.03,
        },
    };
    let sweep = with(SWEEP, "repeat = 295", "repeat = 20");
    let sweep = with(&sweep, "damping_ns_m2 = 100", "damping_ns_m2 = 0");
    let sweep = with(
        &sweep,
        "[wall]",
        "[well]\nhole_diameter_in = 8.5\n[mud]\ndensity_kg_m3 = 1400\nviscosity_cp = 30\n[wall]",
    );
    let string = string.in_hole(hole).unwrap();
    assert!(whirls_of_a_dense_scan(&sweep, &string, 0.0, 0.0) > 10);
}

/// How many whirls a dense scan finds of the string of a sweep, with a mass (kg) at the first of its
/// sites, each of which is in its table.
fn whirls_of_a_dense_scan(sweep: &str, string: &Drillstring, damping: f64, mass: f64) -> usize {
    let speeds = "surface_speed_rpm = { values = [60, 180] }\n";
    let rows = limit(&run(&with(sweep, speeds, "")));
    let found = rolling(&rows);
    let speed = 120.0 * TAU / 60.0;
    let mut whirls = 0;
    for (site, clearance) in SITES {
        let bending = Bending {
            youngs_modulus: 210e9,
            damping,
            compression: 0.0,
        };
        let sites = Sites::new(string, &SITES.map(|(site, _)| site)).unwrap();
        let number_of = |place: f64| {
            sites
                .distances_from_bit()
                .iter()
                .position(|it| *it == place)
        };
        let (number, of_mass) = (number_of(site).unwrap(), number_of(SITES[0].0).unwrap());
        let mut masses = vec![0.0; sites.len()];
        masses[of_mass] = mass;
        let sites = sites.carrying(masses).unwrap();
        let network = BendingNetwork::new(string, bending, SurfaceSupport::Free, &sites).unwrap();
        let stiffness =
            |radius: f64| network.at_rate(speed * RADIUS / radius)[(number, number)].inv();
        let presses_harder = |radius: f64| {
            let wall = WALL_STIFFNESS * (radius - clearance).powf(1.5);
            -stiffness(radius).re * radius > wall
        };
        // The table leaves out what needs more friction than any wall has.
        let is_of_site = |row: &&Row| row.site == site && row.friction < 9.5;
        let mut own = found.iter().filter(is_of_site).rev();
        let mut radius = clearance;
        for step in 1..=20_000 {
            let [mut low, mut high] = [radius, clearance * 3f64.powf(f64::from(step) / 20_000.0)];
            radius = high;
            let sign = presses_harder(low);
            if presses_harder(high) == sign {
                continue;
            }
            while high - low > 1e-12 * high {
                let middle = 0.5 * (low + high);
                if presses_harder(middle) == sign {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            let friction = -stiffness(low).im / stiffness(low).re;
            if friction < 9.5 {
                let row = own.next().unwrap_or_else(|| panic!("none at {radius}"));
                assert!((row.radius / low - 1.0).abs() < 1e-9, "{row:?} {low}");
                assert!(
                    (row.friction / friction - 1.0).abs() < 1e-6,
                    "{row:?} {friction}"
                );
                whirls += 1;
            }
        }
    }
    assert!(found.iter().filter(|row| row.friction < 9.5).count() <= whirls);
    let least = found.iter().map(|row| row.friction).min_by(f64::total_cmp);
    for row in &found {
        assert_eq!(row.least == "true", Some(row.friction) == least, "{row:?}");
    }
    whirls
}

/// With as many cells of pipe.
fn string(cells: usize) -> Drillstring {
    let tube = |length, inner_radius, outer_radius| Tube {
        length,
        inner_radius,
        outer_radius,
    };
    let steel = Material {
        shear_modulus: 80e9,
        density: 7850.0,
    };
    let pipe = vec![tube(9.0, 0.0543, 0.0635), tube(0.5, 0.0413, 0.0841)];
    let collar = vec![tube(9.5, 0.0357, RADIUS)];
    let sections = [(cells, pipe), (20, collar)].map(|(repeat, parts)| Section { repeat, parts });
    Drillstring::new(steel, sections.to_vec(), 1.0).unwrap()
}

/// The academic string touching the wall 50 m above the bit alone: rolling whirl needs
/// friction of 1.156, but with 1.1 an impulse ends in whirl at a slower rate that slides in part;
/// and below the friction of any steady whirl there is no whirl.
#[test]
fn val_whirl_that_slides_needs_less_friction_than_whirl_that_rolls() {
    let academic = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/fig10.toml");
    let sweep = format!(
        r#"base = "{academic}"
sites = [{{ distance_from_bit_m = 50 }}]
impulses = [{{ distance_from_bit_m = 50, ratio = 4.5 }}]
methods = ["quadrature"]
time_s = 20

[design]
kind = "grid"

[design.axes]
friction = {{ values = [0.5, 1.1] }}
"#
    );
    let place = run(&sweep);
    let rows = limit(&place);
    let [rolling, any] = &rows[..] else {
        panic!("{rows:?}");
    };
    assert!((rolling.friction - 1.156).abs() < 1e-3, "{rolling:?}");
    assert!((any.friction - 0.572).abs() < 0.006, "{any:?}");
    assert_eq!(any.motion, "rolling_or_sliding");

    let labels = table(&place, "labels.csv");
    let regimes: Vec<&str> = labels.iter().map(|row| row["lateral"].as_str()).collect();
    assert_eq!(regimes, ["transient_contact", "backward_whirl"]);
    let rate: f64 = labels[1]["precession_turns_per_s"].parse().unwrap();
    assert!(TAU * -rate < 0.9 * rolling.rate, "{rate}");
}
