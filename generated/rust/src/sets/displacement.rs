//! Displacement commands (0x11): Commands of the DEMOD-DC, a demodulator for displacement sensors.
//! Inertial sensors have none of them.
//!
//! Source: mscl: Displacement Commands (0x11).

// What the macros make, which `cargo doc` shows and `src/macros` defines:
// `open_enum!` and `bitfield!` types of values; `record!` a structure with its codec; `union!` its
// alternatives; `view!` methods that read single values; `constructors!` and `setters!` what makes
// it; `field!` its sets and descriptor; `command!` and `responses!` how it is answered.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const DISPLACEMENT_SET: u8 = 0x11;
