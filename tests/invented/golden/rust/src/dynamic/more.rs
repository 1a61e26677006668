use crate::dynamic::macros::record;

record! {
    crate::more::Own { mode }
    "mode" => value(mode);
}
