"""`mip doctor`: finds faults of a stream, and their causes."""
