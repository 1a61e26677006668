use crate::dynamic::macros::record;

record! {
    crate::shared::Timestamp { tow, valid_flags }
    "tow" => value(tow);
    "valid_flags" => value(valid_flags);
}
