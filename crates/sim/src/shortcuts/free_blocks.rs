//! Blocks of steps in which nothing disturbs the sites and none reaches its wall: out of
//! contact the string is linear, and what the past makes of a block is known before it
//! is stepped. Where a bit cuts, or a drive's torque is limited, there are none, for these act in
//! every step; nor of a string that lies on its wall or is held by springs, or where every
//! acceleration counts.

use crate::convolution::partition::FIRST_BLOCK;
use crate::laws::contact::WallLaw;
use crate::laws::torque::TorqueLaw;
use crate::scene::{Lateral, Scene};
use crate::stepper::Stepper;
use crate::system::System;
use crate::watch::lateral::WallWatch;

/// Passes a whole block, or what is left of the time, in which nothing disturbs the sites
/// and none reaches its wall: its motion is the one that stepping would give. Returns
/// how many steps that were.
pub(crate) fn pass_free_block<B: TorqueLaw, W: WallLaw>(
    system: &System,
    scene: &Scene<B, W>,
    stepper: &mut Stepper<B, W>,
    watch: &mut WallWatch,
) -> usize {
    let step = stepper.next_step();
    let count = FIRST_BLOCK.min(stepper.steps() - step);
    let acts_above = system.drive.is_some();
    let turns_freely = !scene.turns_against_rock() && scene.friction.is_empty() && !acts_above;
    let Some(lateral) = scene.lateral.as_ref().filter(|_| turns_freely) else {
        return 0;
    };
    let is_watched = lateral.lying.is_some() || lateral.shocks.is_some();
    if is_watched || !system.springs.is_empty() {
        return 0;
    }
    if count == 0
        || !is_quiet(
            lateral,
            system.sampling.start_of(step),
            system.sampling.start_of(step + FIRST_BLOCK),
        )
    {
        return 0;
    }
    let Some(motion) = stepper.free_block() else {
        return 0;
    };
    let (x, y) = motion.split_at(motion.len() / 2);
    let clearances = lateral.walls.iter().map(WallLaw::clearance);
    let blocks = x.chunks_exact(FIRST_BLOCK).zip(y.chunks_exact(FIRST_BLOCK));
    let is_free = blocks.zip(clearances).all(|((x, y), clearance)| {
        // Counted, because the maximum of some numbers ignores NaN.
        let radii = (x.iter().zip(y)).map(|(x, y)| x * x + y * y);
        let within = radii.filter(|square| *square <= clearance * clearance);
        within.count() == FIRST_BLOCK
    });
    if !is_free {
        return 0;
    }
    watch.see_free_block(x, y, FIRST_BLOCK, count);
    let positions = stepper.end_of_block(x, y, FIRST_BLOCK);
    stepper.pass_block(count, &positions);
    count
}

/// Whether nothing disturbs the sites from one time to before another, s.
fn is_quiet<W>(lateral: &Lateral<W>, from: f64, to: f64) -> bool {
    let mut impulses = lateral.impulses.iter();
    lateral.eccentric_masses.is_empty() && impulses.all(|impulse| impulse.is_quiet(from, to))
}
