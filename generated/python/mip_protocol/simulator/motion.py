from __future__ import annotations


class Motion:
    pass


class Standing(Motion):
    pass
