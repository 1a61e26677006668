"""What each device supports, and what values mean there that differ between devices."""

from __future__ import annotations

from . import filter_data, mip_3dm, types
from .lookup import device_id
from .profile import Device, DeviceInfo, Evidence, Limit, Note, Port, Support, model_number

CL5_10 = Device(
    id="3dm-cl5-10",
    title="3DM-CL5-10",
    description="Inertial measurement unit.",
    model_number=6279,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-15 and 3DM-CX5-10.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x12),  # sensor.gps_timestamp
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_without_state_response` and `3dm.device_status_diagnostic_imu_response`.",
            (),
        )
    },
    readings={
        "base.built_in_test_response.result": types.Gx5BuiltInTest,
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=("3DM-CL5-IMU",),
    generation=5,
    manual=None,
)
"""Inertial measurement unit. Also called 3DM-CL5-IMU. Generation 5. Model number 6279. No manual is
known. This profile is incomplete: No manual is known. Uncertain: MSCL does not know it.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CL5_15 = Device(
    id="3dm-cl5-15",
    title="3DM-CL5-15",
    description="Attitude reference.",
    model_number=6280,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-15.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x18),  # filter.heading_source
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x26),  # filter.reference_position
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0D, 0x41),  # filter.enable_measurements
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x4B),  # filter.pitch_roll_aiding
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x80, 0x11),  # sensor.up_vector
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x0F),  # filter_data.wgs84_gravity_magnitude
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x11),  # filter_data.timestamp
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x14),  # filter_data.heading_update_state
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x21),  # filter_data.pressure_altitude
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_response`.",
            (),
        )
    },
    readings={
        "base.built_in_test_response.result": types.Gx5BuiltInTest,
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=("3DM-CL5-AR",),
    generation=5,
    manual=None,
)
"""Attitude reference. Also called 3DM-CL5-AR. Generation 5. Model number 6280. No manual is known.
This profile is incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CL5_25 = Device(
    id="3dm-cl5-25",
    title="3DM-CL5-25",
    description="Attitude and heading reference system.",
    model_number=6281,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-15 and 3DM-GX5-45.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x18),  # filter.heading_source
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x26),  # filter.reference_position
                    (0x0D, 0x27),  # filter.mag_capture_auto_calibration
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0D, 0x29),  # filter.pressure_altitude_noise
                    (0x0D, 0x2B),  # filter.hard_iron_offset_noise
                    (0x0D, 0x2C),  # filter.soft_iron_matrix_noise
                    (0x0D, 0x41),  # filter.enable_measurements
                    (0x0D, 0x42),  # filter.mag_noise
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x45),  # filter.mag_magnitude_error_adaptive_measurement
                    (0x0D, 0x46),  # filter.mag_dip_angle_error_adaptive_measurement
                    (0x0D, 0x47),  # filter.altitude_aiding
                    (0x0D, 0x4B),  # filter.pitch_roll_aiding
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x80, 0x11),  # sensor.up_vector
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x0F),  # filter_data.wgs84_gravity_magnitude
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x11),  # filter_data.timestamp
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x14),  # filter_data.heading_update_state
                    (0x82, 0x15),  # filter_data.magnetic_model
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0x82, 0x25),  # filter_data.mag_offset
                    (0x82, 0x26),  # filter_data.mag_matrix
                    (0x82, 0x28),  # filter_data.mag_offset_uncertainty
                    (0x82, 0x29),  # filter_data.mag_matrix_uncertainty
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_response`.",
            (),
        )
    },
    readings={
        "base.built_in_test_response.result": types.Gx5BuiltInTest,
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=("3DM-CL5-AHRS",),
    generation=5,
    manual=None,
)
"""Attitude and heading reference system. Also called 3DM-CL5-AHRS. Generation 5. Model number 6281.
No manual is known. This profile is incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CV5_10 = Device(
    id="3dm-cv5-10",
    title="3DM-CV5-10",
    description="Inertial measurement unit.",
    model_number=6259,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-15 and 3DM-CX5-10.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x12),  # sensor.gps_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.NO,
            "refused",
            "The device refuses it (MicroStrain Communication Library: Issue 145).",
            frozenset(
                {
                    (0x80, 0x01)  # sensor.raw_accel
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_without_state_response` and `3dm.device_status_diagnostic_imu_response`.",
            (),
        )
    },
    readings={
        "base.built_in_test_response.result": types.Gx5BuiltInTest,
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
    },
    ack_codes=frozenset([]),
    incomplete=("Its manual (8500-0070) is not known.",),
    also=("3DM-CV5-IMU",),
    generation=5,
    manual=None,
)
"""Inertial measurement unit. Also called 3DM-CV5-IMU. Generation 5. Model number 6259. No manual is
known. This profile is incomplete: Its manual (8500-0070) is not known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CV5_15 = Device(
    id="3dm-cv5-15",
    title="3DM-CV5-15",
    description="Attitude reference.",
    model_number=6258,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x11),  # filter_data.timestamp
                    (0x82, 0x1C),  # filter_data.comp_accel
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x03),  # base.get_device_info
                    (0x0D, 0x01),  # filter.reset
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x07),  # base.get_extended_descriptors
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-15.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x18),  # filter.heading_source
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x26),  # filter.reference_position
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0D, 0x41),  # filter.enable_measurements
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x4B),  # filter.pitch_roll_aiding
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x80, 0x11),  # sensor.up_vector
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0F),  # filter_data.wgs84_gravity_magnitude
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x14),  # filter_data.heading_update_state
                    (0x82, 0x21),  # filter_data.pressure_altitude
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_response`.",
            (),
        )
    },
    readings={
        "base.built_in_test_response.result": types.Gx5BuiltInTest,
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=("3DM-CV5-AR",),
    generation=5,
    manual=None,
)
"""Attitude reference. Also called 3DM-CV5-AR. Generation 5. Model number 6258. No manual is known.
This profile is incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CV5_25 = Device(
    id="3dm-cv5-25",
    title="3DM-CV5-25",
    description="Attitude and heading reference system.",
    model_number=6257,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x11),  # filter_data.timestamp
                    (0x82, 0x1C),  # filter_data.comp_accel
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x03),  # base.get_device_info
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x18),  # filter.heading_source
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x07),  # base.get_extended_descriptors
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-15 and 3DM-GX5-45.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x26),  # filter.reference_position
                    (0x0D, 0x27),  # filter.mag_capture_auto_calibration
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0D, 0x29),  # filter.pressure_altitude_noise
                    (0x0D, 0x2B),  # filter.hard_iron_offset_noise
                    (0x0D, 0x2C),  # filter.soft_iron_matrix_noise
                    (0x0D, 0x41),  # filter.enable_measurements
                    (0x0D, 0x42),  # filter.mag_noise
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x45),  # filter.mag_magnitude_error_adaptive_measurement
                    (0x0D, 0x46),  # filter.mag_dip_angle_error_adaptive_measurement
                    (0x0D, 0x47),  # filter.altitude_aiding
                    (0x0D, 0x4B),  # filter.pitch_roll_aiding
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x80, 0x11),  # sensor.up_vector
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0F),  # filter_data.wgs84_gravity_magnitude
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x14),  # filter_data.heading_update_state
                    (0x82, 0x15),  # filter_data.magnetic_model
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0x82, 0x25),  # filter_data.mag_offset
                    (0x82, 0x26),  # filter_data.mag_matrix
                    (0x82, 0x28),  # filter_data.mag_offset_uncertainty
                    (0x82, 0x29),  # filter_data.mag_matrix_uncertainty
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_response`.",
            (),
        )
    },
    readings={
        "base.built_in_test_response.result": types.Gx5BuiltInTest,
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=("3DM-CV5-AHRS",),
    generation=5,
    manual=None,
)
"""Attitude and heading reference system. Also called 3DM-CV5-AHRS. Generation 5. Model number 6257.
No manual is known. This profile is incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CV5_45 = Device(
    id="3dm-cv5-45",
    title="3DM-CV5-45",
    description="Inertial navigation system with GNSS.",
    model_number=6256,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-45.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x02),  # 3dm.poll_gnss_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x07),  # 3dm.get_gnss_base_rate
                    (0x0C, 0x09),  # 3dm.gnss_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x21),  # 3dm.constellation_settings
                    (0x0C, 0x22),  # 3dm.gnss_sbas_settings
                    (0x0C, 0x23),  # 3dm.gnss_assisted_fix
                    (0x0C, 0x24),  # 3dm.gnss_time_assistance
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x10),  # filter.vehicle_dynamics_mode
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x12),  # filter.sensor_to_vehicle_offset
                    (0x0D, 0x13),  # filter.antenna_offset
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x15),  # filter.gnss_source
                    (0x0D, 0x16),  # filter.external_gnss_update
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x18),  # filter.heading_source
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1C),  # filter.accel_bias_model
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1E),  # filter.auto_zupt
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x22),  # filter.commanded_zupt
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x27),  # filter.mag_capture_auto_calibration
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0D, 0x29),  # filter.pressure_altitude_noise
                    (0x0D, 0x2B),  # filter.hard_iron_offset_noise
                    (0x0D, 0x2C),  # filter.soft_iron_matrix_noise
                    (0x0D, 0x42),  # filter.mag_noise
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x45),  # filter.mag_magnitude_error_adaptive_measurement
                    (0x0D, 0x46),  # filter.mag_dip_angle_error_adaptive_measurement
                    (0x0D, 0x47),  # filter.altitude_aiding
                    (0x0D, 0x4B),  # filter.pitch_roll_aiding
                    (0x0D, 0x53),  # filter.adaptive_filter_options
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x80, 0x11),  # sensor.up_vector
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x81, 0x03),  # gnss_data.llh_position
                    (0x81, 0x04),  # gnss_data.ecef_position
                    (0x81, 0x05),  # gnss_data.ned_velocity
                    (0x81, 0x06),  # gnss_data.ecef_velocity
                    (0x81, 0x07),  # gnss_data.dop
                    (0x81, 0x08),  # gnss_data.utc_time
                    (0x81, 0x09),  # gnss_data.gps_time
                    (0x81, 0x0A),  # gnss_data.clock_info
                    (0x81, 0x0B),  # gnss_data.fix_info
                    (0x81, 0x0C),  # gnss_data.sv_info
                    (0x81, 0x0D),  # gnss_data.hardware_status
                    (0x81, 0x0E),  # gnss_data.dgps_info
                    (0x81, 0x0F),  # gnss_data.dgps_channel
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x14),  # filter_data.heading_update_state
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-25 and 3DM-RQ1-45-LT.",
            frozenset(
                {
                    (0x82, 0x01),  # filter_data.llh_position
                    (0x82, 0x02),  # filter_data.ned_velocity
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x07),  # filter_data.accel_bias
                    (0x82, 0x08),  # filter_data.llh_position_uncertainty
                    (0x82, 0x09),  # filter_data.ned_velocity_uncertainty
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0C),  # filter_data.accel_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0F),  # filter_data.wgs84_gravity_magnitude
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x11),  # filter_data.timestamp
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x15),  # filter_data.magnetic_model
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x20),  # filter_data.standard_atmosphere
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0x82, 0x25),  # filter_data.mag_offset
                    (0x82, 0x26),  # filter_data.mag_matrix
                    (0x82, 0x28),  # filter_data.mag_offset_uncertainty
                    (0x82, 0x29),  # filter_data.mag_matrix_uncertainty
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_gnss_response`.",
            (),
        )
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=(),
    generation=5,
    manual=None,
)
"""Inertial navigation system with GNSS. Generation 5. Model number 6256. No manual is known. This
profile is incomplete: No manual is known. Uncertain: Only MSCL knows it; the SDK does not.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CV7_AHRS = Device(
    id="3dm-cv7-ahrs",
    title="3DM-CV7-AHRS",
    description="Attitude and heading reference system.",
    model_number=6286,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Protocol Support and Specifications).",
            frozenset(
                {
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x01, 0x09),  # base.comm_speed
                    (0x0C, 0x0E),  # 3dm.get_base_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x54),  # 3dm.low_pass_filter
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x1C),  # filter_data.comp_accel
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it.",
            frozenset(
                {
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x13, 0x01),  # aiding.frame_config
                    (0x13, 0x1F),  # aiding.echo_control
                    (0x13, 0x31),  # aiding.true_heading
                    (0x13, 0x32),  # aiding.magnetic_field
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x82, 0x06),  # filter_data.gyro_bias
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by the ROS messages).",
            frozenset(
                {
                    (0x0C, 0x2E),  # 3dm.event_trigger_config
                    (0x0C, 0x2F),  # 3dm.event_action_config
                    (0x0C, 0x41),  # 3dm.gpio_config
                    (0x80, 0x18),  # sensor.overrange_status
                    (0xA0, 0x02),  # system_data.time_sync_status
                    (0xFF, 0xD0),  # shared.event_source
                    (0xFF, 0xD3),  # shared.gps_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by a public program).",
            frozenset(
                {
                    (0x0D, 0x50),  # filter.aiding_measurement_enable
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x13),  # filter_data.gravity_vector
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages).",
            frozenset(
                {
                    (0x82, 0x50)  # filter_data.aiding_frame_config_error
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x0F),  # 3dm.message_format
                    (0x0C, 0x2B),  # 3dm.event_control
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x31),  # 3dm.sensor_to_vehicle_transform_euler
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x03)  # base.get_device_info
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (Public programs of users: Program for a 3DM-CV7).",
            frozenset(
                {
                    (0x01, 0x05)  # base.built_in_test
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (ROS driver of the vendor: Example configurations).",
            frozenset(
                {
                    (0x0C, 0x28),  # 3dm.pps_source_control
                    (0x0D, 0x53),  # filter.adaptive_filter_options
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (PX4: Driver of the vendor's sensors).",
            frozenset(
                {
                    (0x0C, 0x52),  # 3dm.sensor_range
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: Fields of event thresholds).",
            frozenset(
                {
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0xA0, 0x03),  # system_data.gpio_state
                    (0xFF, 0xD5),  # shared.reference_timestamp
                    (0xFF, 0xD7),  # shared.external_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it, 3DM-CV7-GNSS/INS.",
            frozenset(
                {
                    (0x01, 0x08),  # base.continuous_built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x0D),  # 3dm.poll_data
                    (0x0C, 0x10),  # 3dm.factory_streaming
                    (0x0C, 0x2A),  # 3dm.get_event_support
                    (0x0C, 0x2C),  # 3dm.get_event_trigger_status
                    (0x0C, 0x2D),  # 3dm.get_event_action_status
                    (0x0C, 0x32),  # 3dm.sensor_to_vehicle_transform_quaternion
                    (0x0C, 0x33),  # 3dm.sensor_to_vehicle_transform_dcm
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x42),  # 3dm.gpio_state
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x53),  # 3dm.get_calibrated_sensor_ranges
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x14),  # sensor.temperature_statistics
                    (0xA0, 0x01),  # system_data.built_in_test
                    (0xFF, 0xD4),  # shared.delta_time
                    (0xFF, 0xD6),  # shared.reference_time_delta
                    (0xFF, 0xD8),  # shared.external_time_delta
                }
            ),
            (),
        ),
        Evidence(
            Support.NO,
            "refused",
            "The device refuses it (firmware 1.0.07; ROS driver of the vendor: Issue 257).",
            frozenset(
                {
                    (0x81, 0x03),  # gnss_data.llh_position
                    (0x81, 0x0B),  # gnss_data.fix_info
                    (0x82, 0x34),  # filter_data.multi_antenna_offset_correction
                    (0x82, 0x43),  # filter_data.gnss_position_aiding_status
                    (0x91, 0x03),  # gnss_1.llh_position
                    (0x91, 0x0B),  # gnss_1.fix_info
                }
            ),
            (),
        ),
        Evidence(
            Support.NO,
            "refused",
            "The device refuses it (ROS driver of the vendor: Issue 350).",
            frozenset(
                {
                    (0x82, 0x49),  # filter_data.gnss_dual_antenna_status
                    (0x91, 0x12),  # gnss_1.sbas_info
                    (0x91, 0x14),  # gnss_1.rf_error_detection
                    (0x92, 0x0B),  # gnss_2.fix_info
                    (0x92, 0x12),  # gnss_2.sbas_info
                    (0x92, 0x14),  # gnss_2.rf_error_detection
                }
            ),
            (),
        ),
    ),
    functions={(0x0C, 0x38): "WRSLD", (0x0C, 0x3A): "WRSLD", (0x0C, 0x3B): "WRSLD"},
    base_rates={0x80: 1000, 0x82: 1000, 0xA0: 1000},
    ports=(
        Port("Main", 1, (115200, 230400, 460800, 921600), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (115200, 230400, 460800, 921600), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(
            4, None, "Frames that the aiding frame configuration can define, according to MSCL."
        ),
        "event_triggers": Limit(12, None, "Total number of triggers."),
        "event_gpio_triggers": Limit(4, None, "GPIO triggers."),
        "event_threshold_triggers": Limit(8, None, "Threshold triggers."),
        "event_combination_triggers": Limit(8, None, "Combination triggers."),
        "event_tick_rate": Limit(1000, "Hz", "Rate of the event cycle."),
    },
    notes={
        "anti_aliasing": Note(
            "Anti-aliasing low-pass filter",
            "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.",
            (
                ("Set", "Descriptor", "Data"),
                ("0x80", "0x04", "Scaled accel"),
                ("0x80", "0x05", "Scaled gyro"),
                ("0x80", "0x06", "Scaled mag"),
                ("0x80", "0x17", "Scaled pressure"),
                ("0x82", "0x1C", "Compensated acceleration"),
                ("0x82", "0x0E", "Compensated angular rate"),
                ("0x82", "0x0D", "Linear acceleration"),
            ),
        ),
        "gpio_pins": Note(
            "GPIO pins",
            "Features of each pin, according to MSCL, and its place on the connector, according to the ROS driver.",
            (
                ("Pin", "Connector pin", "Features"),
                ("1", "7", "GPIO, PPS, timestamp"),
                ("2", "9", "GPIO, PPS, timestamp"),
                ("3", "6", "GPIO, PPS, timestamp"),
                ("4", "10", "GPIO, PPS, timestamp"),
            ),
        ),
        "ports": Note(
            "Ports",
            "The main port is an alias of USB 1 if that is connected, or else of UART 1.",
            (),
        ),
    },
    readings={
        "base.comm_speed.port": types.CommInterface,
        "base.built_in_test_response.result": types.Cv7BuiltInTest,
        "base.continuous_built_in_test_response.result": types.Cv7InertialContinuousBuiltInTest,
        "base.comm_speed_response.port": types.CommInterface,
        "filter_data.status.filter_state": filter_data.Cv7FilterState,
        "filter_data.status.dynamics_mode": filter_data.Cv7DynamicsMode,
        "filter_data.status.status_flags": filter_data.Cv7StatusFlags,
        "system_data.built_in_test.result": types.Cv7InertialContinuousBuiltInTest,
    },
    ack_codes=frozenset([]),
    incomplete=("Only some pages of the manual are known, so it has more commands and data.",),
    also=(),
    generation=7,
    manual="3dm-cv7",
)
"""Attitude and heading reference system. Generation 7. Model number 6286. Manual: MicroStrain
3DM-CV7 Documentation (AHRS and AR), online, known from some pages. This profile is incomplete: Only
some pages of the manual are known, so it has more commands and data. Uncertain: MSCL offers only
the values `none` and `manual` of `filter.MagneticDeclinationSource`; the manual also has `wmm`.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CV7_AR = Device(
    id="3dm-cv7-ar",
    title="3DM-CV7-AR",
    description="Attitude reference.",
    model_number=6287,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Protocol Support and Specifications).",
            frozenset(
                {
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x01, 0x09),  # base.comm_speed
                    (0x0C, 0x0E),  # 3dm.get_base_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x54),  # 3dm.low_pass_filter
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x1C),  # filter_data.comp_accel
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it.",
            frozenset(
                {
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x13, 0x01),  # aiding.frame_config
                    (0x13, 0x1F),  # aiding.echo_control
                    (0x13, 0x31),  # aiding.true_heading
                    (0x13, 0x32),  # aiding.magnetic_field
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x82, 0x06),  # filter_data.gyro_bias
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by the ROS messages).",
            frozenset(
                {
                    (0x0C, 0x2E),  # 3dm.event_trigger_config
                    (0x0C, 0x2F),  # 3dm.event_action_config
                    (0x0C, 0x41),  # 3dm.gpio_config
                    (0x80, 0x18),  # sensor.overrange_status
                    (0xA0, 0x02),  # system_data.time_sync_status
                    (0xFF, 0xD0),  # shared.event_source
                    (0xFF, 0xD3),  # shared.gps_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by a public program).",
            frozenset(
                {
                    (0x0D, 0x50),  # filter.aiding_measurement_enable
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x13),  # filter_data.gravity_vector
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages).",
            frozenset(
                {
                    (0x82, 0x50)  # filter_data.aiding_frame_config_error
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "listed",
            "The device lists it (MicroStrain Communication Library: Issue 258).",
            frozenset(
                {
                    (0x01, 0x08),  # base.continuous_built_in_test
                    (0xA0, 0x01),  # system_data.built_in_test
                    (0xA0, 0x03),  # system_data.gpio_state
                    (0xFF, 0xD4),  # shared.delta_time
                    (0xFF, 0xD5),  # shared.reference_timestamp
                    (0xFF, 0xD6),  # shared.reference_time_delta
                    (0xFF, 0xD7),  # shared.external_timestamp
                    (0xFF, 0xD8),  # shared.external_time_delta
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x0F),  # 3dm.message_format
                    (0x0C, 0x2B),  # 3dm.event_control
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x31),  # 3dm.sensor_to_vehicle_transform_euler
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (ROS driver of the vendor: Example configurations).",
            frozenset(
                {
                    (0x0C, 0x28),  # 3dm.pps_source_control
                    (0x0D, 0x53),  # filter.adaptive_filter_options
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (PX4: Driver of the vendor's sensors).",
            frozenset(
                {
                    (0x0C, 0x52),  # 3dm.sensor_range
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: Fields of event thresholds).",
            frozenset(
                {
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x21),  # filter_data.pressure_altitude
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it, 3DM-CV7-GNSS/INS.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x0D),  # 3dm.poll_data
                    (0x0C, 0x10),  # 3dm.factory_streaming
                    (0x0C, 0x2A),  # 3dm.get_event_support
                    (0x0C, 0x2C),  # 3dm.get_event_trigger_status
                    (0x0C, 0x2D),  # 3dm.get_event_action_status
                    (0x0C, 0x32),  # 3dm.sensor_to_vehicle_transform_quaternion
                    (0x0C, 0x33),  # 3dm.sensor_to_vehicle_transform_dcm
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x42),  # 3dm.gpio_state
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x53),  # 3dm.get_calibrated_sensor_ranges
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x14),  # sensor.temperature_statistics
                }
            ),
            (),
        ),
        Evidence(
            Support.NO,
            "refused",
            "The device refuses it (MicroStrain Communication Library: Issue 258).",
            frozenset(
                {
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x4B),  # filter.pitch_roll_aiding
                }
            ),
            (),
        ),
    ),
    functions={(0x0C, 0x38): "WRSLD", (0x0C, 0x3A): "WRSLD", (0x0C, 0x3B): "WRSLD"},
    base_rates={0x80: 1000, 0x82: 1000, 0xA0: 1000},
    ports=(
        Port("Main", 1, (115200, 230400, 460800, 921600), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (115200, 230400, 460800, 921600), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(
            4, None, "Frames that the aiding frame configuration can define, according to MSCL."
        ),
        "event_triggers": Limit(12, None, "Total number of triggers."),
        "event_gpio_triggers": Limit(4, None, "GPIO triggers."),
        "event_threshold_triggers": Limit(8, None, "Threshold triggers."),
        "event_combination_triggers": Limit(8, None, "Combination triggers."),
        "event_tick_rate": Limit(1000, "Hz", "Rate of the event cycle."),
    },
    notes={
        "anti_aliasing": Note(
            "Anti-aliasing low-pass filter",
            "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.",
            (
                ("Set", "Descriptor", "Data"),
                ("0x80", "0x04", "Scaled accel"),
                ("0x80", "0x05", "Scaled gyro"),
                ("0x80", "0x06", "Scaled mag"),
                ("0x80", "0x17", "Scaled pressure"),
                ("0x82", "0x1C", "Compensated acceleration"),
                ("0x82", "0x0E", "Compensated angular rate"),
                ("0x82", "0x0D", "Linear acceleration"),
            ),
        ),
        "gpio_pins": Note(
            "GPIO pins",
            "Features of each pin, according to MSCL, and its place on the connector, according to the ROS driver.",
            (
                ("Pin", "Connector pin", "Features"),
                ("1", "7", "GPIO, PPS, timestamp"),
                ("2", "9", "GPIO, PPS, timestamp"),
                ("3", "6", "GPIO, PPS, timestamp"),
                ("4", "10", "GPIO, PPS, timestamp"),
            ),
        ),
        "ports": Note(
            "Ports",
            "The main port is an alias of USB 1 if that is connected, or else of UART 1.",
            (),
        ),
    },
    readings={
        "base.comm_speed.port": types.CommInterface,
        "base.built_in_test_response.result": types.Cv7BuiltInTest,
        "base.continuous_built_in_test_response.result": types.Cv7InertialContinuousBuiltInTest,
        "base.comm_speed_response.port": types.CommInterface,
        "filter_data.status.filter_state": filter_data.Cv7FilterState,
        "filter_data.status.dynamics_mode": filter_data.Cv7DynamicsMode,
        "filter_data.status.status_flags": filter_data.Cv7StatusFlags,
        "system_data.built_in_test.result": types.Cv7InertialContinuousBuiltInTest,
    },
    ack_codes=frozenset([]),
    incomplete=("Only some pages of the manual are known, so it has more commands and data.",),
    also=(),
    generation=7,
    manual="3dm-cv7",
)
"""Attitude reference. Generation 7. Model number 6287. Manual: MicroStrain 3DM-CV7 Documentation
(AHRS and AR), online, known from some pages. This profile is incomplete: Only some pages of the
manual are known, so it has more commands and data. Uncertain: MSCL offers only the values `none`
and `manual` of `filter.MagneticDeclinationSource`; the manual also has `wmm`.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CV7_GNSS_INS = Device(
    id="3dm-cv7-gnss-ins",
    title="3DM-CV7-GNSS/INS",
    description="Inertial navigation system with two RTK-capable GNSS receivers, magnetometer and pressure sensor.",
    model_number=6292,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it.",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x01, 0x08),  # base.continuous_built_in_test
                    (0x01, 0x09),  # base.comm_speed
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x04),  # 3dm.poll_nmea_data
                    (0x0C, 0x0C),  # 3dm.nmea_message_format
                    (0x0C, 0x0D),  # 3dm.poll_data
                    (0x0C, 0x0E),  # 3dm.get_base_rate
                    (0x0C, 0x0F),  # 3dm.message_format
                    (0x0C, 0x10),  # 3dm.factory_streaming
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x22),  # 3dm.gnss_sbas_settings
                    (0x0C, 0x28),  # 3dm.pps_source_control
                    (0x0C, 0x2A),  # 3dm.get_event_support
                    (0x0C, 0x2B),  # 3dm.event_control
                    (0x0C, 0x2C),  # 3dm.get_event_trigger_status
                    (0x0C, 0x2D),  # 3dm.get_event_action_status
                    (0x0C, 0x2E),  # 3dm.event_trigger_config
                    (0x0C, 0x2F),  # 3dm.event_action_config
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x31),  # 3dm.sensor_to_vehicle_transform_euler
                    (0x0C, 0x32),  # 3dm.sensor_to_vehicle_transform_quaternion
                    (0x0C, 0x33),  # 3dm.sensor_to_vehicle_transform_dcm
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x41),  # 3dm.gpio_config
                    (0x0C, 0x42),  # 3dm.gpio_state
                    (0x0C, 0x43),  # 3dm.odometer_config
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x52),  # 3dm.sensor_range
                    (0x0C, 0x53),  # 3dm.get_calibrated_sensor_ranges
                    (0x0C, 0x54),  # 3dm.low_pass_filter
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x05),  # filter.run
                    (0x0D, 0x13),  # filter.antenna_offset
                    (0x0D, 0x15),  # filter.gnss_source
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1C),  # filter.accel_bias_model
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x50),  # filter.aiding_measurement_enable
                    (0x0D, 0x52),  # filter.initialization_config
                    (0x0D, 0x53),  # filter.adaptive_filter_options
                    (0x0D, 0x54),  # filter.multi_antenna_offset
                    (0x0D, 0x55),  # filter.relative_position_config
                    (0x0D, 0x56),  # filter.reference_point_lever_arm
                    (0x0D, 0x61),  # filter.speed_lever_arm
                    (0x0D, 0x63),  # filter.wheeled_vehicle_constraint_control
                    (0x0D, 0x64),  # filter.gnss_antenna_calibration_control
                    (0x0E, 0x01),  # gnss.receiver_info
                    (0x0E, 0x02),  # gnss.signal_config
                    (0x0E, 0x20),  # gnss.spartn_config
                    (0x13, 0x01),  # aiding.frame_config
                    (0x13, 0x1F),  # aiding.echo_control
                    (0x13, 0x21),  # aiding.ecef_position
                    (0x13, 0x22),  # aiding.llh_position
                    (0x13, 0x23),  # aiding.height_above_ellipsoid
                    (0x13, 0x28),  # aiding.ecef_velocity
                    (0x13, 0x29),  # aiding.ned_velocity
                    (0x13, 0x2A),  # aiding.body_frame_velocity
                    (0x13, 0x31),  # aiding.true_heading
                    (0x13, 0x32),  # aiding.magnetic_field
                    (0x13, 0x33),  # aiding.pressure
                    (0x7F, 0x02),  # system.interface_control
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x80, 0x14),  # sensor.temperature_statistics
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x80, 0x18),  # sensor.overrange_status
                    (0x80, 0x40),  # sensor.odometer
                    (0x82, 0x01),  # filter_data.llh_position
                    (0x82, 0x02),  # filter_data.ned_velocity
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x07),  # filter_data.accel_bias
                    (0x82, 0x08),  # filter_data.llh_position_uncertainty
                    (0x82, 0x09),  # filter_data.ned_velocity_uncertainty
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0C),  # filter_data.accel_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x11),  # filter_data.timestamp
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x15),  # filter_data.magnetic_model
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0x82, 0x34),  # filter_data.multi_antenna_offset_correction
                    (0x82, 0x35),  # filter_data.multi_antenna_offset_correction_uncertainty
                    (0x82, 0x36),  # filter_data.ecef_position_uncertainty
                    (0x82, 0x37),  # filter_data.ecef_velocity_uncertainty
                    (0x82, 0x40),  # filter_data.ecef_position
                    (0x82, 0x41),  # filter_data.ecef_velocity
                    (0x82, 0x42),  # filter_data.ned_relative_position
                    (0x82, 0x43),  # filter_data.gnss_position_aiding_status
                    (0x82, 0x46),  # filter_data.aiding_measurement_summary
                    (0x82, 0x47),  # filter_data.odometer_scale_factor_error
                    (0x82, 0x48),  # filter_data.odometer_scale_factor_error_uncertainty
                    (0x82, 0x49),  # filter_data.gnss_dual_antenna_status
                    (0x82, 0x50),  # filter_data.aiding_frame_config_error
                    (0x82, 0x51),  # filter_data.aiding_frame_config_error_uncertainty
                    (0x91, 0x03),  # gnss_1.llh_position
                    (0x91, 0x04),  # gnss_1.ecef_position
                    (0x91, 0x05),  # gnss_1.ned_velocity
                    (0x91, 0x06),  # gnss_1.ecef_velocity
                    (0x91, 0x07),  # gnss_1.dop
                    (0x91, 0x08),  # gnss_1.utc_time
                    (0x91, 0x09),  # gnss_1.gps_time
                    (0x91, 0x0B),  # gnss_1.fix_info
                    (0x91, 0x0D),  # gnss_1.hardware_status
                    (0x91, 0x10),  # gnss_1.clock_info_2
                    (0x91, 0x11),  # gnss_1.gps_leap_seconds
                    (0x91, 0x12),  # gnss_1.sbas_info
                    (0x91, 0x20),  # gnss_1.satellite_status
                    (0x91, 0x22),  # gnss_1.raw
                    (0x91, 0x61),  # gnss_1.gps_ephemeris
                    (0x91, 0x62),  # gnss_1.glonass_ephemeris
                    (0x91, 0x63),  # gnss_1.galileo_ephemeris
                    (0x91, 0x64),  # gnss_1.beidou_ephemeris
                    (0x92, 0x03),  # gnss_2.llh_position
                    (0x92, 0x04),  # gnss_2.ecef_position
                    (0x92, 0x05),  # gnss_2.ned_velocity
                    (0x92, 0x06),  # gnss_2.ecef_velocity
                    (0x92, 0x07),  # gnss_2.dop
                    (0x92, 0x08),  # gnss_2.utc_time
                    (0x92, 0x09),  # gnss_2.gps_time
                    (0x92, 0x0B),  # gnss_2.fix_info
                    (0x92, 0x0D),  # gnss_2.hardware_status
                    (0x92, 0x10),  # gnss_2.clock_info_2
                    (0x92, 0x11),  # gnss_2.gps_leap_seconds
                    (0x92, 0x12),  # gnss_2.sbas_info
                    (0x92, 0x20),  # gnss_2.satellite_status
                    (0x92, 0x22),  # gnss_2.raw
                    (0x92, 0x61),  # gnss_2.gps_ephemeris
                    (0x92, 0x62),  # gnss_2.glonass_ephemeris
                    (0x92, 0x63),  # gnss_2.galileo_ephemeris
                    (0x92, 0x64),  # gnss_2.beidou_ephemeris
                    (0x93, 0x30),  # gnss_corrections.base_station_info
                    (0x93, 0x31),  # gnss_corrections.rtk_corrections_status
                    (0x94, 0x03),  # gnss_external.llh_position
                    (0x94, 0x05),  # gnss_external.ned_velocity
                    (0x94, 0x08),  # gnss_external.utc_time
                    (0x94, 0x0B),  # gnss_external.fix_info
                    (0x94, 0x20),  # gnss_external.satellite_status
                    (0xA0, 0x01),  # system_data.built_in_test
                    (0xA0, 0x02),  # system_data.time_sync_status
                    (0xA0, 0x03),  # system_data.gpio_state
                    (0xFF, 0xD0),  # shared.event_source
                    (0xFF, 0xD3),  # shared.gps_timestamp
                    (0xFF, 0xD4),  # shared.delta_time
                    (0xFF, 0xD5),  # shared.reference_timestamp
                    (0xFF, 0xD6),  # shared.reference_time_delta
                    (0xFF, 0xD7),  # shared.external_timestamp
                    (0xFF, 0xD8),  # shared.external_time_delta
                }
            ),
            (),
        ),
    ),
    functions={
        (0x01, 0x72): "W",
        (0x0C, 0x37): "WRSLD",
        (0x0C, 0x38): "WRSLD",
        (0x0C, 0x3A): "WRSLD",
        (0x0C, 0x3B): "WRSLD",
    },
    base_rates={0x80: 1000, 0x82: 1000, 0x91: 5, 0x92: 5, 0x93: 0, 0x94: 0, 0xA0: 1000},
    ports=(
        Port("Main", 1, (), ("MIP", "NMEA", "RTCM", "SPARTN"), ("MIP", "NMEA")),
        Port(
            "UART 1",
            17,
            (115200, 230400, 460800, 921600, 3000000),
            ("MIP", "NMEA", "RTCM", "SPARTN"),
            ("MIP", "NMEA"),
        ),
        Port(
            "UART 2",
            18,
            (4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600),
            ("MIP", "NMEA", "RTCM", "SPARTN"),
            ("MIP", "NMEA"),
        ),
        Port(
            "UART 3",
            19,
            (4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600),
            ("MIP", "NMEA", "RTCM", "SPARTN"),
            ("MIP", "NMEA"),
        ),
        Port("USB 1", 33, (), ("MIP", "NMEA", "RTCM", "SPARTN"), ("MIP", "NMEA")),
        Port("USB 2", 34, (), ("MIP", "NMEA", "RTCM", "SPARTN"), ("MIP", "NMEA")),
    ),
    limits={
        "event_triggers": Limit(12, None, "Total number of triggers."),
        "event_gpio_triggers": Limit(4, None, "GPIO triggers."),
        "event_threshold_triggers": Limit(8, None, "Threshold triggers."),
        "event_combination_triggers": Limit(8, None, "Combination triggers."),
        "event_actions": Limit(12, None, "Total number of actions."),
        "event_gpio_actions": Limit(6, None, "GPIO actions."),
        "event_message_actions": Limit(8, None, "Message actions."),
        "event_message_fields": Limit(12, None, "Fields in the packet of one message action."),
        "event_tick_rate": Limit(
            1000, "Hz", "Rate of the event cycle; always the base rate of the system data set."
        ),
        "gpio_pins": Limit(4, None, "User GPIO pins."),
        "aiding_frames": Limit(4, None, "Frames that the aiding frame configuration can define."),
        "nmea_rate": Limit(
            10, "Hz", "Highest rate of an NMEA sentence from the sensor or filter data set."
        ),
        "nmea_gnss_rate": Limit(2, "Hz", "Highest rate of an NMEA sentence from a GNSS set."),
        "mip_input_ports": Limit(2, None, "Ports besides the main port that may accept MIP."),
        "nmea_input_ports": Limit(1, None, "Ports that may accept NMEA."),
        "rtcm_input_ports": Limit(1, None, "Ports that may accept RTCM."),
        "spartn_input_ports": Limit(1, None, "Ports that may accept SPARTN."),
        "baud_rate_delay": Limit(250, "ms", "Time to wait after a change of the baud rate."),
        "time_update_window": Limit(
            250,
            "ms",
            "Time after the rising edge of the PPS within which the GPS time update must arrive.",
        ),
        "save_time": Limit(1, "s", "Time that saving all settings may take."),
        "motion_latency": Limit(
            1.9,
            "ms",
            "Typical time from a motion to the message that reports it, not including transmission.",
        ),
        "timestamp_repeatability": Limit(
            1,
            "us",
            "Upper bound of the typical variation of sensor timestamps due to internal processing.",
        ),
        "gpio_timestamp_accuracy": Limit(
            1, "us", "Upper bound of the error of GPIO timestamps; the error is far smaller."
        ),
        "antenna_offset_error": Limit(
            0.5, "m", "Highest value of the maximum offset of the antenna lever arm calibration."
        ),
    },
    notes={
        "ports": Note(
            "Ports",
            "The main port is USB 1 while a host has it open (DTR set), else UART 1. MIP is always enabled on it. The others must be enabled first. All ports stream the same data; replies to polls go to the port that sent the poll.",
            (
                ("Port", "Id", "Pins"),
                ("Main", "0x01", "alias of USB 1 or UART 1"),
                ("UART 1", "0x11", "connector pins 4 (RxD) and 5 (TxD)"),
                ("UART 2", "0x12", "GPIO 1 and GPIO 2"),
                ("UART 3", "0x13", "GPIO 3 and GPIO 4"),
                ("USB 1", "0x21", "connector pins 1 and 2"),
                ("USB 2", "0x22", "connector pins 1 and 2"),
            ),
        ),
        "anti_aliasing": Note(
            "Anti-aliasing low-pass filter",
            "Data that `3dm.low_pass_filter` can filter.",
            (
                ("Set", "Descriptor", "Data"),
                ("0x80", "0x04", "Scaled accel"),
                ("0x80", "0x05", "Scaled gyro"),
                ("0x80", "0x06", "Scaled mag"),
                ("0x80", "0x17", "Scaled pressure"),
                ("0x82", "0x1C", "Compensated acceleration"),
                ("0x82", "0x0E", "Compensated angular rate"),
                ("0x82", "0x0D", "Linear acceleration"),
            ),
        ),
        "gpio_pins": Note(
            "GPIO pins",
            "Features of each pin; all are unused by default. The encoder feature is not available. The manual marks PPS on pins 2 to 4 with an asterisk that it does not explain.",
            (
                ("Pin", "Connector pin", "Features", "UART"),
                ("1", "7", "GPIO, PPS, timestamp, UART", "UART 2"),
                ("2", "9", "GPIO, PPS (restricted), timestamp, UART", "UART 2"),
                ("3", "6", "GPIO, PPS (restricted), timestamp, UART", "UART 3"),
                ("4", "10", "GPIO, PPS (restricted), timestamp, UART", "UART 3"),
            ),
        ),
        "gpio_behaviors": Note(
            "GPIO behaviors and pin modes",
            "Values of the behavior for each feature, and the pin modes that go with it. Two pins cannot have the same direction of the same UART. PPS output from an internal receiver is always push-pull.",
            (
                ("Feature", "Behavior", "Pins", "Pin modes"),
                ("unused (0)", "unused (0)", "1 to 4", "none"),
                ("gpio (1)", "input (1)", "1 to 4", "pull-up or pull-down"),
                ("gpio (1)", "output low (2)", "1 to 4", "open drain, optionally with pull-up"),
                ("gpio (1)", "output high (3)", "1 to 4", "open drain, optionally with pull-up"),
                ("pps (2)", "input (1)", "1; restricted on 2 to 4", "none"),
                ("pps (2)", "output (2)", "1; restricted on 2 to 4", "none"),
                ("timestamp (4)", "rising (1)", "1 to 4", "pull-up or pull-down"),
                ("timestamp (4)", "falling (2)", "1 to 4", "pull-up or pull-down"),
                ("timestamp (4)", "either (3)", "1 to 4", "pull-up or pull-down"),
                (
                    "uart (5)",
                    "UART 2 transmit (33)",
                    "1 and 2",
                    "open drain, optionally with pull-up",
                ),
                ("uart (5)", "UART 2 receive (34)", "1 and 2", "pull-up or pull-down"),
                (
                    "uart (5)",
                    "UART 3 transmit (49)",
                    "3 and 4",
                    "open drain, optionally with pull-up",
                ),
                ("uart (5)", "UART 3 receive (50)", "3 and 4", "pull-up or pull-down"),
            ),
        ),
        "nmea_output": Note(
            "NMEA output",
            "Sentences of `3dm.nmea_message_format`. The talkers are GN (GNSS), GP (GPS), GA (Galileo) and GL (GLONASS). A sentence is sent only while its data is valid. A GNSS source has a base rate of 5 Hz, so its decimation must be 3 or more.",
            (
                ("Sentence", "Contents", "Talkers", "Sources"),
                ("GGA", "GNSS fix", "GN, GP, GA, GL", "GNSS, filter"),
                ("GLL", "Latitude and longitude", "GN, GP, GA, GL", "GNSS, filter"),
                ("GSV", "Satellites in view", "by constellation", "GNSS"),
                ("RMC", "Recommended minimum", "GN, GP, GA, GL", "GNSS, filter"),
                ("VTG", "Course and speed over ground", "GN, GP, GA, GL", "GNSS, filter"),
                ("HDT", "True heading", "GN, GP, GA, GL", "GNSS, filter"),
                ("ZDA", "Time and date", "GN, GP, GA, GL", "GNSS"),
                ("GST", "Error statistics", "GN, GP, GA, GL", "GNSS, filter"),
                ("PMSRA", "Euler angles", "proprietary", "filter"),
                ("PMSRR", "Angular rate and acceleration", "proprietary", "sensor"),
            ),
        ),
        "nmea_input": Note(
            "NMEA input",
            "Sentences accepted from an external receiver, with any talker: RMC, ZDA, HDT, GGA, VTG, GLL and GSV. They are received on the main port, USB 2, or a UART on GPIO pins; while such a UART is configured to receive, on that one only. An epoch is processed when a sentence with another time arrives. The manual warns of a known bug of NMEA input; the errata sheet that it refers to is not known.",
            (),
        ),
        "rtcm_input": Note(
            "RTCM input",
            "RTCM 3 messages that the GNSS receivers use.",
            (
                ("Contents", "Messages"),
                ("GPS observations", "1074, 1075, 1077"),
                ("GLONASS observations", "1084, 1085, 1087"),
                ("Galileo observations", "1094, 1095, 1097"),
                ("BeiDou observations", "1124, 1125, 1127"),
                ("Station coordinates", "1005, 1006"),
                ("Antenna description", "1007"),
                ("Antenna and receiver description", "1033"),
                ("GLONASS biases", "1230"),
            ),
        ),
        "gnss_signals": Note(
            "GNSS signals",
            "Signals that can be enabled together by `gnss.signal_config`. GPS or Galileo must be enabled, and GPS L1 with BeiDou L1 alone is refused.",
            (
                ("Constellation", "Choices"),
                ("GPS", "none, L1, L1 + L5"),
                ("GLONASS", "none, L1"),
                ("Galileo", "none, L1 + L5"),
                ("BeiDou", "none, L1, L1 + L5"),
            ),
        ),
        "sensor_ranges": Note(
            "Sensor ranges",
            "Settings of `3dm.sensor_range`. The manual gives them for related models, and its gyroscope column is cut off; `3dm.get_calibrated_sensor_ranges` returns those of the device.",
            (
                ("Sensor", "Setting", "Range"),
                ("Accelerometer", "2", "4 g"),
                ("Accelerometer", "3", "8 g"),
                ("Accelerometer", "4", "16 g"),
                ("Gyroscope", "2", "250 deg/s"),
            ),
        ),
        "pps": Note(
            "Pulse per second",
            "Without a valid PPS the filter neither starts nor accepts measurements. A PPS output has a duty cycle of 50 %; each second begins at its rising edge.",
            (),
        ),
    },
    readings={
        "base.comm_speed.port": types.CommInterface,
        "base.built_in_test_response.result": types.Cv7BuiltInTest,
        "base.continuous_built_in_test_response.result": types.Cv7ContinuousBuiltInTest,
        "base.comm_speed_response.port": types.CommInterface,
        "filter_data.status.filter_state": filter_data.Cv7FilterState,
        "filter_data.status.dynamics_mode": filter_data.Cv7DynamicsMode,
        "filter_data.status.status_flags": filter_data.Cv7StatusFlags,
        "system_data.built_in_test.result": types.Cv7ContinuousBuiltInTest,
    },
    ack_codes=frozenset([0, 1, 2, 3, 4, 5, 6]),
    incomplete=(),
    also=(),
    generation=7,
    manual="3dm-cv7-gnss-ins",
)
"""Inertial navigation system with two RTK-capable GNSS receivers, magnetometer and pressure sensor.
Generation 7. Model number 6292. Manual: MicroStrain 3DM-CV7-GNSS/INS Documentation, 8500-0099.
Uncertain: What the bug of NMEA input is that the manual warns of.

- mip-sdk-4: Device models
"""

CV7_INS = Device(
    id="3dm-cv7-ins",
    title="3DM-CV7-INS",
    description="Inertial navigation system without a GNSS receiver of its own.",
    model_number=6291,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it.",
            frozenset(
                {
                    (0x0D, 0x13),  # filter.antenna_offset
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (MicroStrain 3DM-CV7-INS Documentation: Field pages).",
            frozenset(
                {
                    (0x0D, 0x52),  # filter.initialization_config
                    (0x13, 0x01),  # aiding.frame_config
                    (0x82, 0x50),  # filter_data.aiding_frame_config_error
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (MicroStrain 3DM-CV7-INS Documentation: Index of the set 0x94, on a test site).",
            frozenset(
                {
                    (0x94, 0x03),  # gnss_external.llh_position
                    (0x94, 0x04),  # gnss_external.ecef_position
                    (0x94, 0x05),  # gnss_external.ned_velocity
                    (0x94, 0x06),  # gnss_external.ecef_velocity
                    (0x94, 0x07),  # gnss_external.dop
                    (0x94, 0x08),  # gnss_external.utc_time
                    (0x94, 0x0B),  # gnss_external.fix_info
                    (0x94, 0x10),  # gnss_external.clock_info_2
                    (0x94, 0x11),  # gnss_external.gps_leap_seconds
                    (0x94, 0x14),  # gnss_external.rf_error_detection
                    (0x94, 0x20),  # gnss_external.satellite_status
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x0E),  # 3dm.get_base_rate
                    (0x0C, 0x0F),  # 3dm.message_format
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x50),  # filter.aiding_measurement_enable
                    (0x13, 0x22),  # aiding.llh_position
                    (0x13, 0x29),  # aiding.ned_velocity
                    (0x13, 0x2A),  # aiding.body_frame_velocity
                    (0x13, 0x31),  # aiding.true_heading
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            frozenset(
                {
                    (0x82, 0x01),  # filter_data.llh_position
                    (0x82, 0x02),  # filter_data.ned_velocity
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x10),  # filter_data.status
                    (0xA0, 0x02),  # system_data.time_sync_status
                    (0xFF, 0xD3),  # shared.gps_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (PX4: Driver of the vendor's sensors).",
            frozenset(
                {
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x31),  # 3dm.sensor_to_vehicle_transform_euler
                    (0x0C, 0x52),  # 3dm.sensor_range
                    (0x0D, 0x15),  # filter.gnss_source
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x08),  # filter_data.llh_position_uncertainty
                    (0x82, 0x09),  # filter_data.ned_velocity_uncertainty
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (ROS driver of the vendor: Example configurations).",
            frozenset(
                {
                    (0x01, 0x09),  # base.comm_speed
                    (0x0C, 0x28),  # 3dm.pps_source_control
                    (0x0C, 0x41),  # 3dm.gpio_config
                    (0x0C, 0x42),  # 3dm.gpio_state
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x55),  # filter.relative_position_config
                    (0x82, 0x36),  # filter_data.ecef_position_uncertainty
                    (0x82, 0x40),  # filter_data.ecef_position
                    (0x82, 0x42),  # filter_data.ned_relative_position
                    (0x82, 0x46),  # filter_data.aiding_measurement_summary
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: MIP node features).",
            frozenset(
                {
                    (0x0D, 0x53)  # filter.adaptive_filter_options
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (Public programs of users: Notes on a 3DM-CV7-INS, 2026).",
            frozenset(
                {
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: Fields of event thresholds).",
            frozenset(
                {
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x07),  # filter_data.accel_bias
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0C),  # filter_data.accel_bias_uncertainty
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0xA0, 0x03),  # system_data.gpio_state
                    (0xFF, 0xD5),  # shared.reference_timestamp
                    (0xFF, 0xD7),  # shared.external_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it, 3DM-CV7-GNSS/INS.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x08),  # base.continuous_built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x04),  # 3dm.poll_nmea_data
                    (0x0C, 0x0C),  # 3dm.nmea_message_format
                    (0x0C, 0x0D),  # 3dm.poll_data
                    (0x0C, 0x10),  # 3dm.factory_streaming
                    (0x0C, 0x2A),  # 3dm.get_event_support
                    (0x0C, 0x2B),  # 3dm.event_control
                    (0x0C, 0x2C),  # 3dm.get_event_trigger_status
                    (0x0C, 0x2D),  # 3dm.get_event_action_status
                    (0x0C, 0x2E),  # 3dm.event_trigger_config
                    (0x0C, 0x2F),  # 3dm.event_action_config
                    (0x0C, 0x32),  # 3dm.sensor_to_vehicle_transform_quaternion
                    (0x0C, 0x33),  # 3dm.sensor_to_vehicle_transform_dcm
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x53),  # 3dm.get_calibrated_sensor_ranges
                    (0x0C, 0x54),  # 3dm.low_pass_filter
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x05),  # filter.run
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1C),  # filter.accel_bias_model
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0D, 0x56),  # filter.reference_point_lever_arm
                    (0x13, 0x1F),  # aiding.echo_control
                    (0x13, 0x21),  # aiding.ecef_position
                    (0x13, 0x23),  # aiding.height_above_ellipsoid
                    (0x13, 0x28),  # aiding.ecef_velocity
                    (0x13, 0x32),  # aiding.magnetic_field
                    (0x13, 0x33),  # aiding.pressure
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x14),  # sensor.temperature_statistics
                    (0x80, 0x18),  # sensor.overrange_status
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x15),  # filter_data.magnetic_model
                    (0x82, 0x37),  # filter_data.ecef_velocity_uncertainty
                    (0x82, 0x41),  # filter_data.ecef_velocity
                    (0x82, 0x43),  # filter_data.gnss_position_aiding_status
                    (0x82, 0x51),  # filter_data.aiding_frame_config_error_uncertainty
                    (0xA0, 0x01),  # system_data.built_in_test
                    (0xFF, 0xD0),  # shared.event_source
                    (0xFF, 0xD4),  # shared.delta_time
                    (0xFF, 0xD6),  # shared.reference_time_delta
                    (0xFF, 0xD8),  # shared.external_time_delta
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={0x94: 0},
    ports=(
        Port("Main", 1, (), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (), ("MIP",), ("MIP",)),
        Port("UART 2", 18, (), ("MIP",), ("MIP",)),
        Port("UART 3", 19, (), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(
            4, None, "Frames that the aiding frame configuration can define, according to MSCL."
        ),
        "antenna_offset": Limit(10, "m", "Greatest distance of the antenna from the device."),
    },
    notes={
        "anti_aliasing": Note(
            "Anti-aliasing low-pass filter",
            "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.",
            (
                ("Set", "Descriptor", "Data"),
                ("0x80", "0x04", "Scaled accel"),
                ("0x80", "0x05", "Scaled gyro"),
                ("0x80", "0x06", "Scaled mag"),
                ("0x80", "0x17", "Scaled pressure"),
                ("0x82", "0x1C", "Compensated acceleration"),
                ("0x82", "0x0E", "Compensated angular rate"),
                ("0x82", "0x0D", "Linear acceleration"),
            ),
        ),
        "ports": Note(
            "Ports",
            "The main port is an alias of USB 1 if that is connected, or else of UART 1. UART 2 is on the pins GPIO 1 and 2, UART 3 on GPIO 3 and 4.",
            (),
        ),
        "gpio_pins": Note(
            "GPIO pins",
            "Features of each pin, according to MSCL.",
            (
                ("Pin", "Features"),
                ("1", "GPIO, PPS, timestamp, UART 2"),
                ("2", "GPIO, PPS, timestamp, UART 2"),
                ("3", "GPIO, PPS, timestamp, UART 3, encoder A"),
                ("4", "GPIO, PPS, timestamp, UART 3, encoder B"),
            ),
        ),
        "receivers": Note(
            "GNSS sets", "The sets 0x94 and 0x95 have data of two receivers of the user.", ()
        ),
    },
    readings={
        "base.comm_speed.port": types.CommInterface,
        "base.built_in_test_response.result": types.Cv7BuiltInTest,
        "base.continuous_built_in_test_response.result": types.Cv7InertialContinuousBuiltInTest,
        "base.comm_speed_response.port": types.CommInterface,
        "filter_data.status.filter_state": filter_data.Cv7FilterState,
        "filter_data.status.dynamics_mode": filter_data.Cv7DynamicsMode,
        "filter_data.status.status_flags": filter_data.Cv7StatusFlags,
        "system_data.built_in_test.result": types.Cv7InertialContinuousBuiltInTest,
    },
    ack_codes=frozenset([]),
    incomplete=(
        "Only some pages of the manual are known, so it has more commands and data.",
        "It has the data sets 0x80, 0x82, 0x94, 0x95, 0xA0 and 0xFF.",
    ),
    also=(),
    generation=7,
    manual="3dm-cv7-ins",
)
"""Inertial navigation system without a GNSS receiver of its own. Generation 7. Model number 6291.
Manual: MicroStrain 3DM-CV7-INS Documentation, online, known from some pages. This profile is
incomplete: Only some pages of the manual are known, so it has more commands and data. This profile
is incomplete: It has the data sets 0x80, 0x82, 0x94, 0x95, 0xA0 and 0xFF. Uncertain: Only a test
site of the vendor names the set 0x95. Uncertain: The base rate of the set 0x94 is inferred from the
3DM-CV7-GNSS/INS.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CX5_10 = Device(
    id="3dm-cx5-10",
    title="3DM-CX5-10",
    description="Inertial measurement unit.",
    model_number=6275,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (3DM-CX5-10 Data Communications Protocol Manual: Contents).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x11),  # 3dm.data_stream_control
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-15 and 3DM-CX5-10.",
            frozenset(
                {
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x12),  # sensor.gps_timestamp
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_without_state_response` and `3dm.device_status_diagnostic_imu_response`.",
            (),
        )
    },
    readings={
        "base.built_in_test_response.result": types.Gx5BuiltInTest,
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
    },
    ack_codes=frozenset([]),
    incomplete=(
        "Of the manual the table of contents is known, up to the set `3dm`. It has the sets `base`, `3dm` and `sensor` only.",
    ),
    also=("3DM-CX5-IMU",),
    generation=5,
    manual="3dm-cx5-10",
)
"""Inertial measurement unit. Also called 3DM-CX5-IMU. Generation 5. Model number 6275. Manual:
3DM-CX5-10 Data Communications Protocol Manual, 8500-0087 revision A, 2017, known from its contents.
This profile is incomplete: Of the manual the table of contents is known, up to the set `3dm`. It
has the sets `base`, `3dm` and `sensor` only.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CX5_15 = Device(
    id="3dm-cx5-15",
    title="3DM-CX5-15",
    description="Attitude reference.",
    model_number=6274,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x11),  # filter_data.timestamp
                    (0x82, 0x1C),  # filter_data.comp_accel
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x03),  # base.get_device_info
                    (0x0D, 0x01),  # filter.reset
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x07),  # base.get_extended_descriptors
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-15.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x18),  # filter.heading_source
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x26),  # filter.reference_position
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0D, 0x41),  # filter.enable_measurements
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x4B),  # filter.pitch_roll_aiding
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x80, 0x11),  # sensor.up_vector
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0F),  # filter_data.wgs84_gravity_magnitude
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x14),  # filter_data.heading_update_state
                    (0x82, 0x21),  # filter_data.pressure_altitude
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_response`.",
            (),
        )
    },
    readings={
        "base.built_in_test_response.result": types.Gx5BuiltInTest,
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=("3DM-CX5-AR",),
    generation=5,
    manual=None,
)
"""Attitude reference. Also called 3DM-CX5-AR. Generation 5. Model number 6274. No manual is known.
This profile is incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CX5_25 = Device(
    id="3dm-cx5-25",
    title="3DM-CX5-25",
    description="Attitude and heading reference system.",
    model_number=6273,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x11),  # filter_data.timestamp
                    (0x82, 0x1C),  # filter_data.comp_accel
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x03),  # base.get_device_info
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x18),  # filter.heading_source
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x07),  # base.get_extended_descriptors
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-15 and 3DM-GX5-45.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x26),  # filter.reference_position
                    (0x0D, 0x27),  # filter.mag_capture_auto_calibration
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0D, 0x29),  # filter.pressure_altitude_noise
                    (0x0D, 0x2B),  # filter.hard_iron_offset_noise
                    (0x0D, 0x2C),  # filter.soft_iron_matrix_noise
                    (0x0D, 0x41),  # filter.enable_measurements
                    (0x0D, 0x42),  # filter.mag_noise
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x45),  # filter.mag_magnitude_error_adaptive_measurement
                    (0x0D, 0x46),  # filter.mag_dip_angle_error_adaptive_measurement
                    (0x0D, 0x47),  # filter.altitude_aiding
                    (0x0D, 0x4B),  # filter.pitch_roll_aiding
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x80, 0x11),  # sensor.up_vector
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0F),  # filter_data.wgs84_gravity_magnitude
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x14),  # filter_data.heading_update_state
                    (0x82, 0x15),  # filter_data.magnetic_model
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0x82, 0x25),  # filter_data.mag_offset
                    (0x82, 0x26),  # filter_data.mag_matrix
                    (0x82, 0x28),  # filter_data.mag_offset_uncertainty
                    (0x82, 0x29),  # filter_data.mag_matrix_uncertainty
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_response`.",
            (),
        )
    },
    readings={
        "base.built_in_test_response.result": types.Gx5BuiltInTest,
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=("3DM-CX5-AHRS",),
    generation=5,
    manual=None,
)
"""Attitude and heading reference system. Also called 3DM-CX5-AHRS. Generation 5. Model number 6273.
No manual is known. This profile is incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CX5_35 = Device(
    id="3dm-cx5-35",
    title="3DM-CX5-35",
    description="Attitude and heading reference with GNSS.",
    model_number=6272,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-35.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x02),  # 3dm.poll_gnss_data
                    (0x0C, 0x07),  # 3dm.get_gnss_base_rate
                    (0x0C, 0x09),  # 3dm.gnss_message_format
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x21),  # 3dm.constellation_settings
                    (0x0C, 0x22),  # 3dm.gnss_sbas_settings
                    (0x0C, 0x23),  # 3dm.gnss_assisted_fix
                    (0x0C, 0x24),  # 3dm.gnss_time_assistance
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x80, 0x11),  # sensor.up_vector
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x81, 0x03),  # gnss_data.llh_position
                    (0x81, 0x04),  # gnss_data.ecef_position
                    (0x81, 0x05),  # gnss_data.ned_velocity
                    (0x81, 0x06),  # gnss_data.ecef_velocity
                    (0x81, 0x07),  # gnss_data.dop
                    (0x81, 0x08),  # gnss_data.utc_time
                    (0x81, 0x09),  # gnss_data.gps_time
                    (0x81, 0x0A),  # gnss_data.clock_info
                    (0x81, 0x0B),  # gnss_data.fix_info
                    (0x81, 0x0C),  # gnss_data.sv_info
                    (0x81, 0x0D),  # gnss_data.hardware_status
                    (0x81, 0x0E),  # gnss_data.dgps_info
                    (0x81, 0x0F),  # gnss_data.dgps_channel
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_gnss_response`.",
            (),
        )
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=("3DM-CX5-GNSS/AHRS",),
    generation=5,
    manual=None,
)
"""Attitude and heading reference with GNSS. Also called 3DM-CX5-GNSS/AHRS. Generation 5. Model
number 6272. No manual is known. This profile is incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CX5_45 = Device(
    id="3dm-cx5-45",
    title="3DM-CX5-45",
    description="Inertial navigation system with GNSS.",
    model_number=6271,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (3DM-CX5-45 Data Communications Protocol Manual: Title).",
            frozenset(
                {
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x09),  # 3dm.gnss_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x13),  # filter.antenna_offset
                    (0x0D, 0x18),  # filter.heading_source
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x81, 0x0B),  # gnss_data.fix_info
                    (0x82, 0x01),  # filter_data.llh_position
                    (0x82, 0x02),  # filter_data.ned_velocity
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x11),  # filter_data.timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x03),  # base.get_device_info
                    (0x0C, 0x07),  # 3dm.get_gnss_base_rate
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (ArduPilot: AP_ExternalAHRS_MicroStrain5).",
            frozenset(
                {
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x81, 0x03),  # gnss_data.llh_position
                    (0x81, 0x05),  # gnss_data.ned_velocity
                    (0x81, 0x07),  # gnss_data.dop
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x07),  # base.get_extended_descriptors
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-45.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x02),  # 3dm.poll_gnss_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x21),  # 3dm.constellation_settings
                    (0x0C, 0x22),  # 3dm.gnss_sbas_settings
                    (0x0C, 0x23),  # 3dm.gnss_assisted_fix
                    (0x0C, 0x24),  # 3dm.gnss_time_assistance
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x10),  # filter.vehicle_dynamics_mode
                    (0x0D, 0x12),  # filter.sensor_to_vehicle_offset
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x15),  # filter.gnss_source
                    (0x0D, 0x16),  # filter.external_gnss_update
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1C),  # filter.accel_bias_model
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1E),  # filter.auto_zupt
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x22),  # filter.commanded_zupt
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x27),  # filter.mag_capture_auto_calibration
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0D, 0x29),  # filter.pressure_altitude_noise
                    (0x0D, 0x2B),  # filter.hard_iron_offset_noise
                    (0x0D, 0x2C),  # filter.soft_iron_matrix_noise
                    (0x0D, 0x42),  # filter.mag_noise
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x45),  # filter.mag_magnitude_error_adaptive_measurement
                    (0x0D, 0x46),  # filter.mag_dip_angle_error_adaptive_measurement
                    (0x0D, 0x47),  # filter.altitude_aiding
                    (0x0D, 0x4B),  # filter.pitch_roll_aiding
                    (0x0D, 0x53),  # filter.adaptive_filter_options
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x80, 0x11),  # sensor.up_vector
                    (0x81, 0x04),  # gnss_data.ecef_position
                    (0x81, 0x06),  # gnss_data.ecef_velocity
                    (0x81, 0x08),  # gnss_data.utc_time
                    (0x81, 0x09),  # gnss_data.gps_time
                    (0x81, 0x0A),  # gnss_data.clock_info
                    (0x81, 0x0C),  # gnss_data.sv_info
                    (0x81, 0x0D),  # gnss_data.hardware_status
                    (0x81, 0x0E),  # gnss_data.dgps_info
                    (0x81, 0x0F),  # gnss_data.dgps_channel
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x14),  # filter_data.heading_update_state
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-25 and 3DM-RQ1-45-LT.",
            frozenset(
                {
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x07),  # filter_data.accel_bias
                    (0x82, 0x08),  # filter_data.llh_position_uncertainty
                    (0x82, 0x09),  # filter_data.ned_velocity_uncertainty
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0C),  # filter_data.accel_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0F),  # filter_data.wgs84_gravity_magnitude
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x15),  # filter_data.magnetic_model
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x20),  # filter_data.standard_atmosphere
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0x82, 0x25),  # filter_data.mag_offset
                    (0x82, 0x26),  # filter_data.mag_matrix
                    (0x82, 0x28),  # filter_data.mag_offset_uncertainty
                    (0x82, 0x29),  # filter_data.mag_matrix_uncertainty
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_gnss_response`.",
            (),
        )
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    ack_codes=frozenset([]),
    incomplete=(
        "Of the manual the title is known: 196 pages, of which those from 131 describe the data.",
    ),
    also=("3DM-CX5-GNSS/INS",),
    generation=5,
    manual="3dm-cx5-45",
)
"""Inertial navigation system with GNSS. Also called 3DM-CX5-GNSS/INS. Generation 5. Model number
6271. Manual: 3DM-CX5-45 Data Communications Protocol Manual, 8500-0089 revision A, 2017, known from
its title. This profile is incomplete: Of the manual the title is known: 196 pages, of which those
from 131 describe the data.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CX7_AHRS = Device(
    id="3dm-cx7-ahrs",
    title="3DM-CX7-AHRS",
    description="Attitude and heading reference system.",
    model_number=6701,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: MIP node features).",
            frozenset(
                {
                    (0x0C, 0x28),  # 3dm.pps_source_control
                    (0x0C, 0x41),  # 3dm.gpio_config
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x50),  # filter.aiding_measurement_enable
                    (0x0D, 0x53),  # filter.adaptive_filter_options
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: Fields of event thresholds).",
            frozenset(
                {
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0xA0, 0x02),  # system_data.time_sync_status
                    (0xA0, 0x03),  # system_data.gpio_state
                    (0xFF, 0xD3),  # shared.gps_timestamp
                    (0xFF, 0xD5),  # shared.reference_timestamp
                    (0xFF, 0xD7),  # shared.external_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x0C, 0x0E),  # 3dm.get_base_rate
                    (0x0C, 0x0F),  # 3dm.message_format
                    (0x0C, 0x30),  # 3dm.device_settings
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it, 3DM-CV7-GNSS/INS.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x08),  # base.continuous_built_in_test
                    (0x01, 0x09),  # base.comm_speed
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x0D),  # 3dm.poll_data
                    (0x0C, 0x10),  # 3dm.factory_streaming
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x2A),  # 3dm.get_event_support
                    (0x0C, 0x2B),  # 3dm.event_control
                    (0x0C, 0x2C),  # 3dm.get_event_trigger_status
                    (0x0C, 0x2D),  # 3dm.get_event_action_status
                    (0x0C, 0x2E),  # 3dm.event_trigger_config
                    (0x0C, 0x2F),  # 3dm.event_action_config
                    (0x0C, 0x31),  # 3dm.sensor_to_vehicle_transform_euler
                    (0x0C, 0x32),  # 3dm.sensor_to_vehicle_transform_quaternion
                    (0x0C, 0x33),  # 3dm.sensor_to_vehicle_transform_dcm
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x42),  # 3dm.gpio_state
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x52),  # 3dm.sensor_range
                    (0x0C, 0x53),  # 3dm.get_calibrated_sensor_ranges
                    (0x0C, 0x54),  # 3dm.low_pass_filter
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x13, 0x01),  # aiding.frame_config
                    (0x13, 0x1F),  # aiding.echo_control
                    (0x13, 0x31),  # aiding.true_heading
                    (0x13, 0x32),  # aiding.magnetic_field
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x14),  # sensor.temperature_statistics
                    (0x80, 0x18),  # sensor.overrange_status
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0xA0, 0x01),  # system_data.built_in_test
                    (0xFF, 0xD0),  # shared.event_source
                    (0xFF, 0xD4),  # shared.delta_time
                    (0xFF, 0xD6),  # shared.reference_time_delta
                    (0xFF, 0xD8),  # shared.external_time_delta
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(
        Port("Main", 1, (), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(
            4, None, "Frames that the aiding frame configuration can define, according to MSCL."
        )
    },
    notes={
        "anti_aliasing": Note(
            "Anti-aliasing low-pass filter",
            "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.",
            (
                ("Set", "Descriptor", "Data"),
                ("0x80", "0x04", "Scaled accel"),
                ("0x80", "0x05", "Scaled gyro"),
                ("0x80", "0x06", "Scaled mag"),
                ("0x80", "0x17", "Scaled pressure"),
                ("0x82", "0x1C", "Compensated acceleration"),
                ("0x82", "0x0E", "Compensated angular rate"),
                ("0x82", "0x0D", "Linear acceleration"),
            ),
        ),
        "ports": Note(
            "Ports",
            "The main port is an alias of USB 1 if that is connected, or else of UART 1.",
            (),
        ),
        "gpio_pins": Note(
            "GPIO pins",
            "Features of each pin, according to MSCL.",
            (
                ("Pin", "Features"),
                ("1", "GPIO, PPS, timestamp"),
                ("2", "GPIO, PPS, timestamp"),
                ("3", "GPIO, PPS, timestamp"),
                ("4", "GPIO, PPS, timestamp"),
            ),
        ),
    },
    readings={
        "base.comm_speed.port": types.CommInterface,
        "base.built_in_test_response.result": types.Cv7BuiltInTest,
        "base.continuous_built_in_test_response.result": types.Cv7InertialContinuousBuiltInTest,
        "base.comm_speed_response.port": types.CommInterface,
        "filter_data.status.filter_state": filter_data.Cv7FilterState,
        "filter_data.status.dynamics_mode": filter_data.Cv7DynamicsMode,
        "filter_data.status.status_flags": filter_data.Cv7StatusFlags,
        "system_data.built_in_test.result": types.Cv7InertialContinuousBuiltInTest,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=(),
    generation=7,
    manual=None,
)
"""Attitude and heading reference system. Generation 7. Model number 6701. No manual is known. This
profile is incomplete: No manual is known. Uncertain: Only MSCL knows it; the SDK does not.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CX7_AR = Device(
    id="3dm-cx7-ar",
    title="3DM-CX7-AR",
    description="Attitude reference.",
    model_number=6700,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: MIP node features).",
            frozenset(
                {
                    (0x0C, 0x28),  # 3dm.pps_source_control
                    (0x0C, 0x41),  # 3dm.gpio_config
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x50),  # filter.aiding_measurement_enable
                    (0x0D, 0x53),  # filter.adaptive_filter_options
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: Fields of event thresholds).",
            frozenset(
                {
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0xA0, 0x02),  # system_data.time_sync_status
                    (0xA0, 0x03),  # system_data.gpio_state
                    (0xFF, 0xD3),  # shared.gps_timestamp
                    (0xFF, 0xD5),  # shared.reference_timestamp
                    (0xFF, 0xD7),  # shared.external_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x0C, 0x0E),  # 3dm.get_base_rate
                    (0x0C, 0x0F),  # 3dm.message_format
                    (0x0C, 0x30),  # 3dm.device_settings
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it, 3DM-CV7-GNSS/INS.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x08),  # base.continuous_built_in_test
                    (0x01, 0x09),  # base.comm_speed
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x0D),  # 3dm.poll_data
                    (0x0C, 0x10),  # 3dm.factory_streaming
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x2A),  # 3dm.get_event_support
                    (0x0C, 0x2B),  # 3dm.event_control
                    (0x0C, 0x2C),  # 3dm.get_event_trigger_status
                    (0x0C, 0x2D),  # 3dm.get_event_action_status
                    (0x0C, 0x2E),  # 3dm.event_trigger_config
                    (0x0C, 0x2F),  # 3dm.event_action_config
                    (0x0C, 0x31),  # 3dm.sensor_to_vehicle_transform_euler
                    (0x0C, 0x32),  # 3dm.sensor_to_vehicle_transform_quaternion
                    (0x0C, 0x33),  # 3dm.sensor_to_vehicle_transform_dcm
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x42),  # 3dm.gpio_state
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x52),  # 3dm.sensor_range
                    (0x0C, 0x53),  # 3dm.get_calibrated_sensor_ranges
                    (0x0C, 0x54),  # 3dm.low_pass_filter
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x13, 0x01),  # aiding.frame_config
                    (0x13, 0x1F),  # aiding.echo_control
                    (0x13, 0x31),  # aiding.true_heading
                    (0x13, 0x32),  # aiding.magnetic_field
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x14),  # sensor.temperature_statistics
                    (0x80, 0x18),  # sensor.overrange_status
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0xA0, 0x01),  # system_data.built_in_test
                    (0xFF, 0xD0),  # shared.event_source
                    (0xFF, 0xD4),  # shared.delta_time
                    (0xFF, 0xD6),  # shared.reference_time_delta
                    (0xFF, 0xD8),  # shared.external_time_delta
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(
        Port("Main", 1, (), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(
            4, None, "Frames that the aiding frame configuration can define, according to MSCL."
        )
    },
    notes={
        "anti_aliasing": Note(
            "Anti-aliasing low-pass filter",
            "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.",
            (
                ("Set", "Descriptor", "Data"),
                ("0x80", "0x04", "Scaled accel"),
                ("0x80", "0x05", "Scaled gyro"),
                ("0x80", "0x06", "Scaled mag"),
                ("0x80", "0x17", "Scaled pressure"),
                ("0x82", "0x1C", "Compensated acceleration"),
                ("0x82", "0x0E", "Compensated angular rate"),
                ("0x82", "0x0D", "Linear acceleration"),
            ),
        ),
        "ports": Note(
            "Ports",
            "The main port is an alias of USB 1 if that is connected, or else of UART 1.",
            (),
        ),
        "gpio_pins": Note(
            "GPIO pins",
            "Features of each pin, according to MSCL.",
            (
                ("Pin", "Features"),
                ("1", "GPIO, PPS, timestamp"),
                ("2", "GPIO, PPS, timestamp"),
                ("3", "GPIO, PPS, timestamp"),
                ("4", "GPIO, PPS, timestamp"),
            ),
        ),
    },
    readings={
        "base.comm_speed.port": types.CommInterface,
        "base.built_in_test_response.result": types.Cv7BuiltInTest,
        "base.continuous_built_in_test_response.result": types.Cv7InertialContinuousBuiltInTest,
        "base.comm_speed_response.port": types.CommInterface,
        "filter_data.status.filter_state": filter_data.Cv7FilterState,
        "filter_data.status.dynamics_mode": filter_data.Cv7DynamicsMode,
        "filter_data.status.status_flags": filter_data.Cv7StatusFlags,
        "system_data.built_in_test.result": types.Cv7InertialContinuousBuiltInTest,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=(),
    generation=7,
    manual=None,
)
"""Attitude reference. Generation 7. Model number 6700. No manual is known. This profile is
incomplete: No manual is known. Uncertain: Only MSCL knows it; the SDK does not.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

CX7_INS = Device(
    id="3dm-cx7-ins",
    title="3DM-CX7-INS",
    description="Inertial navigation system.",
    model_number=6702,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: MIP node features).",
            frozenset(
                {
                    (0x0C, 0x28),  # 3dm.pps_source_control
                    (0x0C, 0x41),  # 3dm.gpio_config
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x50),  # filter.aiding_measurement_enable
                    (0x0D, 0x53),  # filter.adaptive_filter_options
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: Fields of event thresholds).",
            frozenset(
                {
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x07),  # filter_data.accel_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0C),  # filter_data.accel_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0xA0, 0x02),  # system_data.time_sync_status
                    (0xA0, 0x03),  # system_data.gpio_state
                    (0xFF, 0xD3),  # shared.gps_timestamp
                    (0xFF, 0xD5),  # shared.reference_timestamp
                    (0xFF, 0xD7),  # shared.external_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x0C, 0x0E),  # 3dm.get_base_rate
                    (0x0C, 0x0F),  # 3dm.message_format
                    (0x0C, 0x30),  # 3dm.device_settings
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it, 3DM-CV7-GNSS/INS.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x08),  # base.continuous_built_in_test
                    (0x01, 0x09),  # base.comm_speed
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x04),  # 3dm.poll_nmea_data
                    (0x0C, 0x0C),  # 3dm.nmea_message_format
                    (0x0C, 0x0D),  # 3dm.poll_data
                    (0x0C, 0x10),  # 3dm.factory_streaming
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x2A),  # 3dm.get_event_support
                    (0x0C, 0x2B),  # 3dm.event_control
                    (0x0C, 0x2C),  # 3dm.get_event_trigger_status
                    (0x0C, 0x2D),  # 3dm.get_event_action_status
                    (0x0C, 0x2E),  # 3dm.event_trigger_config
                    (0x0C, 0x2F),  # 3dm.event_action_config
                    (0x0C, 0x31),  # 3dm.sensor_to_vehicle_transform_euler
                    (0x0C, 0x32),  # 3dm.sensor_to_vehicle_transform_quaternion
                    (0x0C, 0x33),  # 3dm.sensor_to_vehicle_transform_dcm
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x42),  # 3dm.gpio_state
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x52),  # 3dm.sensor_range
                    (0x0C, 0x53),  # 3dm.get_calibrated_sensor_ranges
                    (0x0C, 0x54),  # 3dm.low_pass_filter
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x05),  # filter.run
                    (0x0D, 0x13),  # filter.antenna_offset
                    (0x0D, 0x15),  # filter.gnss_source
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1C),  # filter.accel_bias_model
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0D, 0x52),  # filter.initialization_config
                    (0x0D, 0x55),  # filter.relative_position_config
                    (0x0D, 0x56),  # filter.reference_point_lever_arm
                    (0x13, 0x01),  # aiding.frame_config
                    (0x13, 0x1F),  # aiding.echo_control
                    (0x13, 0x21),  # aiding.ecef_position
                    (0x13, 0x22),  # aiding.llh_position
                    (0x13, 0x23),  # aiding.height_above_ellipsoid
                    (0x13, 0x28),  # aiding.ecef_velocity
                    (0x13, 0x29),  # aiding.ned_velocity
                    (0x13, 0x2A),  # aiding.body_frame_velocity
                    (0x13, 0x31),  # aiding.true_heading
                    (0x13, 0x32),  # aiding.magnetic_field
                    (0x13, 0x33),  # aiding.pressure
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x14),  # sensor.temperature_statistics
                    (0x80, 0x18),  # sensor.overrange_status
                    (0x82, 0x01),  # filter_data.llh_position
                    (0x82, 0x02),  # filter_data.ned_velocity
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x08),  # filter_data.llh_position_uncertainty
                    (0x82, 0x09),  # filter_data.ned_velocity_uncertainty
                    (0x82, 0x15),  # filter_data.magnetic_model
                    (0x82, 0x36),  # filter_data.ecef_position_uncertainty
                    (0x82, 0x37),  # filter_data.ecef_velocity_uncertainty
                    (0x82, 0x40),  # filter_data.ecef_position
                    (0x82, 0x41),  # filter_data.ecef_velocity
                    (0x82, 0x42),  # filter_data.ned_relative_position
                    (0x82, 0x43),  # filter_data.gnss_position_aiding_status
                    (0x82, 0x46),  # filter_data.aiding_measurement_summary
                    (0x82, 0x50),  # filter_data.aiding_frame_config_error
                    (0x82, 0x51),  # filter_data.aiding_frame_config_error_uncertainty
                    (0x94, 0x03),  # gnss_external.llh_position
                    (0x94, 0x05),  # gnss_external.ned_velocity
                    (0x94, 0x08),  # gnss_external.utc_time
                    (0x94, 0x0B),  # gnss_external.fix_info
                    (0x94, 0x20),  # gnss_external.satellite_status
                    (0xA0, 0x01),  # system_data.built_in_test
                    (0xFF, 0xD0),  # shared.event_source
                    (0xFF, 0xD4),  # shared.delta_time
                    (0xFF, 0xD6),  # shared.reference_time_delta
                    (0xFF, 0xD8),  # shared.external_time_delta
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(
        Port("Main", 1, (), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (), ("MIP",), ("MIP",)),
        Port("UART 2", 18, (), ("MIP",), ("MIP",)),
        Port("UART 3", 19, (), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(
            4, None, "Frames that the aiding frame configuration can define, according to MSCL."
        )
    },
    notes={
        "anti_aliasing": Note(
            "Anti-aliasing low-pass filter",
            "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.",
            (
                ("Set", "Descriptor", "Data"),
                ("0x80", "0x04", "Scaled accel"),
                ("0x80", "0x05", "Scaled gyro"),
                ("0x80", "0x06", "Scaled mag"),
                ("0x80", "0x17", "Scaled pressure"),
                ("0x82", "0x1C", "Compensated acceleration"),
                ("0x82", "0x0E", "Compensated angular rate"),
                ("0x82", "0x0D", "Linear acceleration"),
            ),
        ),
        "ports": Note(
            "Ports",
            "The main port is an alias of USB 1 if that is connected, or else of UART 1. UART 2 is on the pins GPIO 1 and 2, UART 3 on GPIO 3 and 4.",
            (),
        ),
        "gpio_pins": Note(
            "GPIO pins",
            "Features of each pin, according to MSCL.",
            (
                ("Pin", "Features"),
                ("1", "GPIO, PPS, timestamp, UART 2"),
                ("2", "GPIO, PPS, timestamp, UART 2"),
                ("3", "GPIO, PPS, timestamp, UART 3, encoder A"),
                ("4", "GPIO, PPS, timestamp, UART 3, encoder B"),
            ),
        ),
    },
    readings={
        "base.comm_speed.port": types.CommInterface,
        "base.built_in_test_response.result": types.Cv7BuiltInTest,
        "base.continuous_built_in_test_response.result": types.Cv7InertialContinuousBuiltInTest,
        "base.comm_speed_response.port": types.CommInterface,
        "filter_data.status.filter_state": filter_data.Cv7FilterState,
        "filter_data.status.dynamics_mode": filter_data.Cv7DynamicsMode,
        "filter_data.status.status_flags": filter_data.Cv7StatusFlags,
        "system_data.built_in_test.result": types.Cv7InertialContinuousBuiltInTest,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=(),
    generation=7,
    manual=None,
)
"""Inertial navigation system. Generation 7. Model number 6702. No manual is known. This profile is
incomplete: No manual is known. Uncertain: Only MSCL knows it; the SDK does not.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

DH3 = Device(
    id="3dm-dh3",
    title="3DM-DH3",
    description="Device of generation 3.",
    model_number=6219,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: MIP node features).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x11),  # 3dm.data_stream_control
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={},
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=(),
    generation=3,
    manual=None,
)
"""Device of generation 3. Generation 3. Model number 6219. No manual is known. This profile is
incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

GQ4_45 = Device(
    id="3dm-gq4-45",
    title="3DM-GQ4-45",
    description="Tactical grade inertial navigation system with GNSS.",
    model_number=6250,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it.",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x02),  # 3dm.poll_gnss_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x07),  # 3dm.get_gnss_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x09),  # 3dm.gnss_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x20),  # 3dm.raw_rtcm_2_3_message
                    (0x0C, 0x21),  # 3dm.constellation_settings
                    (0x0C, 0x22),  # 3dm.gnss_sbas_settings
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-RQ1-45-LT and 3DM-GX4-45.",
            frozenset(
                {
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x10),  # filter.vehicle_dynamics_mode
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x12),  # filter.sensor_to_vehicle_offset
                    (0x0D, 0x13),  # filter.antenna_offset
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x15),  # filter.gnss_source
                    (0x0D, 0x16),  # filter.external_gnss_update
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x18),  # filter.heading_source
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1C),  # filter.accel_bias_model
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1E),  # filter.auto_zupt
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x22),  # filter.commanded_zupt
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x42),  # filter.mag_noise
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x45),  # filter.mag_magnitude_error_adaptive_measurement
                    (0x0D, 0x46),  # filter.mag_dip_angle_error_adaptive_measurement
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x81, 0x03),  # gnss_data.llh_position
                    (0x81, 0x05),  # gnss_data.ned_velocity
                    (0x81, 0x09),  # gnss_data.gps_time
                    (0x82, 0x01),  # filter_data.llh_position
                    (0x82, 0x02),  # filter_data.ned_velocity
                    (0x82, 0x05),  # filter_data.euler_angles
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "direct_mode": Note(
            "Direct modes",
            "`system.comm_mode` connects the port to the inner inertial sensor or to the receiver. The inner sensor of the GX4 has the model number 6237, that of the RQ1 6238.",
            (),
        ),
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_gq4_45_response`.",
            (),
        ),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
    },
    ack_codes=frozenset([]),
    incomplete=(
        "The table of contents of the manual is known up to the commands of the set `3dm`. The sets `filter` and `system` follow.",
        "It has the data sets 0x80, 0x81 and 0x82, none of whose fields is known.",
    ),
    also=(),
    generation=4,
    manual="3dm-gq4-45",
)
"""Tactical grade inertial navigation system with GNSS. Generation 4. Model number 6250. Manual:
LORD 3DM-GQ4-45 Data Communications Protocol, of September 26, 2015, known from its table of
contents. This profile is incomplete: The table of contents of the manual is known up to the
commands of the set `3dm`. The sets `filter` and `system` follow. This profile is incomplete: It has
the data sets 0x80, 0x81 and 0x82, none of whose fields is known. Uncertain: It may accept raw RTCM
by a command whose layout is not known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

GQ7 = Device(
    id="3dm-gq7",
    title="3DM-GQ7-GNSS/INS",
    description="Inertial navigation system with two GNSS receivers.",
    model_number=6284,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (MicroStrain 3DM-GQ7 Documentation: Field pages, linked by the ROS messages).",
            frozenset(
                {
                    (0x01, 0x03),  # base.get_device_info
                    (0x0C, 0x42),  # 3dm.gpio_state
                    (0x80, 0x14),  # sensor.temperature_statistics
                    (0xA0, 0x01),  # system_data.built_in_test
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (MicroStrain 3DM-GQ7 Documentation: Protocol Support and Specifications).",
            frozenset(
                {
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x01, 0x09),  # base.comm_speed
                    (0x0C, 0x0E),  # 3dm.get_base_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x54),  # 3dm.low_pass_filter
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it.",
            frozenset(
                {
                    (0x0C, 0x04),  # 3dm.poll_nmea_data
                    (0x0C, 0x31),  # 3dm.sensor_to_vehicle_transform_euler
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0D, 0x05),  # filter.run
                    (0x0D, 0x15),  # filter.gnss_source
                    (0x0D, 0x1E),  # filter.auto_zupt
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x52),  # filter.initialization_config
                    (0x0D, 0x64),  # filter.gnss_antenna_calibration_control
                    (0x91, 0x03),  # gnss_1.llh_position
                    (0x91, 0x0B),  # gnss_1.fix_info
                    (0x92, 0x0D),  # gnss_2.hardware_status
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (MicroStrain 3DM-GQ7 Documentation: Field pages, linked by the wiki of the ROS driver).",
            frozenset(
                {
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x80, 0x18),  # sensor.overrange_status
                    (0x80, 0x40),  # sensor.odometer
                    (0x82, 0x01),  # filter_data.llh_position
                    (0x82, 0x02),  # filter_data.ned_velocity
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x08),  # filter_data.llh_position_uncertainty
                    (0x82, 0x09),  # filter_data.ned_velocity_uncertainty
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x34),  # filter_data.multi_antenna_offset_correction
                    (0x82, 0x36),  # filter_data.ecef_position_uncertainty
                    (0x82, 0x37),  # filter_data.ecef_velocity_uncertainty
                    (0x82, 0x40),  # filter_data.ecef_position
                    (0x82, 0x41),  # filter_data.ecef_velocity
                    (0x82, 0x42),  # filter_data.ned_relative_position
                    (0x82, 0x43),  # filter_data.gnss_position_aiding_status
                    (0x82, 0x46),  # filter_data.aiding_measurement_summary
                    (0x82, 0x49),  # filter_data.gnss_dual_antenna_status
                    (0x91, 0x04),  # gnss_1.ecef_position
                    (0x91, 0x05),  # gnss_1.ned_velocity
                    (0x91, 0x06),  # gnss_1.ecef_velocity
                    (0x91, 0x12),  # gnss_1.sbas_info
                    (0x91, 0x14),  # gnss_1.rf_error_detection
                    (0x92, 0x03),  # gnss_2.llh_position
                    (0x92, 0x04),  # gnss_2.ecef_position
                    (0x92, 0x05),  # gnss_2.ned_velocity
                    (0x92, 0x06),  # gnss_2.ecef_velocity
                    (0x92, 0x12),  # gnss_2.sbas_info
                    (0x92, 0x14),  # gnss_2.rf_error_detection
                    (0x93, 0x30),  # gnss_corrections.base_station_info
                    (0x93, 0x31),  # gnss_corrections.rtk_corrections_status
                    (0xFF, 0xD3),  # shared.gps_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x0F),  # 3dm.message_format
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x50),  # filter.aiding_measurement_enable
                    (0x0D, 0x54),  # filter.multi_antenna_offset
                    (0x0D, 0x63),  # filter.wheeled_vehicle_constraint_control
                    (0x92, 0x0B),  # gnss_2.fix_info
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (ROS driver of the vendor: Example configurations).",
            frozenset(
                {
                    (0x0C, 0x0C),  # 3dm.nmea_message_format
                    (0x0C, 0x10),  # 3dm.factory_streaming
                    (0x0C, 0x22),  # 3dm.gnss_sbas_settings
                    (0x0C, 0x28),  # 3dm.pps_source_control
                    (0x0C, 0x41),  # 3dm.gpio_config
                    (0x0C, 0x43),  # 3dm.odometer_config
                    (0x0D, 0x53),  # filter.adaptive_filter_options
                    (0x0D, 0x55),  # filter.relative_position_config
                    (0x0D, 0x56),  # filter.reference_point_lever_arm
                    (0x0D, 0x61),  # filter.speed_lever_arm
                    (0x0E, 0x02),  # gnss.signal_config
                    (0x0E, 0x10),  # gnss.rtk_dongle_config
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (PX4: Driver of the vendor's sensors).",
            frozenset(
                {
                    (0x91, 0x07),  # gnss_1.dop
                    (0x91, 0x11),  # gnss_1.gps_leap_seconds
                    (0x92, 0x07),  # gnss_2.dop
                    (0x92, 0x11),  # gnss_2.gps_leap_seconds
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it, 3DM-CV7-GNSS/INS.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x08),  # base.continuous_built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x0D),  # 3dm.poll_data
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x2A),  # 3dm.get_event_support
                    (0x0C, 0x2B),  # 3dm.event_control
                    (0x0C, 0x2C),  # 3dm.get_event_trigger_status
                    (0x0C, 0x2D),  # 3dm.get_event_action_status
                    (0x0C, 0x2E),  # 3dm.event_trigger_config
                    (0x0C, 0x2F),  # 3dm.event_action_config
                    (0x0C, 0x32),  # 3dm.sensor_to_vehicle_transform_quaternion
                    (0x0C, 0x33),  # 3dm.sensor_to_vehicle_transform_dcm
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x52),  # 3dm.sensor_range
                    (0x0C, 0x53),  # 3dm.get_calibrated_sensor_ranges
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1C),  # filter.accel_bias_model
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0E, 0x01),  # gnss.receiver_info
                    (0x13, 0x01),  # aiding.frame_config
                    (0x13, 0x1F),  # aiding.echo_control
                    (0x13, 0x31),  # aiding.true_heading
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x07),  # filter_data.accel_bias
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0C),  # filter_data.accel_bias_uncertainty
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x15),  # filter_data.magnetic_model
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0x82, 0x35),  # filter_data.multi_antenna_offset_correction_uncertainty
                    (0x82, 0x47),  # filter_data.odometer_scale_factor_error
                    (0x82, 0x48),  # filter_data.odometer_scale_factor_error_uncertainty
                    (0x91, 0x08),  # gnss_1.utc_time
                    (0x91, 0x09),  # gnss_1.gps_time
                    (0x91, 0x0D),  # gnss_1.hardware_status
                    (0x91, 0x10),  # gnss_1.clock_info_2
                    (0x91, 0x20),  # gnss_1.satellite_status
                    (0x91, 0x22),  # gnss_1.raw
                    (0x91, 0x61),  # gnss_1.gps_ephemeris
                    (0x91, 0x62),  # gnss_1.glonass_ephemeris
                    (0x91, 0x63),  # gnss_1.galileo_ephemeris
                    (0x91, 0x64),  # gnss_1.beidou_ephemeris
                    (0x92, 0x08),  # gnss_2.utc_time
                    (0x92, 0x09),  # gnss_2.gps_time
                    (0x92, 0x10),  # gnss_2.clock_info_2
                    (0x92, 0x20),  # gnss_2.satellite_status
                    (0x92, 0x22),  # gnss_2.raw
                    (0x92, 0x61),  # gnss_2.gps_ephemeris
                    (0x92, 0x62),  # gnss_2.glonass_ephemeris
                    (0x92, 0x63),  # gnss_2.galileo_ephemeris
                    (0x92, 0x64),  # gnss_2.beidou_ephemeris
                    (0xA0, 0x02),  # system_data.time_sync_status
                    (0xA0, 0x03),  # system_data.gpio_state
                    (0xFF, 0xD0),  # shared.event_source
                    (0xFF, 0xD4),  # shared.delta_time
                    (0xFF, 0xD5),  # shared.reference_timestamp
                    (0xFF, 0xD6),  # shared.reference_time_delta
                    (0xFF, 0xD7),  # shared.external_timestamp
                    (0xFF, 0xD8),  # shared.external_time_delta
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={0x80: 1000, 0x82: 1000, 0xA0: 1000, 0x91: 2, 0x92: 2, 0x93: 0},
    ports=(
        Port("Main", 1, (115200, 230400, 460800, 921600), ("MIP", "NMEA"), ("MIP", "NMEA")),
        Port("Aux", 2, (), ("MIP",), ("MIP",)),
    ),
    limits={"nmea_rate": Limit(10, "Hz", "Highest rate of an NMEA sentence, according to MSCL.")},
    notes={
        "anti_aliasing": Note(
            "Anti-aliasing low-pass filter",
            "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.",
            (
                ("Set", "Descriptor", "Data"),
                ("0x80", "0x04", "Scaled accel"),
                ("0x80", "0x05", "Scaled gyro"),
                ("0x80", "0x06", "Scaled mag"),
                ("0x80", "0x17", "Scaled pressure"),
                ("0x82", "0x1C", "Compensated acceleration"),
                ("0x82", "0x0E", "Compensated angular rate"),
                ("0x82", "0x0D", "Linear acceleration"),
            ),
        ),
        "firmware": Note(
            "Firmware", "NMEA on the main port requires firmware later than 1.0.10.", ()
        ),
        "gpio_pins": Note(
            "GPIO pins",
            "Features of each pin, according to MSCL.",
            (
                ("Pin", "Connector pin", "Features"),
                ("1", "primary 7", "GPIO, PPS, encoder A"),
                ("2", "primary 9", "GPIO, encoder B"),
                ("3", "auxiliary 7", "GPIO, PPS"),
                ("4", "auxiliary 9", "GPIO"),
            ),
        ),
        "nmea_output": Note(
            "NMEA output",
            "Sentences are GGA, GLL, GSV, RMC, VTG, HDT, ZDA, and the proprietary PMSRA and PMSRR.",
            (),
        ),
        "gnss_signals": Note(
            "GNSS signals",
            "Signals that can be enabled together by `gnss.signal_config`, according to MSCL.",
            (
                ("Constellation", "Choices"),
                ("GPS", "none, L1 C/A + L2C"),
                ("GLONASS", "none, L1 + L2"),
                ("Galileo", "none, E1 + E5b"),
                ("BeiDou", "none, B1 + B2"),
            ),
        ),
        "receivers": Note(
            "GNSS sets",
            "The set 0x91 is of the first receiver, 0x92 of the second, 0x93 has the RTK corrections.",
            (),
        ),
    },
    readings={
        "base.built_in_test_response.result": types.Cv7BuiltInTest,
        "base.continuous_built_in_test_response.result": types.Cv7InertialContinuousBuiltInTest,
        "filter_data.status.filter_state": filter_data.Cv7FilterState,
        "filter_data.status.dynamics_mode": filter_data.Cv7DynamicsMode,
        "filter_data.status.status_flags": filter_data.Cv7StatusFlags,
        "system_data.built_in_test.result": types.Cv7InertialContinuousBuiltInTest,
    },
    ack_codes=frozenset([]),
    incomplete=(
        "Only some pages of the manual are known, so it has more commands and data.",
        "The baud rates of the Aux port are not known, nor all of its protocols.",
    ),
    also=("3DM-GQ7",),
    generation=7,
    manual="3dm-gq7",
)
"""Inertial navigation system with two GNSS receivers. Also called 3DM-GQ7. Generation 7. Model
number 6284. Manual: MicroStrain 3DM-GQ7 Documentation, online, known from some pages. This profile
is incomplete: Only some pages of the manual are known, so it has more commands and data. This
profile is incomplete: The baud rates of the Aux port are not known, nor all of its protocols.
Uncertain: The values of `filter.MagneticDeclinationSource` are those that MSCL offers. Uncertain:
According to MSCL, firmware from 1.0 to below 1.1 has only the values `all_internal` and `external`
of `filter.GnssSource`.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

GV7_AHRS = Device(
    id="3dm-gv7-ahrs",
    title="3DM-GV7-AHRS",
    description="Attitude and heading reference system.",
    model_number=6288,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x0E),  # 3dm.get_base_rate
                    (0x0C, 0x0F),  # 3dm.message_format
                    (0x0C, 0x2B),  # 3dm.event_control
                    (0x0C, 0x2E),  # 3dm.event_trigger_config
                    (0x0C, 0x2F),  # 3dm.event_action_config
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x31),  # 3dm.sensor_to_vehicle_transform_euler
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x50),  # filter.aiding_measurement_enable
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x10),  # filter_data.status
                    (0xFF, 0xD0),  # shared.event_source
                    (0xFF, 0xD3),  # shared.gps_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (ROS driver of the vendor: Example configurations).",
            frozenset(
                {
                    (0x0C, 0x28),  # 3dm.pps_source_control
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x53),  # filter.adaptive_filter_options
                    (0xA0, 0x02),  # system_data.time_sync_status
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: MIP node features).",
            frozenset(
                {
                    (0x0C, 0x41)  # 3dm.gpio_config
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: Fields of event thresholds).",
            frozenset(
                {
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0xA0, 0x03),  # system_data.gpio_state
                    (0xFF, 0xD5),  # shared.reference_timestamp
                    (0xFF, 0xD7),  # shared.external_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x07),  # base.get_extended_descriptors
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it, 3DM-CV7-GNSS/INS.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x08),  # base.continuous_built_in_test
                    (0x01, 0x09),  # base.comm_speed
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x0D),  # 3dm.poll_data
                    (0x0C, 0x10),  # 3dm.factory_streaming
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x2A),  # 3dm.get_event_support
                    (0x0C, 0x2C),  # 3dm.get_event_trigger_status
                    (0x0C, 0x2D),  # 3dm.get_event_action_status
                    (0x0C, 0x32),  # 3dm.sensor_to_vehicle_transform_quaternion
                    (0x0C, 0x33),  # 3dm.sensor_to_vehicle_transform_dcm
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x42),  # 3dm.gpio_state
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x52),  # 3dm.sensor_range
                    (0x0C, 0x53),  # 3dm.get_calibrated_sensor_ranges
                    (0x0C, 0x54),  # 3dm.low_pass_filter
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x13, 0x01),  # aiding.frame_config
                    (0x13, 0x1F),  # aiding.echo_control
                    (0x13, 0x31),  # aiding.true_heading
                    (0x13, 0x32),  # aiding.magnetic_field
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x14),  # sensor.temperature_statistics
                    (0x80, 0x18),  # sensor.overrange_status
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0xA0, 0x01),  # system_data.built_in_test
                    (0xFF, 0xD4),  # shared.delta_time
                    (0xFF, 0xD6),  # shared.reference_time_delta
                    (0xFF, 0xD8),  # shared.external_time_delta
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(
        Port("Main", 1, (), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(
            4, None, "Frames that the aiding frame configuration can define, according to MSCL."
        )
    },
    notes={
        "anti_aliasing": Note(
            "Anti-aliasing low-pass filter",
            "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.",
            (
                ("Set", "Descriptor", "Data"),
                ("0x80", "0x04", "Scaled accel"),
                ("0x80", "0x05", "Scaled gyro"),
                ("0x80", "0x06", "Scaled mag"),
                ("0x80", "0x17", "Scaled pressure"),
                ("0x82", "0x1C", "Compensated acceleration"),
                ("0x82", "0x0E", "Compensated angular rate"),
                ("0x82", "0x0D", "Linear acceleration"),
            ),
        ),
        "ports": Note(
            "Ports",
            "The main port is an alias of USB 1 if that is connected, or else of UART 1.",
            (),
        ),
        "gpio_pins": Note(
            "GPIO pins",
            "Features of each pin, according to MSCL.",
            (("Pin", "Features"), ("1", "GPIO, PPS, timestamp"), ("2", "GPIO, PPS, timestamp")),
        ),
    },
    readings={
        "base.comm_speed.port": types.CommInterface,
        "base.built_in_test_response.result": types.Cv7BuiltInTest,
        "base.continuous_built_in_test_response.result": types.Cv7InertialContinuousBuiltInTest,
        "base.comm_speed_response.port": types.CommInterface,
        "filter_data.status.filter_state": filter_data.Cv7FilterState,
        "filter_data.status.dynamics_mode": filter_data.Cv7DynamicsMode,
        "filter_data.status.status_flags": filter_data.Cv7StatusFlags,
        "system_data.built_in_test.result": types.Cv7InertialContinuousBuiltInTest,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=(),
    generation=7,
    manual=None,
)
"""Attitude and heading reference system. Generation 7. Model number 6288. No manual is known. This
profile is incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

GV7_AR = Device(
    id="3dm-gv7-ar",
    title="3DM-GV7-AR",
    description="Attitude reference.",
    model_number=6289,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x0E),  # 3dm.get_base_rate
                    (0x0C, 0x0F),  # 3dm.message_format
                    (0x0C, 0x2B),  # 3dm.event_control
                    (0x0C, 0x2E),  # 3dm.event_trigger_config
                    (0x0C, 0x2F),  # 3dm.event_action_config
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x31),  # 3dm.sensor_to_vehicle_transform_euler
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0D, 0x01),  # filter.reset
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x10),  # filter_data.status
                    (0xFF, 0xD0),  # shared.event_source
                    (0xFF, 0xD3),  # shared.gps_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (ROS driver of the vendor: Example configurations).",
            frozenset(
                {
                    (0x0C, 0x28),  # 3dm.pps_source_control
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x50),  # filter.aiding_measurement_enable
                    (0x0D, 0x53),  # filter.adaptive_filter_options
                    (0xA0, 0x02),  # system_data.time_sync_status
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: MIP node features).",
            frozenset(
                {
                    (0x0C, 0x41)  # 3dm.gpio_config
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: Fields of event thresholds).",
            frozenset(
                {
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0xA0, 0x03),  # system_data.gpio_state
                    (0xFF, 0xD5),  # shared.reference_timestamp
                    (0xFF, 0xD7),  # shared.external_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x07),  # base.get_extended_descriptors
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it, 3DM-CV7-GNSS/INS.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x08),  # base.continuous_built_in_test
                    (0x01, 0x09),  # base.comm_speed
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x0D),  # 3dm.poll_data
                    (0x0C, 0x10),  # 3dm.factory_streaming
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x2A),  # 3dm.get_event_support
                    (0x0C, 0x2C),  # 3dm.get_event_trigger_status
                    (0x0C, 0x2D),  # 3dm.get_event_action_status
                    (0x0C, 0x32),  # 3dm.sensor_to_vehicle_transform_quaternion
                    (0x0C, 0x33),  # 3dm.sensor_to_vehicle_transform_dcm
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x42),  # 3dm.gpio_state
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x52),  # 3dm.sensor_range
                    (0x0C, 0x53),  # 3dm.get_calibrated_sensor_ranges
                    (0x0C, 0x54),  # 3dm.low_pass_filter
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x13, 0x01),  # aiding.frame_config
                    (0x13, 0x1F),  # aiding.echo_control
                    (0x13, 0x31),  # aiding.true_heading
                    (0x13, 0x32),  # aiding.magnetic_field
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x14),  # sensor.temperature_statistics
                    (0x80, 0x18),  # sensor.overrange_status
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0xA0, 0x01),  # system_data.built_in_test
                    (0xFF, 0xD4),  # shared.delta_time
                    (0xFF, 0xD6),  # shared.reference_time_delta
                    (0xFF, 0xD8),  # shared.external_time_delta
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(
        Port("Main", 1, (), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(
            4, None, "Frames that the aiding frame configuration can define, according to MSCL."
        )
    },
    notes={
        "anti_aliasing": Note(
            "Anti-aliasing low-pass filter",
            "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.",
            (
                ("Set", "Descriptor", "Data"),
                ("0x80", "0x04", "Scaled accel"),
                ("0x80", "0x05", "Scaled gyro"),
                ("0x80", "0x06", "Scaled mag"),
                ("0x80", "0x17", "Scaled pressure"),
                ("0x82", "0x1C", "Compensated acceleration"),
                ("0x82", "0x0E", "Compensated angular rate"),
                ("0x82", "0x0D", "Linear acceleration"),
            ),
        ),
        "ports": Note(
            "Ports",
            "The main port is an alias of USB 1 if that is connected, or else of UART 1.",
            (),
        ),
        "gpio_pins": Note(
            "GPIO pins",
            "Features of each pin, according to MSCL.",
            (("Pin", "Features"), ("1", "GPIO, PPS, timestamp"), ("2", "GPIO, PPS, timestamp")),
        ),
    },
    readings={
        "base.comm_speed.port": types.CommInterface,
        "base.built_in_test_response.result": types.Cv7BuiltInTest,
        "base.continuous_built_in_test_response.result": types.Cv7InertialContinuousBuiltInTest,
        "base.comm_speed_response.port": types.CommInterface,
        "filter_data.status.filter_state": filter_data.Cv7FilterState,
        "filter_data.status.dynamics_mode": filter_data.Cv7DynamicsMode,
        "filter_data.status.status_flags": filter_data.Cv7StatusFlags,
        "system_data.built_in_test.result": types.Cv7InertialContinuousBuiltInTest,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=(),
    generation=7,
    manual=None,
)
"""Attitude reference. Generation 7. Model number 6289. No manual is known. This profile is
incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

GV7_INS = Device(
    id="3dm-gv7-ins",
    title="3DM-GV7-INS",
    description="Inertial navigation system.",
    model_number=6290,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x0E),  # 3dm.get_base_rate
                    (0x0C, 0x0F),  # 3dm.message_format
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x50),  # filter.aiding_measurement_enable
                    (0x0D, 0x52),  # filter.initialization_config
                    (0x13, 0x01),  # aiding.frame_config
                    (0x13, 0x22),  # aiding.llh_position
                    (0x13, 0x29),  # aiding.ned_velocity
                    (0x13, 0x2A),  # aiding.body_frame_velocity
                    (0x13, 0x31),  # aiding.true_heading
                    (0x82, 0x01),  # filter_data.llh_position
                    (0x82, 0x02),  # filter_data.ned_velocity
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x10),  # filter_data.status
                    (0xFF, 0xD3),  # shared.gps_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (ROS driver of the vendor: Example configurations).",
            frozenset(
                {
                    (0x01, 0x09),  # base.comm_speed
                    (0x0C, 0x28),  # 3dm.pps_source_control
                    (0x0C, 0x41),  # 3dm.gpio_config
                    (0x0C, 0x42),  # 3dm.gpio_state
                    (0x0D, 0x13),  # filter.antenna_offset
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x55),  # filter.relative_position_config
                    (0x82, 0x36),  # filter_data.ecef_position_uncertainty
                    (0x82, 0x40),  # filter_data.ecef_position
                    (0x82, 0x42),  # filter_data.ned_relative_position
                    (0x82, 0x46),  # filter_data.aiding_measurement_summary
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: MIP node features).",
            frozenset(
                {
                    (0x0D, 0x53)  # filter.adaptive_filter_options
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: Fields of event thresholds).",
            frozenset(
                {
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x07),  # filter_data.accel_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0C),  # filter_data.accel_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0xA0, 0x02),  # system_data.time_sync_status
                    (0xA0, 0x03),  # system_data.gpio_state
                    (0xFF, 0xD5),  # shared.reference_timestamp
                    (0xFF, 0xD7),  # shared.external_timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x07),  # base.get_extended_descriptors
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it, 3DM-CV7-GNSS/INS.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x08),  # base.continuous_built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x04),  # 3dm.poll_nmea_data
                    (0x0C, 0x0C),  # 3dm.nmea_message_format
                    (0x0C, 0x0D),  # 3dm.poll_data
                    (0x0C, 0x10),  # 3dm.factory_streaming
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x2A),  # 3dm.get_event_support
                    (0x0C, 0x2B),  # 3dm.event_control
                    (0x0C, 0x2C),  # 3dm.get_event_trigger_status
                    (0x0C, 0x2D),  # 3dm.get_event_action_status
                    (0x0C, 0x2E),  # 3dm.event_trigger_config
                    (0x0C, 0x2F),  # 3dm.event_action_config
                    (0x0C, 0x31),  # 3dm.sensor_to_vehicle_transform_euler
                    (0x0C, 0x32),  # 3dm.sensor_to_vehicle_transform_quaternion
                    (0x0C, 0x33),  # 3dm.sensor_to_vehicle_transform_dcm
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x52),  # 3dm.sensor_range
                    (0x0C, 0x53),  # 3dm.get_calibrated_sensor_ranges
                    (0x0C, 0x54),  # 3dm.low_pass_filter
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x05),  # filter.run
                    (0x0D, 0x15),  # filter.gnss_source
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1C),  # filter.accel_bias_model
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0D, 0x56),  # filter.reference_point_lever_arm
                    (0x13, 0x1F),  # aiding.echo_control
                    (0x13, 0x21),  # aiding.ecef_position
                    (0x13, 0x23),  # aiding.height_above_ellipsoid
                    (0x13, 0x28),  # aiding.ecef_velocity
                    (0x13, 0x32),  # aiding.magnetic_field
                    (0x13, 0x33),  # aiding.pressure
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x14),  # sensor.temperature_statistics
                    (0x80, 0x18),  # sensor.overrange_status
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x08),  # filter_data.llh_position_uncertainty
                    (0x82, 0x09),  # filter_data.ned_velocity_uncertainty
                    (0x82, 0x15),  # filter_data.magnetic_model
                    (0x82, 0x37),  # filter_data.ecef_velocity_uncertainty
                    (0x82, 0x41),  # filter_data.ecef_velocity
                    (0x82, 0x43),  # filter_data.gnss_position_aiding_status
                    (0x82, 0x50),  # filter_data.aiding_frame_config_error
                    (0x82, 0x51),  # filter_data.aiding_frame_config_error_uncertainty
                    (0x94, 0x03),  # gnss_external.llh_position
                    (0x94, 0x05),  # gnss_external.ned_velocity
                    (0x94, 0x08),  # gnss_external.utc_time
                    (0x94, 0x0B),  # gnss_external.fix_info
                    (0x94, 0x20),  # gnss_external.satellite_status
                    (0xA0, 0x01),  # system_data.built_in_test
                    (0xFF, 0xD0),  # shared.event_source
                    (0xFF, 0xD4),  # shared.delta_time
                    (0xFF, 0xD6),  # shared.reference_time_delta
                    (0xFF, 0xD8),  # shared.external_time_delta
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(
        Port("Main", 1, (), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (), ("MIP",), ("MIP",)),
        Port("UART 2", 18, (), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(
            4, None, "Frames that the aiding frame configuration can define, according to MSCL."
        )
    },
    notes={
        "anti_aliasing": Note(
            "Anti-aliasing low-pass filter",
            "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.",
            (
                ("Set", "Descriptor", "Data"),
                ("0x80", "0x04", "Scaled accel"),
                ("0x80", "0x05", "Scaled gyro"),
                ("0x80", "0x06", "Scaled mag"),
                ("0x80", "0x17", "Scaled pressure"),
                ("0x82", "0x1C", "Compensated acceleration"),
                ("0x82", "0x0E", "Compensated angular rate"),
                ("0x82", "0x0D", "Linear acceleration"),
            ),
        ),
        "ports": Note(
            "Ports",
            "The main port is an alias of USB 1 if that is connected, or else of UART 1. UART 2 is on the pins GPIO 1 and 2.",
            (),
        ),
        "gpio_pins": Note(
            "GPIO pins",
            "Features of each pin, according to MSCL.",
            (
                ("Pin", "Features"),
                ("1", "GPIO, PPS, timestamp, UART 2"),
                ("2", "GPIO, PPS, timestamp, UART 2"),
            ),
        ),
    },
    readings={
        "base.comm_speed.port": types.CommInterface,
        "base.built_in_test_response.result": types.Cv7BuiltInTest,
        "base.continuous_built_in_test_response.result": types.Cv7InertialContinuousBuiltInTest,
        "base.comm_speed_response.port": types.CommInterface,
        "filter_data.status.filter_state": filter_data.Cv7FilterState,
        "filter_data.status.dynamics_mode": filter_data.Cv7DynamicsMode,
        "filter_data.status.status_flags": filter_data.Cv7StatusFlags,
        "system_data.built_in_test.result": types.Cv7InertialContinuousBuiltInTest,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=(),
    generation=7,
    manual=None,
)
"""Inertial navigation system. Generation 7. Model number 6290. No manual is known. This profile is
incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

GX3_15 = Device(
    id="3dm-gx3-15",
    title="3DM-GX3-15",
    description="Inertial sensor of generation 3.",
    model_number=6227,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: MIP node features).",
            frozenset(
                {
                    (0x0C, 0x35)  # 3dm.imu_signal_conditioning
                }
            ),
            ((12, 60),),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX3-35.",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x36),  # 3dm.imu_timestamp
                    (0x0C, 0x61),  # 3dm.device_power_state
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={},
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
    },
    ack_codes=frozenset([]),
    incomplete=(
        "Its manual (8500-0024, revision 002 of 2012, for firmware 2.0.00 and later) is not known.",
    ),
    also=(),
    generation=3,
    manual=None,
)
"""Inertial sensor of generation 3. Generation 3. Model number 6227. No manual is known. This
profile is incomplete: Its manual (8500-0024, revision 002 of 2012, for firmware 2.0.00 and later)
is not known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

GX3_25 = Device(
    id="3dm-gx3-25",
    title="3DM-GX3-25",
    description="Inertial sensor of generation 3.",
    model_number=6223,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: MIP node features).",
            frozenset(
                {
                    (0x0C, 0x35)  # 3dm.imu_signal_conditioning
                }
            ),
            ((12, 60), (12, 61)),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MIP SDK of 2014: Examples, one for each model).",
            frozenset(
                {
                    (0x0C, 0x61)  # 3dm.device_power_state
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX3-35.",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x36),  # 3dm.imu_timestamp
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                }
            ),
            (),
        ),
        Evidence(
            Support.NO,
            "refused",
            "The device refuses it (ROS driver of the vendor: Issue 347).",
            frozenset(
                {
                    (0x0C, 0x0C),  # 3dm.nmea_message_format
                    (0x0C, 0x22),  # 3dm.gnss_sbas_settings
                    (0x0C, 0x43),  # 3dm.odometer_config
                    (0x0D, 0x10),  # filter.vehicle_dynamics_mode
                    (0x0D, 0x13),  # filter.antenna_offset
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x54),  # filter.multi_antenna_offset
                    (0x0E, 0x02),  # gnss.signal_config
                    (0x0E, 0x10),  # gnss.rtk_dongle_config
                    (0x82, 0x01),  # filter_data.llh_position
                    (0x82, 0x02),  # filter_data.ned_velocity
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x08),  # filter_data.llh_position_uncertainty
                    (0x82, 0x09),  # filter_data.ned_velocity_uncertainty
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x36),  # filter_data.ecef_position_uncertainty
                    (0x82, 0x37),  # filter_data.ecef_velocity_uncertainty
                    (0x82, 0x40),  # filter_data.ecef_position
                    (0x82, 0x41),  # filter_data.ecef_velocity
                }
            ),
            (),
        ),
        Evidence(
            Support.NO,
            "refused",
            "The device refuses it (firmware 2.0.06; ROS driver of the vendor: Issue 213).",
            frozenset(
                {
                    (0x81, 0x03),  # gnss_data.llh_position
                    (0x81, 0x05),  # gnss_data.ned_velocity
                    (0x81, 0x0B),  # gnss_data.fix_info
                    (0x82, 0x43),  # filter_data.gnss_position_aiding_status
                    (0x91, 0x03),  # gnss_1.llh_position
                    (0x91, 0x05),  # gnss_1.ned_velocity
                    (0x91, 0x0B),  # gnss_1.fix_info
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={},
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
    },
    ack_codes=frozenset([]),
    incomplete=(
        "Its manual (8500-0024, revision 002 of 2012, for firmware 2.0.00 and later) is not known.",
    ),
    also=(),
    generation=3,
    manual=None,
)
"""Inertial sensor of generation 3. Generation 3. Model number 6223. No manual is known. This
profile is incomplete: Its manual (8500-0024, revision 002 of 2012, for firmware 2.0.00 and later)
is not known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

GX3_35 = Device(
    id="3dm-gx3-35",
    title="3DM-GX3-35",
    description="Inertial sensor of generation 3.",
    model_number=6225,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MIP SDK of 2014: Examples, one for each model).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x02),  # 3dm.poll_gnss_data
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x07),  # 3dm.get_gnss_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x09),  # 3dm.gnss_message_format
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x34),  # 3dm.gps_dynamics_mode
                    (0x0C, 0x35),  # 3dm.imu_signal_conditioning
                    (0x0C, 0x36),  # 3dm.imu_timestamp
                    (0x0C, 0x60),  # 3dm.data_stream_format
                    (0x0C, 0x61),  # 3dm.device_power_state
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x81, 0x03),  # gnss_data.llh_position
                    (0x81, 0x05),  # gnss_data.ned_velocity
                    (0x81, 0x09),  # gnss_data.gps_time
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MIP SDK of 2014: Examples, one for each model).",
            frozenset(
                {
                    (0x0C, 0x62)  # 3dm.gps_advanced_settings
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={"receiver": Note("Receiver", "The GNSS receiver is of u-blox.", ())},
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
    },
    ack_codes=frozenset([]),
    incomplete=("Its manual (1.00 of 2011-01-04) is not known.",),
    also=(),
    generation=3,
    manual=None,
)
"""Inertial sensor of generation 3. Generation 3. Model number 6225. No manual is known. This
profile is incomplete: Its manual (1.00 of 2011-01-04) is not known.

- mip-sdk-4: Device models
- mscl: MIP node features
- mip-sdk-2014: Example of the 3DM-GX3-35
"""

GX3_45 = Device(
    id="3dm-gx3-45",
    title="3DM-GX3-45",
    description="Inertial sensor of generation 3.",
    model_number=6228,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MIP SDK of 2014: Examples, one for each model).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x05),  # base.built_in_test
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x07),  # 3dm.get_gnss_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x09),  # 3dm.gnss_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x04),  # filter.set_initial_attitude_from_imu
                    (0x0D, 0x10),  # filter.vehicle_dynamics_mode
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x12),  # filter.sensor_to_vehicle_offset
                    (0x0D, 0x13),  # filter.antenna_offset
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x15),  # filter.gnss_source
                    (0x0D, 0x18),  # filter.heading_source
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x81, 0x03),  # gnss_data.llh_position
                    (0x81, 0x05),  # gnss_data.ned_velocity
                    (0x81, 0x09),  # gnss_data.gps_time
                    (0x82, 0x01),  # filter_data.llh_position
                    (0x82, 0x02),  # filter_data.ned_velocity
                    (0x82, 0x05),  # filter_data.euler_angles
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: MIP node features).",
            frozenset(
                {
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x45),  # filter.mag_magnitude_error_adaptive_measurement
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX3-35.",
            frozenset(
                {
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x02),  # 3dm.poll_gnss_data
                    (0x0C, 0x35),  # 3dm.imu_signal_conditioning
                    (0x0C, 0x36),  # 3dm.imu_timestamp
                    (0x0C, 0x64),  # 3dm.device_status
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={},
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=(),
    generation=3,
    manual=None,
)
"""Inertial sensor of generation 3. Generation 3. Model number 6228. No manual is known. This
profile is incomplete: No manual is known. Uncertain: The SDK of 2014 has the model number 6226.

- mip-sdk-4: Device models
- mscl: MIP node features
- mip-sdk-2014: Example of the 3DM-GX3-45
"""

GX4_15 = Device(
    id="3dm-gx4-15",
    title="3DM-GX4-15",
    description="Device of generation 4.",
    model_number=6233,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MIP SDK of 2014: Examples, one for each model).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x05),  # base.built_in_test
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x26),  # filter.reference_position
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x82, 0x05),  # filter_data.euler_angles
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: MIP node features).",
            frozenset(
                {
                    (0x0D, 0x45)  # filter.mag_magnitude_error_adaptive_measurement
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX4-25.",
            frozenset(
                {
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x80, 0x11),  # sensor.up_vector
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x0F),  # filter_data.wgs84_gravity_magnitude
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x11),  # filter_data.timestamp
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "direct_mode": Note(
            "Direct modes",
            "`system.comm_mode` connects the port to the inner inertial sensor or to the receiver. The inner sensor of the GX4 has the model number 6237, that of the RQ1 6238.",
            (),
        ),
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_without_state_response` and `3dm.device_status_diagnostic_gx4_response`.",
            (),
        ),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=(),
    generation=4,
    manual=None,
)
"""Device of generation 4. Generation 4. Model number 6233. No manual is known. This profile is
incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

GX4_25 = Device(
    id="3dm-gx4-25",
    title="3DM-GX4-25",
    description="Device of generation 4.",
    model_number=6234,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MIP SDK of 2014: Examples, one for each model).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x05),  # base.built_in_test
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x18),  # filter.heading_source
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x26),  # filter.reference_position
                    (0x0D, 0x42),  # filter.mag_noise
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x45),  # filter.mag_magnitude_error_adaptive_measurement
                    (0x0D, 0x46),  # filter.mag_dip_angle_error_adaptive_measurement
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x82, 0x05),  # filter_data.euler_angles
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (Public programs of users: Driver imu_3dm_gx4).",
            frozenset(
                {
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0D, 0x41),  # filter.enable_measurements
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-25.",
            frozenset(
                {
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x80, 0x11),  # sensor.up_vector
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x0F),  # filter_data.wgs84_gravity_magnitude
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x11),  # filter_data.timestamp
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x14),  # filter_data.heading_update_state
                    (0x82, 0x15),  # filter_data.magnetic_model
                }
            ),
            (),
        ),
        Evidence(
            Support.NO,
            "refused",
            "The device refuses it (MicroStrain Communication Library: Issue 30).",
            frozenset(
                {
                    (0x82, 0x07)  # filter_data.accel_bias
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={0x80: 1000, 0x82: 500},
    ports=(),
    limits={},
    notes={
        "direct_mode": Note(
            "Direct modes",
            "`system.comm_mode` connects the port to the inner inertial sensor or to the receiver. The inner sensor of the GX4 has the model number 6237, that of the RQ1 6238.",
            (),
        ),
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_without_state_response` and `3dm.device_status_diagnostic_gx4_response`.",
            (),
        ),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    ack_codes=frozenset([]),
    incomplete=("Its manual (of 2014-12-23) is not known.",),
    also=(),
    generation=4,
    manual=None,
)
"""Device of generation 4. Generation 4. Model number 6234. No manual is known. This profile is
incomplete: Its manual (of 2014-12-23) is not known. Uncertain: A ROS driver by others uses the
model number 6253 for it, which is that of the 3DM-GX5-25.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

