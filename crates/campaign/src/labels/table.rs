//! `labels.csv` as it is written: one row per case and method, tidy.

use sim::{Label, LateralMeasures, TorsionMeasures, TorsionRegime};

use super::certainty::Certainty;
use super::field::{Field, Kind};
use super::motion::Labels;
use crate::engine::{Record, Verdict, certified};
use crate::plan::{Sweep, to_rpm};
use crate::quantities::Axis;
use crate::sweep_file::StartName;

/// Columns that follow the axes.
const RESULT_COLUMNS: [(&str, Kind); 23] = [
    ("torsion", Kind::Text),
    ("lateral", Kind::Text),
    ("first_slip_s", Kind::Number),
    ("period_s", Kind::Number),
    ("slip_time_s", Kind::Number),
    ("sticks", Kind::Count),
    ("bit_speed_peak_rpm", Kind::Number),
    ("bit_speed_closing_rpm", Kind::Number),
    ("stick_slip_severity", Kind::Number),
    ("stick_slip_margin_rpm", Kind::Number),
    ("site_from_bit_m", Kind::Number),
    ("first_contact_s", Kind::Number),
    ("peak_radius_mm", Kind::Number),
    ("mean_radius_mm", Kind::Number),
    ("contact_fraction", Kind::Number),
    ("rolling_fraction", Kind::Number),
    ("precession_turns_per_s", Kind::Number),
    ("normal_force_mean_kn", Kind::Number),
    ("ambiguous_steps", Kind::Count),
    ("predicted", Kind::Text),
    ("simulated_s", Kind::Number),
    ("ended", Kind::Text),
    ("status", Kind::Text),
];

/// Columns of what turns the surface, where that is followed.
const SURFACE_COLUMNS: [(&str, Kind); 4] = [
    ("surface_torque_peak_nm", Kind::Number),
    ("surface_torque_least_nm", Kind::Number),
    ("surface_torque_mean_nm", Kind::Number),
    ("surface_torque_greatest_nm", Kind::Number),
];

/// Columns of the greatest torque along the string, where that is followed.
const STRING_COLUMNS: [(&str, Kind); 2] = [
    ("string_torque_peak_nm", Kind::Number),
    ("string_torque_peak_from_bit_m", Kind::Number),
];

/// Columns of what is certain, where labels are certified: what the method says by shorter
/// steps, as far as it matters to that, and whether the labels of the row are certain.
const CERTIFICATE_COLUMNS: [(&str, Kind); 8] = [
    ("finer_torsion", Kind::Text),
    ("finer_lateral", Kind::Text),
    ("finer_stick_slip_margin_rpm", Kind::Number),
    ("finer_contact_fraction", Kind::Number),
    ("finer_precession_turns_per_s", Kind::Number),
    ("torsion_certified", Kind::Flag),
    ("lateral_certified", Kind::Flag),
    ("nearby_torsion_agrees", Kind::Flag),
];

/// Columns of how the bit turns from each start, where cases begin in both ways.
const START_COLUMNS: [(&str, Kind); 2] = [
    ("torsion_from_stuck", Kind::Text),
    ("torsion_from_smooth", Kind::Text),
];

/// Columns of the sites that a case was found to have besides those of the file, with `;` between
/// them, and of how often it was run again for them.
pub const FOUND_COLUMNS: [(&str, Kind); 2] = [
    ("found_sites_from_bit_m", Kind::Text),
    ("found_rounds", Kind::Count),
];

/// The status of a case with an answer.
const DONE: &str = "ok";
/// That of one without.
pub const FAILED: &str = "failed";

/// How many of the columns are measures of torsion.
pub const TORSION_COLUMNS: usize = 7;
/// How many are those of lateral motion.
pub const LATERAL_COLUMNS: usize = 9;

/// What the rows of a `labels.csv` have in common.
pub struct LabelTable<'a> {
    /// Names of the methods, in the sweep's order.
    pub methods: Vec<&'a str>,
    /// What differs between the cases.
    pub axes: &'a [Axis],
    /// Whether T_d has a column: it has where it follows from an axis and is none itself.
    pub shows_torque: bool,
    /// Whether what turns the surface is followed.
    pub shows_surface: bool,
    /// Whether the torque along the string is followed.
    pub shows_string_torque: bool,
    /// Columns of what cases are held against.
    pub misfits: Vec<&'a str>,
    /// The places of the methods that certify labels, where any do.
    pub certifying: Option<[usize; 2]>,
    /// Whether cases begin in both ways.
    pub shows_starts: bool,
    /// Whether sites are found.
    pub shows_found: bool,
}

