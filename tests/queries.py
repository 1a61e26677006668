"""What people type to find a field, and the field that they mean."""

QUERIES = {
    # descriptors, in every form
    "0x0D13": "filter.antenna_offset",
    "0x0D,0x13": "filter.antenna_offset",
    "0x0d 0x13": "filter.antenna_offset",
    "0D 13": "filter.antenna_offset",
    "0D13": "filter.antenna_offset",
    "(0x0D, 0x13)": "filter.antenna_offset",
    "82 10": "filter_data.status",
    "(0x82,0x10)": "filter_data.status",
    "8210": "filter_data.status",
    "80 D3": "shared.gps_timestamp",
    "0CA8": "3dm.pps_source_control_response",
    "0xF1": "protocol.acknowledge",
    # names and titles
    "ping": "base.ping",
    "set to idle": "base.set_idle",
    "scaled accelerometer": "sensor.scaled_accel",
    "3dm.pps_source_control": "3dm.pps_source_control",
    "filter status": "filter_data.status",
    # symbols of the languages
    "mip_3dm_pps_source_control_write": "3dm.pps_source_control",
    "MIP_3DM_PPS_SOURCE_GENERATED": "3dm.pps_source_control",
    "PpsSourceControl": "3dm.pps_source_control",
    "PpsSourceControl.write": "3dm.pps_source_control",
    "sensor::ScaledAccel": "sensor.scaled_accel",
    # names of the vendor
    "poll_imu_message": "3dm.poll_imu_data",
    "mip_3dm_poll_imu_message": "3dm.poll_imu_data",
    # parameters and values
    "falling edge gpio": "3dm.gpio_config",
    "low_threshold": "3dm.event_trigger_config",
    # other words
    "nack": "protocol.acknowledge",
    "ack": "protocol.acknowledge",
    "lever arm": "filter.antenna_offset",
    "save settings": "3dm.device_settings",
    "factory reset": "3dm.device_settings",
    "baud rate": "3dm.uart_baud_rate",
    "reboot": "base.soft_reset",
    "serial number": "base.get_device_info",
    "stop streaming": "base.set_idle",
    "output rate": "3dm.message_format",
    "mounting orientation": "3dm.sensor_to_vehicle_transform_euler",
    "roll pitch yaw": "filter_data.euler_angles",
    "barometer": "sensor.scaled_pressure",
    "pulse per second": "3dm.pps_source_control",
    "zero velocity": "filter.auto_zupt",
    "saturation": "sensor.overrange_status",
    "satellites": "gnss_1.sv_info",
    # symbols of values
    "MIP_ACK_CODE_INVALID_PARAMETER": "protocol.acknowledge",
    "AckCode.INVALID_PARAMETER": "protocol.acknowledge",
    "AckCode::InvalidParameter": "protocol.acknowledge",
}

#: What people type to find a page or a section, and its address within the site: the first result.
PAGES = {
    "stream imu data": "guides/stream_imu_data.html",
    "Stream IMU data at 100 Hz": "guides/stream_imu_data.html",
    "bandwidth": "tools/bandwidth.html",
    "inspector": "tools/inspector.html",
    "checksum": "packets.html#checksum",
    "units": "units.html#units",
    "GX5-15 CV7": "guides/migrate_from_gx5_15_to_cv7.html",
    "frames of reference": "units.html#frames-of-reference",
    "0x7565": "packets.html#frame",
    "3DM-CV7-GNSS/INS": "devices/3dm-cv7-gnss-ins.html",
}