GX4_45 = Device(
    id="3dm-gx4-45",
    title="3DM-GX4-45",
    description="Device of generation 4.",
    model_number=6236,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MIP SDK of 2014: Examples, one for each model).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x05),  # base.built_in_test
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x02),  # 3dm.poll_gnss_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x07),  # 3dm.get_gnss_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x09),  # 3dm.gnss_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x10),  # filter.vehicle_dynamics_mode
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x12),  # filter.sensor_to_vehicle_offset
                    (0x0D, 0x13),  # filter.antenna_offset
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x15),  # filter.gnss_source
                    (0x0D, 0x16),  # filter.external_gnss_update
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x18),  # filter.heading_source
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1C),  # filter.accel_bias_model
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1E),  # filter.auto_zupt
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x22),  # filter.commanded_zupt
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x42),  # filter.mag_noise
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x45),  # filter.mag_magnitude_error_adaptive_measurement
                    (0x0D, 0x46),  # filter.mag_dip_angle_error_adaptive_measurement
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x81, 0x03),  # gnss_data.llh_position
                    (0x81, 0x05),  # gnss_data.ned_velocity
                    (0x81, 0x09),  # gnss_data.gps_time
                    (0x82, 0x01),  # filter_data.llh_position
                    (0x82, 0x02),  # filter_data.ned_velocity
                    (0x82, 0x05),  # filter_data.euler_angles
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-25.",
            frozenset(
                {
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x80, 0x11),  # sensor.up_vector
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x0F),  # filter_data.wgs84_gravity_magnitude
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x11),  # filter_data.timestamp
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x14),  # filter_data.heading_update_state
                    (0x82, 0x15),  # filter_data.magnetic_model
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "direct_mode": Note(
            "Direct modes",
            "`system.comm_mode` connects the port to the inner inertial sensor or to the receiver. The inner sensor of the GX4 has the model number 6237, that of the RQ1 6238.",
            (),
        ),
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_gnss_response`.",
            (),
        ),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=(),
    generation=4,
    manual=None,
)
"""Device of generation 4. Generation 4. Model number 6236. No manual is known. This profile is
incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

GX5_10 = Device(
    id="3dm-gx5-10",
    title="3DM-GX5-10",
    description="Inertial measurement unit.",
    model_number=6255,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-15 and 3DM-CX5-10.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x12),  # sensor.gps_timestamp
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_without_state_response` and `3dm.device_status_diagnostic_imu_response`.",
            (),
        )
    },
    readings={
        "base.built_in_test_response.result": types.Gx5BuiltInTest,
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=("3DM-GX5-IMU",),
    generation=5,
    manual=None,
)
"""Inertial measurement unit. Also called 3DM-GX5-IMU. Generation 5. Model number 6255. No manual is
known. This profile is incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

GX5_15 = Device(
    id="3dm-gx5-15",
    title="3DM-GX5-15",
    description="Vertical reference unit with an inertial sensor, a pressure sensor and an estimation filter.",
    model_number=6254,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it.",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x18),  # filter.heading_source
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x26),  # filter.reference_position
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0D, 0x41),  # filter.enable_measurements
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x4B),  # filter.pitch_roll_aiding
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x80, 0x11),  # sensor.up_vector
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x0F),  # filter_data.wgs84_gravity_magnitude
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x11),  # filter_data.timestamp
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x14),  # filter_data.heading_update_state
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x21),  # filter_data.pressure_altitude
                }
            ),
            (),
        ),
        Evidence(
            Support.NO,
            "refused",
            "The device refuses it (MicroStrain Communication Library: Issue 301).",
            frozenset(
                {
                    (0x80, 0x01),  # sensor.raw_accel
                    (0x80, 0x02),  # sensor.raw_gyro
                }
            ),
            (),
        ),
    ),
    functions={(0x0D, 0x21): "WSLD"},
    base_rates={0x80: 1000, 0x82: 500},
    ports=(
        Port("UART 1", None, (9600, 19200, 115200, 230400, 460800, 921600), ("MIP",), ("MIP",)),
        Port("USB", None, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "low_pass_cutoff": Limit(250, "Hz", "Highest cutoff of the low-pass filters."),
        "external_heading_rate": Limit(20, "Hz", "Highest rate of external heading updates."),
        "zero_angular_rate_update_rate": Limit(
            10, "Hz", "Highest rate of commanded zero angular rate updates."
        ),
        "baud_rate_delay": Limit(
            250,
            "ms",
            "Time from the acknowledge of a new baud rate until commands are answered at that rate.",
        ),
    },
    notes={
        "base_rates": Note(
            "Base rates",
            "The manual gives both 1000 and 500 for each stream. Read the base rates from the device before computing a decimation.",
            (),
        ),
        "frames": Note(
            "Frame of the sensor data",
            "`filter.sensor_to_vehicle_rotation_euler` rotates scaled acceleration and angular rate, delta theta and delta velocity, as well as the outputs of the estimation filter other than the gyroscope bias. Until it is set, they are in the sensor frame. It does not rotate the outputs of the complementary filter.",
            (),
        ),
        "low_pass_filter": Note(
            "Low-pass filter",
            "Data that `3dm.imu_low_pass_filter` can select.",
            (
                ("Set", "Descriptor", "Data"),
                ("0x80", "0x04", "Scaled accel"),
                ("0x80", "0x05", "Scaled gyro"),
                ("0x80", "0x17", "Scaled pressure"),
            ),
        ),
        "uart": Note(
            "UART",
            "The default baud rate is 115200. There is no handshake; data that does not fit is dropped.",
            (),
        ),
        "time": Note(
            "Time synchronization",
            "The pulse per second goes to pin 7 of the connector. Send `base.gps_time_update` once per second. The filter timestamp and the sensor timestamp follow it.",
            (),
        ),
        "direct_mode": Note(
            "Direct mode",
            "`system.comm_mode` connects the port to the internal inertial sensor. Meanwhile, only that command and `3dm.device_status` are available.",
            (),
        ),
    },
    readings={
        "base.built_in_test_response.result": types.Gx5BuiltInTest,
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    ack_codes=frozenset([0, 1, 2, 3, 4, 5]),
    incomplete=(),
    also=("3DM-GX5-AR",),
    generation=5,
    manual="3dm-gx5-15",
)
"""Vertical reference unit with an inertial sensor, a pressure sensor and an estimation filter. Also
called 3DM-GX5-AR. Generation 5. Model number 6254. Manual: LORD Sensing 3DM-GX5-15 Data
Communications Protocol, 8500-0067 rev. E.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

