"""What the templates print: a class for each kind of page, or part of one, whose properties are finished Markdown."""
