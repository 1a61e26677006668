//! Measurements (0x80): Data of every type.

use crate::types;
use crate::{DecodeError, EncodeError, Field, Reader, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0x80;

/// Acceleration (0x80,0x01).
///
/// A vector whose elements are valid together.
///
/// At most 100 Hz. Supported by Model A and Model B.
///
/// - Manual guide: Acceleration
/// - Manual leaflet: Acceleration
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Accel {
    /// Specific force.
    ///
    /// Unit: g; frame: sensor; valid if `valid_flags.ready, valid_flags.hot` is set.
    ///
    /// - On model-b: unit m, m, s, frame ned; Turned by the device.
    pub scaled_accel: types::Vector3f,
    /// What is valid.
    pub valid_flags: types::StateFlags,
}

impl Wire for Accel {
    const SIZE: usize = 14;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let scaled_accel = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self { scaled_accel, valid_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.scaled_accel)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for Accel {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x01;
    const NAME: &'static str = "measurements.accel";

    fn in_set(set: u8) -> bool {
        matches!(set, 0x80 | 0x81)
    }
}

/// Numbers (0x80,0x02).
///
/// One of each.
///
/// Supported by Model A.
///
/// - Manual guide: Numbers
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Numbers {
    /// Unsigned.
    pub u8: u8,
    /// Unsigned.
    pub u16: u16,
    /// Unsigned.
    pub u32: u32,
    /// Unsigned.
    pub u64: u64,
    /// Signed.
    pub s8: i8,
    /// Signed.
    pub s16: i16,
    /// Signed.
    pub s32: i32,
    /// Signed.
    pub s64: i64,
    /// Four bytes.
    ///
    /// Unit: 1.
    pub float: f32,
    /// Eight bytes.
    ///
    /// Unit: 1.
    pub double: f64,
    /// True or false.
    pub bool: crate::Bool,
    /// One character.
    pub char: u8,
}

impl Wire for Numbers {
    const SIZE: usize = 44;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let u8 = reader.read()?;
        let u16 = reader.read()?;
        let u32 = reader.read()?;
        let u64 = reader.read()?;
        let s8 = reader.read()?;
        let s16 = reader.read()?;
        let s32 = reader.read()?;
        let s64 = reader.read()?;
        let float = reader.read()?;
        let double = reader.read()?;
        let bool = reader.read()?;
        let char = reader.read()?;
        Ok(Self { u8, u16, u32, u64, s8, s16, s32, s64, float, double, bool, char })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.u8)?;
        writer.write(&self.u16)?;
        writer.write(&self.u32)?;
        writer.write(&self.u64)?;
        writer.write(&self.s8)?;
        writer.write(&self.s16)?;
        writer.write(&self.s32)?;
        writer.write(&self.s64)?;
        writer.write(&self.float)?;
        writer.write(&self.double)?;
        writer.write(&self.bool)?;
        writer.write(&self.char)?;
        Ok(())
    }
}

impl Field for Numbers {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x02;
    const NAME: &'static str = "measurements.numbers";
}

/// Strings (0x80,0x03).
///
/// Fixed, counted, and to the end.
///
/// Supported by Model A.
///
/// - Manual guide: Strings
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Strings {
    /// Padded with spaces.
    pub model: crate::Text<16>,
    /// The name.
    pub name: crate::VarText<236>,
    /// All that follows.
    pub rest: crate::VarText<236>,
}

impl Wire for Strings {
    const SIZE: usize = 253;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let model = reader.read()?;
        let length = reader.read::<u8>()?;
        let name = reader.text(length)?;
        let rest = reader.rest_of_text()?;
        Ok(Self { model, name, rest })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.model)?;
        writer.count::<u8>(self.name.len())?;
        self.name.encode_items(writer)?;
        self.rest.encode_items(writer)?;
        Ok(())
    }
}

impl Field for Strings {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x03;
    const NAME: &'static str = "measurements.strings";

    fn in_set(set: u8) -> bool {
        matches!(set, 0x80 | 0x81)
    }
}

/// Health (0x80,0x04).
///
/// The wide bitfield.
///
/// Supported by Model A.
///
/// - Manual guide: Health
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[deprecated(note = "use measurements.numbers instead")]
pub struct Health {
    /// The bits.
    pub result: types::Health,
    /// An enumeration over four bytes.
    pub code: types::WideCode,
}

impl Wire for Health {
    const SIZE: usize = 20;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let result = reader.read()?;
        let code = reader.read()?;
        Ok(Self { result, code })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.result)?;
        writer.write(&self.code)?;
        Ok(())
    }
}

impl Field for Health {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x04;
    const NAME: &'static str = "measurements.health";
}

/// Arrays (0x80,0x05).
///
/// Arrays of all that can stand in one.
///
/// Supported by Model A.
///
/// - Manual guide: Arrays
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Arrays {
    /// Enumerations.
    pub modes: [types::Mode; 3],
    /// Bitfields.
    pub flags: [types::StateFlags; 2],
    /// Vectors.
    ///
    /// Unit: m.
    pub vectors: [types::Vector3f; 2],
    /// Structures.
    ///
    /// Unit: m.
    pub points: [types::Point; 2],
    /// A nested structure.
    pub track: types::Segment,
    /// Reserved.
    ///
    /// Send 0.
    pub offsets: [i8; 4],
}

impl Wire for Arrays {
    const SIZE: usize = 53;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let modes = reader.read()?;
        let flags = reader.read()?;
        let vectors = reader.read()?;
        let points = reader.read()?;
        let track = reader.read()?;
        let offsets = reader.read()?;
        Ok(Self { modes, flags, vectors, points, track, offsets })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.modes)?;
        writer.write(&self.flags)?;
        writer.write(&self.vectors)?;
        writer.write(&self.points)?;
        writer.write(&self.track)?;
        writer.write(&self.offsets)?;
        Ok(())
    }
}

impl Field for Arrays {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x05;
    const NAME: &'static str = "measurements.arrays";
}

/// Growing (0x80,0x06).
///
/// Newer devices send more of it.
///
/// Supported by Model A.
///
/// - Manual guide: Growing
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Growing {
    /// Always there.
    pub first: u16,
    /// From version 2 on.
    pub second: Option<u16>,
    /// From version 3 on.
    ///
    /// Unit: deg.
    pub third: Option<f32>,
}

impl Wire for Growing {
    const SIZE: usize = 8;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let first = reader.read()?;
        let second = reader.group(false, Reader::read)?;
        let third = reader.group(false, Reader::read)?;
        Ok(Self { first, second, third })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.first)?;
        writer.some(false, &self.second)?;
        writer.some(false, &self.third)?;
        Ok(())
    }
}

impl Field for Growing {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x06;
    const NAME: &'static str = "measurements.growing";
}
