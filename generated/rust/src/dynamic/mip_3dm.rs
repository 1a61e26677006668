use crate::dynamic::macros::{record, union};
use crate::types;

record! {
    crate::mip_3dm::PollEntry { descriptor, reserved }
    "descriptor" => value(descriptor);
    "reserved" => value(reserved);
}

record! {
    crate::mip_3dm::ConstellationSettingsEntry {
        constellation_id,
        enable,
        reserved_channels,
        max_channels,
        option_flags,
    }
    "constellation_id" => value(constellation_id);
    "enable" => value(enable);
    "reserved_channels" => value(reserved_channels);
    "max_channels" => value(max_channels);
    "option_flags" => value(option_flags);
}

record! {
    crate::mip_3dm::SupportedEventInfo { type_, count }
    "type" => value(type_);
    "count" => value(count);
}

record! {
    crate::mip_3dm::EventTriggerStatusEntry { type_, status }
    "type" => value(type_);
    "status" => value(status);
}

record! {
    crate::mip_3dm::EventActionStatusEntry { action_type, trigger_id }
    "action_type" => value(action_type);
    "trigger_id" => value(trigger_id);
}

record! {
    crate::mip_3dm::SensorRangeEntry { setting, range }
    "setting" => value(setting);
    "range" => value(range);
}

record! {
    crate::mip_3dm::PollImuData { suppress_ack, descriptors }
    "suppress_ack" => value(suppress_ack);
    "num_descriptors" => counter(descriptors, "descriptors");
    "descriptors" => value(descriptors);
}

record! {
    crate::mip_3dm::PollGnssData { suppress_ack, descriptors }
    "suppress_ack" => value(suppress_ack);
    "num_descriptors" => counter(descriptors, "descriptors");
    "descriptors" => value(descriptors);
}

record! {
    crate::mip_3dm::PollEstimationFilterData { suppress_ack, descriptors }
    "suppress_ack" => value(suppress_ack);
    "num_descriptors" => counter(descriptors, "descriptors");
    "descriptors" => value(descriptors);
}

record! {
    crate::mip_3dm::PollNmeaData { suppress_ack, format_entries }
    "suppress_ack" => value(suppress_ack);
    "count" => counter(format_entries, "format_entries");
    "format_entries" => value(format_entries);
}

record! {
    crate::mip_3dm::GetImuDataBaseRate {}
}

record! {
    crate::mip_3dm::GetGnssDataBaseRate {}
}

record! {
    crate::mip_3dm::ImuMessageFormat { function, descriptors }
    "function" => value(function);
    "num_descriptors" => some_counter(descriptors, "descriptors");
    "descriptors" => some_value(descriptors);
}

record! {
    crate::mip_3dm::GnssMessageFormat { function, descriptors }
    "function" => value(function);
    "num_descriptors" => some_counter(descriptors, "descriptors");
    "descriptors" => some_value(descriptors);
}

record! {
    crate::mip_3dm::EstimationFilterMessageFormat { function, descriptors }
    "function" => value(function);
    "num_descriptors" => some_counter(descriptors, "descriptors");
    "descriptors" => some_value(descriptors);
}

record! {
    crate::mip_3dm::GetEstimationFilterDataBaseRate {}
}

record! {
    crate::mip_3dm::NmeaMessageFormat { function, format_entries }
    "function" => value(function);
    "count" => some_counter(format_entries, "format_entries");
    "format_entries" => some_value(format_entries);
}

record! {
    crate::mip_3dm::PollData { desc_set, suppress_ack, descriptors }
    "desc_set" => value(desc_set);
    "suppress_ack" => value(suppress_ack);
    "num_descriptors" => counter(descriptors, "descriptors");
    "descriptors" => value(descriptors);
}

record! {
    crate::mip_3dm::GetDataBaseRate { desc_set }
    "desc_set" => value(desc_set);
}

record! {
    crate::mip_3dm::MessageFormat { function, desc_set, descriptors }
    "function" => value(function);
    "desc_set" => some_value(desc_set);
    "num_descriptors" => some_counter(descriptors, "descriptors");
    "descriptors" => some_value(descriptors);
}

