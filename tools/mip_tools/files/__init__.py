"""Output files, and signals that interrupt writing them."""
