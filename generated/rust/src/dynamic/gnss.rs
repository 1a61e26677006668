use crate::dynamic::macros::record;

record! {
    crate::gnss::ReceiverInfoEntry { receiver_id, mip_data_descriptor_set, description }
    "receiver_id" => value(receiver_id);
    "mip_data_descriptor_set" => value(mip_data_descriptor_set);
    "description" => value(description);
}

record! {
    crate::gnss::ReceiverInfo {}
}

record! {
    crate::gnss::SignalConfiguration {
        function,
        gps_enable,
        glonass_enable,
        galileo_enable,
        beidou_enable,
        reserved,
    }
    "function" => value(function);
    "gps_enable" => some_value(gps_enable);
    "glonass_enable" => some_value(glonass_enable);
    "galileo_enable" => some_value(galileo_enable);
    "beidou_enable" => some_value(beidou_enable);
    "reserved" => some_value(reserved);
}

record! {
    crate::gnss::RtkDongleConfiguration { function, enable, reserved }
    "function" => value(function);
    "enable" => some_value(enable);
    "reserved" => some_value(reserved);
}

record! {
    crate::gnss::SpartnConfiguration {
        function,
        enable,
        type_,
        current_key_tow,
        current_key_week,
        current_key,
        next_key_tow,
        next_key_week,
        next_key,
    }
    "function" => value(function);
    "enable" => some_value(enable);
    "type" => some_value(type_);
    "current_key_tow" => some_value(current_key_tow);
    "current_key_week" => some_value(current_key_week);
    "current_key" => some_value(current_key);
    "next_key_tow" => some_value(next_key_tow);
    "next_key_week" => some_value(next_key_week);
    "next_key" => some_value(next_key);
}

record! {
    crate::gnss::ReceiverInfoResponse { receiver_info }
    "num_receivers" => counter(receiver_info, "receiver_info");
    "receiver_info" => value(receiver_info);
}

record! {
    crate::gnss::SignalConfigurationResponse {
        gps_enable,
        glonass_enable,
        galileo_enable,
        beidou_enable,
        reserved,
    }
    "gps_enable" => value(gps_enable);
    "glonass_enable" => value(glonass_enable);
    "galileo_enable" => value(galileo_enable);
    "beidou_enable" => value(beidou_enable);
    "reserved" => value(reserved);
}

record! {
    crate::gnss::RtkDongleConfigurationResponse { enable, reserved }
    "enable" => value(enable);
    "reserved" => value(reserved);
}

record! {
    crate::gnss::SpartnConfigurationResponse {
        enable,
        type_,
        current_key_tow,
        current_key_week,
        current_key,
        next_key_tow,
        next_key_week,
        next_key,
    }
    "enable" => value(enable);
    "type" => value(type_);
    "current_key_tow" => value(current_key_tow);
    "current_key_week" => value(current_key_week);
    "current_key" => value(current_key);
    "next_key_tow" => value(next_key_tow);
    "next_key_week" => value(next_key_week);
    "next_key" => value(next_key);
}
