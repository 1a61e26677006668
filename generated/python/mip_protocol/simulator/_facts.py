"""What simulated devices show and do, by full names of fields."""

from __future__ import annotations

from .facts import Behavior, Difference, FieldValues, Value

#: Letters of function selectors -> their numbers.
FUNCTIONS: dict[str, int] = {"W": 1, "R": 2, "S": 3, "L": 4, "D": 5, "A": 6}

#: Names of quantities -> unit.
QUANTITIES: dict[str, str | None] = {
    "device.firmware_version": None,
    "device.model_name": None,
    "device.model_number": None,
    "device.serial_number": None,
    "device.lot_number": None,
    "device.options": None,
    "device.number": None,
    "device.descriptors": None,
    "device.further_descriptors": None,
    "device.uptime": "s",
    "device.bytes_sent": "byte",
    "device.bytes_received": "byte",
    "device.packets_dropped": "1",
    "stream.base_rate": "Hz",
    "stream.enabled": None,
    "stream.sensor": None,
    "stream.gnss": None,
    "stream.filter": None,
    "event.slots": "1",
    "event.types": None,
    "event.triggers": None,
    "event.actions": None,
    "pin.level": None,
    "sensor.ranges": None,
    "receiver.list": None,
    "gps.week": None,
    "gps.tow": "s",
}

#: Names of effects -> their arguments.
EFFECTS: dict[str, tuple[str, ...]] = {
    "all_settings": (),
    "baud_rate": ("port", "baud"),
    "capture": ("milliseconds",),
    "communication_mode": ("mode",),
    "device_status": (),
    "factory_streaming": ("action",),
    "format": ("set", "fields"),
    "frame_rotation": ("format", "rotation"),
    "gps_time": ("field", "value"),
    "idle": (),
    "orientation_dcm": ("dcm", "inverse"),
    "orientation_euler": ("roll", "pitch", "yaw", "inverse"),
    "orientation_quaternion": ("q", "inverse"),
    "pin": ("pin", "feature", "behavior"),
    "pin_state": ("pin", "state"),
    "poll": ("set", "fields"),
    "poll_sentences": ("entries",),
    "restart": (),
    "resume": (),
    "self_test": (),
    "sentences": ("entries",),
    "switch": ("set", "enable"),
    "trigger": ("instance",),
    "trigger_mode": ("instance", "mode"),
    "action": (),
}

