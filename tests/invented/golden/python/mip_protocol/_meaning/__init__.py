"""What the types of each module mean; `reflection.info` loads what is asked for."""
