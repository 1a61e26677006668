"""Output formats: tables, MCAP, ROS 2 bags.

Tests in `tests/tools`: `cli/test_stream.py`, `cli/test_robots.py`, `test_log_tables.py`.
"""
