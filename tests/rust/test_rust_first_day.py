"""The first minutes with a device in Rust: the module session, the ports of a computer, and the README's program."""

from __future__ import annotations

import json
import os
import re
import subprocess
from pathlib import Path

import pytest
from crates import WORK, cargo_lock, passes, rendered, write
from mip_protocol import base, open_port
from mipgen.targets.rust import session
from support import PATIENCE, heavy, locked, model, simulated
from test_rust import HERE
from test_rust_examples import EXAMPLES, FEATURES, SETS, crate, programs, ran
from virtual import test_datagrams as datagrams
from virtual import test_reopen as reopen

CV7, GX5 = "3dm-cv7-gnss-ins", "3dm-gx5-15"
#: A line of the example.
LINE = re.compile(r" +-?0\.0\d{3} +-?0\.0\d{3} +-(?:0\.9|1\.0)\d{3} g")


#: Programs whose devices block, and are awaited.
DEVICES = {
    "blocking": "use mip_protocol::device::Device;\n",
    "awaited": f'#[path = "{HERE / "awaited.rs"}"]\nmod awaited;\nuse awaited::Device;\n'
    f'#[path = "{HERE / "awaited_session.rs"}"]\nmod awaited_session;\n',
}


@heavy("the Rust crate in many more builds")
def test_connect_and_stream_at_a_scripted_port() -> None:
    """With few sets: building the crate with all of them takes longer than everything else."""
    features = '"base", "mip_3dm", "sensor", "filter_data", "shared", "std", "devices", "registry", '
    features += '"embedded-io-async-07"'
    manifest = f"""[package]
name = "first-day"
version = "0.0.0"
edition = "2021"

[dependencies]
mip-protocol = {{ path = "{crate()}", default-features = false, features = [{features}] }}
embedded-io-async = "0.7"

[workspace]
"""
    files = {"Cargo.toml": manifest.encode(), "Cargo.lock": cargo_lock(), "src/lib.rs": b""}
    for name, device in DEVICES.items():
        module = f'#[path = "{HERE / "first_day.rs"}"]\nmod first_day;\n'
        files[f"tests/{name}.rs"] = f"{device}{module}".encode()
    folder = WORK / "real/first-day"
    with locked(WORK / "real-first-day"):
        write(files, folder)
    out = passes(folder, "test", "--quiet")
    first, second = (n for n in re.findall(r"test result: ok. (\d+) passed", out) if n != "0")
    assert first == second and int(first) > 12


def test_a_part_without_these_commands_has_no_such_module() -> None:
    assert session.compose(model("invented")) is None
    assert "src/sets/session.rs" not in rendered("invented")
    assert b"session" not in rendered("invented")["src/sets.rs"]
    assert "src/sets/session.rs" in rendered("real")


def good(result: tuple[int, str, str], name: str = "3DM-CV7-GNSS/INS") -> None:
    """The program runs until the device is gone, which is an error of the port."""
    code, out, error = result
    head, *lines = out.splitlines()
    assert head == name and code == 1
    assert re.fullmatch(r"stream: port: [^{}]+\n", error), error
    assert 50 < len(lines) < 310 and all(LINE.fullmatch(line) for line in lines), lines[:3]


@heavy(EXAMPLES)
@pytest.mark.parametrize(("device", "name"), [(CV7, "3DM-CV7-GNSS/INS"), (GX5, "3DM-GX5-15")])
def test_devices_of_two_generations(device: str, name: str, tmp_path: object) -> None:
    """The one of the fifth generation has other commands for this."""
    path = f"{tmp_path}/terminal"
    programs()  # before the device starts, which ends by itself
    with simulated("--tcp", "0", "--duration", "2", device=device) as place:
        good(ran("stream", f"tcp:{place}"), name)
    with simulated("--pty", path, "--duration", "2", device=device):
        good(ran("stream", path), name)
    for way in (["--tcp", "0"], ["--pty", path]):
        with simulated(*way, "--duration", "2", device=device) as place:
            code, out, error = ran("two_tasks", path if way[0] == "--pty" else place)
        assert code == 1 and re.fullmatch(r"two_tasks: (the port is closed|port: [^{}]+)\n", error), error
        lines = out.splitlines()
        data = [line for line in lines if LINE.fullmatch(line)]
        assert len(data) > 50 and [line for line in lines if line not in data] == [name]


@heavy(EXAMPLES)
def test_faults(tmp_path: object) -> None:
    path = f"{tmp_path}/terminal"
    programs()
    for fault in ("lose_answer@1", "lose_answer@2", "lose_answer@5", "nmea=0.2,noise=0.05"):
        with simulated("--pty", path, "--duration", "3", "--fault", fault):
            good(ran("stream", f"serial:{path}"))
    with simulated("--pty", path, "--fault", "refuse@5"):
        assert "rejected the command: bad checksum (2)" in ran("stream", f"serial:{path}")[2]
    with simulated("--pty", path, "--fault", "lose_answer=1"):
        assert "no device answers at 115200, 3000000, " in ran("stream", f"serial:{path}")[2]


