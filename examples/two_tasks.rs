//! Uses a device in two tasks of `tokio`: one shows its data, the other sends commands.
//!
//!     cargo run --example two_tasks --features tokio -- /dev/ttyACM0

use std::error::Error;

use mip_protocol::base::GetDeviceInfo;
use mip_protocol::sensor::{self, ScaledAccel};
use mip_protocol::session::Rate;

#[tokio::main]
async fn main() {
    if let Err(error) = run().await {
        eprintln!("two_tasks: {error}");
        std::process::exit(1);
    }
}

async fn run() -> Result<(), Box<dyn Error + Send + Sync>> {
    let place = std::env::args().nth(1).ok_or("usage: two_tasks PORT | HOST:PORT")?;
    let mut device = mip_protocol::open_async(&place).await?; // finds the baud rate
    device.stream(sensor::SET, &[Rate::of::<ScaledAccel>(100.0)]).await?;

    let (commands, mut data) = device.split();
    let reader = tokio::spawn(async move {
        let mut data = data.fields::<ScaledAccel>(1000);
        while let Some(found) = data.next().await {
            let [x, y, z]: [f32; 3] = found?.1.scaled_accel.into();
            println!("{x:8.4} {y:8.4} {z:8.4} g");
        }
        Ok::<_, Box<dyn Error + Send + Sync>>(())
    });
    let info = commands.request(&GetDeviceInfo::new()).await?.device_info;
    println!("{}", info.model_name.to_string().trim()); // some devices pad it in front
    reader.await?
}
