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
}
