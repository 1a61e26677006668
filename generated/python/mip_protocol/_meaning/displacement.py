"""The meaning of the types of `displacement`."""

from __future__ import annotations

from .. import displacement, protocol
from ..info import FieldInfo, Info
from ..parameter import Parameter

# fmt: off

#: Class -> its description.
TYPES: dict[str, Info] = {
    "GetCalibration": FieldInfo(
        "displacement.get_calibration", displacement.GetCalibration, likely=("demod-dc",), parameters=(
        )),
    "OutputRate": FieldInfo(
        "displacement.output_rate", displacement.OutputRate, functions=("read",), likely=("demod-dc",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
        )),
    "DeviceTime": FieldInfo(
        "displacement.device_time", displacement.DeviceTime, functions=("write",), likely=("demod-dc",), parameters=(
            Parameter("function", "function", "scalar", scalar="u8", type=protocol.FunctionSelector),
            Parameter("time", "time", "scalar", scalar="u64", units=("ns",), required=("write",)),
        )),
    "GetCalibrationResponse": FieldInfo(
        "displacement.get_calibration_response", displacement.GetCalibrationResponse, likely=("demod-dc",), parameters=(
            Parameter("slope", "slope", "scalar", scalar="float"),
            Parameter("offset", "offset", "scalar", scalar="float"),
        )),
    "OutputRateResponse": FieldInfo(
        "displacement.output_rate_response", displacement.OutputRateResponse, likely=("demod-dc",), parameters=(
            Parameter("rate", "rate", "scalar", scalar="u32", units=("Hz",)),
        )),
}
