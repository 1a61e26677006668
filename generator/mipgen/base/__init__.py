"""The program itself: its files, its cache, its processes, and the failure that ends it. Independent of MIP."""
