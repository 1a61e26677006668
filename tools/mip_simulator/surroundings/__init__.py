"""The motion of the virtual device and everything around it: gravity, magnetic field, satellites, noise of sensors."""
