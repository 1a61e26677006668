"""Reads and writes all settings of a device as one file.

`instances`, `setting` and `once` in `spec/simulation` define which settings exist. Tests: `test_settings_file.py`,
which compares virtual devices and settings_text.mjs of the workbench, and `test_config.py`.
"""
