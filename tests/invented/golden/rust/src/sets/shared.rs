//! Shared (0xFF): Valid in every data set.

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

record! {
    /// Timestamp (0xFF,0xD3).
    ///
    /// When the packet was sent.
    ///
    /// Supported by [Model A](crate::devices::MODEL_A) and [Model C](crate::devices::MODEL_C).
    ///
    /// Source: guide: Timestamp.
    #[derive(Copy, Default)]
    pub struct Timestamp {
        /// Time of week.
        ///
        /// Unit: s. Valid if [`valid_flags.ready`](types::StateFlags::ready) is set.
        #[cfg_attr(feature = "serde", serde(with = "crate::readable"))]
        pub tow: f64,
        /// What is valid.
        pub valid_flags: types::StateFlags,
    }
}

view! {
    Timestamp
    tow: f64, at 0;
    valid_flags: types::StateFlags, at 8;
}

constructors! {
    Timestamp

    /// Creates it from its values.
    fn new(tow: f64, valid_flags: types::StateFlags);
}

field! {
    Timestamp: 0xD3, "shared.timestamp";
    in [0x80..=0xFE];
}
