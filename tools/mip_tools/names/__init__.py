"""Names of fields, commands and values, as people write them."""