record! {
    crate::mip_3dm::FactoryStreaming { action, reserved }
    "action" => value(action);
    "reserved" => value(reserved);
}

record! {
    crate::mip_3dm::DataStreamControl { function, desc_set, enable }
    "function" => value(function);
    "desc_set" => some_value(desc_set);
    "enable" => some_value(enable);
}

record! {
    crate::mip_3dm::ConstellationSettings { function, max_channels, settings }
    "function" => value(function);
    "max_channels" => some_value(max_channels);
    "config_count" => some_counter(settings, "settings");
    "settings" => some_value(settings);
}

record! {
    crate::mip_3dm::GnssSbasSettings { function, enable_sbas, sbas_options, included_prns }
    "function" => value(function);
    "enable_sbas" => some_value(enable_sbas);
    "sbas_options" => some_value(sbas_options);
    "num_included_prns" => some_counter(included_prns, "included_prns");
    "included_prns" => some_value(included_prns);
}

record! {
    crate::mip_3dm::GnssAssistedFix { function, option, flags }
    "function" => value(function);
    "option" => some_value(option);
    "flags" => some_value(flags);
}

record! {
    crate::mip_3dm::GnssTimeAssistance { function, tow, week_number, accuracy }
    "function" => value(function);
    "tow" => some_value(tow);
    "week_number" => some_value(week_number);
    "accuracy" => some_value(accuracy);
}

record! {
    crate::mip_3dm::PpsSourceControl { function, source }
    "function" => value(function);
    "source" => some_value(source);
}

record! {
    crate::mip_3dm::GetSupportedEvents { query }
    "query" => value(query);
}

record! {
    crate::mip_3dm::EventControl { function, instance, mode }
    "function" => value(function);
    "instance" => some_value(instance);
    "mode" => some_value(mode);
}

record! {
    crate::mip_3dm::GetEventTriggerStatus { requested_instances }
    "requested_count" => counter(requested_instances, "requested_instances");
    "requested_instances" => value(requested_instances);
}

record! {
    crate::mip_3dm::GetEventActionStatus { requested_instances }
    "requested_count" => counter(requested_instances, "requested_instances");
    "requested_instances" => value(requested_instances);
}

record! {
    crate::mip_3dm::EventTriggerConfiguration { function, instance, type_, parameters }
    "function" => value(function);
    "instance" => some_value(instance);
    "type" => some_value(type_);
    "parameters" => some_union(parameters, type_, crate::mip_3dm::EventTriggerConfigurationParameters);
}

union! {
    crate::mip_3dm::EventTriggerConfigurationParameters, types::EventTriggerType;
    NONE => None;
    GPIO => Gpio("gpio");
    THRESHOLD => Threshold("threshold");
    COMBINATION => Combination("combination");
}

record! {
    crate::mip_3dm::EventActionConfiguration { function, instance, trigger, type_, parameters }
    "function" => value(function);
    "instance" => some_value(instance);
    "trigger" => some_value(trigger);
    "type" => some_value(type_);
    "parameters" => some_union(parameters, type_, crate::mip_3dm::EventActionConfigurationParameters);
}

union! {
    crate::mip_3dm::EventActionConfigurationParameters, types::EventActionType;
    NONE => None;
    GPIO => Gpio("gpio");
    MESSAGE => Message("message");
}

record! {
    crate::mip_3dm::DeviceStartUpSettings { function }
    "function" => value(function);
}

record! {
    crate::mip_3dm::SensorToVehicleFrameTransformationEuler { function, roll, pitch, yaw }
    "function" => value(function);
    "roll" => some_value(roll);
    "pitch" => some_value(pitch);
    "yaw" => some_value(yaw);
}

record! {
    crate::mip_3dm::SensorToVehicleFrameTransformationQuaternion { function, q }
    "function" => value(function);
    "q" => some_value(q);
}

record! {
    crate::mip_3dm::SensorToVehicleFrameTransformationDirectionCosineMatrix { function, dcm }
    "function" => value(function);
    "dcm" => some_value(dcm);
}

record! {
    crate::mip_3dm::AccelerometerBiasConfiguration { function, bias }
    "function" => value(function);
    "bias" => some_value(bias);
}

