//! The sweep that is open, and its cases as they are asked for.

use anyhow::{Context, Result, anyhow};
use campaign::engine::{
    Case, Choice, ChosenCase, FollowedMethod, LimitPoint, MethodSystem, RunOptions, answer,
    common_setting, stick_slip_limit,
};
use campaign::labels::{LabelTable, history_columns};
use campaign::plan::Sweep;
use campaign::quantities::Axis;
use campaign::records::{Certainty, Failure, Record};
use campaign::sweep_file::MethodName;
use linear::estimates::largest_undershoot;
use serde_json::{Map, Value, json};

use crate::request::{CaseAsked, LimitAsked, Request};
use crate::sweep_of::sweep_of;

/// What is answered.
#[derive(Debug, Default)]
pub struct Answer {
    /// JSON: `{"ok": …}` or `{"error": "…"}`. Where there are numbers, `ok.columns` names them.
    pub words: String,
    /// Columns, one after another, all as long.
    pub numbers: Vec<f64>,
}

impl Answer {
    /// An answer that gives only the reason of an error.
    pub fn error(reason: &str) -> Self {
        Self {
            words: json!({ "error": reason }).to_string(),
            numbers: Vec::new(),
        }
    }

    fn ok(words: Value) -> Self {
        Self {
            words: json!({ "ok": words }).to_string(),
            numbers: Vec::new(),
        }
    }

    /// Words with columns of numbers, each named.
    fn with_columns(mut words: Map<String, Value>, columns: Vec<(String, Vec<f64>)>) -> Self {
        let names = columns.iter().map(|(name, _)| name.clone().into());
        words.insert("columns".to_owned(), Value::Array(names.collect()));
        Self {
            numbers: columns.into_iter().flat_map(|(_, values)| values).collect(),
            ..Self::ok(words.into())
        }
    }
}

/// The open sweep, with the linear system of the last case.
#[derive(Default)]
pub struct Engine {
    open: Option<Open>,
}

struct Open {
    sweep: Sweep,
    built: Option<Built>,
}

/// The system of a string by a method.
struct Built {
    /// The sweep with that string.
    sweep: Sweep,
    /// The method's place in its list.
    method: usize,
    /// For how long it was built, s.
    longest: f64,
    system: FollowedMethod,
}

impl Engine {
    /// Answers a request, which is JSON.
    pub fn answer(&mut self, request: &[u8]) -> Answer {
        self.answer_or_say(request)
            .unwrap_or_else(|error| Answer::error(&format!("{error:#}")))
    }

    fn answer_or_say(&mut self, request: &[u8]) -> Result<Answer> {
        let request = serde_json::from_slice(request).context("this cannot be asked")?;
        if let Request::Open(opening) = request {
            let sweep = sweep_of(*opening)?;
            let answer = Answer::ok(description(&sweep));
            self.open = Some(Open { sweep, built: None });
            return Ok(answer);
        }
        let open = self.open.as_mut().context("no sweep is open")?;
        match request {
            Request::Simulate(asked) => open.simulate(&asked),
            Request::Limit(asked) => open.limit(&asked),
            Request::Open(_) => unreachable!("answered above"),
        }
    }
}

/// What a page shows of a sweep.
fn description(sweep: &Sweep) -> Value {
    let methods = sweep.methods.iter().map(|method| method.name());
    let sites = sweep.setting.sites.distances_from_bit();
    let lateral = sweep.setting.lateral.as_ref();
    let clearances = lateral.map(|lateral| lateral.walls.iter().map(|wall| 1e3 * wall.clearance));
    json!({
        "title": sweep.title,
        "methods": methods.collect::<Vec<_>>(),
        "cases": sweep.design.cases(),
        "axes": sweep.design.axes().iter().map(|axis| axis.name()).collect::<Vec<_>>(),
        "sites_from_bit_m": sites,
        "clearances_mm": clearances.map(|all| all.collect::<Vec<_>>()),
    })
}

impl Open {
    fn simulate(&mut self, asked: &CaseAsked) -> Result<Answer> {
        let options = RunOptions {
            full: asked.full,
            // As where `sweep simulate` looks at a case.
            allow_unstable: !self.sweep.design.varies_string(),
        };
        let (built, chosen) = self.built_for(asked)?;
        let found = built.at_found_sites(&chosen, options)?;
        let (built, case, row_found) = match &found {
            Some((built, case, row)) => (built, case, Some(row)),
            None => (built, &chosen.case, None),
        };
        let (row, simulation) =
            (built.system).simulate(&built.sweep, case, built.method, options, true)?;
        let row = row_found.unwrap_or(&row);
        let simulation = simulation.ok_or_else(|| without_answer(&built.sweep, row))?;
        let columns = history_columns(&built.sweep.setting.sites, &simulation.trajectory);
        let columns = columns
            .into_iter()
            .map(|column| (column.name, column.values));
        let mut words = Map::new();
        words.insert("row".to_owned(), row_of(&built.sweep, row));
        Ok(Answer::with_columns(words, columns.collect()))
    }

