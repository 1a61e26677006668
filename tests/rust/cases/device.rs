//! A device at a scripted port. The program chooses the `Device`, which blocks or is awaited, and `SLACK`, the
//! milliseconds by which a time-out may be late.

use std::collections::VecDeque;
use std::error::Error as _;
use std::io::{self, ErrorKind, Read, Write};

use mip_protocol::device::{self, DeviceError, Port, StdPort};
use mip_protocol::protocol::{AckCode, Acknowledge};
use mip_protocol::types::{Mode, Vector3f};
use mip_protocol::{
    measurements, tools, AnyField, Client, Command, CommandError, DescriptorSet, EncodeErrorKind,
    Field, PacketBuilder, Reason, RequestError,
};

use crate::{Device, SLACK};

/// A port that answers each packet with chunks, or with an error; in between, time goes on.
#[derive(Debug, Default)]
struct Played {
    sent: Vec<Vec<u8>>,
    /// Packets of several pings; they are answered at once.
    barriers: usize,
    replies: VecDeque<Vec<Vec<u8>>>,
    coming: VecDeque<Vec<u8>>,
    now: u32,
    /// How long the program is stopped before the next read.
    stopped: u32,
    /// The same during the next read, which then returns nothing.
    stopped_inside: u32,
    /// How long reading takes if there are bytes.
    pace: u32,
    /// Is it one that does not know whether bytes wait?
    ignores: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gone;

impl std::fmt::Display for Gone {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("gone")
    }
}

impl std::error::Error for Gone {}

impl Port for Played {
    type Error = Gone;

    fn read(&mut self, buffer: &mut [u8]) -> Result<usize, Gone> {
        self.now = self.now.wrapping_add(std::mem::take(&mut self.stopped));
        let inside = std::mem::take(&mut self.stopped_inside);
        if inside > 0 {
            self.now = self.now.wrapping_add(inside);
            return Ok(0);
        }
        let Some(chunk) = self.coming.front_mut() else {
            self.now += 10;
            return Ok(0);
        };
        if chunk.is_empty() {
            self.coming.pop_front();
            return Err(Gone);
        }
        self.now += self.pace;
        let count = chunk.len().min(buffer.len());
        buffer[..count].copy_from_slice(&chunk[..count]);
        chunk.drain(..count);
        if chunk.is_empty() {
            self.coming.pop_front();
        }
        Ok(count)
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), Gone> {
        if let Some(answer) = barrier(bytes) {
            self.barriers += 1;
            self.coming.push_back(answer);
            return Ok(());
        }
        self.sent.push(bytes.to_vec());
        self.coming.extend(self.replies.pop_front().unwrap_or_default());
        Ok(())
    }

    fn waits(&mut self) -> Result<bool, Gone> {
        Ok(!self.ignores && !self.coming.is_empty())
    }

    fn now_ms(&mut self) -> u32 {
        self.now
    }
}

/// The answer to a barrier, if it is one: as many acknowledges as it has pings.
fn barrier(bytes: &[u8]) -> Option<Vec<u8>> {
    let mut answer = PacketBuilder::new(tools::SET);
    let pings = bytes.get(4..bytes.len() - 2)?;
    for ping in pings.chunks(2) {
        answer.push(&Acknowledge { command: 1, code: AckCode::OK }).ok()?;
        (ping == [2, 1]).then_some(())?;
    }
    (bytes[2] == tools::SET.0 && pings.len() > 2).then(|| answer.bytes().to_vec())
}

fn ack(command: u8, code: AckCode) -> Vec<u8> {
    packet(&Acknowledge { command, code })
}

fn packet<T: Field>(field: &T) -> Vec<u8> {
    let mut builder = PacketBuilder::new(T::SETS[0]);
    builder.push(field).unwrap();
    builder.bytes().to_vec()
}

fn answered<T: Field>(command: u8, response: &T) -> Vec<u8> {
    let mut builder = PacketBuilder::new(tools::SET);
    builder.push(&Acknowledge { command, code: AckCode::OK }).unwrap();
    builder.push(response).unwrap();
    builder.bytes().to_vec()
}

