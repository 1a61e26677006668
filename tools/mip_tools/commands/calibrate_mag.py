"""`mip calibrate-mag`: hard and soft iron of a magnetometer, from measurements in all directions."""

from __future__ import annotations

import argparse
import sys
import time
from typing import TYPE_CHECKING, Any

from ..binding import DEVICES, MipError, NoAnswer, Refused
from ..devices import views
from ..devices.facts import COMMANDS
from ..devices.known import KnownDevice
from ..devices.settings import asking
from ..errors import Failure, Misuse
from ..files import outputs, signals
from ..formats import plot
from ..logs import inputs
from ..names.selection import one_field
from ..options import add_baud, add_device, hertz, line_of, seconds
from ..ports import connection
from ..ports.listing import command_type
from ..ports.silence import Line
from ..ports.start import start

if TYPE_CHECKING:
    from ..analysis.ellipsoid import Fit
    from ..columns.scan import Array

EPILOG = """\
examples:
  mip calibrate-mag /dev/ttyACM0                     turn the device; Ctrl-C ends the measurement
  mip calibrate-mag /dev/ttyACM0 --duration 60 --apply --save
  mip calibrate-mag log.bin --picture mag.png
  mip calibrate-mag log.bin --apply /dev/ttyACM0

Turn the device slowly about all axes, mounted as it will be used, away from other iron. A port is
configured to send sensor.scaled_mag, as by `mip stream`. Offset and matrix include those that the
device has, because it applies them to the data; with --overwrite, the log is from before that.
Without --save, they are lost at power-off.
"""
_FIELD, _HARD, _SOFT = "sensor.scaled_mag", "3dm.mag_hard_iron_offset", "3dm.mag_soft_iron_matrix"
#: The least coverage for an ellipsoid, and for a sphere.
_LEAST = {True: 0.5, False: 0.25}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("input", metavar="PORT", help="a port such as /dev/ttyACM0, COM3, HOST:PORT; or a log")
    add("--rate", type=hertz, default=50.0, metavar="HZ", help="rate of the measurements at a port (default: 50)")
    add("--duration", type=seconds, metavar="S", help="measure for S seconds (default: until Ctrl-C)")
    add("--hard-iron-only", action="store_true", help="fit a sphere, which needs half the coverage")
    add("--field", type=float, metavar="GAUSS", help="true field strength (default: keep the measured one)")
    add("--picture", metavar="FILE", help="draw the measurements before and after: png, svg or pdf")
    add("--apply", nargs="?", const="", metavar="PORT", help="write the result to the device, of a log at PORT")
    add("--save", action="store_true", help="with --apply: also save it in the device")
    add("--overwrite", action="store_true", help="do not combine the result with the values in the device")
    add_device(parser)
    add_baud(parser)


def run(options: argparse.Namespace) -> int:
    inputs.need_numpy()
    at_port = inputs.is_port(options.input)
    if options.save and options.apply is None:
        raise Misuse("--save is for --apply")
    if options.apply == "" and not at_port:
        raise Misuse("name the port of the device: --apply PORT")
    pyplot = plot.matplotlib_pyplot(window=False) if plot.image_format(options.picture) else None
    points = _measured(options) if at_port else _logged(options)
    fit, share = _fitted(points, options)
    print(f"{len(points)} measurements, coverage {share:.0%}, field {fit.field:.4f} gauss")
    print(f"deviation of the field strength: {fit.before:.4f} gauss before, {fit.after:.4f} gauss after")
    if pyplot is not None:
        _draw(pyplot, points, fit, options.picture)
    port = options.apply or (options.input if at_port else None)
    offset, matrix = fit.offset, fit.matrix
    if port is None:
        print("for a device without hard and soft iron correction; with --apply PORT, it is combined with that")
        return _print(options.apply or "PORT", offset, matrix)
    with connection.opened(Line(port, options.baud, options.command)) as device:
        try:
            offset, matrix = _combined(device, offset, matrix, options.overwrite)
            _print(port, offset, matrix)
            for name, values in ((_HARD, offset), (_SOFT, matrix)) if options.apply is not None else ():
                kind = command_type(name)
                device.request(kind.write(values.tolist()))
                if options.save:
                    device.request(kind.save())
        except Refused as error:
            raise Failure(str(error), 3) from None
        except (OSError, MipError) as error:
            raise Failure(f"{port}: {connection.reason(error)}") from None
    if options.apply is not None:
        print("written and saved" if options.save else "written; --save keeps it after power-off")
    return 0


def _print(port: str, offset: Array, matrix: Array) -> int:
    for name, values in ((_HARD, offset), (_SOFT, matrix)):
        print(f"mip send {port} {name} write", ",".join(f"{value:.6g}" for value in values.ravel()))
    return 0


