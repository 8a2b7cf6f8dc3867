//! `sweep window`: where, over weight and speed, no limit is near, and the best point there.

use std::f64::consts::PI;

use crate::support::{CUTTING, SMALL, Workplace, small_with_design, with};

/// The small sweep over a grid.
fn grid(count: usize) -> String {
    small_with_design(&format!(
        "[design]\nkind = \"grid\"\n[design.axes]\n\
         surface_speed_rpm = {{ from = 0.02, to = 0.6, count = {count} }}\n\
         weight_on_bit_kn = {{ from = 20, to = 80, count = {count} }}\n"
    ))
}

pub fn done(place: &Workplace, arguments: &[&str]) -> String {
    let answer = place.sweep(arguments);
    assert_eq!(answer.code, 0, "{arguments:?}: {}", answer.errors);
    answer.output
}

pub fn refused(place: &Workplace, arguments: &[&str], message: &str) {
    let answer = place.sweep(arguments);
    assert_eq!(answer.code, 2, "{arguments:?}: {}", answer.output);
    assert!(answer.errors.contains(message), "{}", answer.errors);
}

/// Rows of a table by the names of its columns.
pub fn table(place: &Workplace, name: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let text = std::fs::read_to_string(place.path(name)).unwrap();
    let row = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
    let mut rows = text.lines().map(row);
    (rows.next().unwrap(), rows.collect())
}

/// A cell of the window: its weights, its speeds, how it stands and to what.
pub struct Cell {
    pub ends: [[f64; 2]; 2],
    pub standing: String,
    pub limits: String,
}

impl Cell {
    /// Whether a weight and a speed are in it.
    pub fn has(&self, [weight, speed]: [f64; 2]) -> bool {
        let [weights, speeds] = self.ends;
        (weights[0]..=weights[1]).contains(&weight) && (speeds[0]..=speeds[1]).contains(&speed)
    }
}

pub fn cells(place: &Workplace, name: &str) -> Vec<Cell> {
    let (header, rows) = table(place, name);
    let expected = "weight_on_bit_kn_from,weight_on_bit_kn_to,surface_speed_rpm_from,\
                    surface_speed_rpm_to,standing,limits,rate_of_penetration_m_h";
    assert_eq!(header.join(","), expected);
    let cell = |row: Vec<String>| {
        let number = |column: usize| row[column].parse::<f64>().unwrap();
        Cell {
            ends: [[number(0), number(1)], [number(2), number(3)]],
            standing: row[4].clone(),
            limits: row[5].clone(),
        }
    };
    rows.into_iter().map(cell).collect()
}

