"""Meshes as objects of other packages."""
