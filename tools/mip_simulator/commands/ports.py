"""The ports of a device: their baud rates, and the protocols that they receive and send."""

from __future__ import annotations

from typing import Any

from mip_tools.binding import Port
from mip_tools.devices.codes import COMMAND_FAILED, INVALID_PARAMETER, Refused
from mip_tools.devices.facts import COMMANDS
from mip_tools.devices.settings import arguments, asking

from ..link import Link
from ..state import DeviceState

#: Protocols, as bits of the protocols of a port.
PROTOCOLS = {"MIP": 1, "NMEA": 1 << 8, "RTCM": 1 << 9, "SPARTN": 1 << 24}
MIP, NMEA, RTCM = PROTOCOLS["MIP"], PROTOCOLS["NMEA"], PROTOCOLS["RTCM"]

#: Protocol -> the maximum number of ports, besides the main one, that may receive it.
PARSERS = {
    "MIP": "mip_input_ports",
    "NMEA": "nmea_input_ports",
    "RTCM": "rtcm_input_ports",
    "SPARTN": "spartn_input_ports",
}


def is_main(device: DeviceState, name: str) -> bool:
    """Is this a main port, the first of its kind, such as UART 1?"""
    kinds = [port.name.split()[0] for port in device.ports if port.name != name]
    before = [port.name for port in device.ports]
    first = before.index(name) if name in before else 0
    return name.split()[0] not in kinds[:first]


def port_protocols(device: DeviceState, port: Port) -> tuple[int, int]:
    """Returns the protocols that a port receives and sends; if no command sets them, all protocols of the port."""
    takes, gives = (sum(PROTOCOLS.get(name, 0) for name in names) or MIP for names in (port.receives, port.sends))
    for setting in device.settings_of("protocols"):
        if setting["port"] == port.id:
            return setting["incoming"], setting["outgoing"]
    if is_main(device, port.name) or not device.has_effect("protocols"):
        return takes, gives
    return 0, 0


def by_number(device: DeviceState, number: int) -> Port | None:
    """Finds a port by its number, or the only port, whose number is not known."""
    return next((p for p in device.ports if p.id == number or (p.id is None and not device.profile.ports)), None)


def check_protocols(device: DeviceState, values: dict[str, Any], link: Link | None) -> None:
    """Raises Refused if a port cannot have these protocols."""
    port = by_number(device, values["port"])
    if link is not None and not is_main(device, link.port):
        raise Refused(COMMAND_FAILED)
    if port is None:
        raise Refused(INVALID_PARAMETER)
    for way, names in (("incoming", port.receives), ("outgoing", port.sends)):
        if values[way] & ~sum(PROTOCOLS.get(name, 0) for name in names):
            raise Refused(INVALID_PARAMETER)
    if is_main(device, port.name) and not values["incoming"] & values["outgoing"] & MIP:
        raise Refused(COMMAND_FAILED)
    for name, limit in PARSERS.items():
        others = [p for p in device.ports if p is not port and not is_main(device, p.name)]
        taken = sum(bool(port_protocols(device, p)[0] & PROTOCOLS[name]) for p in others)
        most = device.profile.limits.get(limit)
        wants = values["incoming"] & PROTOCOLS[name] and not is_main(device, port.name)
        if wants and most is not None and taken >= most.value:
            raise Refused(COMMAND_FAILED)


def with_baud_rates(device: DeviceState, number: int | None) -> Port | None:
    """Finds a port by its number; without a number, the first port with baud rates."""
    if number is not None:
        return by_number(device, number)
    return next((port for port in device.ports if port.baud_rates), None)


def baud_rates(device: DeviceState) -> dict[str, int]:
    """Name of a port -> its baud rate, for ports that have one."""
    rates: dict[str, int] = {}
    for name, behavior in COMMANDS.items():
        if behavior.effect != "baud_rate" or not device.knows(name):
            continue
        first_port = with_baud_rates(device, None)
        for port in device.ports if "port" in behavior.arguments else (first_port,):
            if port is not None and port.baud_rates and (port.id is not None or "port" not in behavior.arguments):
                asked = asking(name, () if port.id is None else (port.id,))
                rates[port.name] = arguments(device.settings.current(asked))["baud"]
    return rates


def arrange(device: DeviceState) -> None:
    """Applies the settings of the ports to their links."""
    by_port = {port.name: port_protocols(device, port) for port in device.ports}
    bauds = baud_rates(device)
    for link in device.links:
        link.takes, link.gives = by_port.get(link.port, (MIP, MIP | NMEA))
        link.baud = bauds.get(link.port)
