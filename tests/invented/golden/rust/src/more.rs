//! More measurements (0x81): A second sensor with the fields of the first.

use crate::types;
use crate::{DecodeError, EncodeError, Field, Reader, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0x81;

/// (0x81,0x01) Second acceleration: the same as [`measurements.accel`](crate::measurements::Accel).
///
/// - Manual guide: Second acceleration
pub type Accel = crate::measurements::Accel;

/// (0x81,0x03) Strings: the same as [`measurements.strings`](crate::measurements::Strings).
///
/// - Manual guide: Second strings
pub type Strings = crate::measurements::Strings;

/// Own (0x81,0x07).
///
/// Beside those that it repeats.
///
/// Supported by Model A.
///
/// - Manual guide: Own
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Own {
    /// Of the second sensor.
    pub mode: types::Mode,
}

impl Wire for Own {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let mode = reader.read()?;
        Ok(Self { mode })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.mode)?;
        Ok(())
    }
}

impl Field for Own {
    const SET: u8 = 0x81;
    const DESCRIPTOR: u8 = 0x07;
    const NAME: &'static str = "more.own";
}
