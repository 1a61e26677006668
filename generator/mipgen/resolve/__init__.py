"""Turns nodes into the model, and checks it. Only this package knows the keys of a specification.

A further key also needs a place in a schema of `spec/schema`, in the model and in `tests/invented`; each mistake with
it, and the message, is a row in `tests/bad_specs`.
"""