/// What a cell is follows from the labels at the four cases around it and from Eq. 74, both read
/// from the tables of the run: cases alone put a cell on the wrong side, and below Eq. 74, which is no
/// limit, none is safe; the best point and all around it are safe, and no other point with
/// as much room has more weight times speed.
#[test]
fn a_cell_is_safe_where_cases_around_it_are_smooth_and_above_eq_74() {
    let place = Workplace::with_small(&grid(7));
    done(
        &place,
        &["run", "small.toml", "--quiet", "--out", "results/small"],
    );
    let said = done(&place, &["window", "small.toml", "--clearance", "0.06"]);
    let (header, labels) = table(&place, "results/small/labels.csv");
    let column = |name: &str| header.iter().position(|known| known == name).unwrap();
    let (weight, speed) = (column("weight_on_bit_kn"), column("surface_speed_rpm"));
    let torsion = column("torsion");
    let (_, boundary) = table(&place, "results/small/boundary.csv");
    let limit: Vec<[f64; 2]> = (boundary.iter())
        .map(|row| [0, 2].map(|column| row[column].parse().unwrap()))
        .collect();
    // Of the line, straight between its points.
    let limit_at = |at: f64| {
        let above = limit
            .partition_point(|point| point[0] < at)
            .clamp(1, limit.len() - 1);
        let [[x, y], [next, z]] = [limit[above - 1], limit[above]];
        y + (z - y) * (at - x) / (next - x)
    };
    // The limit is proportional to the undershoot, by the method and as it is.
    let manifest = std::fs::read_to_string(place.path("results/small/manifest.json")).unwrap();
    let manifest: serde_json::Value = serde_json::from_str(&manifest).unwrap();
    let undershoot = |name: &str| manifest["methods"][0][name].as_f64().unwrap();
    let exact = undershoot("exact_undershoot_rad_s_per_nm") / undershoot("undershoot_rad_s_per_nm");
    assert!((exact - 1.0).abs() > 0.005, "{exact}");
    let found = cells(&place, "results/small/window.csv");
    let mut seen = [0; 4];
    for cell in &found {
        let [weights, speeds] = cell.ends;
        // Steps of the grid: 10 kN and 0.58/6 rpm.
        let (w, s) = (weights[0] + 1e-9, speeds[0] + 1e-9);
        let (low_w, low_s) = (
            20.0 + ((w - 20.0) / 10.0).floor() * 10.0,
            0.02 + ((s - 0.02) / (0.58 / 6.0)).floor() * 0.58 / 6.0,
        );
        let is_around = |row: &&Vec<String>| {
            let value = |column: usize| row[column].parse::<f64>().unwrap();
            (-1e-6..10.0 + 1e-6).contains(&(value(weight) - low_w))
                && (-1e-6..0.58 / 6.0 + 1e-6).contains(&(value(speed) - low_s))
        };
        let around: Vec<&str> = (labels.iter().filter(is_around))
            .map(|row| row[torsion].as_str())
            .collect();
        assert_eq!(around.len(), 4, "{:?}", cell.ends);
        let highest = limit_at(weights[1]) * exact.max(1.0);
        let simulated = if around.contains(&"stuck") {
            3
        } else if around.iter().all(|label| *label == "smooth") {
            0
        } else if around.iter().all(|label| *label == "stick_slip") {
            2
        } else {
            1
        };
        let room = 1e-9;
        let analytic = usize::from(speeds[0] < highest - room);
        let worst = simulated.max(analytic);
        let name = ["safe", "near", "against", "untold"][worst];
        assert_eq!(cell.standing, name, "{:?}: {around:?}", cell.ends);
        assert_eq!(cell.limits.contains("simulated"), simulated > 0);
        assert_eq!(cell.limits.contains("Eq. 74"), analytic > 0);
        seen[worst] += 1;
    }
    assert!(seen[..3].iter().all(|count| *count > 500), "{seen:?}");
    // The words tell the best point in three digits.
    let best = said
        .split("best point: ")
        .nth(1)
        .unwrap_or_else(|| panic!("{said}"));
    let mut words = best.split_whitespace();
    let weight: f64 = words.next().unwrap().parse().unwrap();
    let speed: f64 = words.nth(2).unwrap().parse().unwrap();
    let is_clear = |[w, s]: [f64; 2], part: f64| {
        let is_inside = (20.0..=80.0).contains(&(w - part * 60.0))
            && (20.0..=80.0).contains(&(w + part * 60.0))
            && (0.02..=0.6).contains(&(s - part * 0.58))
            && (0.02..=0.6).contains(&(s + part * 0.58));
        let is_safe = |cell: &Cell| {
            let [weights, speeds] = cell.ends;
            let is_off = weights[1] <= w - part * 60.0
                || weights[0] >= w + part * 60.0
                || speeds[1] <= s - part * 0.58
                || speeds[0] >= s + part * 0.58;
            is_off || cell.standing == "safe"
        };
        is_inside && found.iter().all(is_safe)
    };
    // But for the rounding of what is said.
    assert!(is_clear([weight, speed], 0.055), "{weight} {speed}");
    for cell in &found {
        let [w, s] = cell.ends.map(|[from, to]| 0.5 * (from + to));
        assert!(
            w * s < 1.01 * weight * speed || !is_clear([w, s], 0.06),
            "{w} {s}"
        );
    }
    assert!(said.contains("not examined"), "{said}");
    for name in ["window.svg", "window.png"] {
        assert!(place.path(&format!("results/small/{name}")).exists());
    }
}