    /// Eq. 74 along an axis, by the undershoot of the method that is asked for.
    fn limit(&mut self, asked: &LimitAsked) -> Result<Answer> {
        let (built, chosen) = self.built_for(&asked.of)?;
        let taps = built.system.system().driving_point();
        let (bit, taps) =
            (built.sweep.bit.as_ref().zip(taps)).context("no torque acts on the bit")?;
        let values = (asked.axis, asked.values.iter().copied());
        let limit = stick_slip_limit(
            (bit, &chosen.case.conditions),
            values,
            largest_undershoot(taps),
        )?;
        let column = |name: &str, of: fn(&LimitPoint) -> f64| {
            (name.to_owned(), limit.iter().map(of).collect())
        };
        Ok(Answer::with_columns(
            Map::new(),
            vec![
                column("value", |point| point.value),
                column("torque_dynamic_nm", |point| point.torque_dynamic_nm),
                column("surface_speed_rpm", |point| point.surface_speed_rpm),
            ],
        ))
    }

    /// The case that is asked for, and the system that it is stepped against, built unless that
    /// of the last case will do.
    fn built_for(&mut self, asked: &CaseAsked) -> Result<(&Built, ChosenCase)> {
        let method = self.place_of(asked.method)?;
        let set: Vec<(Axis, f64)> = asked
            .set
            .iter()
            .map(|(&axis, &value)| (axis, value))
            .collect();
        let choice = Choice::new(&self.sweep, asked.case, &set)?;
        let setting = common_setting(&self.sweep, std::slice::from_ref(&choice))??;
        let last = self.built.take();
        let is_same = (last.as_ref()).is_some_and(|built| built.is_of(method, &setting.changed));
        let sweep = match &last {
            Some(built) if is_same => &built.sweep,
            _ => &Sweep {
                setting,
                ..self.sweep.clone()
            },
        };
        let chosen = choice.case(sweep)?;
        let lasts = |built: &Built| {
            built.longest == chosen.longest || asked.quick && built.longest > chosen.longest
        };
        let built = match last {
            Some(built) if is_same && lasts(&built) => built,
            _ => {
                let earlier = last.as_ref().map(|built| built.system.system());
                Built::new(sweep.clone(), method, chosen.longest, earlier)?
            }
        };
        Ok((self.built.insert(built), chosen))
    }

    /// The place of a method in the list of the open sweep.
    fn place_of(&self, method: Option<MethodName>) -> Result<usize> {
        let Some(name) = method.map(MethodName::name) else {
            return Ok(0);
        };
        let place = self.sweep.methods.iter().position(|own| own.name() == name);
        place.with_context(|| format!("the sweep was opened without the method {name}"))
    }
}

impl Built {
    /// Builds a system; what its string has in common with an earlier one is not built again.
    fn new(
        sweep: Sweep,
        method: usize,
        longest: f64,
        earlier: Option<&MethodSystem>,
    ) -> Result<Self> {
        let (setting, by) = (sweep.setting.for_labels(), sweep.methods[method]);
        let system = MethodSystem::build_after(&sweep, &setting, by, longest, earlier)?;
        Ok(Self {
            system: FollowedMethod::new(&sweep, system, longest)?,
            method,
            longest,
            sweep,
        })
    }

    /// Whether it is of this method, and of the string with these changes.
    fn is_of(&self, method: usize, changed: &[(Axis, f64)]) -> bool {
        self.method == method && self.sweep.setting.changed == changed
    }

    /// Where sites are found, the system and the case with those of this case, and the row that
    /// says how; else none.
    fn at_found_sites(
        &self,
        chosen: &ChosenCase,
        options: RunOptions,
    ) -> Result<Option<(Self, Case, Record)>> {
        let lateral = self.sweep.setting.lateral.as_ref();
        if lateral.is_none_or(|lateral| lateral.finding.is_none()) {
            return Ok(None);
        }
        let row = answer(
            self.system.system(),
            &chosen.case,
            self.method,
            options,
            &self.sweep,
        );
        if row.outcome.is_err() {
            return Err(without_answer(&self.sweep, &row));
        }
        let sites = row.found.as_ref().map_or(&[][..], |found| &found.sites);
        let setting = self.sweep.setting_with_sites(&self.sweep.setting, sites)?;
        let case = chosen.case.at_sites_of(&setting)?;
        let sweep = Sweep {
            setting,
            ..self.sweep.clone()
        };
        let built = Self::new(sweep, self.method, chosen.longest, None)?;
        Ok(Some((built, case, row)))
    }
}

/// That a case has no answer, in the words of `sweep simulate`.
fn without_answer(sweep: &Sweep, row: &Record) -> anyhow::Error {
    let (case, method) = (row.case, sweep.methods[row.method].name());
    let reason = row
        .outcome
        .as_ref()
        .err()
        .map_or("no motion", Failure::text);
    anyhow!("case {case} by {method} has no answer: {reason}")
}

/// A row of `labels.csv` by its columns: numbers as numbers, what is empty as null.
fn row_of(sweep: &Sweep, row: &Record) -> Value {
    let table = LabelTable::of(sweep);
    let (header, row) = (table.header(), table.row(row, Certainty::default()));
    let value = |text: &str| match text.parse::<f64>() {
        _ if text.is_empty() => Value::Null,
        Ok(number) => number.into(),
        Err(_) => text.into(),
    };
    let fields = header.split(',').zip(row.split(','));
    fields
        .map(|(name, text)| (name.to_owned(), value(text)))
        .collect()
}
