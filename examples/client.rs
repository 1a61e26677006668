use mip_protocol::{base, mip_3dm, Client, Parser, RequestError};

/// Your serial port, which sends bytes and returns received ones.
fn exchange(_sent: &[u8]) -> &'static [u8] {
    &[]
}

fn main() -> Result<(), RequestError> {
    let mut client = Client::new();
    let mut parser = Parser::new();

    let (ticket, packet) = client.send(&mip_3dm::PpsSourceControl::read(), 0)?;
    let mut received = exchange(packet.bytes());
    while let Some(packet) = parser.next(&mut received) {
        for event in client.receive(&packet) {
            match event.answer(&ticket) {
                Some(Ok(response)) => println!("{:?}", response.source),
                Some(Err(error)) => println!("{error}"), // rejected, with the named code, or undecodable
                None => {}                               // replies to another command
            }
        }
    }
    // Before a command times out, `poll` returns packets that noise has hidden.
    while let Some(packet) = client.poll(&mut parser, 1_000) {
        client.receive(&packet);
    }
    // Events stay until they are taken.
    let Some(Err(error)) = client.take(&ticket) else { unreachable!() };
    assert_eq!(error.to_string(), "3dm.pps_source_control: no reply arrived in time");

    // Several commands in one packet:
    let mut request = client.request(base::SET);
    let first = request.add(&base::Ping::new())?;
    let second = request.add(&base::Ping::new())?;
    let packet = request.send(1_000);
    println!("to send: {:02x?}, for {first:?} and {second:?}", packet.bytes());
    Ok(())
}
