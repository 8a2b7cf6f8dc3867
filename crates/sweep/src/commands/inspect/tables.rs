//! `--csv`: the taps of every response, and its frequency response, exact and by each method.

use std::f64::consts::TAU;
use std::path::Path;

use anyhow::{Result, bail};
use linear::passivity::Ending;
use linear::waves::lateral::BendingNetwork;
use linear::waves::network::TorsionNetwork;
use linear::waves::{ResponseMatrix, TorsionAdmittance};
use linear::{Channel, Complex64, parallel};

use crate::commands::status::UsageError;
use campaign::engine::MethodSystem;
use campaign::plan::Sweep;
use results::files::AtomicFile;

/// Frequencies of a response, up to half the sampling frequency.
const FREQUENCIES: usize = 2000;

/// Rows of a table, of which there may be sites² times taps; more would fill a disk.
const MOST_ROWS: usize = 20_000_000;

const TAPS: &str = "method,motion,input,input_from_bit_m,output_from_bit_m,unit,tap,time_s,value\n";
const FREQUENCY_RESPONSES: &str = "method,motion,input,input_from_bit_m,output_from_bit_m,unit,\
     frequency_hz,real,imaginary\n";

/// What a response is of.
#[derive(Clone, Copy)]
struct Between {
    channel: Channel,
    /// The site that the load acts on; none where the surface moves.
    from: Option<usize>,
    to: usize,
}

/// A response by a method.
struct Known<'a> {
    method: &'a str,
    /// Of the method, Hz.
    sampling_frequency: f64,
    between: Between,
    taps: &'a [f64],
    /// Whether they are all there is of it.
    is_whole: bool,
}

/// Writes `taps.csv` and `frequency_responses.csv`.
///
/// # Errors
/// Where that would take too many rows, or cannot be written.
pub fn write_tables(sweep: &Sweep, systems: &[MethodSystem], folder: &Path) -> Result<()> {
    let responses: Vec<Known> = systems.iter().flat_map(known).collect();
    let rows: usize = responses.iter().map(|it| it.taps.len()).sum();
    if rows.max(2 * responses.len() * FREQUENCIES) > MOST_ROWS {
        bail!(UsageError(format!(
            "--csv: {} responses of {rows} samples in all are more rows than {MOST_ROWS}: take \
             fewer \
             sites or methods",
            responses.len()
        )));
    }
    write_taps(sweep, &responses, &folder.join("taps.csv"))?;
    write_frequency_responses(sweep, &responses, &folder.join("frequency_responses.csv"))
}

/// Every response of a system.
fn known(system: &MethodSystem) -> Vec<Known<'_>> {
    let mut all = Vec::new();
    for block in &system.responses.channels {
        let mut add = |from, to, taps| {
            all.push(Known {
                method: system.method.name(),
                sampling_frequency: system.responses.sampling_frequency,
                between: Between {
                    channel: block.channel,
                    from,
                    to,
                },
                taps,
                is_whole: block.ending == Ending::Whole,
            });
        };
        for (to, taps) in block.from_surface.iter().enumerate() {
            add(None, to, taps.as_slice());
        }
        for (to, loads) in block.from_loads.iter().enumerate() {
            for (&from, taps) in block.loads.iter().zip(loads) {
                add(Some(from), to, taps.as_slice());
            }
        }
    }
    all
}

fn write_taps(sweep: &Sweep, responses: &[Known], path: &Path) -> Result<()> {
    let mut file = AtomicFile::create(path)?;
    file.write(TAPS.as_bytes())?;
    for response in responses {
        let start = first_columns(sweep, response.method, response.between);
        let rows = response.taps.iter().enumerate().map(|(index, tap)| {
            let time = index as f64 / response.sampling_frequency;
            format!("{start},{index},{time},{tap}\n")
        });
        file.write(rows.collect::<String>().as_bytes())?;
    }
    file.finish()?;
    Ok(())
}

