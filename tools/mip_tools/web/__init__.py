"""`mip serve`: shares a port with pages in a browser."""
