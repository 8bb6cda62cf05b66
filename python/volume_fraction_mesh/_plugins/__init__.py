"""Plugins of other packages, which import them."""
