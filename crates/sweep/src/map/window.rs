//! An operating window: how far each part of weight and speed is from its limits, the safe
//! regions by their names, and the best point.

use super::contour::contour;
use super::mesh::Mesh;
use super::shown::show_in;
use super::words;
use campaign::quantities::{RATE, Units};
use campaign::words::short;
use plot::colours::BLUE;
use plot::{
    self, Band, CellFill, LineStyle, Look, MapChart, MapGroup, MapPanel, Mark, Picture, Safety,
    Series, map_chart,
};
use results::window::{AXES, Best, Chart, Drawn, Limit, Region, Room, Standing};

/// Safe regions that are a smaller part of the map have no name.
const LEAST_SHARE: f64 = 0.005;

/// The part of the weights at which the names of ranges of speed stand.
const NAMES_AT: f64 = 0.12;

/// About how many lines of equal rates of penetration there are.
const RATE_LINES: f64 = 8.0;

/// What regions are called.
const NAMES: [&str; 6] = ["A", "B", "C", "D", "E", "F"];

/// What is drawn.
pub struct WindowView<'a> {
    /// Title above all.
    pub title: String,
    /// What its numbers are shown in.
    pub units: Units,
    /// The limits.
    pub chart: &'a Chart,
    /// Where all are clear, the largest first.
    pub regions: Vec<Region>,
    /// The best point, where one is safe.
    pub best: Option<Best>,
    /// The part of either axis by which that should be away from every limit.
    pub clearance: f64,
    /// What may shake the string and has no limit here.
    pub not_examined: Vec<String>,
    /// How often words of safety were wrong for such strings.
    pub how_often_wrong: Vec<String>,
}

/// Draws an operating window.
pub fn window_picture(of: &WindowView) -> Picture {
    let chart = of.chart;
    let mesh = Mesh::between(chart.edges.clone());
    let rates = rate_lines(chart, of.units);
    let best = of.best.iter().map(|best| Mark {
        name: format!("best: {}", of.place(best.at)),
        at: (best.at[0], best.at[1]),
    });
    let panel = MapPanel {
        cells: mesh.joined(|cell| Some(fill(chart.standing(cell)))),
        lines: (chart.limits.iter().filter_map(|it| line(chart, it)))
            .chain(rates.iter().map(|rate| rate.series(of.units)))
            .collect(),
        bands: chart
            .limits
            .iter()
            .flat_map(|it| bands(chart, it))
            .collect(),
        names: (of.named_regions())
            .map(|(name, region)| of.name_of(name, region))
            .chain(chart.limits.iter().flat_map(|it| names_of_bands(chart, it)))
            .chain(rates.iter().filter_map(RateLine::name))
            .collect(),
        ..MapPanel::default()
    };
    let mut chart = MapChart {
        title: of.title.clone(),
        axes: AXES.map(|axis| plot::Axis::linear(axis.title(of.units))),
        marks: best.collect(),
        groups: vec![MapGroup {
            heading: String::new(),
            scale: None,
            keys: keys(chart),
            notes: Vec::new(),
            below: [
                of.regions(),
                of.best(),
                of.limits(),
                of.not_examined(),
                of.how_often_wrong(),
            ]
            .concat(),
            panels: vec![panel],
        }],
    };
    show_in(&mut chart, AXES.map(|axis| axis.unit(of.units)));
    map_chart(&Look::default(), &chart)
}

fn fill(standing: Standing) -> CellFill {
    match standing {
        Standing::Clear => CellFill::Safety(Safety::Safe),
        Standing::Possible => CellFill::Safety(Safety::Conditional),
        Standing::Near => CellFill::Safety(Safety::Near),
        Standing::Against => CellFill::Safety(Safety::Unsafe),
        Standing::Undetermined => CellFill::NoCase,
    }
}

