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
    "port.incoming": None,
    "port.outgoing": None,
    "pin.level": None,
    "sensor.ranges": None,
    "receiver.list": None,
    "gps.tow": "s",
    "gps.week": "week",
    "gps.seconds": "s",
    "gps.microseconds": "us",
    "gps.time": "ns",
    "gps.flags": None,
    "gps.leap_seconds": "s",
    "gps.pulse_age": "s",
    "utc.year": None,
    "utc.month": None,
    "utc.day": None,
    "utc.hour": None,
    "utc.minute": None,
    "utc.second": "s",
    "utc.millisecond": "ms",
    "reference.time": "ns",
    "reference.delta": "ns",
    "external.delta": "ns",
    "ticks.count": "1",
    "ticks.delta": "1",
    "event.trigger": None,
    "measured.specific_force": "m/s^2",
    "measured.angular_rate": "rad/s",
    "measured.magnetic_field": "gauss",
    "measured.pressure": "mbar",
    "measured.speed": "m/s",
    "counts.specific_force": "1",
    "counts.angular_rate": "1",
    "counts.magnetic_field": "1",
    "counts.pressure": "1",
    "counts.temperature": "1",
    "delta.rotation": "rad",
    "delta.velocity": "m/s",
    "delta.matrix": "1",
    "stabilized.up": "m/s^2",
    "stabilized.north": "gauss",
    "temperature.min": "degC",
    "temperature.max": "degC",
    "temperature.mean": "degC",
    "gpio.states": None,
    "gpio.voltage": "V",
    "attitude.quaternion": "1",
    "attitude.dcm": "1",
    "attitude.roll": "rad",
    "attitude.pitch": "rad",
    "attitude.yaw": "rad",
    "motion.angular_rate": "rad/s",
    "motion.specific_force": "m/s^2",
    "motion.acceleration": "m/s^2",
    "gravity.vector": "m/s^2",
    "gravity.magnitude": "m/s^2",
    "bias.angular_rate": "rad/s",
    "bias.specific_force": "m/s^2",
    "bias.gyro_setting": "rad/s",
    "identity.matrix": "1",
    "identity.quaternion": "1",
    "covariance.magnetic_field": None,
    "position.latitude": "rad",
    "position.longitude": "rad",
    "position.height": "m",
    "position.msl_height": "m",
    "position.ecef": "m",
    "position.relative": "m",
    "velocity.north": "m/s",
    "velocity.east": "m/s",
    "velocity.down": "m/s",
    "velocity.ecef": "m/s",
    "magnetic.north": "gauss",
    "magnetic.east": "gauss",
    "magnetic.down": "gauss",
    "magnetic.inclination": "rad",
    "magnetic.declination": "rad",
    "air.altitude": "m",
    "air.temperature": "degC",
    "air.pressure": "mbar",
    "air.density": "kg/m^3",
    "filter.position_uncertainty": "m",
    "filter.aids": None,
    "aid.source": None,
    "aid.type": None,
    "filter.receivers": None,
    "receiver.id": None,
    "receiver.clock_bias": "s",
    "receiver.clock_drift": "s/s",
    "gnss_1.latitude": "rad",
    "gnss_1.longitude": "rad",
    "gnss_1.height": "m",
    "gnss_1.msl_height": "m",
    "gnss_1.ecef": "m",
    "gnss_1.velocity": "m/s",
    "gnss_1.ecef_velocity": "m/s",
    "gnss_1.speed": "m/s",
    "gnss_1.ground_speed": "m/s",
    "gnss_1.course": "rad",
    "gnss_1.course_accuracy": "rad",
    "gnss_1.clock_bias": "s",
    "gnss_1.clock_drift": "s/s",
    "gnss_1.satellites": None,
    "gnss_2.latitude": "rad",
    "gnss_2.longitude": "rad",
    "gnss_2.height": "m",
    "gnss_2.msl_height": "m",
    "gnss_2.ecef": "m",
    "gnss_2.velocity": "m/s",
    "gnss_2.ecef_velocity": "m/s",
    "gnss_2.speed": "m/s",
    "gnss_2.ground_speed": "m/s",
    "gnss_2.course": "rad",
    "gnss_2.course_accuracy": "rad",
    "gnss_2.clock_bias": "s",
    "gnss_2.clock_drift": "s/s",
    "gnss_2.satellites": None,
    "dop.gdop": "1",
    "dop.pdop": "1",
    "dop.hdop": "1",
    "dop.vdop": "1",
    "dop.tdop": "1",
    "dop.ndop": "1",
    "dop.edop": "1",
    "gnss.horizontal_accuracy": "m",
    "gnss.vertical_accuracy": "m",
    "gnss.position_accuracy": "m",
    "satellite.index": None,
    "satellite.count": None,
    "satellite.used": "1",
    "satellite.channel": None,
    "satellite.constellation": None,
    "satellite.id": None,
    "satellite.signal": None,
    "satellite.elevation": "rad",
    "satellite.azimuth": "rad",
    "satellite.strength": "dB-Hz",
    "satellite.pseudorange": "m",
    "satellite.phase": "cycle",
    "satellite.doppler": "Hz",
    "satellite.lock_time": "s",
    "gnss.gps_satellites": None,
    "sbas.system": None,
    "sbas.id": None,
    "sbas.corrections": "1",
    "base_station.ecef": "m",
    "ephemeris.gps": None,
    "ephemeris.glonass": None,
    "ephemeris.galileo": None,
    "ephemeris.beidou": None,
    "ephemeris.satellite": None,
    "ephemeris.index": None,
    "ephemeris.count": None,
    "ephemeris.issue": None,
    "ephemeris.reference_time": "s",
    "ephemeris.semi_major_axis": "m",
    "ephemeris.mean_anomaly": "rad",
    "ephemeris.eccentricity": "1",
    "ephemeris.argument_of_perigee": "rad",
    "ephemeris.node": "rad",
    "ephemeris.node_rate": "rad/s",
    "ephemeris.inclination": "rad",
    "ephemeris.clock_bias": "s",
    "ephemeris.frequency": None,
    "ephemeris.time_of_day": "s",
    "ephemeris.day_time": "s",
    "ephemeris.day": "day",
    "ephemeris.odd": None,
    "ephemeris.position": "m",
    "ephemeris.velocity": "m/s",
}

