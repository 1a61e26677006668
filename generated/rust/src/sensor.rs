//! Sensor data (0x80): Inertial, magnetic and pressure measurements, and the attitude of the
//! complementary filter.
//!
//! - Manual 3dm-gx5-15: 5.1 IMU Data
//! - Manual 3dm-cv7-gnss-ins: Sensor (0x80)

use crate::macros::bitfield;
use crate::types;
use crate::{DecodeError, EncodeError, Field, Reader, Wire, Writer};

/// The number of the descriptor set.
pub const SET: u8 = 0x80;

bitfield! {
    /// Sensor axes that were near or outside their range.
    OverrangeFlags: u16 {
        /// Accelerometer X axis.
        ACCEL_X: bool = 0,
            "accel_x", accel_x, set_accel_x, with_accel_x;
        /// Accelerometer Y axis.
        ACCEL_Y: bool = 1,
            "accel_y", accel_y, set_accel_y, with_accel_y;
        /// Accelerometer Z axis.
        ACCEL_Z: bool = 2,
            "accel_z", accel_z, set_accel_z, with_accel_z;
        /// Gyroscope X axis.
        GYRO_X: bool = 4,
            "gyro_x", gyro_x, set_gyro_x, with_gyro_x;
        /// Gyroscope Y axis.
        GYRO_Y: bool = 5,
            "gyro_y", gyro_y, set_gyro_y, with_gyro_y;
        /// Gyroscope Z axis.
        GYRO_Z: bool = 6,
            "gyro_z", gyro_z, set_gyro_z, with_gyro_z;
        /// Magnetometer X axis.
        MAG_X: bool = 8,
            "mag_x", mag_x, set_mag_x, with_mag_x;
        /// Magnetometer Y axis.
        MAG_Y: bool = 9,
            "mag_y", mag_y, set_mag_y, with_mag_y;
        /// Magnetometer Z axis.
        MAG_Z: bool = 10,
            "mag_z", mag_z, set_mag_z, with_mag_z;
        /// Pressure sensor.
        PRESS: bool = 12,
            "press", press, set_press, with_press;
    }
}

bitfield! {
    /// Whether the odometer values are valid.
    OdometerFlags: u16 {
        /// The odometer is configured.
        ODOMETER: bool = 0,
            "odometer", odometer, set_odometer, with_odometer;
    }
}

/// Raw accel (0x80,0x01).
///
/// Raw acceleration in counts of the sensor, temperature compensated.
///
/// - Manual mip-sdk-4: Raw Accel (0x80,0x01)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RawAccel {
    /// Acceleration in counts.
    ///
    /// Unit: 1; frame: sensor.
    pub raw_accel: types::Vector3f,
}

impl Wire for RawAccel {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let raw_accel = reader.read()?;
        Ok(Self { raw_accel })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.raw_accel)?;
        Ok(())
    }
}

impl Field for RawAccel {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x01;
    const NAME: &'static str = "sensor.raw_accel";
}

/// Raw gyro (0x80,0x02).
///
/// Raw angular rate in counts of the sensor, temperature compensated.
///
/// - Manual mip-sdk-4: Raw Gyro (0x80,0x02)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RawGyro {
    /// Angular rate in counts.
    ///
    /// Unit: 1; frame: sensor.
    pub raw_gyro: types::Vector3f,
}

impl Wire for RawGyro {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let raw_gyro = reader.read()?;
        Ok(Self { raw_gyro })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.raw_gyro)?;
        Ok(())
    }
}

impl Field for RawGyro {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x02;
    const NAME: &'static str = "sensor.raw_gyro";
}

/// Raw mag (0x80,0x03).
///
/// Raw magnetic field in counts of the sensor, temperature compensated.
///
/// - Manual mip-sdk-4: Raw Mag (0x80,0x03)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RawMag {
    /// Magnetic field in counts.
    ///
    /// Unit: 1; frame: vehicle.
    pub raw_mag: types::Vector3f,
}

impl Wire for RawMag {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let raw_mag = reader.read()?;
        Ok(Self { raw_mag })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.raw_mag)?;
        Ok(())
    }
}

impl Field for RawMag {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x03;
    const NAME: &'static str = "sensor.raw_mag";
}

