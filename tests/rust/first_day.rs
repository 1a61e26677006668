//! The first minutes with a device, at a scripted port; with the real specification. The program chooses
//! the `Device`: one that blocks, or one that is awaited.

use std::collections::VecDeque;
use std::convert::Infallible;

use mip_protocol::device::{DeviceError, Port};
use mip_protocol::protocol::{AckCode, WriteCall};
use mip_protocol::session::{Rate, StreamError, BAUD_RATES};
use mip_protocol::{
    base, checksum, filter_data, mip_3dm, sensor, shared, CommandError, DescriptorSet, Packet,
    Reason, RequestError,
};

use crate::Device;

/// A device, and its faults.
#[derive(Clone, Debug)]
struct Fake {
    /// Its baud rate; and that of the port, which has none if it is 0.
    baud: u32,
    rate: u32,
    fastest: u32,
    /// Whether commands change its rate.
    changes: bool,
    now: u32,
    base_rate: u16,
    older: bool,
    /// Replies that it loses, to this command (0: to all); a command that it NACKs.
    lose: usize,
    lose_of: u16,
    refuse: u16,
    /// The descriptor with which a message format must begin (0: any).
    begin: u8,
    /// Its name and number.
    model: [&'static str; 2],
    /// Packets of data that it sends without being asked.
    data: usize,
    sent: Vec<Vec<u8>>,
    tried: Vec<u32>,
    coming: VecDeque<u8>,
}

fn device(baud: u32) -> Device<Fake> {
    at_rate(115_200, baud)
}

fn at_rate(rate: u32, baud: u32) -> Device<Fake> {
    Device::new(Fake {
        baud,
        rate,
        fastest: u32::MAX,
        changes: true,
        now: 0xFFFF_F000, // it wraps around
        base_rate: 1000,
        older: false,
        lose: 0,
        lose_of: 0,
        refuse: 0,
        begin: 0,
        model: ["3DM-CV7-AHRS", "6286-9999"],
        data: 0,
        sent: Vec::new(),
        tried: Vec::new(),
        coming: VecDeque::new(),
    })
}

fn packet(set: u8, payload: &[u8]) -> Vec<u8> {
    let mut bytes = vec![0x75, 0x65, set, payload.len() as u8];
    bytes.extend(payload);
    let sum = checksum(&bytes);
    bytes.extend(sum);
    bytes
}

impl Fake {
    fn commands(&self) -> Vec<u16> {
        self.sent.iter().map(|p| u16::from_be_bytes([p[2], p[5]])).collect()
    }

    fn last(&self, command: u16) -> &[u8] {
        let at = self.commands().iter().rposition(|c| *c == command).unwrap();
        let bytes = &self.sent[at];
        &bytes[6..bytes.len() - 2]
    }
}

impl Port for Fake {
    type Error = Infallible;

    fn read(&mut self, buffer: &mut [u8]) -> Result<usize, Self::Error> {
        self.now = self.now.wrapping_add(10);
        if self.data > 0 && self.coming.is_empty() {
            self.data -= 1;
            self.coming.extend(packet(0x80, &[]));
        }
        let count = buffer.len().min(self.coming.len());
        for (place, byte) in buffer.iter_mut().zip(self.coming.drain(..count)) {
            *place = if self.rate == self.baud { byte } else { byte ^ 0x5A };
        }
        Ok(count)
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), Self::Error> {
        let command = u16::from_be_bytes([bytes[2], bytes[5]]);
        assert!(Packet::new(bytes).is_ok());
        if command == 0x0101 && bytes[3] > 2 {
            let answers = [4, 0xF1, 1, 0].repeat(usize::from(bytes[3] / 2)); // to a barrier
            self.coming.extend(packet(1, &answers));
            return Ok(());
        }
        self.sent.push(bytes.to_vec());
        if self.rate != self.baud {
            self.coming.extend([0x75 ^ 0x5A; 40]);
            return Ok(());
        }
        if self.lose > 0 && [0, command].contains(&self.lose_of) {
            self.lose -= 1;
            return Ok(());
        }
        let known = if self.older {
            ![0x0C0E, 0x0C0F].contains(&command)
        } else {
            !(0x0C06..0x0C0C).contains(&command)
        };
        let first = match command {
            0x0C0F => bytes[9],
            0x0C08 => bytes[8],
            _ => self.begin,
        };
        let begins = self.begin == 0 || self.begin == first;
        let refused = command == self.refuse || !known || !begins;
        let mut payload = vec![4, 0xF1, bytes[5], u8::from(refused)];
        let [high, low] = self.base_rate.to_be_bytes();
        match command {
            _ if refused => {}
            0x0C0E => payload.extend([5, 0x8E, bytes[6], high, low]),
            0x0C06 => payload.extend([4, 0x83, high, low]),
            0x0C0B => payload.extend([4, 0x8A, high, low]),
            0x0103 => {
                payload.extend([84, 0x81, 0, 0]);
                payload.extend(format!("{:16}{:64}", self.model[0], self.model[1]).bytes());
            }
            0x0104 => payload.extend([6, 0x82, 0x01, 0x07, 0x80, 0x04]),
            0x0107 => payload.extend([4, 0x86, 0x82, 0x10]),
            _ => {}
        }
        self.coming.extend(packet(bytes[2], &payload));
        if command == 0x0109 && self.changes && !refused {
            self.baud = u32::from_be_bytes([bytes[8], bytes[9], bytes[10], bytes[11]]);
        }
        Ok(())
    }