@heavy(EXAMPLES)
def test_the_baud_rate_is_found(tmp_path: object) -> None:
    """Another program has changed the rate; a rate that is given is tried first."""
    path = f"{tmp_path}/terminal"
    programs()
    with simulated("--port", f"UART 1=pty:{path}", "--strict-baud", "--duration", "6"):
        with open_port(path) as device:
            device.request(base.SetIdle())
            assert device.change_baud(base.CommSpeed.write(0x11, 460800)) == 460800
        code, out, _ = ran("stream", f"serial:{path}:460800")
        assert code == 1 and out.startswith("3DM-CV7-GNSS/INS\n") and len(out.splitlines()) > 100


@heavy(EXAMPLES)
def test_places_that_cannot_be_opened(tmp_path: object) -> None:
    for place, said in {
        f"serial:{tmp_path}/none": f"serial:{tmp_path}/none: No such file or directory",
        "tcp:127.0.0.1:1": "tcp:127.0.0.1:1: Connection refused",
        "tcp:no.such.host.invalid:1": "tcp:no.such.host.invalid:1: failed to lookup",
        f"file:{tmp_path}/none": f"file:{tmp_path}/none: No such file or directory",
        f"{tmp_path}/none:115200": f"{tmp_path}/none:115200: No such file or directory",
        "127.0.0.1:1": "127.0.0.1:1: Connection refused",
        "com-1.invalid:1": "com-1.invalid:1: failed to lookup",
    }.items():
        code, out, error = ran("stream", place)
        assert (code, out) == (1, "") and said in error, error


def built(name: str, text: str) -> Path:
    """A program that is not among the examples."""
    example = crate() / f"examples/{name}.rs"
    folder = programs()
    example.write_text(text)
    try:
        features = ("--no-default-features", "--features", f"{FEATURES},{SETS}")
        passes(crate(), "build", "--quiet", "--locked", "--example", name, *features)
    finally:
        example.unlink()
    return folder / name


#: Prints what is in a log, and shows that a log accepts no commands.
LOG = """
use mip_protocol::{base::Ping, session::Rate, DescriptorSet};
fn main() {
    let place = std::env::args().nth(1).unwrap();
    let mut device = mip_protocol::open(&place).unwrap();
    let mut count = 0;
    while device.next_packet(60_000).unwrap().is_some() {
        count += 1;
    }
    println!("{count} {}", device.parser().skipped());
    println!("{}", device.request(&Ping::new()).unwrap_err());
    println!("{}", device.stream(DescriptorSet(0x80), &[Rate::of_descriptor(4, 1.0)]).unwrap_err());
}
"""


@heavy(EXAMPLES)
def test_a_log(tmp_path: object) -> None:
    """Even with an incomplete packet at the end, and a packet behind it; nothing is waited for."""
    from test_rust_examples import ACCEL
    from test_rust_examples import LOG as log

    example = built("read_log", LOG)
    path = f"{tmp_path}/log.bin"
    with open(path, "wb") as file:
        file.write(log * 3 + bytes.fromhex("756580ff") + ACCEL)
    done = subprocess.run([example, path], capture_output=True, text=True, timeout=PATIENCE)
    assert done.stdout.splitlines() == ["4 46", *["port: a log accepts no commands"] * 2], done.stdout + done.stderr


@heavy(EXAMPLES)
@pytest.mark.parametrize("way", DEVICES)
def test_a_port_is_opened_again(way: str, tmp_path: Path) -> None:
    """A terminal, a hundred times during a stream."""
    example = built("pulled", (reopen.HERE / "pulled.rs").read_text())
    with reopen.pulled(tmp_path, [f"pty:{tmp_path}/port"]) as (place,):
        command = [example, way, f"serial:{place}", str(reopen.PULLS)]
        done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)
    assert done.returncode == 0, done.stderr
    reopen.checked(json.loads(done.stdout))


@heavy(EXAMPLES)
def test_replies_over_udp_stay_those_of_their_commands(tmp_path: Path) -> None:
    program = built("pairs", (datagrams.HERE / "pairs.rs").read_text())
    datagrams.check(tmp_path, {way: [str(program), way] for way in DEVICES}, 500)


#: Shows as which model the times of a device are read, before and after it has started its data.
MODEL = """
use mip_protocol::{sensor::{self, ScaledAccel}, session::Rate};
#[tokio::main]
async fn main() {
    let place = std::env::args().nth(1).unwrap();
    let rates = [Rate::of::<ScaledAccel>(100.0)];
    let mut device = mip_protocol::open(&place).unwrap();
    println!("{:?}", device.fields::<ScaledAccel>(0));
    device.stream(sensor::SET, &rates).unwrap();
    println!("{:?}", device.fields::<ScaledAccel>(0));
    drop(device);
    let mut device = mip_protocol::open_async(&place).await.unwrap();
    device.stream(sensor::SET, &rates).await.unwrap();
    println!("{:?}", device.fields::<ScaledAccel>(0));
    println!("{:?}", device.split().1.fields::<ScaledAccel>(0));
}
"""


