//! Awkward names (0x0C): Names that are keywords or begin with a digit.

// The macros are in `src/macros`; `cargo doc` shows what they generate. `open_enum!` and
// `bitfield!`: types of values; `record!`: a structure with its codec; `union!`: its alternatives;
// `view!`: methods that read single values; `constructors!` and `setters!`: functions that fill the
// structure; `field!`: its sets and descriptor; `command!` and `responses!`: the replies to it.

#[allow(unused_imports)] // some families name a type in comments only, or none
use crate::types;

/// The number of the descriptor set.
pub const SET: crate::DescriptorSet = crate::DescriptorSet(0x0C);

record! {
    /// Default (0x0C,0x10).
    ///
    /// Its parameters are keywords here and there.
    ///
    /// Not acknowledged if [`mode`](crate::tools::Settings::mode) of
    /// [`tools::Settings`](crate::tools::Settings) is [`types::Mode::FAST`]. Supported by [Model
    /// A](crate::devices::MODEL_A).
    ///
    /// Source: guide: Default.
    #[derive(Copy, Default, Eq, Hash)]
    pub struct Default {
        /// A keyword.
        pub class: u8,
        /// A keyword.
        #[cfg_attr(feature = "serde", serde(rename = "type"))]
        pub type_: u8,
        /// A keyword.
        pub register: u8,
        /// A keyword.
        #[cfg_attr(feature = "serde", serde(rename = "self"))]
        pub self_: u8,
        /// Used by generated code elsewhere.
        pub present: u8,
    }
    wire 5 {
        [class]
        [type_ "type"]
        [register]
        [self_ "self"]
        [present]
    }
}

constructors! {
    Default

    /// Creates the command from its parameters.
    fn new(
        class: u8,
        type_: u8,
        register: u8,
        self_: u8,
        present: u8,
    );
}

field! {
    Default: 0x10, "3d.default";
    in [0x0C];
}

command! {
    Default -> ();
}
