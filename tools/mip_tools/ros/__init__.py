"""ROS 2 messages: standard ones in the axes of REP 103, and those of the package mip_msgs."""
