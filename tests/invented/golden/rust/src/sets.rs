//! One module for each descriptor set.

pub mod copy;
pub mod measurements;
pub mod mip_3d;
pub mod more;
pub mod shared;
pub mod tools;
