"""One package for each target; `emit.target.Target` defines its interface."""
