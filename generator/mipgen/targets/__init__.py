"""One module per target language; `render.Target` says what it offers."""
