//! A quantity as it was recorded over time.

use std::sync::Arc;

use thiserror::Error;

/// Values at growing times, straight between them; before the first it is the first, after
/// the last the last.
///
/// ```
/// use sim::{Recording, RecordingError};
///
/// let speed = Recording::new(vec![0.0, 2.0, 4.0], vec![0.0, 60.0, 80.0])?;
/// assert_eq!([speed.at(1.0), speed.at(3.0), speed.at(9.0)], [30.0, 70.0, 80.0]);
/// let refused = Recording::new(vec![0.0, 2.0, 1.0], vec![0.0, 60.0, 80.0]);
/// assert!(matches!(refused, Err(RecordingError::RunsBack { sample: 2, .. })));
/// # Ok::<(), RecordingError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Recording(Arc<Samples>);

#[derive(Debug, PartialEq)]
struct Samples {
    /// Times, s.
    times: Vec<f64>,
    values: Vec<f64>,
}

/// Why samples are no recording.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum RecordingError {
    /// There is none, or not one value for each time.
    #[error("a recording has a value at each of at least two times")]
    Shape,
    /// One is no number.
    #[error("sample {0} (counted from 0) is not a number")]
    NotFinite(usize),
    /// A time is not after the one before.
    #[error("time {time} s of sample {sample} (counted from 0) is not after {before} s")]
    RunsBack {
        /// The sample.
        sample: usize,
        /// Its time, s.
        time: f64,
        /// The time before, s.
        before: f64,
    },
}

impl Recording {
    /// Samples at times (s).
    ///
    /// # Errors
    /// Where they are not one value for each of at least two growing times.
    pub fn new(times: Vec<f64>, values: Vec<f64>) -> Result<Self, RecordingError> {
        if times.len() < 2 || times.len() != values.len() {
            return Err(RecordingError::Shape);
        }
        let mut samples = times.iter().zip(&values);
        if let Some(sample) =
            samples.position(|(time, value)| !(time.is_finite() && value.is_finite()))
        {
            return Err(RecordingError::NotFinite(sample));
        }
        if let Some(index) = times.windows(2).position(|pair| pair[1] <= pair[0]) {
            return Err(RecordingError::RunsBack {
                sample: index + 1,
                time: times[index + 1],
                before: times[index],
            });
        }
        Ok(Self(Arc::new(Samples { times, values })))
    }

    /// Times, s.
    pub fn times(&self) -> &[f64] {
        &self.0.times
    }

    /// Its values.
    pub fn values(&self) -> &[f64] {
        &self.0.values
    }

    /// Time of the first sample, s.
    pub fn begin(&self) -> f64 {
        self.0.times[0]
    }

    /// Time of the last sample, s.
    pub fn end(&self) -> f64 {
        self.0.times[self.0.times.len() - 1]
    }

    /// The same with its values replaced.
    pub fn map(&self, value: impl Fn(f64) -> f64) -> Self {
        Self(Arc::new(Samples {
            times: self.0.times.clone(),
            values: self.0.values.iter().map(|&it| value(it)).collect(),
        }))
    }

    /// The same up to a time (s) at which it ends, if it lasts longer.
    pub fn until(&self, end: f64) -> Self {
        let kept = self.0.times.partition_point(|time| *time < end);
        if kept == self.0.times.len() || kept == 0 {
            return self.clone();
        }
        let mut times = self.0.times[..kept].to_vec();
        let mut values = self.0.values[..kept].to_vec();
        times.push(end);
        values.push(self.at(end));
        Self(Arc::new(Samples { times, values }))
    }

    /// The value at a time, s.
    pub fn at(&self, time: f64) -> f64 {
        let Samples { times, values } = &*self.0;
        let next = times.partition_point(|known| *known <= time);
        if next == 0 {
            return values[0];
        }
        if next == times.len() {
            return values[next - 1];
        }
        let part = (time - times[next - 1]) / (times[next] - times[next - 1]);
        values[next - 1] + part * (values[next] - values[next - 1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_straight_between_samples_and_stays_at_its_ends() {
        let recording = Recording::new(vec![1.0, 2.0, 4.0], vec![3.0, 5.0, -1.0]).unwrap();
        let found = [0.0, 1.0, 1.5, 2.0, 3.0, 4.0, 9.0].map(|time| recording.at(time));
        assert_eq!(found, [3.0, 3.0, 4.0, 5.0, 2.0, -1.0, -1.0]);
    }

    #[test]
    fn it_is_cut_where_it_lasts_too_long() {
        let recording = Recording::new(vec![0.0, 2.0, 4.0], vec![0.0, 2.0, 6.0]).unwrap();
        let cut = recording.until(3.0);
        assert_eq!(
            (cut.times(), cut.values()),
            (&[0.0, 2.0, 3.0][..], &[0.0, 2.0, 4.0][..])
        );
        assert_eq!(recording.until(4.0), recording);
        assert_eq!(recording.until(9.0), recording);
        assert_eq!(recording.until(2.0).times(), [0.0, 2.0]);
    }

    #[test]
    fn what_is_no_recording_is_refused() {
        let new = |times: &[f64], values: &[f64]| Recording::new(times.to_vec(), values.to_vec());
        assert_eq!(new(&[0.0], &[1.0]), Err(RecordingError::Shape));
        assert_eq!(new(&[0.0, 1.0], &[1.0]), Err(RecordingError::Shape));
        let not_a_number = new(&[0.0, 1.0], &[1.0, f64::NAN]);
        assert_eq!(not_a_number, Err(RecordingError::NotFinite(1)));
        let message = new(&[0.0, 2.0, 2.0], &[1.0; 3]).unwrap_err().to_string();
        assert!(message.contains("time 2 s of sample 2"), "{message}");
    }
}
