//! What may be skipped, and why it may: each says on which condition its motion is the
//! one that stepping would give.

mod bit_alone;
mod free_blocks;
mod look_ahead;
mod stuck_torque;

pub(crate) use bit_alone::BitAlone;
pub(crate) use free_blocks::pass_free_block;
