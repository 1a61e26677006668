"""The settings of a device as one file: what they are, how they are written and read, and how a device gets them."""
