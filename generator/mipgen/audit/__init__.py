"""Compares the specification with manuals and other sources."""
