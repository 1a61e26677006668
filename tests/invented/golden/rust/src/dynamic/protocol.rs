use crate::dynamic::macros::record;

record! {
    crate::protocol::Acknowledge { command, code }
    "command" => value(command);
    "code" => value(code);
}
