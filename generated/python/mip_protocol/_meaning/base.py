"""What the types of `base` mean."""

from __future__ import annotations

from .. import base, protocol, types
from ..info import EnumInfo, FieldInfo, Info, SetInfo, StructureInfo, ValueInfo
from ..parameter import Parameter, Variant

# fmt: off
SET = SetInfo("base", number=0x01, title="Base", description="Commands common to all devices: identity, supported descriptors, idle and resume, self test, reset.", sources=("3dm-gx5-15: 4.1 Base Commands", "3dm-cv7-gnss-ins: Base (0x01)"))

#: Class -> what is known of it.
TYPES: dict[str, Info] = {
    "BaseDeviceInfo": StructureInfo(
        "base.base_device_info", type=base.BaseDeviceInfo, description="Identity of a device. The strings are padded with spaces.", sources=("3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03)", "3dm-cv7-gnss-ins: Get device information (0x01,0x03)"),
        parameters=(
            Parameter("firmware_version", "firmware_version", "scalar", description="Firmware version as one decimal number: 1202 means 1.2.02.", scalar="u16"),
            Parameter("model_name", "model_name", "text", description="Name of the model.", scalar="char", length=16),
            Parameter("model_number", "model_number", "text", description="Part number of the model.", scalar="char", length=16),
            Parameter("serial_number", "serial_number", "text", description="Serial number.", scalar="char", length=16),
            Parameter("lot_number", "lot_number", "text", description="Lot number; reserved and blank on some devices.", scalar="char", length=16),
            Parameter("device_options", "device_options", "text", description="Options of the unit, such as its sensor ranges.", scalar="char", length=16),
        ),
    ),
    "GpsTimeField": EnumInfo(
        "base.gps_time_field", type=base.GpsTimeField, description="The part of the GPS time that a value holds.",
        values=(
            ValueInfo("week_number", value=1, description="Week number."),
            ValueInfo("tow", value=2, description="Time of week in whole seconds."),
        ),
    ),
    "Ping": FieldInfo(
        "base.ping", type=base.Ping,
        title="Ping",
        description="Checks whether a device is present and answers commands.",
        facts=("Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.", "May be supported by 3DM-CL5-10, 3DM-CL5-15, 3DM-CL5-25, 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-35, 3DM-CX5-45, 3DM-DH3, 3DM-GQ7-GNSS/INS, 3DM-GV7-AHRS, 3DM-GV7-AR, 3DM-GV7-INS, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX5-10, 3DM-GX5-25, 3DM-GX5-45, 3DM-MV5-AR and 3DM-RTK.", "A device that is not in a normal operating mode may refuse the command."),
        sources=("3dm-gx5-15: 4.1.1 Ping (0x01, 0x01)", "3dm-cv7-gnss-ins: Ping (0x01,0x01)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-rq1-45-lt", "3dm-rq1-45-st"),
        perhaps=("3dm-cl5-10", "3dm-cl5-15", "3dm-cl5-25", "3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-35", "3dm-cx5-45", "3dm-dh3", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-10", "3dm-gx5-25", "3dm-gx5-45", "3dm-mv5-ar", "3dm-rtk"),
        parameters=(
        ),
    ),
    "SetIdle": FieldInfo(
        "base.set_idle", type=base.SetIdle,
        title="Set to idle",
        description="Stops all data streams, and wakes a sleeping device, so that it can be configured.",
        facts=("Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.", "May be supported by 3DM-CL5-10, 3DM-CL5-15, 3DM-CL5-25, 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-35, 3DM-CX5-45, 3DM-DH3, 3DM-GQ7-GNSS/INS, 3DM-GV7-AHRS, 3DM-GV7-AR, 3DM-GV7-INS, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX5-10, 3DM-GX5-25, 3DM-GX5-35, 3DM-GX5-45, 3DM-MV5-AR and 3DM-RTK.", "`base.Resume` restores the previous mode.", "While idle, the device does not send NMEA sentences either."),
        sources=("3dm-gx5-15: 4.1.2 Set To Idle (0x01, 0x02)", "3dm-cv7-gnss-ins: Set to idle (0x01,0x02)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-rq1-45-lt", "3dm-rq1-45-st"),
        perhaps=("3dm-cl5-10", "3dm-cl5-15", "3dm-cl5-25", "3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-35", "3dm-cx5-45", "3dm-dh3", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-10", "3dm-gx5-25", "3dm-gx5-35", "3dm-gx5-45", "3dm-mv5-ar", "3dm-rtk"),
        parameters=(
        ),
    ),
    "GetDeviceInfo": FieldInfo(
        "base.get_device_info", type=base.GetDeviceInfo,
        title="Get device information",
        description="Gets the firmware version and the identity strings of the device.",
        facts=("Answered by `base.GetDeviceInfoResponse`.", "Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.", "May be supported by 3DM-CL5-10, 3DM-CL5-15, 3DM-CL5-25, 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-35, 3DM-CX5-45, 3DM-DH3, 3DM-GQ7-GNSS/INS, 3DM-GV7-AHRS, 3DM-GV7-AR, 3DM-GV7-INS, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX5-10, 3DM-GX5-25, 3DM-MV5-AR and 3DM-RTK."),
        sources=("3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03)", "3dm-cv7-gnss-ins: Get device information (0x01,0x03)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"),
        perhaps=("3dm-cl5-10", "3dm-cl5-15", "3dm-cl5-25", "3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-35", "3dm-cx5-45", "3dm-dh3", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-10", "3dm-gx5-25", "3dm-mv5-ar", "3dm-rtk"),
        parameters=(
        ),
    ),
    "GetDeviceDescriptors": FieldInfo(
        "base.get_device_descriptors", type=base.GetDeviceDescriptors,
        title="Get device descriptors",
        description="Gets the command and data descriptors that the device supports.",
        facts=("Answered by `base.GetDeviceDescriptorsResponse`.", "Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.", "May be supported by 3DM-CL5-10, 3DM-CL5-15, 3DM-CL5-25, 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-35, 3DM-CX5-45, 3DM-DH3, 3DM-GQ7-GNSS/INS, 3DM-GV7-AHRS, 3DM-GV7-AR, 3DM-GV7-INS, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX5-10, 3DM-GX5-25, 3DM-GX5-45, 3DM-MV5-AR and 3DM-RTK.", "If the list contains the descriptor of `base.GetExtendedDescriptors`, that command returns further descriptors."),
        sources=("3dm-gx5-15: 4.1.4 Get Device Descriptor Sets (0x01, 0x04)", "3dm-cv7-gnss-ins: Get device descriptors (0x01,0x04)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-rq1-45-lt", "3dm-rq1-45-st"),
        perhaps=("3dm-cl5-10", "3dm-cl5-15", "3dm-cl5-25", "3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-35", "3dm-cx5-45", "3dm-dh3", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-10", "3dm-gx5-25", "3dm-gx5-45", "3dm-mv5-ar", "3dm-rtk"),
        parameters=(
        ),
    ),
    "BuiltInTest": FieldInfo(
        "base.built_in_test", type=base.BuiltInTest,
        title="Built-in test",
        description="Runs the self test of the device and gets its result.",
        facts=("Answered by `base.BuiltInTestResponse`.", "The device may take 10 s to answer.", "Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.", "May be supported by 3DM-GX5-35 and 3DM-GX5-45.", "The test interrupts normal operation for up to several seconds; no data is available meanwhile.", "The device must be at rest; acceleration, rotation or vibration cause false failures.", "The continuous built-in test, if the device has it, gives more detail about a failure.", "Uncertain: The maximum duration of the test. The manual of the 3DM-CV7 says several seconds; 10 s leaves room for that."),
        sources=("3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05)", "3dm-cv7-gnss-ins: Built in test (0x01,0x05)", "3dm-cv7-gnss-ins: Commanded Built-in Test"),
        devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-rq1-45-lt", "3dm-rq1-45-st"),
        perhaps=("3dm-gx5-35", "3dm-gx5-45"),
        parameters=(
        ),
    ),
    "Resume": FieldInfo(
        "base.resume", type=base.Resume,
        title="Resume",
        description="Ends idle mode and returns the device to the mode that it was in before.",
        facts=("Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.", "May be supported by 3DM-CL5-10, 3DM-CL5-15, 3DM-CL5-25, 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-35, 3DM-CX5-45, 3DM-DH3, 3DM-GQ7-GNSS/INS, 3DM-GV7-AHRS, 3DM-GV7-AR, 3DM-GV7-INS, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX5-10, 3DM-GX5-25, 3DM-GX5-35, 3DM-GX5-45, 3DM-MV5-AR and 3DM-RTK.", "If the device was not idle, it enters its default mode (3DM-GX5-15)."),
        sources=("3dm-gx5-15: 4.1.6 Resume (0x01, 0x06)", "3dm-cv7-gnss-ins: Resume (0x01,0x06)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-rq1-45-lt", "3dm-rq1-45-st"),
        perhaps=("3dm-cl5-10", "3dm-cl5-15", "3dm-cl5-25", "3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-35", "3dm-cx5-45", "3dm-dh3", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-10", "3dm-gx5-25", "3dm-gx5-35", "3dm-gx5-45", "3dm-mv5-ar", "3dm-rtk"),
        parameters=(
        ),
    ),
    "GetExtendedDescriptors": FieldInfo(
        "base.get_extended_descriptors", type=base.GetExtendedDescriptors,
        title="Get device descriptors (extended)",
        description="Gets the supported descriptors that did not fit into the reply of `base.GetDeviceDescriptors`.",
        facts=("Answered by `base.GetExtendedDescriptorsResponse`.", "Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-35.", "May be supported by 3DM-GX5-45.", "Only supported if `base.GetDeviceDescriptors` lists it."),
        sources=("3dm-gx5-15: 4.1.7 Get Extended Device Descriptor Sets (0x01, 0x07)", "3dm-cv7-gnss-ins: Get device descriptors (extended) (0x01,0x07)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-35"),
        perhaps=("3dm-gx5-45",),
        parameters=(
        ),
    ),
    "ContinuousBuiltInTest": FieldInfo(
        "base.continuous_built_in_test", type=base.ContinuousBuiltInTest,
        title="Continuous built-in test",
        description="Gets the flags of the tests that run all the time. It does not interrupt operation.",
        facts=("Also called `continuous_bit`.", "Answered by `base.ContinuousBuiltInTestResponse`.", "Supported by 3DM-CV7-GNSS/INS.", "It is less thorough than `base.BuiltInTest`.", "Each flag stays set until this command reports it; the streamed field has its own copy of the flags.", "The self-test flags change only when `base.BuiltInTest` runs."),
        sources=("3dm-cv7-gnss-ins: Continuous built-in test (0x01,0x08)",),
        also=("continuous_bit",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
        ),
    ),
    "CommSpeed": FieldInfo(
        "base.comm_speed", type=base.CommSpeed,
        title="Comm port speed",
        description="Baud rate of one communication port.",
        facts=("Functions: `write`, `read`, `save`, `load` and `default`.", "Answered by `base.CommSpeedResponse`.", "Supported by 3DM-CV7-GNSS/INS.", "The change takes effect once pending data is sent and received, after at most 250 ms.", "Send it alone in a packet while the device is idle, and wait 250 ms before going on.", "Commands and data during the change may be lost, or sent at either rate."),
        sources=("3dm-cv7-gnss-ins: Comm Port Speed (0x01,0x09)",),
        functions=("write", "read", "save", "load", "default"),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("port", "port", "scalar", description="Port id of the device; 0 means all ports, and is for save, load and default only.", facts=("On the 3DM-CV7-GNSS/INS: values of `types.CommInterface`.",), scalar="u8", required=("write", "read", "save", "load", "default"), variants=(Variant("device", ("3dm-cv7-gnss-ins",), "On the 3DM-CV7-GNSS/INS: values of `types.CommInterface`.", {"type": types.CommInterface}),)),
            Parameter("baud", "baud", "scalar", description="Baud rate; one that the port supports.", facts=("Unit: Bd.", "Required for `write`."), scalar="u32", units=("Bd",), required=("write",)),
        ),
    ),
    "GpsTimeUpdate": FieldInfo(
        "base.gps_time_update", type=base.GpsTimeUpdate,
        title="GPS time update",
        description="Sets the week number or the time of week of the external (GPS) time.",
        facts=("Functions: `write`, `read` and `apply`.", "Answered by `base.GpsTimeUpdateWeekNumberResponse` or `base.GpsTimeUpdateTowResponse`.", "Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15 and 3DM-GX5-35.", "May be supported by 3DM-GX5-45.", "On the 3DM-CV7-GNSS/INS: `write` only.", "Send it once for the time of week and once for the week number after the PPS is locked.", "The PPS supplies the fraction of the second; send the whole second that began at its last edge.", "Send it within 250 ms after the rising edge of the PPS.", "Once per second is recommended for the 3DM-GX5-15; the 3DM-CV7-GNSS/INS needs it at least once.", "Send it again after a glitch of the PPS. It is usually not needed if an internal GNSS receiver is the PPS source."),
        sources=("3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72)", "3dm-cv7-gnss-ins: GPS Time Update Command (0x01,0x72)"),
        functions=("write", "read", "apply"),
        devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35"),
        perhaps=("3dm-gx5-45",),
        parameters=(
            Parameter("function", "function", "scalar", description="What to do with the setting.", scalar="u8", type=protocol.FunctionSelector),
            Parameter("field_id", "field_id", "scalar", description="Meaning of the value.", scalar="u8", required=("write", "read", "apply"), type=base.GpsTimeField),
            Parameter("value", "value", "scalar", description="Time, as `field_id` says.", facts=("Required for `write` and `apply`.", "If `field_id` is `base.GpsTimeField.WEEK_NUMBER`: unit week. GPS week number since 6 January 1980.", "If `field_id` is `base.GpsTimeField.TOW`: unit s. Whole seconds of the GPS week."), scalar="u32", required=("write", "apply"), variants=(Variant("field_id", (1,), "If `field_id` is `base.GpsTimeField.WEEK_NUMBER`: unit week. GPS week number since 6 January 1980.", {"units": ("week",)}), Variant("field_id", (2,), "If `field_id` is `base.GpsTimeField.TOW`: unit s. Whole seconds of the GPS week.", {"units": ("s",)}),)),
        ),
    ),
    "SoftReset": FieldInfo(
        "base.soft_reset", type=base.SoftReset,
        title="Reset device",
        description="Acknowledges the command, then resets the device immediately.",
        facts=("Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.", "May be supported by 3DM-GX5-35."),
        sources=("3dm-gx5-15: 4.1.9 Device Reset (0x01, 0x7E)", "3dm-cv7-gnss-ins: Reset device (0x01,0x7E)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"),
        perhaps=("3dm-gx5-35",),
        parameters=(
        ),
    ),
    "GetDeviceInfoResponse": FieldInfo(
        "base.get_device_info_response", type=base.GetDeviceInfoResponse,
        title="Get device information response",
        facts=("Answers `base.GetDeviceInfo`.", "Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.", "May be supported by 3DM-CL5-10, 3DM-CL5-15, 3DM-CL5-25, 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-35, 3DM-CX5-45, 3DM-DH3, 3DM-GQ7-GNSS/INS, 3DM-GV7-AHRS, 3DM-GV7-AR, 3DM-GV7-INS, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX5-10, 3DM-GX5-25, 3DM-MV5-AR and 3DM-RTK."),
        sources=("3dm-gx5-15: 4.1.3 Get Device Information (0x01, 0x03)", "3dm-cv7-gnss-ins: Get device information (0x01,0x03)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"),
        perhaps=("3dm-cl5-10", "3dm-cl5-15", "3dm-cl5-25", "3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-35", "3dm-cx5-45", "3dm-dh3", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-10", "3dm-gx5-25", "3dm-mv5-ar", "3dm-rtk"),
        parameters=(
            Parameter("device_info", "device_info", "struct", description="Identity of the device.", type=base.BaseDeviceInfo),
        ),
    ),
    "GetDeviceDescriptorsResponse": FieldInfo(
        "base.get_device_descriptors_response", type=base.GetDeviceDescriptorsResponse,
        title="Get device descriptors response",
        facts=("Answers `base.GetDeviceDescriptors`.", "Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-GX5-35, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.", "May be supported by 3DM-CL5-10, 3DM-CL5-15, 3DM-CL5-25, 3DM-CV5-10, 3DM-CV5-15, 3DM-CV5-25, 3DM-CV7-AHRS, 3DM-CV7-AR, 3DM-CV7-INS, 3DM-CX5-10, 3DM-CX5-15, 3DM-CX5-25, 3DM-CX5-35, 3DM-CX5-45, 3DM-DH3, 3DM-GQ7-GNSS/INS, 3DM-GV7-AHRS, 3DM-GV7-AR, 3DM-GV7-INS, 3DM-GX3-15, 3DM-GX3-25, 3DM-GX3-35, 3DM-GX3-45, 3DM-GX4-15, 3DM-GX4-25, 3DM-GX4-45, 3DM-GX5-10, 3DM-GX5-25, 3DM-GX5-45, 3DM-MV5-AR and 3DM-RTK."),
        sources=("3dm-gx5-15: 4.1.4 Get Device Descriptor Sets (0x01, 0x04)", "3dm-cv7-gnss-ins: Get device descriptors (0x01,0x04)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35", "3dm-rq1-45-lt", "3dm-rq1-45-st"),
        perhaps=("3dm-cl5-10", "3dm-cl5-15", "3dm-cl5-25", "3dm-cv5-10", "3dm-cv5-15", "3dm-cv5-25", "3dm-cv7-ahrs", "3dm-cv7-ar", "3dm-cv7-ins", "3dm-cx5-10", "3dm-cx5-15", "3dm-cx5-25", "3dm-cx5-35", "3dm-cx5-45", "3dm-dh3", "3dm-gq7", "3dm-gv7-ahrs", "3dm-gv7-ar", "3dm-gv7-ins", "3dm-gx3-15", "3dm-gx3-25", "3dm-gx3-35", "3dm-gx3-45", "3dm-gx4-15", "3dm-gx4-25", "3dm-gx4-45", "3dm-gx5-10", "3dm-gx5-25", "3dm-gx5-45", "3dm-mv5-ar", "3dm-rtk"),
        parameters=(
            Parameter("descriptors", "descriptors", "array", description="Supported descriptors: the descriptor set in the high byte, the field descriptor in the low byte.", scalar="u16", length="rest"),
        ),
    ),
    "BuiltInTestResponse": FieldInfo(
        "base.built_in_test_response", type=base.BuiltInTestResponse,
        title="Built-in test response",
        facts=("Answers `base.BuiltInTest`.", "Supported by 3DM-CV7-GNSS/INS, 3DM-GQ4-45, 3DM-GX5-15, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST.", "May be supported by 3DM-GX5-35 and 3DM-GX5-45."),
        sources=("3dm-gx5-15: 4.1.5 Device Built-In Test (0x01, 0x05)", "3dm-cv7-gnss-ins: Built in test (0x01,0x05)", "3dm-cv7-gnss-ins: Commanded Built-in Test"),
        devices=("3dm-cv7-gnss-ins", "3dm-gq4-45", "3dm-gx5-15", "3dm-rq1-45-lt", "3dm-rq1-45-st"),
        perhaps=("3dm-gx5-35", "3dm-gx5-45"),
        parameters=(
            Parameter("result", "result", "scalar", description="Failure flags, defined by each device. Zero means that every test passed.", facts=("On the 3DM-CV7-GNSS/INS: values of `types.Cv7BuiltInTest`.", "On the 3DM-GQ4-45, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: the values are not known.", "On the 3DM-GX5-15: values of `types.Gx5BuiltInTest`."), scalar="u32", variants=(Variant("device", ("3dm-cv7-gnss-ins",), "On the 3DM-CV7-GNSS/INS: values of `types.Cv7BuiltInTest`.", {"type": types.Cv7BuiltInTest}), Variant("device", ("3dm-gq4-45", "3dm-gx5-35", "3dm-gx5-45", "3dm-rq1-45-lt", "3dm-rq1-45-st"), "On the 3DM-GQ4-45, 3DM-GX5-35, 3DM-GX5-45, 3DM-RQ1-45-LT and 3DM-RQ1-45-ST: the values are not known.", {"type": None}), Variant("device", ("3dm-gx5-15",), "On the 3DM-GX5-15: values of `types.Gx5BuiltInTest`.", {"type": types.Gx5BuiltInTest}),)),
        ),
    ),
    "GpsTimeUpdateWeekNumberResponse": FieldInfo(
        "base.gps_time_update_week_number_response", type=base.GpsTimeUpdateWeekNumberResponse,
        title="GPS time update, week number",
        description="The current week number.",
        facts=("Answers `base.GpsTimeUpdate`.", "Sent if `field_id` is `base.GpsTimeField.WEEK_NUMBER`.", "Supported by 3DM-GQ4-45, 3DM-GX5-15 and 3DM-GX5-35.", "May be supported by 3DM-GX5-45."),
        sources=("3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72)", "3dm-cv7-gnss-ins: GPS Time Update Command (0x01,0x72)"),
        devices=("3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35"),
        perhaps=("3dm-gx5-45",),
        parameters=(
            Parameter("week_number", "week_number", "scalar", description="GPS week number.", facts=("Unit: week.",), scalar="u32", units=("week",)),
        ),
    ),
    "GpsTimeUpdateTowResponse": FieldInfo(
        "base.gps_time_update_tow_response", type=base.GpsTimeUpdateTowResponse,
        title="GPS time update, time of week",
        description="The current time of week.",
        facts=("Answers `base.GpsTimeUpdate`.", "Sent if `field_id` is `base.GpsTimeField.TOW`.", "Supported by 3DM-GQ4-45, 3DM-GX5-15 and 3DM-GX5-35.", "May be supported by 3DM-GX5-45."),
        sources=("3dm-gx5-15: 4.1.8 GPS Time Update (0x01, 0x72)", "3dm-cv7-gnss-ins: GPS Time Update Command (0x01,0x72)"),
        devices=("3dm-gq4-45", "3dm-gx5-15", "3dm-gx5-35"),
        perhaps=("3dm-gx5-45",),
        parameters=(
            Parameter("tow", "tow", "scalar", description="GPS time of week in whole seconds.", facts=("Unit: s.",), scalar="u32", units=("s",)),
        ),
    ),
    "GetExtendedDescriptorsResponse": FieldInfo(
        "base.get_extended_descriptors_response", type=base.GetExtendedDescriptorsResponse,
        title="Get device descriptors (extended) response",
        facts=("Answers `base.GetExtendedDescriptors`.", "Supported by 3DM-CV7-GNSS/INS, 3DM-GX5-15 and 3DM-GX5-35.", "May be supported by 3DM-GX5-45."),
        sources=("3dm-gx5-15: 4.1.7 Get Extended Device Descriptor Sets (0x01, 0x07)", "3dm-cv7-gnss-ins: Get device descriptors (extended) (0x01,0x07)"),
        devices=("3dm-cv7-gnss-ins", "3dm-gx5-15", "3dm-gx5-35"),
        perhaps=("3dm-gx5-45",),
        parameters=(
            Parameter("descriptors", "descriptors", "array", description="Supported descriptors: the descriptor set in the high byte, the field descriptor in the low byte.", scalar="u16", length="rest"),
        ),
    ),
    "ContinuousBuiltInTestResponse": FieldInfo(
        "base.continuous_built_in_test_response", type=base.ContinuousBuiltInTestResponse,
        title="Continuous built-in test response",
        facts=("Also called `continuous_bit_response`.", "Answers `base.ContinuousBuiltInTest`.", "Supported by 3DM-CV7-GNSS/INS."),
        sources=("3dm-cv7-gnss-ins: Continuous built-in test (0x01,0x08)",),
        also=("continuous_bit_response",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("result", "result", "array", description="Flags, defined by each device, least significant byte first: bit 8 is bit 0 of the second byte.", facts=("On the 3DM-CV7-GNSS/INS: values of `types.Cv7ContinuousBuiltInTest`.",), scalar="u8", length=16, variants=(Variant("device", ("3dm-cv7-gnss-ins",), "On the 3DM-CV7-GNSS/INS: values of `types.Cv7ContinuousBuiltInTest`.", {"type": types.Cv7ContinuousBuiltInTest}),)),
        ),
    ),
    "CommSpeedResponse": FieldInfo(
        "base.comm_speed_response", type=base.CommSpeedResponse,
        title="Comm port speed response",
        facts=("Answers `base.CommSpeed`.", "Supported by 3DM-CV7-GNSS/INS."),
        sources=("3dm-cv7-gnss-ins: Comm Port Speed (0x01,0x09)",),
        devices=("3dm-cv7-gnss-ins",),
        parameters=(
            Parameter("port", "port", "scalar", description="Port id of the device.", facts=("On the 3DM-CV7-GNSS/INS: values of `types.CommInterface`.",), scalar="u8", variants=(Variant("device", ("3dm-cv7-gnss-ins",), "On the 3DM-CV7-GNSS/INS: values of `types.CommInterface`.", {"type": types.CommInterface}),)),
            Parameter("baud", "baud", "scalar", description="Baud rate of the port.", facts=("Unit: Bd.",), scalar="u32", units=("Bd",)),
        ),
    ),
}
