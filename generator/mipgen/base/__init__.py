"""The program itself: its files, its cache, its processes, and the failure that ends it. Knows nothing of MIP."""
