#!/usr/bin/env python3
"""Panels that ParaView makes of Plugin/*.xml.

Each property of the meshing filters is in a group. Decorators refer to existing properties.
"""
import os
import unittest
import xml.etree.ElementTree as ElementTree

PLUGIN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Plugin")


def read_proxies():
    """Returns all proxies by name."""
    proxies = {}
    for name in sorted(os.listdir(PLUGIN)):
        if name.endswith((".xml", ".xml.in")):
            for group in ElementTree.parse(os.path.join(PLUGIN, name)).iter("ProxyGroup"):
                proxies.update((proxy.get("name"), proxy) for proxy in group)
    return proxies


PROXIES = read_proxies()


def properties(proxy):
    """Returns the properties of the base proxy, then its own."""
    base = PROXIES.get(proxy.get("base_proxyname"))
    return ([] if base is None else properties(base)) + [
        p for p in proxy if p.tag.endswith("Property")]


def names(proxy):
    return [p.get("name") for p in properties(proxy)]


def groups(proxy):
    """Returns {label: names of properties} of all groups, including the base proxy's groups."""
    own = {group.get("label"): [p.get("name") for p in group]
           for group in proxy.iter("PropertyGroup")}
    base = PROXIES.get(proxy.get("base_proxyname"))
    return own if base is None else {**own, **groups(base)}


class Panel(unittest.TestCase):
    def test_every_property_is_in_a_group(self):
        for name in ("VolumeFractionToHex", "VolumeFractionToTet"):
            proxy = PROXIES[name]
            grouped = [p for members in groups(proxy).values() for p in members]
            self.assertEqual(len(grouped), len(set(grouped)), name)
            shown = {p.get("name") for p in properties(proxy) if not p.get("information_only")}
            self.assertEqual(shown - {"Input"}, set(grouped) - {"Input"}, name)

    def test_method_stands_above_what_hexahedra_have_too(self):
        """Groups are in the order of their first property, and Input is the first of all."""
        members = next(iter(groups(PROXIES["VolumeFractionToTet"]).values()))
        self.assertEqual(members[:2], ["Input", "Method"])
        self.assertEqual(names(PROXIES["VolumeFractionToHex"])[0], "Input")

    def test_decorators_name_properties(self):
        count = 0
        for name, proxy in PROXIES.items():
            for decorator in proxy.iter("PropertyWidgetDecorator"):
                if decorator.get("type") == "GenericDecorator":
                    self.assertIn(decorator.get("property"), names(proxy), name)
                    self.assertIn(decorator.get("mode"), ("visibility", "enabled_state"), name)
                    count += 1
        self.assertGreater(count, 10)


if __name__ == "__main__":
    unittest.main()
