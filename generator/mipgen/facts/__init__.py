"""Facts about each part of a model, composed once for all targets; references in texts; sample values."""
