//! The linear system of a method before it is built, and what a case takes that is stepped against
//! it.

use linear::{ChannelRequest, Method, Request};
use sim::{SimulatorPlan, plan};

use crate::plan::Setting;

/// The linear system of one method before it is built.
#[derive(Debug, Clone, Copy)]
pub struct SystemPlan<'a> {
    /// What it is built from.
    pub setting: &'a Setting,
    /// By which method.
    pub method: &'a Method,
    /// Whether a torque acts on the bit.
    pub cuts: bool,
    /// The longest time of its cases, s.
    pub longest_time: f64,
}

/// What cases are stepped against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stepping {
    /// Its simulator.
    pub(super) simulator: SimulatorPlan,
    /// Series that are recorded of torsion, in a motion that is kept.
    pub(super) recorded: usize,
    /// Taps of each response in torsion.
    pub(super) taps: usize,
    /// Whether motions are kept for the torque that turns the surface.
    pub(super) follows_surface: bool,
}

impl SystemPlan<'_> {
    /// Steps of its longest case.
    pub(super) fn steps(&self) -> f64 {
        plan::steps(self.longest_time, self.setting.sampling_frequency)
    }

    /// What its responses are built from without bending by poles.
    pub(super) fn request_of_taps(&self) -> Request {
        let mut request = self.request();
        let is_by_poles = |channel: &ChannelRequest| {
            *self.method == Method::Poles && matches!(channel, ChannelRequest::Bending { .. })
        };
        request.channels.retain(|channel| !is_by_poles(channel));
        request
    }

    /// What its responses are built from.
    pub(super) fn request(&self) -> Request {
        let setting = self.setting;
        let sites = setting.sites.len();
        let torques = match &setting.lateral {
            // Where the string rubs along its well, torques act on its nodes.
            _ if setting.friction.is_some() => Vec::new(),
            // Friction turns the string wherever it touches the wall.
            Some(_) => (0..sites).collect(),
            // A drive whose torque is limited turns what is only observed, too.
            None if setting.drive_limit.is_some() => (0..sites).collect(),
            None if self.cuts => vec![sites - 1],
            None => Vec::new(),
        };
        let in_bending = (setting.lateral.as_ref()).map(|lateral| ChannelRequest::Bending {
            bending: lateral.bending,
            support: lateral.support,
        });
        let along = setting
            .cutting
            .as_ref()
            .map(|cutting| ChannelRequest::Axial {
                rod: Box::new(cutting.rod.clone()),
                forces: vec![sites - 1],
            });
        let in_torsion = ChannelRequest::Torsion { torques };
        Request {
            sites: setting.sites.clone(),
            channels: std::iter::once(in_torsion)
                .chain(in_bending)
                .chain(along)
                .collect(),
            sampling_frequency: setting.sampling_frequency,
            longest_time: self.longest_time,
        }
    }
}

impl Stepping {
    /// Bytes of a case, with its motion where that is kept.
    pub(super) fn case_bytes(&self, keeps_motion: bool) -> f64 {
        let motion = self.simulator.recorded_bytes(self.recorded);
        let keeps_motion = keeps_motion || self.follows_surface;
        self.simulator.case_bytes() + if keeps_motion { motion } else { 0.0 }
    }
}