GX5_25 = Device(
    id="3dm-gx5-25",
    title="3DM-GX5-25",
    description="Attitude and heading reference system.",
    model_number=6253,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "transcribed",
            "A list by others after its manual has it (Public programs of users: Parser of 3DM-GX5-25 data in MATLAB, 2018).",
            frozenset(
                {
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x80, 0x11),  # sensor.up_vector
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x0F),  # filter_data.wgs84_gravity_magnitude
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x11),  # filter_data.timestamp
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x14),  # filter_data.heading_update_state
                    (0x82, 0x15),  # filter_data.magnetic_model
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0x82, 0x25),  # filter_data.mag_offset
                    (0x82, 0x26),  # filter_data.mag_matrix
                    (0x82, 0x28),  # filter_data.mag_offset_uncertainty
                    (0x82, 0x29),  # filter_data.mag_matrix_uncertainty
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x19),  # filter.auto_initialization_control
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x03),  # base.get_device_info
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x18),  # filter.heading_source
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (ROS driver microstrain_mips: Table of tested functions).",
            frozenset(
                {
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1E),  # filter.auto_zupt
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x26),  # filter.reference_position
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x7F, 0x10),  # system.comm_mode
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (ROS driver microstrain_mips: Conditions by model).",
            frozenset(
                {
                    (0x0D, 0x42),  # filter.mag_noise
                    (0x0D, 0x45),  # filter.mag_magnitude_error_adaptive_measurement
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x07),  # base.get_extended_descriptors
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-15 and 3DM-GX5-45.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x27),  # filter.mag_capture_auto_calibration
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0D, 0x29),  # filter.pressure_altitude_noise
                    (0x0D, 0x2B),  # filter.hard_iron_offset_noise
                    (0x0D, 0x2C),  # filter.soft_iron_matrix_noise
                    (0x0D, 0x41),  # filter.enable_measurements
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x46),  # filter.mag_dip_angle_error_adaptive_measurement
                    (0x0D, 0x47),  # filter.altitude_aiding
                    (0x0D, 0x4B),  # filter.pitch_roll_aiding
                }
            ),
            (),
        ),
        Evidence(
            Support.NO,
            "refused",
            "The device refuses it (ROS driver of the vendor: Issue 238).",
            frozenset(
                {
                    (0x0C, 0x41),  # 3dm.gpio_config
                    (0x81, 0x03),  # gnss_data.llh_position
                    (0x81, 0x0B),  # gnss_data.fix_info
                    (0x82, 0x43),  # filter_data.gnss_position_aiding_status
                    (0x82, 0x49),  # filter_data.gnss_dual_antenna_status
                    (0x91, 0x03),  # gnss_1.llh_position
                    (0x91, 0x0B),  # gnss_1.fix_info
                    (0x93, 0x31),  # gnss_corrections.rtk_corrections_status
                }
            ),
            (),
        ),
        Evidence(
            Support.NO,
            "refused",
            "The device refuses it (firmware 1.1.76; ROS driver of the vendor: Issue 368).",
            frozenset(
                {
                    (0x80, 0x18),  # sensor.overrange_status
                    (0x82, 0x01),  # filter_data.llh_position
                    (0x82, 0x08),  # filter_data.llh_position_uncertainty
                    (0x92, 0x0B),  # gnss_2.fix_info
                    (0x92, 0x12),  # gnss_2.sbas_info
                    (0x92, 0x14),  # gnss_2.rf_error_detection
                }
            ),
            (),
        ),
        Evidence(
            Support.NO,
            "refused",
            "The device refuses it (ROS driver of the vendor: Issue 59; MicroStrain Communication Library: Issue 200).",
            frozenset(
                {
                    (0x82, 0x02)  # filter_data.ned_velocity
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_response`.",
            (),
        )
    },
    readings={
        "base.built_in_test_response.result": types.Gx5BuiltInTest,
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    ack_codes=frozenset([]),
    incomplete=("Its manual (8500-0065) is not known.",),
    also=("3DM-GX5-AHRS",),
    generation=5,
    manual=None,
)
"""Attitude and heading reference system. Also called 3DM-GX5-AHRS. Generation 5. Model number 6253.
No manual is known. This profile is incomplete: Its manual (8500-0065) is not known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

GX5_35 = Device(
    id="3dm-gx5-35",
    title="3DM-GX5-35",
    description="Attitude and heading reference with GNSS.",
    model_number=6252,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it.",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x07),  # base.get_extended_descriptors
                    (0x01, 0x72),  # base.gps_time_update
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x07),  # 3dm.get_gnss_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x09),  # 3dm.gnss_message_format
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x21),  # 3dm.constellation_settings
                    (0x0C, 0x22),  # 3dm.gnss_sbas_settings
                    (0x0C, 0x23),  # 3dm.gnss_assisted_fix
                    (0x0C, 0x24),  # 3dm.gnss_time_assistance
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x11),  # sensor.up_vector
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x81, 0x06),  # gnss_data.ecef_velocity
                    (0x81, 0x0E),  # gnss_data.dgps_info
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-15 and 3DM-GX5-45.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x02),  # 3dm.poll_gnss_data
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x81, 0x03),  # gnss_data.llh_position
                    (0x81, 0x04),  # gnss_data.ecef_position
                    (0x81, 0x05),  # gnss_data.ned_velocity
                    (0x81, 0x07),  # gnss_data.dop
                    (0x81, 0x08),  # gnss_data.utc_time
                    (0x81, 0x09),  # gnss_data.gps_time
                    (0x81, 0x0A),  # gnss_data.clock_info
                    (0x81, 0x0B),  # gnss_data.fix_info
                    (0x81, 0x0C),  # gnss_data.sv_info
                    (0x81, 0x0D),  # gnss_data.hardware_status
                    (0x81, 0x0F),  # gnss_data.dgps_channel
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={0x80: 500, 0x81: 4},
    ports=(),
    limits={
        "reserved_gnss_channels": Limit(
            32, None, "Sum of the channels that constellations reserve."
        )
    },
    notes={
        "receiver": Note(
            "Receiver",
            "The GNSS receiver is a u-blox M8M. GLONASS and BeiDou cannot be used together.",
            (),
        ),
        "streams": Note(
            "Streams",
            "The manual lists the selectors of the sensor and the filter stream, though the device has no filter.",
            (),
        ),
        "device_status": Note(
            "Device status",
            "It answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_gnss_response`.",
            (),
        ),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
    },
    ack_codes=frozenset([]),
    incomplete=("Only some pages of the manual are known, so it has more commands and data.",),
    also=("3DM-GX5-GNSS/AHRS",),
    generation=5,
    manual="3dm-gx5-35",
)
"""Attitude and heading reference with GNSS. Also called 3DM-GX5-GNSS/AHRS. Generation 5. Model
number 6252. Manual: LORD 3DM-GX5-35 DCP Manual, revision unknown, known from some pages. This
profile is incomplete: Only some pages of the manual are known, so it has more commands and data.
Uncertain: The base rates are those that the manual gives for all 3DM-GX5.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

GX5_45 = Device(
    id="3dm-gx5-45",
    title="3DM-GX5-45",
    description="Inertial navigation system with GNSS, magnetometer and pressure sensor.",
    model_number=6251,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it.",
            frozenset(
                {
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x02),  # 3dm.poll_gnss_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x07),  # 3dm.get_gnss_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x09),  # 3dm.gnss_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x20),  # 3dm.raw_rtcm_2_3_message
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x03),  # filter.set_initial_heading
                    (0x0D, 0x10),  # filter.vehicle_dynamics_mode
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x12),  # filter.sensor_to_vehicle_offset
                    (0x0D, 0x13),  # filter.antenna_offset
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x15),  # filter.gnss_source
                    (0x0D, 0x16),  # filter.external_gnss_update
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x18),  # filter.heading_source
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1C),  # filter.accel_bias_model
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1E),  # filter.auto_zupt
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x22),  # filter.commanded_zupt
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x27),  # filter.mag_capture_auto_calibration
                    (0x0D, 0x28),  # filter.gravity_noise
                    (0x0D, 0x29),  # filter.pressure_altitude_noise
                    (0x0D, 0x2B),  # filter.hard_iron_offset_noise
                    (0x0D, 0x2C),  # filter.soft_iron_matrix_noise
                    (0x0D, 0x42),  # filter.mag_noise
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x45),  # filter.mag_magnitude_error_adaptive_measurement
                    (0x0D, 0x46),  # filter.mag_dip_angle_error_adaptive_measurement
                    (0x0D, 0x47),  # filter.altitude_aiding
                    (0x0D, 0x4B),  # filter.pitch_roll_aiding
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x81, 0x0C),  # gnss_data.sv_info
                    (0x81, 0x0D),  # gnss_data.hardware_status
                    (0x81, 0x0E),  # gnss_data.dgps_info
                    (0x81, 0x0F),  # gnss_data.dgps_channel
                    (0x82, 0x04),  # filter_data.attitude_dcm
                    (0x82, 0x05),  # filter_data.euler_angles
                    (0x82, 0x0E),  # filter_data.comp_angular_rate
                    (0x82, 0x14),  # filter_data.heading_update_state
                }
            ),
            (),
        ),
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it (LORD 3DM-GX5-45 DCP Manual: Single pages).",
            frozenset(
                {
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x07),  # base.get_extended_descriptors
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x0D, 0x01),  # filter.reset
                    (0x80, 0x12),  # sensor.gps_timestamp
                    (0x81, 0x0B),  # gnss_data.fix_info
                    (0x82, 0x01),  # filter_data.llh_position
                    (0x82, 0x02),  # filter_data.ned_velocity
                    (0x82, 0x10),  # filter_data.status
                    (0x82, 0x11),  # filter_data.timestamp
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x0C, 0x39)  # 3dm.capture_gyro_bias
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (ROS driver microstrain_mips: Table of tested functions).",
            frozenset(
                {
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x51),  # 3dm.complementary_filter
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x26),  # filter.reference_position
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: MIP node features).",
            frozenset(
                {
                    (0x0D, 0x53)  # filter.adaptive_filter_options
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (ArduPilot: AP_ExternalAHRS_MicroStrain5).",
            frozenset(
                {
                    (0x80, 0x0A),  # sensor.comp_quaternion
                    (0x80, 0x17),  # sensor.scaled_pressure
                    (0x81, 0x03),  # gnss_data.llh_position
                    (0x81, 0x05),  # gnss_data.ned_velocity
                    (0x81, 0x07),  # gnss_data.dop
                    (0x82, 0x03),  # filter_data.attitude_quaternion
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "family",
            "Devices of its generation have it (MicroStrain MIP SDK: Examples).",
            frozenset(
                {
                    (0x01, 0x04)  # base.get_device_descriptors
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-15 and 3DM-GX5-35.",
            frozenset(
                {
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x72),  # base.gps_time_update
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x21),  # 3dm.constellation_settings
                    (0x0C, 0x22),  # 3dm.gnss_sbas_settings
                    (0x0C, 0x23),  # 3dm.gnss_assisted_fix
                    (0x0C, 0x24),  # 3dm.gnss_time_assistance
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x80, 0x07),  # sensor.delta_theta
                    (0x80, 0x08),  # sensor.delta_velocity
                    (0x80, 0x09),  # sensor.comp_orientation_matrix
                    (0x80, 0x0C),  # sensor.comp_euler_angles
                    (0x80, 0x10),  # sensor.north_vector
                    (0x80, 0x11),  # sensor.up_vector
                    (0x81, 0x04),  # gnss_data.ecef_position
                    (0x81, 0x06),  # gnss_data.ecef_velocity
                    (0x81, 0x08),  # gnss_data.utc_time
                    (0x81, 0x09),  # gnss_data.gps_time
                    (0x81, 0x0A),  # gnss_data.clock_info
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-GX5-25 and 3DM-RQ1-45-LT.",
            frozenset(
                {
                    (0x82, 0x06),  # filter_data.gyro_bias
                    (0x82, 0x07),  # filter_data.accel_bias
                    (0x82, 0x08),  # filter_data.llh_position_uncertainty
                    (0x82, 0x09),  # filter_data.ned_velocity_uncertainty
                    (0x82, 0x0A),  # filter_data.euler_angles_uncertainty
                    (0x82, 0x0B),  # filter_data.gyro_bias_uncertainty
                    (0x82, 0x0C),  # filter_data.accel_bias_uncertainty
                    (0x82, 0x0D),  # filter_data.linear_accel
                    (0x82, 0x0F),  # filter_data.wgs84_gravity_magnitude
                    (0x82, 0x12),  # filter_data.quaternion_attitude_uncertainty
                    (0x82, 0x13),  # filter_data.gravity_vector
                    (0x82, 0x15),  # filter_data.magnetic_model
                    (0x82, 0x1C),  # filter_data.comp_accel
                    (0x82, 0x20),  # filter_data.standard_atmosphere
                    (0x82, 0x21),  # filter_data.pressure_altitude
                    (0x82, 0x25),  # filter_data.mag_offset
                    (0x82, 0x26),  # filter_data.mag_matrix
                    (0x82, 0x28),  # filter_data.mag_offset_uncertainty
                    (0x82, 0x29),  # filter_data.mag_matrix_uncertainty
                }
            ),
            (),
        ),
        Evidence(
            Support.NO,
            "refused",
            "The device refuses it (MicroStrain Communication Library: Issue 43).",
            frozenset(
                {
                    (0x80, 0x01)  # sensor.raw_accel
                }
            ),
            (),
        ),
    ),
    functions={(0x0D, 0x21): "WSLD"},
    base_rates={0x80: 500, 0x81: 4, 0x82: 500},
    ports=(
        Port("UART 1", None, (9600, 19200, 115200, 230400, 460800, 921600), ("MIP",), ("MIP",)),
        Port("USB", None, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "baud_rate_delay": Limit(
            250,
            "ms",
            "Time from the acknowledge of a new baud rate until commands are answered at that rate.",
        ),
        "rtcm_chunk": Limit(253, "byte", "Maximum number of RTCM bytes in one field."),
    },
    notes={
        "rtcm": Note(
            "RTCM input",
            "The command with the descriptor 0x20 of the set `3dm` accepts RTCM 2.3; its layout is not known. The receiver uses the messages 1, 2, 3 and 9.",
            (),
        ),
        "functions": Note(
            "Functions that the specification does not define",
            "The manual has a read of `3dm.device_settings`, which is answered with the settings of all commands.",
            (),
        ),
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_gnss_response`.",
            (),
        ),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    ack_codes=frozenset([]),
    incomplete=(
        "Only some pages of the manual are known, so it has more commands and data.",
        "Only four fields of the filter data are listed; the manual has 27 or more.",
    ),
    also=("3DM-GX5-GNSS/INS",),
    generation=5,
    manual="3dm-gx5-45",
)
"""Inertial navigation system with GNSS, magnetometer and pressure sensor. Also called
3DM-GX5-GNSS/INS. Generation 5. Model number 6251. Manual: LORD 3DM-GX5-45 DCP Manual, 8500-0064
rev. C, known from some pages. This profile is incomplete: Only some pages of the manual are known,
so it has more commands and data. This profile is incomplete: Only four fields of the filter data
are listed; the manual has 27 or more. Uncertain: The values of `filter.GnssSource` are those that
MSCL offers. Uncertain: The base rates are those that the manuals of the 3DM-GX5-35 and the
3DM-GX5-45 give for all 3DM-GX5. Uncertain: An example in the manual has a base rate of 100 Hz for
the sensor data. Uncertain: The manual gives the length of
`mip_3dm.DeviceStatusBasicWithoutStateResponse` and offsets of
`mip_3dm.DeviceStatusDiagnosticGx4Response`; MSCL differs.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

