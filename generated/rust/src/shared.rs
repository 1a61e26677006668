//! Shared data (0xFF): Fields that every data set can hold. No packet has this set: they come in
//! packets of the other data sets.
//!
//! - Manual 3dm-cv7-gnss-ins: Shared (0xFF)
//! - Manual 3dm-cv7-gnss-ins: Shared Data Descriptors

use crate::macros::bitfield;
use crate::{DecodeError, EncodeError, Field, Reader, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0xFF;

bitfield! {
    /// Which parts of the GPS time are valid.
    GpsTimestampFlags: u16 {
        /// The whole seconds of the time of week have been set.
        TOW: bool = 0,
            "tow", tow, set_tow, with_tow;
        /// The week number has been set.
        WEEK_NUMBER: bool = 1,
            "week_number", week_number, set_week_number, with_week_number;
        /// Both are set.
        TIME_VALID: u8 = 0..=1,
            "time_valid", time_valid, set_time_valid, with_time_valid;
    }
}

bitfield! {
    /// Whether the external time is valid.
    ExternalTimestampFlags: u16 {
        /// The time is valid.
        NANOSECONDS: bool = 0,
            "nanoseconds", nanoseconds, set_nanoseconds, with_nanoseconds;
    }
}

bitfield! {
    /// Whether the difference of external time is valid.
    ExternalTimeDeltaFlags: u16 {
        /// The difference is valid.
        DT_NANOS: bool = 0,
            "dt_nanos", dt_nanos, set_dt_nanos, with_dt_nanos;
    }
}

/// Event source (0xFF,0xD0).
///
/// The event trigger that caused the packet.
///
/// - Put it first in the format of event messages, to tell their packets from scheduled ones.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Event Source (0xFF,0xD0)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EventSource {
    /// Id of the trigger; 0 means that the packet was scheduled by the message format (0x0C,0x0F).
    pub trigger_id: u8,
}

impl Wire for EventSource {
    const SIZE: usize = 1;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let trigger_id = reader.read()?;
        Ok(Self { trigger_id })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.trigger_id)?;
        Ok(())
    }
}

impl Field for EventSource {
    const SET: u8 = 0xFF;
    const DESCRIPTOR: u8 = 0xD0;
    const NAME: &'static str = "shared.event_source";

    fn in_set(set: u8) -> bool {
        matches!(set, 0x80..=0xFF)
    }
}

/// Ticks (0xFF,0xD1).
///
/// Base periods since power-up.
///
/// - One tick is one period of the base rate.
/// - Manual mip-sdk-4: Ticks (0xFF,0xD1)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ticks {
    /// Ticks.
    ///
    /// Unit: 1.
    pub ticks: u32,
}

impl Wire for Ticks {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let ticks = reader.read()?;
        Ok(Self { ticks })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.ticks)?;
        Ok(())
    }
}

impl Field for Ticks {
    const SET: u8 = 0xFF;
    const DESCRIPTOR: u8 = 0xD1;
    const NAME: &'static str = "shared.ticks";

    fn in_set(set: u8) -> bool {
        matches!(set, 0x80..=0xFF)
    }
}

/// Delta ticks (0xFF,0xD2).
///
/// Base periods since this field was last sent.
///
/// - One tick is one period of the base rate.
/// - Manual mip-sdk-4: Delta Ticks (0xFF,0xD2)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DeltaTicks {
    /// Ticks.
    ///
    /// Unit: 1.
    pub ticks: u32,
}

impl Wire for DeltaTicks {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let ticks = reader.read()?;
        Ok(Self { ticks })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.ticks)?;
        Ok(())
    }
}

impl Field for DeltaTicks {
    const SET: u8 = 0xFF;
    const DESCRIPTOR: u8 = 0xD2;
    const NAME: &'static str = "shared.delta_ticks";

    fn in_set(set: u8) -> bool {
        matches!(set, 0x80..=0xFF)
    }
}

/// GPS timestamp (0xFF,0xD3).
///
/// External time of the data as GPS time of week and week number.
///
/// - In event messages it is the time of the trigger.
/// - It becomes valid after the PPS is locked and (0x01,0x72) has set the time of week and the week
///   number.
/// - An internal GNSS receiver as PPS source sets the time by itself.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: GPS Timestamp (0xFF,0xD3)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GpsTimestamp {
    /// GPS time of week.
    ///
    /// Unit: s; valid if `valid_flags.tow` is set.
    pub tow: f64,
    /// GPS week number.
    ///
    /// Unit: week; valid if `valid_flags.week_number` is set.
    pub week_number: u16,
    /// Which parts are valid.
    pub valid_flags: GpsTimestampFlags,
}

