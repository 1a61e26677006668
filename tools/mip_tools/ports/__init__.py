"""Ports of devices: received bytes, silence, and what a device reports about itself."""
