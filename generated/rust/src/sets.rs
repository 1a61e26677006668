//! One module for each family of descriptor sets, and one for the first steps with a device.

#[cfg(feature = "aiding")]
pub mod aiding;
#[cfg(feature = "base")]
pub mod base;
#[cfg(feature = "displacement")]
pub mod displacement;
#[cfg(feature = "displacement_data")]
pub mod displacement_data;
#[cfg(feature = "filter")]
pub mod filter;
#[cfg(feature = "filter_data")]
pub mod filter_data;
#[cfg(feature = "gnss")]
pub mod gnss;
#[cfg(feature = "gnss_data")]
pub mod gnss_data;
#[cfg(feature = "mip_3dm")]
pub mod mip_3dm;
#[cfg(feature = "rtk")]
pub mod rtk;
#[cfg(feature = "sensor")]
pub mod sensor;
#[cfg(all(feature = "base", feature = "mip_3dm"))]
pub mod session;
#[cfg(feature = "shared")]
pub mod shared;
#[cfg(feature = "system")]
pub mod system;
#[cfg(feature = "system_data")]
pub mod system_data;
#[cfg(all(feature = "base", feature = "mip_3dm", feature = "open"))]
pub use session::open;
#[cfg(all(feature = "base", feature = "mip_3dm", feature = "tokio"))]
pub use session::open_async;
