//! Displacement commands (0x11): Commands of the DEMOD-DC, a demodulator for displacement sensors.
//! Inertial sensors have none of them.
//!
//! Source: mscl: Displacement Commands (0x11).

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const DISPLACEMENT_SET: u8 = 0x11;
