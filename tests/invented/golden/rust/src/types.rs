//! Types that several descriptor sets share.

use crate::macros::{bitfield, open_enum, vector};
use crate::{DecodeError, EncodeError, Reader, Wire, Writer};

open_enum! {
    /// What a settings command is asked to do.
    FunctionSelector: u8 {
        /// Apply the new setting.
        WRITE = 1, "write";
        /// Send the current setting back in a response.
        READ = 2, "read";
        /// Save the current setting to non-volatile memory.
        SAVE = 3, "save";
        /// Load the saved setting.
        LOAD = 4, "load";
        /// Load the factory default setting.
        DEFAULT = 5, "default";
        /// Apply the new setting and send no acknowledge (5-series devices).
        APPLY = 6, "apply";
    }
}

vector! {
    /// Three floats.
    Vector3f: [f32; 3] {
        /// The element x.
        x,
        /// The element y.
        y,
        /// The element z.
        z,
    }
}

vector! {
    /// A quaternion, scalar part first.
    Quatf: [f32; 4] {
        /// The element w.
        w,
        /// The element x.
        x,
        /// The element y.
        y,
        /// The element z.
        z,
    }
}

open_enum! {
    /// The result of a command.
    AckCode: u8 {
        /// Done.
        OK = 0, "ok";
        /// No such command.
        UNKNOWN_COMMAND = 1, "unknown_command";
        /// A parameter is out of range.
        INVALID_PARAMETER = 3, "invalid_parameter";
    }
}

open_enum! {
    /// What the device does.
    Mode: u8 {
        /// A keyword in three languages.
        DEFAULT = 0, "default";
        /// Quick.
        FAST = 1, "fast";
        /// Careful. Deprecated.
        SLOW = 2, "slow";
    }
}

open_enum! {
    /// An enumeration over four bytes.
    WideCode: u32 {
        /// Low.
        LOW = 1, "low";
        /// High.
        HIGH = 4294901760, "high";
    }
}

bitfield! {
    /// Bits of all kinds.
    StateFlags: u16 {
        /// Ready to measure.
        READY: bool = 0,
            "ready", ready, set_ready, with_ready;
        /// Too hot.
        HOT: bool = 1,
            "hot", hot, set_hot, with_hot;
        /// A number from 0 to 7.
        LEVEL: u8 = 4..=6,
            "level", level, set_level, with_level;
        /// An enumeration inside the bitfield.
        MODE: Mode = 8..=9,
            "mode", mode, set_mode, with_mode;
        /// Ready or hot.
        ANY: u8 = 0..=1,
            "any", any, set_any, with_any;
    }
}

bitfield! {
    /// One hundred and twenty-eight bits, least significant byte first.
    Health: [u8; 16] {
        /// The clock has failed.
        CLOCK: bool = 0,
            "clock", clock, set_clock, with_clock;
        /// The supply is out of range.
        POWER: bool = 9,
            "power", power, set_power, with_power;
        /// A number across two bytes.
        COUNT: u8 = 30..=33,
            "count", count, set_count, with_count;
        /// The very last bit.
        LAST: bool = 127,
            "last", last, set_last, with_last;
    }
}

/// A place in a plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Point {
    /// Eastward.
    ///
    /// Unit: m.
    pub x: i16,
    /// Northward.
    ///
    /// Unit: m.
    pub y: i16,
}

impl Point {
    /// Puts the values together.
    #[must_use]
    pub fn new(x: i16, y: i16) -> Self {
        Self { x, y }
    }
}

impl Wire for Point {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let x = reader.read()?;
        let y = reader.read()?;
        Ok(Self { x, y })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.x)?;
        writer.write(&self.y)?;
        Ok(())
    }
}

/// Two places, nested.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Segment {
    /// Begins here.
    pub from: Point,
    /// Ends here.
    pub to: Point,
    /// Of its ends.
    pub weights: [u8; 2],
}

impl Segment {
    /// Puts the values together.
    #[must_use]
    pub fn new(from: Point, to: Point, weights: [u8; 2]) -> Self {
        Self { from, to, weights }
    }
}

impl Wire for Segment {
    const SIZE: usize = 10;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let from = reader.read()?;
        let to = reader.read()?;
        let weights = reader.read()?;
        Ok(Self { from, to, weights })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.from)?;
        writer.write(&self.to)?;
        writer.write(&self.weights)?;
        Ok(())
    }
}

/// How the Model B reads it.
impl From<AckCode> for Mode {
    fn from(value: AckCode) -> Self {
        Self(value.0)
    }
}
