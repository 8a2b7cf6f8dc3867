//! Arguments of the studies: the commands about the program itself.

use std::path::PathBuf;

use clap::{Args, Subcommand};

use super::values::{parse_measure, parse_setting, parse_strength, sweep_file};
use super::{MemoryArguments, WorkArguments};
use campaign::quantities::Axis;
use studies::promises::{Begins, Motion};
use studies::stability::Family;
use studies::tradeoff::{LADDER, Measure};

/// The studies, which a user asks for as `sweep study NAME`.
#[derive(Debug, Subcommand)]
pub enum Study {
    /// Chart accuracy against speed, all methods, on two strings
    #[command(after_help = "Examples:\n  sweep study tradeoff\n  \
        sweep study tradeoff --ladder 160,320,640 --measures surface_step,whirl_rate_turns_s\n\n\
        The whole study takes up to ten minutes on two cores; a part of it, seconds.")]
    Tradeoff(TradeoffArguments),
    /// Chart where methods fail, and whether their margins predict it
    #[command(after_help = "Examples:\n  sweep study stability\n  \
        sweep study stability --family newmark --out /tmp/newmark")]
    Stability(StabilityArguments),
    /// Test how often accuracies asked for are kept, on random strings
    #[command(after_help = "Examples:\n  sweep study promises\n  \
        sweep study promises --strings 4 --motion whirl --out /tmp/promises\n\n\
        The whole study takes hours on two cores; a string, about a minute.")]
    Promises(PromisesArguments),
    /// Chart how much friction whirl needs at 1, 2, 4, … 64 contacts
    #[command(after_help = "Examples:\n  sweep study contacts\n  \
        sweep study contacts --counts 1,4,16 --methods finite-element,quadrature\n  \
        sweep study contacts sweeps/contacts.toml --counts 32 --set clearance_mm=30\n\n\
        A file gives string, wall, surface speed and methods, with what its first case\n\
        says of them; sites and impulses are the study's own, and friction is what it\n\
        looks for. The whole study takes up to ten minutes on two cores.")]
    Contacts(ContactsArguments),
}

/// Arguments of `tradeoff`.
#[derive(Debug, Args)]
pub struct TradeoffArguments {
    /// Sampling frequencies in Hz; the highest is a multiple of all
    #[arg(long, value_name = "HZ", value_delimiter = ',', default_values_t = LADDER)]
    pub ladder: Vec<f64>,
    /// What to measure, by name as in tradeoff.csv [default: everything]
    #[arg(long, value_name = "NAMES", value_delimiter = ',', value_parser = parse_measure)]
    pub measures: Vec<Measure>,
    /// The strings in viscous mud, of a material with loss: without the uniform tube, which has no
    /// reference there
    #[arg(long)]
    pub in_mud: bool,
    /// Results folder
    #[arg(long, default_value = "results/tradeoff")]
    pub out: PathBuf,
    /// Threads for building, at most 8 a core [default: $SLURM_CPUS_PER_TASK, $SLURM_CPUS_ON_NODE, all cores]
    #[arg(long)]
    pub jobs: Option<usize>,
    /// Print nothing but errors
    #[arg(long)]
    pub quiet: bool,
}

/// Arguments of `stability`.
#[derive(Debug, Args)]
pub struct StabilityArguments {
    /// Results folder
    #[arg(long, default_value = "results/stability")]
    pub out: PathBuf,
    /// Only these parts of the atlas; may be repeated
    #[arg(long, value_name = "FAMILY", value_delimiter = ',')]
    pub family: Vec<Family>,
    /// The strings in viscous mud, of a material with loss: without the strings of other sections
    #[arg(long)]
    pub in_mud: bool,
    /// Threads, at most 8 a core [default: $SLURM_CPUS_PER_TASK, $SLURM_CPUS_ON_NODE, all cores]
    #[arg(long)]
    pub jobs: Option<usize>,
    /// Print nothing but errors
    #[arg(long)]
    pub quiet: bool,
}

