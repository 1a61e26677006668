"""Facts of manuals and other sources that the specification does not have."""
