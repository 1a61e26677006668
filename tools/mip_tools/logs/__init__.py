"""Logs and streams: where their bytes come from, their packets, parts and reports."""