/// The exact responses, each once, and those of the methods that end with their taps.
fn write_frequency_responses(sweep: &Sweep, responses: &[Known], path: &Path) -> Result<()> {
    let sampling = sweep.setting.sampling_frequency;
    let frequencies: Vec<f64> = (1..=FREQUENCIES)
        .map(|index| 0.5 * sampling * index as f64 / FREQUENCIES as f64)
        .collect();
    let exact = Exact::at(sweep, &frequencies)?;
    let mut file = AtomicFile::create(path)?;
    file.write(FREQUENCY_RESPONSES.as_bytes())?;
    let mut write = |method: &str, between: Between, values: &[Complex64]| {
        let start = first_columns(sweep, method, between);
        let rows = (frequencies.iter().zip(values))
            .map(|(frequency, value)| format!("{start},{frequency},{},{}\n", value.re, value.im));
        file.write(rows.collect::<String>().as_bytes())
    };
    let first = responses.first().map(|response| response.method);
    for response in responses.iter().filter(|it| Some(it.method) == first) {
        write("exact", response.between, &exact.of(response.between))?;
    }
    for response in responses.iter().filter(|it| it.is_whole) {
        let values = parallel::map(frequencies.len(), 1, |place| {
            of_taps(
                response.taps,
                frequencies[place] / response.sampling_frequency,
            )
        });
        write(response.method, response.between, &values)?;
    }
    file.finish()?;
    Ok(())
}

/// Σ A(k) z⁻ᵏ, where z goes around once in a number of `turns` per sample.
fn of_taps(taps: &[f64], turns: f64) -> Complex64 {
    let back = Complex64::cis(-TAU * turns);
    let taps = taps.iter().rev();
    taps.fold(Complex64::new(0.0, 0.0), |sum, tap| sum * back + tap)
}

/// The exact responses between all sites at some frequencies.
struct Exact {
    torsion: Vec<TorsionAdmittance>,
    bending: Vec<ResponseMatrix>,
    axial: Vec<TorsionAdmittance>,
}

impl Exact {
    fn at(sweep: &Sweep, frequencies: &[f64]) -> Result<Self> {
        let setting = &sweep.setting;
        let network = TorsionNetwork::new(&setting.string, &setting.sites)?;
        let count = frequencies.len();
        let torsion = parallel::map(count, 1, |it| network.at_frequency(frequencies[it]));
        let bending = match &setting.lateral {
            None => Vec::new(),
            Some(lateral) => {
                let (parameters, support) = (lateral.bending, lateral.support);
                let network =
                    BendingNetwork::new(&setting.string, parameters, support, &setting.sites)?;
                parallel::map(count, 1, |it| network.at_rate(TAU * frequencies[it]))
            }
        };
        let axial = match &setting.cutting {
            None => Vec::new(),
            Some(cutting) => {
                let network = TorsionNetwork::new(&cutting.rod, &setting.sites)?;
                parallel::map(count, 1, |it| network.at_frequency(frequencies[it]))
            }
        };
        Ok(Self {
            torsion,
            bending,
            axial,
        })
    }

    /// Of the string as it twists, or stretches.
    fn rod(&self, channel: Channel) -> &[TorsionAdmittance] {
        match channel {
            Channel::Axial => &self.axial,
            _ => &self.torsion,
        }
    }

    fn of(&self, between: Between) -> Vec<Complex64> {
        let Between { channel, from, to } = between;
        match (channel, from) {
            (Channel::Torsion | Channel::Axial, None) => (self.rod(channel).iter())
                .map(|admittance| admittance.from_surface[to])
                .collect(),
            (Channel::Torsion | Channel::Axial, Some(from)) => (self.rod(channel).iter())
                .map(|admittance| admittance.from_torque[(to, from)])
                .collect(),
            // Nothing in bending is moved by the surface.
            (Channel::Bending, from) => (self.bending.iter())
                .map(|receptance| receptance[(to, from.unwrap_or(to))])
                .collect(),
        }
    }
}

/// The columns that say which response a row is of.
fn first_columns(sweep: &Sweep, method: &str, between: Between) -> String {
    let Between { channel, from, to } = between;
    let places = sweep.setting.sites.distances_from_bit();
    let (input, unit) = match (from, channel) {
        (None, _) => ("surface_speed", "1"),
        (Some(_), Channel::Torsion) => ("torque", "rad/(s N m)"),
        (Some(_), Channel::Bending) => ("force", "m/N"),
        (Some(_), Channel::Axial) => ("force", "m/(s N)"),
    };
    let from = from.map_or_else(String::new, |from| places[from].to_string());
    format!("{method},{channel},{input},{from},{},{unit}", places[to])
}