fn data(x: f32) -> Vec<u8> {
    packet(&measurements::Accel {
        scaled_accel: Vector3f::from([x, 0.0, 0.0]),
        ..Default::default()
    })
}

const BIAS: tools::BiasVector = tools::BiasVector { bias: Vector3f { x: 1.0, y: 2.0, z: 3.0 } };

fn device(replies: impl IntoIterator<Item = Vec<Vec<u8>>>) -> Device<Played> {
    Device::new(Played { replies: replies.into_iter().collect(), ..Default::default() })
}

fn next<const N: usize, const Q: usize>(device: &mut Device<Played, N, Q>) -> Option<Vec<u8>> {
    device.next_packet(100).unwrap().map(|packet| packet.bytes().to_vec())
}

#[test]
fn a_response_and_the_data_around_it() {
    let stream = [data(1.0), data(2.0), answered(5, &BIAS), data(3.0)].concat();
    for size in [1, 3, 7, 64, 1000] {
        let chunks = stream.chunks(size).map(<[u8]>::to_vec).collect();
        let mut device = device([chunks]);
        assert_eq!(device.request(&tools::Bias::read()), Ok(BIAS));
        assert_eq!(device.port().sent.len(), 1);
        for x in [1.0, 2.0, 3.0] {
            assert_eq!(next(&mut device), Some(data(x)));
        }
        assert_eq!(next(&mut device), None);
        assert_eq!((device.dropped(), device.parser().skipped()), (0, 0));
    }
}

#[test]
fn a_command_that_is_only_sent() {
    let reply = ack(1, AckCode::OK);
    let refused = vec![ack(1, AckCode(3))];
    let mut device = device([vec![reply.clone()], vec![], vec![reply.clone()], refused]);
    assert_eq!(device.send(&tools::Ping), Ok(()));
    took(&mut device, 0);
    assert_eq!(next(&mut device), Some(reply)); // data
    device.port_mut().ignores = true; // a late reply is not read before the next command is sent
    assert_eq!(device.send(&tools::Ping), Ok(()));
    assert_eq!(device.send(&tools::Ping), Ok(()));
    assert!(device.request(&tools::Ping).is_err()); // by its own reply
    assert_eq!(next(&mut device), Some(ack(1, AckCode::OK))); // the late one is data
    assert_eq!((device.port().sent.len(), device.port().barriers), (4, 1));
}

/// The time that has passed since the last call.
fn took<const N: usize, const Q: usize>(device: &mut Device<Played, N, Q>, milliseconds: u32) {
    let time = std::mem::take(&mut device.port_mut().now);
    assert!((milliseconds..=milliseconds + SLACK).contains(&time), "{time}");
}

/// The error of a command.
fn failed<C: Command, E>(reason: Reason) -> DeviceError<E> {
    CommandError::new(C::NAME, reason).into()
}

#[test]
fn what_can_become_of_a_command() {
    let mut device = device([
        vec![ack(1, AckCode::OK)],
        vec![ack(5, AckCode::INVALID_PARAMETER)],
        vec![],
        vec![ack(5, AckCode::OK)],
        vec![],
        vec![vec![]],
        vec![answered(5, &BIAS)],
    ]);
    assert_eq!(device.request(&tools::Ping), Ok(()));
    let refused = device.request(&tools::Bias::read()).unwrap_err();
    let code = AckCode::INVALID_PARAMETER;
    assert_eq!(refused, failed::<tools::Bias, _>(Reason::Refused(code)));
    let late = failed::<tools::Bias, _>(Reason::TimedOut);
    assert_eq!(device.request(&tools::Bias::read()), Err(late));
    took(&mut device, 1000);
    let missing = failed::<tools::Bias, _>(Reason::MissingResponse);
    assert_eq!(device.request(&tools::Bias::read()), Err(missing));
    let late = failed::<tools::Status, _>(Reason::TimedOut);
    assert!(matches!(device.request(&tools::Status::new(1)), Err(e) if e == late));
    took(&mut device, 2500);
    assert_eq!(device.port().barriers, 1);
    assert_eq!(device.request(&tools::Ping), Err(DeviceError::Port(Gone)));
    assert_eq!(device.request(&tools::Bias::read()), Ok(BIAS));
    assert_eq!(next(&mut device), None);
}

