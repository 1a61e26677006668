//! Shared (0xFF): Valid in every data set.

use crate::types;
use crate::{DecodeError, EncodeError, Field, Reader, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0xFF;

/// Timestamp (0xFF,0xD3).
///
/// When the packet was sent.
///
/// Supported by Model A.
///
/// - Manual guide: Timestamp
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Timestamp {
    /// Time of week.
    ///
    /// Unit: s; valid if `valid_flags.ready` is set.
    pub tow: f64,
    /// What is valid.
    pub valid_flags: types::StateFlags,
}

impl Wire for Timestamp {
    const SIZE: usize = 10;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let tow = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self { tow, valid_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.tow)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for Timestamp {
    const SET: u8 = 0xFF;
    const DESCRIPTOR: u8 = 0xD3;
    const NAME: &'static str = "shared.timestamp";

    fn in_set(set: u8) -> bool {
        matches!(set, 0x80..=0xFF)
    }
}