@heavy(EXAMPLES)
def test_times_are_those_of_the_model_that_a_stream_asks_for(tmp_path: Path) -> None:
    program = built("model", MODEL)
    with simulated("--pty", f"{tmp_path}/port", device=GX5):
        done = subprocess.run([program, f"{tmp_path}/port"], capture_output=True, text=True, timeout=PATIENCE)
    found = re.findall(r"Times { device: (.*?),", done.stdout)
    assert found == ["None", *[f'Some("{GX5}")'] * 3], done.stdout + done.stderr


#: One port is lost and cannot be opened again, one is opened at the second attempt, one writes what a
#: program passes; ports of each kind copy what they receive.
PORTS = """
use mip_protocol::base::Ping;
use mip_protocol::device::{AsyncLine, Device, DeviceError, Line, Port, TokioDevice};
use std::{fs, io::{Read, Write}, net::TcpListener, time::Duration};
const PING: &[u8] = b"noise\\x75\\x65\\x01\\x02\\x02\\x01\\xE0\\xC6";

fn listening() -> (TcpListener, String) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let place = listener.local_addr().unwrap().to_string();
    (listener, place)
}

async fn lost() {
    let (listener, place) = listening();
    let mut device = TokioDevice::at(AsyncLine::open(&place).await.unwrap());
    drop(listener);
    let error = device.reopen(Duration::ZERO).await.unwrap_err();
    assert!(matches!(error, DeviceError::Port(_)), "{error}");
    let error = device.request(&Ping::new()).await.unwrap_err();
    assert!(matches!(error, DeviceError::Closed), "{error}");
}

fn retried(path: &str) {
    let wait = || {
        println!();
        std::io::stdin().read_line(&mut String::new()).unwrap();
    };
    let mut line = Line::open(&format!("serial:{path}")).unwrap();
    assert!(line.set_baud(230_400).unwrap());
    wait(); // until it is unplugged
    line.reopen(Duration::ZERO).unwrap_err();
    wait(); // until it is back
    line.reopen(Duration::ZERO).unwrap();
    assert_eq!(line.baud(), Some(230_400)); // as before
}

async fn recorded(path: &str) {
    for way in 0..3 {
        let (listener, place) = listening();
        std::thread::spawn(move || listener.accept().unwrap().0.write_all(PING).unwrap());
        let file = fs::File::create(path).unwrap();
        if way == 0 {
            let mut device = Device::new(Line::open(&place).unwrap());
            device.port_mut().record(file);
            assert!(device.next_packet(10_000).unwrap().is_some());
        } else {
            let mut device = TokioDevice::at(AsyncLine::open(&place).await.unwrap());
            device.port_mut().record(file);
            if way == 1 {
                assert!(device.next_packet(10_000).await.unwrap().is_some());
            } else {
                assert!(device.split().1.next_packet(10_000).await.unwrap().is_some());
            }
        }
        assert_eq!(fs::read(path).unwrap(), PING);
    }
}

async fn written() {
    let (listener, place) = listening();
    let device = TokioDevice::at(AsyncLine::open(&place).await.unwrap());
    device.split().0.write(PING).await.unwrap();
    let mut bytes = [0; PING.len()];
    listener.accept().unwrap().0.read_exact(&mut bytes).unwrap();
    assert_eq!(bytes, PING);
}

#[tokio::main]
async fn main() {
    let words: Vec<String> = std::env::args().collect();
    match &*words[1] {
        "lost" => lost().await,
        "retried" => retried(&words[2]),
        "written" => written().await,
        _ => recorded(&words[2]).await,
    }
}
"""


@heavy(EXAMPLES)
def test_ports_of_programs(tmp_path: Path) -> None:
    program, port = built("ports", PORTS), tmp_path / "port"
    for words in (["lost"], ["written"], ["recorded", tmp_path / "log.bin"]):
        subprocess.run([program, *words], check=True, timeout=PATIENCE)
    plugged = os.openpty()
    port.symlink_to(os.ttyname(plugged[1]))
    with subprocess.Popen([program, "retried", port], stdin=-1, stdout=-1, text=True) as process:
        assert process.stdin and process.stdout and process.stdout.readline()
        for end in plugged:
            os.close(end)
        port.unlink()
        print(file=process.stdin, flush=True)
        process.stdout.readline()
        port.symlink_to(os.ttyname(os.openpty()[1]))
        process.communicate("\n", timeout=PATIENCE)
    assert process.returncode == 0
