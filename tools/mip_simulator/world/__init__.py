"""The quantities that the virtual device sends: what its sensors measure, and its filter and its receivers compute."""