/// Scaled accel (0x80,0x04).
///
/// Measured acceleration, temperature compensated.
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 5.1.1 Scaled Accelerometer Vector (0x80, 0x04)
/// - Manual 3dm-cv7-gnss-ins: Scaled Accel (0x80,0x04)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ScaledAccel {
    /// Acceleration.
    ///
    /// Unit: g; frame: vehicle.
    pub scaled_accel: types::Vector3f,
}

impl Wire for ScaledAccel {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let scaled_accel = reader.read()?;
        Ok(Self { scaled_accel })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.scaled_accel)?;
        Ok(())
    }
}

impl Field for ScaledAccel {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x04;
    const NAME: &'static str = "sensor.scaled_accel";
}

/// Scaled gyro (0x80,0x05).
///
/// Measured angular rate, temperature compensated.
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 5.1.2 Scaled Gyro Vector (0x80, 0x05)
/// - Manual 3dm-cv7-gnss-ins: Scaled Gyro (0x80,0x05)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ScaledGyro {
    /// Angular rate.
    ///
    /// Unit: rad/s; frame: vehicle.
    pub scaled_gyro: types::Vector3f,
}

impl Wire for ScaledGyro {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let scaled_gyro = reader.read()?;
        Ok(Self { scaled_gyro })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.scaled_gyro)?;
        Ok(())
    }
}

impl Field for ScaledGyro {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x05;
    const NAME: &'static str = "sensor.scaled_gyro";
}

/// Scaled mag (0x80,0x06).
///
/// Measured magnetic field, temperature compensated.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Scaled Mag (0x80,0x06)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ScaledMag {
    /// Magnetic field.
    ///
    /// Unit: gauss; frame: vehicle.
    pub scaled_mag: types::Vector3f,
}

impl Wire for ScaledMag {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let scaled_mag = reader.read()?;
        Ok(Self { scaled_mag })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.scaled_mag)?;
        Ok(())
    }
}

impl Field for ScaledMag {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x06;
    const NAME: &'static str = "sensor.scaled_mag";
}

/// Delta theta (0x80,0x07).
///
/// Time integral of the angular rate over the period that the message format sets.
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 5.1.4 Delta Theta Vector (0x80, 0x07)
/// - Manual 3dm-cv7-gnss-ins: Delta Theta (0x80,0x07)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DeltaTheta {
    /// Integral of the angular rate.
    ///
    /// Unit: rad; frame: vehicle.
    pub delta_theta: types::Vector3f,
}

impl Wire for DeltaTheta {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let delta_theta = reader.read()?;
        Ok(Self { delta_theta })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.delta_theta)?;
        Ok(())
    }
}

impl Field for DeltaTheta {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x07;
    const NAME: &'static str = "sensor.delta_theta";
}

/// Delta velocity (0x80,0x08).
///
/// Time integral of the acceleration over the period that the message format sets.
///
/// - Multiply by 9.80665 m/s^2 for a change of velocity in metres per second.
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 5.1.5 Delta Velocity Vector (0x80, 0x08)
/// - Manual 3dm-cv7-gnss-ins: Delta Velocity (0x80,0x08)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DeltaVelocity {
    /// Integral of the acceleration.
    ///
    /// Unit: g\*s; frame: vehicle.
    pub delta_velocity: types::Vector3f,
}

impl Wire for DeltaVelocity {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let delta_velocity = reader.read()?;
        Ok(Self { delta_velocity })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.delta_velocity)?;
        Ok(())
    }
}

impl Field for DeltaVelocity {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x08;
    const NAME: &'static str = "sensor.delta_velocity";
}

/// Complementary filter orientation matrix (0x80,0x09).
///
/// Attitude by the complementary filter as a direction cosine matrix, relative to the NED frame.
///
/// - v_vehicle = M \* v_ned; v_sensor in place of v_vehicle on the 3DM-GX5-15.
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 5.1.6 CF Orientation Matrix (0x80, 0x09)
/// - Manual 3dm-cv7-gnss-ins: Complementary Filter Orientation Matrix (0x80,0x09)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ComplementaryFilterOrientationMatrix {
    /// Rotation from the NED frame to the vehicle frame.
    ///
    /// Unit: 1.
    ///
    /// - On 3dm-gx5-15: From the NED frame to the sensor frame.
    pub m: types::Matrix3f,
}

