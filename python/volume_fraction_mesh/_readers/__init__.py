"""Readers of files. Each imports the library that it needs when it is called."""
