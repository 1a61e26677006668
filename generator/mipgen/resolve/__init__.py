"""Turns nodes into the model, and checks it. Knows the meaning of each key of a specification."""