/// Arguments of `promises`.
#[derive(Debug, Args)]
pub struct PromisesArguments {
    /// Strings drawn for each motion; every one is asked for several accuracies
    #[arg(long, default_value = "40", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub strings: u32,
    /// What the random numbers begin with
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Only this motion; may be repeated
    #[arg(long, value_name = "MOTION", value_delimiter = ',')]
    pub motion: Vec<Motion>,
    /// Test instead how often a label that `certify` has as certain is wrong
    #[arg(long, conflicts_with = "limits")]
    pub labels: bool,
    /// Test instead where the limit of stick-slip is at the default sampling frequency
    #[arg(long)]
    pub limits: bool,
    /// Test instead under which fall of the bit's torque with its speed vibration grows at the
    /// default sampling frequency, on strings in viscous mud, of a material with loss
    #[arg(long, conflicts_with_all = ["limits", "labels"])]
    pub growth: bool,
    /// Test instead bits that cut: in which rock steady drilling begins to vibrate at the default
    /// sampling frequency, against the exact criterion; with --labels, the labels of rocks about that; with
    /// --accuracy, whether accuracies asked for are kept
    #[arg(long, conflicts_with_all = ["limits", "growth", "motion", "start"])]
    pub cutting: bool,
    /// With --cutting, whether an accuracy asked for is kept
    #[arg(long, requires = "cutting", conflicts_with = "labels")]
    pub accuracy: bool,
    /// Strings of --limits in viscous mud, of a material with loss; their limits are compared with
    /// those of `held` in 4096 and 8192 steps per travel time
    #[arg(long, requires = "limits")]
    pub in_mud: bool,
    /// How cases of --limits and of stick-slip in --labels begin
    #[arg(long, value_enum, default_value_t = Begins::Stuck)]
    pub start: Begins,
    /// The methods of --limits and --cutting
    #[arg(long, value_name = "METHOD", value_delimiter = ',', default_values_t = [String::from("held")])]
    pub methods: Vec<String>,
    /// Take the exact limits of --limits from an earlier table of the same seed
    #[arg(long, value_name = "CSV")]
    pub known: Option<PathBuf>,
    /// Results folder
    #[arg(long, default_value = "results/promises")]
    pub out: PathBuf,
    /// Threads, at most 8 a core [default: $SLURM_CPUS_PER_TASK, $SLURM_CPUS_ON_NODE, all cores]
    #[arg(long)]
    pub jobs: Option<usize>,
    #[command(flatten)]
    pub memory: MemoryArguments,
    /// Print nothing but errors
    #[arg(long)]
    pub quiet: bool,
}

/// Arguments of `contacts`.
#[derive(Debug, Args)]
pub struct ContactsArguments {
    /// The sweep file [default: the paper's string, and that of a 12¼-inch well]
    #[arg(value_parser = sweep_file())]
    pub file: Option<PathBuf>,
    /// Numbers of contacts
    #[arg(long, value_name = "N", value_delimiter = ',', default_values_t = [1, 2, 4, 8, 16, 32, 64])]
    pub counts: Vec<usize>,
    /// Distance of the lowest contact from the bit, m
    #[arg(long, value_name = "M", default_value_t = 0.0)]
    pub from_m: f64,
    /// Where the range of the contacts ends [default: 200 m from the bit, or the surface]
    #[arg(long, value_name = "M")]
    pub to_m: Option<f64>,
    /// Places of impulses, m from the bit [default: the lowest contact, the file's first impulse]
    #[arg(long, alias = "knock-at", value_name = "M", value_delimiter = ',')]
    pub impulse_at: Option<Vec<f64>>,
    /// Their amounts, in multiples of I₀ at that place; rounded to two digits
    #[arg(long, alias = "knocks", value_name = "RATIOS", value_delimiter = ',', default_value = "3,10", value_parser = parse_strength)]
    pub impulses: Vec<f64>,
    /// Impulses spread all along the contacts, N s per metre
    #[arg(long, alias = "blows", value_name = "AMOUNTS", value_delimiter = ',', default_value = "150,500", value_parser = parse_strength)]
    pub impulses_along: Vec<f64>,
    /// Set a quantity, e.g. clearance_mm=10; may be repeated
    #[arg(long, value_name = "AXIS=VALUE", value_parser = parse_setting)]
    pub set: Vec<(Axis, f64)>,
    /// Time simulated, s [default: that of the file]
    #[arg(long, value_name = "TIME")]
    pub time_s: Option<f64>,
    /// Sampling frequency [default: that of the file]
    #[arg(long, value_name = "HZ")]
    pub sampling_hz: Option<f64>,
    /// Results folder
    #[arg(long, default_value = "results/contacts")]
    pub out: PathBuf,
    #[command(flatten)]
    pub work: WorkArguments,
    /// Print nothing but errors
    #[arg(long)]
    pub quiet: bool,
}