MV5_AR = Device(
    id="3dm-mv5-ar",
    title="3DM-MV5-AR",
    description="Device of generation 5.",
    model_number=6243,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: MIP node features).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x06),  # base.resume
                    (0x0C, 0x11),  # 3dm.data_stream_control
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "j1939": Note(
            "J1939",
            "Besides MIP it sends J1939 messages on CAN, from the address 0xE2, according to a driver by others. Angles have 1/32768 deg, rates 1/128 deg/s, accelerations 0.01 m/s^2 for each step.",
            (
                ("Message", "PGN", "Signals", "Offset"),
                ("Slope sensor 2", "0xF029", "pitch (bits 0 to 23), roll (24 to 47)", "-250 deg"),
                (
                    "Angular rate",
                    "0xF02A",
                    "pitch (0 to 15), roll (16 to 31), yaw (32 to 47)",
                    "-250 deg/s",
                ),
                (
                    "Acceleration",
                    "0xF02D",
                    "lateral (0 to 15), longitudinal (16 to 31), vertical (32 to 47)",
                    "-320 m/s^2",
                ),
            ),
        )
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
    },
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=("3DM-MV5-15",),
    generation=5,
    manual=None,
)
"""Device of generation 5. Also called 3DM-MV5-15. Generation 5. Model number 6243. No manual is
known. This profile is incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

RQ1_45_LT = Device(
    id="3dm-rq1-45-lt",
    title="3DM-RQ1-45-LT",
    description="Ruggedized tactical grade inertial navigation system with GPS.",
    model_number=6232,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it.",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x02),  # 3dm.poll_gnss_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x07),  # 3dm.get_gnss_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x09),  # 3dm.gnss_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x20),  # 3dm.raw_rtcm_2_3_message
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "example",
            "An example of the vendor for it uses it (MIP SDK of 2014: Examples, one for each model).",
            frozenset(
                {
                    (0x0D, 0x10),  # filter.vehicle_dynamics_mode
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x12),  # filter.sensor_to_vehicle_offset
                    (0x0D, 0x13),  # filter.antenna_offset
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x15),  # filter.gnss_source
                    (0x0D, 0x16),  # filter.external_gnss_update
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x18),  # filter.heading_source
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1C),  # filter.accel_bias_model
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1E),  # filter.auto_zupt
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x22),  # filter.commanded_zupt
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x42),  # filter.mag_noise
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x45),  # filter.mag_magnitude_error_adaptive_measurement
                    (0x0D, 0x46),  # filter.mag_dip_angle_error_adaptive_measurement
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x81, 0x03),  # gnss_data.llh_position
                    (0x81, 0x05),  # gnss_data.ned_velocity
                    (0x81, 0x09),  # gnss_data.gps_time
                    (0x82, 0x01),  # filter_data.llh_position
                    (0x82, 0x02),  # filter_data.ned_velocity
                    (0x82, 0x05),  # filter_data.euler_angles
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "direct_mode": Note(
            "Direct modes",
            "`system.comm_mode` connects the port to the inner inertial sensor or to the receiver. The inner sensor of the GX4 has the model number 6237, that of the RQ1 6238.",
            (),
        ),
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_rq1_45_response`.",
            (),
        ),
        "absent": Note(
            "What it lacks",
            "According to the table of contents of the manual, it has neither `base.gps_time_update` nor `3dm.complementary_filter`.",
            (),
        ),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
    },
    ack_codes=frozenset([]),
    incomplete=(
        "The table of contents of the manual is known up to `filter.set_initial_heading`. The set `system` follows.",
        "It has the data sets 0x80, 0x81 and 0x82, none of whose fields is known.",
    ),
    also=("3DM-RQ1-45_LT",),
    generation=4,
    manual="3dm-rq1-45",
)
"""Ruggedized tactical grade inertial navigation system with GPS. Also called 3DM-RQ1-45_LT.
Generation 4. Model number 6232. Manual: LORD 3DM-RQ1-45 Data Communications Protocol, of June 25,
2013, known from its table of contents. This profile is incomplete: The table of contents of the
manual is known up to `filter.SetInitialHeading`. The set `system` follows. This profile is
incomplete: It has the data sets 0x80, 0x81 and 0x82, none of whose fields is known. Uncertain: The
SDK writes the name with an underscore before LT and ST.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