/// The fills that are on the map.
fn keys(chart: &Chart) -> Vec<(CellFill, String)> {
    let all = [
        (Standing::Clear, "safe: beyond the margin of every limit"),
        (
            Standing::Possible,
            "safe unless whirl is triggered, which may last here",
        ),
        (Standing::Near, "within the margin of a limit"),
        (Standing::Against, "on the wrong side of a limit"),
        (
            Standing::Undetermined,
            "not known: no answer, or stuck to the end",
        ),
    ];
    let is_there = |standing| chart.cells().any(|cell| chart.standing(cell) == standing);
    let there = all.into_iter().filter(|(standing, _)| is_there(*standing));
    there
        .map(|(standing, text)| (fill(standing), text.to_owned()))
        .collect()
}

/// A limit as a line: around where it is passed beyond its margin, or as it is known.
fn line(chart: &Chart, limit: &Limit) -> Option<Series> {
    let pieces = match &limit.drawn {
        Drawn::Edge => edge(chart, limit),
        // Others would have a name in the legend and nothing on the map.
        Drawn::Lines(lines) => {
            let on_map = lines.iter().filter(|line| touches(chart, line));
            on_map.cloned().collect()
        }
        Drawn::Bands(_) => Vec::new(),
    };
    let gap = std::iter::once((f64::NAN, f64::NAN));
    let points = pieces.into_iter().flat_map(|piece| {
        let points = piece.into_iter().map(|[weight, speed]| (weight, speed));
        points.chain(gap.clone()).collect::<Vec<_>>()
    });
    let points: Vec<_> = points.collect();
    (!points.is_empty()).then(|| Series {
        name: limit.name.clone(),
        style: LineStyle::default(),
        points,
    })
}

/// Whether the box around a line has a part in the map.
fn touches(chart: &Chart, line: &[[f64; 2]]) -> bool {
    [0, 1].iter().all(|&axis: &usize| {
        let [least, most] = chart.range(axis);
        let values = line.iter().map(|point| point[axis]);
        let lowest = values.clone().fold(f64::INFINITY, f64::min);
        let highest = values.fold(f64::NEG_INFINITY, f64::max);
        lowest <= most && highest >= least
    })
}

/// Lines around what is against, or not known.
fn edge(chart: &Chart, limit: &Limit) -> Vec<Vec<[f64; 2]>> {
    let against = |standing: &Standing| match standing {
        Standing::Clear | Standing::Possible => Some(0.0),
        Standing::Near => Some(0.5),
        Standing::Against | Standing::Undetermined => Some(1.0),
    };
    let values: Vec<Option<f64>> = limit.standings.iter().map(against).collect();
    lines_at(chart, &values, 0.75)
}

/// Lines at which a value of cells has a level, by weights and speeds.
fn lines_at(chart: &Chart, values: &[Option<f64>], level: f64) -> Vec<Vec<[f64; 2]>> {
    let middle = |axis: usize, place: f64| {
        let edges = &chart.edges[axis];
        let middle = |cell: usize| 0.5 * (edges[cell] + edges[cell + 1]);
        let below = (place as usize).min(edges.len() - 2);
        let above = (below + 1).min(edges.len() - 2);
        middle(below) + (place - below as f64) * (middle(above) - middle(below))
    };
    let lines = contour(chart.size(), values, level).into_iter();
    let lines = lines.map(|line| {
        let points = line.into_iter();
        points
            .map(|[column, row]| [middle(0, column), middle(1, row)])
            .collect()
    });
    lines.collect()
}

/// Where the rate of penetration has a level.
struct RateLine {
    /// In the unit in which it is shown.
    level: f64,
    lines: Vec<Vec<[f64; 2]>>,
}

/// Lines of equal rates at round numbers.
fn rate_lines(chart: &Chart, units: Units) -> Vec<RateLine> {
    let unit = units.of(&RATE);
    let rates: Vec<Option<f64>> = (chart.rates.iter())
        .map(|rate| rate.map(|rate| unit.number(rate)))
        .collect();
    let most = rates.iter().flatten().copied().fold(0.0, f64::max);
    round_levels(most)
        .into_iter()
        .map(|level| RateLine {
            lines: lines_at(chart, &rates, level),
            level,
        })
        .collect()
}