/// Below its line smooth rotation is lost, if slowly: cases too short for that make no cell safe.
#[test]
fn no_cell_is_safe_where_smooth_rotation_is_lost() {
    let falls = with(
        SMALL,
        "\"sandstone\"",
        "\"sandstone\"\ntorque_decay_rpm = 0.8",
    );
    let faster = with(&falls, "to = 0.6, count = 3", "to = 2.4, count = 13");
    let text = with(
        &faster,
        "values = [30, 70]",
        "from = 20, to = 60, count = 5",
    );
    let place = Workplace::with_small(&text);
    done(&place, &["run", "small.toml", "--quiet", "--out", "out"]);
    done(&place, &["window", "small.toml", "out"]);
    let (header, rows) = table(&place, "out/boundary.csv");
    let column = |name: &str| header.iter().position(|known| known == name).unwrap();
    let number = |row: &[String], name: &str| row[column(name)].parse::<f64>().unwrap();
    let line: Vec<[f64; 2]> = (rows.iter())
        .filter(|row| row[column("limit")] == "smooth_rotation")
        .map(|row| ["weight_on_bit_kn", "surface_speed_rpm"].map(|name| number(row, name)))
        .collect();
    assert!(line.len() > 10, "{line:?}");
    let (mut safe, mut lost) = (0, 0);
    for cell in cells(&place, "out/window.csv") {
        let [weights, speeds] = cell.ends;
        // The line rises with the weight.
        let points = line.iter().filter(|[weight, _]| *weight <= weights[0]);
        let lowest = points.map(|[_, speed]| *speed).fold(0.0, f64::max);
        safe += usize::from(cell.standing == "safe");
        if speeds[1] < lowest {
            lost += 1;
            assert!(
                ["against", "untold"].contains(&&*cell.standing),
                "{:?}",
                cell.ends
            );
            assert!(cell.limits.contains("loss of smooth rotation"));
        }
        assert!(
            cell.standing != "safe" || speeds[0] >= lowest,
            "{:?}",
            cell.ends
        );
    }
    assert!(safe > 500 && lost > 500, "{safe} {lost}");
}

/// Of a part of a grid, what is around cases that are not there is not known.
#[test]
fn what_was_not_simulated_is_not_known() {
    let place = Workplace::with_small(&grid(6));
    let part = ["run", "small.toml", "--quiet", "--shard", "0/5"];
    done(&place, &part);
    let arguments = ["window", "small.toml", "results/small/shard-0-of-5"];
    let said = done(&place, &arguments);
    let found = cells(&place, "results/small/shard-0-of-5/window.csv");
    let undetermined = found.iter().filter(|cell| cell.standing == "untold");
    assert!(undetermined.count() > found.len() / 10, "{said}");
    // A list of cases here and there says nothing of what is between.
    place.write(
        "cases.csv",
        "surface_speed_rpm,weight_on_bit_kn\n0.1,30\n0.2,40\n0.3,30\n",
    );
    let list = small_with_design("[design]\nkind = \"list\"\nfile = \"cases.csv\"\n");
    place.write("list.toml", list);
    done(&place, &["run", "list.toml", "--quiet"]);
    let message = "does not hold every combination of some weights and speeds";
    let answer = place.sweep(&["window", "list.toml"]);
    assert!(answer.errors.contains(message), "{answer:?}");
}

