use crate::dynamic::macros::record;

record! {
    crate::system::InterfaceControl { function, port, protocols_incoming, protocols_outgoing }
    "function" => value(function);
    "port" => some_value(port);
    "protocols_incoming" => some_value(protocols_incoming);
    "protocols_outgoing" => some_value(protocols_outgoing);
}

record! {
    crate::system::CommunicationMode { function, mode }
    "function" => value(function);
    "mode" => some_value(mode);
}

record! {
    crate::system::InterfaceControlResponse { port, protocols_incoming, protocols_outgoing }
    "port" => value(port);
    "protocols_incoming" => value(protocols_incoming);
    "protocols_outgoing" => value(protocols_outgoing);
}

record! {
    crate::system::CommunicationModeResponse { mode }
    "mode" => value(mode);
}
