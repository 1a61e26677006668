"""What data of a log or a port says about its sensors: arrays in, numbers out."""