impl Wire for ComplementaryFilterOrientationMatrix {
    const SIZE: usize = 36;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let m = reader.read()?;
        Ok(Self { m })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.m)?;
        Ok(())
    }
}

impl Field for ComplementaryFilterOrientationMatrix {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x09;
    const NAME: &'static str = "sensor.complementary_filter_orientation_matrix";
}

/// Complementary filter quaternion (0x80,0x0A).
///
/// Attitude by the complementary filter as a quaternion, relative to the NED frame.
///
/// - v_vehicle = q^-1 \* v_ned \* q; v_sensor in place of v_vehicle on the 3DM-GX5-15.
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 5.1.7 CF Quaternion (0x80, 0x0A)
/// - Manual 3dm-cv7-gnss-ins: Complementary Filter Quaternion (0x80,0x0A)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ComplementaryFilterQuaternion {
    /// Rotation between the NED frame and the vehicle frame.
    ///
    /// Unit: 1.
    ///
    /// - On 3dm-gx5-15: Between NED and the sensor frame.
    pub q: types::Quatf,
}

impl Wire for ComplementaryFilterQuaternion {
    const SIZE: usize = 16;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let q = reader.read()?;
        Ok(Self { q })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.q)?;
        Ok(())
    }
}

impl Field for ComplementaryFilterQuaternion {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x0A;
    const NAME: &'static str = "sensor.complementary_filter_quaternion";
}

/// Complementary filter orientation update matrix (0x80,0x0B).
///
/// Change of the attitude by the complementary filter as a matrix.
///
/// - Manual mip-sdk-4: Comp Orientation Update Matrix (0x80,0x0B)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[deprecated(note = "the SDK marks it so and names no replacement")]
pub struct CompOrientationUpdateMatrix {
    /// Matrix in row-major order.
    ///
    /// Unit: 1.
    pub m: types::Matrix3f,
}

impl Wire for CompOrientationUpdateMatrix {
    const SIZE: usize = 36;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let m = reader.read()?;
        Ok(Self { m })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.m)?;
        Ok(())
    }
}

impl Field for CompOrientationUpdateMatrix {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x0B;
    const NAME: &'static str = "sensor.comp_orientation_update_matrix";
}

/// Complementary filter Euler angles (0x80,0x0C).
///
/// Attitude by the complementary filter as Euler angles, relative to the NED frame.
///
/// - The rotations are in the order yaw, pitch, roll (3-2-1).
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 5.1.8 CF Euler Angles (0x80, 0x0C)
/// - Manual 3dm-cv7-gnss-ins: Complementary Filter Euler Angles (0x80,0x0C)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ComplementaryFilterEulerAngles {
    /// Roll angle.
    ///
    /// Unit: rad.
    pub roll: f32,
    /// Pitch angle.
    ///
    /// Unit: rad.
    pub pitch: f32,
    /// Yaw angle.
    ///
    /// Unit: rad.
    pub yaw: f32,
}

impl Wire for ComplementaryFilterEulerAngles {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let roll = reader.read()?;
        let pitch = reader.read()?;
        let yaw = reader.read()?;
        Ok(Self { roll, pitch, yaw })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.roll)?;
        writer.write(&self.pitch)?;
        writer.write(&self.yaw)?;
        Ok(())
    }
}

impl Field for ComplementaryFilterEulerAngles {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x0C;
    const NAME: &'static str = "sensor.complementary_filter_euler_angles";
}

/// Orientation raw temperatures (0x80,0x0D).
///
/// Raw readings of four temperature sensors.
///
/// - Manual mip-sdk-4: Orientation Raw Temp (0x80,0x0D)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[deprecated(note = "the SDK marks it so and names no replacement")]
pub struct OrientationRawTemp {
    /// Temperatures in counts.
    ///
    /// Unit: 1.
    pub raw_temp: [u16; 4],
}

impl Wire for OrientationRawTemp {
    const SIZE: usize = 8;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let raw_temp = reader.read()?;
        Ok(Self { raw_temp })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.raw_temp)?;
        Ok(())
    }
}

impl Field for OrientationRawTemp {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x0D;
    const NAME: &'static str = "sensor.orientation_raw_temp";
}

/// Internal timestamp (0x80,0x0E).
///
/// Free-running counter of the device.
///
/// - Manual mip-sdk-4: Internal Timestamp (0x80,0x0E)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[deprecated(note = "the SDK marks it so and names no replacement")]
pub struct InternalTimestamp {
    /// Counter.
    ///
    /// Unit: 1.
    pub counts: u32,
}