#: Data fields and responses -> what their values show.
VALUES: dict[str, FieldValues] = {
    "base.get_device_info_response": FieldValues(
        "",
        {
            "device_info.firmware_version": Value(quantity="device.firmware_version"),
            "device_info.model_name": Value(quantity="device.model_name"),
            "device_info.model_number": Value(quantity="device.model_number"),
            "device_info.serial_number": Value(quantity="device.serial_number"),
            "device_info.lot_number": Value(quantity="device.lot_number"),
            "device_info.device_options": Value(quantity="device.options"),
        },
    ),
    "base.get_device_descriptors_response": FieldValues(
        "", {"descriptors": Value(quantity="device.descriptors")}
    ),
    "base.get_extended_descriptors_response": FieldValues(
        "", {"descriptors": Value(quantity="device.further_descriptors")}
    ),
    "base.gps_time_update_week_number_response": FieldValues(
        "", {"week_number": Value(quantity="gps.week")}
    ),
    "base.gps_time_update_tow_response": FieldValues("", {"tow": Value(quantity="gps.tow")}),
    "3dm.get_imu_base_rate_response": FieldValues("", {"rate": Value(quantity="stream.base_rate")}),
    "3dm.get_gnss_base_rate_response": FieldValues(
        "", {"rate": Value(quantity="stream.base_rate")}
    ),
    "3dm.get_filter_base_rate_response": FieldValues(
        "", {"rate": Value(quantity="stream.base_rate")}
    ),
    "3dm.get_base_rate_response": FieldValues("", {"rate": Value(quantity="stream.base_rate")}),
    "3dm.data_stream_control_response": FieldValues(
        "", {"enabled": Value(quantity="stream.enabled")}
    ),
    "3dm.constellation_settings_response": FieldValues(
        "", {"max_channels_available": Value(number=72), "max_channels_use": Value(number=32)}
    ),
    "3dm.get_event_support_response": FieldValues(
        "",
        {"max_instances": Value(quantity="event.slots"), "entries": Value(quantity="event.types")},
    ),
    "3dm.get_event_trigger_status_response": FieldValues(
        "", {"triggers": Value(quantity="event.triggers")}
    ),
    "3dm.get_event_action_status_response": FieldValues(
        "", {"actions": Value(quantity="event.actions")}
    ),
    "3dm.gpio_state_response": FieldValues("", {"state": Value(quantity="pin.level")}),
    "3dm.get_calibrated_sensor_ranges_response": FieldValues(
        "", {"ranges": Value(quantity="sensor.ranges")}
    ),
    "3dm.device_status_basic_response": FieldValues(
        "",
        {
            "model_number": Value(quantity="device.number"),
            "system_timer": Value(quantity="device.uptime", factor=1000.0),
        },
    ),
    "3dm.device_status_basic_without_state_response": FieldValues(
        "",
        {
            "model_number": Value(quantity="device.number"),
            "system_timer": Value(quantity="device.uptime", factor=1000.0),
        },
    ),
    "3dm.device_status_diagnostic_response": FieldValues(
        "",
        {
            "model_number": Value(quantity="device.number"),
            "system_timer": Value(quantity="device.uptime", factor=1000.0),
            "imu_stream_enabled": Value(quantity="stream.sensor"),
            "filter_stream_enabled": Value(quantity="stream.filter"),
            "comm_port_bytes_written": Value(quantity="device.bytes_sent"),
            "comm_port_bytes_read": Value(quantity="device.bytes_received"),
            "comm_port_write_overruns": Value(quantity="device.packets_dropped"),
            "imu_last_message_time": Value(quantity="device.uptime", factor=1000.0),
        },
    ),
    "3dm.device_status_diagnostic_gnss_response": FieldValues(
        "",
        {
            "model_number": Value(quantity="device.number"),
            "system_timer": Value(quantity="device.uptime", factor=1000.0),
            "imu_stream_enabled": Value(quantity="stream.sensor"),
            "filter_stream_enabled": Value(quantity="stream.filter"),
            "comm_port_bytes_written": Value(quantity="device.bytes_sent"),
            "comm_port_bytes_read": Value(quantity="device.bytes_received"),
            "comm_port_write_overruns": Value(quantity="device.packets_dropped"),
            "imu_last_message_time": Value(quantity="device.uptime", factor=1000.0),
            "gnss_stream_enabled": Value(quantity="stream.gnss"),
        },
    ),
    "3dm.device_status_diagnostic_gq4_45_response": FieldValues(
        "",
        {
            "model_number": Value(quantity="device.number"),
            "system_timer": Value(quantity="device.uptime", factor=1000.0),
            "imu_stream_enabled": Value(quantity="stream.sensor"),
            "filter_stream_enabled": Value(quantity="stream.filter"),
            "comm_port_bytes_written": Value(quantity="device.bytes_sent"),
            "comm_port_bytes_read": Value(quantity="device.bytes_received"),
            "comm_port_write_overruns": Value(quantity="device.packets_dropped"),
            "imu_last_message_time": Value(quantity="device.uptime", factor=1000.0),
            "gnss_stream_enabled": Value(quantity="stream.gnss"),
        },
    ),
    "3dm.device_status_diagnostic_rq1_45_response": FieldValues(
        "",
        {
            "model_number": Value(quantity="device.number"),
            "system_timer": Value(quantity="device.uptime", factor=1000.0),
            "imu_stream_enabled": Value(quantity="stream.sensor"),
            "filter_stream_enabled": Value(quantity="stream.filter"),
            "comm_port_bytes_written": Value(quantity="device.bytes_sent"),
            "comm_port_bytes_read": Value(quantity="device.bytes_received"),
            "comm_port_write_overruns": Value(quantity="device.packets_dropped"),
            "imu_last_message_time": Value(quantity="device.uptime", factor=1000.0),
            "gnss_stream_enabled": Value(quantity="stream.gnss"),
        },
    ),
    "3dm.device_status_diagnostic_gx4_response": FieldValues(
        "",
        {
            "model_number": Value(quantity="device.number"),
            "system_timer": Value(quantity="device.uptime", factor=1000.0),
            "imu_stream_enabled": Value(quantity="stream.sensor"),
            "filter_stream_enabled": Value(quantity="stream.filter"),
            "comm_port_bytes_written": Value(quantity="device.bytes_sent"),
            "comm_port_bytes_read": Value(quantity="device.bytes_received"),
            "comm_port_write_overruns": Value(quantity="device.packets_dropped"),
            "imu_last_message_time": Value(quantity="device.uptime", factor=1000.0),
        },
    ),
    "3dm.device_status_diagnostic_imu_response": FieldValues(
        "",
        {
            "model_number": Value(quantity="device.number"),
            "system_timer": Value(quantity="device.uptime", factor=1000.0),
            "imu_stream_enabled": Value(quantity="stream.sensor"),
            "comm_port_bytes_written": Value(quantity="device.bytes_sent"),
            "comm_port_bytes_read": Value(quantity="device.bytes_received"),
            "comm_port_write_overruns": Value(quantity="device.packets_dropped"),
        },
    ),
    "gnss.receiver_info_response": FieldValues(
        "", {"receiver_info": Value(quantity="receiver.list")}
    ),
}

