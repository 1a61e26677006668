//! One module for each descriptor set.

pub mod aiding;
pub mod base;
pub mod filter;
pub mod filter_data;
pub mod gnss;
pub mod gnss_1;
pub mod gnss_2;
pub mod gnss_corrections;
pub mod gnss_data;
pub mod gnss_external;
pub mod gnss_external_2;
pub mod mip_3dm;
pub mod rtk;
pub mod sensor;
pub mod shared;
pub mod system;
pub mod system_data;
