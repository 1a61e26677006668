"""What the virtual device sends: streams, events, NMEA sentences."""
