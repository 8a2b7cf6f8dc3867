//! What the linear systems of a string take in memory by all methods, and a case stepped against
//! them: a dry run of what builds them.

use linear::budget::{Budget, Need};
use linear::{BuildError, Method, PlaceQuantity, Sites, SurfaceTorquePlan};
use sim::SurfaceTorque;

use super::along::Along;
use super::dry_run::ask;
use super::finding::most_sites;
use super::finer::finer_frequency;
use super::system_plan::SystemPlan;
use super::timing::{TIMES, is_by_rule};
use super::tools;
use super::whole_string::whole_string;
use crate::plan::{Setting, Sweep};

/// Bytes of a system for longer cases, at most, with a case that is stepped against it. What takes more
/// is not built, and the case is undetermined; so no other sweep takes much more memory.
const MOST_OF_LONGER: f64 = 256.0 * 1024.0 * 1024.0;

/// Memory of one string by all methods, bytes: upper bounds.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StringMemory {
    /// What its systems take.
    pub systems: Need,
    /// What a case takes while it is stepped.
    pub case: f64,
    /// The longest response asked for, in taps, where no method gives one so long.
    pub too_long: Option<f64>,
    /// How many times as long as the rule says cases are followed, at most, where they fade.
    pub times: f64,
}

impl StringMemory {
    /// Of the cases of a sweep, up to the longest time (s). Methods are built side by side,
    /// with the shorter steps of those among them that certify labels.
    pub fn of(sweep: &Sweep, setting: &Setting, methods: &[Method], longest_time: f64) -> Self {
        let of_method = |method| Self::of_followed(sweep, setting, method, longest_time);
        let places = sweep.certifying.into_iter().flatten();
        let finer = places.filter_map(|place| methods.get(place)).map(|method| {
            let setting = setting.by(method);
            let setting = setting.sampled_at(finer_frequency(&setting, method));
            Self::of_method(sweep, &setting, method, longest_time)
        });
        (methods.iter().map(of_method).chain(finer)).fold(Self::default(), |all, one| Self {
            systems: all.systems.and(one.systems),
            case: all.case.max(one.case),
            too_long: (all.too_long.into_iter().chain(one.too_long)).reduce(f64::max),
            times: all.times.max(one.times),
        })
    }

    /// By a method, with what is built where a case is followed for longer.
    fn of_followed(sweep: &Sweep, setting: &Setting, method: &Method, longest_time: f64) -> Self {
        let own = Self::of_method(sweep, setting, method, longest_time);
        let longer = Self::longer(sweep, setting, method, longest_time);
        let longer = longer.into_iter().zip(TIMES);
        longer.fold(
            Self { times: 1.0, ..own },
            |all, (longer, times)| match longer {
                None => all,
                Some(longer) => Self {
                    systems: all.systems.then(longer.systems),
                    case: all.case.max(longer.case),
                    times,
                    ..all
                },
            },
        )
    }

    /// Memory for each of [`TIMES`], of the systems by a method that are built where a case asks for
    /// them; none where they are not.
    pub(super) fn longer(
        sweep: &Sweep,
        setting: &Setting,
        method: &Method,
        longest_time: f64,
    ) -> [Option<Self>; TIMES.len()] {
        let lateral = setting.lateral.as_ref();
        let finds_sites = lateral.is_some_and(|lateral| lateral.finding.is_some());
        let may_fade = sweep.bit.is_some() || setting.friction.is_some() || setting.lying.is_some();
        let follows = is_by_rule(sweep, setting) && may_fade && !finds_sites;
        TIMES.map(|times| {
            let own = || Self::at_sites(sweep, setting, method, times * longest_time);
            let fits = |own: &Self| {
                let bytes = own.systems.kept + own.case;
                own.too_long.is_none() && bytes > 0.0 && bytes <= MOST_OF_LONGER
            };
            follows.then(own).filter(fits)
        })
    }

    fn of_method(sweep: &Sweep, setting: &Setting, method: &Method, longest_time: f64) -> Self {
        let setting = &setting.by(method);
        let mut own = Self::at_sites(sweep, setting, method, longest_time);
        if let Some(most) = with_most_sites(setting, method) {
            // A case is run again with a separate system, and its whole string is reconstructed.
            let again = Self::at_sites(sweep, &most, method, longest_time);
            let whole = whole_string(sweep, &most).map_or(0.0, |whole| whole.need(0).peak);
            own.case = own.case.max(again.systems.peak + again.case) + whole;
        }
        own
    }

    fn at_sites(sweep: &Sweep, setting: &Setting, method: &Method, longest_time: f64) -> Self {
        let plan = SystemPlan {
            setting,
            method,
            cuts: sweep.bit.is_some(),
            longest_time,
        };
        match dry_run(sweep, &plan) {
            Ok((systems, case)) => Self {
                systems,
                case,
                ..Self::default()
            },
            Err(
                BuildError::TooManyTaps { taps, .. }
                | BuildError::TooManyImpulses { impulses: taps, .. },
            ) => Self {
                too_long: Some(taps),
                ..Self::default()
            },
            // What cannot be built takes nothing: building says why.
            Err(_) => Self::default(),
        }
    }
}

/// What a system takes, and a case that is stepped against it.
fn dry_run(sweep: &Sweep, plan: &SystemPlan) -> Result<(Need, f64), BuildError> {
    let budget = Budget::unlimited();
    let stepping = ask(plan, &budget)?;
    let lateral = plan.setting.lateral.as_ref();
    let finds_sites = lateral.is_some_and(|lateral| lateral.finding.is_some());
    let mut case = stepping.case_bytes(sweep.keeps_motion() || finds_sites);
    let finds_surface_torque = sweep.finds_surface_torque();
    if finds_surface_torque && !stepping.follows_surface {
        // Once the rest is there.
        let request = plan.request();
        SurfaceTorquePlan::new(&plan.setting.string, plan.method, &request)?.ask(&budget.part())?;
        SurfaceTorque::ask(stepping.recorded, stepping.taps, &budget)?;
    }
    if let Some(lateral) = lateral {
        case += Along::ask(plan, (PlaceQuantity::Moment, &lateral.stressed), &budget)?;
        case += Along::ask(
            plan,
            (PlaceQuantity::Displacement, &plan.setting.tools),
            &budget,
        )?;
    }
    case += tools::ask_along_axis(plan, &budget)?;
    if finds_surface_torque || stepping.follows_surface {
        case += SurfaceTorque::bytes_of_motion(stepping.taps, plan.steps());
    }
    Ok((budget.need(), case))
}

/// A setting with as many sites as may be found, where they are looked for, wherever they are.
fn with_most_sites(setting: &Setting, method: &Method) -> Option<Setting> {
    let finding = setting.lateral.as_ref()?.finding.as_ref()?;
    let most = most_sites(setting, method).max(setting.sites.len());
    let reach = finding.to.min(setting.string.length());
    let place = |site: usize| reach * site as f64 / most as f64;
    let places: Vec<f64> = (0..most).rev().map(place).collect();
    let sites = Sites::new(&setting.string, &places).ok()?;
    Some(Setting {
        sites,
        ..setting.clone()
    })
}
