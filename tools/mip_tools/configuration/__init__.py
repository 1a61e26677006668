"""Reads and writes all settings of a device as one file.

`instances`, `setting` and `once` in `spec/simulation` define which settings exist. Tests: `test_config.py`, which also
compares virtual devices after a file has carried settings from one to the other.
"""
