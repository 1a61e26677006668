"""`mip doctor`: finds faults of a stream, and their causes.

Warnings follow from `concerns` of bits. `tests/tools/cli/test_doctor.py` plants each cause.
"""
