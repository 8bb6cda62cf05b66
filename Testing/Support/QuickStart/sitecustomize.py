"""Python loads this module when it starts, if PYTHONPATH names the folder. It keeps ParaView from
looking up the documentation of each of its functions, which takes half of the time that pvpython
needs to start."""
import importlib.util
import sys


class ServerManagerFinder:
    """Finds paraview.servermanager once and changes it after it was loaded."""

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
