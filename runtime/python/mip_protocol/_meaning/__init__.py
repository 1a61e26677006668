"""The meaning of the types of each module; `reflection.info` loads them on demand."""
