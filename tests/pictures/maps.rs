//! Regime maps as `sweep run` draws them: every label is on a map, no symbol hides
//! another, and the limit is drawn or noted.

use crate::support::{Answer, SMALL, Workplace, small_with_design, with};
use crate::tables::write_table;

const BENDING: &str = "[string.bending]\nyoungs_modulus_gpa = 210\ndamping_ns_m2 = 2000\n\n";

const WALL: &str = "
[wall]
clearance_mm = 15
stiffness_gn_m15 = 1
friction = 1.5

[[sites]]
distance_from_bit_m = 0

[[impulses]]
distance_from_bit_m = 0
ratio = 3

";

/// The small string in a borehole, with a bit that cuts.
fn with_bit_and_wall(design: &str) -> String {
    let start = SMALL.find("[[sites]]").unwrap();
    let sections = "[[string.sections]]";
    let string = with(&SMALL[..start], sections, &format!("{BENDING}{sections}"));
    format!("{string}{WALL}{design}")
}

/// The same with a bit that does not cut.
fn with_wall(design: &str) -> String {
    with(
        &with_bit_and_wall(design),
        "[bit]\nrock = \"sandstone\"\n",
        "",
    )
}

/// Stick-slip at low speeds, whirl at high ones.
const SPEED_AND_WEIGHT: &str = "[design]\nkind = \"grid\"\n[design.axes]\n\
    surface_speed_rpm = { values = [0.1, 0.3, 30, 60] }\n\
    weight_on_bit_kn = { values = [30, 70] }\n";

/// A finished run of `small.toml` in `results`.
struct Run {
    place: Workplace,
    answer: Answer,
}

impl Run {
    #[track_caller]
    fn of(sweep: &str) -> Self {
        let place = Workplace::with_small(sweep);
        let answer = place.sweep(&["run", "small.toml", "--out", "results"]);
        assert_eq!((answer.code, answer.errors.as_str()), (0, ""), "{answer:?}");
        Self { place, answer }
    }

    fn text(&self, file: &str) -> String {
        std::fs::read_to_string(self.place.path("results").join(file)).unwrap()
    }

    fn map(&self) -> Map {
        Map(self.text("map.svg"))
    }

    /// A column of a table of the results.
    fn column(&self, file: &str, name: &str) -> Vec<String> {
        let text = self.text(file);
        let header = text.lines().next().unwrap();
        let place = header.split(',').position(|field| field == name).unwrap();
        let rows = text.lines().skip(1);
        rows.map(|row| row.split(',').nth(place).unwrap().to_owned())
            .collect()
    }

    fn numbers(&self, file: &str, name: &str) -> Vec<f64> {
        let fields = self.column(file, name);
        fields.iter().map(|field| field.parse().unwrap()).collect()
    }

    fn count(&self, column: &str, label: &str) -> usize {
        let labels = self.column("labels.csv", column);
        labels.iter().filter(|found| *found == label).count()
    }
}

/// A map as SVG.
struct Map(String);

impl Map {
    /// All its words, line by line in the order in which they are written.
    fn words(&self) -> String {
        let texts = self.0.split("<text").skip(1);
        let words = texts.map(|text| {
            let content = text.split_once('>').unwrap().1;
            content.split("</text>").next().unwrap().trim()
        });
        words.collect::<Vec<_>>().join(" ")
    }

    /// Values of attributes of the elements that begin with `tag`.
    fn values<const N: usize>(&self, tag: &str, names: [&str; N]) -> Vec<[String; N]> {
        let elements = self.0.split(tag).skip(1);
        let of_element = |element: &str| {
            let element = element.split('>').next().unwrap();
            names.map(|name| {
                let after = element.split(&format!(" {name}=\"")).nth(1).unwrap();
                after.split('"').next().unwrap().to_owned()
            })
        };
        elements.map(of_element).collect()
    }

    /// Where its circles are, those of the legend included.
    fn circles(&self) -> Vec<[String; 2]> {
        self.values("<circle", ["cx", "cy"])
    }