#: Names of effects -> their arguments.
EFFECTS: dict[str, tuple[str, ...]] = {
    "accel_bias": ("bias",),
    "all_settings": (),
    "baud_rate": ("port", "baud"),
    "capture": ("milliseconds",),
    "communication_mode": ("mode",),
    "device_status": ("sensor", "gnss", "filter"),
    "factory_streaming": ("action",),
    "format": ("set", "fields"),
    "frame_rotation": ("format", "rotation"),
    "gps_time": ("field", "value"),
    "gyro_bias": ("bias",),
    "idle": (),
    "orientation_dcm": ("dcm", "inverse"),
    "orientation_euler": ("roll", "pitch", "yaw", "inverse"),
    "orientation_quaternion": ("q", "inverse"),
    "pin": ("pin", "feature", "behavior", "options"),
    "pin_state": ("pin", "state"),
    "poll": ("set", "fields"),
    "poll_sentences": ("entries",),
    "protocols": ("port", "incoming", "outgoing"),
    "restart": (),
    "resume": (),
    "self_test": (),
    "sentences": ("entries",),
    "switch": ("set", "enable"),
    "trigger": (
        "instance",
        "type",
        "pin",
        "pin_mode",
        "set",
        "field",
        "element",
        "low",
        "high",
        "threshold",
        "interval",
        "table",
        "inputs",
    ),
    "trigger_mode": ("instance", "mode"),
    "action": ("instance", "trigger", "type", "pin", "pin_mode", "set", "decimation", "fields"),
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
    "3dm.gyro_bias_response": FieldValues("", {"bias": Value(quantity="bias.gyro_setting")}),
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
    "system.interface_control_response": FieldValues(
        "",
        {
            "protocols_incoming": Value(quantity="port.incoming"),
            "protocols_outgoing": Value(quantity="port.outgoing"),
        },
    ),
    "gnss.receiver_info_response": FieldValues(
        "", {"receiver_info": Value(quantity="receiver.list")}
    ),
    "sensor.raw_accel": FieldValues("", {"raw_accel": Value(quantity="counts.specific_force")}),
    "sensor.raw_gyro": FieldValues("", {"raw_gyro": Value(quantity="counts.angular_rate")}),
    "sensor.raw_mag": FieldValues("", {"raw_mag": Value(quantity="counts.magnetic_field")}),
    "sensor.scaled_accel": FieldValues(
        "", {"scaled_accel": Value(quantity="measured.specific_force", factor=0.10197162129779283)}
    ),
    "sensor.scaled_gyro": FieldValues("", {"scaled_gyro": Value(quantity="measured.angular_rate")}),
    "sensor.scaled_mag": FieldValues("", {"scaled_mag": Value(quantity="measured.magnetic_field")}),
    "sensor.delta_theta": FieldValues("", {"delta_theta": Value(quantity="delta.rotation")}),
    "sensor.delta_velocity": FieldValues(
        "", {"delta_velocity": Value(quantity="delta.velocity", factor=0.10197162129779283)}
    ),
    "sensor.comp_orientation_matrix": FieldValues("", {"m": Value(quantity="attitude.dcm")}),
    "sensor.comp_quaternion": FieldValues("", {"q": Value(quantity="attitude.quaternion")}),
    "sensor.comp_orientation_update_matrix": FieldValues("", {"m": Value(quantity="delta.matrix")}),
    "sensor.comp_euler_angles": FieldValues(
        "",
        {
            "roll": Value(quantity="attitude.roll"),
            "pitch": Value(quantity="attitude.pitch"),
            "yaw": Value(quantity="attitude.yaw"),
        },
    ),
    "sensor.orientation_raw_temperature": FieldValues(
        "", {"raw_temperature": Value(quantity="counts.temperature")}
    ),
    "sensor.internal_timestamp": FieldValues("", {"counts": Value(quantity="ticks.count")}),
    "sensor.pps_timestamp": FieldValues(
        "",
        {"seconds": Value(quantity="gps.seconds"), "useconds": Value(quantity="gps.microseconds")},
    ),
    "sensor.north_vector": FieldValues("", {"stabilized_mag": Value(quantity="stabilized.north")}),
    "sensor.up_vector": FieldValues(
        "", {"stabilized_accel": Value(quantity="stabilized.up", factor=0.10197162129779283)}
    ),
    "sensor.gps_timestamp": FieldValues(
        "",
        {
            "tow": Value(quantity="gps.tow"),
            "week_number": Value(quantity="gps.week"),
            "valid_flags": Value(quantity="gps.flags"),
        },
    ),
    "sensor.temperature_statistics": FieldValues(
        "",
        {
            "min_temperature": Value(quantity="temperature.min"),
            "max_temperature": Value(quantity="temperature.max"),
            "mean_temperature": Value(quantity="temperature.mean"),
        },
    ),
    "sensor.raw_pressure": FieldValues("", {"raw_pressure": Value(quantity="counts.pressure")}),
    "sensor.scaled_pressure": FieldValues(
        "", {"scaled_pressure": Value(quantity="measured.pressure")}
    ),
    "sensor.overrange_status": FieldValues("", {"status": Value(number=0)}),
    "sensor.odometer": FieldValues(
        "", {"speed": Value(quantity="measured.speed"), "uncertainty": Value(number=0.05)}
    ),
    "shared.event_source": FieldValues("", {"trigger_id": Value(quantity="event.trigger")}),
    "shared.ticks": FieldValues("", {"ticks": Value(quantity="ticks.count")}),
    "shared.delta_ticks": FieldValues("", {"ticks": Value(quantity="ticks.delta")}),
    "shared.gps_timestamp": FieldValues(
        "", {"tow": Value(quantity="gps.tow"), "week_number": Value(quantity="gps.week")}
    ),
    "shared.delta_time": FieldValues(
        "", {"seconds": Value(quantity="external.delta", factor=1e-09)}
    ),
    "shared.reference_timestamp": FieldValues(
        "", {"nanoseconds": Value(quantity="reference.time")}
    ),
    "shared.reference_time_delta": FieldValues("", {"dt_nanos": Value(quantity="reference.delta")}),
    "shared.external_timestamp": FieldValues("", {"nanoseconds": Value(quantity="gps.time")}),
    "shared.external_time_delta": FieldValues("", {"dt_nanos": Value(quantity="external.delta")}),
    "filter_data.llh_position": FieldValues(
        "",
        {
            "latitude": Value(quantity="position.latitude", factor=57.29577951308232),
            "longitude": Value(quantity="position.longitude", factor=57.29577951308232),
            "ellipsoid_height": Value(quantity="position.height"),
        },
    ),
    "filter_data.ned_velocity": FieldValues(
        "",
        {
            "north": Value(quantity="velocity.north"),
            "east": Value(quantity="velocity.east"),
            "down": Value(quantity="velocity.down"),
        },
    ),
    "filter_data.attitude_quaternion": FieldValues(
        "", {"q": Value(quantity="attitude.quaternion")}
    ),
    "filter_data.attitude_dcm": FieldValues("", {"dcm": Value(quantity="attitude.dcm")}),
    "filter_data.euler_angles": FieldValues(
        "",
        {
            "roll": Value(quantity="attitude.roll"),
            "pitch": Value(quantity="attitude.pitch"),
            "yaw": Value(quantity="attitude.yaw"),
        },
    ),
    "filter_data.gyro_bias": FieldValues("", {"bias": Value(quantity="bias.angular_rate")}),
    "filter_data.accel_bias": FieldValues("", {"bias": Value(quantity="bias.specific_force")}),
    "filter_data.llh_position_uncertainty": FieldValues(
        "",
        {
            "north": Value(quantity="filter.position_uncertainty"),
            "east": Value(quantity="filter.position_uncertainty"),
            "down": Value(quantity="filter.position_uncertainty"),
        },
    ),
    "filter_data.ned_velocity_uncertainty": FieldValues(
        "", {"north": Value(number=0.03), "east": Value(number=0.03), "down": Value(number=0.03)}
    ),
    "filter_data.euler_angles_uncertainty": FieldValues(
        "", {"roll": Value(number=0.002), "pitch": Value(number=0.002), "yaw": Value(number=0.01)}
    ),
    "filter_data.gyro_bias_uncertainty": FieldValues("", {"bias_uncertainty": Value(number=2e-05)}),
    "filter_data.accel_bias_uncertainty": FieldValues(
        "", {"bias_uncertainty": Value(number=0.005)}
    ),
    "filter_data.linear_accel": FieldValues("", {"accel": Value(quantity="motion.acceleration")}),
    "filter_data.comp_angular_rate": FieldValues(
        "", {"gyro": Value(quantity="motion.angular_rate")}
    ),
    "filter_data.wgs84_gravity_magnitude": FieldValues(
        "", {"gravity_magnitude": Value(quantity="gravity.magnitude")}
    ),
    "filter_data.status": FieldValues(
        "",
        {
            "filter_state": Value(names=("full_nav", "run_solution_valid")),
            "dynamics_mode": Value(names=("default", "portable")),
            "status_flags": Value(bits=("filter_condition.stable",)),
        },
    ),
    "filter_data.timestamp": FieldValues(
        "", {"tow": Value(quantity="gps.tow"), "week_number": Value(quantity="gps.week")}
    ),
    "filter_data.quaternion_attitude_uncertainty": FieldValues("", {"q": Value(number=0.005)}),
    "filter_data.gravity_vector": FieldValues("", {"gravity": Value(quantity="gravity.vector")}),
    "filter_data.heading_update_state": FieldValues(
        "",
        {
            "heading": Value(quantity="attitude.yaw"),
            "heading_uncertainty": Value(number=0.02),
            "source": Value(bits=("external",)),
        },
    ),
    "filter_data.magnetic_model": FieldValues(
        "",
        {
            "intensity_north": Value(quantity="magnetic.north"),
            "intensity_east": Value(quantity="magnetic.east"),
            "intensity_down": Value(quantity="magnetic.down"),
            "inclination": Value(quantity="magnetic.inclination"),
            "declination": Value(quantity="magnetic.declination"),
        },
    ),
    "filter_data.gyro_scale_factor": FieldValues("", {"scale_factor": Value(number=0)}),
    "filter_data.accel_scale_factor": FieldValues("", {"scale_factor": Value(number=0)}),
    "filter_data.gyro_scale_factor_uncertainty": FieldValues(
        "", {"scale_factor_uncertainty": Value(number=0.001)}
    ),
    "filter_data.accel_scale_factor_uncertainty": FieldValues(
        "", {"scale_factor_uncertainty": Value(number=0.001)}
    ),
    "filter_data.mag_bias": FieldValues("", {"bias": Value(number=0)}),
    "filter_data.mag_bias_uncertainty": FieldValues("", {"bias_uncertainty": Value(number=0.001)}),
    "filter_data.comp_accel": FieldValues("", {"accel": Value(quantity="motion.specific_force")}),
    "filter_data.standard_atmosphere": FieldValues(
        "",
        {
            "geometric_altitude": Value(quantity="position.msl_height"),
            "geopotential_altitude": Value(quantity="air.altitude"),
            "standard_temperature": Value(quantity="air.temperature"),
            "standard_pressure": Value(quantity="air.pressure"),
            "standard_density": Value(quantity="air.density"),
        },
    ),
    "filter_data.pressure_altitude": FieldValues(
        "", {"pressure_altitude": Value(quantity="air.altitude")}
    ),
    "filter_data.density_altitude": FieldValues(
        "", {"density_altitude": Value(quantity="air.altitude")}
    ),
    "filter_data.mag_offset": FieldValues("", {"hard_iron": Value(number=0)}),
    "filter_data.mag_matrix": FieldValues("", {"soft_iron": Value(quantity="identity.matrix")}),
    "filter_data.mag_offset_uncertainty": FieldValues(
        "", {"hard_iron_uncertainty": Value(number=0.001)}
    ),
    "filter_data.mag_matrix_uncertainty": FieldValues(
        "", {"soft_iron_uncertainty": Value(number=0.001)}
    ),
    "filter_data.mag_covariance_matrix": FieldValues(
        "", {"covariance": Value(quantity="covariance.magnetic_field")}
    ),
    "filter_data.mag_residual_vector": FieldValues("", {"residual": Value(number=0)}),
    "filter_data.antenna_offset_correction": FieldValues("", {"offset": Value(number=0)}),
    "filter_data.antenna_offset_correction_uncertainty": FieldValues(
        "", {"offset_uncertainty": Value(number=0.01)}
    ),
    "filter_data.clock_correction": FieldValues(
        "filter.receivers",
        {
            "receiver_id": Value(quantity="receiver.id"),
            "bias": Value(quantity="receiver.clock_bias"),
            "bias_drift": Value(quantity="receiver.clock_drift"),
        },
    ),
    "filter_data.clock_correction_uncertainty": FieldValues(
        "filter.receivers",
        {
            "receiver_id": Value(quantity="receiver.id"),
            "bias_uncertainty": Value(number=1e-08),
            "bias_drift_uncertainty": Value(number=1e-09),
        },
    ),
    "filter_data.multi_antenna_offset_correction": FieldValues(
        "filter.receivers",
        {"receiver_id": Value(quantity="receiver.id"), "offset": Value(number=0)},
    ),
    "filter_data.multi_antenna_offset_correction_uncertainty": FieldValues(
        "filter.receivers",
        {"receiver_id": Value(quantity="receiver.id"), "offset_uncertainty": Value(number=0.01)},
    ),
    "filter_data.ecef_position_uncertainty": FieldValues(
        "", {"position_uncertainty": Value(number=0.6)}
    ),
    "filter_data.ecef_velocity_uncertainty": FieldValues(
        "", {"velocity_uncertainty": Value(number=0.03)}
    ),
    "filter_data.ecef_position": FieldValues("", {"position": Value(quantity="position.ecef")}),
    "filter_data.ecef_velocity": FieldValues("", {"velocity": Value(quantity="velocity.ecef")}),
    "filter_data.ned_relative_position": FieldValues(
        "", {"relative_position": Value(quantity="position.relative")}
    ),
    "filter_data.gnss_position_aiding_status": FieldValues(
        "filter.receivers",
        {
            "receiver_id": Value(quantity="receiver.id"),
            "tow": Value(quantity="gps.tow"),
            "status": Value(
                bits=("tight_coupling", "gps_l1", "glonass_l1", "galileo_e1", "beidou_b1")
            ),
        },
    ),
    "filter_data.gnss_attitude_aiding_status": FieldValues(
        "",
        {
            "tow": Value(quantity="gps.tow"),
            "status": Value(
                bits=("tight_coupling", "gps_l1", "glonass_l1", "galileo_e1", "beidou_b1")
            ),
        },
    ),
    "filter_data.heading_aiding_status": FieldValues(
        "", {"tow": Value(quantity="gps.tow"), "type": Value(names=("dual_antenna",))}
    ),
    "filter_data.aiding_measurement_summary": FieldValues(
        "filter.aids",
        {
            "tow": Value(quantity="gps.tow"),
            "source": Value(quantity="aid.source"),
            "type": Value(quantity="aid.type"),
            "indicator": Value(bits=("enabled", "used")),
        },
    ),
    "filter_data.odometer_scale_factor_error": FieldValues(
        "", {"scale_factor_error": Value(number=0)}
    ),
    "filter_data.odometer_scale_factor_error_uncertainty": FieldValues(
        "", {"scale_factor_error_uncertainty": Value(number=0.002)}
    ),
    "filter_data.gnss_dual_antenna_status": FieldValues(
        "",
        {
            "tow": Value(quantity="gps.tow"),
            "heading": Value(quantity="attitude.yaw"),
            "heading_uncertainty": Value(number=0.005),
            "fix_type": Value(names=("fix_da_fixed",)),
            "status_flags": Value(
                bits=("receiver_1_data_valid", "receiver_2_data_valid", "antenna_offsets_valid")
            ),
        },
    ),
    "filter_data.aiding_frame_config_error": FieldValues(
        "",
        {
            "frame_id": Value(number=1),
            "translation": Value(number=0),
            "attitude": Value(quantity="identity.quaternion"),
        },
    ),
    "filter_data.aiding_frame_config_error_uncertainty": FieldValues(
        "",
        {
            "frame_id": Value(number=1),
            "translation_uncertainty": Value(number=0.01),
            "attitude_uncertainty": Value(number=0.005),
        },
    ),
    "gnss_1.llh_position": FieldValues(
        "",
        {
            "latitude": Value(quantity="gnss_1.latitude", factor=57.29577951308232),
            "longitude": Value(quantity="gnss_1.longitude", factor=57.29577951308232),
            "ellipsoid_height": Value(quantity="gnss_1.height"),
            "msl_height": Value(quantity="gnss_1.msl_height"),
            "horizontal_accuracy": Value(quantity="gnss.horizontal_accuracy"),
            "vertical_accuracy": Value(quantity="gnss.vertical_accuracy"),
        },
    ),
    "gnss_1.ecef_position": FieldValues(
        "",
        {
            "position": Value(quantity="gnss_1.ecef"),
            "position_accuracy": Value(quantity="gnss.position_accuracy"),
        },
    ),
    "gnss_1.ned_velocity": FieldValues(
        "",
        {
            "velocity": Value(quantity="gnss_1.velocity"),
            "speed": Value(quantity="gnss_1.speed"),
            "ground_speed": Value(quantity="gnss_1.ground_speed"),
            "heading": Value(quantity="gnss_1.course", factor=57.29577951308232),
            "speed_accuracy": Value(number=0.1),
            "heading_accuracy": Value(quantity="gnss_1.course_accuracy", factor=57.29577951308232),
        },
    ),
    "gnss_1.ecef_velocity": FieldValues(
        "",
        {
            "velocity": Value(quantity="gnss_1.ecef_velocity"),
            "velocity_accuracy": Value(number=0.1),
        },
    ),
    "gnss_1.dop": FieldValues(
        "",
        {
            "gdop": Value(quantity="dop.gdop"),
            "pdop": Value(quantity="dop.pdop"),
            "hdop": Value(quantity="dop.hdop"),
            "vdop": Value(quantity="dop.vdop"),
            "tdop": Value(quantity="dop.tdop"),
            "ndop": Value(quantity="dop.ndop"),
            "edop": Value(quantity="dop.edop"),
        },
    ),
    "gnss_1.utc_time": FieldValues(
        "",
        {
            "year": Value(quantity="utc.year"),
            "month": Value(quantity="utc.month"),
            "day": Value(quantity="utc.day"),
            "hour": Value(quantity="utc.hour"),
            "min": Value(quantity="utc.minute"),
            "sec": Value(quantity="utc.second"),
            "msec": Value(quantity="utc.millisecond"),
            "valid_flags": Value(bits=("leap_seconds_known",)),
        },
    ),
    "gnss_1.gps_time": FieldValues(
        "", {"tow": Value(quantity="gps.tow"), "week_number": Value(quantity="gps.week")}
    ),
    "gnss_1.clock_info": FieldValues(
        "",
        {
            "bias": Value(quantity="gnss_1.clock_bias"),
            "drift": Value(quantity="gnss_1.clock_drift"),
            "accuracy_estimate": Value(number=1e-08),
        },
    ),
    "gnss_1.fix_info": FieldValues(
        "",
        {
            "fix_type": Value(names=("fix_3d",)),
            "num_sv": Value(quantity="satellite.used"),
            "fix_flags": Value(bits=("sbas_used",)),
        },
    ),
    "gnss_1.sv_info": FieldValues(
        "gnss_1.satellites",
        {
            "channel": Value(quantity="satellite.channel"),
            "satellite_id": Value(quantity="satellite.id"),
            "carrier_noise_ratio": Value(quantity="satellite.strength"),
            "azimuth": Value(quantity="satellite.azimuth", factor=57.29577951308232),
            "elevation": Value(quantity="satellite.elevation", factor=57.29577951308232),
            "sv_flags": Value(bits=("used_for_navigation", "healthy")),
        },
    ),
    "gnss_1.hardware_status": FieldValues(
        "",
        {
            "receiver_state": Value(names=("on",)),
            "antenna_state": Value(names=("good",)),
            "antenna_power": Value(names=("on",)),
        },
    ),
    "gnss_1.dgps_info": FieldValues(
        "",
        {
            "age": Value(number=1),
            "base_station_id": Value(number=1),
            "base_station_status": Value(number=0),
            "num_channels": Value(quantity="sbas.corrections"),
        },
    ),
    "gnss_1.dgps_channel": FieldValues(
        "gnss.gps_satellites",
        {
            "satellite_id": Value(quantity="satellite.id"),
            "age": Value(number=1),
            "range_correction": Value(number=0),
            "range_rate_correction": Value(number=0),
        },
    ),
    "gnss_1.clock_info_2": FieldValues(
        "",
        {
            "bias": Value(quantity="gnss_1.clock_bias"),
            "drift": Value(quantity="gnss_1.clock_drift"),
            "bias_accuracy_estimate": Value(number=1e-08),
            "drift_accuracy_estimate": Value(number=1e-09),
        },
    ),
    "gnss_1.gps_leap_seconds": FieldValues(
        "", {"leap_seconds": Value(quantity="gps.leap_seconds")}
    ),
    "gnss_1.sbas_info": FieldValues(
        "",
        {
            "tow": Value(quantity="gps.tow"),
            "week_number": Value(quantity="gps.week"),
            "sbas_system": Value(quantity="sbas.system"),
            "sbas_id": Value(quantity="sbas.id"),
            "count": Value(quantity="sbas.corrections"),
            "sbas_status": Value(
                bits=("range_available", "corrections_available", "integrity_available")
            ),
        },
    ),
    "gnss_1.sbas_correction": FieldValues(
        "gnss.gps_satellites",
        {
            "index": Value(quantity="satellite.index"),
            "count": Value(quantity="satellite.count"),
            "tow": Value(quantity="gps.tow"),
            "week_number": Value(quantity="gps.week"),
            "gnss_id": Value(quantity="satellite.constellation"),
            "satellite_id": Value(quantity="satellite.id"),
            "udrei": Value(number=5),
            "pseudorange_correction": Value(number=0),
            "iono_correction": Value(number=0),
        },
    ),
    "gnss_1.rf_error_detection": FieldValues(
        "",
        {
            "rf_band": Value(names=("l1",)),
            "jamming_state": Value(names=("none",)),
            "spoofing_state": Value(names=("none",)),
        },
    ),
    "gnss_1.satellite_status": FieldValues(
        "gnss_1.satellites",
        {
            "index": Value(quantity="satellite.index"),
            "count": Value(quantity="satellite.count"),
            "tow": Value(quantity="gps.tow"),
            "week_number": Value(quantity="gps.week"),
            "gnss_id": Value(quantity="satellite.constellation"),
            "satellite_id": Value(quantity="satellite.id"),
            "elevation": Value(quantity="satellite.elevation", factor=57.29577951308232),
            "azimuth": Value(quantity="satellite.azimuth", factor=57.29577951308232),
            "health": Value(number=1),
        },
    ),
    "gnss_1.raw": FieldValues(
        "gnss_1.satellites",
        {
            "index": Value(quantity="satellite.index"),
            "count": Value(quantity="satellite.count"),
            "tow": Value(quantity="gps.tow"),
            "week_number": Value(quantity="gps.week"),
            "receiver_id": Value(number=1),
            "tracking_channel": Value(quantity="satellite.channel"),
            "gnss_id": Value(quantity="satellite.constellation"),
            "satellite_id": Value(quantity="satellite.id"),
            "signal_id": Value(quantity="satellite.signal"),
            "signal_strength": Value(quantity="satellite.strength"),
            "quality": Value(names=("fully_locked",)),
            "pseudorange": Value(quantity="satellite.pseudorange"),
            "carrier_phase": Value(quantity="satellite.phase"),
            "doppler": Value(quantity="satellite.doppler"),
            "range_uncertainty": Value(number=0.5),
            "phase_uncertainty": Value(number=0.01),
            "doppler_uncertainty": Value(number=0.1),
            "lock_time": Value(quantity="satellite.lock_time"),
        },
    ),
    "gnss_1.base_station_info": FieldValues(
        "",
        {
            "tow": Value(quantity="gps.tow"),
            "week_number": Value(quantity="gps.week"),
            "ecef_position": Value(quantity="base_station.ecef"),
            "height": Value(number=0),
            "station_id": Value(number=1),
            "indicators": Value(bits=("gps", "glonass", "galileo", "beidou")),
        },
    ),
    "gnss_1.rtk_corrections_status": FieldValues(
        "",
        {
            "tow": Value(quantity="gps.tow"),
            "week_number": Value(quantity="gps.week"),
            "epoch_status": Value(
                bits=(
                    "antenna_location_received",
                    "gps_received",
                    "glonass_received",
                    "galileo_received",
                    "beidou_received",
                )
            ),
            "dongle_status": Value(number=0),
            "gps_correction_latency": Value(number=1),
            "glonass_correction_latency": Value(number=1),
            "galileo_correction_latency": Value(number=1),
            "beidou_correction_latency": Value(number=1),
        },
    ),
    "gnss_1.gps_ephemeris": FieldValues(
        "ephemeris.gps",
        {
            "index": Value(quantity="ephemeris.index"),
            "count": Value(quantity="ephemeris.count"),
            "tow": Value(quantity="gps.tow"),
            "week_number": Value(quantity="gps.week"),
            "satellite_id": Value(quantity="ephemeris.satellite"),
            "health": Value(number=0),
            "iodc": Value(quantity="ephemeris.issue"),
            "iode": Value(quantity="ephemeris.issue"),
            "t_oc": Value(quantity="ephemeris.reference_time"),
            "af0": Value(quantity="ephemeris.clock_bias"),
            "af1": Value(number=0),
            "af2": Value(number=0),
            "t_gd": Value(number=0),
            "isc_l1ca": Value(number=0),
            "isc_l2c": Value(number=0),
            "t_oe": Value(quantity="ephemeris.reference_time"),
            "a": Value(quantity="ephemeris.semi_major_axis"),
            "a_dot": Value(number=0),
            "mean_anomaly": Value(quantity="ephemeris.mean_anomaly"),
            "delta_mean_motion": Value(number=0),
            "delta_mean_motion_dot": Value(number=0),
            "eccentricity": Value(quantity="ephemeris.eccentricity"),
            "argument_of_perigee": Value(quantity="ephemeris.argument_of_perigee"),
            "omega": Value(quantity="ephemeris.node"),
            "omega_dot": Value(quantity="ephemeris.node_rate"),
            "inclination": Value(quantity="ephemeris.inclination"),
            "inclination_dot": Value(number=0),
            "c_ic": Value(number=0),
            "c_is": Value(number=0),
            "c_uc": Value(number=0),
            "c_us": Value(number=0),
            "c_rc": Value(number=0),
            "c_rs": Value(number=0),
        },
    ),
    "gnss_1.glonass_ephemeris": FieldValues(
        "ephemeris.glonass",
        {
            "index": Value(quantity="ephemeris.index"),
            "count": Value(quantity="ephemeris.count"),
            "tow": Value(quantity="gps.tow"),
            "week_number": Value(quantity="gps.week"),
            "satellite_id": Value(quantity="ephemeris.satellite"),
            "frequency_number": Value(quantity="ephemeris.frequency"),
            "tk": Value(quantity="ephemeris.time_of_day"),
            "tb": Value(quantity="ephemeris.day_time"),
            "satellite_type": Value(names=("glonass_m",)),
            "gamma": Value(number=0),
            "tau_n": Value(quantity="ephemeris.clock_bias"),
            "position": Value(quantity="ephemeris.position"),
            "velocity": Value(quantity="ephemeris.velocity"),
            "accel": Value(number=0),
            "health": Value(number=0),
            "p": Value(number=3),
            "nt": Value(quantity="ephemeris.day"),
            "delta_tau_n": Value(number=0),
            "ft": Value(number=2),
            "en": Value(number=0),
            "p1": Value(number=30),
            "p2": Value(quantity="ephemeris.odd"),
            "p3": Value(number=5),
            "p4": Value(number=1),
        },
    ),
    "gnss_1.galileo_ephemeris": FieldValues(
        "ephemeris.galileo",
        {
            "index": Value(quantity="ephemeris.index"),
            "count": Value(quantity="ephemeris.count"),
            "tow": Value(quantity="gps.tow"),
            "week_number": Value(quantity="gps.week"),
            "satellite_id": Value(quantity="ephemeris.satellite"),
            "health": Value(number=0),
            "iodc": Value(quantity="ephemeris.issue"),
            "iode": Value(quantity="ephemeris.issue"),
            "t_oc": Value(quantity="ephemeris.reference_time"),
            "af0": Value(quantity="ephemeris.clock_bias"),
            "af1": Value(number=0),
            "af2": Value(number=0),
            "t_gd": Value(number=0),
            "isc_l1ca": Value(number=0),
            "isc_l2c": Value(number=0),
            "t_oe": Value(quantity="ephemeris.reference_time"),
            "a": Value(quantity="ephemeris.semi_major_axis"),
            "a_dot": Value(number=0),
            "mean_anomaly": Value(quantity="ephemeris.mean_anomaly"),
            "delta_mean_motion": Value(number=0),
            "delta_mean_motion_dot": Value(number=0),
            "eccentricity": Value(quantity="ephemeris.eccentricity"),
            "argument_of_perigee": Value(quantity="ephemeris.argument_of_perigee"),
            "omega": Value(quantity="ephemeris.node"),
            "omega_dot": Value(quantity="ephemeris.node_rate"),
            "inclination": Value(quantity="ephemeris.inclination"),
            "inclination_dot": Value(number=0),
            "c_ic": Value(number=0),
            "c_is": Value(number=0),
            "c_uc": Value(number=0),
            "c_us": Value(number=0),
            "c_rc": Value(number=0),
            "c_rs": Value(number=0),
        },
    ),
    "gnss_1.beidou_ephemeris": FieldValues(
        "ephemeris.beidou",
        {
            "index": Value(quantity="ephemeris.index"),
            "count": Value(quantity="ephemeris.count"),
            "tow": Value(quantity="gps.tow"),
            "week_number": Value(quantity="gps.week"),
            "satellite_id": Value(quantity="ephemeris.satellite"),
            "health": Value(number=0),
            "iodc": Value(quantity="ephemeris.issue"),
            "iode": Value(quantity="ephemeris.issue"),
            "t_oc": Value(quantity="ephemeris.reference_time"),
            "af0": Value(quantity="ephemeris.clock_bias"),
            "af1": Value(number=0),
            "af2": Value(number=0),
            "t_gd": Value(number=0),
            "isc_l1ca": Value(number=0),
            "isc_l2c": Value(number=0),
            "t_oe": Value(quantity="ephemeris.reference_time"),
            "a": Value(quantity="ephemeris.semi_major_axis"),
            "a_dot": Value(number=0),
            "mean_anomaly": Value(quantity="ephemeris.mean_anomaly"),
            "delta_mean_motion": Value(number=0),
            "delta_mean_motion_dot": Value(number=0),
            "eccentricity": Value(quantity="ephemeris.eccentricity"),
            "argument_of_perigee": Value(quantity="ephemeris.argument_of_perigee"),
            "omega": Value(quantity="ephemeris.node"),
            "omega_dot": Value(quantity="ephemeris.node_rate"),
            "inclination": Value(quantity="ephemeris.inclination"),
            "inclination_dot": Value(number=0),
            "c_ic": Value(number=0),
            "c_is": Value(number=0),
            "c_uc": Value(number=0),
            "c_us": Value(number=0),
            "c_rc": Value(number=0),
            "c_rs": Value(number=0),
        },
    ),
    "gnss_1.gps_iono_correction": FieldValues(
        "", {"tow": Value(quantity="gps.tow"), "week_number": Value(quantity="gps.week")}
    ),
    "gnss_1.galileo_iono_correction": FieldValues(
        "", {"tow": Value(quantity="gps.tow"), "week_number": Value(quantity="gps.week")}
    ),
    "gnss_1.beidou_iono_correction": FieldValues(
        "", {"tow": Value(quantity="gps.tow"), "week_number": Value(quantity="gps.week")}
    ),
    "gnss_2.llh_position": FieldValues(
        "",
        {
            "latitude": Value(quantity="gnss_2.latitude", factor=57.29577951308232),
            "longitude": Value(quantity="gnss_2.longitude", factor=57.29577951308232),
            "ellipsoid_height": Value(quantity="gnss_2.height"),
            "msl_height": Value(quantity="gnss_2.msl_height"),
            "horizontal_accuracy": Value(quantity="gnss.horizontal_accuracy"),
            "vertical_accuracy": Value(quantity="gnss.vertical_accuracy"),
        },
    ),
    "gnss_2.ecef_position": FieldValues(
        "",
        {
            "position": Value(quantity="gnss_2.ecef"),
            "position_accuracy": Value(quantity="gnss.position_accuracy"),
        },
    ),
    "gnss_2.ned_velocity": FieldValues(
        "",
        {
            "velocity": Value(quantity="gnss_2.velocity"),
            "speed": Value(quantity="gnss_2.speed"),
            "ground_speed": Value(quantity="gnss_2.ground_speed"),
            "heading": Value(quantity="gnss_2.course", factor=57.29577951308232),
            "speed_accuracy": Value(number=0.1),
            "heading_accuracy": Value(quantity="gnss_2.course_accuracy", factor=57.29577951308232),
        },
    ),
    "gnss_2.ecef_velocity": FieldValues(
        "",
        {
            "velocity": Value(quantity="gnss_2.ecef_velocity"),
            "velocity_accuracy": Value(number=0.1),
        },
    ),
    "gnss_2.clock_info": FieldValues(
        "",
        {
            "bias": Value(quantity="gnss_2.clock_bias"),
            "drift": Value(quantity="gnss_2.clock_drift"),
            "accuracy_estimate": Value(number=1e-08),
        },
    ),
    "gnss_2.clock_info_2": FieldValues(
        "",
        {
            "bias": Value(quantity="gnss_2.clock_bias"),
            "drift": Value(quantity="gnss_2.clock_drift"),
            "bias_accuracy_estimate": Value(number=1e-08),
            "drift_accuracy_estimate": Value(number=1e-09),
        },
    ),
    "gnss_2.satellite_status": FieldValues(
        "gnss_2.satellites",
        {
            "index": Value(quantity="satellite.index"),
            "count": Value(quantity="satellite.count"),
            "tow": Value(quantity="gps.tow"),
            "week_number": Value(quantity="gps.week"),
            "gnss_id": Value(quantity="satellite.constellation"),
            "satellite_id": Value(quantity="satellite.id"),
            "elevation": Value(quantity="satellite.elevation", factor=57.29577951308232),
            "azimuth": Value(quantity="satellite.azimuth", factor=57.29577951308232),
            "health": Value(number=1),
        },
    ),
    "gnss_2.raw": FieldValues(
        "gnss_2.satellites",
        {
            "index": Value(quantity="satellite.index"),
            "count": Value(quantity="satellite.count"),
            "tow": Value(quantity="gps.tow"),
            "week_number": Value(quantity="gps.week"),
            "receiver_id": Value(number=2),
            "tracking_channel": Value(quantity="satellite.channel"),
            "gnss_id": Value(quantity="satellite.constellation"),
            "satellite_id": Value(quantity="satellite.id"),
            "signal_id": Value(quantity="satellite.signal"),
            "signal_strength": Value(quantity="satellite.strength"),
            "quality": Value(names=("fully_locked",)),
            "pseudorange": Value(quantity="satellite.pseudorange"),
            "carrier_phase": Value(quantity="satellite.phase"),
            "doppler": Value(quantity="satellite.doppler"),
            "range_uncertainty": Value(number=0.5),
            "phase_uncertainty": Value(number=0.01),
            "doppler_uncertainty": Value(number=0.1),
            "lock_time": Value(quantity="satellite.lock_time"),
        },
    ),
    "system_data.time_sync_status": FieldValues(
        "", {"time_sync": Value(number=1), "last_pps_received": Value(quantity="gps.pulse_age")}
    ),
    "system_data.gpio_state": FieldValues("", {"states": Value(quantity="gpio.states")}),
    "system_data.gpio_analog_value": FieldValues(
        "", {"gpio_id": Value(number=1), "value": Value(quantity="gpio.voltage")}
    ),
}
VALUES["gnss_data.llh_position"] = VALUES["gnss_1.llh_position"]
VALUES["gnss_corrections.llh_position"] = VALUES["gnss_1.llh_position"]
VALUES["gnss_external.llh_position"] = VALUES["gnss_1.llh_position"]
VALUES["gnss_external_2.llh_position"] = VALUES["gnss_1.llh_position"]
VALUES["gnss_data.ecef_position"] = VALUES["gnss_1.ecef_position"]
VALUES["gnss_corrections.ecef_position"] = VALUES["gnss_1.ecef_position"]
VALUES["gnss_external.ecef_position"] = VALUES["gnss_1.ecef_position"]
VALUES["gnss_external_2.ecef_position"] = VALUES["gnss_1.ecef_position"]
VALUES["gnss_data.ned_velocity"] = VALUES["gnss_1.ned_velocity"]
VALUES["gnss_corrections.ned_velocity"] = VALUES["gnss_1.ned_velocity"]
VALUES["gnss_external.ned_velocity"] = VALUES["gnss_1.ned_velocity"]
VALUES["gnss_external_2.ned_velocity"] = VALUES["gnss_1.ned_velocity"]
VALUES["gnss_data.ecef_velocity"] = VALUES["gnss_1.ecef_velocity"]
VALUES["gnss_corrections.ecef_velocity"] = VALUES["gnss_1.ecef_velocity"]
VALUES["gnss_external.ecef_velocity"] = VALUES["gnss_1.ecef_velocity"]
VALUES["gnss_external_2.ecef_velocity"] = VALUES["gnss_1.ecef_velocity"]
VALUES["gnss_data.dop"] = VALUES["gnss_1.dop"]
VALUES["gnss_2.dop"] = VALUES["gnss_1.dop"]
VALUES["gnss_corrections.dop"] = VALUES["gnss_1.dop"]
VALUES["gnss_external.dop"] = VALUES["gnss_1.dop"]
VALUES["gnss_external_2.dop"] = VALUES["gnss_1.dop"]
VALUES["gnss_data.utc_time"] = VALUES["gnss_1.utc_time"]
VALUES["gnss_2.utc_time"] = VALUES["gnss_1.utc_time"]
VALUES["gnss_corrections.utc_time"] = VALUES["gnss_1.utc_time"]
VALUES["gnss_external.utc_time"] = VALUES["gnss_1.utc_time"]
VALUES["gnss_external_2.utc_time"] = VALUES["gnss_1.utc_time"]
VALUES["gnss_data.gps_time"] = VALUES["gnss_1.gps_time"]
VALUES["gnss_2.gps_time"] = VALUES["gnss_1.gps_time"]
VALUES["gnss_corrections.gps_time"] = VALUES["gnss_1.gps_time"]
VALUES["gnss_external.gps_time"] = VALUES["gnss_1.gps_time"]
VALUES["gnss_external_2.gps_time"] = VALUES["gnss_1.gps_time"]
VALUES["gnss_data.clock_info"] = VALUES["gnss_1.clock_info"]
VALUES["gnss_corrections.clock_info"] = VALUES["gnss_1.clock_info"]
VALUES["gnss_external.clock_info"] = VALUES["gnss_1.clock_info"]
VALUES["gnss_external_2.clock_info"] = VALUES["gnss_1.clock_info"]
VALUES["gnss_data.fix_info"] = VALUES["gnss_1.fix_info"]
VALUES["gnss_2.fix_info"] = VALUES["gnss_1.fix_info"]
VALUES["gnss_corrections.fix_info"] = VALUES["gnss_1.fix_info"]
VALUES["gnss_external.fix_info"] = VALUES["gnss_1.fix_info"]
VALUES["gnss_external_2.fix_info"] = VALUES["gnss_1.fix_info"]
VALUES["gnss_data.sv_info"] = VALUES["gnss_1.sv_info"]
VALUES["gnss_2.sv_info"] = VALUES["gnss_1.sv_info"]
VALUES["gnss_corrections.sv_info"] = VALUES["gnss_1.sv_info"]
VALUES["gnss_external.sv_info"] = VALUES["gnss_1.sv_info"]
VALUES["gnss_external_2.sv_info"] = VALUES["gnss_1.sv_info"]
VALUES["gnss_data.hardware_status"] = VALUES["gnss_1.hardware_status"]
VALUES["gnss_2.hardware_status"] = VALUES["gnss_1.hardware_status"]
VALUES["gnss_corrections.hardware_status"] = VALUES["gnss_1.hardware_status"]
VALUES["gnss_external.hardware_status"] = VALUES["gnss_1.hardware_status"]
VALUES["gnss_external_2.hardware_status"] = VALUES["gnss_1.hardware_status"]
VALUES["gnss_data.dgps_info"] = VALUES["gnss_1.dgps_info"]
VALUES["gnss_2.dgps_info"] = VALUES["gnss_1.dgps_info"]
VALUES["gnss_corrections.dgps_info"] = VALUES["gnss_1.dgps_info"]
VALUES["gnss_external.dgps_info"] = VALUES["gnss_1.dgps_info"]
VALUES["gnss_external_2.dgps_info"] = VALUES["gnss_1.dgps_info"]
VALUES["gnss_data.dgps_channel"] = VALUES["gnss_1.dgps_channel"]
VALUES["gnss_2.dgps_channel"] = VALUES["gnss_1.dgps_channel"]
VALUES["gnss_corrections.dgps_channel"] = VALUES["gnss_1.dgps_channel"]
VALUES["gnss_external.dgps_channel"] = VALUES["gnss_1.dgps_channel"]
VALUES["gnss_external_2.dgps_channel"] = VALUES["gnss_1.dgps_channel"]
VALUES["gnss_data.clock_info_2"] = VALUES["gnss_1.clock_info_2"]
VALUES["gnss_corrections.clock_info_2"] = VALUES["gnss_1.clock_info_2"]
VALUES["gnss_external.clock_info_2"] = VALUES["gnss_1.clock_info_2"]
VALUES["gnss_external_2.clock_info_2"] = VALUES["gnss_1.clock_info_2"]
VALUES["gnss_data.gps_leap_seconds"] = VALUES["gnss_1.gps_leap_seconds"]
VALUES["gnss_2.gps_leap_seconds"] = VALUES["gnss_1.gps_leap_seconds"]
VALUES["gnss_corrections.gps_leap_seconds"] = VALUES["gnss_1.gps_leap_seconds"]
VALUES["gnss_external.gps_leap_seconds"] = VALUES["gnss_1.gps_leap_seconds"]
VALUES["gnss_external_2.gps_leap_seconds"] = VALUES["gnss_1.gps_leap_seconds"]
VALUES["gnss_data.sbas_info"] = VALUES["gnss_1.sbas_info"]
VALUES["gnss_2.sbas_info"] = VALUES["gnss_1.sbas_info"]
VALUES["gnss_corrections.sbas_info"] = VALUES["gnss_1.sbas_info"]
VALUES["gnss_external.sbas_info"] = VALUES["gnss_1.sbas_info"]
VALUES["gnss_external_2.sbas_info"] = VALUES["gnss_1.sbas_info"]
VALUES["gnss_data.sbas_correction"] = VALUES["gnss_1.sbas_correction"]
VALUES["gnss_2.sbas_correction"] = VALUES["gnss_1.sbas_correction"]
VALUES["gnss_corrections.sbas_correction"] = VALUES["gnss_1.sbas_correction"]
VALUES["gnss_external.sbas_correction"] = VALUES["gnss_1.sbas_correction"]
VALUES["gnss_external_2.sbas_correction"] = VALUES["gnss_1.sbas_correction"]
VALUES["gnss_data.rf_error_detection"] = VALUES["gnss_1.rf_error_detection"]
VALUES["gnss_2.rf_error_detection"] = VALUES["gnss_1.rf_error_detection"]
VALUES["gnss_corrections.rf_error_detection"] = VALUES["gnss_1.rf_error_detection"]
VALUES["gnss_external.rf_error_detection"] = VALUES["gnss_1.rf_error_detection"]
VALUES["gnss_external_2.rf_error_detection"] = VALUES["gnss_1.rf_error_detection"]
VALUES["gnss_data.satellite_status"] = VALUES["gnss_1.satellite_status"]
VALUES["gnss_corrections.satellite_status"] = VALUES["gnss_1.satellite_status"]
VALUES["gnss_external.satellite_status"] = VALUES["gnss_1.satellite_status"]
VALUES["gnss_external_2.satellite_status"] = VALUES["gnss_1.satellite_status"]
VALUES["gnss_data.raw"] = VALUES["gnss_1.raw"]
VALUES["gnss_corrections.raw"] = VALUES["gnss_1.raw"]
VALUES["gnss_external.raw"] = VALUES["gnss_1.raw"]
VALUES["gnss_external_2.raw"] = VALUES["gnss_1.raw"]
VALUES["gnss_data.base_station_info"] = VALUES["gnss_1.base_station_info"]
VALUES["gnss_2.base_station_info"] = VALUES["gnss_1.base_station_info"]
VALUES["gnss_corrections.base_station_info"] = VALUES["gnss_1.base_station_info"]
VALUES["gnss_external.base_station_info"] = VALUES["gnss_1.base_station_info"]
VALUES["gnss_external_2.base_station_info"] = VALUES["gnss_1.base_station_info"]
VALUES["gnss_data.rtk_corrections_status"] = VALUES["gnss_1.rtk_corrections_status"]
VALUES["gnss_2.rtk_corrections_status"] = VALUES["gnss_1.rtk_corrections_status"]
VALUES["gnss_corrections.rtk_corrections_status"] = VALUES["gnss_1.rtk_corrections_status"]
VALUES["gnss_external.rtk_corrections_status"] = VALUES["gnss_1.rtk_corrections_status"]
VALUES["gnss_external_2.rtk_corrections_status"] = VALUES["gnss_1.rtk_corrections_status"]
VALUES["gnss_data.gps_ephemeris"] = VALUES["gnss_1.gps_ephemeris"]
VALUES["gnss_2.gps_ephemeris"] = VALUES["gnss_1.gps_ephemeris"]
VALUES["gnss_corrections.gps_ephemeris"] = VALUES["gnss_1.gps_ephemeris"]
VALUES["gnss_external.gps_ephemeris"] = VALUES["gnss_1.gps_ephemeris"]
VALUES["gnss_external_2.gps_ephemeris"] = VALUES["gnss_1.gps_ephemeris"]
VALUES["gnss_data.glonass_ephemeris"] = VALUES["gnss_1.glonass_ephemeris"]
VALUES["gnss_2.glonass_ephemeris"] = VALUES["gnss_1.glonass_ephemeris"]
VALUES["gnss_corrections.glonass_ephemeris"] = VALUES["gnss_1.glonass_ephemeris"]
VALUES["gnss_external.glonass_ephemeris"] = VALUES["gnss_1.glonass_ephemeris"]
VALUES["gnss_external_2.glonass_ephemeris"] = VALUES["gnss_1.glonass_ephemeris"]
VALUES["gnss_data.galileo_ephemeris"] = VALUES["gnss_1.galileo_ephemeris"]
VALUES["gnss_2.galileo_ephemeris"] = VALUES["gnss_1.galileo_ephemeris"]
VALUES["gnss_corrections.galileo_ephemeris"] = VALUES["gnss_1.galileo_ephemeris"]
VALUES["gnss_external.galileo_ephemeris"] = VALUES["gnss_1.galileo_ephemeris"]
VALUES["gnss_external_2.galileo_ephemeris"] = VALUES["gnss_1.galileo_ephemeris"]
VALUES["gnss_data.beidou_ephemeris"] = VALUES["gnss_1.beidou_ephemeris"]
VALUES["gnss_2.beidou_ephemeris"] = VALUES["gnss_1.beidou_ephemeris"]
VALUES["gnss_corrections.beidou_ephemeris"] = VALUES["gnss_1.beidou_ephemeris"]
VALUES["gnss_external.beidou_ephemeris"] = VALUES["gnss_1.beidou_ephemeris"]
VALUES["gnss_external_2.beidou_ephemeris"] = VALUES["gnss_1.beidou_ephemeris"]
VALUES["gnss_data.gps_iono_correction"] = VALUES["gnss_1.gps_iono_correction"]
VALUES["gnss_2.gps_iono_correction"] = VALUES["gnss_1.gps_iono_correction"]
VALUES["gnss_corrections.gps_iono_correction"] = VALUES["gnss_1.gps_iono_correction"]
VALUES["gnss_external.gps_iono_correction"] = VALUES["gnss_1.gps_iono_correction"]
VALUES["gnss_external_2.gps_iono_correction"] = VALUES["gnss_1.gps_iono_correction"]
VALUES["gnss_data.galileo_iono_correction"] = VALUES["gnss_1.galileo_iono_correction"]
VALUES["gnss_2.galileo_iono_correction"] = VALUES["gnss_1.galileo_iono_correction"]
VALUES["gnss_corrections.galileo_iono_correction"] = VALUES["gnss_1.galileo_iono_correction"]
VALUES["gnss_external.galileo_iono_correction"] = VALUES["gnss_1.galileo_iono_correction"]
VALUES["gnss_external_2.galileo_iono_correction"] = VALUES["gnss_1.galileo_iono_correction"]
VALUES["gnss_data.beidou_iono_correction"] = VALUES["gnss_1.beidou_iono_correction"]
VALUES["gnss_2.beidou_iono_correction"] = VALUES["gnss_1.beidou_iono_correction"]
VALUES["gnss_corrections.beidou_iono_correction"] = VALUES["gnss_1.beidou_iono_correction"]
VALUES["gnss_external.beidou_iono_correction"] = VALUES["gnss_1.beidou_iono_correction"]
VALUES["gnss_external_2.beidou_iono_correction"] = VALUES["gnss_1.beidou_iono_correction"]

