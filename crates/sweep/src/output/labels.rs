//! `labels.csv` as it is written: one row per case and method, tidy.

use std::fmt::{Display, Write};

use sim::{Label, LateralMeasures, TorsionMeasures, TorsionRegime};

use super::certainty::Certainty;
use super::motion::Labels;
use crate::engine::{Record, Verdict, certified};
use crate::plan::{Sweep, to_rpm};
use crate::quantities::Axis;

/// Columns that follow the axes.
const RESULT_COLUMNS: [&str; 23] = [
    "torsion",
    "lateral",
    "first_slip_s",
    "period_s",
    "slip_time_s",
    "sticks",
    "bit_speed_peak_rpm",
    "bit_speed_closing_rpm",
    "stick_slip_severity",
    "stick_slip_margin_rpm",
    "site_from_bit_m",
    "first_contact_s",
    "peak_radius_mm",
    "mean_radius_mm",
    "contact_fraction",
    "rolling_fraction",
    "precession_turns_per_s",
    "normal_force_mean_kn",
    "ambiguous_steps",
    "predicted",
    "simulated_s",
    "ended",
    "status",
];

/// Columns of what turns the surface, where that is followed.
const SURFACE_COLUMNS: [&str; 4] = [
    "surface_torque_peak_nm",
    "surface_torque_least_nm",
    "surface_torque_mean_nm",
    "surface_torque_greatest_nm",
];

/// Columns of the greatest torque along the string, where that is followed.
const STRING_COLUMNS: [&str; 2] = ["string_torque_peak_nm", "string_torque_peak_from_bit_m"];

/// Columns of what is certain, where labels are certified: what the method says by shorter
/// steps, as far as it matters to that, and whether the labels of the row are certain.
const CERTIFICATE_COLUMNS: [&str; 7] = [
    "finer_torsion",
    "finer_lateral",
    "finer_stick_slip_margin_rpm",
    "finer_contact_fraction",
    "finer_precession_turns_per_s",
    "torsion_certified",
    "lateral_certified",
];

/// Columns of the sites that a case was found to have besides those of the file, with `;` between
/// them, and of how often it was run again for them.
pub(super) const FOUND_COLUMNS: [&str; 2] = ["found_sites_from_bit_m", "found_rounds"];

/// The status of a case with an answer, and of one without.
const DONE: &str = "ok";
pub(super) const FAILED: &str = "failed";

/// How many of the columns are measures of torsion, and of lateral motion.
pub(super) const TORSION_COLUMNS: usize = 7;
pub(super) const LATERAL_COLUMNS: usize = 9;

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
            shows_found: shows_found(sweep),
        }
    }

    /// The first line.
    pub fn header(&self) -> String {
        let mut header = vec!["case".to_owned(), "method".to_owned()];
        header.extend(self.axes.iter().map(|axis| axis.name()));
        header.extend(self.shows_torque.then(|| Axis::TorqueDynamicNm.name()));
        header.extend(RESULT_COLUMNS.map(str::to_owned));
        if self.shows_surface {
            header.extend(SURFACE_COLUMNS.map(str::to_owned));
        }
        if self.shows_string_torque {
            header.extend(STRING_COLUMNS.map(str::to_owned));
        }
        header.extend(self.misfits.iter().map(|&column| column.to_owned()));
        if self.certifying.is_some() {
            header.extend(CERTIFICATE_COLUMNS.map(str::to_owned));
        }
        if self.shows_found {
            header.extend(FOUND_COLUMNS.map(str::to_owned));
        }
        header.join(",")
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
        let mut row = Row(record.case.to_string());
        row.add(self.methods[record.method]);
        record.values.iter().for_each(|value| row.add(value));
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
pub(super) fn shows_torque(sweep: &Sweep) -> bool {
    sweep.bit.is_some() && !sweep.design.axes().contains(&Axis::TorqueDynamicNm)
}

/// Whether what turns the surface has columns in the table of a sweep.
pub(super) fn shows_surface(sweep: &Sweep) -> bool {
    sweep.content.surface_torque || sweep.setting.friction.is_some()
}

/// Whether the sites of a sweep are found case by case.
pub(super) fn shows_found(sweep: &Sweep) -> bool {
    let lateral = sweep.setting.lateral.as_ref();
    lateral.is_some_and(|lateral| lateral.finding.is_some())
}

/// Whether the torque along the string is followed in a sweep.
pub(super) fn shows_string_torque(sweep: &Sweep) -> bool {
    let friction = sweep.setting.friction.as_ref();
    friction.is_some_and(|friction| friction.follows_torque)
}

/// A row being written.
struct Row(String);

impl Row {
    fn add(&mut self, field: impl Display) {
        // A string takes all that is written into it.
        let _ = write!(self.0, ",{field}");
    }

    fn add_optional(&mut self, field: Option<impl Display>) {
        match field {
            Some(field) => self.add(field),
            None => self.add(""),
        }
    }

    fn add_torsion(&mut self, torsion: Option<&TorsionMeasures>) {
        let Some(torsion) = torsion else {
            return self.0.extend([','; TORSION_COLUMNS]);
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
            return self.0.extend([','; LATERAL_COLUMNS]);
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
pub(super) fn to_mm(length: f64) -> f64 {
    1e3 * length
}

/// A newton in kN.
pub(super) fn to_kn(force: f64) -> f64 {
    1e-3 * force
}

/// A radian per second in turns per second.
pub(super) fn to_turns(rate: f64) -> f64 {
    rate / std::f64::consts::TAU
}
