"""Packets and values as text, and YAML files."""
