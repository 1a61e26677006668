"""The commands of `mip`, one module for each, on the standard library; see `mip --help`."""
