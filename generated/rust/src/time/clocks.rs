//! The clocks of timestamps.

#[allow(unused_imports)] // if there are none
use super::{Flag, Part, Place, Reading, Source};

/// A clock of timestamps. Of several, the first is to be preferred.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Clock {
    /// GPS time, once a receiver, a PPS or the host has set it. Unix (POSIX) time is 315964800 s
    /// more, less the leap seconds.
    #[cfg_attr(feature = "serde", serde(rename = "gps"))]
    Gps,
    /// Nanoseconds of the clock that is synchronized to the PPS.
    #[cfg_attr(feature = "serde", serde(rename = "external"))]
    External,
    /// Nanoseconds since power-on, by the clock of the device.
    #[cfg_attr(feature = "serde", serde(rename = "reference"))]
    Reference,
    /// Seconds since power-on, which a device without GPS time sends as the time of week.
    #[cfg_attr(feature = "serde", serde(rename = "device"))]
    Device,
}

#[rustfmt::skip]
impl Clock {
    /// All clocks.
    pub const ALL: &'static [Self] = &[Self::Gps, Self::External, Self::Reference, Self::Device];

    /// Returns the name in the specification.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Gps => "gps",
            Self::External => "external",
            Self::Reference => "reference",
            Self::Device => "device",
        }
    }

    /// Returns the epoch in seconds since 1970; `None` for a clock that starts with the device.
    pub(super) fn epoch(self) -> Option<i64> {
        EPOCHS.iter().find(|(clock, _)| *clock == self).map(|(_, epoch)| *epoch)
    }
}

const EPOCHS: &[(Clock, i64)] = &[(Clock::Gps, 315964800)];

impl super::Utc {
    /// Converts nanoseconds of the clock [`Clock::Gps`] since 1980-01-06.
    #[must_use]
    pub fn from_gps(nanoseconds: i64) -> Self {
        Self::from_clock(Clock::Gps, nanoseconds).unwrap_or(Self(0)) // it has an epoch
    }
}

/// The beginning of each day on which a leap second counts for the first time, in seconds since
/// 1970, and the seconds by which clocks with an epoch are ahead of UTC from then on.
#[rustfmt::skip]
pub(super) const LEAP_SECONDS: [(i64, i64); 18] = [
    (362793600, 1),
    (394329600, 2),
    (425865600, 3),
    (489024000, 4),
    (567993600, 5),
    (631152000, 6),
    (662688000, 7),
    (709948800, 8),
    (741484800, 9),
    (773020800, 10),
    (820454400, 11),
    (867715200, 12),
    (915148800, 13),
    (1136073600, 14),
    (1230768000, 15),
    (1341100800, 16),
    (1435708800, 17),
    (1483228800, 18),
];

/// The fields that contain the time of their packet, by descriptor.
#[rustfmt::skip]
pub(super) const SOURCES: [Source; 6] = [
    // gnss_data.gps_time
    Source {
        sets: &[0x81, 0x91, 0x92, 0x94, 0x95],
        descriptor: 0x09,
        size: 12,
        clock: Clock::Gps,
        undated: None,
        parts: &[
            Part { place: Place { at: 0, size: 8, after: &[] }, scale: 1_000_000_000, is_float: true, is_signed: false, undated: true },
            Part { place: Place { at: 8, size: 2, after: &[] }, scale: 604_800_000_000_000, is_float: false, is_signed: false, undated: false },
        ],
        readings: &[
            Reading {
                devices: &[],
                flags: &[
                    Flag { place: Place { at: 10, size: 2, after: &[] }, mask: 0x01 },
                    Flag { place: Place { at: 10, size: 2, after: &[] }, mask: 0x02 },
                ],
                fewer: 0x00,
            },
        ],
    },
    // filter_data.timestamp
    Source {
        sets: &[0x82],
        descriptor: 0x11,
        size: 12,
        clock: Clock::Gps,
        undated: Some(Clock::Device),
        parts: &[
            Part { place: Place { at: 0, size: 8, after: &[] }, scale: 1_000_000_000, is_float: true, is_signed: false, undated: true },
            Part { place: Place { at: 8, size: 2, after: &[] }, scale: 604_800_000_000_000, is_float: false, is_signed: false, undated: false },
        ],
        readings: &[
            Reading {
                devices: &[],
                flags: &[
                    Flag { place: Place { at: 10, size: 2, after: &[] }, mask: 0x01 },
                ],
                fewer: 0x00,
            },
        ],
    },
    // sensor.gps_timestamp
    Source {
        sets: &[0x80],
        descriptor: 0x12,
        size: 12,
        clock: Clock::Gps,
        undated: Some(Clock::Device),
        parts: &[
            Part { place: Place { at: 0, size: 8, after: &[] }, scale: 1_000_000_000, is_float: true, is_signed: false, undated: true },
            Part { place: Place { at: 8, size: 2, after: &[] }, scale: 604_800_000_000_000, is_float: false, is_signed: false, undated: false },
        ],
        readings: &[
            Reading {
                devices: &["3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-45", "3dm-dh3", "3dm-gq4-45", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx4-imu", "3dm-gx5-15", "3dm-gx5-25", "3dm-gx5-35", "3dm-gx5-45", "3dm-mv5-ar", "3dm-rq1-45-lt", "3dm-rq1-45-st", "3dm-rq1-imu"],
                flags: &[
                    Flag { place: Place { at: 10, size: 2, after: &[] }, mask: 0x04 },
                ],
                fewer: 0xFFF8,
            },
            Reading {
                devices: &[],
                flags: &[
                    Flag { place: Place { at: 10, size: 2, after: &[] }, mask: 0x08 },
                    Flag { place: Place { at: 10, size: 2, after: &[] }, mask: 0x10 },
                ],
                fewer: 0x00,
            },
        ],
    },
    // shared.gps_timestamp
    Source {
        sets: &[0xFF],
        descriptor: 0xD3,
        size: 12,
        clock: Clock::Gps,
        undated: Some(Clock::Device),
        parts: &[
            Part { place: Place { at: 0, size: 8, after: &[] }, scale: 1_000_000_000, is_float: true, is_signed: false, undated: true },
            Part { place: Place { at: 8, size: 2, after: &[] }, scale: 604_800_000_000_000, is_float: false, is_signed: false, undated: false },
        ],
        readings: &[
            Reading {
                devices: &[],
                flags: &[
                    Flag { place: Place { at: 10, size: 2, after: &[] }, mask: 0x01 },
                    Flag { place: Place { at: 10, size: 2, after: &[] }, mask: 0x02 },
                ],
                fewer: 0x00,
            },
        ],
    },
    // shared.reference_timestamp
    Source {
        sets: &[0xFF],
        descriptor: 0xD5,
        size: 8,
        clock: Clock::Reference,
        undated: None,
        parts: &[
            Part { place: Place { at: 0, size: 8, after: &[] }, scale: 1, is_float: false, is_signed: false, undated: true },
        ],
        readings: &[],
    },
    // shared.external_timestamp
    Source {
        sets: &[0xFF],
        descriptor: 0xD7,
        size: 10,
        clock: Clock::External,
        undated: None,
        parts: &[
            Part { place: Place { at: 0, size: 8, after: &[] }, scale: 1, is_float: false, is_signed: false, undated: true },
        ],
        readings: &[
            Reading {
                devices: &[],
                flags: &[
                    Flag { place: Place { at: 8, size: 2, after: &[] }, mask: 0x01 },
                ],
                fewer: 0x00,
            },
        ],
    },
];
