"""The settings of a device as one file, and their transfer to and from a device."""
