use crate::dynamic::macros::record;

record! {
    crate::rtk::GetStatusFlags {}
}

record! {
    crate::rtk::GetImei {}
}

record! {
    crate::rtk::GetImsi {}
}

record! {
    crate::rtk::GetIccid {}
}

record! {
    crate::rtk::GetRssi {}
}

record! {
    crate::rtk::ConnectedDeviceType { function, device_type }
    "function" => value(function);
    "device_type" => some_value(device_type);
}

record! {
    crate::rtk::GetActivationCode {}
}

record! {
    crate::rtk::GetModemFirmwareVersion {}
}

record! {
    crate::rtk::ServiceStatus { reserved1, reserved2 }
    "reserved1" => value(reserved1);
    "reserved2" => value(reserved2);
}

record! {
    crate::rtk::EraseStorage { media }
    "media" => value(media);
}

record! {
    crate::rtk::LedControl { primary_color, alternate_color, action, period }
    "primary_color" => value(primary_color);
    "alternate_color" => value(alternate_color);
    "action" => value(action);
    "period" => value(period);
}

record! {
    crate::rtk::ModemHardReset {}
}

record! {
    crate::rtk::GetStatusFlagsResponse { flags }
    "flags" => value(flags);
}

record! {
    crate::rtk::GetImeiResponse { imei }
    "imei" => value(imei);
}

record! {
    crate::rtk::GetImsiResponse { imsi }
    "imsi" => value(imsi);
}

record! {
    crate::rtk::GetIccidResponse { iccid }
    "iccid" => value(iccid);
}

record! {
    crate::rtk::GetRssiResponse { valid, rssi, signal_quality }
    "valid" => value(valid);
    "rssi" => value(rssi);
    "signal_quality" => value(signal_quality);
}

record! {
    crate::rtk::ConnectedDeviceTypeResponse { device_type }
    "device_type" => value(device_type);
}

record! {
    crate::rtk::GetActivationCodeResponse { activation_code }
    "activation_code" => value(activation_code);
}

record! {
    crate::rtk::GetModemFirmwareVersionResponse { modem_firmware_version }
    "modem_firmware_version" => value(modem_firmware_version);
}

record! {
    crate::rtk::ServiceStatusResponse { flags, received_bytes, last_bytes, last_bytes_time }
    "flags" => value(flags);
    "received_bytes" => value(received_bytes);
    "last_bytes" => value(last_bytes);
    "last_bytes_time" => value(last_bytes_time);
}
