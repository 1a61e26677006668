"""A port for pages in a browser: `mip serve`."""
