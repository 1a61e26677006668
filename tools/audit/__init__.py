"""Compares this specification with facts of other sources: `make audit`.

`tests/generator/test_witness.py` tests it.
"""
