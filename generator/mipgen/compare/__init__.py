"""Finds what a change to a specification means for its users."""