impl<'a> LabelTable<'a> {
    /// That of a sweep.
    pub fn of(sweep: &'a Sweep) -> Self {
        Self {
            methods: sweep.methods.iter().map(|method| method.name()).collect(),
            axes: sweep.design.axes(),
            shows_torque: shows_torque(sweep),
            shows_surface: shows_surface(sweep),
            shows_string_torque: shows_string_torque(sweep),
            misfits: (sweep.data.comparisons.iter())
                .map(|comparison| comparison.column.as_str())
                .collect(),
            certifying: sweep.certifying,
            shows_starts: sweep.starts.name == StartName::Both,
            shows_found: shows_found(sweep),
        }
    }

    /// The columns, each with what it holds.
    pub fn columns(&self) -> Vec<(String, Kind)> {
        let number = |axis: Axis| (axis.name(), Kind::Number);
        let mut columns = vec![
            ("case".to_owned(), Kind::Count),
            ("method".to_owned(), Kind::Text),
        ];
        columns.extend(self.axes.iter().copied().map(number));
        columns.extend(self.shows_torque.then(|| number(Axis::TorqueDynamicNm)));
        let mut add = |known: &[(&str, Kind)], is_shown: bool| {
            let shown = known.iter().filter(|_| is_shown);
            columns.extend(shown.map(|&(name, kind)| (name.to_owned(), kind)));
        };
        add(&RESULT_COLUMNS, true);
        add(&SURFACE_COLUMNS, self.shows_surface);
        add(&STRING_COLUMNS, self.shows_string_torque);
        let misfits = self.misfits.iter().map(|&column| (column, Kind::Number));
        add(&misfits.collect::<Vec<_>>(), true);
        add(&CERTIFICATE_COLUMNS, self.certifying.is_some());
        add(&START_COLUMNS, self.shows_starts);
        add(&FOUND_COLUMNS, self.shows_found);
        columns
    }

    /// The first line.
    pub fn header(&self) -> String {
        let names: Vec<String> = self.columns().into_iter().map(|(name, _)| name).collect();
        names.join(",")
    }

    /// What is certain of each of some records, in which those of a case follow one another.
    pub fn certainties(&self, records: &[Record]) -> Vec<Certainty> {
        let Some(places) = self.certifying else {
            return vec![Certainty::default(); records.len()];
        };
        let cases = records.chunk_by(|one, next| one.case == next.case);
        let of_case = |case: &[Record]| {
            let certified = certified(case, places);
            let labels = case.iter().map(|record| {
                let outcome = record.outcome.as_ref();
                outcome.map(Labels::of).unwrap_or_default()
            });
            labels
                .map(|labels| Certainty::of(labels, certified))
                .collect::<Vec<_>>()
        };
        cases.flat_map(of_case).collect()
    }

    /// A row. No field of it needs quotes: they are names and numbers.
    pub fn row(&self, record: &Record, certainty: Certainty) -> String {
        let fields = self.fields(record, certainty);
        let texts: Vec<String> = fields.iter().map(Field::to_string).collect();
        texts.join(",")
    }

    /// The fields of a row, one for each column.
    pub fn fields(&self, record: &Record, certainty: Certainty) -> Vec<Field<'a>> {
        let mut row = Row(Vec::new());
        row.add(record.case);
        row.add(self.methods[record.method]);
        record.values.iter().for_each(|&value| row.add(value));
        if self.shows_torque {
            row.add_optional(record.torque_dynamic_nm);
        }
        let done = record.outcome.as_ref().ok();
        let torsion = done.and_then(|outcome| outcome.torsion.as_ref());
        let lateral = done.and_then(|outcome| outcome.lateral.as_ref());
        row.add_optional(torsion.map(|torsion| torsion.regime.name()));
        row.add_optional(lateral.map(|lateral| lateral.regime.name()));
        row.add_torsion(torsion);
        row.add_optional(record.above_limit.map(to_rpm));
        row.add_lateral(lateral, record.site_from_bit_m);
        row.add_optional(done.and_then(|outcome| outcome.predicted).map(Label::name));
        row.add_optional(done.map(|outcome| outcome.simulated));
        row.add_optional(done.map(|outcome| outcome.ended.name()));
        row.add(if done.is_some() { DONE } else { FAILED });
        if self.shows_surface {
            let surface = done.and_then(|outcome| outcome.surface);
            row.add_optional(surface.map(|it| it.peak_torque));
            row.add_optional(surface.map(|it| it.least_torque));
            row.add_optional(surface.map(|it| it.mean_torque));
            row.add_optional(surface.map(|it| it.greatest_torque));
        }
        if self.shows_string_torque {
            let along = done.and_then(|outcome| outcome.string_torque);
            row.add_optional(along.map(|it| it.peak_torque));
            row.add_optional(along.map(|it| it.from_bit));
        }
        for index in 0..self.misfits.len() {
            row.add_optional(record.misfits.get(index).copied().flatten());
        }
        if self.certifying.is_some() {
            row.add_finer(&record.finer.unwrap_or_default());
            row.add_optional(certainty.torsion);
            row.add_optional(certainty.lateral);
            row.add_optional(record.agrees_nearby);
        }
        if self.shows_starts {
            let by_start = record.by_start;
            row.add_optional(by_start.map(|it| it.stuck.name()));
            row.add_optional(by_start.map(|it| it.smooth.name()));
        }
        if self.shows_found {
            let found = record.found.as_ref();
            let sites = found.map(|found| found.sites.iter().map(f64::to_string));
            let sites: Vec<String> = sites.into_iter().flatten().collect();
            row.add(sites.join(";"));
            row.add_optional(found.map(|found| found.rounds));
        }
        row.0
    }
}

