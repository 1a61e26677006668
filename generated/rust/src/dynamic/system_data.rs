use crate::dynamic::macros::record;

record! {
    crate::system_data::BuiltInTest { result }
    "result" => value(result);
}

record! {
    crate::system_data::TimeSyncStatus { time_sync, last_pps_rcvd }
    "time_sync" => value(time_sync);
    "last_pps_rcvd" => value(last_pps_rcvd);
}

record! {
    crate::system_data::GpioState { states }
    "states" => value(states);
}

record! {
    crate::system_data::GpioAnalogValue { gpio_id, value }
    "gpio_id" => value(gpio_id);
    "value" => value(value);
}
