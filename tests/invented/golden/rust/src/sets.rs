//! One module for each descriptor set.

#[cfg(feature = "copy")]
pub mod copy;
#[cfg(feature = "measurements")]
pub mod measurements;
#[cfg(feature = "mip_3d")]
pub mod mip_3d;
#[cfg(feature = "more")]
pub mod more;
#[cfg(feature = "shared")]
pub mod shared;
#[cfg(feature = "tools")]
pub mod tools;
