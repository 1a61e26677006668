"""mipgen: one specification of the MIP protocol, bindings in several languages."""

__version__ = "0.2.0"
