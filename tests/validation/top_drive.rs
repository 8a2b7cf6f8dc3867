//! The limit of Fig. 9 below three controllers of a top drive, as the files in `sweeps/` have
//! it, and what `inspect` says of them.

use std::path::Path;

use crate::support::Workplace;

/// One of the files shipped.
fn file(name: &str) -> String {
    let sweeps = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../sweeps");
    sweeps.join(format!("{name}.toml")).display().to_string()
}

/// The rows of a CSV file with their columns of these names.
fn columns<const N: usize>(text: &str, names: [&str; N]) -> Vec<[String; N]> {
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().unwrap();
    let places = names.map(|name| header.iter().position(|known| *known == name).unwrap());
    lines
        .map(|cells| places.map(|place| cells[place].to_owned()))
        .collect()
}

/// The limit of Eq. 74 at 100 kN by `held`, rpm, and the labels by it; all of them on the right
/// side of the limit but within a tenth of it.
fn limit(name: &str) -> (f64, usize) {
    let place = Workplace::new();
    let run = place.sweep(&[
        "run",
        &file(name),
        "--methods",
        "held",
        "--out",
        "results",
        "--quiet",
    ]);
    assert_eq!(run.code, 0, "{name}: {}", run.errors);
    let read = |table: &str| std::fs::read_to_string(place.path("results").join(table)).unwrap();
    let boundary: Vec<[f64; 2]> = columns(
        &read("boundary.csv"),
        ["weight_on_bit_kn", "surface_speed_rpm"],
    )
    .iter()
    .map(|row| row.each_ref().map(|cell| cell.parse().unwrap()))
    .collect();
    let limit_at = |weight: f64| {
        let above = boundary.iter().position(|row| row[0] >= weight - 1e-9);
        boundary[above.unwrap()][1]
    };
    let labels = columns(
        &read("labels.csv"),
        ["weight_on_bit_kn", "surface_speed_rpm", "torsion"],
    );
    let mut sticks = 0;
    for [weight, speed, label] in &labels {
        let limit = limit_at(weight.parse().unwrap());
        let ratio = speed.parse::<f64>().unwrap() / limit;
        let is_stick_slip = label == "stick_slip";
        sticks += usize::from(is_stick_slip);
        if !(0.9..1.1).contains(&ratio) {
            assert_eq!(
                is_stick_slip,
                ratio < 1.0,
                "{name}: {weight} kN {speed} rpm"
            );
        }
    }
    (limit_at(100.0), sticks)
}

#[test]
fn val_controllers_move_the_limit_of_stick_slip_as_their_reflection_says() {
    let [plain, stiff, soft, matched] = [
        "fig09",
        "top_drive",
        "top_drive_soft_torque",
        "top_drive_impedance_matched",
    ]
    .map(limit);
    // A stiff drive is nearly a surface that turns as prescribed.
    assert!(
        (stiff.0 / plain.0 - 1.0).abs() < 0.05,
        "{stiff:?} {plain:?}"
    );
    assert!(
        (0.15..0.35).contains(&(soft.0 / plain.0)),
        "{soft:?} {plain:?}"
    );
    assert!(soft.1 > 0);
    // Nothing comes back that could stop the bit.
    assert_eq!(matched, (0.0, 0));
}

#[test]
fn inspect_shows_the_reflection_coefficient_and_how_modes_die_away() {
    let place = Workplace::new();
    let file = file("top_drive_soft_torque");
    let answer = place.sweep(&["inspect", &file, "--out", "looked"]);
    assert_eq!(answer.code, 0, "{}", answer.errors);
    for expected in [
        "top drive",
        "integral gain K_i",
        "of a wave, then comes back",
    ] {
        assert!(answer.output.contains(expected), "{}", answer.output);
    }
    for picture in ["inspect.png", "top_drive.png", "top_drive.svg"] {
        assert!(place.path("looked").join(picture).exists(), "{picture}");
    }
}

