use mip_protocol::{base::GetDeviceInfo, sensor::ScaledAccel, PacketBuilder, Parser};

fn main() -> Result<(), mip_protocol::EncodeError> {
    let packet = PacketBuilder::with(&GetDeviceInfo::new())?; // now send packet.bytes()
    println!("{} bytes to send", packet.bytes().len());

    let received = b"$GPGGA noise\r\n\x75\x65\x80\x0E\x0E\x04\x3E\x7A\x63\xA0\
                     \xBB\x8E\x3B\x29\x7F\xE5\xBF\x7F\x84\xEE";
    let mut parser = Parser::new(); // for a stream; `packets` if all bytes are there
    parser.feed(received).for_each(|packet| match packet.find::<ScaledAccel>() {
        Ok(Some(accel)) => println!("{:.4} g along x", accel.scaled_accel.x),
        Err(broken) => println!("{broken}"),
        Ok(None) => {} // the packet contains other fields
    });
    Ok(())
}
