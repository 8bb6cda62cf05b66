"""Orientations and phases of grains."""