#: Commands -> what they do besides storing a setting.
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
    "gnss.receiver_info": Behavior(arguments={"only": 129, "first": 145, "second": 146}),
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
        arguments={
            "instance": "instance",
            "type": "type",
            "pin": "parameters.pin",
            "pin_mode": "parameters.mode",
            "set": "parameters.descriptor_set",
            "field": "parameters.field_descriptor",
            "element": "parameters.parameter_id",
            "low": "parameters.thresholds.low_threshold",
            "high": "parameters.thresholds.high_threshold",
            "threshold": "parameters.thresholds.interval_threshold",
            "interval": "parameters.thresholds.interval",
            "table": "parameters.logic_table",
            "inputs": "parameters.input_triggers",
        },
        all={"instance": 0},
        instances={"instance": "event_triggers"},
    ),
    "3dm.event_action_config": Behavior(
        effect="action",
        arguments={
            "instance": "instance",
            "trigger": "trigger",
            "type": "type",
            "pin": "parameters.pin",
            "pin_mode": "parameters.mode",
            "set": "parameters.descriptor_set",
            "decimation": "parameters.decimation",
            "fields": "parameters.descriptors",
        },
        all={"instance": 0},
        instances={"instance": "event_actions"},
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
        initial={"dcm": (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)},
    ),
    "filter.sensor_to_vehicle_rotation_euler": Behavior(
        effect="orientation_euler",
        arguments={"roll": "roll", "pitch": "pitch", "yaw": "yaw", "inverse": 1},
    ),
    "filter.sensor_to_vehicle_rotation_dcm": Behavior(
        effect="orientation_dcm",
        arguments={"dcm": "dcm", "inverse": 1},
        setting="filter.sensor_to_vehicle_rotation_euler",
        initial={"dcm": (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)},
    ),
    "filter.sensor_to_vehicle_rotation_quaternion": Behavior(
        effect="orientation_quaternion",
        arguments={"q": "q", "inverse": 1},
        setting="filter.sensor_to_vehicle_rotation_euler",
        initial={"q": (1.0, 0.0, 0.0, 0.0)},
    ),
    "3dm.accel_bias": Behavior(effect="accel_bias", arguments={"bias": "bias"}),
    "3dm.gyro_bias": Behavior(effect="gyro_bias", arguments={"bias": "bias"}),
    "3dm.capture_gyro_bias": Behavior(
        effect="capture", arguments={"milliseconds": "averaging_time_ms"}, setting="3dm.gyro_bias"
    ),
    "3dm.mag_soft_iron_matrix": Behavior(
        initial={"matrix": (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)}
    ),
    "3dm.uart_baud_rate": Behavior(
        effect="baud_rate",
        arguments={"baud": "baud"},
        setting="base.comm_speed",
        key={"port": 17},
        initial={"baud": 115200},
    ),
    "3dm.gpio_config": Behavior(
        effect="pin",
        arguments={
            "pin": "pin",
            "feature": "feature",
            "behavior": "behavior",
            "options": "pin_mode",
        },
        all={"pin": 0},
        instances={"pin": "gpio_pins"},
    ),
    "3dm.gpio_state": Behavior(
        effect="pin_state",
        arguments={"pin": "pin", "state": "state"},
        instances={"pin": "gpio_pins"},
    ),
    "3dm.sensor_range": Behavior(all={"sensor": 0}, initial={"setting": 3}),
    "3dm.get_calibrated_sensor_ranges": Behavior(arguments={"sensor": "sensor"}),
    "3dm.device_status": Behavior(
        effect="device_status",
        arguments={"sensor": 128, "gnss": 129, "filter": 130},
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
    "system.interface_control": Behavior(
        effect="protocols",
        arguments={
            "port": "port",
            "incoming": "protocols_incoming",
            "outgoing": "protocols_outgoing",
        },
        all={"port": 0},
        instances={"port": "ports"},
    ),
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
    "3dm-cv7-gnss-ins": {
        "3dm.pps_source_control.source": Difference(default=1),
        "filter.gnss_antenna_calibration_control.max_offset": Difference(
            default=0.1, minimum=0, maximum=0.5
        ),
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
        "3dm.data_stream_control.descriptor_set": Difference(values=frozenset({1, 3})),
        "3dm.uart_baud_rate.baud": Difference(default=115200),
        "3dm.imu_low_pass_filter.frequency": Difference(maximum=250),
        "3dm.complementary_filter.pitch_roll_enable": Difference(default=True),
        "3dm.complementary_filter.heading_enable": Difference(default=True),
        "3dm.device_status.model_number": Difference(constant=6254),
        "3dm.data_stream_control_response.descriptor_set": Difference(values=frozenset({1, 3})),
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
        "filter.gnss_source.source": Difference(values=frozenset({1, 2})),
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
