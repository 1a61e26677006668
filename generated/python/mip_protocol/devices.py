"""The fields that each device supports, and the meanings of values that differ between devices."""

from __future__ import annotations

from . import filter_data, mip_3dm, types
from .lookup import device_id
from .profile import Device, DeviceInfo, Evidence, Limit, Note, Port, Support, model_number

# fmt: off

CV5_10 = Device(
    id="3dm-cv5-10", title="3DM-CV5-10", model_number=6259,
    description="Inertial measurement unit.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented (3DM-CV5-10 Data Communications Protocol Manual: Contents).",
            {0x01: bytes.fromhex("01 02 03 04 05 06 72 7E"), 0x0C: bytes.fromhex("01 06 08")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
            {0x0C: bytes.fromhex("30"), 0x80: bytes.fromhex("04 05")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-CX5-10.",
            {0x0C: bytes.fromhex("11 37 38 39 3E 40 50 51 64"), 0x80: bytes.fromhex("07 08 12")}),
        Evidence(Support.NO, "refused", "Rejected by the device (MicroStrain Communication Library: Issue 145).",
            {0x80: bytes.fromhex("01")}),
        Evidence(Support.NO, "unlisted", "Not in the manual, whose list of the set is complete.",
            {0x01: bytes.fromhex("07 08 09")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires a magnetometer, which the device lacks.",
            {0x0C: bytes.fromhex("3A 3B"), 0x80: bytes.fromhex("03 06")}, absence='has no magnetometer'),
        Evidence(Support.NO, "hardware", "Requires a pressure sensor, which the device lacks.",
            {0x80: bytes.fromhex("16 17")}, absence='has no pressure sensor'),
    ),
    base_rates={},
    notes={
        "device_status": Note("Device status", "According to MSCL, it replies with `3dm.device_status_basic_without_state_response` and `3dm.device_status_diagnostic_imu_response`.", ()),
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
    incomplete=("Of the manual, only the table of contents is known, up to the set `3dm`. It lists only the sets `base`, `3dm` and `sensor`.",),
    also=("3DM-CV5-IMU",),
    generation=5,
    manual="3dm-cv5-10",
)
"""Inertial measurement unit. Also called 3DM-CV5-IMU. Generation 5. Model number 6259. Sensors:
accelerometer, gyroscope. GNSS receivers: none. GNSS antennas: none. Sets known completely from the
manual: base (0x01). Manual: 3DM-CV5-10 Data Communications Protocol Manual, 8500-0070 revision E,
2018, known from its contents. This profile is incomplete: Of the manual, only the table of contents
is known, up to the set `3dm`. It lists only the sets `base`, `3dm` and `sensor`. Uncertain: The
sensors are inferred from the name of the model; that it has no magnetometer also from MSCL, which
offers it no north compensation.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


CV5_15 = Device(
    id="3dm-cv5-15", title="3DM-CV5-15", model_number=6258,
    description="Attitude reference.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented (3DM-CV5-15 Data Communications Protocol Manual: Contents).",
            {0x01: bytes.fromhex("01 02 03 04 05 06 07 72 7E"), 0x0C: bytes.fromhex("01 03 06 08 0A 0B")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            {0x0C: bytes.fromhex("30 39"), 0x0D: bytes.fromhex("11 19"), 0x80: bytes.fromhex("04 05 12"), 0x82: bytes.fromhex("05 0E 10 11 1C")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
            {0x0D: bytes.fromhex("01")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX5-15.",
            {0x0C: bytes.fromhex("11 37 38 3E 40 50 51 64"), 0x0D: bytes.fromhex("02 03 14 17 18 1A 1B 1D 1F 20 21 23 26 28 41 44 4B"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("07 08 09 0A 0C 10 11 17"), 0x82: bytes.fromhex("03 04 06 0A 0B 0D 0F 12 13 14 21")}),
        Evidence(Support.NO, "unlisted", "Not in the manual, whose list of the set is complete.",
            {0x01: bytes.fromhex("08 09")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires a magnetometer, which the device lacks.",
            {0x0C: bytes.fromhex("3A 3B"), 0x0D: bytes.fromhex("27 2B 2C 42 43 45 46 4C 4D"), 0x80: bytes.fromhex("03 06"), 0x82: bytes.fromhex("1A 1B 25 26 28 29 2A 2C")}, absence='has no magnetometer'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
    ),
    base_rates={},
    notes={
        "device_status": Note("Device status", "According to MSCL, it replies with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_response`.", ()),
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
    incomplete=("Of the manual, only the table of contents is known, up to `3dm.filter_message_format`. It lists the sets `base`, `3dm`, `filter`, `system`, `sensor` and `filter_data`.",),
    also=("3DM-CV5-AR",),
    generation=5,
    manual="3dm-cv5-15",
)
"""Attitude reference. Also called 3DM-CV5-AR. Generation 5. Model number 6258. Sensors:
accelerometer, gyroscope, pressure sensor. GNSS receivers: none. GNSS antennas: none. Sets known
completely from the manual: base (0x01). Manual: 3DM-CV5-15 Data Communications Protocol Manual,
revision D, 2018, known from its contents. This profile is incomplete: Of the manual, only the table
of contents is known, up to `mip_3dm.FilterMessageFormat`. It lists the sets `base`, `3dm`,
`filter`, `system`, `sensor` and `filter_data`.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


CV5_25 = Device(
    id="3dm-cv5-25", title="3DM-CV5-25", model_number=6257,
    description="Attitude and heading reference system.",
    evidence=(
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            {0x01: bytes.fromhex("01 02 06"), 0x0C: bytes.fromhex("06 08 0A 0B 30 39"), 0x0D: bytes.fromhex("11 19"), 0x80: bytes.fromhex("04 05 12"), 0x82: bytes.fromhex("05 0E 10 11 1C")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("03"), 0x0D: bytes.fromhex("01 18")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("04 07")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-GX5-45.",
            {0x01: bytes.fromhex("05 72 7E"), 0x0C: bytes.fromhex("01 03 11 37 38 3A 3B 3E 40 50 51 64"), 0x0D: bytes.fromhex("02 03 14 17 1A 1B 1D 1F 20 21 23 26 27 28 29 2B 2C 41 42 43 44 45 46 47 4B"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("06 07 08 09 0A 0C 10 11 17"), 0x82: bytes.fromhex("03 04 06 0A 0B 0D 0F 12 13 14 15 21 25 26 28 29")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
    ),
    base_rates={},
    notes={
        "device_status": Note("Device status", "According to MSCL, it replies with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_response`.", ()),
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
    incomplete=("No manual is known.",),
    also=("3DM-CV5-AHRS",),
    generation=5,
)
"""Attitude and heading reference system. Also called 3DM-CV5-AHRS. Generation 5. Model number 6257.
Sensors: accelerometer, gyroscope, magnetometer, pressure sensor. GNSS receivers: none. GNSS
antennas: none. No manual is known. This profile is incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


CV7_AHRS = Device(
    id="3dm-cv7-ahrs", title="3DM-CV7-AHRS", model_number=6286,
    description="Attitude and heading reference system.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Protocol Support and Specifications).",
            {0x01: bytes.fromhex("04 07 09"), 0x0C: bytes.fromhex("0E 50 54"), 0x80: bytes.fromhex("06 17"), 0x82: bytes.fromhex("1C")}),
        Evidence(Support.YES, "documented", "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages).",
            {0x01: bytes.fromhex("7E"), 0x0C: bytes.fromhex("2A"), 0x80: bytes.fromhex("0C"), 0x82: bytes.fromhex("50")}),
        Evidence(Support.YES, "documented", "Documented.",
            {0x0C: bytes.fromhex("11 38 39 3A 3B"), 0x0D: bytes.fromhex("01 03 43"), 0x13: bytes.fromhex("01 1F 31 32"), 0x80: bytes.fromhex("04"), 0x82: bytes.fromhex("06")}),
        Evidence(Support.YES, "documented", "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by the ROS messages).",
            {0x0C: bytes.fromhex("2E 2F 41"), 0x80: bytes.fromhex("18"), 0xA0: bytes.fromhex("02"), 0xFF: bytes.fromhex("D0 D3")}),
        Evidence(Support.YES, "documented", "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by a public program).",
            {0x0D: bytes.fromhex("50"), 0x80: bytes.fromhex("05 0A"), 0x82: bytes.fromhex("03 04 05 0D 0E 10 13")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            {0x01: bytes.fromhex("01 02 06"), 0x0C: bytes.fromhex("0F 2B 30 31")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("03")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (Public programs of users: Program for a 3DM-CV7).",
            {0x01: bytes.fromhex("05")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (ROS driver of the vendor: Example configurations).",
            {0x0C: bytes.fromhex("28"), 0x0D: bytes.fromhex("53")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (PX4: Driver of the vendor's sensors).",
            {0x0C: bytes.fromhex("52"), 0x82: bytes.fromhex("0A")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
            {0x01: bytes.fromhex("08 72"), 0x0C: bytes.fromhex("0D 10 2C 2D 32 33 37 42 51 53"), 0x0D: bytes.fromhex("1A 1B 1D 20 28"), 0x80: bytes.fromhex("07 08 09 14"), 0x82: bytes.fromhex("0B 12 21"), 0xA0: bytes.fromhex("01 03"), 0xFF: bytes.fromhex("D4 D5 D6 D7 D8")}),
        Evidence(Support.NO, "refused", "Rejected by the device (firmware 1.0.07; ROS driver of the vendor: Issue 257).",
            {0x81: bytes.fromhex("03 0B"), 0x82: bytes.fromhex("34 43"), 0x91: bytes.fromhex("03 0B")}),
        Evidence(Support.NO, "refused", "Rejected by the device (ROS driver of the vendor: Issue 350).",
            {0x82: bytes.fromhex("49"), 0x91: bytes.fromhex("12 14"), 0x92: bytes.fromhex("0B 12 14")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
    ),
    functions={
        (0x0C, 0x38): "WRSLD",
        (0x0C, 0x3A): "WRSLD",
        (0x0C, 0x3B): "WRSLD",
    },
    firmware={
        (0x0C, 0x50): "<= 1.0.07",
        (0x0C, 0x54): "> 1.0.07",
    },
    base_rates={0x80: 1000, 0x82: 1000, 0xA0: 1000},
    ports=(
        Port("Main", 1, (115200, 230400, 460800, 921600), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (115200, 230400, 460800, 921600), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(4, None, "Number of frames that the aiding frame configuration can define, according to MSCL."),
        "event_triggers": Limit(12, None, "Total number of triggers.", '>= 1.0.04'),
        "event_gpio_triggers": Limit(4, None, "Number of GPIO triggers.", '>= 1.0.04'),
        "event_threshold_triggers": Limit(8, None, "Number of threshold triggers.", '>= 1.0.04'),
        "event_combination_triggers": Limit(8, None, "Number of combination triggers.", '>= 1.0.04'),
        "event_tick_rate": Limit(1000, "Hz", "Rate of the event cycle.", '>= 1.0.04'),
    },
    notes={
        "anti_aliasing": Note("Anti-aliasing low-pass filter", "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.", (("Set", "Descriptor", "Data"), ("0x80", "0x04", "Scaled accel"), ("0x80", "0x05", "Scaled gyro"), ("0x80", "0x06", "Scaled mag"), ("0x80", "0x17", "Scaled pressure"), ("0x82", "0x1C", "Compensated acceleration"), ("0x82", "0x0E", "Compensated angular rate"), ("0x82", "0x0D", "Linear acceleration"))),
        "gpio_pins": Note("GPIO pins", "Features of each pin, according to MSCL, and its position on the connector, according to the ROS driver.", (("Pin", "Connector pin", "Features"), ("1", "7", "GPIO, PPS, timestamp"), ("2", "9", "GPIO, PPS, timestamp"), ("3", "6", "GPIO, PPS, timestamp"), ("4", "10", "GPIO, PPS, timestamp"))),
        "ports": Note("Ports", "The main port is an alias of USB 1 if that is connected, or else of UART 1.", ()),
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
    incomplete=("Only some pages of its manual are known; the device has further commands and data.",),
    generation=7,
    manual="3dm-cv7",
)
"""Attitude and heading reference system. Generation 7. Model number 6286. Sensors: accelerometer,
gyroscope, magnetometer, pressure sensor. GNSS receivers: none. GNSS antennas: none. Manual:
MicroStrain 3DM-CV7 Documentation (AHRS and AR), online, known from some pages. This profile is
incomplete: Only some pages of its manual are known; the device has further commands and data.
Uncertain: MSCL offers only the values `none` and `manual` of `filter.MagneticDeclinationSource`;
the manual also has `wmm`.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


CV7_AR = Device(
    id="3dm-cv7-ar", title="3DM-CV7-AR", model_number=6287,
    description="Attitude reference.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Protocol Support and Specifications).",
            {0x01: bytes.fromhex("04 07 09"), 0x0C: bytes.fromhex("0E 50 54"), 0x80: bytes.fromhex("17"), 0x82: bytes.fromhex("1C")}),
        Evidence(Support.YES, "documented", "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages).",
            {0x01: bytes.fromhex("7E"), 0x0C: bytes.fromhex("2A"), 0x80: bytes.fromhex("0C"), 0x82: bytes.fromhex("50")}),
        Evidence(Support.YES, "documented", "Documented.",
            {0x0C: bytes.fromhex("11 38 39"), 0x0D: bytes.fromhex("01 03"), 0x13: bytes.fromhex("01 1F 31 32"), 0x80: bytes.fromhex("04"), 0x82: bytes.fromhex("06")}),
        Evidence(Support.YES, "documented", "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by the ROS messages).",
            {0x0C: bytes.fromhex("2E 2F 41"), 0x80: bytes.fromhex("18"), 0xA0: bytes.fromhex("02"), 0xFF: bytes.fromhex("D0 D3")}),
        Evidence(Support.YES, "documented", "Documented (MicroStrain 3DM-CV7 Documentation (AHRS and AR): Field pages, linked by a public program).",
            {0x0D: bytes.fromhex("50"), 0x80: bytes.fromhex("05 0A"), 0x82: bytes.fromhex("03 04 05 0D 0E 10 13")}),
        Evidence(Support.YES, "listed", "Listed by the device (MicroStrain Communication Library: Issue 258).",
            {0x01: bytes.fromhex("08"), 0xA0: bytes.fromhex("01 03"), 0xFF: bytes.fromhex("D4 D5 D6 D7 D8")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("01 02 03 06"), 0x0C: bytes.fromhex("0F 2B 30 31")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (ROS driver of the vendor: Example configurations).",
            {0x0C: bytes.fromhex("28"), 0x0D: bytes.fromhex("53")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (PX4: Driver of the vendor's sensors).",
            {0x0C: bytes.fromhex("52"), 0x82: bytes.fromhex("0A")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
            {0x01: bytes.fromhex("05 72"), 0x0C: bytes.fromhex("0D 10 2C 2D 32 33 37 42 51 53"), 0x0D: bytes.fromhex("1A 1B 1D 20 28"), 0x80: bytes.fromhex("07 08 09 14"), 0x82: bytes.fromhex("0B 12 21")}),
        Evidence(Support.NO, "refused", "Rejected by the device (MicroStrain Communication Library: Issue 258).",
            {0x0D: bytes.fromhex("19 44 4B")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires a magnetometer, which the device lacks.",
            {0x0C: bytes.fromhex("3A 3B"), 0x0D: bytes.fromhex("27 2B 2C 42 43 45 46 4C 4D"), 0x80: bytes.fromhex("03 06"), 0x82: bytes.fromhex("1A 1B 25 26 28 29 2A 2C")}, absence='has no magnetometer'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
    ),
    functions={
        (0x0C, 0x38): "WRSLD",
    },
    firmware={
        (0x0C, 0x50): "<= 1.0.07",
        (0x0C, 0x54): "> 1.0.07",
    },
    base_rates={0x80: 1000, 0x82: 1000, 0xA0: 1000},
    ports=(
        Port("Main", 1, (115200, 230400, 460800, 921600), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (115200, 230400, 460800, 921600), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(4, None, "Number of frames that the aiding frame configuration can define, according to MSCL."),
        "event_triggers": Limit(12, None, "Total number of triggers.", '>= 1.0.04'),
        "event_gpio_triggers": Limit(4, None, "Number of GPIO triggers.", '>= 1.0.04'),
        "event_threshold_triggers": Limit(8, None, "Number of threshold triggers.", '>= 1.0.04'),
        "event_combination_triggers": Limit(8, None, "Number of combination triggers.", '>= 1.0.04'),
        "event_tick_rate": Limit(1000, "Hz", "Rate of the event cycle.", '>= 1.0.04'),
    },
    notes={
        "anti_aliasing": Note("Anti-aliasing low-pass filter", "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.", (("Set", "Descriptor", "Data"), ("0x80", "0x04", "Scaled accel"), ("0x80", "0x05", "Scaled gyro"), ("0x80", "0x06", "Scaled mag"), ("0x80", "0x17", "Scaled pressure"), ("0x82", "0x1C", "Compensated acceleration"), ("0x82", "0x0E", "Compensated angular rate"), ("0x82", "0x0D", "Linear acceleration"))),
        "gpio_pins": Note("GPIO pins", "Features of each pin, according to MSCL, and its position on the connector, according to the ROS driver.", (("Pin", "Connector pin", "Features"), ("1", "7", "GPIO, PPS, timestamp"), ("2", "9", "GPIO, PPS, timestamp"), ("3", "6", "GPIO, PPS, timestamp"), ("4", "10", "GPIO, PPS, timestamp"))),
        "ports": Note("Ports", "The main port is an alias of USB 1 if that is connected, or else of UART 1.", ()),
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
    incomplete=("Only some pages of its manual are known; the device has further commands and data.",),
    generation=7,
    manual="3dm-cv7",
)
"""Attitude reference. Generation 7. Model number 6287. Sensors: accelerometer, gyroscope, pressure
sensor. GNSS receivers: none. GNSS antennas: none. Manual: MicroStrain 3DM-CV7 Documentation (AHRS
and AR), online, known from some pages. This profile is incomplete: Only some pages of its manual
are known; the device has further commands and data. Uncertain: MSCL offers only the values `none`
and `manual` of `filter.MagneticDeclinationSource`; the manual also has `wmm`.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


CV7_GNSS_INS = Device(
    id="3dm-cv7-gnss-ins", title="3DM-CV7-GNSS/INS", model_number=6292,
    description="Inertial navigation system with two RTK-capable GNSS receivers, magnetometer and pressure sensor.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented.",
            {0x01: bytes.fromhex("01 02 03 04 05 06 07 08 09 72 7E"), 0x0C: bytes.fromhex("04 0C 0D 0E 0F 10 11 22 28 2A 2B 2C 2D 2E 2F 30 31 32 33 37 38 39 3A 3B 40 41 42 43 50 51 52 53 54"), 0x0D: bytes.fromhex("01 03 05 13 15 17 1A 1B 1C 1D 1F 20 28 43 50 52 53 54 55 56 61 63 64"), 0x0E: bytes.fromhex("01 02 20"), 0x13: bytes.fromhex("01 1F 21 22 23 28 29 2A 31 32 33"), 0x7F: bytes.fromhex("02"), 0x80: bytes.fromhex("04 05 06 07 08 09 0A 0C 12 14 17 18 40"), 0x82: bytes.fromhex("01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 10 11 12 13 15 1C 21 34 35 36 37 40 41 42 43 46 47 48 49 50 51"), 0x91: bytes.fromhex("03 04 05 06 07 08 09 0B 0D 10 11 12 20 22 61 62 63 64"), 0x92: bytes.fromhex("03 04 05 06 07 08 09 0B 0D 10 11 12 20 22 61 62 63 64"), 0x93: bytes.fromhex("30 31"), 0x94: bytes.fromhex("03 05 08 0B 20"), 0xA0: bytes.fromhex("01 02 03"), 0xFF: bytes.fromhex("D0 D3 D4 D5 D6 D7 D8")}),
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
        Port("UART 1", 17, (115200, 230400, 460800, 921600, 3000000), ("MIP", "NMEA", "RTCM", "SPARTN"), ("MIP", "NMEA")),
        Port("UART 2", 18, (4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600), ("MIP", "NMEA", "RTCM", "SPARTN"), ("MIP", "NMEA")),
        Port("UART 3", 19, (4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600), ("MIP", "NMEA", "RTCM", "SPARTN"), ("MIP", "NMEA")),
        Port("USB 1", 33, (), ("MIP", "NMEA", "RTCM", "SPARTN"), ("MIP", "NMEA")),
        Port("USB 2", 34, (), ("MIP", "NMEA", "RTCM", "SPARTN"), ("MIP", "NMEA")),
    ),
    limits={
        "event_triggers": Limit(12, None, "Total number of triggers.", '>= 1.2.02'),
        "event_gpio_triggers": Limit(4, None, "Number of GPIO triggers.", '>= 1.2.02'),
        "event_threshold_triggers": Limit(8, None, "Number of threshold triggers.", '>= 1.2.02'),
        "event_combination_triggers": Limit(8, None, "Number of combination triggers.", '>= 1.2.02'),
        "event_actions": Limit(12, None, "Total number of actions.", '>= 1.2.02'),
        "event_gpio_actions": Limit(6, None, "Number of GPIO actions.", '>= 1.2.02'),
        "event_message_actions": Limit(8, None, "Number of message actions.", '>= 1.2.02'),
        "event_message_fields": Limit(12, None, "Maximum number of fields in the packet of a message action."),
        "event_tick_rate": Limit(1000, "Hz", "Rate of the event cycle; always the base rate of the system data set.", '>= 1.2.02'),
        "gpio_pins": Limit(4, None, "Number of user GPIO pins."),
        "aiding_frames": Limit(4, None, "Number of frames that the aiding frame configuration can define."),
        "nmea_rate": Limit(10, "Hz", "Maximum rate of an NMEA sentence from the sensor or filter data set."),
        "nmea_gnss_rate": Limit(2, "Hz", "Maximum rate of an NMEA sentence from a GNSS set."),
        "mip_input_ports": Limit(2, None, "Number of ports, besides the main port, that may accept MIP."),
        "nmea_input_ports": Limit(1, None, "Number of ports that may accept NMEA."),
        "rtcm_input_ports": Limit(1, None, "Number of ports that may accept RTCM."),
        "spartn_input_ports": Limit(1, None, "Number of ports that may accept SPARTN."),
        "baud_rate_delay": Limit(250, "ms", "Time to wait after a baud rate change."),
        "time_update_window": Limit(250, "ms", "Time after the rising edge of the PPS within which the GPS time update must arrive."),
        "save_time": Limit(1, "s", "Maximum duration of saving all settings."),
        "motion_latency": Limit(1.9, "ms", "Typical time from a motion to the message that reports it, not including transmission."),
        "timestamp_repeatability": Limit(1, "us", "Upper bound of the typical variation of sensor timestamps due to internal processing."),
        "gpio_timestamp_accuracy": Limit(1, "us", "Upper bound of the error of GPIO timestamps; the error is far smaller."),
        "antenna_offset_error": Limit(0.5, "m", "Upper limit of the maximum offset in the antenna lever arm calibration."),
    },
    notes={
        "ports": Note("Ports", "The main port is USB 1 while a host has it open (DTR set), else UART 1. MIP is always enabled on it. The others must be enabled first. All ports stream the same data; replies to polls go to the port that sent the poll.", (("Port", "Id", "Pins"), ("Main", "0x01", "alias of USB 1 or UART 1"), ("UART 1", "0x11", "connector pins 4 (RxD) and 5 (TxD)"), ("UART 2", "0x12", "GPIO 1 and GPIO 2"), ("UART 3", "0x13", "GPIO 3 and GPIO 4"), ("USB 1", "0x21", "connector pins 1 and 2"), ("USB 2", "0x22", "connector pins 1 and 2"))),
        "anti_aliasing": Note("Anti-aliasing low-pass filter", "Data that `3dm.low_pass_filter` can filter.", (("Set", "Descriptor", "Data"), ("0x80", "0x04", "Scaled accel"), ("0x80", "0x05", "Scaled gyro"), ("0x80", "0x06", "Scaled mag"), ("0x80", "0x17", "Scaled pressure"), ("0x82", "0x1C", "Compensated acceleration"), ("0x82", "0x0E", "Compensated angular rate"), ("0x82", "0x0D", "Linear acceleration"))),
        "gpio_pins": Note("GPIO pins", "Features of each pin; all are unused by default. The encoder feature is not available. The manual marks PPS on pins 2 to 4 with an asterisk, which it does not explain.", (("Pin", "Connector pin", "Features", "UART"), ("1", "7", "GPIO, PPS, timestamp, UART", "UART 2"), ("2", "9", "GPIO, PPS*, timestamp, UART", "UART 2"), ("3", "6", "GPIO, PPS*, timestamp, UART", "UART 3"), ("4", "10", "GPIO, PPS*, timestamp, UART", "UART 3"))),
        "gpio_behaviors": Note("GPIO behaviors and pin modes", "Values of the behavior for each feature, and the pin modes that go with it. Two pins cannot have the same direction of the same UART. PPS output from an internal receiver is always push-pull. The asterisk is the same as in the table of pin features.", (("Feature", "Behavior", "Pins", "Pin modes"), ("unused (0)", "unused (0)", "1 to 4", "none"), ("gpio (1)", "input (1)", "1 to 4", "pull-up or pull-down"), ("gpio (1)", "output low (2)", "1 to 4", "open drain, optionally with pull-up"), ("gpio (1)", "output high (3)", "1 to 4", "open drain, optionally with pull-up"), ("pps (2)", "input (1)", "1; 2 to 4*", "none"), ("pps (2)", "output (2)", "1; 2 to 4*", "none"), ("timestamp (4)", "rising (1)", "1 to 4", "pull-up or pull-down"), ("timestamp (4)", "falling (2)", "1 to 4", "pull-up or pull-down"), ("timestamp (4)", "either (3)", "1 to 4", "pull-up or pull-down"), ("uart (5)", "UART 2 transmit (33)", "1 and 2", "open drain, optionally with pull-up"), ("uart (5)", "UART 2 receive (34)", "1 and 2", "pull-up or pull-down"), ("uart (5)", "UART 3 transmit (49)", "3 and 4", "open drain, optionally with pull-up"), ("uart (5)", "UART 3 receive (50)", "3 and 4", "pull-up or pull-down"))),
        "nmea_output": Note("NMEA output", "Sentences of `3dm.nmea_message_format`. The talkers are GN (GNSS), GP (GPS), GA (Galileo) and GL (GLONASS). A sentence is sent only while its data is valid. A GNSS source has a base rate of 5 Hz, so its decimation must be 3 or more.", (("Sentence", "Contents", "Talkers", "Sources"), ("GGA", "GNSS fix", "GN, GP, GA, GL", "GNSS, filter"), ("GLL", "Latitude and longitude", "GN, GP, GA, GL", "GNSS, filter"), ("GSV", "Satellites in view", "by constellation", "GNSS"), ("RMC", "Recommended minimum", "GN, GP, GA, GL", "GNSS, filter"), ("VTG", "Course and speed over ground", "GN, GP, GA, GL", "GNSS, filter"), ("HDT", "True heading", "GN, GP, GA, GL", "GNSS, filter"), ("ZDA", "Time and date", "GN, GP, GA, GL", "GNSS"), ("GST", "Error statistics", "GN, GP, GA, GL", "GNSS, filter"), ("PMSRA", "Euler angles", "proprietary", "filter"), ("PMSRR", "Angular rate and acceleration", "proprietary", "sensor"))),
        "nmea_input": Note("NMEA input", "Sentences accepted from an external receiver, with any talker: RMC, ZDA, HDT, GGA, VTG, GLL and GSV. They are received on the main port, USB 2, or a UART on GPIO pins; while such a UART is configured to receive, on that one only. An epoch is processed when a sentence with another time arrives. The manual warns of a known bug of NMEA input; the errata sheet that it refers to is not available.", ()),
        "rtcm_input": Note("RTCM input", "RTCM 3 messages that the GNSS receivers use.", (("Contents", "Messages"), ("GPS observations", "1074, 1075, 1077"), ("GLONASS observations", "1084, 1085, 1087"), ("Galileo observations", "1094, 1095, 1097"), ("BeiDou observations", "1124, 1125, 1127"), ("Station coordinates", "1005, 1006"), ("Antenna description", "1007"), ("Antenna and receiver description", "1033"), ("GLONASS biases", "1230"))),
        "gnss_signals": Note("GNSS signals", "Signals that can be enabled together by `gnss.signal_config`. GPS or Galileo must be enabled, and GPS L1 with BeiDou L1 alone is rejected.", (("Constellation", "Choices"), ("GPS", "none, L1, L1 + L5"), ("GLONASS", "none, L1"), ("Galileo", "none, L1 + L5"), ("BeiDou", "none, L1, L1 + L5"))),
        "sensor_ranges": Note("Sensor ranges", "Settings of `3dm.sensor_range`. The manual lists them for related models, and its gyroscope column is cut off; `3dm.get_calibrated_sensor_ranges` returns the settings that the device supports.", (("Sensor", "Setting", "Range"), ("Accelerometer", "2", "4 g"), ("Accelerometer", "3", "8 g"), ("Accelerometer", "4", "16 g"), ("Gyroscope", "2", "250 deg/s"))),
        "pps": Note("Pulse per second", "Without a valid PPS the filter neither starts nor accepts measurements. A PPS output has a duty cycle of 50 %; each second begins at its rising edge.", ()),
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
    generation=7,
    manual="3dm-cv7-gnss-ins",
)
"""Inertial navigation system with two RTK-capable GNSS receivers, magnetometer and pressure sensor.
Generation 7. Model number 6292. Sensors: accelerometer, gyroscope, magnetometer, pressure sensor.
GNSS receivers: 2. GNSS antennas: 2. Manual: MicroStrain 3DM-CV7-GNSS/INS Documentation, 8500-0099.
Uncertain: The manual warns of a bug in the NMEA input, and does not describe it.

- mip-sdk-4: Device models
"""


CV7_INS = Device(
    id="3dm-cv7-ins", title="3DM-CV7-INS", model_number=6291,
    description="Inertial navigation system without an internal GNSS receiver.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented.",
            {0x0D: bytes.fromhex("13 20")}),
        Evidence(Support.YES, "documented", "Documented (MicroStrain 3DM-CV7-INS Documentation: Field pages).",
            {0x0D: bytes.fromhex("52"), 0x13: bytes.fromhex("01"), 0x82: bytes.fromhex("50")}),
        Evidence(Support.YES, "documented", "Documented (MicroStrain 3DM-CV7-INS Documentation: Index of the set 0x94, on a test site).",
            {0x94: bytes.fromhex("03 04 05 06 07 08 0B 10 11 14 20")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("01 02 03 06"), 0x0C: bytes.fromhex("0E 0F 30 39"), 0x0D: bytes.fromhex("01 50"), 0x13: bytes.fromhex("22 29 2A 31")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            {0x82: bytes.fromhex("01 02 05 10"), 0xA0: bytes.fromhex("02"), 0xFF: bytes.fromhex("D3")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (PX4: Driver of the vendor's sensors).",
            {0x01: bytes.fromhex("04 07"), 0x0C: bytes.fromhex("11 31 52"), 0x0D: bytes.fromhex("15"), 0x80: bytes.fromhex("06 17"), 0x82: bytes.fromhex("03 08 09 0A 0D 0E")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (ROS driver of the vendor: Example configurations).",
            {0x01: bytes.fromhex("09"), 0x0C: bytes.fromhex("28 41 42"), 0x0D: bytes.fromhex("43 55"), 0x82: bytes.fromhex("36 40 42 46")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
            {0x0D: bytes.fromhex("53")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (Public programs of users: Notes on a 3DM-CV7-INS, 2026).",
            {0x80: bytes.fromhex("04 05")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
            {0x01: bytes.fromhex("05 08 72 7E"), 0x0C: bytes.fromhex("04 0C 0D 10 2A 2B 2C 2D 2E 2F 32 33 37 38 3A 3B 50 51 53 54"), 0x0D: bytes.fromhex("03 05 17 1A 1B 1C 1D 1F 28 56"), 0x13: bytes.fromhex("1F 21 23 28 32 33"), 0x80: bytes.fromhex("07 08 09 0A 0C 14 18"), 0x82: bytes.fromhex("04 06 07 0B 0C 12 13 15 1C 21 37 41 43 51"), 0xA0: bytes.fromhex("01 03"), 0xFF: bytes.fromhex("D0 D4 D5 D6 D7 D8")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
    ),
    base_rates={0x94: 0},
    ports=(
        Port("Main", 1, (), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (), ("MIP",), ("MIP",)),
        Port("UART 2", 18, (), ("MIP",), ("MIP",)),
        Port("UART 3", 19, (), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(4, None, "Number of frames that the aiding frame configuration can define, according to MSCL."),
        "antenna_offset": Limit(10, "m", "Maximum distance of the antenna from the device."),
    },
    notes={
        "anti_aliasing": Note("Anti-aliasing low-pass filter", "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.", (("Set", "Descriptor", "Data"), ("0x80", "0x04", "Scaled accel"), ("0x80", "0x05", "Scaled gyro"), ("0x80", "0x06", "Scaled mag"), ("0x80", "0x17", "Scaled pressure"), ("0x82", "0x1C", "Compensated acceleration"), ("0x82", "0x0E", "Compensated angular rate"), ("0x82", "0x0D", "Linear acceleration"))),
        "ports": Note("Ports", "The main port is an alias of USB 1 if that is connected, or else of UART 1. UART 2 is on the pins GPIO 1 and 2, UART 3 on GPIO 3 and 4.", ()),
        "gpio_pins": Note("GPIO pins", "Features of each pin, according to MSCL.", (("Pin", "Features"), ("1", "GPIO, PPS, timestamp, UART 2"), ("2", "GPIO, PPS, timestamp, UART 2"), ("3", "GPIO, PPS, timestamp, UART 3, encoder A"), ("4", "GPIO, PPS, timestamp, UART 3, encoder B"))),
        "receivers": Note("GNSS sets", "The sets 0x94 and 0x95 contain the data of two external receivers.", ()),
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
    incomplete=("Only some pages of its manual are known; the device has further commands and data.", "It has the data sets 0x80, 0x82, 0x94, 0x95, 0xA0 and 0xFF."),
    generation=7,
    manual="3dm-cv7-ins",
)
"""Inertial navigation system without an internal GNSS receiver. Generation 7. Model number 6291.
Sensors: accelerometer, gyroscope, magnetometer, pressure sensor. GNSS receivers: none. GNSS
antennas: none. Manual: MicroStrain 3DM-CV7-INS Documentation, online, known from some pages. This
profile is incomplete: Only some pages of its manual are known; the device has further commands and
data. This profile is incomplete: It has the data sets 0x80, 0x82, 0x94, 0x95, 0xA0 and 0xFF.
Uncertain: Only a test site of the vendor names the set 0x95. Uncertain: The base rate of the set
0x94 is inferred from the 3DM-CV7-GNSS/INS.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


CX5_10 = Device(
    id="3dm-cx5-10", title="3DM-CX5-10", model_number=6275,
    description="Inertial measurement unit.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented (3DM-CX5-10 Data Communications Protocol Manual: Contents).",
            {0x01: bytes.fromhex("01 02 03 04 05 06 72 7E"), 0x0C: bytes.fromhex("01 06 08 11")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
            {0x0C: bytes.fromhex("30"), 0x80: bytes.fromhex("04 05")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-CX5-10.",
            {0x0C: bytes.fromhex("37 38 39 3E 40 50 51 64"), 0x80: bytes.fromhex("07 08 12")}),
        Evidence(Support.NO, "unlisted", "Not in the manual, whose list of the set is complete.",
            {0x01: bytes.fromhex("07 08 09")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires a magnetometer, which the device lacks.",
            {0x0C: bytes.fromhex("3A 3B"), 0x80: bytes.fromhex("03 06")}, absence='has no magnetometer'),
        Evidence(Support.NO, "hardware", "Requires a pressure sensor, which the device lacks.",
            {0x80: bytes.fromhex("16 17")}, absence='has no pressure sensor'),
    ),
    base_rates={},
    notes={
        "device_status": Note("Device status", "According to MSCL, it replies with `3dm.device_status_basic_without_state_response` and `3dm.device_status_diagnostic_imu_response`.", ()),
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
    incomplete=("Of the manual, only the table of contents is known, up to the set `3dm`. It lists only the sets `base`, `3dm` and `sensor`.",),
    also=("3DM-CX5-IMU",),
    generation=5,
    manual="3dm-cx5-10",
)
"""Inertial measurement unit. Also called 3DM-CX5-IMU. Generation 5. Model number 6275. Sensors:
accelerometer, gyroscope. GNSS receivers: none. GNSS antennas: none. Sets known completely from the
manual: base (0x01). Manual: 3DM-CX5-10 Data Communications Protocol Manual, 8500-0087 revision A,
2017, known from its contents. This profile is incomplete: Of the manual, only the table of contents
is known, up to the set `3dm`. It lists only the sets `base`, `3dm` and `sensor`. Uncertain: The
sensors are inferred from the name of the model; that it has no magnetometer also from MSCL, which
offers it no north compensation.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


CX5_15 = Device(
    id="3dm-cx5-15", title="3DM-CX5-15", model_number=6274,
    description="Attitude reference.",
    evidence=(
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            {0x01: bytes.fromhex("01 02 06"), 0x0C: bytes.fromhex("06 08 0A 0B 30 39"), 0x0D: bytes.fromhex("11 19"), 0x80: bytes.fromhex("04 05 12"), 0x82: bytes.fromhex("05 0E 10 11 1C")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("03"), 0x0D: bytes.fromhex("01")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("04 07")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX5-15.",
            {0x01: bytes.fromhex("05 72 7E"), 0x0C: bytes.fromhex("01 03 11 37 38 3E 40 50 51 64"), 0x0D: bytes.fromhex("02 03 14 17 18 1A 1B 1D 1F 20 21 23 26 28 41 44 4B"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("07 08 09 0A 0C 10 11 17"), 0x82: bytes.fromhex("03 04 06 0A 0B 0D 0F 12 13 14 21")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires a magnetometer, which the device lacks.",
            {0x0C: bytes.fromhex("3A 3B"), 0x0D: bytes.fromhex("27 2B 2C 42 43 45 46 4C 4D"), 0x80: bytes.fromhex("03 06"), 0x82: bytes.fromhex("1A 1B 25 26 28 29 2A 2C")}, absence='has no magnetometer'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
    ),
    base_rates={},
    notes={
        "device_status": Note("Device status", "According to MSCL, it replies with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_response`.", ()),
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
    incomplete=("No manual is known.",),
    also=("3DM-CX5-AR",),
    generation=5,
)
"""Attitude reference. Also called 3DM-CX5-AR. Generation 5. Model number 6274. Sensors:
accelerometer, gyroscope, pressure sensor. GNSS receivers: none. GNSS antennas: none. No manual is
known. This profile is incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


CX5_25 = Device(
    id="3dm-cx5-25", title="3DM-CX5-25", model_number=6273,
    description="Attitude and heading reference system.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented (3DM-CX5-25 Data Communications Protocol Manual: Title).",
            {0x0D: bytes.fromhex("20 21")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            {0x01: bytes.fromhex("01 02 06"), 0x0C: bytes.fromhex("06 08 0A 0B 30 39"), 0x0D: bytes.fromhex("11 19"), 0x80: bytes.fromhex("04 05 12"), 0x82: bytes.fromhex("05 0E 10 11 1C")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("03"), 0x0D: bytes.fromhex("01 18")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("04 07")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-GX5-45.",
            {0x01: bytes.fromhex("05 72 7E"), 0x0C: bytes.fromhex("01 03 11 37 38 3A 3B 3E 40 50 51 64"), 0x0D: bytes.fromhex("02 03 14 17 1A 1B 1D 1F 23 26 27 28 29 2B 2C 41 42 43 44 45 46 47 4B"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("06 07 08 09 0A 0C 10 11 17"), 0x82: bytes.fromhex("03 04 06 0A 0B 0D 0F 12 13 14 15 21 25 26 28 29")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
    ),
    base_rates={},
    notes={
        "device_status": Note("Device status", "According to MSCL, it replies with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_response`.", ()),
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
    incomplete=("Of the manual, only the title is known. It has 149 pages.",),
    also=("3DM-CX5-AHRS",),
    generation=5,
    manual="3dm-cx5-25",
)
"""Attitude and heading reference system. Also called 3DM-CX5-AHRS. Generation 5. Model number 6273.
Sensors: accelerometer, gyroscope, magnetometer, pressure sensor. GNSS receivers: none. GNSS
antennas: none. Manual: 3DM-CX5-25 Data Communications Protocol Manual, 8500-0085 revision A, 2017,
known from its title. This profile is incomplete: Of the manual, only the title is known. It has 149
pages.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


CX5_45 = Device(
    id="3dm-cx5-45", title="3DM-CX5-45", model_number=6271,
    description="Inertial navigation system with GNSS.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented (3DM-CX5-45 Data Communications Protocol Manual: Title).",
            {0x80: bytes.fromhex("04 05 06")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            {0x01: bytes.fromhex("01 02 06"), 0x0C: bytes.fromhex("06 08 09 0A 0B 30"), 0x0D: bytes.fromhex("01 11 13 18 19"), 0x80: bytes.fromhex("12"), 0x81: bytes.fromhex("0B"), 0x82: bytes.fromhex("01 02 05 10 11")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("03"), 0x0C: bytes.fromhex("07 39")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (ArduPilot: AP_ExternalAHRS_MicroStrain5).",
            {0x80: bytes.fromhex("0A 17"), 0x81: bytes.fromhex("03 05 07"), 0x82: bytes.fromhex("03")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("04 07")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX5-45.",
            {0x01: bytes.fromhex("05 72 7E"), 0x0C: bytes.fromhex("01 02 03 11 21 22 23 24 37 38 3A 3B 3E 40 50 51 64"), 0x0D: bytes.fromhex("02 03 10 12 14 15 16 17 1A 1B 1C 1D 1E 1F 20 21 22 23 27 28 29 2B 2C 42 43 44 45 46 47 4B 53"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("07 08 09 0C 10 11"), 0x81: bytes.fromhex("04 06 08 09 0A 0C 0D 0E 0F"), 0x82: bytes.fromhex("04 0E 14")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX5-25 and 3DM-RQ1-45-LT.",
            {0x82: bytes.fromhex("06 07 08 09 0A 0B 0C 0D 0F 12 13 15 1C 20 21 25 26 28 29")}),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
        Evidence(Support.NO, "hardware", "Requires 2 receivers, which the device lacks.",
            {0x92: bytes.fromhex("")}, absence='has fewer than 2 GNSS receivers'),
    ),
    base_rates={},
    notes={
        "device_status": Note("Device status", "According to MSCL, it replies with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_gnss_response`.", ()),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    incomplete=("Of the manual, only the title is known. It has 196 pages, and describes the data from page 131.",),
    also=("3DM-CX5-GNSS/INS",),
    generation=5,
    manual="3dm-cx5-45",
)
"""Inertial navigation system with GNSS. Also called 3DM-CX5-GNSS/INS. Generation 5. Model number
6271. Sensors: accelerometer, gyroscope, magnetometer, pressure sensor. GNSS receivers: 1. GNSS
antennas: 1. Manual: 3DM-CX5-45 Data Communications Protocol Manual, 8500-0089 revision A, 2017,
known from its title. This profile is incomplete: Of the manual, only the title is known. It has 196
pages, and describes the data from page 131.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


CX7_AHRS = Device(
    id="3dm-cx7-ahrs", title="3DM-CX7-AHRS", model_number=6701,
    description="Attitude and heading reference system.",
    evidence=(
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
            {0x0C: bytes.fromhex("28 41"), 0x0D: bytes.fromhex("43 50 53")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("01 02 03 04 06 07"), 0x0C: bytes.fromhex("0E 0F 30")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
            {0x01: bytes.fromhex("05 08 09 72 7E"), 0x0C: bytes.fromhex("0D 10 11 2A 2B 2C 2D 2E 2F 31 32 33 37 38 39 3A 3B 42 50 51 52 53 54"), 0x0D: bytes.fromhex("01 03 1A 1B 1D 20 28"), 0x13: bytes.fromhex("01 1F 31 32"), 0x80: bytes.fromhex("04 05 06 07 08 09 0A 0C 14 17 18"), 0x82: bytes.fromhex("03 04 05 06 0A 0B 0D 0E 10 12 13 1C 21"), 0xA0: bytes.fromhex("01 02 03"), 0xFF: bytes.fromhex("D0 D3 D4 D5 D6 D7 D8")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
    ),
    base_rates={},
    ports=(
        Port("Main", 1, (), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(4, None, "Number of frames that the aiding frame configuration can define, according to MSCL."),
    },
    notes={
        "anti_aliasing": Note("Anti-aliasing low-pass filter", "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.", (("Set", "Descriptor", "Data"), ("0x80", "0x04", "Scaled accel"), ("0x80", "0x05", "Scaled gyro"), ("0x80", "0x06", "Scaled mag"), ("0x80", "0x17", "Scaled pressure"), ("0x82", "0x1C", "Compensated acceleration"), ("0x82", "0x0E", "Compensated angular rate"), ("0x82", "0x0D", "Linear acceleration"))),
        "ports": Note("Ports", "The main port is an alias of USB 1 if that is connected, or else of UART 1.", ()),
        "gpio_pins": Note("GPIO pins", "Features of each pin, according to MSCL.", (("Pin", "Features"), ("1", "GPIO, PPS, timestamp"), ("2", "GPIO, PPS, timestamp"), ("3", "GPIO, PPS, timestamp"), ("4", "GPIO, PPS, timestamp"))),
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
    incomplete=("No manual is known.",),
    generation=7,
)
"""Attitude and heading reference system. Generation 7. Model number 6701. Sensors: accelerometer,
gyroscope, magnetometer, pressure sensor. GNSS receivers: none. GNSS antennas: none. No manual is
known. This profile is incomplete: No manual is known. Uncertain: Only MSCL lists it; the SDK does
not.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


CX7_AR = Device(
    id="3dm-cx7-ar", title="3DM-CX7-AR", model_number=6700,
    description="Attitude reference.",
    evidence=(
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
            {0x0C: bytes.fromhex("28 41"), 0x0D: bytes.fromhex("50 53")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("01 02 03 04 06 07"), 0x0C: bytes.fromhex("0E 0F 30")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
            {0x01: bytes.fromhex("05 08 09 72 7E"), 0x0C: bytes.fromhex("0D 10 11 2A 2B 2C 2D 2E 2F 31 32 33 37 38 39 42 50 51 52 53 54"), 0x0D: bytes.fromhex("01 03 1A 1B 1D 20 28"), 0x13: bytes.fromhex("01 1F 31 32"), 0x80: bytes.fromhex("04 05 07 08 09 0A 0C 14 17 18"), 0x82: bytes.fromhex("03 04 05 06 0A 0B 0D 0E 10 12 13 1C 21"), 0xA0: bytes.fromhex("01 02 03"), 0xFF: bytes.fromhex("D0 D3 D4 D5 D6 D7 D8")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires a magnetometer, which the device lacks.",
            {0x0C: bytes.fromhex("3A 3B"), 0x0D: bytes.fromhex("27 2B 2C 42 43 45 46 4C 4D"), 0x80: bytes.fromhex("03 06"), 0x82: bytes.fromhex("1A 1B 25 26 28 29 2A 2C")}, absence='has no magnetometer'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
    ),
    base_rates={},
    ports=(
        Port("Main", 1, (), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(4, None, "Number of frames that the aiding frame configuration can define, according to MSCL."),
    },
    notes={
        "anti_aliasing": Note("Anti-aliasing low-pass filter", "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.", (("Set", "Descriptor", "Data"), ("0x80", "0x04", "Scaled accel"), ("0x80", "0x05", "Scaled gyro"), ("0x80", "0x06", "Scaled mag"), ("0x80", "0x17", "Scaled pressure"), ("0x82", "0x1C", "Compensated acceleration"), ("0x82", "0x0E", "Compensated angular rate"), ("0x82", "0x0D", "Linear acceleration"))),
        "ports": Note("Ports", "The main port is an alias of USB 1 if that is connected, or else of UART 1.", ()),
        "gpio_pins": Note("GPIO pins", "Features of each pin, according to MSCL.", (("Pin", "Features"), ("1", "GPIO, PPS, timestamp"), ("2", "GPIO, PPS, timestamp"), ("3", "GPIO, PPS, timestamp"), ("4", "GPIO, PPS, timestamp"))),
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
    incomplete=("No manual is known.",),
    generation=7,
)
"""Attitude reference. Generation 7. Model number 6700. Sensors: accelerometer, gyroscope, pressure
sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is incomplete:
No manual is known. Uncertain: Only MSCL lists it; the SDK does not.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


CX7_INS = Device(
    id="3dm-cx7-ins", title="3DM-CX7-INS", model_number=6702,
    description="Inertial navigation system.",
    evidence=(
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
            {0x0C: bytes.fromhex("28 41"), 0x0D: bytes.fromhex("43 50 53")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("01 02 03 04 06 07"), 0x0C: bytes.fromhex("0E 0F 30")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
            {0x01: bytes.fromhex("05 08 09 72 7E"), 0x0C: bytes.fromhex("04 0C 0D 10 11 2A 2B 2C 2D 2E 2F 31 32 33 37 38 39 3A 3B 42 50 51 52 53 54"), 0x0D: bytes.fromhex("01 03 05 13 15 17 1A 1B 1C 1D 1F 20 28 52 55 56"), 0x13: bytes.fromhex("01 1F 21 22 23 28 29 2A 31 32 33"), 0x80: bytes.fromhex("04 05 06 07 08 09 0A 0C 14 17 18"), 0x82: bytes.fromhex("01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 10 12 13 15 1C 21 36 37 40 41 42 43 46 50 51"), 0x94: bytes.fromhex("03 05 08 0B 20"), 0xA0: bytes.fromhex("01 02 03"), 0xFF: bytes.fromhex("D0 D3 D4 D5 D6 D7 D8")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
    ),
    base_rates={},
    ports=(
        Port("Main", 1, (), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (), ("MIP",), ("MIP",)),
        Port("UART 2", 18, (), ("MIP",), ("MIP",)),
        Port("UART 3", 19, (), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(4, None, "Number of frames that the aiding frame configuration can define, according to MSCL."),
    },
    notes={
        "anti_aliasing": Note("Anti-aliasing low-pass filter", "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.", (("Set", "Descriptor", "Data"), ("0x80", "0x04", "Scaled accel"), ("0x80", "0x05", "Scaled gyro"), ("0x80", "0x06", "Scaled mag"), ("0x80", "0x17", "Scaled pressure"), ("0x82", "0x1C", "Compensated acceleration"), ("0x82", "0x0E", "Compensated angular rate"), ("0x82", "0x0D", "Linear acceleration"))),
        "ports": Note("Ports", "The main port is an alias of USB 1 if that is connected, or else of UART 1. UART 2 is on the pins GPIO 1 and 2, UART 3 on GPIO 3 and 4.", ()),
        "gpio_pins": Note("GPIO pins", "Features of each pin, according to MSCL.", (("Pin", "Features"), ("1", "GPIO, PPS, timestamp, UART 2"), ("2", "GPIO, PPS, timestamp, UART 2"), ("3", "GPIO, PPS, timestamp, UART 3, encoder A"), ("4", "GPIO, PPS, timestamp, UART 3, encoder B"))),
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
    incomplete=("No manual is known.",),
    generation=7,
)
"""Inertial navigation system. Generation 7. Model number 6702. Sensors: accelerometer, gyroscope,
magnetometer, pressure sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This
profile is incomplete: No manual is known. Uncertain: Only MSCL lists it; the SDK does not.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


DH3 = Device(
    id="3dm-dh3", title="3DM-DH3", model_number=6219,
    description="Device of generation 3.",
    evidence=(
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
            {0x01: bytes.fromhex("01 02 03 04 06"), 0x0C: bytes.fromhex("11")}),
    ),
    base_rates={},
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    incomplete=("No manual is known.",),
    generation=3,
)
"""Device of generation 3. Generation 3. Model number 6219. No manual is known. This profile is
incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


GQ4_45 = Device(
    id="3dm-gq4-45", title="3DM-GQ4-45", model_number=6250,
    description="Tactical grade inertial navigation system with GNSS.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented.",
            {0x01: bytes.fromhex("01 02 03 04 05 06 72 7E"), 0x0C: bytes.fromhex("01 02 03 06 07 08 09 0A 0B 11 20 21 22 30 37 38 39 3A 3B 3E 40 50 51 64")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-RQ1-45-LT and 3DM-GX4-45.",
            {0x0D: bytes.fromhex("01 02 03 10 11 12 13 14 15 16 17 18 19 1A 1B 1C 1D 1E 1F 20 21 22 23 42 43 44 45 46"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("04 05 06"), 0x81: bytes.fromhex("03 05 09"), 0x82: bytes.fromhex("01 02 05")}),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
        Evidence(Support.NO, "hardware", "Requires 2 receivers, which the device lacks.",
            {0x92: bytes.fromhex("")}, absence='has fewer than 2 GNSS receivers'),
    ),
    base_rates={},
    notes={
        "direct_mode": Note("Direct modes", "`system.comm_mode` connects the port to the internal inertial sensor or to the receiver. The internal sensor replies as a separate device: 3DM-GX4-IMU in the 3DM-GX4-45, 3DM-RQ1-IMU in the 3DM-RQ1-45.", ()),
        "device_status": Note("Device status", "According to MSCL, it replies with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_gq4_45_response`.", ()),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    incomplete=("The manual's table of contents is known only up to the commands of the set `3dm`. The unknown part includes the sets `filter` and `system`.", "It has the data sets 0x80, 0x81 and 0x82, but none of their fields are known."),
    generation=4,
    manual="3dm-gq4-45",
)
"""Tactical grade inertial navigation system with GNSS. Generation 4. Model number 6250. Sensors:
accelerometer, gyroscope, magnetometer, pressure sensor. GNSS receivers: 1. GNSS antennas: 1.
Manual: LORD 3DM-GQ4-45 Data Communications Protocol, of September 26, 2015, known from its table of
contents. This profile is incomplete: The manual's table of contents is known only up to the
commands of the set `3dm`. The unknown part includes the sets `filter` and `system`. This profile is
incomplete: It has the data sets 0x80, 0x81 and 0x82, but none of their fields are known. Uncertain:
It may accept raw RTCM by a command whose layout is not known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


GQ7 = Device(
    id="3dm-gq7", title="3DM-GQ7-GNSS/INS", model_number=6284,
    description="Inertial navigation system with two GNSS receivers.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented (MicroStrain 3DM-GQ7 Documentation: Field pages, linked by the ROS messages).",
            {0x01: bytes.fromhex("03"), 0x0C: bytes.fromhex("42"), 0x80: bytes.fromhex("14"), 0xA0: bytes.fromhex("01")}),
        Evidence(Support.YES, "documented", "Documented (MicroStrain 3DM-GQ7 Documentation: Protocol Support and Specifications).",
            {0x01: bytes.fromhex("04 07 09"), 0x0C: bytes.fromhex("0E 50 54")}),
        Evidence(Support.YES, "documented", "Documented.",
            {0x0C: bytes.fromhex("04 31 39"), 0x0D: bytes.fromhex("05 15 1E 20 43 52 64"), 0x91: bytes.fromhex("03 0B"), 0x92: bytes.fromhex("0D")}),
        Evidence(Support.YES, "documented", "Documented (MicroStrain 3DM-GQ7 Documentation: Field pages, linked by the wiki of the ROS driver).",
            {0x80: bytes.fromhex("04 05 06 07 08 0A 12 17 18 40"), 0x82: bytes.fromhex("01 02 03 05 08 09 0A 0D 0E 10 1C 34 36 37 40 41 42 43 46 49"), 0x91: bytes.fromhex("04 05 06 12 14"), 0x92: bytes.fromhex("03 04 05 06 12 14"), 0x93: bytes.fromhex("30 31"), 0xFF: bytes.fromhex("D3")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            {0x01: bytes.fromhex("01 02 06"), 0x0C: bytes.fromhex("0F 30"), 0x0D: bytes.fromhex("01 50 54 63"), 0x92: bytes.fromhex("0B")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (ROS driver of the vendor: Example configurations).",
            {0x0C: bytes.fromhex("0C 10 22 28 41 43"), 0x0D: bytes.fromhex("53 55 56 61"), 0x0E: bytes.fromhex("02 10")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (PX4: Driver of the vendor's sensors).",
            {0x91: bytes.fromhex("07 11"), 0x92: bytes.fromhex("07 11")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
            {0x01: bytes.fromhex("05 08 72 7E"), 0x0C: bytes.fromhex("0D 11 2A 2B 2C 2D 2E 2F 32 33 37 38 3A 3B 51 52 53"), 0x0D: bytes.fromhex("03 17 1A 1B 1C 1D 1F 28"), 0x0E: bytes.fromhex("01"), 0x13: bytes.fromhex("01 1F 31"), 0x80: bytes.fromhex("09 0C"), 0x82: bytes.fromhex("04 06 07 0B 0C 12 13 15 21 35 47 48"), 0x91: bytes.fromhex("08 09 0D 10 20 22 61 62 63 64"), 0x92: bytes.fromhex("08 09 10 20 22 61 62 63 64"), 0xA0: bytes.fromhex("02 03"), 0xFF: bytes.fromhex("D0 D4 D5 D6 D7 D8")}),
    ),
    firmware={
        (0x0C, 0x50): "<= 1.0.10",
        (0x0C, 0x54): "> 1.0.10",
        (0x0E, 0x02): "> 1.0.10",
        (0xA0, 0x01): "> 1.0.10",
        (0xA0, 0x02): "> 1.0.10",
        (0xA0, 0x03): "> 1.0.10",
    },
    base_rates={0x80: 1000, 0x82: 1000, 0xA0: 1000, 0x91: 2, 0x92: 2, 0x93: 0},
    ports=(
        Port("Main", 1, (115200, 230400, 460800, 921600), ("MIP", "NMEA"), ("MIP", "NMEA")),
        Port("Aux", 2, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "nmea_rate": Limit(10, "Hz", "Maximum rate of an NMEA sentence, according to MSCL."),
    },
    notes={
        "anti_aliasing": Note("Anti-aliasing low-pass filter", "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.", (("Set", "Descriptor", "Data"), ("0x80", "0x04", "Scaled accel"), ("0x80", "0x05", "Scaled gyro"), ("0x80", "0x06", "Scaled mag"), ("0x80", "0x17", "Scaled pressure"), ("0x82", "0x1C", "Compensated acceleration"), ("0x82", "0x0E", "Compensated angular rate"), ("0x82", "0x0D", "Linear acceleration"))),
        "gpio_pins": Note("GPIO pins", "Features of each pin, according to MSCL.", (("Pin", "Connector pin", "Features"), ("1", "primary 7", "GPIO, PPS, encoder A"), ("2", "primary 9", "GPIO, encoder B"), ("3", "auxiliary 7", "GPIO, PPS"), ("4", "auxiliary 9", "GPIO"))),
        "nmea_output": Note("NMEA output", "Sentences are GGA, GLL, GSV, RMC, VTG, HDT, ZDA, and the proprietary PMSRA and PMSRR.", ()),
        "gnss_signals": Note("GNSS signals", "Signals that can be enabled together by `gnss.signal_config`, according to MSCL.", (("Constellation", "Choices"), ("GPS", "none, L1 C/A + L2C"), ("GLONASS", "none, L1 + L2"), ("Galileo", "none, E1 + E5b"), ("BeiDou", "none, B1 + B2"))),
        "receivers": Note("GNSS sets", "The set 0x91 belongs to the first receiver and 0x92 to the second; 0x93 contains the RTK corrections.", ()),
    },
    readings={
        "base.built_in_test_response.result": types.Cv7BuiltInTest,
        "base.continuous_built_in_test_response.result": types.Gq7ContinuousBuiltInTest,
        "filter_data.status.filter_state": filter_data.Cv7FilterState,
        "filter_data.status.dynamics_mode": filter_data.Cv7DynamicsMode,
        "filter_data.status.status_flags": filter_data.Cv7StatusFlags,
        "system_data.built_in_test.result": types.Gq7ContinuousBuiltInTest,
    },
    incomplete=("Only some pages of its manual are known; the device has further commands and data.", "The baud rates of the Aux port are not known, nor all of its protocols."),
    also=("3DM-GQ7",),
    generation=7,
    manual="3dm-gq7",
)
"""Inertial navigation system with two GNSS receivers. Also called 3DM-GQ7. Generation 7. Model
number 6284. Sensors: accelerometer, gyroscope, magnetometer, pressure sensor. GNSS receivers: 2.
GNSS antennas: 2. Manual: MicroStrain 3DM-GQ7 Documentation, online, known from some pages. This
profile is incomplete: Only some pages of its manual are known; the device has further commands and
data. This profile is incomplete: The baud rates of the Aux port are not known, nor all of its
protocols. Uncertain: The values of `filter.MagneticDeclinationSource` are those that MSCL offers.
Uncertain: According to MSCL, firmware from 1.0 to below 1.1 has only the values `all_internal` and
`external` of `filter.GnssSource`.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


GV7_AHRS = Device(
    id="3dm-gv7-ahrs", title="3DM-GV7-AHRS", model_number=6288,
    description="Attitude and heading reference system.",
    evidence=(
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("01 02 03 06"), 0x0C: bytes.fromhex("0E 0F 2B 2E 2F 30 31 39"), 0x0D: bytes.fromhex("01 50"), 0x82: bytes.fromhex("05 10"), 0xFF: bytes.fromhex("D0 D3")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (ROS driver of the vendor: Example configurations).",
            {0x0C: bytes.fromhex("28"), 0x0D: bytes.fromhex("43 53"), 0xA0: bytes.fromhex("02")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
            {0x0C: bytes.fromhex("41")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("04 07")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
            {0x01: bytes.fromhex("05 08 09 72 7E"), 0x0C: bytes.fromhex("0D 10 11 2A 2C 2D 32 33 37 38 3A 3B 42 50 51 52 53 54"), 0x0D: bytes.fromhex("03 1A 1B 1D 20 28"), 0x13: bytes.fromhex("01 1F 31 32"), 0x80: bytes.fromhex("04 05 06 07 08 09 0A 0C 14 17 18"), 0x82: bytes.fromhex("03 04 06 0A 0B 0D 0E 12 13 1C 21"), 0xA0: bytes.fromhex("01 03"), 0xFF: bytes.fromhex("D4 D5 D6 D7 D8")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
    ),
    base_rates={},
    ports=(
        Port("Main", 1, (), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(4, None, "Number of frames that the aiding frame configuration can define, according to MSCL."),
    },
    notes={
        "anti_aliasing": Note("Anti-aliasing low-pass filter", "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.", (("Set", "Descriptor", "Data"), ("0x80", "0x04", "Scaled accel"), ("0x80", "0x05", "Scaled gyro"), ("0x80", "0x06", "Scaled mag"), ("0x80", "0x17", "Scaled pressure"), ("0x82", "0x1C", "Compensated acceleration"), ("0x82", "0x0E", "Compensated angular rate"), ("0x82", "0x0D", "Linear acceleration"))),
        "ports": Note("Ports", "The main port is an alias of USB 1 if that is connected, or else of UART 1.", ()),
        "gpio_pins": Note("GPIO pins", "Features of each pin, according to MSCL.", (("Pin", "Features"), ("1", "GPIO, PPS, timestamp"), ("2", "GPIO, PPS, timestamp"))),
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
    incomplete=("No manual is known.",),
    generation=7,
)
"""Attitude and heading reference system. Generation 7. Model number 6288. Sensors: accelerometer,
gyroscope, magnetometer, pressure sensor. GNSS receivers: none. GNSS antennas: none. No manual is
known. This profile is incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


GV7_AR = Device(
    id="3dm-gv7-ar", title="3DM-GV7-AR", model_number=6289,
    description="Attitude reference.",
    evidence=(
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("01 02 03 06"), 0x0C: bytes.fromhex("0E 0F 2B 2E 2F 30 31 39"), 0x0D: bytes.fromhex("01"), 0x82: bytes.fromhex("05 10"), 0xFF: bytes.fromhex("D0 D3")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (ROS driver of the vendor: Example configurations).",
            {0x0C: bytes.fromhex("28"), 0x0D: bytes.fromhex("50 53"), 0xA0: bytes.fromhex("02")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
            {0x0C: bytes.fromhex("41")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("04 07")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
            {0x01: bytes.fromhex("05 08 09 72 7E"), 0x0C: bytes.fromhex("0D 10 11 2A 2C 2D 32 33 37 38 42 50 51 52 53 54"), 0x0D: bytes.fromhex("03 1A 1B 1D 20 28"), 0x13: bytes.fromhex("01 1F 31 32"), 0x80: bytes.fromhex("04 05 07 08 09 0A 0C 14 17 18"), 0x82: bytes.fromhex("03 04 06 0A 0B 0D 0E 12 13 1C 21"), 0xA0: bytes.fromhex("01 03"), 0xFF: bytes.fromhex("D4 D5 D6 D7 D8")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires a magnetometer, which the device lacks.",
            {0x0C: bytes.fromhex("3A 3B"), 0x0D: bytes.fromhex("27 2B 2C 42 43 45 46 4C 4D"), 0x80: bytes.fromhex("03 06"), 0x82: bytes.fromhex("1A 1B 25 26 28 29 2A 2C")}, absence='has no magnetometer'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
    ),
    base_rates={},
    ports=(
        Port("Main", 1, (), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(4, None, "Number of frames that the aiding frame configuration can define, according to MSCL."),
    },
    notes={
        "anti_aliasing": Note("Anti-aliasing low-pass filter", "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.", (("Set", "Descriptor", "Data"), ("0x80", "0x04", "Scaled accel"), ("0x80", "0x05", "Scaled gyro"), ("0x80", "0x06", "Scaled mag"), ("0x80", "0x17", "Scaled pressure"), ("0x82", "0x1C", "Compensated acceleration"), ("0x82", "0x0E", "Compensated angular rate"), ("0x82", "0x0D", "Linear acceleration"))),
        "ports": Note("Ports", "The main port is an alias of USB 1 if that is connected, or else of UART 1.", ()),
        "gpio_pins": Note("GPIO pins", "Features of each pin, according to MSCL.", (("Pin", "Features"), ("1", "GPIO, PPS, timestamp"), ("2", "GPIO, PPS, timestamp"))),
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
    incomplete=("No manual is known.",),
    generation=7,
)
"""Attitude reference. Generation 7. Model number 6289. Sensors: accelerometer, gyroscope, pressure
sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is incomplete:
No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


GV7_INS = Device(
    id="3dm-gv7-ins", title="3DM-GV7-INS", model_number=6290,
    description="Inertial navigation system.",
    evidence=(
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("01 02 03 06"), 0x0C: bytes.fromhex("0E 0F 30 39"), 0x0D: bytes.fromhex("01 50 52"), 0x13: bytes.fromhex("01 22 29 2A 31"), 0x82: bytes.fromhex("01 02 05 10"), 0xFF: bytes.fromhex("D3")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (ROS driver of the vendor: Example configurations).",
            {0x01: bytes.fromhex("09"), 0x0C: bytes.fromhex("28 41 42"), 0x0D: bytes.fromhex("13 43 55"), 0x82: bytes.fromhex("36 40 42 46")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
            {0x0D: bytes.fromhex("53")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("04 07")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation, 3DM-CV7-GNSS/INS.",
            {0x01: bytes.fromhex("05 08 72 7E"), 0x0C: bytes.fromhex("04 0C 0D 10 11 2A 2B 2C 2D 2E 2F 31 32 33 37 38 3A 3B 50 51 52 53 54"), 0x0D: bytes.fromhex("03 05 15 17 1A 1B 1C 1D 1F 20 28 56"), 0x13: bytes.fromhex("1F 21 23 28 32 33"), 0x80: bytes.fromhex("04 05 06 07 08 09 0A 0C 14 17 18"), 0x82: bytes.fromhex("03 04 06 07 08 09 0A 0B 0C 0D 0E 12 13 15 1C 21 37 41 43 50 51"), 0x94: bytes.fromhex("03 05 08 0B 20"), 0xA0: bytes.fromhex("01 02 03"), 0xFF: bytes.fromhex("D0 D4 D5 D6 D7 D8")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
    ),
    base_rates={},
    ports=(
        Port("Main", 1, (), ("MIP",), ("MIP",)),
        Port("UART 1", 17, (), ("MIP",), ("MIP",)),
        Port("UART 2", 18, (), ("MIP",), ("MIP",)),
        Port("USB 1", 33, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "aiding_frames": Limit(4, None, "Number of frames that the aiding frame configuration can define, according to MSCL."),
    },
    notes={
        "anti_aliasing": Note("Anti-aliasing low-pass filter", "Data that `3dm.low_pass_filter` can filter on the 3DM-CV7 and the 3DM-GQ7, and so probably on the others; `3dm.imu_low_pass_filter` filters sensor data only.", (("Set", "Descriptor", "Data"), ("0x80", "0x04", "Scaled accel"), ("0x80", "0x05", "Scaled gyro"), ("0x80", "0x06", "Scaled mag"), ("0x80", "0x17", "Scaled pressure"), ("0x82", "0x1C", "Compensated acceleration"), ("0x82", "0x0E", "Compensated angular rate"), ("0x82", "0x0D", "Linear acceleration"))),
        "ports": Note("Ports", "The main port is an alias of USB 1 if that is connected, or else of UART 1. UART 2 is on the pins GPIO 1 and 2.", ()),
        "gpio_pins": Note("GPIO pins", "Features of each pin, according to MSCL.", (("Pin", "Features"), ("1", "GPIO, PPS, timestamp, UART 2"), ("2", "GPIO, PPS, timestamp, UART 2"))),
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
    incomplete=("No manual is known.",),
    generation=7,
)
"""Inertial navigation system. Generation 7. Model number 6290. Sensors: accelerometer, gyroscope,
magnetometer, pressure sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This
profile is incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


GX3_15 = Device(
    id="3dm-gx3-15", title="3DM-GX3-15", model_number=6227,
    description="Inertial sensor of generation 3.",
    evidence=(
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
            {0x0C: bytes.fromhex("35")}, ((12, 60),)),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX3-35.",
            {0x01: bytes.fromhex("01 02 03 04 05 06"), 0x0C: bytes.fromhex("01 06 08 11 36 61 64"), 0x80: bytes.fromhex("04 05")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires a magnetometer, which the device lacks.",
            {0x0C: bytes.fromhex("3A 3B"), 0x80: bytes.fromhex("03 06")}, absence='has no magnetometer'),
        Evidence(Support.NO, "hardware", "Requires a pressure sensor, which the device lacks.",
            {0x80: bytes.fromhex("16 17")}, absence='has no pressure sensor'),
    ),
    base_rates={},
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    incomplete=("Its manual (8500-0024, revision 002 of 2012, for firmware 2.0.00 and later) is not known.",),
    generation=3,
)
"""Inertial sensor of generation 3. Generation 3. Model number 6227. Sensors: accelerometer,
gyroscope. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is
incomplete: Its manual (8500-0024, revision 002 of 2012, for firmware 2.0.00 and later) is not
known. Uncertain: The sensors are inferred from the name of the model; that it has no magnetometer
also from MSCL, which offers it no north compensation.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


GX3_25 = Device(
    id="3dm-gx3-25", title="3DM-GX3-25", model_number=6223,
    description="Inertial sensor of generation 3.",
    evidence=(
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
            {0x0C: bytes.fromhex("35")}, ((12, 60), (12, 61))),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MIP SDK of 2014: Examples, one for each model).",
            {0x0C: bytes.fromhex("61")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX3-35.",
            {0x01: bytes.fromhex("01 02 03 04 05 06"), 0x0C: bytes.fromhex("01 06 08 11 36 64"), 0x80: bytes.fromhex("04 05 06")}),
        Evidence(Support.NO, "refused", "Rejected by the device (ROS driver of the vendor: Issue 347).",
            {0x0C: bytes.fromhex("0C 22 43"), 0x0D: bytes.fromhex("10 13 43 54"), 0x0E: bytes.fromhex("02 10"), 0x82: bytes.fromhex("01 02 03 08 09 0A 0E 10 36 37 40 41")}),
        Evidence(Support.NO, "refused", "Rejected by the device (firmware 2.0.06; ROS driver of the vendor: Issue 213).",
            {0x81: bytes.fromhex("03 05 0B"), 0x82: bytes.fromhex("43"), 0x91: bytes.fromhex("03 05 0B")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 23 24 34 62"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires a pressure sensor, which the device lacks.",
            {0x80: bytes.fromhex("16 17")}, absence='has no pressure sensor'),
    ),
    base_rates={},
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
    },
    incomplete=("Its manual (8500-0024, revision 002 of 2012, for firmware 2.0.00 and later) is not known.",),
    generation=3,
)
"""Inertial sensor of generation 3. Generation 3. Model number 6223. Sensors: accelerometer,
gyroscope, magnetometer. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile
is incomplete: Its manual (8500-0024, revision 002 of 2012, for firmware 2.0.00 and later) is not
known. Uncertain: The sensors are inferred from the name of the model.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


GX3_35 = Device(
    id="3dm-gx3-35", title="3DM-GX3-35", model_number=6225,
    description="Inertial sensor of generation 3.",
    evidence=(
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
            {0x01: bytes.fromhex("01 02 03 04 05 06"), 0x0C: bytes.fromhex("01 02 06 07 08 09 11 34 35 36 60 61 64"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("04 05 06"), 0x81: bytes.fromhex("03 05 09")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MIP SDK of 2014: Examples, one for each model).",
            {0x0C: bytes.fromhex("62")}),
        Evidence(Support.NO, "hardware", "Requires a pressure sensor, which the device lacks.",
            {0x80: bytes.fromhex("16 17")}, absence='has no pressure sensor'),
        Evidence(Support.NO, "hardware", "Requires 2 receivers, which the device lacks.",
            {0x92: bytes.fromhex("")}, absence='has fewer than 2 GNSS receivers'),
    ),
    base_rates={},
    notes={
        "receiver": Note("Receiver", "The GNSS receiver is made by u-blox.", ()),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    incomplete=("Its manual (1.00 of 2011-01-04) is not known.",),
    generation=3,
)
"""Inertial sensor of generation 3. Generation 3. Model number 6225. Sensors: accelerometer,
gyroscope, magnetometer. GNSS receivers: 1. GNSS antennas: 1. No manual is known. This profile is
incomplete: Its manual (1.00 of 2011-01-04) is not known. Uncertain: The sensors are inferred from
the name of the model.

- mip-sdk-4: Device models
- mscl: MIP node features
- mip-sdk-2014: Example of the 3DM-GX3-35
"""


GX3_45 = Device(
    id="3dm-gx3-45", title="3DM-GX3-45", model_number=6228,
    description="Inertial sensor of generation 3.",
    evidence=(
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
            {0x01: bytes.fromhex("01 02 03 04 05"), 0x0C: bytes.fromhex("06 07 08 09 0A 0B 11"), 0x0D: bytes.fromhex("01 02 03 04 10 11 12 13 14 15 18 19 1A 1B 1D"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("04 05 06"), 0x81: bytes.fromhex("03 05 09"), 0x82: bytes.fromhex("01 02 05")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
            {0x0D: bytes.fromhex("44 45")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX3-35.",
            {0x01: bytes.fromhex("06"), 0x0C: bytes.fromhex("01 02 35 36 64")}),
        Evidence(Support.NO, "hardware", "Requires a pressure sensor, which the device lacks.",
            {0x0D: bytes.fromhex("29 47"), 0x80: bytes.fromhex("16 17"), 0x82: bytes.fromhex("21")}, absence='has no pressure sensor'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
        Evidence(Support.NO, "hardware", "Requires 2 receivers, which the device lacks.",
            {0x92: bytes.fromhex("")}, absence='has fewer than 2 GNSS receivers'),
    ),
    base_rates={},
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    incomplete=("No manual is known.",),
    generation=3,
)
"""Inertial sensor of generation 3. Generation 3. Model number 6228. Sensors: accelerometer,
gyroscope, magnetometer. GNSS receivers: 1. GNSS antennas: 1. No manual is known. This profile is
incomplete: No manual is known. Uncertain: The SDK of 2014 has the model number 6226. Uncertain: The
sensors are inferred from the name of the model.

- mip-sdk-4: Device models
- mscl: MIP node features
- mip-sdk-2014: Example of the 3DM-GX3-45
"""


GX4_15 = Device(
    id="3dm-gx4-15", title="3DM-GX4-15", model_number=6233,
    description="Device of generation 4.",
    evidence=(
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
            {0x01: bytes.fromhex("01 02 03 04 05"), 0x0C: bytes.fromhex("01 03 06 08 0A 0B 11 37 38 39 51 64"), 0x0D: bytes.fromhex("01 02 03 14 19 1A 1B 1D 20 21 23 26 44"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("04 05"), 0x82: bytes.fromhex("05")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX4-25.",
            {0x01: bytes.fromhex("06 7E"), 0x0C: bytes.fromhex("30 3E 40 50"), 0x80: bytes.fromhex("07 08 09 0A 0C 10 11 12 17"), 0x82: bytes.fromhex("03 04 06 0A 0B 0D 0E 0F 10 11 12 13")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires a magnetometer, which the device lacks.",
            {0x0C: bytes.fromhex("3A 3B"), 0x0D: bytes.fromhex("27 2B 2C 42 43 45 46 4C 4D"), 0x80: bytes.fromhex("03 06"), 0x82: bytes.fromhex("1A 1B 25 26 28 29 2A 2C")}, absence='has no magnetometer'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
    ),
    base_rates={},
    notes={
        "direct_mode": Note("Direct modes", "`system.comm_mode` connects the port to the internal inertial sensor or to the receiver. The internal sensor replies as a separate device: 3DM-GX4-IMU in the 3DM-GX4-45, 3DM-RQ1-IMU in the 3DM-RQ1-45.", ()),
        "device_status": Note("Device status", "According to MSCL, it replies with `3dm.device_status_basic_without_state_response` and `3dm.device_status_diagnostic_gx4_response`.", ()),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    incomplete=("No manual is known.",),
    generation=4,
)
"""Device of generation 4. Generation 4. Model number 6233. Sensors: accelerometer, gyroscope,
pressure sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This profile is
incomplete: No manual is known. Uncertain: The sensors are inferred from the name of the model; that
it has no magnetometer also from MSCL, which offers it no north compensation.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


GX4_25 = Device(
    id="3dm-gx4-25", title="3DM-GX4-25", model_number=6234,
    description="Device of generation 4.",
    evidence=(
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
            {0x01: bytes.fromhex("01 02 03 04 05"), 0x0C: bytes.fromhex("01 03 06 08 0A 0B 11 37 38 39 3A 3B 51 64"), 0x0D: bytes.fromhex("01 02 03 11 14 17 18 19 1A 1B 1D 1F 20 21 23 26 42 43 44 45 46"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("04 05 06"), 0x82: bytes.fromhex("05")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (Public programs of users: Driver imu_3dm_gx4).",
            {0x01: bytes.fromhex("06"), 0x0C: bytes.fromhex("40"), 0x0D: bytes.fromhex("41"), 0x80: bytes.fromhex("17"), 0x82: bytes.fromhex("03 06 0A 0B")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX5-25.",
            {0x01: bytes.fromhex("7E"), 0x0C: bytes.fromhex("30 3E 50"), 0x80: bytes.fromhex("07 08 09 0A 0C 10 11 12"), 0x82: bytes.fromhex("04 0D 0E 0F 10 11 12 13 14 15")}),
        Evidence(Support.NO, "refused", "Rejected by the device (MicroStrain Communication Library: Issue 30).",
            {0x82: bytes.fromhex("07")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
    ),
    base_rates={0x80: 1000, 0x82: 500},
    notes={
        "direct_mode": Note("Direct modes", "`system.comm_mode` connects the port to the internal inertial sensor or to the receiver. The internal sensor replies as a separate device: 3DM-GX4-IMU in the 3DM-GX4-45, 3DM-RQ1-IMU in the 3DM-RQ1-45.", ()),
        "device_status": Note("Device status", "According to MSCL, it replies with `3dm.device_status_basic_without_state_response` and `3dm.device_status_diagnostic_gx4_response`.", ()),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    incomplete=("Its manual (of 2014-12-23) is not known.",),
    generation=4,
)
"""Device of generation 4. Generation 4. Model number 6234. Sensors: accelerometer, gyroscope,
magnetometer, pressure sensor. GNSS receivers: none. GNSS antennas: none. No manual is known. This
profile is incomplete: Its manual (of 2014-12-23) is not known. Uncertain: A third-party ROS driver
uses the model number 6253 for it, which is that of the 3DM-GX5-25. Uncertain: The sensors are
inferred from the name of the model.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


GX4_45 = Device(
    id="3dm-gx4-45", title="3DM-GX4-45", model_number=6236,
    description="Device of generation 4.",
    evidence=(
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
            {0x01: bytes.fromhex("01 02 03 04 05"), 0x0C: bytes.fromhex("01 02 03 06 07 08 09 0A 0B 11 37 38 39 3A 3B 51 64"), 0x0D: bytes.fromhex("01 02 03 10 11 12 13 14 15 16 17 18 19 1A 1B 1C 1D 1E 1F 20 21 22 23 42 43 44 45 46"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("04 05 06"), 0x81: bytes.fromhex("03 05 09"), 0x82: bytes.fromhex("01 02 05")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX5-25.",
            {0x01: bytes.fromhex("06 7E"), 0x0C: bytes.fromhex("30 3E 40 50"), 0x80: bytes.fromhex("07 08 09 0A 0C 10 11 12 17"), 0x82: bytes.fromhex("03 04 06 0A 0B 0D 0E 0F 10 11 12 13 14 15")}),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
        Evidence(Support.NO, "hardware", "Requires 2 receivers, which the device lacks.",
            {0x92: bytes.fromhex("")}, absence='has fewer than 2 GNSS receivers'),
    ),
    base_rates={},
    notes={
        "direct_mode": Note("Direct modes", "`system.comm_mode` connects the port to the internal inertial sensor or to the receiver. The internal sensor replies as a separate device: 3DM-GX4-IMU in the 3DM-GX4-45, 3DM-RQ1-IMU in the 3DM-RQ1-45.", ()),
        "device_status": Note("Device status", "According to MSCL, it replies with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_gnss_response`.", ()),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.device_status_basic_response.system_state": mip_3dm.Gx4SystemState,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    incomplete=("No manual is known.",),
    generation=4,
)
"""Device of generation 4. Generation 4. Model number 6236. Sensors: accelerometer, gyroscope,
magnetometer, pressure sensor. GNSS receivers: 1. GNSS antennas: 1. No manual is known. This profile
is incomplete: No manual is known. Uncertain: The sensors are inferred from the name of the model.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


GX4_IMU = Device(
    id="3dm-gx4-imu", title="3DM-GX4-IMU", model_number=6237,
    description="Inertial sensor inside the 3DM-GX4-45, which replies in the direct mode.",
    evidence=(
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
            {0x01: bytes.fromhex("01 02 03 04 05"), 0x0C: bytes.fromhex("01 06 08 37 38 39 3A 3B 3E 64"), 0x7F: bytes.fromhex("10")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation, 3DM-GX4-25.",
            {0x01: bytes.fromhex("06")}),
    ),
    base_rates={},
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    incomplete=("No manual is known.",),
    generation=4,
)
"""Inertial sensor inside the 3DM-GX4-45, which replies in the direct mode. Generation 4. Model
number 6237. No manual is known. This profile is incomplete: No manual is known.

- mip-sdk-2014: GX4 IMU
"""


GX5_15 = Device(
    id="3dm-gx5-15", title="3DM-GX5-15", model_number=6254,
    description="Vertical reference unit with an inertial sensor, a pressure sensor and an estimation filter.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented.",
            {0x01: bytes.fromhex("01 02 03 04 05 06 07 72 7E"), 0x0C: bytes.fromhex("01 03 06 08 0A 0B 11 30 37 38 39 3E 40 50 51 64"), 0x0D: bytes.fromhex("01 02 03 11 14 17 18 19 1A 1B 1D 1F 20 21 23 26 28 41 44 4B"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("04 05 07 08 09 0A 0C 10 11 12 17"), 0x82: bytes.fromhex("03 04 05 06 0A 0B 0D 0E 0F 10 11 12 13 14 1C 21")}),
        Evidence(Support.NO, "refused", "Rejected by the device (MicroStrain Communication Library: Issue 301).",
            {0x80: bytes.fromhex("01 02")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires a magnetometer, which the device lacks.",
            {0x0C: bytes.fromhex("3A 3B"), 0x0D: bytes.fromhex("27 2B 2C 42 43 45 46 4C 4D"), 0x80: bytes.fromhex("03 06"), 0x82: bytes.fromhex("1A 1B 25 26 28 29 2A 2C")}, absence='has no magnetometer'),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
    ),
    functions={
        (0x0D, 0x21): "WSLD",
    },
    base_rates={0x80: 1000, 0x82: 500},
    ports=(
        Port("UART 1", None, (9600, 19200, 115200, 230400, 460800, 921600), ("MIP",), ("MIP",)),
        Port("USB", None, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "low_pass_cutoff": Limit(250, "Hz", "Maximum cutoff frequency of the low-pass filters."),
        "external_heading_rate": Limit(20, "Hz", "Maximum rate of external heading updates."),
        "zero_angular_rate_update_rate": Limit(10, "Hz", "Maximum rate of commanded zero angular rate updates."),
        "baud_rate_delay": Limit(250, "ms", "Time from the ACK of a new baud rate until the device replies to commands at that rate."),
    },
    notes={
        "base_rates": Note("Base rates", "The manual states both 1000 and 500 for each stream. Read the base rates from the device before computing a decimation.", ()),
        "frames": Note("Frame of the sensor data", "`filter.sensor_to_vehicle_rotation_euler` rotates scaled acceleration and angular rate, delta theta and delta velocity, as well as the outputs of the estimation filter other than the gyroscope bias. Until it is set, they are in the sensor frame. It does not rotate the outputs of the complementary filter.", ()),
        "low_pass_filter": Note("Low-pass filter", "Data that `3dm.imu_low_pass_filter` can select.", (("Set", "Descriptor", "Data"), ("0x80", "0x04", "Scaled accel"), ("0x80", "0x05", "Scaled gyro"), ("0x80", "0x17", "Scaled pressure"))),
        "uart": Note("UART", "The default baud rate is 115200. There is no handshake; data that does not fit is dropped.", ()),
        "time": Note("Time synchronization", "Connect the PPS signal to pin 7 of the connector, and send `base.gps_time_update` once per second. The filter and sensor timestamps are then synchronized with them.", ()),
        "direct_mode": Note("Direct mode", "`system.comm_mode` connects the port to the internal inertial sensor. Meanwhile, only that command and `3dm.device_status` are available.", ()),
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
    also=("3DM-GX5-AR",),
    generation=5,
    manual="3dm-gx5-15",
)
"""Vertical reference unit with an inertial sensor, a pressure sensor and an estimation filter. Also
called 3DM-GX5-AR. Generation 5. Model number 6254. Sensors: accelerometer, gyroscope, pressure
sensor. GNSS receivers: none. GNSS antennas: none. Manual: LORD Sensing 3DM-GX5-15 Data
Communications Protocol, 8500-0067 rev. E.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


GX5_25 = Device(
    id="3dm-gx5-25", title="3DM-GX5-25", model_number=6253,
    description="Attitude and heading reference system.",
    evidence=(
        Evidence(Support.LIKELY, "transcribed", "Transcribed from the manual by others (Public programs of users: Parser of 3DM-GX5-25 data in MATLAB, 2018).",
            {0x80: bytes.fromhex("04 05 06 07 08 09 0A 0C 10 11 12 17"), 0x82: bytes.fromhex("03 04 05 06 0A 0B 0D 0E 0F 10 11 12 13 14 15 1C 21 25 26 28 29")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            {0x01: bytes.fromhex("01 02 06"), 0x0C: bytes.fromhex("06 08 0A 0B 30 39"), 0x0D: bytes.fromhex("11 19")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("03"), 0x0D: bytes.fromhex("01 18")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (ROS driver microstrain_mips: Table of tested functions).",
            {0x0C: bytes.fromhex("11 37 38 3A 3B 3E 51 64"), 0x0D: bytes.fromhex("02 03 14 1A 1B 1D 1E 20 21 26 44"), 0x7F: bytes.fromhex("10")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (ROS driver microstrain_mips: Conditions by model).",
            {0x0D: bytes.fromhex("42 45")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("04 07")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-GX5-45.",
            {0x01: bytes.fromhex("05 72 7E"), 0x0C: bytes.fromhex("01 03 40 50"), 0x0D: bytes.fromhex("17 1F 23 27 28 29 2B 2C 41 43 46 47 4B")}),
        Evidence(Support.NO, "refused", "Rejected by the device (ROS driver of the vendor: Issue 238).",
            {0x0C: bytes.fromhex("41"), 0x81: bytes.fromhex("03 0B"), 0x82: bytes.fromhex("43 49"), 0x91: bytes.fromhex("03 0B"), 0x93: bytes.fromhex("31")}),
        Evidence(Support.NO, "refused", "Rejected by the device (firmware 1.1.76; ROS driver of the vendor: Issue 368).",
            {0x80: bytes.fromhex("18"), 0x82: bytes.fromhex("01 08"), 0x92: bytes.fromhex("0B 12 14")}),
        Evidence(Support.NO, "refused", "Rejected by the device (ROS driver of the vendor: Issue 59; MicroStrain Communication Library: Issue 200).",
            {0x82: bytes.fromhex("02")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x0D: bytes.fromhex("54 64"), 0x82: bytes.fromhex("34 35"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
    ),
    base_rates={},
    notes={
        "device_status": Note("Device status", "According to MSCL, it replies with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_response`.", ()),
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
    incomplete=("Its manual (8500-0065) is not known.",),
    also=("3DM-GX5-AHRS",),
    generation=5,
)
"""Attitude and heading reference system. Also called 3DM-GX5-AHRS. Generation 5. Model number 6253.
Sensors: accelerometer, gyroscope, magnetometer, pressure sensor. GNSS receivers: none. GNSS
antennas: none. No manual is known. This profile is incomplete: Its manual (8500-0065) is not known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


GX5_35 = Device(
    id="3dm-gx5-35", title="3DM-GX5-35", model_number=6252,
    description="Attitude and heading reference system (AHRS) with GNSS.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented.",
            {0x01: bytes.fromhex("01 03 04 07 72"), 0x0C: bytes.fromhex("01 07 08 09 11 21 22 23 24 30 37 39 3B 51 64"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("04 05 06 07 11 12 17"), 0x81: bytes.fromhex("06 0E")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("02 06"), 0x0C: bytes.fromhex("06")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-GX5-45.",
            {0x01: bytes.fromhex("05 7E"), 0x0C: bytes.fromhex("02 38 3A 3E 40 50"), 0x80: bytes.fromhex("08 09 0A 0C 10"), 0x81: bytes.fromhex("03 04 05 07 08 09 0A 0B 0C 0D 0F")}),
        Evidence(Support.NO, "hardware", "Requires 2 receivers, which the device lacks.",
            {0x92: bytes.fromhex("")}, absence='has fewer than 2 GNSS receivers'),
    ),
    base_rates={0x80: 500, 0x81: 4},
    limits={
        "reserved_gnss_channels": Limit(32, None, "Sum of the channels that constellations reserve."),
    },
    notes={
        "receiver": Note("Receiver", "The GNSS receiver is a u-blox M8M. GLONASS and BeiDou cannot be used together.", ()),
        "streams": Note("Streams", "The manual lists the selectors of the sensor and the filter stream, though the device has no filter.", ()),
        "device_status": Note("Device status", "It replies with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_gnss_response`.", ()),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
    },
    incomplete=("Only some pages of its manual are known; the device has further commands and data.",),
    also=("3DM-GX5-GNSS/AHRS",),
    generation=5,
    manual="3dm-gx5-35",
)
"""Attitude and heading reference system (AHRS) with GNSS. Also called 3DM-GX5-GNSS/AHRS. Generation
5. Model number 6252. Sensors: accelerometer, gyroscope, magnetometer, pressure sensor. GNSS
receivers: 1. GNSS antennas: 1. Manual: LORD 3DM-GX5-35 DCP Manual, revision unknown, known from
some pages. This profile is incomplete: Only some pages of its manual are known; the device has
further commands and data. Uncertain: The base rates are those that the manual states for all
3DM-GX5.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


GX5_45 = Device(
    id="3dm-gx5-45", title="3DM-GX5-45", model_number=6251,
    description="Inertial navigation system with GNSS, magnetometer and pressure sensor.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented.",
            {0x01: bytes.fromhex("03 7E"), 0x0C: bytes.fromhex("02 03 06 07 08 09 0A 0B 20 30 3A 40 64"), 0x0D: bytes.fromhex("03 10 11 12 13 14 15 16 17 18 19 1A 1B 1C 1D 1E 1F 20 21 22 23 27 28 29 2B 2C 42 43 44 45 46 47 4B"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("04 05 06"), 0x81: bytes.fromhex("0C 0D 0E 0F"), 0x82: bytes.fromhex("04 05 0E 14")}),
        Evidence(Support.YES, "documented", "Documented (LORD 3DM-GX5-45 DCP Manual: Single pages).",
            {0x01: bytes.fromhex("06 07")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK, versions 1 to 3: Examples of the versions 1 to 3).",
            {0x01: bytes.fromhex("01 02"), 0x0D: bytes.fromhex("01"), 0x80: bytes.fromhex("12"), 0x81: bytes.fromhex("0B"), 0x82: bytes.fromhex("01 02 10 11")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MicroStrain MIP SDK: Examples).",
            {0x0C: bytes.fromhex("39")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (ROS driver microstrain_mips: Table of tested functions).",
            {0x0C: bytes.fromhex("11 37 38 3B 3E 51"), 0x0D: bytes.fromhex("02 26")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
            {0x0D: bytes.fromhex("53")}),
        Evidence(Support.LIKELY, "software", "Used by programs for this model (ArduPilot: AP_ExternalAHRS_MicroStrain5).",
            {0x80: bytes.fromhex("0A 17"), 0x81: bytes.fromhex("03 05 07"), 0x82: bytes.fromhex("03")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation (MicroStrain MIP SDK: Examples).",
            {0x01: bytes.fromhex("04")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX5-15 and 3DM-GX5-35.",
            {0x01: bytes.fromhex("05 72"), 0x0C: bytes.fromhex("01 21 22 23 24 50"), 0x80: bytes.fromhex("07 08 09 0C 10 11"), 0x81: bytes.fromhex("04 06 08 09 0A")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-GX5-25 and 3DM-RQ1-45-LT.",
            {0x82: bytes.fromhex("06 07 08 09 0A 0B 0C 0D 0F 12 13 15 1C 20 21 25 26 28 29")}),
        Evidence(Support.NO, "refused", "Rejected by the device (MicroStrain Communication Library: Issue 43).",
            {0x80: bytes.fromhex("01")}),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
        Evidence(Support.NO, "hardware", "Requires 2 receivers, which the device lacks.",
            {0x92: bytes.fromhex("")}, absence='has fewer than 2 GNSS receivers'),
    ),
    functions={
        (0x0D, 0x21): "WSLD",
    },
    base_rates={0x80: 500, 0x81: 4, 0x82: 500},
    ports=(
        Port("UART 1", None, (9600, 19200, 115200, 230400, 460800, 921600), ("MIP",), ("MIP",)),
        Port("USB", None, (), ("MIP",), ("MIP",)),
    ),
    limits={
        "baud_rate_delay": Limit(250, "ms", "Time from the ACK of a new baud rate until the device replies to commands at that rate."),
        "rtcm_chunk": Limit(253, "byte", "Maximum number of RTCM bytes in one field."),
    },
    notes={
        "rtcm": Note("RTCM input", "The command with the descriptor 0x20 of the set `3dm` accepts RTCM 2.3; its layout is not known. The receiver uses the messages 1, 2, 3 and 9.", ()),
        "functions": Note("Read of all settings", "According to the manual, `3dm.device_settings` can also be read, which returns the settings of all commands. The response is not documented, so the read is not defined here.", ()),
        "device_status": Note("Device status", "According to MSCL, it replies with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_gnss_response`.", ()),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    incomplete=("Only some pages of its manual are known; the device has further commands and data.", "Only four fields of the filter data are listed; the manual documents 27 or more."),
    also=("3DM-GX5-GNSS/INS",),
    generation=5,
    manual="3dm-gx5-45",
)
"""Inertial navigation system with GNSS, magnetometer and pressure sensor. Also called
3DM-GX5-GNSS/INS. Generation 5. Model number 6251. Sensors: accelerometer, gyroscope, magnetometer,
pressure sensor. GNSS receivers: 1. GNSS antennas: 1. Manual: LORD 3DM-GX5-45 DCP Manual, 8500-0064
rev. C, known from some pages. This profile is incomplete: Only some pages of its manual are known;
the device has further commands and data. This profile is incomplete: Only four fields of the filter
data are listed; the manual documents 27 or more. Uncertain: The values of `filter.GnssSource` are
those that MSCL offers. Uncertain: The base rates are those that the manuals of the 3DM-GX5-35 and
the 3DM-GX5-45 state for all 3DM-GX5. Uncertain: An example in the manual has a base rate of 100 Hz
for the sensor data. Uncertain: The manual states the length of
`mip_3dm.DeviceStatusBasicWithoutStateResponse` and offsets of
`mip_3dm.DeviceStatusDiagnosticGx4Response`; MSCL differs.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


MV5_AR = Device(
    id="3dm-mv5-ar", title="3DM-MV5-AR", model_number=6243,
    description="Device of generation 5.",
    evidence=(
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
            {0x01: bytes.fromhex("01 02 03 04 06"), 0x0C: bytes.fromhex("11")}),
        Evidence(Support.NO, "hardware", "Requires a receiver, which the device lacks.",
            {0x0C: bytes.fromhex("02 07 09 20 21 22 23 24 34 62"), 0x81: bytes.fromhex(""), 0x91: bytes.fromhex(""), 0x92: bytes.fromhex(""), 0x93: bytes.fromhex("")}, absence='has no GNSS receiver'),
        Evidence(Support.NO, "hardware", "Requires a magnetometer, which the device lacks.",
            {0x0C: bytes.fromhex("3A 3B")}, absence='has no magnetometer'),
    ),
    base_rates={},
    notes={
        "j1939": Note("J1939", "Besides MIP it sends J1939 messages on CAN, from the address 0xE2, according to a third-party driver. The resolution is 1/32768 deg for angles, 1/128 deg/s for rates and 0.01 m/s^2 for accelerations.", (("Message", "PGN", "Signals", "Offset"), ("Slope sensor 2", "0xF029", "pitch (bits 0 to 23), roll (24 to 47)", "-250 deg"), ("Angular rate", "0xF02A", "pitch (0 to 15), roll (16 to 31), yaw (32 to 47)", "-250 deg/s"), ("Acceleration", "0xF02D", "lateral (0 to 15), longitudinal (16 to 31), vertical (32 to 47)", "-320 m/s^2"))),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    incomplete=("No manual is known.",),
    also=("3DM-MV5-15",),
    generation=5,
)
"""Device of generation 5. Also called 3DM-MV5-15. Generation 5. Model number 6243. Sensors:
accelerometer, gyroscope. GNSS receivers: none. GNSS antennas: none. No manual is known. This
profile is incomplete: No manual is known. Uncertain: The sensors are inferred from the name of the
model.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


RQ1_45_LT = Device(
    id="3dm-rq1-45-lt", title="3DM-RQ1-45-LT", model_number=6232,
    description="Ruggedized tactical grade inertial navigation system with GPS.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented.",
            {0x01: bytes.fromhex("01 02 03 04 05 06 7E"), 0x0C: bytes.fromhex("01 02 03 06 07 08 09 0A 0B 11 20 30 37 38 39 3A 3B 3E 40 50 64"), 0x0D: bytes.fromhex("01 02 03")}),
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
            {0x0D: bytes.fromhex("10 11 12 13 14 15 16 17 18 19 1A 1B 1C 1D 1E 1F 20 21 22 23 42 43 44 45 46"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("04 05 06"), 0x81: bytes.fromhex("03 05 09"), 0x82: bytes.fromhex("01 02 05")}),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
        Evidence(Support.NO, "hardware", "Requires 2 receivers, which the device lacks.",
            {0x92: bytes.fromhex("")}, absence='has fewer than 2 GNSS receivers'),
    ),
    base_rates={},
    notes={
        "direct_mode": Note("Direct modes", "`system.comm_mode` connects the port to the internal inertial sensor or to the receiver. The internal sensor replies as a separate device: 3DM-GX4-IMU in the 3DM-GX4-45, 3DM-RQ1-IMU in the 3DM-RQ1-45.", ()),
        "device_status": Note("Device status", "According to MSCL, it replies with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_rq1_45_response`.", ()),
        "absent": Note("What it lacks", "According to the table of contents of the manual, it has neither `base.gps_time_update` nor `3dm.complementary_filter`.", ()),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.device_status_basic_response.system_state": mip_3dm.Gx4SystemState,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    incomplete=("The manual's table of contents is known only up to `filter.set_initial_heading`. The unknown part includes the set `system`.", "It has the data sets 0x80, 0x81 and 0x82, but none of their fields are known."),
    also=("3DM-RQ1-45_LT",),
    generation=4,
    manual="3dm-rq1-45",
)
"""Ruggedized tactical grade inertial navigation system with GPS. Also called 3DM-RQ1-45_LT.
Generation 4. Model number 6232. GNSS receivers: 1. GNSS antennas: 1. Manual: LORD 3DM-RQ1-45 Data
Communications Protocol, of June 25, 2013, known from its table of contents. This profile is
incomplete: The manual's table of contents is known only up to `filter.SetInitialHeading`. The
unknown part includes the set `system`. This profile is incomplete: It has the data sets 0x80, 0x81
and 0x82, but none of their fields are known. Uncertain: The SDK writes the name with an underscore
before LT and ST.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


RQ1_45_ST = Device(
    id="3dm-rq1-45-st", title="3DM-RQ1-45-ST", model_number=6239,
    description="Ruggedized tactical grade inertial navigation system with GPS.",
    evidence=(
        Evidence(Support.YES, "documented", "Documented.",
            {0x01: bytes.fromhex("01 02 03 04 05 06 7E"), 0x0C: bytes.fromhex("01 02 03 06 07 08 09 0A 0B 11 20 30 37 38 39 3A 3B 3E 40 50 64"), 0x0D: bytes.fromhex("01 02 03")}),
        Evidence(Support.ASSUMED, "sister", "Supported by nearly identical devices, 3DM-RQ1-45-LT.",
            {0x0D: bytes.fromhex("10 11 12 13 14 15 16 17 18 19 1A 1B 1C 1D 1E 1F 20 21 22 23 42 43 44 45 46"), 0x7F: bytes.fromhex("10"), 0x80: bytes.fromhex("04 05 06"), 0x81: bytes.fromhex("03 05 09"), 0x82: bytes.fromhex("01 02 05")}),
        Evidence(Support.NO, "hardware", "Requires 2 antennas, which the device lacks.",
            {0x82: bytes.fromhex("49")}, absence='has fewer than 2 GNSS antennas'),
        Evidence(Support.NO, "hardware", "Requires 2 receivers, which the device lacks.",
            {0x92: bytes.fromhex("")}, absence='has fewer than 2 GNSS receivers'),
    ),
    base_rates={},
    notes={
        "direct_mode": Note("Direct modes", "`system.comm_mode` connects the port to the internal inertial sensor or to the receiver. The internal sensor replies as a separate device: 3DM-GX4-IMU in the 3DM-GX4-45, 3DM-RQ1-IMU in the 3DM-RQ1-45.", ()),
        "device_status": Note("Device status", "According to MSCL, it replies with `3dm.device_status_basic_response` and `3dm.device_status_diagnostic_rq1_45_response`.", ()),
        "absent": Note("What it lacks", "According to the table of contents of the manual, it has neither `base.gps_time_update` nor `3dm.complementary_filter`.", ()),
    },
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.device_status_basic_response.system_state": mip_3dm.Gx4SystemState,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    incomplete=("The manual's table of contents is known only up to `filter.set_initial_heading`. The unknown part includes the set `system`.", "It has the data sets 0x80, 0x81 and 0x82, but none of their fields are known."),
    also=("3DM-RQ1-45_ST",),
    generation=4,
    manual="3dm-rq1-45",
)
"""Ruggedized tactical grade inertial navigation system with GPS. Also called 3DM-RQ1-45_ST.
Generation 4. Model number 6239. GNSS receivers: 1. GNSS antennas: 1. Manual: LORD 3DM-RQ1-45 Data
Communications Protocol, of June 25, 2013, known from its table of contents. This profile is
incomplete: The manual's table of contents is known only up to `filter.SetInitialHeading`. The
unknown part includes the set `system`. This profile is incomplete: It has the data sets 0x80, 0x81
and 0x82, but none of their fields are known. Uncertain: The SDK writes the name with an underscore
before LT and ST.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


RQ1_IMU = Device(
    id="3dm-rq1-imu", title="3DM-RQ1-IMU", model_number=6238,
    description="Inertial sensor inside the 3DM-RQ1-45, which replies in the direct mode.",
    evidence=(
        Evidence(Support.LIKELY, "example", "Used by the vendor's example for this model (MIP SDK of 2014: Examples, one for each model).",
            {0x01: bytes.fromhex("01 02 03 04 05"), 0x0C: bytes.fromhex("01 06 08 37 38 39 3E 64"), 0x7F: bytes.fromhex("10")}),
        Evidence(Support.ASSUMED, "family", "Supported by devices of the same generation, 3DM-GX4-25.",
            {0x01: bytes.fromhex("06")}),
    ),
    base_rates={},
    readings={
        "3dm.data_stream_control.descriptor_set": mip_3dm.LegacyDataStream,
        "3dm.data_stream_control_response.descriptor_set": mip_3dm.LegacyDataStream,
        "sensor.gps_timestamp.valid_flags": types.Gx5SensorGpsTimestampFlags,
        "filter_data.status.filter_state": filter_data.Gx5FilterState,
        "filter_data.status.dynamics_mode": filter_data.Gx5DynamicsMode,
        "filter_data.status.status_flags": filter_data.Gx5StatusFlags,
    },
    incomplete=("No manual is known.",),
    generation=4,
)
"""Inertial sensor inside the 3DM-RQ1-45, which replies in the direct mode. Generation 4. Model
number 6238. No manual is known. This profile is incomplete: No manual is known.

- mip-sdk-2014: RQ1 IMU
"""


RTK = Device(
    id="3dm-rtk", title="3DM-RTK", model_number=6285,
    description="Modem for GNSS corrections.",
    evidence=(
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MicroStrain Communication Library: MIP node features).",
            {0x01: bytes.fromhex("01 02 03 04 05 06 09 7E"), 0x0C: bytes.fromhex("30"), 0x0F: bytes.fromhex("01 07"), 0x7F: bytes.fromhex("10")}),
    ),
    base_rates={},
    notes={
        "versions": Note("Versions", "According to MSCL, model numbers that end in 0000 denote version 1, and those that end in 0100 version 2. Their status words in `rtk.get_status_flags` differ.", ()),
    },
    readings={
        "base.built_in_test_response.result": types.Cv7BuiltInTest,
    },
    incomplete=("No manual is known.",),
    generation=7,
)
"""Modem for GNSS corrections. Generation 7. Model number 6285. No manual is known. This profile is
incomplete: No manual is known.

- mip-sdk-4: Device models
- mscl: MIP node features
"""


DEMOD_DC = Device(
    id="demod-dc", title="DEMOD-DC", model_number=6130,
    description="Digital demodulator for displacement sensors.",
    evidence=(
        Evidence(Support.LIKELY, "software", "Used by programs for this model (MicroStrain Communication Library: Displacement node).",
            {0x01: bytes.fromhex("01 02 03 04 06"), 0x11: bytes.fromhex("01 02 04"), 0x90: bytes.fromhex("01 02 04")}),
    ),
    base_rates={},
    incomplete=("No manual is known; everything here is from MSCL.",),
    also=("Digital Demod",),
)
"""Digital demodulator for displacement sensors. Also called Digital Demod. Model number 6130. No
manual is known. This profile is incomplete: No manual is known; everything here is from MSCL.

- mscl: Displacement node
"""


# fmt: on

#: All devices by id.
DEVICES: dict[str, Device] = {
    "3dm-cv5-10": CV5_10,
    "3dm-cv5-15": CV5_15,
    "3dm-cv5-25": CV5_25,
    "3dm-cv7-ahrs": CV7_AHRS,
    "3dm-cv7-ar": CV7_AR,
    "3dm-cv7-gnss-ins": CV7_GNSS_INS,
    "3dm-cv7-ins": CV7_INS,
    "3dm-cx5-10": CX5_10,
    "3dm-cx5-15": CX5_15,
    "3dm-cx5-25": CX5_25,
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
    "3dm-gx4-imu": GX4_IMU,
    "3dm-gx5-15": GX5_15,
    "3dm-gx5-25": GX5_25,
    "3dm-gx5-35": GX5_35,
    "3dm-gx5-45": GX5_45,
    "3dm-mv5-ar": MV5_AR,
    "3dm-rq1-45-lt": RQ1_45_LT,
    "3dm-rq1-45-st": RQ1_45_ST,
    "3dm-rq1-imu": RQ1_IMU,
    "3dm-rtk": RTK,
    "demod-dc": DEMOD_DC,
}


def by_name(name: str) -> Device:
    """Finds a device by its id, title, other name or last words ("gx5 15"), in any spelling; raises UnknownName."""
    return DEVICES[device_id(name)]


def by_model(number: int) -> Device | None:
    """Finds a device by its model number; None if the number is unknown, for example of a newer device."""
    return next((d for d in DEVICES.values() if d.model_number == number), None)


def identify(info: DeviceInfo) -> Device | None:
    """Finds the device that sent this device information; None if it is unknown."""
    number = model_number(info.model_number) or model_number(info.serial_number)
    return by_model(number) if number else None


# fmt: off
__all__ = [
    "DEVICES", "Device", "DeviceInfo", "Evidence", "Limit", "Note", "Port", "Support", "by_model", "by_name",
    "identify", "model_number",
    "CV5_10",
    "CV5_15",
    "CV5_25",
    "CV7_AHRS",
    "CV7_AR",
    "CV7_GNSS_INS",
    "CV7_INS",
    "CX5_10",
    "CX5_15",
    "CX5_25",
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
    "GX4_IMU",
    "GX5_15",
    "GX5_25",
    "GX5_35",
    "GX5_45",
    "MV5_AR",
    "RQ1_45_LT",
    "RQ1_45_ST",
    "RQ1_IMU",
    "RTK",
    "DEMOD_DC",
]
