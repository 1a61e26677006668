use crate::dynamic::macros::record;

record! {
    crate::shared::EventSource { trigger_id }
    "trigger_id" => value(trigger_id);
}

record! {
    crate::shared::Ticks { ticks }
    "ticks" => value(ticks);
}

record! {
    crate::shared::DeltaTicks { ticks }
    "ticks" => value(ticks);
}

record! {
    crate::shared::GpsTimestamp { tow, week_number, valid_flags }
    "tow" => value(tow);
    "week_number" => value(week_number);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::shared::DeltaTime { seconds }
    "seconds" => value(seconds);
}

record! {
    crate::shared::ReferenceTimestamp { nanoseconds }
    "nanoseconds" => value(nanoseconds);
}

record! {
    crate::shared::ReferenceTimeDelta { dt_nanos }
    "dt_nanos" => value(dt_nanos);
}

record! {
    crate::shared::ExternalTimestamp { nanoseconds, valid_flags }
    "nanoseconds" => value(nanoseconds);
    "valid_flags" => value(valid_flags);
}

record! {
    crate::shared::ExternalTimeDelta { dt_nanos, valid_flags }
    "dt_nanos" => value(dt_nanos);
    "valid_flags" => value(valid_flags);
}