#[test]
fn what_is_not_sent() {
    let mut device = device([]);
    let mut no_value = tools::Bias::write(Vector3f::default()).into_command();
    no_value.bias = None;
    let Err(DeviceError::Request(RequestError::Encode(error))) = device.request(&no_value) else {
        panic!()
    };
    assert_eq!(error.kind, EncodeErrorKind::Missing);
    assert_eq!(error.to_string(), "tools.bias.bias: it is missing, or a value before it");
    assert!(device.port().sent.is_empty());
    let request = error_of(error);
    let whole = DeviceError::<io::Error>::from(request);
    assert!(whole.to_string().starts_with("not sent: "));
    // The text states the cause, so `source` does not: programs that print both would repeat it.
    assert!(whole.to_string().ends_with(&error.to_string()) && whole.source().is_none());
    let broken = tools::Bias::decode(&[]).unwrap_err();
    let undecodable = Reason::Undecodable(broken);
    let whole = failed::<tools::Bias, io::Error>(undecodable);
    assert_eq!(whole.to_string(), format!("tools.bias: {undecodable}"));
    assert_eq!(whole.source().unwrap().to_string(), broken.to_string());
}

fn error_of(error: mip_protocol::EncodeError) -> RequestError {
    error.into()
}

#[test]
fn several_commands_in_one_packet_and_their_answers_in_several() {
    let reply = vec![data(1.0), ack(1, AckCode::OK), data(2.0), answered(5, &BIAS)];
    let mut device = device([reply, vec![ack(1, AckCode::OK)], vec![ack(1, AckCode::OK)]]);
    let tickets = device.send_all(tools::SET, |request| {
        Ok((
            request.add(&tools::Ping)?,
            request.add(&tools::Bias::read())?,
            request.add(&tools::Ping)?,
        ))
    });
    let (first, second, third) = tickets.unwrap();
    assert_eq!(device.port().sent.len(), 1);
    took(&mut device, 1000);
    assert_eq!(device.answer(&second), Ok(BIAS));
    assert_eq!(device.answer(&third).unwrap_err().reason, Reason::TimedOut);
    assert_eq!(next(&mut device), Some(data(1.0)));
    // An unsolicited answer takes no room from the next.
    for _ in 0..2 {
        assert_eq!(device.request(&tools::Ping), Ok(()));
    }
    let forgotten = CommandError::new("tools.ping", Reason::Forgotten);
    assert_eq!(device.answer(&first), Err(forgotten));
    assert_eq!(next(&mut device), Some(data(2.0)));
    let replies = [vec![ack(1, AckCode::OK), answered(5, &BIAS)], vec![ack(1, AckCode(3))]];
    let mut device = self::device(replies);
    let both = (&tools::Ping, &tools::Bias::read());
    assert_eq!(device.request_all(both), Ok(((), BIAS)));
    assert_eq!(device.port().sent.len(), 1);
    let rejected = failed::<tools::Ping, _>(Reason::Refused(AckCode(3)));
    assert_eq!(device.request_all(both), Err(rejected));
    // Nothing is sent if one of them cannot be added.
    let mut small: Device<_, 1> = Device::with_client(Played::default(), Client::with_timeout(50));
    let busy = small.send_all(tools::SET, |request| {
        Ok((request.add(&tools::Ping)?, request.add(&tools::Ping)?))
    });
    assert_eq!(busy.unwrap_err(), DeviceError::Request(RequestError::Busy));
    assert!(small.port().sent.is_empty());
    assert_eq!(small.request(&tools::Ping), Err(failed::<tools::Ping, _>(Reason::TimedOut)));
    took(&mut small, 50);
}

