"""The latest values of a device, and the screen that shows them.

Tests: `tests/tools/cli/test_monitor.py`, which presses keys.
"""
