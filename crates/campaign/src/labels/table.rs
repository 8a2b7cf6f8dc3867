//! `labels.csv` as it is written: one row per case and method, tidy.

use sim::Outcome;

use crate::plan::Sweep;
use crate::quantities::Axis;
use crate::records::{
    COLUMNS, Certainty, Field, Group, Kind, Record, RecordRow, ResultColumn, certainty, certified,
};
use crate::sweep_file::StartName;

/// Groups before the columns of what cases are held against, and those after.
const BEFORE_MISFITS: [Group; 9] = [
    Group::Always,
    Group::Cutting,
    Group::Lying,
    Group::Shocks,
    Group::Stress,
    Group::Surface,
    Group::String,
    Group::Motor,
    Group::Wall,
];
const AFTER_MISFITS: [Group; 3] = [Group::Certificate, Group::Starts, Group::Found];

/// What the rows of a `labels.csv` have in common.
pub struct LabelTable<'a> {
    /// Names of the methods, in the sweep's order.
    pub methods: Vec<&'a str>,
    /// What differs between the cases.
    pub axes: &'a [Axis],
    /// Whether T_d has a column: it has where it follows from an axis and is not an axis itself.
    pub shows_torque: bool,
    /// Whether the bit cuts what its blades leave.
    pub shows_cutting: bool,
    /// Whether the string lies in its hole.
    pub shows_lying: bool,
    /// Whether accelerations are measured.
    pub shows_shocks: bool,
    /// Whether bending and stress are measured.
    pub shows_stress: bool,
    /// Whether what turns the surface is followed.
    pub shows_surface: bool,
    /// Whether the torque along the string is followed.
    pub shows_string_torque: bool,
    /// Whether the bit turns below a mud motor.
    pub shows_motor: bool,
    /// Whether the string has walls.
    pub shows_wall: bool,
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
            shows_cutting: sweep.setting.cutting.is_some(),
            shows_lying: shows_lying(sweep),
            shows_shocks: shows_shocks(sweep),
            shows_stress: sweep.content.measures_stress(),
            shows_surface: shows_surface(sweep),
            shows_string_torque: shows_string_torque(sweep),
            shows_motor: sweep.setting.motor.is_some(),
            shows_wall: sweep.setting.lateral.is_some(),
            misfits: (sweep.data.comparisons.iter())
                .map(|comparison| comparison.column.as_str())
                .collect(),
            certifying: sweep.certifying,
            shows_starts: sweep.starts.name == StartName::Both,
            shows_found: shows_found(sweep),
        }
    }

    /// Whether it has the columns of a group.
    fn shows(&self, group: Group) -> bool {
        match group {
            Group::Always => true,
            Group::Cutting => self.shows_cutting,
            Group::Lying => self.shows_lying,
            Group::Shocks => self.shows_shocks,
            Group::Stress => self.shows_stress,
            Group::Surface => self.shows_surface,
            Group::String => self.shows_string_torque,
            Group::Motor => self.shows_motor,
            Group::Wall => self.shows_wall,
            Group::Certificate => self.certifying.is_some(),
            Group::Starts => self.shows_starts,
            Group::Found => self.shows_found,
        }
    }

    /// Its columns of some groups.
    fn of_groups<const N: usize>(
        &self,
        groups: [Group; N],
    ) -> impl Iterator<Item = &'static ResultColumn> {
        let shown = groups.map(|group| Some(group).filter(|group| self.shows(*group)));
        COLUMNS
            .iter()
            .filter(move |column| shown.contains(&Some(column.group)))
    }

    /// The columns, each with what it holds.
    pub fn columns(&self) -> Vec<(String, Kind)> {
        let number = |axis: Axis| (axis.name(), Kind::Number);
        let result = |column: &ResultColumn| (column.name.to_owned(), column.kind);
        let mut columns = vec![
            ("case".to_owned(), Kind::Count),
            ("method".to_owned(), Kind::Text),
        ];
        columns.extend(self.axes.iter().copied().map(number));
        columns.extend(self.shows_torque.then(|| number(Axis::TorqueDynamicNm)));
        columns.extend(self.of_groups(BEFORE_MISFITS).map(result));
        let misfits = self.misfits.iter();
        columns.extend(misfits.map(|&column| (column.to_owned(), Kind::Number)));
        columns.extend(self.of_groups(AFTER_MISFITS).map(result));
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
                outcome.map(Outcome::labels).unwrap_or_default()
            });
            labels
                .map(|labels| certainty(labels, certified))
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
        let row = RecordRow::new(record, certainty);
        let result = |column: &ResultColumn| column.field(&row);
        let mut fields = vec![record.case.into(), self.methods[record.method].into()];
        fields.extend(record.values.iter().map(|&value| Field::from(value)));
        if self.shows_torque {
            fields.push(record.torque_dynamic_nm.into());
        }
        fields.extend(self.of_groups(BEFORE_MISFITS).map(result));
        let misfit = |place: usize| record.misfits.get(place).copied().flatten();
        fields.extend((0..self.misfits.len()).map(|place| Field::from(misfit(place))));
        fields.extend(self.of_groups(AFTER_MISFITS).map(result));
        fields
    }
}

/// Whether T_d has a column in the table of a sweep.
pub fn shows_torque(sweep: &Sweep) -> bool {
    sweep.bit.is_some() && !sweep.design.axes().contains(&Axis::TorqueDynamicNm)
}

/// Whether what turns the surface has columns in the table of a sweep.
pub fn shows_surface(sweep: &Sweep) -> bool {
    sweep.content.surface_torque || sweep.content.follows_surface()
}

/// Whether the string of a sweep lies in its hole.
pub fn shows_lying(sweep: &Sweep) -> bool {
    sweep.setting.lying.is_some()
}

/// Whether accelerations are measured in a sweep.
pub fn shows_shocks(sweep: &Sweep) -> bool {
    let lateral = sweep.setting.lateral.as_ref();
    lateral.is_some_and(|lateral| lateral.shocks.is_some())
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