    /// Heights of the level lines drawn as the first limit is, the key of the legend
    /// last.
    fn limits(&self) -> Vec<f64> {
        let lines = self.values("<polyline", ["stroke-width", "points"]);
        let limits = lines.iter().filter(|[width, _]| width == "1.2");
        let height = |points: &str| {
            let first = points.split([' ', ',']).nth(1).unwrap();
            first.parse::<f64>().unwrap()
        };
        limits.map(|[_, points]| height(points)).collect()
    }
}

#[test]
fn a_scene_with_bit_and_wall_has_a_map_for_each_of_its_labels() {
    let run = Run::of(&with_bit_and_wall(SPEED_AND_WEIGHT));
    let [stick_slip, whirl] = [
        run.count("torsion", "stick_slip"),
        run.count("lateral", "backward_whirl"),
    ];
    assert!(stick_slip > 0 && whirl > stick_slip, "{stick_slip} {whirl}");
    let map = run.map();
    let middle = 1180.0 / 2.0;
    let is_left = |[x, _]: &[String; 2]| x.parse::<f64>().unwrap() < middle;
    let (left, right): (Vec<_>, Vec<_>) = map.circles().into_iter().partition(is_left);
    // Each legend has a circle too.
    assert_eq!((left.len(), right.len()), (stick_slip + 1, whirl + 1));
    let words = map.words();
    for said in [
        "Torsion",
        "Lateral motion",
        "stick-slip",
        "no sustained whirl",
    ] {
        assert!(words.contains(said), "{said}: {words}");
    }
    // The limit of stick-slip is not drawn for whirl.
    assert_eq!(words.matches("Eq. 74").count(), 1, "{words}");
    let before = run.place.files();
    run.place.sweep(&["plot", "results"]);
    assert!(
        run.place.files() == before,
        "drawn again, it is another map"
    );
}

/// The numbers of a line.
fn sum(line: &str) -> usize {
    let numbers = line.split(|letter: char| !letter.is_ascii_digit());
    numbers
        .filter_map(|number| number.parse::<usize>().ok())
        .sum()
}

#[test]
fn two_labels_of_a_case_are_counted_in_two_lists() {
    let run = Run::of(&with_bit_and_wall(SPEED_AND_WEIGHT));
    let cases = 8;
    let said = &run.answer.output;
    for motion in ["torsional", "lateral"] {
        let start = format!("quadrature, {motion}: ");
        let counts = said.split(&start).nth(1).expect(said);
        assert_eq!(sum(counts.lines().next().unwrap()), cases, "{said}");
    }
    let summary = run.place.sweep(&["summary", "results"]).output;
    for motion in ["torsional", "lateral"] {
        let caption = format!("Cases of each {motion} regime, by method:");
        let table = summary.split(&caption).nth(1).expect(&summary);
        assert_eq!(sum(table.lines().nth(2).unwrap()), cases, "{summary}");
        let shown = summary.split("Cases by what the map is about:").nth(1);
        let row = shown.unwrap().lines().find(|line| line.contains(motion));
        assert_eq!(sum(row.expect(&summary)), cases, "{summary}");
    }
    // Both maps in characters.
    let stick_slip = summary.matches("O stick-slip by all methods").count();
    let whirl = summary.matches("O sustained whirl by all methods").count();
    assert_eq!((stick_slip, whirl), (1, 1), "{summary}");
    // Scripts continue to read all labels in one place.
    let manifest: serde_json::Value = serde_json::from_str(&run.text("manifest.json")).unwrap();
    let labels = manifest["labels"]["quadrature"].as_object().unwrap();
    let counts = labels.values().map(|count| count.as_u64().unwrap());
    assert_eq!(counts.sum::<u64>(), 2 * cases as u64);
}

#[test]
fn a_scene_with_one_label_has_one_list_without_a_motion() {
    let run = Run::of(SMALL);
    let said = &run.answer.output;
    assert!(said.contains("\n  quadrature: "), "{said}");
    let summary = run.place.sweep(&["summary", "results"]).output;
    assert!(summary.contains("Cases of each regime, by method:"));
    let words = run.map().words();
    assert!(
        !words.contains("Torsion") && !words.contains("whirl"),
        "{words}"
    );
}

