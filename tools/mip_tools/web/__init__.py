"""`mip serve`: shares a port with pages in a browser.

Tests: `tests/tools/cli/test_web.py`, and `tests/javascript/test_live_page.py` in Chromium.
"""
