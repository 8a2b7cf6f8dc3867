//! The sweep that is open, and its cases as they are asked for.

use anyhow::{Context, Result, anyhow};
use campaign::Campaign;
use campaign::engine::{LimitPoint, RunOptions, stick_slip_limit};
use campaign::follow::{ChosenCases, Following, KeptSystems};
use campaign::labels::{LabelTable, history_columns};
use campaign::plan::Sweep;
use campaign::quantities::Axis;
use campaign::records::{Certainty, Failure, Record};
use campaign::sweep_file::MethodName;
use linear::estimates::largest_undershoot;
use serde_json::{Map, Value, json};

use crate::opening::opened;
use crate::request::{CaseAsked, LimitAsked, Request};

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
    campaign: Campaign,
    systems: KeptSystems,
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
            let campaign = opened(*opening)?;
            let answer = Answer::ok(description(&campaign.sweep));
            self.open = Some(Open {
                campaign,
                systems: KeptSystems::default(),
            });
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
        let chosen = self.chosen(asked)?;
        let how = following(asked.full);
        self.systems.accepts_longer = asked.quick;
        let followed = chosen.follow(&how, &mut self.systems)?;
        let (sweep, row) = (&followed.sweep, followed.rows.first());
        let row = row.context("there is no case")?;
        let simulation = followed.simulations.first();
        let simulation = simulation.ok_or_else(|| without_answer(sweep, row))?;
        let columns = history_columns(&sweep.setting.sites, &simulation.trajectory);
        let columns = columns
            .into_iter()
            .map(|column| (column.name, column.values));
        let mut words = Map::new();
        words.insert("row".to_owned(), row_of(sweep, row));
        Ok(Answer::with_columns(words, columns.collect()))
    }

    /// Eq. 74 along an axis, by the undershoot of the method that is asked for.
    fn limit(&mut self, asked: &LimitAsked) -> Result<Answer> {
        let chosen = self.chosen(&asked.of)?;
        let case = chosen.cases.first().context("there is no case")?;
        self.systems.accepts_longer = asked.of.quick;
        let how = following(asked.of.full);
        let systems = self.systems.built_for(&chosen, case.longest, &how)?;
        let system = systems.first().context("there is no method")?;
        let system = system.as_ref().map_err(|reason| anyhow!("{reason}"))?;
        let taps = system.system().driving_point();
        let (bit, taps) =
            (chosen.sweep.bit.as_ref().zip(taps)).context("no torque acts on the bit")?;
        let values = (asked.axis, asked.values.iter().copied());
        let limit = stick_slip_limit(
            (bit, &case.case.conditions),
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

    /// The case that is asked for.
    fn chosen(&self, asked: &CaseAsked) -> Result<ChosenCases> {
        let method = self.place_of(asked.method)?;
        let set = asked.set.iter().map(|(&axis, &value)| (axis, value));
        let set: Vec<(Axis, f64)> = set.collect();
        let chosen = self.campaign.cases(&[asked.case], &set, &[method])?;
        chosen.map_err(|rows| match rows.first() {
            Some(row) => without_answer(&self.campaign.sweep, row),
            None => anyhow!("there is no case"),
        })
    }

    /// The place of a method in the list of the open sweep.
    fn place_of(&self, method: Option<MethodName>) -> Result<usize> {
        let Some(name) = method.map(MethodName::name) else {
            return Ok(0);
        };
        let place = self
            .campaign
            .sweep
            .methods
            .iter()
            .position(|own| own.name() == name);
        place.with_context(|| format!("the sweep was opened without the method {name}"))
    }
}

/// As where `sweep simulate` looks at a case.
fn following(full: bool) -> Following<'static> {
    Following {
        options: RunOptions {
            full,
            allow_unstable: false,
        },
        memory: None,
        warn: &|_| (),
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
