"""One package for each target; `emit.target.Target` defines what it offers."""
