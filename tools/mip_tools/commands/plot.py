"""`mip plot`: values over time."""

from __future__ import annotations

import argparse

from ..files import outputs
from ..formats import plot
from ..logs import inputs
from ..logs.assumed import print_assumptions
from ..options import add_device

EPILOG = """\
examples:
  mip plot log.bin sensor.scaled_accel -o accel.png
  mip plot log.bin sensor.scaled_accel.z filter_data.llh_position      in a window
  mip plot log.bin gnss_1.llh_position.latitude filter_data.llh_position.latitude --together

The file extension selects the format: png, svg, pdf. Values whose flags mark them as invalid are
left out. Enumerations and flags are shown as numbers.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.epilog = EPILOG
    add = parser.add_argument
    add("file", metavar="FILE", help="a log; - for standard input")
    add("names", nargs="+", metavar="NAME", help="fields, or FIELD.PARAMETER, FIELD.PARAMETER.ELEMENT")
    add("-o", "--output", metavar="FILE", help="write an image (default: open a window)")
    add_device(parser)
    add("--together", action="store_true", help="draw all in one diagram")


def run(options: argparse.Namespace) -> int:
    pyplot = plot.matplotlib_pyplot(window=options.output is None)
    plot.image_format(options.output)
    if options.output is not None:
        outputs.refuse_input(options.output, options.file)
    curves = [curve for name in options.names for curve in plot.curves_of(name)]
    with inputs.open_columns(options.file, options.device) as log:
        figure = plot.draw(pyplot, log, curves, options)
        print_assumptions("plot", log, times=False, names=False)
        if options.output is None:
            pyplot.show()
            return 0
        plot.save(figure, options.output)
    outputs.note(f"{options.output}: {', '.join(options.names)}")
    return 0
