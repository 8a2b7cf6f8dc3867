//! `[[compare]]`: what was recorded, and how far a simulated motion is from it.

use sim::{Recording, Trajectory};

use crate::records::{MISFIT, to_rpm};
use crate::sweep_file::{
    AutoOr, CompareTable, Extreme, FileContent, Source, SweepFileError, TextOf, TraceName,
    read_series,
};

/// A recorded quantity, and where the simulated one is held against it.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// Name of its column in tables.
    pub column: String,
    /// What it is called, in words.
    pub name: String,
    /// What is simulated.
    pub trace: TraceName,
    /// What was recorded, in the unit of the trace.
    pub recorded: Recording,
    /// From when on, s.
    pub from: f64,
    /// Until when, s.
    pub to: f64,
    /// Of a time around each sample, s, the least or the greatest was recorded.
    pub extreme: Option<(Extreme, f64)>,
}

impl TraceName {
    /// Its name with the unit.
    pub fn name(self) -> &'static str {
        match self {
            Self::BitSpeedRpm => "bit_speed_rpm",
            Self::SurfaceSpeedRpm => "surface_speed_rpm",
            Self::SurfaceTorqueNm => "surface_torque_nm",
        }
    }

    /// Its unit as names end in it.
    pub fn unit(self) -> &'static str {
        match self {
            Self::BitSpeedRpm | Self::SurfaceSpeedRpm => "_rpm",
            Self::SurfaceTorqueNm => "_nm",
        }
    }

    /// Its value in a step of a motion; none where that does not have it.
    pub fn value(self, motion: &Trajectory, step: usize) -> Option<f64> {
        match self {
            Self::BitSpeedRpm => Some(to_rpm(*motion.speeds.last()?.get(step)?)),
            Self::SurfaceSpeedRpm => Some(to_rpm(*motion.surface_speed.get(step)?)),
            Self::SurfaceTorqueNm => motion.surface_torque.get(step).copied(),
        }
    }
}

/// Times closer than this are the same, s.
const SAME_TIME: f64 = 1e-6;

impl Comparison {
    /// Whether another is held against the same recording.
    pub fn has_same_recording(&self, other: &Self) -> bool {
        self.recorded == other.recorded && self.extreme == other.extreme
    }

    /// What was recorded, in words.
    pub fn description(&self) -> &'static str {
        match self.extreme {
            None => "recorded",
            Some((Extreme::Least, _)) => "least recorded",
            Some((Extreme::Greatest, _)) => "greatest recorded",
        }
    }

    /// Root mean square of simulated less recorded, in the unit of the trace; none where the
    /// motion does not have the trace or does not reach the time.
    pub fn misfit(&self, motion: &Trajectory) -> Option<f64> {
        if *motion.times.last()? < self.to - SAME_TIME {
            return None;
        }
        let off: Vec<f64> = match self.extreme {
            None => {
                let steps = motion.times.iter().enumerate();
                let within = steps.filter(|(_, time)| (self.from..=self.to).contains(*time));
                let off = within.map(|(step, time)| {
                    Some(self.trace.value(motion, step)? - self.recorded.at(*time))
                });
                off.collect::<Option<_>>()?
            }
            Some((extreme, over)) => {
                let samples = self.recorded.times().iter().zip(self.recorded.values());
                let within = samples.filter(|(time, _)| (self.from..=self.to).contains(*time));
                let off = within.map(|(time, recorded)| {
                    Some(self.extreme_around(motion, extreme, *time, over)? - recorded)
                });
                off.collect::<Option<_>>()?
            }
        };
        let squares: f64 = off.iter().map(|off| off * off).sum();
        (!off.is_empty()).then(|| (squares / off.len() as f64).sqrt())
    }

    fn extreme_around(
        &self,
        motion: &Trajectory,
        extreme: Extreme,
        time: f64,
        over: f64,
    ) -> Option<f64> {
        let first = motion
            .times
            .partition_point(|known| *known < time - 0.5 * over);
        let last = motion
            .times
            .partition_point(|known| *known <= time + 0.5 * over);
        let values = (first..last).map(|step| self.trace.value(motion, step));
        let values: Vec<f64> = values.collect::<Option<_>>()?;
        values.into_iter().reduce(match extreme {
            Extreme::Least => f64::min,
            Extreme::Greatest => f64::max,
        })
    }
}

/// What the file holds its cases against, and what was ignored in the files.
///
/// # Errors
/// Where a key is refused, or a file.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    text_of: TextOf,
) -> Result<(Vec<Comparison>, Vec<String>), SweepFileError> {
    let mut comparisons: Vec<Comparison> = Vec::new();
    let mut notes = Vec::new();
    for (index, table) in content.compare.iter().enumerate() {
        let (comparison, ignored) = comparison(source, content, index, table, text_of)?;
        let mut before = comparisons.iter();
        let is_there = before.any(|other| other.column == comparison.column);
        let message = format!(
            "there is a column `{}` already: give a `name`",
            comparison.column
        );
        source.refuse_if(is_there, &format!("compare[{index}].trace"), message)?;
        comparisons.push(comparison);
        notes.extend(ignored);
    }
    Ok((comparisons, notes))
}