#: Commands -> what they do beside keeping a setting.
COMMANDS: dict[str, Behavior] = {
    "base.set_idle": Behavior(effect="idle"),
    "base.resume": Behavior(effect="resume"),
    "base.soft_reset": Behavior(effect="restart"),
    "base.built_in_test": Behavior(effect="self_test"),
    "base.comm_speed": Behavior(
        effect="baud_rate",
        arguments={"port": "port", "baud": "baud"},
        all={"port": 0},
        instances={"port": "ports"},
        initial={"baud": 115200},
    ),
    "base.gps_time_update": Behavior(
        effect="gps_time", arguments={"field": "field_id", "value": "value"}
    ),
    "3dm.poll_imu_data": Behavior(effect="poll", arguments={"set": 128, "fields": "descriptors"}),
    "3dm.poll_gnss_data": Behavior(effect="poll", arguments={"set": 129, "fields": "descriptors"}),
    "3dm.poll_filter_data": Behavior(
        effect="poll", arguments={"set": 130, "fields": "descriptors"}
    ),
    "3dm.poll_data": Behavior(
        effect="poll", arguments={"set": "descriptor_set", "fields": "descriptors"}
    ),
    "3dm.poll_nmea_data": Behavior(
        effect="poll_sentences", arguments={"entries": "format_entries"}
    ),
    "3dm.get_imu_base_rate": Behavior(arguments={"set": 128}),
    "3dm.get_gnss_base_rate": Behavior(arguments={"set": 129}),
    "3dm.get_filter_base_rate": Behavior(arguments={"set": 130}),
    "3dm.get_base_rate": Behavior(
        arguments={"set": "descriptor_set"}, instances={"descriptor_set": "data_sets"}
    ),
    "3dm.message_format": Behavior(
        effect="format",
        arguments={"set": "descriptor_set", "fields": "descriptors"},
        all={"descriptor_set": 0},
        instances={"descriptor_set": "data_sets"},
    ),
    "3dm.imu_message_format": Behavior(
        effect="format",
        arguments={"set": 128, "fields": "descriptors"},
        setting="3dm.message_format",
        key={"descriptor_set": 128},
    ),
    "3dm.gnss_message_format": Behavior(
        effect="format",
        arguments={"set": 129, "fields": "descriptors"},
        setting="3dm.message_format",
        key={"descriptor_set": 129},
    ),
    "3dm.filter_message_format": Behavior(
        effect="format",
        arguments={"set": 130, "fields": "descriptors"},
        setting="3dm.message_format",
        key={"descriptor_set": 130},
    ),
    "3dm.nmea_message_format": Behavior(
        effect="sentences", arguments={"entries": "format_entries"}
    ),
    "3dm.factory_streaming": Behavior(effect="factory_streaming", arguments={"action": "action"}),
    "3dm.data_stream_control": Behavior(
        effect="switch",
        arguments={"set": "descriptor_set", "enable": "enable"},
        all={"descriptor_set": 0},
        instances={"descriptor_set": "data_sets"},
        translate={"descriptor_set": {1: 128, 2: 129, 3: 130}},
    ),
    "3dm.event_control": Behavior(
        effect="trigger_mode",
        arguments={"instance": "instance", "mode": "mode"},
        all={"instance": 0},
        instances={"instance": "event_triggers"},
    ),
    "3dm.event_trigger_config": Behavior(
        effect="trigger",
        arguments={"instance": "instance"},
        all={"instance": 0},
        instances={"instance": "event_triggers"},
    ),
    "3dm.event_action_config": Behavior(
        effect="action", all={"instance": 0}, instances={"instance": "event_actions"}
    ),
    "3dm.get_event_support": Behavior(arguments={"query": "query"}),
    "3dm.get_event_trigger_status": Behavior(arguments={"instances": "requested_instances"}),
    "3dm.get_event_action_status": Behavior(arguments={"instances": "requested_instances"}),
    "3dm.device_settings": Behavior(effect="all_settings"),
    "3dm.sensor_to_vehicle_transform_euler": Behavior(
        effect="orientation_euler",
        arguments={"roll": "roll", "pitch": "pitch", "yaw": "yaw"},
        setting="3dm.sensor_to_vehicle_transform_quaternion",
    ),
    "3dm.sensor_to_vehicle_transform_quaternion": Behavior(
        effect="orientation_quaternion", arguments={"q": "q"}, initial={"q": (1.0, 0.0, 0.0, 0.0)}
    ),
    "3dm.sensor_to_vehicle_transform_dcm": Behavior(
        effect="orientation_dcm",
        arguments={"dcm": "dcm"},
        setting="3dm.sensor_to_vehicle_transform_quaternion",
    ),
    "filter.sensor_to_vehicle_rotation_euler": Behavior(
        effect="orientation_euler",
        arguments={"roll": "roll", "pitch": "pitch", "yaw": "yaw", "inverse": 1},
    ),
    "filter.sensor_to_vehicle_rotation_dcm": Behavior(
        effect="orientation_dcm",
        arguments={"dcm": "dcm", "inverse": 1},
        setting="filter.sensor_to_vehicle_rotation_euler",
    ),
    "filter.sensor_to_vehicle_rotation_quaternion": Behavior(
        effect="orientation_quaternion",
        arguments={"q": "q", "inverse": 1},
        setting="filter.sensor_to_vehicle_rotation_euler",
    ),
    "3dm.capture_gyro_bias": Behavior(
        effect="capture", arguments={"milliseconds": "averaging_time_ms"}, setting="3dm.gyro_bias"
    ),
    "3dm.mag_soft_iron_matrix": Behavior(
        initial={"matrix": (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)}
    ),
    "3dm.uart_baud_rate": Behavior(
        effect="baud_rate", arguments={"baud": "baud"}, initial={"baud": 115200}
    ),
    "3dm.gpio_config": Behavior(
        effect="pin",
        arguments={"pin": "pin", "feature": "feature", "behavior": "behavior"},
        all={"pin": 0},
        instances={"pin": "gpio_pins"},
    ),
    "3dm.gpio_state": Behavior(effect="pin_state", arguments={"pin": "pin", "state": "state"}),
    "3dm.sensor_range": Behavior(all={"sensor": 0}, initial={"setting": 1}),
    "3dm.get_calibrated_sensor_ranges": Behavior(arguments={"sensor": "sensor"}),
    "3dm.device_status": Behavior(
        effect="device_status",
        answers={
            "device_status_basic_without_state_response": (
                "3dm-gx4-15",
                "3dm-gx4-25",
                "3dm-gx5-10",
                "3dm-cx5-10",
                "3dm-cv5-10",
            ),
            "device_status_diagnostic_gnss_response": (
                "3dm-gx4-45",
                "3dm-gx5-35",
                "3dm-gx5-45",
                "3dm-cx5-35",
                "3dm-cx5-45",
            ),
            "device_status_diagnostic_gq4_45_response": ("3dm-gq4-45",),
            "device_status_diagnostic_rq1_45_response": ("3dm-rq1-45-lt", "3dm-rq1-45-st"),
            "device_status_diagnostic_gx4_response": ("3dm-gx4-15", "3dm-gx4-25"),
            "device_status_diagnostic_imu_response": ("3dm-gx5-10", "3dm-cx5-10", "3dm-cv5-10"),
        },
    ),
    "aiding.frame_config": Behavior(
        effect="frame_rotation",
        arguments={"format": "format", "rotation": "rotation"},
        instances={"frame_id": "aiding_frames"},
    ),
    "aiding.echo_control": Behavior(initial={"mode": 1}),
    "system.comm_mode": Behavior(effect="communication_mode", arguments={"mode": "mode"}),
}

