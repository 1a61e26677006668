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
    crate::base::SetIdle {}
}

record! {
    crate::base::GetDeviceInfo {}
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
    crate::base::GetExtendedDescriptors {}
}

record! {
    crate::base::ContinuousBuiltInTest {}
}

record! {
    crate::base::CommSpeed { function, port, baud }
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
    crate::base::SoftReset {}
}

record! {
    crate::base::GetDeviceInfoResponse { device_info }
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
    crate::base::GpsTimeUpdateTowResponse { tow }
    "tow" => value(tow);
}

record! {
    crate::base::GetExtendedDescriptorsResponse { descriptors }
    "descriptors" => value(descriptors);
}

record! {
    crate::base::ContinuousBuiltInTestResponse { result }
    "result" => value(result);
}

record! {
    crate::base::CommSpeedResponse { port, baud }
    "port" => value(port);
    "baud" => value(baud);
}