/// Refuses what no case of the file has.
fn is_followed(
    source: &Source,
    content: &FileContent,
    key: &str,
    trace: TraceName,
) -> Result<(), SweepFileError> {
    let (follows, bends) = (content.follows_surface(), content.wall.is_some());
    let at_bit = content.bit_is_site();
    let (is_there, message) = match trace {
        TraceName::BitSpeedRpm => (
            !bends || at_bit,
            "with a wall the bit is followed where it is one of the [[sites]]",
        ),
        TraceName::SurfaceSpeedRpm => (
            follows,
            "it is followed with [string_friction], or with `saturates` in [top_drive]",
        ),
        TraceName::SurfaceTorqueNm => return Ok(()),
    };
    source.refuse_if(!is_there, key, message)
}

fn comparison(
    source: &Source,
    content: &FileContent,
    index: usize,
    table: &CompareTable,
    text_of: TextOf,
) -> Result<(Comparison, Vec<String>), SweepFileError> {
    let key = |key: &str| format!("compare[{index}].{key}");
    is_followed(source, content, &key("trace"), table.trace)?;
    let (unit, file) = (table.trace.unit(), &table.file);
    let column = Some(table.column.as_str());
    let (recorded, ignored) = read_series(source, &key("file"), file, column, unit, text_of)?;
    let from = source.within(&key("from_s"), table.from_s, 0.0, 1e6, "s")?;
    let to = source.within(&key("to_s"), table.to_s, 0.0, 1e6, "s")?;
    source.refuse_if(
        to <= from,
        &key("to_s"),
        format!("{to} s is not after {from} s"),
    )?;
    let (begin, end) = (recorded.begin(), recorded.end());
    let message = |limit| format!("the recording is from {begin} s to {end} s: {limit}");
    source.refuse_if(from < begin, &key("from_s"), message("it begins later"))?;
    source.refuse_if(to > end, &key("to_s"), message("it ends sooner"))?;
    if let AutoOr::Given(time) = content.time_s {
        let message = format!("the cases end at {time} s");
        source.refuse_if(to > time, &key("to_s"), message)?;
    }
    let extreme = match (table.of, table.over_s) {
        (None, None) => None,
        (Some(of), Some(over)) => Some((of, source.within(&key("over_s"), over, 1e-3, 1e4, "s")?)),
        (Some(_), None) => return Err(source.error(&key("of"), "needs `over_s`, a time")),
        (None, Some(_)) => {
            return Err(source.error(&key("over_s"), "needs `of`: `least` or `greatest`"));
        }
    };
    let name = match &table.name {
        None => table.trace.name().trim_end_matches(unit),
        Some(name) => {
            let is_word = |letter: char| {
                letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '_'
            };
            let message = "names a column: lower case letters, digits and `_`";
            let is_name = !name.is_empty() && name.chars().all(is_word);
            source.refuse_if(!is_name, &key("name"), message)?;
            name
        }
    };
    let comparison = Comparison {
        column: format!("{MISFIT}{name}{unit}"),
        name: name.replace('_', " "),
        trace: table.trace,
        recorded,
        from,
        to,
        extreme,
    };
    Ok((comparison, ignored))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A torque that is twice the time, recorded 3 too low.
    #[test]
    fn a_misfit_is_the_root_mean_square_of_what_is_off() {
        let times: Vec<f64> = (0..100).map(|step| 0.1 * f64::from(step)).collect();
        let motion = Trajectory {
            surface_torque: times.iter().map(|time| 2.0 * time).collect(),
            times,
            ..Trajectory::default()
        };
        let recorded = Recording::new(vec![0.0, 10.0], vec![-3.0, 17.0]).unwrap();
        let comparison = Comparison {
            column: String::new(),
            name: String::new(),
            trace: TraceName::SurfaceTorqueNm,
            recorded: recorded.clone(),
            from: 2.0,
            to: 7.0,
            extreme: None,
        };
        assert!((comparison.misfit(&motion).unwrap() - 3.0).abs() < 1e-12);
        // The greatest of a second around is one more.
        let samples = Recording::new(vec![2.0, 3.0, 4.0], vec![1.0, 3.0, 5.0]).unwrap();
        let of_greatest = Comparison {
            recorded: samples,
            extreme: Some((Extreme::Greatest, 1.0)),
            ..comparison.clone()
        };
        assert!((of_greatest.misfit(&motion).unwrap() - 4.0).abs() < 1e-9);
        // It ends before the motion is to be held against it.
        let of_more = Comparison {
            to: 9.95,
            ..comparison.clone()
        };
        assert_eq!(of_more.misfit(&motion), None);
        let of_bit = Comparison {
            trace: TraceName::BitSpeedRpm,
            ..comparison
        };
        assert_eq!(of_bit.misfit(&motion), None);
    }
}