/// About as many levels as a map has room for, up to the greatest value.
fn round_levels(most: f64) -> Vec<f64> {
    if most <= 0.0 {
        return Vec::new();
    }
    let raw = most / RATE_LINES;
    let decade = 10f64.powf(raw.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].map(|digit| digit * decade);
    let step = step.into_iter().find(|step| *step >= raw).unwrap_or(raw);
    let count = (most / step) as usize;
    (1..=count).map(|level| level as f64 * step).collect()
}

impl RateLine {
    fn series(&self, units: Units) -> Series {
        let gap = [(f64::NAN, f64::NAN)];
        let points = self.lines.iter().flat_map(|line| {
            let points = line.iter().map(|&[weight, speed]| (weight, speed));
            points.chain(gap)
        });
        Series {
            name: format!("rate of penetration ({})", units.of(&RATE).name),
            style: LineStyle::coloured(BLUE),
            points: points.collect(),
        }
    }

    /// The level on its longest line.
    fn name(&self) -> Option<Mark> {
        let longest = self.lines.iter().max_by_key(|line| line.len())?;
        let [weight, speed] = longest[longest.len() / 2];
        Some(Mark {
            name: short(self.level),
            at: (weight, speed),
        })
    }
}

/// Ranges of speed within the map, with their names.
fn ranges<'a>(chart: &Chart, limit: &'a Limit) -> Vec<([f64; 2], &'a str)> {
    let Drawn::Bands(ranges) = &limit.drawn else {
        return Vec::new();
    };
    let [slowest, fastest] = chart.range(1);
    let inside = |speeds: [f64; 2]| speeds.map(|speed| speed.clamp(slowest, fastest));
    (ranges
        .iter()
        .map(|(speeds, name)| (inside(*speeds), name.as_str())))
    .collect()
}

fn bands(chart: &Chart, limit: &Limit) -> Vec<Band> {
    let band = |(speeds, _)| Band {
        name: limit.name.clone(),
        ends: [chart.range(0), speeds],
    };
    ranges(chart, limit).into_iter().map(band).collect()
}

/// The name of each range of a limit, inside it.
fn names_of_bands(chart: &Chart, limit: &Limit) -> Vec<Mark> {
    let [least, most] = chart.range(0);
    let name = |([from, to], name): ([f64; 2], &str)| Mark {
        name: name.to_owned(),
        at: (least + NAMES_AT * (most - least), 0.5 * (from + to)),
    };
    ranges(chart, limit).into_iter().map(name).collect()
}

