"""Reads and writes all settings of a device as one file."""
