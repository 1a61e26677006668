"""Compares this specification with manuals and other sources: `make audit`.

`tests/generator/test_witness.py` tests it.
"""