/// A uniform string held at the bit and 20 m above, that hangs free beyond.
pub fn held() -> String {
    let part = "{ length_m = 0.5, inner_radius_m = 0.04, outer_radius_m = 0.15 },";
    let uniform = with(SMALL, part, "");
    let setting = uniform.split("[bit]").next().unwrap();
    format!(
        "{setting}[string.bending]\nyoungs_modulus_gpa = 206\ndamping_ns_m2 = 100\n\
         [bit]\nrock = \"sandstone\"\n[wall]\nclearance_mm = 20\nfriction = 0.3\n\
         [[sites]]\ndistance_from_bit_m = 0\n[[sites]]\ndistance_from_bit_m = 20\n\
         [design]\nkind = \"grid\"\n[design.axes]\n\
         surface_speed_rpm = {{ values = [40, 100, 160] }}\n\
         weight_on_bit_kn = {{ values = [20, 50] }}\n"
    )
}

/// Of a beam pinned at both ends f = π/(2 l²) √(E I/(ρ A)).
#[test]
fn lateral_resonance_is_that_of_the_string_between_what_holds_it() {
    let place = Workplace::with_small(&held());
    done(&place, &["run", "small.toml", "--quiet"]);
    let radius_of_gyration = 0.5 * (0.125f64.powi(2) + 0.05f64.powi(2)).sqrt();
    let wave = (206e9f64 / 7840.0).sqrt() * radius_of_gyration;
    let critical = |span: f64| 60.0 * PI / (2.0 * span * span) * wave;
    let band = |margin: f64| {
        let all = cells(&place, "results/small/window.csv");
        let near: Vec<f64> = (all.iter())
            .filter(|cell| cell.limits.contains("lateral resonance"))
            .flat_map(|cell| {
                assert!(["near", "against", "untold"].contains(&cell.standing.as_str()));
                cell.ends[1]
            })
            .collect();
        let least = near.iter().copied().fold(f64::INFINITY, f64::min);
        let most = near.iter().copied().fold(0.0, f64::max);
        (least / (1.0 - margin), most / (1.0 + margin))
    };
    let said = done(&place, &["window", "small.toml"]);
    let expected = critical(20.0);
    assert!((70.0..90.0).contains(&expected), "{expected}");
    let (low, high) = band(0.1);
    assert!((low / expected - 1.0).abs() < 1e-6, "{low} {expected}");
    assert!((high / expected - 1.0).abs() < 1e-6, "{high} {expected}");
    let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains("held at 0, 20 m from the bit"), "{said}");
    // Twice a turn, and held elsewhere.
    let more = ["--orders", "2", "--held-at", "0,12", "--margin", "0.05"];
    done(&place, &[&["window", "small.toml"], &more[..]].concat());
    let (low, high) = band(0.05);
    let expected = 0.5 * critical(12.0);
    assert!((low / expected - 1.0).abs() < 1e-6, "{low} {expected}");
    assert!((high / expected - 1.0).abs() < 1e-6, "{high} {expected}");
    let off = ["window", "small.toml", "--held-at", "0,200"];
    refused(&place, &off, "--held-at: ");
}

/// Random cases are counted in cells; where none says enough, nothing is safe.
#[test]
fn random_cases_are_safe_where_enough_of_them_are() {
    let place = Workplace::with_small(&small_with_design(
        "[design]\nkind = \"monte-carlo\"\nseed = 5\ncases = 900\n[design.axes]\n\
         surface_speed_rpm = { from = 0.02, to = 3 }\nweight_on_bit_kn = { from = 20, to = 80 }\n\
         torque_static_ratio = { from = 1.1, to = 1.3 }\n",
    ));
    done(&place, &["run", "small.toml", "--quiet"]);
    let safe = |more: &[&str]| {
        done(&place, &[&["window", "small.toml"], more].concat());
        let all = cells(&place, "results/small/window.csv");
        let safe = all.iter().filter(|cell| cell.standing == "safe").count();
        safe as f64 / all.len() as f64
    };
    // 100 in each of nine cells, one in a hundred of which would be too many; 9 in each of a
    // hundred tell nothing.
    let [few, fine] = [safe(&["--bins", "3"]), safe(&["--bins", "10"])];
    assert!(few > 0.3 && few < 0.9 && fine == 0.0, "{few} {fine}");
    assert!(safe(&["--bins", "3", "--risk", "0.01"]) < few);
    assert!(safe(&["--bins", "10", "--risk", "0.5"]) > 0.1);
}

