//! The protocol itself: constants, and the acknowledge field.

pub use crate::types::AckCode;
pub use crate::types::FunctionSelector;

use crate::types;
use crate::{DecodeError, EncodeError, Field, Reader, Wire, Writer};

/// Version of the specification that this crate was made from.
pub const VERSION: &str = "0.1.0";
/// The two bytes that every packet begins with.
pub const SYNC: [u8; 2] = [0x75, 0x65];

/// Acknowledge (0x00,0xF1).
///
/// Answers one command field. A response, if there is one, follows it in the same packet.
///
/// - Manual 3dm-gx5-15: 2.2.2 Example “Ping” Reply Packet
/// - Manual 3dm-cv7-gnss-ins: Ack/Nack Field Specification
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Acknowledge {
    /// Descriptor of the command that is answered.
    pub command: u8,
    /// Zero acknowledges, any other value refuses.
    pub code: types::AckCode,
}

impl Wire for Acknowledge {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let command = reader.read()?;
        let code = reader.read()?;
        Ok(Self { command, code })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.command)?;
        writer.write(&self.code)?;
        Ok(())
    }
}

impl Field for Acknowledge {
    const SET: u8 = 0x00;
    const DESCRIPTOR: u8 = 0xF1;
    const NAME: &'static str = "protocol.acknowledge";

    fn in_set(set: u8) -> bool {
        matches!(set, 0x01..=0x7F)
    }
}
