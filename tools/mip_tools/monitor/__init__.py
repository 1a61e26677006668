"""The latest values of a device."""