#[test]
fn each_command_has_a_time_out_of_its_own() {
    let mut device = device([vec![]]);
    let both = device.send_all(tools::SET, |request| {
        Ok((request.add(&tools::Ping)?, request.add(&tools::Status::new(1))?))
    });
    took(&mut device, 2500);
    let (ping, status) = both.unwrap();
    assert_eq!(device.answer(&ping).unwrap_err().reason, Reason::TimedOut);
    assert_eq!(device.answer(&status).unwrap_err().reason, Reason::TimedOut);
}

#[test]
fn noise_hides_no_answer_and_no_data() {
    let noise = b"ue\x80\xFF".to_vec();
    let mut device = device([vec![noise.clone(), answered(5, &BIAS), data(1.0)]]);
    assert_eq!(device.request(&tools::Bias::read()), Ok(BIAS));
    took(&mut device, 1000); // only then is it known to be noise
    device.port_mut().coming.extend([noise, data(2.0)]);
    assert_eq!(next(&mut device), Some(data(1.0)));
    assert_eq!(next(&mut device), Some(data(2.0)));
    assert_eq!((next(&mut device), device.parser().skipped()), (None, 8));
}

#[test]
fn data_are_kept_as_far_as_there_is_room() {
    let count = if cfg!(miri) { 100 } else { 1000 }; // Miri is a thousand times slower
    let size = data(0.0).len();
    let chunks: Vec<_> = (0..count).map(|n| data(n as f32)).chain([ack(1, AckCode::OK)]).collect();
    let port = Played { replies: [chunks].into(), ..Default::default() };
    let mut device: Device<_, 1, 600> = Device::with_client(port, Client::default());
    device.request(&tools::Ping).unwrap();
    let kept = 600 / size;
    assert_eq!(device.dropped() as usize, count - kept);
    for n in count - kept..count {
        assert_eq!(next(&mut device), Some(data(n as f32)));
    }
    // A stream that is read loses nothing, in whatever chunks it comes.
    let mut device: Device<_, 1, 265> = Device::with_client(Played::default(), Client::default());
    let stream: Vec<u8> = (0..count).flat_map(|n| data(n as f32)).collect();
    device.port_mut().coming.extend(stream.chunks(501).map(<[u8]>::to_vec));
    for n in 0..count {
        assert_eq!(next(&mut device), Some(data(n as f32)));
    }
    assert_eq!((next(&mut device), device.dropped()), (None, 0));
    // Without room, all is dropped, and commands work.
    let replies = [vec![data(1.0), ack(1, AckCode::OK)]].into();
    let port = Played { replies, ..Default::default() };
    let mut device: Device<_, 1, 0> = Device::with_client(port, Client::default());
    assert_eq!((device.request(&tools::Ping), device.dropped()), (Ok(()), 1));
}

#[test]
fn the_time_that_data_may_take() {
    let mut device = device([]);
    assert!(device.next_packet(0).unwrap().is_none());
    took(&mut device, if SLACK > 0 { 0 } else { 10 });
    assert!(device.next_packet(500).unwrap().is_none());
    took(&mut device, 500);
    device.port_mut().coming.push_back(vec![]);
    assert_eq!(device.next_packet(500).unwrap_err(), DeviceError::Port(Gone));
}

#[test]
fn a_copy_of_a_reply_that_waits_is_not_that_of_the_next_command() {
    let twice = |code| vec![ack(1, code), ack(1, code)];
    let mut device = device([twice(AckCode::OK), twice(AckCode::INVALID_PARAMETER)]);
    assert!(device.request(&tools::Ping).is_ok() && device.request(&tools::Ping).is_err());
    assert!(next(&mut device).is_some() && next(&mut device).is_some());
    // Bytes that arrive without end do not keep a command from being sent.
    device.port_mut().pace = 10;
    device.port_mut().coming.extend(vec![vec![0]; 1000]);
    assert!(device.request(&tools::Ping).is_err() && device.port().sent.len() == 3);
    assert!(device.port().coming.len() > 500);
}

