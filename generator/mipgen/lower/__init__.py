"""What every codec needs: operations, sizes, lengths, the reference codec. Knows bytes, and nothing of text."""