#[test]
fn few_values_of_a_third_axis_have_a_map_each_with_its_own_limit() {
    let design = "[design]\nkind = \"grid\"\n[design.axes]\n\
        surface_speed_rpm = { values = [40, 80] }\n\
        impulse_ratio = { values = [2, 4] }\n\
        friction = { values = [0.5, 1.5, 2.5] }\n\
        [map]\nx = \"impulse_ratio\"\ny = \"friction\"\n";
    let run = Run::of(&with_wall(design));
    let map = run.map();
    let words = map.words();
    for title in ["Surface speed Ω = 40 rpm", "Surface speed Ω = 80 rpm"] {
        assert!(words.contains(title), "{words}");
    }
    let circles = map.circles();
    assert_eq!(circles.len(), run.count("lateral", "backward_whirl") + 1);
    for (index, circle) in circles.iter().enumerate() {
        assert!(!circles[..index].contains(circle), "two at {circle:?}");
    }
    // Pixels grow downwards, friction upwards.
    let [slow, fast, _key] = map.limits()[..] else {
        panic!("{:?}", map.limits());
    };
    let friction = run.numbers("boundary.csv", "friction");
    let [first, last] = [friction[0], friction[friction.len() - 1]];
    assert!((first - last).abs() > 0.02, "{first} {last}");
    assert_eq!(slow < fast, first > last, "{slow} {fast}: {first} {last}");
}

#[test]
fn many_values_of_a_third_axis_are_shown_as_parts_and_their_limits_as_a_range() {
    let design = "[design]\nkind = \"monte-carlo\"\ncases = 60\nseed = 1\n[design.axes]\n\
        surface_speed_rpm = { from = 30, to = 90 }\n\
        impulse_ratio = { from = 1, to = 5 }\n\
        friction = { from = 0.5, to = 3 }\n\
        [map]\nx = \"impulse_ratio\"\ny = \"friction\"\n";
    let run = Run::of(&with_wall(design));
    let map = run.map();
    assert!(map.circles().is_empty());
    let words = map.words();
    for said in [
        "Cases with sustained whirl in each cell (quadrature), of 60 cases over surface speed",
        "all",
        "none",
        "its range over these cases",
    ] {
        assert!(words.contains(said), "{said}: {words}");
    }
    // Every value of the boundary once had its own line, a solid black band.
    let level = map.limits();
    assert!(run.numbers("boundary.csv", "friction").len() > 20);
    assert!(level.len() < 20, "{} lines", level.len());
}