#[test]
fn a_program_that_was_stopped_finds_what_came_in_time() {
    let stopped = |replies: Vec<Vec<u8>>| {
        let mut device = device([replies]);
        device.port_mut().stopped = 5000;
        device.port_mut().now = u32::MAX - 100;
        device
    };
    let before: Vec<u8> = (0..50).flat_map(|n| data(n as f32)).collect();
    let mut device = stopped(vec![before.clone(), answered(5, &BIAS)]);
    assert_eq!(device.request(&tools::Bias::read()), Ok(BIAS));
    for n in 0..50 {
        assert_eq!(next(&mut device), Some(data(n as f32)));
    }
    device.port_mut().stopped = 5000;
    device.port_mut().coming.extend([vec![0; 2000], data(1.0)]);
    assert_eq!(next(&mut device), Some(data(1.0)));
    device.port_mut().stopped_inside = 5000;
    device.port_mut().replies.push_back(vec![answered(5, &BIAS)]);
    assert_eq!(device.request(&tools::Bias::read()), Ok(BIAS));
    // Reading stops when nothing is missing any more, and finally even if bytes never end.
    let late = Err(failed::<tools::Bias, _>(Reason::TimedOut));
    assert_eq!(stopped(vec![before]).request(&tools::Bias::read()), late);
    let mut device = stopped(vec![vec![0]; 100]);
    assert_eq!(device.request(&tools::Bias::read()), late);
    assert!((99 - 64..=100 - 64).contains(&device.port().coming.len()));
    assert_eq!(next(&mut device), None);
}

#[test]
fn bytes_that_keep_coming_hold_nothing_up() {
    if SLACK > 0 {
        return; // a device that is awaited counts reads, and no time
    }
    let talking = |pace| {
        let mut device = device([]);
        device.port_mut().ignores = true;
        device.port_mut().pace = pace;
        device.port_mut().coming.extend(vec![vec![0]; 1000]);
        device
    };
    // After the deadline, reading goes on for what the first read after it leaves of 100 ms.
    for (pace, end) in [(1, 64), (10, 110), (99, 297), (100, 200), (900, 1800)] {
        let mut device = talking(pace);
        assert!(device.next_packet(0).unwrap().is_none());
        assert_eq!(device.port().now, end, "{pace}");
    }
    for (pace, end) in [(10, 1100), (100, 1100), (900, 2700)] {
        let mut device = talking(pace);
        let late = Err(failed::<tools::Bias, _>(Reason::TimedOut));
        assert_eq!(device.request(&tools::Bias::read()), late);
        assert_eq!(device.port().now, end, "{pace}");
    }
    // Each deadline has such a time of its own: an answer between two is not lost.
    let mut device = talking(100);
    device.port_mut().coming.insert(25, answered(4, &tools::StatusShort::default()));
    let tickets = device.send_all(tools::SET, |request| {
        Ok((request.add(&tools::Ping)?, request.add(&tools::Status::new(1))?))
    });
    let (ping, status) = tickets.unwrap();
    assert_eq!(device.port().now, 2600);
    assert_eq!(device.answer(&ping).unwrap_err().reason, Reason::TimedOut);
    assert!(device.answer(&status).is_ok());
}

/// A stream whose reads report that there is nothing, in one of the possible ways.
struct Stream {
    nothing: fn() -> io::Result<usize>,
    coming: VecDeque<u8>,
    sent: Vec<u8>,
}

impl Read for Stream {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        // After each byte, one read finds nothing.
        match self.coming.pop_front() {
            Some(0xFF) | None => (self.nothing)(),
            Some(byte) => {
                buffer[0] = byte;
                Ok(1)
            }
        }
    }
}