/// What the chart shows, in words.
impl WindowView<'_> {
    /// Each limit, and how much of the map it takes.
    pub fn limits(&self) -> Vec<String> {
        let in_words = |limit: &Limit| {
            let mut parts = Vec::new();
            for (standing, what) in [
                (Standing::Against, "of the map on its wrong side"),
                (Standing::Possible, "of the map, if triggered"),
                (Standing::Near, "within its margin"),
                (Standing::Undetermined, "not known"),
            ] {
                let part = self.chart.part(limit, standing);
                if part > 0.0 {
                    parts.push(format!("{} {what}", percent(part)));
                }
            }
            if parts.is_empty() {
                parts.push("not reached anywhere on the map".to_owned());
            }
            format!(
                "{}: {} ({})",
                limit.name,
                parts.join(", "),
                limit.description
            )
        };
        self.chart.limits.iter().map(in_words).collect()
    }

    /// The safe regions that have names.
    pub fn regions(&self) -> Vec<String> {
        if self.regions.is_empty() {
            return vec!["nothing on the map is safe".to_owned()];
        }
        let in_words = |(name, region): (&str, &Region)| {
            let [weights, speeds] =
                [0, 1].map(|axis| words::ends(AXES[axis], region.ends[axis], self.units));
            let share = percent(region.share);
            let clear = match region.clear {
                clear if clear > 0.999 * region.share => String::new(),
                0.0 => ", though whirl, if triggered, could last in all of it".to_owned(),
                clear => format!(", {} where whirl could not even last", percent(clear)),
            };
            format!("safe region {name}: {share} of the map{clear}, within {weights} and {speeds}")
        };
        let mut all: Vec<String> = self.named_regions().map(in_words).collect();
        let others = self.regions.len() - all.len();
        if others > 0 {
            let plural = if others == 1 { "" } else { "s" };
            all.push(format!("and {others} smaller one{plural}"));
        }
        all
    }

    /// The best point, why it is, and what is around it.
    pub fn best(&self) -> Vec<String> {
        let Some(best) = &self.best else {
            return Vec::new();
        };
        let place = self.place(best.at);
        let (asked, own) = (percent(self.clearance), percent(best.clearance));
        let greatest = match self.chart.rates.is_empty() {
            true => "greatest weight × speed",
            false => "greatest rate of penetration",
        };
        let rule = if best.is_as_asked {
            format!(
                "{greatest} of the points that stay safe when both are off by {asked} \
                 of their axes"
            )
        } else {
            format!(
                "no point stays safe when weight and speed are off by {asked} of their axes; this \
                 one stays so up to {own}"
            )
        };
        let whirl = match best.standing {
            Standing::Clear => "",
            _ => "; safe unless whirl is triggered",
        };
        let at_end = best.is_at_end(self.clearance, self.chart).then(|| {
            "it is at the edge of the map, beyond which nothing is known: extend the map to look \
             further"
                .to_owned()
        });
        let drills = best
            .rate_of_penetration_m_h
            .map_or_else(String::new, |rate| {
                format!(", {}", self.units.of(&RATE).text(rate, 1))
            });
        let point = format!("best point: {place}{drills} ({rule}{whirl})");
        [point, self.room(best)].into_iter().chain(at_end).collect()
    }

    /// What is not on the map.
    pub fn not_examined(&self) -> Vec<String> {
        let in_words = |what: &String| format!("not examined: {what}");
        self.not_examined.iter().map(in_words).collect()
    }

    /// How often words such as safe were wrong.
    pub fn how_often_wrong(&self) -> Vec<String> {
        let in_words = |what: &String| format!("how often wrong: {what}");
        self.how_often_wrong.iter().map(in_words).collect()
    }

    /// How far it is from the best point to what limits it.
    fn room(&self, best: &Best) -> String {
        let [[less, more], [slower, faster]] = &best.room;
        let in_words = |axis: usize, room: &Room, way: &str| {
            let distance = words::quantity(AXES[axis], room.distance, self.units);
            let to = match &room.limits[..] {
                [] => "the end of the map".to_owned(),
                limits => limits.join(" and "),
            };
            format!("{distance} {way} to {to}")
        };
        let all = [
            in_words(0, less, "less"),
            in_words(0, more, "more"),
            in_words(1, slower, "slower"),
            in_words(1, faster, "faster"),
        ];
        format!("around it: {}", all.join("; "))
    }

    fn place(&self, at: [f64; 2]) -> String {
        let [weight, speed] = [0, 1].map(|axis| words::quantity(AXES[axis], at[axis], self.units));
        format!("{weight} at {speed}")
    }

    fn named_regions(&self) -> impl Iterator<Item = (&'static str, &Region)> {
        let large = self
            .regions
            .iter()
            .filter(|region| region.share >= LEAST_SHARE);
        NAMES.into_iter().zip(large)
    }

    fn name_of(&self, name: &str, region: &Region) -> Mark {
        let [weight, speed] = self.chart.middle(self.chart.heart(region));
        Mark {
            name: name.to_owned(),
            at: (weight, speed),
        }
    }
}

fn percent(part: f64) -> String {
    let percent = 100.0 * part;
    let rounded = match percent {
        percent if percent >= 10.0 => percent.round(),
        percent => (10.0 * percent).round() / 10.0,
    };
    match rounded {
        0.0 => "under 0.1 %".to_owned(),
        rounded => format!("{} %", short(rounded)),
    }
}