record! {
    crate::mip_3dm::GyroscopeBiasConfiguration { function, bias }
    "function" => value(function);
    "bias" => some_value(bias);
}

record! {
    crate::mip_3dm::CaptureGyroscopeBias { averaging_time_ms }
    "averaging_time_ms" => value(averaging_time_ms);
}

record! {
    crate::mip_3dm::MagnetometerHardIronOffset { function, offset }
    "function" => value(function);
    "offset" => some_value(offset);
}

record! {
    crate::mip_3dm::MagnetometerSoftIronMatrix { function, offset }
    "function" => value(function);
    "offset" => some_value(offset);
}

record! {
    crate::mip_3dm::ConingAndScullingEnable { function, enable }
    "function" => value(function);
    "enable" => some_value(enable);
}

record! {
    crate::mip_3dm::UartBaudRate { function, baud }
    "function" => value(function);
    "baud" => some_value(baud);
}

record! {
    crate::mip_3dm::GpioConfiguration { function, pin, feature, behavior, pin_mode }
    "function" => value(function);
    "pin" => some_value(pin);
    "feature" => some_value(feature);
    "behavior" => some_value(behavior);
    "pin_mode" => some_value(pin_mode);
}

record! {
    crate::mip_3dm::GpioState { function, pin, state }
    "function" => value(function);
    "pin" => some_value(pin);
    "state" => some_value(state);
}

record! {
    crate::mip_3dm::OdometerConfiguration { function, mode, scaling, uncertainty }
    "function" => value(function);
    "mode" => some_value(mode);
    "scaling" => some_value(scaling);
    "uncertainty" => some_value(uncertainty);
}

record! {
    crate::mip_3dm::AdvancedLowPassFilterSettings {
        function,
        target_descriptor,
        enable,
        manual,
        frequency,
        reserved,
    }
    "function" => value(function);
    "target_descriptor" => some_value(target_descriptor);
    "enable" => some_value(enable);
    "manual" => some_value(manual);
    "frequency" => some_value(frequency);
    "reserved" => some_value(reserved);
}

record! {
    crate::mip_3dm::ComplementaryFilterConfiguration {
        function,
        pitch_roll_enable,
        heading_enable,
        pitch_roll_time_constant,
        heading_time_constant,
    }
    "function" => value(function);
    "pitch_roll_enable" => some_value(pitch_roll_enable);
    "heading_enable" => some_value(heading_enable);
    "pitch_roll_time_constant" => some_value(pitch_roll_time_constant);
    "heading_time_constant" => some_value(heading_time_constant);
}

record! {
    crate::mip_3dm::SensorRange { function, sensor, setting }
    "function" => value(function);
    "sensor" => some_value(sensor);
    "setting" => some_value(setting);
}

record! {
    crate::mip_3dm::GetCalibratedSensorRanges { sensor }
    "sensor" => value(sensor);
}

record! {
    crate::mip_3dm::LowPassAntiAliasingFilter {
        function,
        desc_set,
        field_desc,
        enable,
        manual,
        frequency,
    }
    "function" => value(function);
    "desc_set" => some_value(desc_set);
    "field_desc" => some_value(field_desc);
    "enable" => some_value(enable);
    "manual" => some_value(manual);
    "frequency" => some_value(frequency);
}

record! {
    crate::mip_3dm::DeviceStatus { status_selector }
    "status_selector" => value(status_selector);
}

record! {
    crate::mip_3dm::ImuMessageFormatResponse { descriptors }
    "num_descriptors" => counter(descriptors, "descriptors");
    "descriptors" => value(descriptors);
}

record! {
    crate::mip_3dm::GnssMessageFormatResponse { descriptors }
    "num_descriptors" => counter(descriptors, "descriptors");
    "descriptors" => value(descriptors);
}

record! {
    crate::mip_3dm::EstimationFilterMessageFormatResponse { descriptors }
    "num_descriptors" => counter(descriptors, "descriptors");
    "descriptors" => value(descriptors);
}

record! {
    crate::mip_3dm::GetImuDataBaseRateResponse { rate }
    "rate" => value(rate);
}

record! {
    crate::mip_3dm::GetGnssDataBaseRateResponse { rate }
    "rate" => value(rate);
}