impl Wire for InternalTimestamp {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let counts = reader.read()?;
        Ok(Self { counts })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.counts)?;
        Ok(())
    }
}

impl Field for InternalTimestamp {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x0E;
    const NAME: &'static str = "sensor.internal_timestamp";
}

/// PPS timestamp (0x80,0x0F).
///
/// Time that is counted with the pulse per second.
///
/// - Manual mip-sdk-4: Pps Timestamp (0x80,0x0F)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[deprecated(note = "the SDK marks it so and names no replacement")]
pub struct PpsTimestamp {
    /// Whole seconds.
    ///
    /// Unit: s.
    pub seconds: u32,
    /// Fraction of the second.
    ///
    /// Unit: us.
    pub useconds: u32,
}

impl Wire for PpsTimestamp {
    const SIZE: usize = 8;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let seconds = reader.read()?;
        let useconds = reader.read()?;
        Ok(Self { seconds, useconds })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.seconds)?;
        writer.write(&self.useconds)?;
        Ok(())
    }
}

impl Field for PpsTimestamp {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x0F;
    const NAME: &'static str = "sensor.pps_timestamp";
}

/// Complementary filter stabilized north vector (0x80,0x10).
///
/// Estimate of the geomagnetic field by the complementary filter, free of short disturbances.
///
/// - Without magnetic disturbance it equals the measured magnetic field.
/// - A lasting disturbance is not compensated.
///
/// Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 5.1.9 CF Stabilized North Vector (0x80, 0x10)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ComplementaryFilterStabilizedNorthVector {
    /// Geomagnetic field.
    ///
    /// Unit: gauss; frame: sensor.
    pub stabilized_mag: types::Vector3f,
}

impl Wire for ComplementaryFilterStabilizedNorthVector {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let stabilized_mag = reader.read()?;
        Ok(Self { stabilized_mag })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.stabilized_mag)?;
        Ok(())
    }
}

impl Field for ComplementaryFilterStabilizedNorthVector {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x10;
    const NAME: &'static str = "sensor.complementary_filter_stabilized_north_vector";
}

/// Complementary filter stabilized up vector (0x80,0x11).
///
/// Estimate of the vertical (up) by the complementary filter, free of linear acceleration.
///
/// - At rest it equals the measured acceleration.
///
/// Supported by 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 5.1.10 CF Stabilized Up Vector (0x80, 0x11)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ComplementaryFilterStabilizedUpVector {
    /// The part of the measured acceleration that gravity causes.
    ///
    /// Unit: g; frame: sensor.
    pub stabilized_accel: types::Vector3f,
}

impl Wire for ComplementaryFilterStabilizedUpVector {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let stabilized_accel = reader.read()?;
        Ok(Self { stabilized_accel })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.stabilized_accel)?;
        Ok(())
    }
}

impl Field for ComplementaryFilterStabilizedUpVector {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x11;
    const NAME: &'static str = "sensor.complementary_filter_stabilized_up_vector";
}

/// GPS timestamp (0x80,0x12).
///
/// GPS time of the sensor data.
///
/// - Without a PPS the time runs on the internal clock and jumps when the PPS comes back.
/// - The fraction of the time of week is the time since the last pulse.
/// - Without external synchronization it is the internal system time.
/// - Where the device has it, use the shared GPS timestamp (0xFF,0xD3) instead; this field may be
///   deprecated.
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 5.1.11 GPS Correlation Timestamp (0x80, 0x12)
/// - Manual 3dm-cv7-gnss-ins: GPS Timestamp (0x80,0x12)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GpsTimestamp {
    /// GPS time of week.
    ///
    /// Unit: s; valid if `valid_flags.tow_valid` is set.
    pub tow: f64,
    /// GPS week number.
    ///
    /// Unit: week; valid if `valid_flags.week_number_valid` is set.
    pub week_number: u16,
    /// State of the time.
    pub valid_flags: types::SensorGpsTimestampFlags,
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
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x12;
    const NAME: &'static str = "sensor.gps_timestamp";
}

