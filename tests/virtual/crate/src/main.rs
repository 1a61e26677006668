//! Pings a device, requests two data fields, and prints the vectors of ten packets, or how far it came.

use std::{sync::Arc, time::Duration};

use microstrain_inertial::api::{
    commands::imu_3dm::DescriptorRate,
    data::sensor::{self, SensorField, SensorPacket},
};
use microstrain_inertial::{interface::AsyncInterface, serialport::start_serialport_thread};
use tokio::time::{sleep, timeout};

const PATIENCE: Duration = Duration::from_secs(5);

#[tokio::main(flavor = "current_thread")]
async fn main() {
    let interface = Arc::new(AsyncInterface::new());
    start_serialport_thread(&std::env::args().nth(1).unwrap(), 115_200, interface.clone()).unwrap();
    sleep(PATIENCE / 10).await; // when its receiving thread begins, it discards what has arrived
    println!("{:?}", timeout(PATIENCE, interface.ping()).await.unwrap().unwrap().acknack);
    let rates = [sensor::ScaledAccel::DESCRIPTOR, sensor::ScaledGyro::DESCRIPTOR]
        .map(|descriptor| DescriptorRate { descriptor, decimation: 100 });
    let format = interface.set_message_format(sensor::SENSOR_DESCRIPTOR_SET, &rates);
    if let Err(error) = timeout(PATIENCE, format).await.unwrap() {
        return println!("{error:?}");
    }
    for _ in 0..10 {
        let data = timeout(PATIENCE, interface.read_raw_data()).await.unwrap().unwrap();
        for field in SensorPacket::new(data.payload()).fields() {
            match field {
                Ok(SensorField::ScaledAccel(accel)) => println!("accel {:?}", accel.scaled_accel),
                Ok(SensorField::ScaledGyro(gyro)) => println!("gyro {:?}", gyro.scaled_gyro),
                other => println!("{:?}", other.is_ok()),
            }
        }
    }
}
