"""A virtual device: answers commands and streams data as a device profile says, without hardware."""