record! {
    crate::mip_3dm::DataStreamControlResponse { desc_set, enabled }
    "desc_set" => value(desc_set);
    "enabled" => value(enabled);
}

record! {
    crate::mip_3dm::UartBaudRateResponse { baud }
    "baud" => value(baud);
}

record! {
    crate::mip_3dm::GetEstimationFilterDataBaseRateResponse { rate }
    "rate" => value(rate);
}

record! {
    crate::mip_3dm::AdvancedLowPassFilterSettingsResponse {
        target_descriptor,
        enable,
        manual,
        frequency,
        reserved,
    }
    "target_descriptor" => value(target_descriptor);
    "enable" => value(enable);
    "manual" => value(manual);
    "frequency" => value(frequency);
    "reserved" => value(reserved);
}

record! {
    crate::mip_3dm::NmeaMessageFormatResponse { format_entries }
    "count" => counter(format_entries, "format_entries");
    "format_entries" => value(format_entries);
}

record! {
    crate::mip_3dm::GetDataBaseRateResponse { desc_set, rate }
    "desc_set" => value(desc_set);
    "rate" => value(rate);
}

record! {
    crate::mip_3dm::MessageFormatResponse { desc_set, descriptors }
    "desc_set" => value(desc_set);
    "num_descriptors" => counter(descriptors, "descriptors");
    "descriptors" => value(descriptors);
}

record! {
    crate::mip_3dm::DeviceStatusBasicResponse { status_flags, system_state, system_timer }
    "status_flags" => value(status_flags);
    "system_state" => value(system_state);
    "system_timer" => value(system_timer);
}

record! {
    crate::mip_3dm::DeviceStatusDiagnosticResponse {
        status_flags,
        system_state,
        system_timer,
        imu_stream_enabled,
        filter_stream_enabled,
        imu_dropped_packets,
        filter_dropped_packets,
        com_port_bytes_written,
        com_port_bytes_read,
        com_port_write_overruns,
        com_port_read_overruns,
        imu_parser_errors,
        imu_message_count,
        imu_last_message_time,
    }
    "status_flags" => value(status_flags);
    "system_state" => value(system_state);
    "system_timer" => value(system_timer);
    "imu_stream_enabled" => value(imu_stream_enabled);
    "filter_stream_enabled" => value(filter_stream_enabled);
    "imu_dropped_packets" => value(imu_dropped_packets);
    "filter_dropped_packets" => value(filter_dropped_packets);
    "com_port_bytes_written" => value(com_port_bytes_written);
    "com_port_bytes_read" => value(com_port_bytes_read);
    "com_port_write_overruns" => value(com_port_write_overruns);
    "com_port_read_overruns" => value(com_port_read_overruns);
    "imu_parser_errors" => value(imu_parser_errors);
    "imu_message_count" => value(imu_message_count);
    "imu_last_message_time" => value(imu_last_message_time);
}

record! {
    crate::mip_3dm::ComplementaryFilterConfigurationResponse {
        pitch_roll_enable,
        heading_enable,
        pitch_roll_time_constant,
        heading_time_constant,
    }
    "pitch_roll_enable" => value(pitch_roll_enable);
    "heading_enable" => value(heading_enable);
    "pitch_roll_time_constant" => value(pitch_roll_time_constant);
    "heading_time_constant" => value(heading_time_constant);
}

record! {
    crate::mip_3dm::AccelerometerBiasConfigurationResponse { bias }
    "bias" => value(bias);
}

record! {
    crate::mip_3dm::GyroscopeBiasConfigurationResponse { bias }
    "bias" => value(bias);
}

record! {
    crate::mip_3dm::MagnetometerHardIronOffsetResponse { offset }
    "offset" => value(offset);
}

record! {
    crate::mip_3dm::MagnetometerSoftIronMatrixResponse { offset }
    "offset" => value(offset);
}

record! {
    crate::mip_3dm::ConingAndScullingEnableResponse { enable }
    "enable" => value(enable);
}

