"""Loads the plugin for a script that was told where it is, also by a path from the present folder,
which ParaView since 5.13 takes for a name."""
import os

from paraview import simple


def load_plugin(path, names):
    """names: globals() of the script, which gets the functions that make the plugin's filters."""
    simple.LoadPlugin(os.path.abspath(path), remote=False, ns=names)