impl Write for Stream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.sent.push(bytes[0]);
        self.coming.extend(
            ack(1, AckCode::OK).iter().flat_map(|b| [0xFF, *b]).take(if self.sent.len() == 8 {
                99
            } else {
                0
            }),
        );
        Ok(1)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn ports_of_the_standard_library() {
    let ways: [fn() -> io::Result<usize>; 3] = [
        || Err(ErrorKind::TimedOut.into()),
        || Err(ErrorKind::WouldBlock.into()),
        || Err(ErrorKind::Interrupted.into()),
    ];
    for nothing in ways {
        let stream = Stream { nothing, coming: VecDeque::new(), sent: Vec::new() };
        let client = Client::with_timeout(20_000);
        let mut device: device::Device<_> =
            device::Device::with_client(StdPort::new(stream), client);
        device.request(&tools::Ping).unwrap();
        assert_eq!(device.port().get_ref().sent, packet(&tools::Ping));
        assert!(device.next_packet(5).unwrap().is_none());
    }
    let nothing = || Err(ErrorKind::BrokenPipe.into());
    let stream = Stream { nothing, coming: VecDeque::new(), sent: Vec::new() };
    let mut device = device::Device::new(StdPort::new(stream));
    let error = device.request(&tools::Ping).unwrap_err();
    assert!(matches!(&error, DeviceError::Port(e) if e.kind() == ErrorKind::BrokenPipe));
    let error: Box<dyn std::error::Error> = error.into();
    assert!(error.to_string().starts_with("port: "));
    // The other end has closed the connection.
    let stream = Stream { nothing: || Ok(0), coming: VecDeque::new(), sent: vec![0; 9] };
    let error = device::Device::new(StdPort::new(stream)).request(&tools::Ping).unwrap_err();
    assert!(matches!(&error, DeviceError::Port(e) if e.kind() == ErrorKind::UnexpectedEof));
    // A time-out takes real time.
    let nothing = || Err(ErrorKind::WouldBlock.into());
    let stream = Stream { nothing, coming: VecDeque::new(), sent: vec![0; 9] };
    let client = Client::with_timeout(20);
    let mut device: device::Device<_, 1> =
        device::Device::with_client(StdPort::new(stream), client);
    let start = std::time::Instant::now();
    let error = device.request(&tools::Ping).unwrap_err();
    assert!(matches!(error, DeviceError::Command(e) if e.reason == Reason::TimedOut));
    assert!(start.elapsed().as_millis() >= 20);
}

#[test]
fn a_packet_longer_than_the_queue_leaves_the_others_in_it() {
    let mut large = PacketBuilder::new(measurements::MEASUREMENTS_SET);
    large.push_raw(0x70, &[0; 200]).unwrap();
    let replies = vec![data(1.0), data(2.0), large.bytes().to_vec(), ack(1, AckCode::OK)];
    let port = Played { replies: [replies].into(), ..Default::default() };
    let mut device: Device<Played, 1, 100> = Device::with_client(port, Client::default());
    assert_eq!(device.request(&tools::Ping), Ok(()));
    assert_eq!(device.dropped(), 1);
    assert_eq!((next(&mut device), next(&mut device)), (Some(data(1.0)), Some(data(2.0))));
}

#[test]
fn a_late_answer_is_not_that_of_the_next_command() {
    let other = tools::BiasVector { bias: Vector3f { x: 9.0, ..BIAS.bias } };
    let late = failed::<tools::Bias, _>(Reason::TimedOut);
    let noise = b"ue\x80\xFF".to_vec();
    let mut device = device([vec![], vec![answered(5, &BIAS)], vec![], vec![]]);
    assert_eq!(device.request(&tools::Bias::read()), Err(late));
    device.port_mut().coming.extend([data(1.0), noise, answered(5, &other)]);
    assert_eq!(device.request(&tools::Bias::read()), Ok(BIAS));
    // It is there as data.
    assert_eq!(next(&mut device), Some(data(1.0)));
    assert_eq!(next(&mut device), Some(answered(5, &other)));
    // A ping that is not answered, and a device that sends without end.
    let late = failed::<tools::Ping, _>(Reason::TimedOut);
    assert_eq!(device.request(&tools::Ping), Err(late));
    assert_eq!(next(&mut device), None);
    device.port_mut().coming.push_back(ack(1, AckCode::OK));
    device.port_mut().coming.extend(vec![vec![0]; 1000]);
    assert_eq!(device.request(&tools::Ping), Err(late));
    assert_eq!(device.port().sent.len(), 4);
}