/// Where the first wave hardly breaks the bit loose, and where it creeps, the bit is caught by
/// its own collars dozens of times a second: three such cycles alike are no stick-slip of the
/// string, and were once taken for it.
#[test]
fn val_creeping_is_not_taken_for_settled_stick_slip() {
    let cases = "surface_speed_rpm,weight_on_bit_kn\n60,170\n60,200\n65,180\n70,190\n\
                 120,80\n125,80\n145,90\n170,100\n175,100\n";
    let run = |keys: &str, options: &[&str]| -> Vec<[String; 3]> {
        let place = Workplace::new();
        let well = file("well_12in_soft_torque");
        let design = "[design]\nkind = \"list\"\nfile = \"cases.csv\"\n";
        place.write(
            "well.toml",
            format!(
                "base = '{well}'\nmethods = [\"held\"]\nsurface_speed_rise_s = 0\n{keys}\n{design}"
            ),
        );
        place.write("cases.csv", cases);
        let run = ["run", "well.toml", "--out", "results", "--quiet"];
        let answer = place.sweep(&[&run, options].concat());
        assert_eq!(answer.code, 0, "{}", answer.errors);
        let labels = std::fs::read_to_string(place.path("results/labels.csv")).unwrap();
        columns(
            &labels,
            ["surface_speed_rpm", "weight_on_bit_kn", "torsion"],
        )
    };
    assert_eq!(run("", &[]), run("", &["--full"]));
    // As the matched impedance was first tried: more damping, a lower static torque.
    let first = "[string]\ntorsional_damping_nms_rad_m = 0.1\n[bit]\n\
                 torque_static_ratio = 1.2\n[top_drive]\ncontroller = \"impedance-matched\"\n";
    for row in run(first, &[]) {
        assert_eq!(row[2], "smooth", "{row:?}");
    }
}

/// A surface that takes τ to reach its speed is behind by τ/2 for ever, and so is the first
/// slip.
#[test]
fn val_a_rise_of_the_surface_speed_puts_the_first_slip_off_by_half_of_it() {
    let first_slip = |rise: f64| -> f64 {
        let place = Workplace::new();
        let base = file("fig08a");
        let keys = format!(
            "base = '{base}'\nsurface_speed_rise_s = {rise}\ndesign = {{ kind = \"list\", file = \"one.csv\" }}\n"
        );
        place.write("one.toml", keys);
        place.write("one.csv", "surface_speed_rpm\n0.2\n");
        let options = ["--methods", "held", "--out", "results", "--quiet"];
        let answer = place.sweep(&[&["run", "one.toml"], &options[..]].concat());
        assert_eq!(answer.code, 0, "{}", answer.errors);
        let labels = std::fs::read_to_string(place.path("results/labels.csv")).unwrap();
        columns(&labels, ["first_slip_s"])[0][0].parse().unwrap()
    };
    let at_once = first_slip(0.0);
    for rise in [0.5, 2.0] {
        let later = first_slip(rise) - at_once;
        assert!((later - 0.5 * rise).abs() < 0.02, "{rise}: {later}");
    }
}

/// In the end the motor turns a bit that drills smoothly, and the whole string through its
/// damping: momentum in, momentum out.
#[test]
fn val_the_motor_turns_bit_and_string() {
    let place = Workplace::new();
    let file = file("top_drive_soft_torque");
    let at = [
        "--set",
        "surface_speed_rpm=0.5",
        "--set",
        "weight_on_bit_kn=50",
    ];
    let answer = place.sweep(&[&["simulate", &file, "--out", "looked"], &at[..]].concat());
    assert_eq!(answer.code, 0, "{}", answer.errors);
    let history = std::fs::read_to_string(place.path("looked/history.csv")).unwrap();
    let rows = columns(&history, ["torque_on_bit_nm", "motor_torque_nm"]);
    let [on_bit, of_motor] = (rows.last().unwrap())
        .each_ref()
        .map(|cell| cell.parse::<f64>().unwrap());
    // c_t L of the paper's string is 10 000 N m s/rad.
    let through_damping = 1e4 * 0.5 * std::f64::consts::TAU / 60.0;
    let off = of_motor / (on_bit + through_damping) - 1.0;
    assert!(off.abs() < 0.01, "{on_bit} {of_motor}");
}
