"""One module per target language; `render.Target` defines what it offers."""
