"""Commands to the virtual device: their replies and effects."""
