"""What every codec needs: sizes, lengths, runs, memory, the reference codec. Knows bytes, and nothing of text."""
