use crate::dynamic::macros::record;

record! {
    crate::base::BaseDeviceInfo {
        firmware_version,
        model_name,
        model_number,
        serial_number,
        lot_number,
        device_options,
    }
    "firmware_version" => value(firmware_version);
    "model_name" => value(model_name);
    "model_number" => value(model_number);
    "serial_number" => value(serial_number);
    "lot_number" => value(lot_number);
    "device_options" => value(device_options);
}

record! {
    crate::base::Ping {}
}

record! {
    crate::base::SetToIdle {}
}

record! {
    crate::base::GetDeviceInformation {}
}

record! {
    crate::base::GetDeviceDescriptors {}
}

record! {
    crate::base::BuiltInTest {}
}

record! {
    crate::base::Resume {}
}

record! {
    crate::base::GetDeviceDescriptorsExtended {}
}

record! {
    crate::base::ContinuousBuiltInTest {}
}

record! {
    crate::base::CommPortSpeed { function, port, baud }
    "function" => value(function);
    "port" => some_value(port);
    "baud" => some_value(baud);
}

record! {
    crate::base::GpsTimeUpdate { function, field_id, value }
    "function" => value(function);
    "field_id" => some_value(field_id);
    "value" => some_value(value);
}

record! {
    crate::base::ResetDevice {}
}

record! {
    crate::base::GetDeviceInformationResponse { device_info }
    "device_info" => value(device_info);
}

record! {
    crate::base::GetDeviceDescriptorsResponse { descriptors }
    "descriptors" => value(descriptors);
}

record! {
    crate::base::BuiltInTestResponse { result }
    "result" => value(result);
}

record! {
    crate::base::GpsTimeUpdateWeekNumberResponse { week_number }
    "week_number" => value(week_number);
}

record! {
    crate::base::GpsTimeUpdateTimeOfWeekResponse { time_of_week }
    "time_of_week" => value(time_of_week);
}

record! {
    crate::base::GetDeviceDescriptorsExtendedResponse { descriptors }
    "descriptors" => value(descriptors);
}

record! {
    crate::base::ContinuousBuiltInTestResponse { result }
    "result" => value(result);
}

record! {
    crate::base::CommPortSpeedResponse { port, baud }
    "port" => value(port);
    "baud" => value(baud);
}