/// Numbers from 0 to 1 that follow from a seed (the generator of Knuth's MMIX).
pub struct Numbers(pub u64);

impl Numbers {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = self.0.wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.next()
    }
}

/// A string with or without joints and collars, of `shortest` to `longest` metres.
fn random_string(numbers: &mut Numbers, [shortest, longest]: [f64; 2]) -> String {
    let length = shortest * (longest / shortest).powf(numbers.next());
    let joint = match numbers.next() < 0.6 {
        true => ", { length_m = 0.5, inner_radius_m = 0.045, outer_radius_m = 0.082 }",
        false => "",
    };
    let collars = numbers.between(0.0, 13.0) as usize;
    let collars = match collars {
        0 => String::new(),
        collars => format!(
            "[[string.sections]]\nrepeat = {collars}\n\
             parts = [{{ length_m = 9, inner_radius_m = 0.036, outer_radius_m = 0.1 }}]\n"
        ),
    };
    let damping = 10f64.powf(numbers.between(-1.0, 0.4));
    format!(
        "[string]\nshear_modulus_gpa = 80\ndensity_kg_m3 = 7850\n\
         torsional_damping_nms_rad_m = {damping}\n[[string.sections]]\nrepeat = {}\n\
         parts = [{{ length_m = 9, inner_radius_m = 0.05, outer_radius_m = 0.0635 }}{joint}]\n\
         {collars}[bit]\nrock = \"sandstone\"\n",
        (length / 9.5) as usize
    )
}

/// How often what is safe is not, by a method that the window did not see: on a number of random
/// strings, `STRINGS`, traced to 1/64 of the axes, 400 random cases each.
#[test]
fn what_is_safe_is_smooth_by_another_method_too() {
    let strings = std::env::var("STRINGS")
        .ok()
        .map(|text| text.parse::<usize>().unwrap());
    // A few short ones, so that it does not take long.
    let lengths = [100.0, strings.map_or(400.0, |_| 3000.0)];
    let mut numbers = Numbers(2026);
    let (mut safe, mut broken) = (0, 0);
    let mut left = strings.unwrap_or(2);
    while left > 0 {
        let string = random_string(&mut numbers, lengths);
        let design = |kind: &str, highest: f64, more: &str| {
            format!(
                "[design]\nkind = \"{kind}\"\n{more}[design.axes]\n\
                 surface_speed_rpm = {{ from = {}, to = {highest} }}\n\
                 weight_on_bit_kn = {{ from = 20, to = 150 }}\n",
                0.02 * highest
            )
        };
        let place = Workplace::new();
        // By default strings so short would have some 10 kHz.
        let both = "sampling_frequency_hz = 640\n\
                    methods = [\"quadrature\", \"finite-element\"]\n";
        let run = |name: &str, methods: &str, design: String| {
            let text = format!("{methods}{string}{design}");
            place.write(&format!("{name}.toml"), text);
            done(
                &place,
                &["run", &format!("{name}.toml"), "--quiet", "--fresh"],
            );
        };
        run("limit", both, design("monte-carlo", 1.0, "cases = 1\n"));
        let (_, boundary) = table(&place, "results/limit/boundary.csv");
        let limits = boundary.iter().map(|row| row[2].parse::<f64>().unwrap());
        let limit = limits.fold(0.0, f64::max);
        // Where damping leaves nothing to stick-slip, every point is safe.
        if limit < 0.05 {
            continue;
        }
        left -= 1;
        run(
            "window",
            both,
            design("trace", 2.5 * limit, "tolerance = 0.02\n"),
        );
        done(&place, &["window", "window.toml"]);
        let cells = cells(&place, "results/window/window.csv");
        let drawn = format!("cases = 400\nseed = {left}\n");
        run(
            "other",
            "methods = [\"held\"]\n",
            design("monte-carlo", 2.5 * limit, &drawn),
        );
        let (header, labels) = table(&place, "results/other/labels.csv");
        let column = |name: &str| header.iter().position(|known| known == name).unwrap();
        let axes = ["weight_on_bit_kn", "surface_speed_rpm"].map(column);
        let mut own = [0; 2];
        for row in &labels {
            let at = axes.map(|column| row[column].parse::<f64>().unwrap());
            if cells.iter().find(|cell| cell.has(at)).unwrap().standing == "safe" {
                own[0] += 1;
                own[1] += usize::from(row[column("torsion")] != "smooth");
            }
        }
        println!("{own:?} (safe, not smooth) below {limit} rpm of\n{string}");
        (safe, broken) = (safe + own[0], broken + own[1]);
    }
    println!("{broken} of {safe} safe cases are not smooth");
    assert!(safe > 100 && 100 * broken < safe, "{broken} of {safe}");
}