/// Made-up cases, of which no two neighbours are alike.
#[test]
fn a_sheet_of_twelve_maps_of_many_cases_stays_below_a_megabyte() {
    let design = "[design]\nkind = \"grid\"\n[design.axes]\n\
        surface_speed_rpm = { values = [40, 80] }\n\
        weight_on_bit_kn = { values = [30, 70] }\n\
        impulse_ratio = { values = [2, 4] }\n\
        [map]\nx = \"impulse_ratio\"\ny = \"weight_on_bit_kn\"\n";
    let run = Run::of(&with_bit_and_wall(design));
    let axes = "surface_speed_rpm,weight_on_bit_kn,impulse_ratio";
    let mut labels = format!("case,method,{axes},torsion,lateral\n");
    let regimes = ["smooth,backward_whirl", "stick_slip,no_contact"];
    for case in 0..6 * 60 * 60 {
        let (speed, weight, impulse) = (case / 3600, case / 60 % 60, case % 60);
        let regime = regimes[(weight + impulse) % 2];
        labels += &format!("{case},quadrature,{speed},{weight},{impulse},{regime}\n");
    }
    write_table(&run.place, "results", "labels.csv", labels);
    let answer = run.place.sweep(&["plot", "results"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    let map = run.map();
    assert_eq!(map.words().matches("Weight on bit W (kN)").count(), 12);
    assert!(map.0.len() < 1_000_000, "{}", map.0.len());
}

/// What follows `before` in `words`, as a number.
#[track_caller]
fn number_after(words: &str, before: &str) -> f64 {
    let after = words.split(before).nth(1).expect(words);
    after.split([' ', ',']).next().unwrap().parse().unwrap()
}

#[track_caller]
fn assert_near(one: f64, other: f64) {
    assert!(
        (one - other).abs() < 6e-3 * other.abs(),
        "{one} and {other}"
    );
}

#[test]
fn a_map_of_one_regime_names_it_alone_and_tells_where_stick_slip_begins() {
    let design = "[design]\nkind = \"grid\"\n[design.axes]\n\
        surface_speed_rpm = { values = [20, 40] }\n\
        weight_on_bit_kn = { values = [30, 70] }\n";
    let run = Run::of(&small_with_design(design));
    assert_eq!(run.count("torsion", "smooth"), 4);
    let words = run.map().words();
    assert!(words.contains("smooth (quadrature)"), "{words}");
    assert!(!words.contains("stick-slip ("), "{words}");
    let limits = run.numbers("boundary.csv", "surface_speed_rpm");
    let weights = run.numbers("boundary.csv", "weight_on_bit_kn");
    let nearest = (0..limits.len()).max_by(|&a, &b| limits[a].total_cmp(&limits[b]));
    let nearest = nearest.unwrap();
    assert!(words.contains("below this map"), "{words}");
    assert_near(number_after(&words, "quadrature: "), limits[nearest]);
    assert_near(number_after(&words, "rpm at "), weights[nearest]);
    assert_near(number_after(&words, "margin "), 20.0 - limits[nearest]);
    let summary = run.place.sweep(&["summary", "results"]).output;
    let keys = summary.lines().find(|line| line.starts_with(". ")).unwrap();
    assert_eq!(keys, ". smooth by all methods");
}

#[test]
fn a_map_of_whirl_alone_tells_how_far_above_the_least_friction_it_is() {
    let design = "[design]\nkind = \"grid\"\n[design.axes]\n\
        impulse_ratio = { values = [4, 5] }\nfriction = { values = [2, 3] }\n";
    let run = Run::of(&with_wall(design));
    assert_eq!(run.count("lateral", "backward_whirl"), 4);
    let words = run.map().words();
    assert!(!words.contains("no sustained whirl"), "{words}");
    let limits = run.numbers("boundary.csv", "friction");
    let least = limits.into_iter().fold(f64::INFINITY, f64::min);
    assert_near(number_after(&words, ": limit "), least);
    assert_near(number_after(&words, "margin "), 2.0 - least);
}

#[test]
fn marks_of_a_base_outside_of_the_range_are_noted_and_do_not_stretch_the_axes() {
    let design = "[design]\nkind = \"grid\"\n[design.axes]\n\
        surface_speed_rpm = { values = [20, 40] }\n\
        weight_on_bit_kn = { values = [60, 70] }\n";
    let own_range = Run::of(&format!("{}[map]\nmarks = []\n", small_with_design(design)));
    let inherited = Workplace::with_small(SMALL);
    let derived = format!("base = \"small.toml\"\n{design}");
    inherited.write("derived.toml", derived);
    let answer = inherited.sweep(&["run", "derived.toml", "--out", "results"]);
    let inherited = Run {
        place: inherited,
        answer,
    };
    let words = inherited.map().words();
    let note = "marks outside this map: A (50 kN, 0.3 rpm)";
    assert_eq!(
        with(&words, &format!(" {note}"), ""),
        own_range.map().words()
    );
    // One within the range is drawn, at its very edge too.
    let marked =
        "[map]\nmarks = [{ name = \"A\", surface_speed_rpm = 40, weight_on_bit_kn = 60 }]\n";
    let inside = Run::of(&format!("{}{marked}", small_with_design(design)));
    let words = inside.map().words();
    assert!(
        words.contains(" A") && !words.contains("outside"),
        "{words}"
    );
}

/// [`SPEED_AND_WEIGHT`] with a measure as colour.
fn coloured(measure: &str) -> String {
    format!("{SPEED_AND_WEIGHT}[map]\ncolour = {measure:?}\n")
}

#[test]
fn a_measure_is_drawn_as_colour_with_its_unit_and_classes() {
    let run = Run::of(&with_bit_and_wall(&coloured("peak_radius_mm")));
    let map = run.map().words();
    for words in ["Greatest radius (mm)", "limit of sustained whirl", " to "] {
        assert!(map.contains(words), "no {words:?}");
    }
    let run = Run::of(&small_with_design(&coloured("bit_speed_peak_rpm")));
    let map = run.map().words();
    for words in ["Greatest bit speed (rpm)", "limit of stick-slip"] {
        assert!(map.contains(words), "no {words:?}");
    }
}

/// How a map is drawn is no other sweep.
#[test]
fn another_colour_draws_the_same_results_again() {
    let run = Run::of(&small_with_design(SPEED_AND_WEIGHT));
    let text = small_with_design(&coloured("stick_slip_severity"));
    run.place.write("small.toml", text);
    let answer = run.place.sweep(&["run", "small.toml", "--out", "results"]);
    assert!(answer.output.contains("nothing to run"), "{answer:?}");
    assert!(run.text("map.svg").contains("Severity of stick-slip"));
}

/// Where the middles of the map's symbols are along its horizontal axis, by case.
fn places_across(run: &Run) -> Vec<f64> {
    let report = run.place.sweep(&["report", "results"]);
    assert_eq!(report.code, 0, "{report:?}");
    let page = std::fs::read_to_string(run.place.path("results/report.html")).unwrap();
    let (_, data) = page
        .split_once("\"ends\":[[")
        .expect("the ends of the axes");
    let (ends, _) = data.split_once(']').unwrap();
    let ends: Vec<f64> = ends.split(',').map(|end| end.parse().unwrap()).collect();
    let of = |value: f64| (value / ends[0]).ln() / (ends[1] / ends[0]).ln();
    assert!(page.contains("\"logarithmic\":[true,false]"));
    [0.02, 0.2, 2.0].map(of).to_vec()
}

/// Numbers below an axis stand where their logarithms are, as cells do.
#[test]
fn an_axis_that_is_even_in_the_logarithm_is_drawn_so() {
    let run = Run::of(&small_with_design(
        "[design]\nkind = \"grid\"\n[design.axes]\n\
         surface_speed_rpm = { from = 0.02, to = 2, count = 5, spacing = \"log\" }\n\
         weight_on_bit_kn = { values = [30, 70] }\n\
         [map]\nx = \"surface_speed_rpm\"\n",
    ));
    let svg = std::fs::read_to_string(run.place.path("results/map.svg")).unwrap();
    let place_of = |number: &str| -> f64 {
        let mut texts = svg.split("<text ").skip(1);
        let text = texts.find(|text| text.contains(&format!(">{number}</text>")));
        let (_, after) = text.expect(number).split_once("x=\"").unwrap();
        after.split('"').next().unwrap().parse().unwrap()
    };
    let [low, middle, high] = ["0.02", "0.2", "2"].map(place_of);
    assert!(middle - low > 5.0, "{low} {middle} {high}");
    assert!(
        (high - middle - (middle - low)).abs() < 0.2,
        "{low} {middle} {high}"
    );
    let [low, middle, high] = places_across(&run)[..] else {
        panic!("three places");
    };
    assert!((high - 2.0 * middle + low).abs() < 1e-9 && low > 0.0 && high < 1.0);
    let refused = (run.place).sweep(&["plot", "results", "--x-range", "0..1"]);
    assert_eq!(refused.code, 2, "{refused:?}");
    assert!(
        refused
            .errors
            .contains("--x-range: a logarithmic axis begins above zero")
    );
}

/// Without a title a map has the name of its file, in words.
#[test]
fn a_map_without_a_title_has_the_words_of_its_file() {
    let untitled = with(SMALL, "title = \"A small sweep\"\n", "");
    let place = Workplace::new();
    std::fs::write(place.path("my_first-well.toml"), untitled).unwrap();
    let answer = place.sweep(&["run", "my_first-well.toml", "--out", "results"]);
    assert_eq!(answer.code, 0, "{answer:?}");
    let svg = std::fs::read_to_string(place.path("results/map.svg")).unwrap();
    assert!(svg.contains("My first-well"), "{}", &svg[..2000]);
}
