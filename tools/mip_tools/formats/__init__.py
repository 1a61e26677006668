"""Output formats: tables, MCAP, ROS 2 bags, Foxglove.

Tests in `tests/tools`: `cli/test_stream.py`, `cli/test_robots.py`, `cli/test_foxglove.py`, `test_log_tables.py`.
"""
