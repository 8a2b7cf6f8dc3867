//! Which snapshots are drawn of the string in its hole.

use anyhow::{Result, bail};
use sim::Trajectory;
use sim::laws::contact::Touch;

use crate::cli::FilmArguments;
use crate::commands::status::UsageError;
use campaign::engine::ChosenCase;
use campaign::plan::Sweep;
use campaign::words::{counted, short};

/// Refuses, before anything is simulated, a film of what does not bend or of no time.
///
/// # Errors
/// Where it can be no film.
pub fn refuse_idle(sweep: &Sweep, cases: &[ChosenCase], film: &FilmArguments) -> Result<()> {
    if !film.film {
        return Ok(());
    }
    if sweep.setting.lateral.is_none() {
        refuse("--film: there is no wall in this sweep, and so nothing bends")?;
    }
    let given = [("--film-from", film.from), ("--film-to", film.to)];
    let ends = cases
        .first()
        .map(|chosen| chosen.case.scene.timing.duration);
    for (name, time) in given {
        let Some((time, end)) = time.zip(ends) else {
            continue;
        };
        if !(0.0..=end).contains(&time) {
            refuse(&format!(
                "{name} {time}: the case is simulated from 0 to {end} s"
            ))?;
        }
    }
    match (film.from, film.to) {
        (Some(from), Some(to)) if from > to => refuse(&format!(
            "--film-from {from}: it is later than --film-to {to}"
        )),
        _ => Ok(()),
    }
}

/// The steps to draw, evenly from the first to the last, both among them; none without
/// `--film`.
///
/// # Errors
/// Where there are fewer steps than frames.
pub fn chosen_steps(film: &FilmArguments, motion: &Trajectory) -> Result<Vec<usize>> {
    if !film.film {
        return Ok(Vec::new());
    }
    let first = match film.from {
        Some(from) => motion.times.partition_point(|time| *time < from),
        None => first_contact(motion).unwrap_or(0),
    };
    let end = match film.to {
        Some(to) => motion.times.partition_point(|time| *time <= to),
        None => motion.times.len(),
    };
    let frames = film.frames_asked();
    let steps = end.saturating_sub(first);
    if steps < frames {
        let from = match (film.from, motion.times.get(first)) {
            (None, Some(&time)) => format!(
                " from the first contact, at {} s, on; --film-from takes another time",
                short(time)
            ),
            _ => String::new(),
        };
        let there = counted(steps, "step");
        refuse(&format!(
            "--film-frames {frames}: there are {there} to show{from}"
        ))?;
    }
    let gaps = frames.saturating_sub(1).max(1);
    Ok((0..frames)
        .map(|frame| first + frame * (steps - 1) / gaps)
        .collect())
}

/// The step at which a site first touches the wall.
fn first_contact(motion: &Trajectory) -> Option<usize> {
    let sites = motion.touches.iter();
    let firsts = sites.filter_map(|site| site.iter().position(|touch| *touch != Touch::Free));
    firsts.min()
}

fn refuse(reason: &str) -> Result<()> {
    bail!(UsageError(reason.to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A hundred steps of a second; from the fortieth on the second site touches.
    fn motion() -> Trajectory {
        let touches = |from: usize| {
            let touch = |step| {
                if step < from {
                    Touch::Free
                } else {
                    Touch::Sliding
                }
            };
            (0..100).map(touch).collect()
        };
        Trajectory {
            times: (0..100).map(f64::from).collect(),
            touches: vec![touches(100), touches(40)],
            ..Trajectory::default()
        }
    }

    fn film(frames: u8, from: Option<f64>, to: Option<f64>) -> FilmArguments {
        FilmArguments {
            film: true,
            frames,
            from,
            to,
        }
    }

    #[test]
    fn frames_are_even_from_the_first_contact_to_the_end() {
        let steps = |frames, from, to| chosen_steps(&film(frames, from, to), &motion()).unwrap();
        assert_eq!(steps(4, None, None), [40, 59, 79, 99]);
        assert_eq!(steps(3, Some(0.5), Some(11.0)), [1, 6, 11]);
        assert_eq!(steps(1, Some(7.0), Some(7.0)), [7]);
        assert_eq!(steps(60, None, None).len(), 60);
        let free = Trajectory {
            touches: vec![vec![Touch::Free; 100]],
            ..motion()
        };
        assert_eq!(chosen_steps(&film(2, None, None), &free).unwrap(), [0, 99]);
    }

    #[test]
    fn frames_without_steps_are_refused() {
        for (film, words) in [
            (film(12, Some(3.0), Some(5.0)), "there are 3 steps to show"),
            (
                film(12, None, Some(20.0)),
                "there are 0 steps to show from the first contact, at 40 s",
            ),
        ] {
            let refusal = chosen_steps(&film, &motion()).unwrap_err().to_string();
            assert!(refusal.contains(words), "{refusal}");
        }
    }
}
