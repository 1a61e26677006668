"""The consequences of a change to a specification for its users."""
