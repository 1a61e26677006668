"""Reads specifications: files, lines, schemas, overlays and the wording of problems. Independent of MIP."""