#[test]
fn what_says_nothing_of_limits_over_both_axes_is_refused() {
    let place = Workplace::with_small(&grid(3));
    done(&place, &["run", "small.toml", "--quiet"]);
    let longer = with(&grid(3), "repeat = 10", "repeat = 12");
    place.write("other.toml", &longer);
    let strange = ["window", "other.toml", "results/small"];
    let message = "are not of one string: string.sections[0].repeat: 10 → 12";
    refused(&place, &strange, message);
    let one = small_with_design(
        "[design]\nkind = \"grid\"\n[design.axes]\nsurface_speed_rpm = { values = [0.1, 0.5] }\n",
    );
    let alone = with(&one, "[bit]\n", "[bit]\nweight_on_bit_kn = 50\n");
    place.write("one.toml", &alone);
    done(&place, &["run", "one.toml", "--quiet"]);
    refused(
        &place,
        &["window", "one.toml"],
        "its cases do not differ in weight_on_bit_kn",
    );
    refused(
        &place,
        &["window", "small.toml", "nowhere"],
        "nowhere is not a folder",
    );
    refused(
        &place,
        &["window", "small.toml", "--margin", "2"],
        "is not a fraction from 0 to 0.5",
    );
    refused(
        &place,
        &["window", "small.toml", "--held-at", "0"],
        "has no [wall]",
    );
}

/// A trace leaves most points out, and has its rates of penetration between those that it simulates: as a
/// grid that simulates all.
#[test]
fn rates_of_a_trace_are_those_of_a_grid() {
    let softer = with(
        CUTTING,
        "specific_energy_mpa = 60",
        "specific_energy_mpa = 8",
    );
    let damped = "[string.axial]\ndamping_ns_m2 = 1500\n[bit]\n";
    let softer = with(
        &with(&softer, "[bit]\n", damped),
        "time_s = 20",
        "time_s = 10",
    );
    let setting = softer.split("[design]").next().unwrap();
    let best = |kind: &str, count: usize| {
        let design = format!(
            "[design]\n{kind}\n[design.axes]\n\
             surface_speed_rpm = {{ from = 40, to = 200, count = {count} }}\n\
             weight_on_bit_kn = {{ from = 5, to = 25, count = {count} }}\n"
        );
        let place = Workplace::with_small(&format!("{setting}{design}"));
        done(&place, &["run", "small.toml"]);
        let json = done(&place, &["window", "small.toml", "--json"]);
        let found: serde_json::Value = serde_json::from_str(&json).unwrap();
        found["best"].clone()
    };
    let [trace, grid] = [
        best("kind = \"trace\"\ntolerance = 0.05", 5),
        best("kind = \"grid\"", 9),
    ];
    for (key, part) in [
        ("rate_of_penetration_m_h", 0.01),
        ("surface_speed_rpm", 0.05),
        ("weight_on_bit_kn", 0.05),
    ] {
        let [trace, grid] = [&trace, &grid].map(|best| best[key].as_f64().unwrap());
        assert!((trace / grid - 1.0).abs() < part, "{key}: {trace} {grid}");
    }
}

