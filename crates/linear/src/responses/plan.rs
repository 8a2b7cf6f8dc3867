//! Responses before they are built: their lengths, and the memory that they ask for.

use super::bending::{self, BendingPlan};
use super::channels::{ChannelResponses, Responses};
use super::earlier::Earlier;
use super::request::{ChannelRequest, Request};
use super::torsion::TorsionPlan;
use super::trains::ImpulseTrains;
use super::wanted::Wanted;
use crate::budget::{Budget, Need, OutOfBudget, What, Working};
use crate::drillstring::Drillstring;
use crate::error::BuildError;
use crate::method::Method;
use crate::parallel;

/// The responses of a string by one method before they are built.
#[derive(Debug)]
pub struct ResponsePlan<'a> {
    string: &'a Drillstring,
    method: &'a Method,
    request: &'a Request,
    channels: Vec<ChannelPlan<'a>>,
}

/// The same in one channel.
#[derive(Debug)]
enum ChannelPlan<'a> {
    /// Torsion or axial motion.
    Rod(TorsionPlan<'a>),
    Bending(BendingPlan<'a>),
    /// Taken over.
    Known(&'a ChannelResponses),
}

impl<'a> ResponsePlan<'a> {
    /// Of a request.
    ///
    /// # Errors
    /// Where a parameter is out of range, the method cannot treat the string, or the responses
    /// would be longer than any method makes them.
    pub fn new(
        string: &'a Drillstring,
        method: &'a Method,
        request: &'a Request,
    ) -> Result<Self, BuildError> {
        Self::from_parts(string, method, request, (None, None))
    }

    /// The same, with the trains of impulses of such a request that held responses in torsion
    /// are made of: those at many sampling frequencies then cost little more than those at one.
    ///
    /// # Errors
    /// As [`ResponsePlan::new`], and where the trains are those of another string or request.
    pub fn with_trains(
        string: &'a Drillstring,
        method: &'a Method,
        request: &'a Request,
        trains: &'a ImpulseTrains,
    ) -> Result<Self, BuildError> {
        Self::from_parts(string, method, request, (Some(trains), None))
    }

    /// The same after other responses, to the bit. Channels in which the string moves as before
    /// are taken over: with another torsional damping or top drive it bends as before.
    ///
    /// # Errors
    /// As [`ResponsePlan::new`].
    pub fn after(
        string: &'a Drillstring,
        method: &'a Method,
        request: &'a Request,
        earlier: Earlier<'a>,
    ) -> Result<Self, BuildError> {
        Self::from_parts(string, method, request, (None, Some(earlier)))
    }

    fn from_parts(
        string: &'a Drillstring,
        method: &'a Method,
        request: &'a Request,
        (trains, earlier): (Option<&'a ImpulseTrains>, Option<Earlier<'a>>),
    ) -> Result<Self, BuildError> {
        request.check(string)?;
        let plan = |wanted: &'a ChannelRequest| {
            let known = earlier.and_then(|it| it.channel(string, method, request, wanted));
            match (known, wanted) {
                (Some(known), _) => Ok(ChannelPlan::Known(known)),
                (None, ChannelRequest::Torsion { torques }) => {
                    let wanted = Wanted::Sites { torques };
                    TorsionPlan::new(string, method, request, wanted, trains).map(ChannelPlan::Rod)
                }
                (None, ChannelRequest::Axial { rod, forces }) => {
                    let wanted = Wanted::Sites { torques: forces };
                    TorsionPlan::new(rod, method, request, wanted, None).map(ChannelPlan::Rod)
                }
                (None, ChannelRequest::Bending { bending, support }) => {
                    let (bends, wanted) = ((bending, *support), bending::Wanted::Displacements);
                    BendingPlan::new(string, method, request, bends, wanted)
                        .map(ChannelPlan::Bending)
                }
            }
        };
        Ok(Self {
            string,
            method,
            request,
            channels: request
                .channels
                .iter()
                .map(plan)
                .collect::<Result<_, _>>()?,
        })
    }

    /// Taps of each response in torsion, at most; none where it is not asked for.
    pub fn torsion_taps(&self) -> usize {
        self.taps(|request| matches!(request, ChannelRequest::Torsion { .. }))
    }

    /// The same in bending.
    pub fn bending_taps(&self) -> usize {
        self.taps(|request| matches!(request, ChannelRequest::Bending { .. }))
    }

    /// The same in axial motion.
    pub fn axial_taps(&self) -> usize {
        self.taps(|request| matches!(request, ChannelRequest::Axial { .. }))
    }

    fn taps(&self, is_channel: impl Fn(&ChannelRequest) -> bool) -> usize {
        let mut channels = self.request.channels.iter().zip(&self.channels);
        let found = channels.find(|(request, _)| is_channel(request));
        found.map_or(0, |(_, plan)| plan.taps())
    }

    /// What building takes of a budget.
    ///
    /// # Errors
    /// Where that is more than is left.
    pub fn ask(&self, budget: &Budget) -> Result<(), OutOfBudget> {
        // Channels are built side by side.
        let channels = self.channels.iter();
        let working = channels.map(|channel| budget.begin(channel.need(), What::Responses));
        let working: Vec<Working> = working.collect::<Result<_, _>>()?;
        working.into_iter().for_each(Working::done);
        Ok(())
    }

    /// Builds the responses, which stay taken of a budget.
    ///
    /// # Errors
    /// Where they are not finite, last longer than they may, or ask for more memory than is left.
    pub fn build(&self, budget: &Budget) -> Result<Responses, BuildError> {
        let channels: Vec<Result<ChannelResponses, BuildError>> =
            parallel::map(self.channels.len(), 1, |channel| {
                self.channels[channel].build(budget)
            });
        let Request {
            sites,
            sampling_frequency,
            longest_time,
            ..
        } = self.request;
        Ok(Responses {
            string: self.string.id(),
            method: *self.method,
            sites: sites.clone(),
            sampling_frequency: *sampling_frequency,
            longest_time: *longest_time,
            channels: channels.into_iter().collect::<Result<_, _>>()?,
        })
    }
}

impl ChannelPlan<'_> {
    fn taps(&self) -> usize {
        match self {
            Self::Rod(plan) => plan.taps(),
            Self::Bending(plan) => plan.taps(),
            Self::Known(known) => known.taps(),
        }
    }

    fn need(&self) -> Need {
        match self {
            Self::Rod(plan) => plan.need(),
            Self::Bending(plan) => plan.need(),
            Self::Known(known) => Need::lasting(known.bytes()),
        }
    }

    fn build(&self, budget: &Budget) -> Result<ChannelResponses, BuildError> {
        match self {
            Self::Rod(plan) => plan.build(budget),
            Self::Bending(plan) => plan.build(budget),
            Self::Known(known) => {
                budget.reserve(known.bytes(), What::Responses)?.keep();
                Ok((*known).clone())
            }
        }
    }
}
