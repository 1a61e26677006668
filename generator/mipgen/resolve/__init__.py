"""Turns nodes into the model, and checks it. Knows what each key of a specification means."""
