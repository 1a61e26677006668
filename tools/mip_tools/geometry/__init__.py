"""The Earth, and rotations."""