RQ1_45_ST = Device(
    id="3dm-rq1-45-st",
    title="3DM-RQ1-45-ST",
    description="Ruggedized tactical grade inertial navigation system with GPS.",
    model_number=6239,
    evidence=(
        Evidence(
            Support.YES,
            "documented",
            "Its documentation has it.",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x01),  # 3dm.poll_imu_data
                    (0x0C, 0x02),  # 3dm.poll_gnss_data
                    (0x0C, 0x03),  # 3dm.poll_filter_data
                    (0x0C, 0x06),  # 3dm.get_imu_base_rate
                    (0x0C, 0x07),  # 3dm.get_gnss_base_rate
                    (0x0C, 0x08),  # 3dm.imu_message_format
                    (0x0C, 0x09),  # 3dm.gnss_message_format
                    (0x0C, 0x0A),  # 3dm.filter_message_format
                    (0x0C, 0x0B),  # 3dm.get_filter_base_rate
                    (0x0C, 0x11),  # 3dm.data_stream_control
                    (0x0C, 0x20),  # 3dm.raw_rtcm_2_3_message
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0C, 0x37),  # 3dm.accel_bias
                    (0x0C, 0x38),  # 3dm.gyro_bias
                    (0x0C, 0x39),  # 3dm.capture_gyro_bias
                    (0x0C, 0x3A),  # 3dm.mag_hard_iron_offset
                    (0x0C, 0x3B),  # 3dm.mag_soft_iron_matrix
                    (0x0C, 0x3E),  # 3dm.coning_sculling_enable
                    (0x0C, 0x40),  # 3dm.uart_baud_rate
                    (0x0C, 0x50),  # 3dm.imu_low_pass_filter
                    (0x0C, 0x64),  # 3dm.device_status
                    (0x0D, 0x01),  # filter.reset
                    (0x0D, 0x02),  # filter.set_initial_attitude
                    (0x0D, 0x03),  # filter.set_initial_heading
                }
            ),
            (),
        ),
        Evidence(
            Support.PROBABLE,
            "sister",
            "A nearly equal device has it, 3DM-RQ1-45-LT.",
            frozenset(
                {
                    (0x0D, 0x10),  # filter.vehicle_dynamics_mode
                    (0x0D, 0x11),  # filter.sensor_to_vehicle_rotation_euler
                    (0x0D, 0x12),  # filter.sensor_to_vehicle_offset
                    (0x0D, 0x13),  # filter.antenna_offset
                    (0x0D, 0x14),  # filter.estimation_control
                    (0x0D, 0x15),  # filter.gnss_source
                    (0x0D, 0x16),  # filter.external_gnss_update
                    (0x0D, 0x17),  # filter.external_heading_update
                    (0x0D, 0x18),  # filter.heading_source
                    (0x0D, 0x19),  # filter.auto_initialization_control
                    (0x0D, 0x1A),  # filter.accel_noise
                    (0x0D, 0x1B),  # filter.gyro_noise
                    (0x0D, 0x1C),  # filter.accel_bias_model
                    (0x0D, 0x1D),  # filter.gyro_bias_model
                    (0x0D, 0x1E),  # filter.auto_zupt
                    (0x0D, 0x1F),  # filter.external_heading_update_with_time
                    (0x0D, 0x20),  # filter.auto_angular_zupt
                    (0x0D, 0x21),  # filter.tare_orientation
                    (0x0D, 0x22),  # filter.commanded_zupt
                    (0x0D, 0x23),  # filter.commanded_angular_zupt
                    (0x0D, 0x42),  # filter.mag_noise
                    (0x0D, 0x43),  # filter.magnetic_declination_source
                    (0x0D, 0x44),  # filter.accel_magnitude_error_adaptive_measurement
                    (0x0D, 0x45),  # filter.mag_magnitude_error_adaptive_measurement
                    (0x0D, 0x46),  # filter.mag_dip_angle_error_adaptive_measurement
                    (0x7F, 0x10),  # system.comm_mode
                    (0x80, 0x04),  # sensor.scaled_accel
                    (0x80, 0x05),  # sensor.scaled_gyro
                    (0x80, 0x06),  # sensor.scaled_mag
                    (0x81, 0x03),  # gnss_data.llh_position
                    (0x81, 0x05),  # gnss_data.ned_velocity
                    (0x81, 0x09),  # gnss_data.gps_time
                    (0x82, 0x01),  # filter_data.llh_position
                    (0x82, 0x02),  # filter_data.ned_velocity
                    (0x82, 0x05),  # filter_data.euler_angles
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={
        "direct_mode": Note(
            "Direct modes",
            "`system.comm_mode` connects the port to the inner inertial sensor or to the receiver. The inner sensor of the GX4 has the model number 6237, that of the RQ1 6238.",
            (),
        ),
        "device_status": Note(
            "Device status",
            "According to MSCL, it answers with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_rq1_45_response`.",
            (),
        ),
        "absent": Note(
            "What it lacks",
            "According to the table of contents of the manual, it has neither `base.gps_time_update` nor `3dm.complementary_filter`.",
            (),
        ),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
    },
    ack_codes=frozenset([]),
    incomplete=(
        "The table of contents of the manual is known up to `filter.set_initial_heading`. The set `system` follows.",
        "It has the data sets 0x80, 0x81 and 0x82, none of whose fields is known.",
    ),
    also=("3DM-RQ1-45_ST",),
    generation=4,
    manual="3dm-rq1-45",
)
"""Ruggedized tactical grade inertial navigation system with GPS. Also called 3DM-RQ1-45_ST.
Generation 4. Model number 6239. Manual: LORD 3DM-RQ1-45 Data Communications Protocol, of June 25,
2013, known from its table of contents. This profile is incomplete: The table of contents of the
manual is known up to `filter.SetInitialHeading`. The set `system` follows. This profile is
incomplete: It has the data sets 0x80, 0x81 and 0x82, none of whose fields is known. Uncertain: The
SDK writes the name with an underscore before LT and ST.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

RTK = Device(
    id="3dm-rtk",
    title="3DM-RTK",
    description="Modem for GNSS corrections.",
    model_number=6285,
    evidence=(
        Evidence(
            Support.PROBABLE,
            "software",
            "Software for it uses it (MicroStrain Communication Library: MIP node features).",
            frozenset(
                {
                    (0x01, 0x01),  # base.ping
                    (0x01, 0x02),  # base.set_idle
                    (0x01, 0x03),  # base.get_device_info
                    (0x01, 0x04),  # base.get_device_descriptors
                    (0x01, 0x05),  # base.built_in_test
                    (0x01, 0x06),  # base.resume
                    (0x01, 0x09),  # base.comm_speed
                    (0x01, 0x7E),  # base.soft_reset
                    (0x0C, 0x30),  # 3dm.device_settings
                    (0x0F, 0x01),  # rtk.get_status_flags
                    (0x0F, 0x07),  # rtk.get_activation_code
                    (0x7F, 0x10),  # system.comm_mode
                }
            ),
            (),
        ),
    ),
    functions={},
    base_rates={},
    ports=(),
    limits={},
    notes={},
    readings={"base.built_in_test_response.result": types.Cv7BuiltInTest},
    ack_codes=frozenset([]),
    incomplete=("No manual is known.",),
    also=(),
    generation=7,
    manual=None,
)
"""Modem for GNSS corrections. Generation 7. Model number 6285. No manual is known. This profile is
incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""

#: All devices by id.
DEVICES: dict[str, Device] = {
    "3dm-cl5-10": CL5_10,
    "3dm-cl5-15": CL5_15,
    "3dm-cl5-25": CL5_25,
    "3dm-cv5-10": CV5_10,
    "3dm-cv5-15": CV5_15,
    "3dm-cv5-25": CV5_25,
    "3dm-cv5-45": CV5_45,
    "3dm-cv7-ahrs": CV7_AHRS,
    "3dm-cv7-ar": CV7_AR,
    "3dm-cv7-gnss-ins": CV7_GNSS_INS,
    "3dm-cv7-ins": CV7_INS,
    "3dm-cx5-10": CX5_10,
    "3dm-cx5-15": CX5_15,
    "3dm-cx5-25": CX5_25,
    "3dm-cx5-35": CX5_35,
    "3dm-cx5-45": CX5_45,
    "3dm-cx7-ahrs": CX7_AHRS,
    "3dm-cx7-ar": CX7_AR,
    "3dm-cx7-ins": CX7_INS,
    "3dm-dh3": DH3,
    "3dm-gq4-45": GQ4_45,
    "3dm-gq7": GQ7,
    "3dm-gv7-ahrs": GV7_AHRS,
    "3dm-gv7-ar": GV7_AR,
    "3dm-gv7-ins": GV7_INS,
    "3dm-gx3-15": GX3_15,
    "3dm-gx3-25": GX3_25,
    "3dm-gx3-35": GX3_35,
    "3dm-gx3-45": GX3_45,
    "3dm-gx4-15": GX4_15,
    "3dm-gx4-25": GX4_25,
    "3dm-gx4-45": GX4_45,
    "3dm-gx5-10": GX5_10,
    "3dm-gx5-15": GX5_15,
    "3dm-gx5-25": GX5_25,
    "3dm-gx5-35": GX5_35,
    "3dm-gx5-45": GX5_45,
    "3dm-mv5-ar": MV5_AR,
    "3dm-rq1-45-lt": RQ1_45_LT,
    "3dm-rq1-45-st": RQ1_45_ST,
    "3dm-rtk": RTK,
}


def find(name: str) -> Device | None:
    """A device by its id, its title or another name."""
    return next((d for d in DEVICES.values() if name in (d.id, d.title, *d.also)), None)


def by_name(name: str) -> Device:
    """The same for any spelling, or for its last words ("gx5 15"); raises UnknownName, which gives the nearest."""
    return DEVICES[device_id(name)]


def by_model(number: int) -> Device | None:
    """A device by its model number; None if it is unknown, for example of a newer device."""
    return next((d for d in DEVICES.values() if d.model_number == number), None)


def identify(info: DeviceInfo) -> Device | None:
    """The device that sent this device information; None if it is unknown."""
    number = model_number(info.model_number) or model_number(info.serial_number)
    return by_model(number) if number else None


# fmt: off
__all__ = [
    "DEVICES", "Device", "DeviceInfo", "Evidence", "Limit", "Note", "Port", "Support", "by_model", "by_name", "find",
    "identify", "model_number",
    "CL5_10",
    "CL5_15",
    "CL5_25",
    "CV5_10",
    "CV5_15",
    "CV5_25",
    "CV5_45",
    "CV7_AHRS",
    "CV7_AR",
    "CV7_GNSS_INS",
    "CV7_INS",
    "CX5_10",
    "CX5_15",
    "CX5_25",
    "CX5_35",
    "CX5_45",
    "CX7_AHRS",
    "CX7_AR",
    "CX7_INS",
    "DH3",
    "GQ4_45",
    "GQ7",
    "GV7_AHRS",
    "GV7_AR",
    "GV7_INS",
    "GX3_15",
    "GX3_25",
    "GX3_35",
    "GX3_45",
    "GX4_15",
    "GX4_25",
    "GX4_45",
    "GX5_10",
    "GX5_15",
    "GX5_25",
    "GX5_35",
    "GX5_45",
    "MV5_AR",
    "RQ1_45_LT",
    "RQ1_45_ST",
    "RTK",
]