#[test]
fn only_after_a_missing_answer_is_there_a_barrier() {
    let mut device = device([]);
    let answered = |device: &mut Device<Played>| {
        device.port_mut().replies = [vec![ack(1, AckCode::OK)]].into();
        let before = device.port().barriers;
        assert_eq!(device.request(&tools::Ping), Ok(()));
        device.port().barriers - before
    };
    assert_eq!(answered(&mut device), 0);
    let late = failed::<tools::Ping, _>(Reason::TimedOut);
    assert_eq!(device.request(&tools::Ping), Err(late));
    assert_eq!((answered(&mut device), answered(&mut device)), (1, 0));
    // A failed port is such a case, too, even with data in between.
    device.port_mut().replies = [vec![vec![], ack(1, AckCode::OK)]].into();
    assert_eq!(device.request(&tools::Ping), Err(DeviceError::Port(Gone)));
    assert_eq!(next(&mut device), Some(ack(1, AckCode::OK)));
    assert_eq!(answered(&mut device), 1);
}

#[test]
fn without_commands_nothing_is_sent() {
    let mut device = device([]);
    for set in [DescriptorSet(0), tools::SET, DescriptorSet(0xFF)] {
        assert_eq!(device.send_all(set, |_| Ok(())), Ok(()));
    }
    assert!(device.port().sent.is_empty());
    assert_eq!(device.port().now, 0);
}

#[test]
fn a_command_whose_type_is_known_at_run_time() {
    let mut device = device([
        vec![answered(5, &BIAS)],
        vec![ack(1, AckCode::INVALID_PARAMETER)],
        vec![],
        vec![],
    ]);
    let mut send = |command: AnyField| {
        let set = command.info().set().unwrap();
        let ticket = device.send_all(set, |request| request.add_any(&command)).unwrap();
        // It is there until the next command.
        assert_eq!(device.event(&ticket), device.event(&ticket));
        (ticket, device.event(&ticket).cloned())
    };
    let (first, bias) = send(tools::Bias::read().into());
    let bias = bias.unwrap();
    assert_eq!((bias.id, bias.outcome()), (first.id(), Ok(())));
    let response = AnyField::decode_with_trailing(&bias.response().unwrap()).unwrap().unwrap();
    assert_eq!(response.field, AnyField::from(BIAS));
    let refused = send(tools::Ping.into()).1.unwrap();
    assert_eq!(refused.outcome(), Err(Reason::Refused(AckCode::INVALID_PARAMETER)));
    assert_eq!(send(tools::Ping.into()).1.unwrap().outcome(), Err(Reason::TimedOut));
    let silent = send(tools::Settings::apply(1, Mode::FAST, 1).into());
    assert!(silent.0.is_silent() && silent.1.is_none());
    assert_eq!(device.event(&first), None);
}

#[test]
fn a_port_can_be_lent() {
    let mut port = Played { replies: [vec![ack(1, AckCode::OK)]].into(), ..Default::default() };
    assert_eq!(Device::new(&mut port).request(&tools::Ping), Ok(()));
    assert_eq!(port.sent, [packet(&tools::Ping)]);
}

#[test]
fn fields_are_iterated_until_no_packet_arrives() {
    let stream = vec![[data(1.0), ack(1, AckCode::OK)].concat(), data(2.0)];
    let mut device = device([stream]);
    device.request(&tools::Ping).unwrap();
    let found = device.fields::<measurements::Accel>(100).map(|found| found.unwrap());
    let found = found.map(|(time, accel)| (time, accel.scaled_accel.x));
    assert_eq!(found.collect::<Vec<_>>(), [(None, 1.0), (None, 2.0)]);
    let short = vec![0x75, 0x65, 0x80, 2, 2, measurements::Accel::DESCRIPTOR];
    let short = [&short[..], &mip_protocol::checksum(&short)].concat();
    device.port_mut().coming.push_back(short);
    let error = device.fields::<measurements::Accel>(100).next().unwrap().unwrap_err();
    assert!(matches!(error, DeviceError::Data(_)), "{error:?}");
}