/// Temperature statistics (0x80,0x14).
///
/// Temperatures since the last power-on or reset.
///
/// - The values come from the inertial sensors, alone or together with sensors on the board.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Temperature Statistics (0x80,0x14)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TemperatureStatistics {
    /// Lowest temperature.
    ///
    /// Unit: degC.
    pub min_temp: f32,
    /// Highest temperature.
    ///
    /// Unit: degC.
    pub max_temp: f32,
    /// Mean temperature.
    ///
    /// Unit: degC.
    pub mean_temp: f32,
}

impl Wire for TemperatureStatistics {
    const SIZE: usize = 12;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let min_temp = reader.read()?;
        let max_temp = reader.read()?;
        let mean_temp = reader.read()?;
        Ok(Self { min_temp, max_temp, mean_temp })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.min_temp)?;
        writer.write(&self.max_temp)?;
        writer.write(&self.mean_temp)?;
        Ok(())
    }
}

impl Field for TemperatureStatistics {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x14;
    const NAME: &'static str = "sensor.temperature_statistics";
}

/// Raw pressure (0x80,0x16).
///
/// Raw ambient pressure in counts of the sensor, temperature compensated.
///
/// - Manual mip-sdk-4: Raw Pressure (0x80,0x16)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RawPressure {
    /// Pressure in counts.
    ///
    /// Unit: 1.
    pub raw_pressure: f32,
}

impl Wire for RawPressure {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let raw_pressure = reader.read()?;
        Ok(Self { raw_pressure })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.raw_pressure)?;
        Ok(())
    }
}

impl Field for RawPressure {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x16;
    const NAME: &'static str = "sensor.raw_pressure";
}

/// Scaled pressure (0x80,0x17).
///
/// Measured ambient pressure, temperature compensated.
///
/// Supported by 3DM-CV7-GNSS/INS and 3DM-GX5-15.
///
/// - Manual 3dm-gx5-15: 5.1.3 Scaled Ambient Pressure (0x80, 0x17)
/// - Manual 3dm-cv7-gnss-ins: Scaled Pressure (0x80,0x17)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ScaledPressure {
    /// Ambient pressure.
    ///
    /// Unit: mbar.
    pub scaled_pressure: f32,
}

impl Wire for ScaledPressure {
    const SIZE: usize = 4;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let scaled_pressure = reader.read()?;
        Ok(Self { scaled_pressure })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.scaled_pressure)?;
        Ok(())
    }
}

impl Field for ScaledPressure {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x17;
    const NAME: &'static str = "sensor.scaled_pressure";
}

/// Overrange status (0x80,0x18).
///
/// Which sensor axes are near or outside their range.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Overrange Status (0x80,0x18)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OverrangeStatus {
    /// One bit for each axis.
    pub status: OverrangeFlags,
}

impl Wire for OverrangeStatus {
    const SIZE: usize = 2;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let status = reader.read()?;
        Ok(Self { status })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.status)?;
        Ok(())
    }
}

impl Field for OverrangeStatus {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x18;
    const NAME: &'static str = "sensor.overrange_status";
}

/// Odometer data (0x80,0x40).
///
/// Speed by the wheel encoder.
///
/// Supported by 3DM-CV7-GNSS/INS.
///
/// - Manual 3dm-cv7-gnss-ins: Odometer Data (0x80,0x40)
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Odometer {
    /// Average speed over the interval; negative values come from quadrature encoders only.
    ///
    /// Unit: m/s; valid if `valid_flags.odometer` is set.
    pub speed: f32,
    /// Uncertainty of the speed.
    ///
    /// Unit: m/s; valid if `valid_flags.odometer` is set.
    pub uncertainty: f32,
    /// Whether the values are valid.
    pub valid_flags: OdometerFlags,
}

impl Wire for Odometer {
    const SIZE: usize = 10;

    fn decode_from(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let speed = reader.read()?;
        let uncertainty = reader.read()?;
        let valid_flags = reader.read()?;
        Ok(Self { speed, uncertainty, valid_flags })
    }

    fn encode_to(&self, writer: &mut Writer<'_>) -> Result<(), EncodeError> {
        writer.write(&self.speed)?;
        writer.write(&self.uncertainty)?;
        writer.write(&self.valid_flags)?;
        Ok(())
    }
}

impl Field for Odometer {
    const SET: u8 = 0x80;
    const DESCRIPTOR: u8 = 0x40;
    const NAME: &'static str = "sensor.odometer";
}
