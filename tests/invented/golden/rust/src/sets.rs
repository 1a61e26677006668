//! One module for each family of descriptor sets.

#[cfg(feature = "measurements")]
pub mod measurements;
#[cfg(feature = "mip_3d")]
pub mod mip_3d;
#[cfg(feature = "shared")]
pub mod shared;
#[cfg(feature = "tools")]
pub mod tools;
