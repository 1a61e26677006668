"""Turns nodes into the model, and checks it. Only this package knows the keys of a specification."""
