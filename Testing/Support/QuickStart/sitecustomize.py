"""Python loads this module at start if PYTHONPATH contains the folder.

It prevents ParaView from looking up the documentation of each function, which takes half of the
time that pvpython needs to start.
"""
import importlib.util
import sys


class ServerManagerFinder:
    """Finds paraview.servermanager once and changes it after loading."""

    def find_spec(self, name, path, target=None):
        if name != "paraview.servermanager":
            return None
        sys.meta_path.remove(self)
        spec = importlib.util.find_spec(name)
        load = spec.loader.exec_module

        def load_and_change(module):
            load(module)
            if hasattr(module, "ProxyNamespace"):
                module.ProxyNamespace.getDocumentation = lambda *_: ""

        spec.loader.exec_module = load_and_change
        return spec


sys.meta_path.insert(0, ServerManagerFinder())