def _logged(options: argparse.Namespace) -> Array:
    import numpy as np

    with inputs.open_columns(options.input, options.device) as log:
        _refuse(log.device)
        points = np.asarray(log[one_field(_FIELD)]["scaled_mag"], float)
    if not len(points):
        raise Failure(f"{options.input} has no {_FIELD}; record a log that has it while you turn the device")
    return points


def _refuse(device: str | None) -> None:
    """Raises Failure if the device has no magnetometer."""
    kind = one_field(_FIELD)
    profile = DEVICES.get(device or "")
    why = profile.why(kind.set, kind.kind.DESCRIPTOR) if profile else None
    if profile and why and why.absence:
        raise Failure(f"{profile.title} {why.absence}")


def _measured(options: argparse.Namespace) -> Array:
    """Measures at a port, until the time is over or Ctrl-C."""
    import numpy as np

    from ..analysis.ellipsoid import coverage, sphere_centre

    field, known = one_field(_FIELD), KnownDevice(options.device)
    kind: Any = field.kind
    points: list[Any] = []

    def begin(device: Any) -> bool:
        known.ask(device)
        _refuse(known.id)
        start(device, {field: options.rate}, "auto")
        return False

    shown = 0.0
    with signals.handled(signals.interrupt):
        try:
            for piece in connection.port_pieces(line_of(options, options.input), options.duration, begin):
                if piece is not None and piece.packet is not None:
                    points += [tuple(found.scaled_mag) for found in kind.find_all(piece.packet)]
                elif len(points) > 3 and time.monotonic() - shown > 0.5 and outputs.redraws(sys.stderr):
                    shown, array = time.monotonic(), np.array(points)
                    try:
                        share = coverage(array, sphere_centre(array))
                    except ValueError:
                        share = 0.0
                    outputs.progress(f"{len(points)} measurements, coverage {share:.0%}; turn the device")
        except KeyboardInterrupt:  # the usual way to end it
            pass
        finally:
            outputs.progress("")
    if not points:
        raise Failure(f"{options.input} has sent no {_FIELD}")
    return np.array(points, float)


def _fitted(points: Array, options: argparse.Namespace) -> tuple[Fit, float]:
    import numpy as np

    from ..analysis.ellipsoid import coverage, fitted, sphere_centre

    points = points[np.isfinite(points).all(axis=1)]
    soft = not options.hard_iron_only
    try:
        share = coverage(points, sphere_centre(points))
        if share < _LEAST[soft]:
            sphere = "; --hard-iron-only needs 25%" if soft and share >= _LEAST[False] else ""
            raise ValueError(
                f"the measurements cover {share:.0%} of all directions, and {_LEAST[soft]:.0%} are needed: "
                f"turn the device about all axes, also upside down{sphere}"
            )
        return fitted(points, soft, options.field), share
    except ValueError as error:
        raise Failure(str(error)) from None


def _combined(device: Any, offset: Array, matrix: Array, overwrite: bool) -> tuple[Array, Array]:
    """Converts a result to the axes of the sensor, and combines it with the present values of the device."""
    import numpy as np

    turn = _mounting(device)
    offset, matrix = turn.T @ offset, turn.T @ matrix @ turn
    if overwrite:
        return offset, matrix
    hard = np.array(tuple(device.request(command_type(_HARD).read()).offset))
    soft = np.array(tuple(device.request(command_type(_SOFT).read()).matrix)).reshape(3, 3)
    return hard + np.linalg.solve(soft, offset), matrix @ soft


def _mounting(device: Any) -> Array:
    """Reads the rotation from the sensor to the vehicle, in whose axes the device sends its data."""
    import numpy as np

    for name, behavior in COMMANDS.items():
        if behavior.effect in views.ORIENTATIONS:
            try:
                reply = device.request(asking(name, ()))
            except (Refused, NoAnswer):
                continue
            values = {key: getattr(reply, at) if isinstance(at, str) else at for key, at in behavior.arguments.items()}
            return np.array(views.vehicle_matrix(behavior.effect, values)).reshape(3, 3)
    return np.eye(3)


def _draw(pyplot: Any, points: Array, fit: Fit, path: str) -> None:
    corrected = (points - fit.offset) @ fit.matrix.T
    figure, axes = pyplot.subplots(1, 3, figsize=(12, 4.4), layout="constrained")
    for axis, (a, b) in zip(axes, ((0, 1), (0, 2), (1, 2))):
        for values, label in ((points, "before"), (corrected, "after")):
            axis.plot(values[:, a], values[:, b], ".", markersize=2, label=label)
        axis.add_patch(pyplot.Circle((0, 0), fit.field, fill=False))
        axis.set(aspect="equal", xlabel=f"{'xyz'[a]} in gauss", ylabel=f"{'xyz'[b]} in gauss")
        axis.grid(alpha=0.3)
    axes[0].legend()
    plot.save(figure, path)
