"""Standard messages of ROS 2, in the axes of REP 103."""
