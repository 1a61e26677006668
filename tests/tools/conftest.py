"""The tests of the folders below import from the modules here: pytest puts the folder of this file on the path."""