impl Wire for GpsTimestamp {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let tow = reader.read()?;
        let week_number = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self { tow, week_number, valid_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.tow)?;
        writer.write(&self.week_number)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for GpsTimestamp {
    const SET: u8 = 0xFF;
    const DESCRIPTOR: u8 = 0xD3;
    const NAME: &'static str = "shared.gps_timestamp";

    fn in_set(set: u8) -> bool {
        matches!(set, 0x80..=0xFF)
    }
}

/// Delta time (0xFF,0xD4).
///
/// External time since this field was last sent in the same set and event instance.
///
/// - It is the same as external time delta (0xFF,0xD8), in other units.
/// - Sending either restarts the counter that both share, so use only one of them.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Delta Time (0xFF,0xD4)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DeltaTime {
    /// Time since the last output.
    ///
    /// Unit: s.
    pub seconds: f64,
}

impl Wire for DeltaTime {
    const SIZE: usize = 8;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let seconds = reader.read()?;
        Ok(Self { seconds })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.seconds)?;
        Ok(())
    }
}

impl Field for DeltaTime {
    const SET: u8 = 0xFF;
    const DESCRIPTOR: u8 = 0xD4;
    const NAME: &'static str = "shared.delta_time";

    fn in_set(set: u8) -> bool {
        matches!(set, 0x80..=0xFF)
    }
}

/// Reference timestamp (0xFF,0xD5).
///
/// Time of the data by the internal reference clock.
///
/// - The clock starts at power-on, only moves forward and never jumps; the value is always valid.
/// - In event messages it is the time of the trigger.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Reference Timestamp (0xFF,0xD5)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ReferenceTimestamp {
    /// Time since initialization.
    ///
    /// Unit: ns.
    pub nanoseconds: u64,
}

impl Wire for ReferenceTimestamp {
    const SIZE: usize = 8;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let nanoseconds = reader.read()?;
        Ok(Self { nanoseconds })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.nanoseconds)?;
        Ok(())
    }
}

impl Field for ReferenceTimestamp {
    const SET: u8 = 0xFF;
    const DESCRIPTOR: u8 = 0xD5;
    const NAME: &'static str = "shared.reference_timestamp";

    fn in_set(set: u8) -> bool {
        matches!(set, 0x80..=0xFF)
    }
}

/// Reference time delta (0xFF,0xD6).
///
/// Reference time since this field was last sent in the same set and event instance.
///
/// - The value is always valid.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Reference Time Delta (0xFF,0xD6)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ReferenceTimeDelta {
    /// Time since the last output.
    ///
    /// Unit: ns.
    pub dt_nanos: u64,
}

impl Wire for ReferenceTimeDelta {
    const SIZE: usize = 8;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let dt_nanos = reader.read()?;
        Ok(Self { dt_nanos })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.dt_nanos)?;
        Ok(())
    }
}

impl Field for ReferenceTimeDelta {
    const SET: u8 = 0xFF;
    const DESCRIPTOR: u8 = 0xD6;
    const NAME: &'static str = "shared.reference_time_delta";

    fn in_set(set: u8) -> bool {
        matches!(set, 0x80..=0xFF)
    }
}

/// External timestamp (0xFF,0xD7).
///
/// Time of the data in the external clock domain.
///
/// - It is the GPS timestamp (0xFF,0xD3) in nanoseconds.
/// - In event messages it is the time of the trigger.
/// - It becomes valid when the external clock is synchronized through the PPS.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: External Timestamp (0xFF,0xD7)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ExternalTimestamp {
    /// External time.
    ///
    /// Unit: ns; valid if `valid_flags.nanoseconds` is set.
    pub nanoseconds: u64,
    /// Whether the time is valid.
    pub valid_flags: ExternalTimestampFlags,
}

impl Wire for ExternalTimestamp {
    const SIZE: usize = 10;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let nanoseconds = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self { nanoseconds, valid_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.nanoseconds)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for ExternalTimestamp {
    const SET: u8 = 0xFF;
    const DESCRIPTOR: u8 = 0xD7;
    const NAME: &'static str = "shared.external_timestamp";

    fn in_set(set: u8) -> bool {
        matches!(set, 0x80..=0xFF)
    }
}

/// External time delta (0xFF,0xD8).
///
/// External time since this field was last sent in the same set and event instance.
///
/// - It is the same as delta time (0xFF,0xD4), in other units.
/// - Sending either restarts the counter that both share, so use only one of them.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: External Time Delta (0xFF,0xD8)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ExternalTimeDelta {
    /// Time since the last output.
    ///
    /// Unit: ns; valid if `valid_flags.dt_nanos` is set.
    pub dt_nanos: u64,
    /// Whether the difference is valid.
    pub valid_flags: ExternalTimeDeltaFlags,
}

impl Wire for ExternalTimeDelta {
    const SIZE: usize = 10;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let dt_nanos = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self { dt_nanos, valid_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.dt_nanos)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for ExternalTimeDelta {
    const SET: u8 = 0xFF;
    const DESCRIPTOR: u8 = 0xD8;
    const NAME: &'static str = "shared.external_time_delta";

    fn in_set(set: u8) -> bool {
        matches!(set, 0x80..=0xFF)
    }
}
