"""What the specification states about devices: profiles, settings, effects and limits of commands."""