    fn now_ms(&mut self) -> u32 {
        self.now
    }

    fn set_baud(&mut self, rate: u32) -> Result<bool, Self::Error> {
        if rate > self.fastest || self.rate == 0 {
            return Ok(false);
        }
        self.tried.push(rate);
        self.rate = rate;
        self.coming.clear();
        Ok(true)
    }

    fn baud(&self) -> Option<u32> {
        Some(self.rate).filter(|rate| *rate != 0)
    }
}

#[test]
fn connects_at_any_rate() {
    for &rate in BAUD_RATES {
        let mut device = device(rate);
        assert_eq!(device.connect(BAUD_RATES), Ok(Some(rate)));
        let port = device.port();
        assert_eq!(port.tried.last(), Some(&rate));
        assert_eq!(port.commands().last(), Some(&0x0102));
        assert_eq!(device.next_packet(0), Ok(None)); // nothing is left of the search
    }
}

#[test]
fn a_device_that_only_sends_data_is_found() {
    let mut found = device(460_800);
    (found.port_mut().data, found.port_mut().lose) = (1000, 1);
    assert_eq!(found.connect(BAUD_RATES), Ok(Some(460_800)));
    assert_eq!(found.port().commands().iter().filter(|c| **c == 0x0102).count(), 1);
}

#[test]
fn answers_that_are_lost_are_asked_for_again() {
    for lose_of in [0x0101, 0x0102] {
        let mut device = device(115_200);
        (device.port_mut().lose, device.port_mut().lose_of) = (1, lose_of);
        assert_eq!(device.connect(BAUD_RATES), Ok(Some(115_200)), "{lose_of:#x}");
    }
    for (lose_of, stream) in [(0x0C0E, 5), (0x0C0F, 5), (0x0C11, 5), (0x0106, 5)] {
        let mut device = device(115_200);
        (device.port_mut().lose, device.port_mut().lose_of) = (2, lose_of);
        assert_eq!(device.stream(sensor::SET, &[Rate::of::<sensor::ScaledAccel>(100.0)]), Ok(1000));
        assert_eq!(device.port().sent.len(), stream + 1);
    }
}

fn failed<E>(command: &'static str, reason: Reason) -> DeviceError<E> {
    CommandError::new(command, reason).into()
}

#[test]
fn nobody_is_there() {
    let nobody = Err(failed("base.ping", Reason::TimedOut));
    let mut none = device(1234);
    assert_eq!(none.connect(BAUD_RATES), nobody);
    assert_eq!(none.port().tried, BAUD_RATES);
    assert_eq!(none.port().sent.len(), 2 * BAUD_RATES.len());

    let mut silent = at_rate(0, 115_200); // a port without rates
    assert_eq!(silent.connect(BAUD_RATES), Err(failed("base.set_idle", Reason::TimedOut)));
    assert_eq!(silent.port().commands(), [0x0102; 3]);

    let mut slow = at_rate(0, 0);
    assert_eq!(slow.connect(BAUD_RATES), Ok(None));
}

#[test]
fn rates_that_a_port_lacks_are_passed_over() {
    let mut device = device(9600);
    device.port_mut().fastest = 115_200;
    assert_eq!(device.connect(BAUD_RATES), Ok(Some(9600)));
    assert_eq!(device.port().tried, [115_200, 57_600, 38_400, 19_200, 9600]);
}

fn rates() -> [Rate; 3] {
    [
        Rate::of::<shared::GpsTimestamp>(100.0),
        Rate::fastest::<sensor::ScaledAccel>(),
        Rate::of_descriptor(5, 1000.0 / 3.0),
    ]
}

#[test]
fn streams() {
    let mut device = device(115_200);
    assert_eq!(device.stream(sensor::SET, &rates()), Ok(1000));
    let port = device.port();
    assert_eq!(port.commands(), [0x0C0E, 0x0C0F, 0x0C11, 0x0106]);
    assert_eq!(port.last(0x0C0F), [1, 0x80, 3, 0xD3, 0, 10, 4, 0, 1, 5, 0, 3]);
    assert_eq!(port.last(0x0C11), [1, 0x80, 1]);
}

#[test]
fn a_stream_gets_the_first_timestamp_that_the_device_accepts() {
    let rates = [Rate::of::<sensor::ScaledGyro>(124.99), Rate::of::<sensor::ScaledAccel>(333.33)];
    let started = |begin, older, timed| {
        let mut device = device(115_200);
        (device.port_mut().begin, device.port_mut().older) = (begin, older);
        let done = if timed {
            device.stream(sensor::SET, &rates)
        } else {
            device.stream_only(sensor::SET, &rates)
        };
        assert_eq!(done, Ok(1000));
        let format = if older { 0x0C08 } else { 0x0C0F };
        let tried = device.port().commands().iter().filter(|x| **x == format).count();
        (tried, device.port().last(format).to_vec())
    };
    for (i, stamp) in [0xD5, 0xD7, 0x12, 0xD3].into_iter().enumerate() {
        let sent = vec![1, 0x80, 3, stamp, 0, 3, 5, 0, 8, 4, 0, 3];
        assert_eq!(started(stamp, false, true), (i + 1, sent));
        let sent = vec![1, 3, stamp, 0, 3, 5, 0, 8, 4, 0, 3];
        assert_eq!(started(stamp, true, true), (i + 1, sent));
    }
    let none = vec![1, 0x80, 2, 5, 0, 8, 4, 0, 3];
    assert_eq!(started(5, false, true), (5, none.clone()));
    assert_eq!(started(0, false, false), (1, none));
}

#[test]
fn streams_of_older_devices() {
    let sets = [(sensor::SET, 0x0C06, 0x0C08, 1), (filter_data::SET, 0x0C0B, 0x0C0A, 3)];
    for (set, base, format, stream) in sets {
        let mut device = device(115_200);
        device.port_mut().older = true;
        assert_eq!(device.stream(set, &[Rate::of::<shared::GpsTimestamp>(100.0)]), Ok(1000));
        let port = device.port();
        assert_eq!(port.commands(), [0x0C0E, base, format, 0x0C11, 0x0106]);
        assert_eq!(port.last(format), [1, 1, 0xD3, 0, 10]);
        assert_eq!(port.last(0x0C11), [1, stream, 1]);
    }
    // It does not have the set at all.
    let refused = |device: &mut Device<Fake>, set| {
        let error = failed("3dm.get_base_rate", Reason::Refused(AckCode(1)));
        assert_eq!(device.stream(set, &[]), Err(error.into()));
    };
    let mut device = device(115_200);
    (device.port_mut().older, device.port_mut().refuse) = (true, 0x0C0B);
    refused(&mut device, filter_data::SET);
    refused(&mut device, DescriptorSet(0x91));
    assert_eq!(device.port().commands(), [0x0C0E, 0x0C0B, 0x0C0E]);
}

#[test]
fn the_rejected_field_is_in_neither_of_its_lists() {
    let command = mip_3dm::MessageFormat::write(0x82, [(0x10, 1).into(), (0x01, 1).into()]);
    let mut rejected = device(115_200);
    let found = rejected.rejected(&command).unwrap().unwrap();
    assert_eq!((found.index, found.set.0, found.descriptor), (1, 0x82, 0x01));
    assert_eq!(found.to_string(), "3DM-CV7-AHRS does not send filter_data.llh_position");
    assert_eq!(rejected.port().commands(), [0x0103, 0x0104, 0x0107]);
    assert_eq!(rejected.rejected(&base::Ping::new()), Ok(None));
    // Without all answers, no list is known.
    for lost in [0x0107, 0] {
        (rejected.port_mut().lose, rejected.port_mut().lose_of) = (9, lost);
        let index = rejected.rejected(&command).unwrap().map(|found| found.index);
        assert_ne!(index, Some(0), "{lost:#X}"); // nothing shows that the first is absent
    }
}

#[test]
fn a_device_that_was_asked_what_it_is_has_its_own_times() {
    let mut device = device(115_200);
    device.port_mut().model = ["3DM-GX5-25", "6253-4220"];
    let clocks = |device: &mut Device<Fake>| {
        let mut stamp = vec![14, 0x12];
        stamp.extend(12.5_f64.to_be_bytes());
        stamp.extend([8, 252, 0, 0x18]); // a date, but on models of its generation
        device.port_mut().coming.extend(packet(0x80, &stamp));
        let mut found = device.fields::<sensor::GpsTimestamp>(10);
        found.next().unwrap().unwrap().0.map(|time| time.clock.name())
    };
    assert_eq!(clocks(&mut device), Some("gps"));
    assert_eq!(device.profile().unwrap().map(|profile| profile.id), Some("3dm-gx5-25"));
    assert_eq!(clocks(&mut device), Some("device"));
    // The serial number is not asked if there is a model number, even of a model that is not known.
    device.port_mut().model[1] = "6299-0000       6253-4220";
    assert_eq!(device.profile(), Ok(None));
    device.port_mut().model[1] = "                6253-4220";
    assert_eq!(device.profile().unwrap().map(|profile| profile.id), Some("3dm-gx5-25"));
    assert_eq!(device.connect(BAUD_RATES), Ok(Some(115_200))); // perhaps to another one
    assert_eq!(clocks(&mut device), Some("gps"));
}

#[test]
fn a_rate_that_the_device_lacks_changes_nothing() {
    let least = 1000.0 / 65535.0;
    let wrong = [
        (70.0, 1000.0 / 14.0),
        (2000.0, 1000.0),
        (-1.0, least),
        (0.0, least),
        (f32::NAN, 1000.0),
        (66.674, 1000.0 / 15.0),
        (f32::MAX, 1000.0),
    ];
    for (hz, next) in wrong {
        let mut device = device(115_200);
        let asked = [Rate::of::<sensor::ScaledGyro>(10.0), Rate::of::<sensor::ScaledAccel>(hz)];
        let error = device.stream(sensor::SET, &asked).unwrap_err();
        let StreamError::NoSuchRate { descriptor, nearest, base, .. } = error else {
            panic!("{error}")
        };
        assert_eq!((descriptor, nearest, base), (4, next, 1000));
        assert_eq!(device.port().commands(), [0x0C0E]);
        if hz == 0.0 {
            assert!(error.to_string().ends_with(" 0 Hz: for the highest rate, use Rate::fastest"));
        }
        if hz == 70.0 {
            let said =
                "sensor.scaled_accel at 70 Hz: not a rate of the device; nearest: 71.42857 Hz, \
                        as it divides 1000 Hz by whole numbers";
            assert_eq!(error.to_string(), said);
            assert_eq!(
                device.stream(sensor::SET, &[Rate::of::<sensor::ScaledAccel>(nearest)]),
                Ok(1000)
            );
        }
    }
}

#[test]
fn data_of_the_earlier_format_is_discarded() {
    let mut device = device(115_200);
    for set in [0x80, 0x82, 0x80] {
        device.port_mut().coming.extend(packet(set, &[3, 0x7F, 1]));
    }
    device.stream(sensor::SET, &[Rate::of::<sensor::ScaledAccel>(10.0)]).unwrap();
    assert_eq!(device.next_packet(10).unwrap().map(|packet| packet.set().0), Some(0x82));
    assert!(device.next_packet(10).unwrap().is_none());
}

#[test]
fn a_response_becomes_the_command_that_writes_it() {
    let trigger = mip_3dm::EventTriggerConfigResponse {
        instance: 3,
        parameters: mip_3dm::EventTriggerConfigParameters::Gpio(Default::default()),
        ..Default::default()
    };
    let command = WriteCall::from(trigger.clone());
    assert_eq!(command, mip_3dm::EventTriggerConfig::write(3, trigger.parameters));
    let disabled = mip_3dm::GnssAssistedFixResponse::default();
    let option = disabled.option; // a reserved value follows
    assert_eq!(WriteCall::from(disabled), mip_3dm::GnssAssistedFix::write(option));
}

#[test]
fn decimations_are_the_nearest() {
    for base in [1_u16, 10, 500, 1000] {
        for wanted in [0.001_f32, 0.02, 0.9, 1.0, 3.0, 7.0, 70.0, 99.5, 300.0, 499.0, 900.0, 5000.0]
        {
            let mut device = device(115_200);
            device.port_mut().base_rate = base;
            let got = match device.stream_only(sensor::SET, &[Rate::of_descriptor(4, wanted)]) {
                Err(StreamError::NoSuchRate { nearest, .. }) => nearest,
                done => done.map(|_| wanted).unwrap(),
            };
            let distance = |by: u16| (f32::from(base) / f32::from(by) - wanted).abs();
            let best = (1..=u16::MAX).map(distance).fold(f32::INFINITY, f32::min);
            assert_eq!((got - wanted).abs(), best, "{base} {wanted}");
        }
    }
}

#[test]
fn each_rate_of_the_device_has_its_decimation() {
    for base in [1_u16, 7, 1000, 0x8001, 0xFFFF] {
        for by in [1_u16, 2, 3, 7, 127, 128, 129, 999, 0x7FFF, 0x8000, 0xFFFE, 0xFFFF] {
            let mut device = device(115_200);
            device.port_mut().base_rate = base;
            let rate = Rate::of_descriptor(4, f32::from(base) / f32::from(by));
            assert_eq!(device.stream_only(sensor::SET, &[rate]), Ok(base), "{base} by {by}");
            let [high, low] = by.to_be_bytes();
            assert_eq!(device.port().last(0x0C0F), [1, 0x80, 1, 4, high, low]);
        }
    }
}

#[test]
fn data_that_is_sent_as_it_arrives_has_no_rate() {
    let mut device = device(115_200);
    device.port_mut().base_rate = 0;
    assert_eq!(device.stream(sensor::SET, &[Rate::of::<sensor::ScaledAccel>(5.0)]), Ok(0));
    assert_eq!(device.port().last(0x0C0F), [1, 0x80, 2, 0xD5, 0, 1, 4, 0, 1]);
}

#[test]
fn fields_of_other_sets_and_too_many() {
    let mut device = device(115_200);
    let error =
        device.stream(sensor::SET, &[Rate::of::<filter_data::EulerAngles>(10.0)]).unwrap_err();
    assert!(error.to_string().contains("filter_data.euler_angles"), "{error}");
    assert!(device.port().sent.is_empty());
    let many = [Rate::of_descriptor(4, 10.0); 84];
    let error = device.stream(sensor::SET, &many).unwrap_err();
    assert!(matches!(error, StreamError::Device(DeviceError::Request(RequestError::Encode(_)))));
    assert_eq!(device.port().commands(), [0x0C0E]);
}

#[test]
fn the_baud_rate_changes() {
    let mut device = device(115_200);
    assert_eq!(device.change_baud(&base::CommSpeed::write(1, 921_600)), Ok(921_600));
    assert_eq!((device.port().rate, device.port().baud), (921_600, 921_600));
    // The command was for another port of the device.
    device.port_mut().changes = false;
    assert_eq!(device.change_baud(&base::CommSpeed::write(2, 9600)), Ok(921_600));
    assert_eq!(device.port().rate, 921_600);
    device.port_mut().refuse = 0x0109;
    let refused = failed("base.comm_speed", Reason::Refused(AckCode(1)));
    assert_eq!(device.change_baud(&base::CommSpeed::write(1, 9600)), Err(refused));
    assert_eq!(device.port().rate, 921_600);
    device.port_mut().baud = 7;
    let gone = failed("base.ping", Reason::TimedOut);
    assert_eq!(device.change_baud(&mip_3dm::UartBaudRate::write(9600)), Err(gone));
    assert_eq!(device.port().rate, 921_600); // that of before

    let none = at_rate(0, 0).change_baud(&base::CommSpeed::write(1, 9600));
    assert_eq!(none, Err(DeviceError::NoBaudRate));
}
