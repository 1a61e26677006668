"""The navigation filter of the virtual device."""
