"""From targets to output folders: templates, names, formatters, caches. Independent of languages and fields."""