/// Whether T_d has a column in the table of a sweep.
pub fn shows_torque(sweep: &Sweep) -> bool {
    sweep.bit.is_some() && !sweep.design.axes().contains(&Axis::TorqueDynamicNm)
}

/// Whether what turns the surface has columns in the table of a sweep.
pub fn shows_surface(sweep: &Sweep) -> bool {
    sweep.content.surface_torque || sweep.setting.friction.is_some()
}

/// Whether the sites of a sweep are found case by case.
pub fn shows_found(sweep: &Sweep) -> bool {
    let lateral = sweep.setting.lateral.as_ref();
    lateral.is_some_and(|lateral| lateral.finding.is_some())
}

/// Whether the torque along the string is followed in a sweep.
pub fn shows_string_torque(sweep: &Sweep) -> bool {
    let friction = sweep.setting.friction.as_ref();
    friction.is_some_and(|friction| friction.follows_torque)
}

/// A row being written.
struct Row<'a>(Vec<Field<'a>>);

impl<'a> Row<'a> {
    fn add(&mut self, field: impl Into<Field<'a>>) {
        self.0.push(field.into());
    }

    fn add_optional(&mut self, field: Option<impl Into<Field<'a>>>) {
        self.0.push(field.map_or(Field::Nothing, Into::into));
    }

    fn add_nothing(&mut self, fields: usize) {
        self.0.extend(std::iter::repeat_n(Field::Nothing, fields));
    }

    fn add_torsion(&mut self, torsion: Option<&TorsionMeasures>) {
        let Some(torsion) = torsion else {
            return self.add_nothing(TORSION_COLUMNS);
        };
        self.add_optional(torsion.first_slip);
        self.add_optional(torsion.period);
        self.add_optional(torsion.slip_time);
        self.add(torsion.sticks);
        self.add(to_rpm(torsion.peak_speed));
        self.add(to_rpm(torsion.closing_speed));
        self.add_optional(torsion.severity);
    }

    fn add_lateral(&mut self, lateral: Option<&LateralMeasures>, site_from_bit_m: Option<f64>) {
        let Some(lateral) = lateral else {
            return self.add_nothing(LATERAL_COLUMNS);
        };
        self.add_optional(site_from_bit_m);
        self.add_optional(lateral.first_contact);
        self.add(to_mm(lateral.peak_radius));
        self.add(to_mm(lateral.mean_radius));
        self.add(lateral.contact_fraction);
        self.add(lateral.rolling_fraction);
        self.add(to_turns(lateral.precession_rate));
        self.add(to_kn(lateral.mean_normal_force));
        self.add(lateral.ambiguous_steps);
    }

    /// What decides the labels by shorter steps.
    fn add_finer(&mut self, finer: &Verdict) {
        let lateral = finer.lateral.as_ref();
        self.add_optional(finer.torsion.map(TorsionRegime::name));
        self.add_optional(lateral.map(|it| it.regime.name()));
        self.add_optional(finer.above_limit.map(to_rpm));
        self.add_optional(lateral.map(|it| it.contact_fraction));
        self.add_optional(lateral.map(|it| to_turns(it.precession_rate)));
    }
}

/// A metre in mm.
pub fn to_mm(length: f64) -> f64 {
    1e3 * length
}

/// A newton in kN.
pub fn to_kn(force: f64) -> f64 {
    1e-3 * force
}

/// A radian per second in turns per second.
pub fn to_turns(rate: f64) -> f64 {
    rate / std::f64::consts::TAU
}
