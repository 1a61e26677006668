"""What every codec needs: sizes, lengths, runs, memory, the reference codec. Deals with bytes, not with texts."""
