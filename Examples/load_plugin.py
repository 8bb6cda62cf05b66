"""Loads the plugin from a path, absolute or relative to the current folder. ParaView 5.13 and later
take a relative path for the name of a plugin."""
import os

from paraview import simple


def load_plugin(path, names):
    """Loads the plugin and adds the functions that create its filters to names, the globals() of
    the script."""
    simple.LoadPlugin(os.path.abspath(path), remote=False, ns=names)
