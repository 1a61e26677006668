"""The needs of every codec: sizes, lengths, runs, memory, the reference codec. Knows bytes, and nothing of text."""
