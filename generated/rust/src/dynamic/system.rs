use crate::dynamic::macros::record;

record! {
    crate::system::CommunicationMode { function, mode }
    "function" => value(function);
    "mode" => some_value(mode);
}

record! {
    crate::system::CommunicationModeResponse { mode }
    "mode" => value(mode);
}