/// Rates of penetration are drawn, and the fastest point is the best, among those that are safe.
#[test]
fn of_a_bit_that_cuts_the_best_point_drills_fastest() {
    let place = Workplace::with_small("");
    let grid = with(CUTTING, "values = [10, 30]", "from = 5, to = 30, count = 6");
    place.write("small.toml", with(&grid, "count = 3", "count = 4"));
    done(&place, &["run", "small.toml"]);
    let said = done(&place, &["window", "small.toml"]);
    assert!(said.contains("nothing on the map is safe"), "{said}");
    assert!(
        !said.contains("they are not modelled") && !said.contains("Eq. 74"),
        "{said}"
    );
    // All chatter, and in a part of them the bit turns smoothly.
    let accept = ["window", "small.toml", "--accept-chatter"];
    let said = done(&place, &accept);
    assert!(
        said.contains("stick-slip (simulated)") && said.contains("bit bounce (simulated)"),
        "{said}"
    );
    assert!(said.contains("m/h (greatest rate of penetration"), "{said}");
    let svg = std::fs::read_to_string(place.path("results/small/window.svg")).unwrap();
    assert!(svg.contains("rate of penetration"), "no contours");
    let json = done(&place, &[&accept[..], &["--json"]].concat());
    let found: serde_json::Value = serde_json::from_str(&json).unwrap();
    let best = &found["best"];
    let rate = best["rate_of_penetration_m_h"].as_f64().unwrap();
    let at = |name: &str| best[name].as_f64().unwrap();
    let cells = found["cells"].as_array().unwrap();
    let number = |cell: &serde_json::Value, name: &str| cell[name].as_f64().unwrap();
    let is_there = |cell: &&serde_json::Value| {
        ["weight_on_bit_kn", "surface_speed_rpm"]
            .iter()
            .all(|axis| {
                let [from, to] = ["from", "to"].map(|end| number(cell, &format!("{axis}_{end}")));
                from < at(axis) && at(axis) < to
            })
    };
    let own = cells.iter().find(is_there).expect("its cell");
    assert_eq!(
        (&own["standing"], number(own, "rate_of_penetration_m_h")),
        (&"safe".into(), rate)
    );
    // Between those of the cases at the ends of the map, and not the fastest of all.
    let rates = cells
        .iter()
        .map(|cell| number(cell, "rate_of_penetration_m_h"));
    assert!(rates.clone().all(|rate| rate > 0.29 && rate < 43.2));
    assert!(rates.clone().any(|other| other > 1.5 * rate), "{rate}");
}

#[test]
fn rates_of_random_cases_are_means_in_a_range() {
    let place = Workplace::with_small("");
    let random = with(
        CUTTING,
        "kind = \"grid\"",
        "kind = \"monte-carlo\"\ncases = 60",
    );
    let random = with(&random, ", count = 3", "");
    place.write(
        "small.toml",
        with(&random, "values = [10, 30]", "from = 5, to = 30"),
    );
    done(&place, &["run", "small.toml"]);
    let bins = ["--bins", "2", "--risk", "0.5", "--accept-chatter"];
    let said = done(&place, &[&["window", "small.toml"], &bins[..]].concat());
    assert!(said.contains("m/h (greatest rate of penetration"), "{said}");
    let (_, cells) = table(&place, "results/small/window.csv");
    let mut rates: Vec<&str> = cells.iter().map(|cell| cell[6].as_str()).collect();
    rates.sort_unstable();
    rates.dedup();
    assert_eq!(rates.len(), 4, "{rates:?}");
}

#[test]
fn chatter_is_accepted_of_bits_that_cut_alone() {
    let place = Workplace::with_small(SMALL);
    done(&place, &["run", "small.toml"]);
    let answer = place.sweep(&["window", "small.toml", "--accept-chatter"]);
    assert_eq!(answer.code, 2, "{answer:?}");
    assert!(
        answer.errors.contains("--accept-chatter: no bit"),
        "{answer:?}"
    );
}