record! {
    crate::mip_3dm::ConstellationSettingsResponse {
        max_channels_available,
        max_channels_use,
        settings,
    }
    "max_channels_available" => value(max_channels_available);
    "max_channels_use" => value(max_channels_use);
    "config_count" => counter(settings, "settings");
    "settings" => value(settings);
}

record! {
    crate::mip_3dm::GnssSbasSettingsResponse { enable_sbas, sbas_options, included_prns }
    "enable_sbas" => value(enable_sbas);
    "sbas_options" => value(sbas_options);
    "num_included_prns" => counter(included_prns, "included_prns");
    "included_prns" => value(included_prns);
}

record! {
    crate::mip_3dm::GnssAssistedFixResponse { option, flags }
    "option" => value(option);
    "flags" => value(flags);
}

record! {
    crate::mip_3dm::GnssTimeAssistanceResponse { tow, week_number, accuracy }
    "tow" => value(tow);
    "week_number" => value(week_number);
    "accuracy" => value(accuracy);
}

record! {
    crate::mip_3dm::PpsSourceControlResponse { source }
    "source" => value(source);
}

record! {
    crate::mip_3dm::SensorToVehicleFrameTransformationEulerResponse { roll, pitch, yaw }
    "roll" => value(roll);
    "pitch" => value(pitch);
    "yaw" => value(yaw);
}

record! {
    crate::mip_3dm::SensorToVehicleFrameTransformationQuaternionResponse { q }
    "q" => value(q);
}

record! {
    crate::mip_3dm::SensorToVehicleFrameTransformationDirectionCosineMatrixResponse { dcm }
    "dcm" => value(dcm);
}

record! {
    crate::mip_3dm::GetSupportedEventsResponse { query, max_instances, entries }
    "query" => value(query);
    "max_instances" => value(max_instances);
    "num_entries" => counter(entries, "entries");
    "entries" => value(entries);
}

record! {
    crate::mip_3dm::EventControlResponse { instance, mode }
    "instance" => value(instance);
    "mode" => value(mode);
}

record! {
    crate::mip_3dm::GetEventTriggerStatusResponse { triggers }
    "count" => counter(triggers, "triggers");
    "triggers" => value(triggers);
}

record! {
    crate::mip_3dm::GetEventActionStatusResponse { actions }
    "count" => counter(actions, "actions");
    "actions" => value(actions);
}

record! {
    crate::mip_3dm::EventTriggerConfigurationResponse { instance, type_, parameters }
    "instance" => value(instance);
    "type" => value(type_);
    "parameters" => union(parameters, type_, crate::mip_3dm::EventTriggerConfigurationParameters);
}

record! {
    crate::mip_3dm::EventActionConfigurationResponse { instance, trigger, type_, parameters }
    "instance" => value(instance);
    "trigger" => value(trigger);
    "type" => value(type_);
    "parameters" => union(parameters, type_, crate::mip_3dm::EventActionConfigurationParameters);
}

record! {
    crate::mip_3dm::GpioConfigurationResponse { pin, feature, behavior, pin_mode }
    "pin" => value(pin);
    "feature" => value(feature);
    "behavior" => value(behavior);
    "pin_mode" => value(pin_mode);
}

record! {
    crate::mip_3dm::GpioStateResponse { pin, state }
    "pin" => value(pin);
    "state" => value(state);
}

record! {
    crate::mip_3dm::OdometerConfigurationResponse { mode, scaling, uncertainty }
    "mode" => value(mode);
    "scaling" => value(scaling);
    "uncertainty" => value(uncertainty);
}

record! {
    crate::mip_3dm::SensorRangeResponse { sensor, setting }
    "sensor" => value(sensor);
    "setting" => value(setting);
}

record! {
    crate::mip_3dm::GetCalibratedSensorRangesResponse { sensor, ranges }
    "sensor" => value(sensor);
    "num_ranges" => counter(ranges, "ranges");
    "ranges" => value(ranges);
}

record! {
    crate::mip_3dm::LowPassAntiAliasingFilterResponse {
        desc_set,
        field_desc,
        enable,
        manual,
        frequency,
    }
    "desc_set" => value(desc_set);
    "field_desc" => value(field_desc);
    "enable" => value(enable);
    "manual" => value(manual);
    "frequency" => value(frequency);
}
