//! Awkward names (0x0C): Names that are keywords or begin with a digit.

use crate::{Command, DecodeError, EncodeError, Field, Reader, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0x0C;

/// Default (0x0C,0x10).
///
/// Its parameters are keywords here and there.
///
/// Supported by Model A.
///
/// - Manual guide: Default
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Default {
    /// A keyword.
    pub class: u8,
    /// A keyword.
    pub type_: u8,
    /// A keyword.
    pub register: u8,
    /// A keyword.
    pub self_: u8,
    /// Used by generated code elsewhere.
    pub present: u8,
}

impl Default {
    /// The command with its parameters.
    #[must_use]
    pub fn new(class: u8, type_: u8, register: u8, self_: u8, present: u8) -> Self {
        Self { class, type_, register, self_, present }
    }
}

impl Wire for Default {
    const SIZE: usize = 5;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let class = reader.read()?;
        let type_ = reader.read()?;
        let register = reader.read()?;
        let self_ = reader.read()?;
        let present = reader.read()?;
        Ok(Self { class, type_, register, self_, present })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.class)?;
        writer.write(&self.type_)?;
        writer.write(&self.register)?;
        writer.write(&self.self_)?;
        writer.write(&self.present)?;
        Ok(())
    }
}

impl Field for Default {
    const SET: u8 = 0x0C;
    const DESCRIPTOR: u8 = 0x10;
    const NAME: &'static str = "3d.default";
}

impl Command for Default {
    type Response = ();
}
