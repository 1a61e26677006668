"""Uses a device with MSCL, the vendor's library, and prints what happened as one line of JSON.

usage: mscl_client.py HOST:PORT|PATH
"""

import json
import sys
import time

import mscl

#: Settings that MSCL reads, each where it knows that the model has it.
READS = (
    "getUARTBaudRate", "getSensorToVehicleTransform_eulerAngles", "getSensorToVehicleRotation_eulerAngles",
    "getGNSSAssistedFixControl", "getPitchRollAid", "getHeadingUpdateControl", "getAutoInitialization",
    "getAltitudeAid", "getEstimationControlFlags", "getAccelerometerBias", "getGyroBias", "getVehicleDynamicsMode",
    "getDeclinationSource", "getInclinationSource", "getGravityErrorAdaptiveMeasurement",
    "getMagnetometerErrorAdaptiveMeasurement", "getMagDipAngleErrorAdaptiveMeasurement", "getConingAndScullingEnable",
    "getConstellationSettings", "getSBASSettings", "getComplementaryFilterSettings", "getAntennaOffset",
    "getEnableDisableMeasurements", "getEventTriggerStatus", "getEventActionStatus", "getBasicDeviceStatus",
    "getDiagnosticDeviceStatus",
)  # fmt: skip

#: A rate that every device has for the sets that it samples, in Hz.
RATE = 2


def connect(place):
    host, colon, port = place.rpartition(":")
    return mscl.Connection.TcpIp(host, int(port)) if colon else mscl.Connection.Serial(place, 115200)


def reads(node):
    """The values that were read, or why not: rejected by MSCL itself, or failed."""
    found = {}
    for name in READS:
        try:
            getattr(node, name)()
            found[name] = "read"
        except (RuntimeError, mscl.Error) as error:
            found[name] = "not supported" if "not supported" in str(error) else str(error)
    return found


def stream(node):
    """Requests some fields of each class that has a rate; returns how many were set, and how many MSCL reports."""
    features, found = node.features(), {}
    for name in (n for n in dir(mscl.MipTypes) if n.startswith("CLASS_")):
        kind = getattr(mscl.MipTypes, name)
        if not features.supportsCategory(kind) or not features.supportedSampleRates(kind):
            continue
        channels = mscl.MipChannels()
        for field in list(features.supportedChannelFields(kind))[:6]:
            channels.append(mscl.MipChannel(field, mscl.SampleRate.Hertz(1 if "GNSS" in name else RATE)))
        node.setActiveChannelFields(kind, channels)
        node.enableDataStream(kind)
        found[name] = [kind, len(channels), len(node.getActiveChannelFields(kind))]
    return found


def data(node, seconds):
    """Packets and points by descriptor set."""
    found, end = {}, time.monotonic() + seconds
    while time.monotonic() < end:
        for packet in node.getDataPackets(100):
            count = found.setdefault(packet.descriptorSet(), [0, 0])
            count[0] += 1
            count[1] += sum(1 for point in packet.data() if point.as_string() != "")
    return found


def main():
    node = mscl.InertialNode(connect(sys.argv[1]))
    found = {"ping": node.ping()}
    node.setToIdle()
    found["model"] = node.modelNumber()
    found["name"] = node.modelName()
    found["reads"] = reads(node)
    found["classes"] = stream(node)
    node.resume()
    found["data"] = data(node, 3)
    found["reads again"] = reads(node)  # while data arrive
    node.setToIdle()
    print(json.dumps(found))


main()
