"""From targets to folders of output: templates, names, formatters, caches. Knows no language and no field."""