#: Commands that are not acknowledged while the setting of another command has a value: (command, parameter, value).
SILENCED: dict[str, tuple[tuple[str, str, int], ...]] = {
    "aiding.ecef_position": (("aiding.echo_control", "mode", 0),),
    "aiding.llh_position": (("aiding.echo_control", "mode", 0),),
    "aiding.height_above_ellipsoid": (("aiding.echo_control", "mode", 0),),
    "aiding.ecef_velocity": (("aiding.echo_control", "mode", 0),),
    "aiding.ned_velocity": (("aiding.echo_control", "mode", 0),),
    "aiding.body_frame_velocity": (("aiding.echo_control", "mode", 0),),
    "aiding.true_heading": (("aiding.echo_control", "mode", 0),),
    "aiding.magnetic_field": (("aiding.echo_control", "mode", 0),),
    "aiding.pressure": (("aiding.echo_control", "mode", 0),),
}

#: Devices -> parameters of commands and responses that differ there.
DIFFERENCES: dict[str, dict[str, Difference]] = {
    "3dm-cl5-15": {"filter.heading_source.source": Difference(values=frozenset({0, 3}))},
    "3dm-cl5-25": {"filter.heading_source.source": Difference(values=frozenset({0, 1, 3}))},
    "3dm-cv5-15": {"filter.heading_source.source": Difference(values=frozenset({0, 3}))},
    "3dm-cv5-25": {"filter.heading_source.source": Difference(values=frozenset({0, 1, 3}))},
    "3dm-cv7-ahrs": {
        "3dm.pps_source_control.source": Difference(values=frozenset({0, 3, 4})),
        "filter.aiding_measurement_enable.aiding_source": Difference(
            values=frozenset({4, 5, 65535})
        ),
    },
    "3dm-cv7-ar": {
        "3dm.pps_source_control.source": Difference(values=frozenset({0, 3, 4})),
        "filter.aiding_measurement_enable.aiding_source": Difference(values=frozenset({5, 65535})),
    },
    "3dm-gq4-45": {
        "filter.heading_source.source": Difference(values=frozenset({0, 1, 2, 3})),
        "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
        "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
    },
    "3dm-gq7": {"filter.magnetic_declination_source.source": Difference(values=frozenset({2, 3}))},
    "3dm-gx3-45": {
        "filter.vehicle_dynamics_mode.mode": Difference(values=frozenset({1, 2, 3})),
        "filter.heading_source.source": Difference(values=frozenset({0, 1, 2, 3})),
        "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
        "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
    },
    "3dm-gx4-15": {
        "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
        "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
    },
    "3dm-gx4-25": {
        "filter.heading_source.source": Difference(values=frozenset({0, 1, 3})),
        "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
        "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
    },
    "3dm-gx4-45": {
        "filter.heading_source.source": Difference(values=frozenset({0, 1, 2, 3})),
        "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
        "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
    },
    "3dm-gx5-15": {
        "3dm.uart_baud_rate.baud": Difference(default=115200),
        "3dm.imu_low_pass_filter.frequency": Difference(maximum=250),
        "3dm.complementary_filter.pitch_roll_enable": Difference(default=True),
        "3dm.complementary_filter.heading_enable": Difference(default=True),
        "3dm.device_status.model_number": Difference(constant=6254),
        "filter.heading_source.source": Difference(values=frozenset({0, 3})),
    },
    "3dm-gx5-25": {"filter.heading_source.source": Difference(values=frozenset({0, 1, 3}))},
    "3dm-gx5-35": {
        "3dm.gnss_sbas_settings.enable_sbas": Difference(default=1),
        "3dm.gnss_sbas_settings.sbas_options": Difference(default=3),
        "3dm.gnss_assisted_fix.option": Difference(default=0),
        "3dm.gnss_assisted_fix.flags": Difference(default=255),
        "3dm.device_status.model_number": Difference(constant=6252),
        "system.comm_mode.mode": Difference(default=1),
    },
    "3dm-gx5-45": {
        "3dm.mag_hard_iron_offset.offset": Difference(default=(0, 0, 0)),
        "3dm.uart_baud_rate.baud": Difference(default=115200),
        "3dm.device_status.model_number": Difference(constant=6251),
        "filter.adaptive_filter_options.level": Difference(values=frozenset({0, 2})),
    },
    "3dm-rq1-45-lt": {
        "filter.heading_source.source": Difference(values=frozenset({0, 2, 3})),
        "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
        "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
    },
    "3dm-rq1-45-st": {
        "filter.heading_source.source": Difference(values=frozenset({0, 2, 3})),
        "filter.accel_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
        "filter.mag_magnitude_error_adaptive_measurement.adaptive_measurement": Difference(
            values=frozenset({0, 1})
        ),
    },
}
