"""Reads specifications. Knows files, lines, schemas and overlays, words problems, and knows nothing of MIP."""
