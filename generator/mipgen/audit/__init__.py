"""What manuals and other sources contain that the specification does not."""
