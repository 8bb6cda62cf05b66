#!/usr/bin/env python3
"""Writes Documentation/properties.md: the properties of all filters, sources, readers and writers, as the server manager's XML tells them.

usage: scripts/list_properties.py           writes it
       scripts/list_properties.py --check   fails when it is not what would be written
"""
import os
import re
import sys
import xml.etree.ElementTree as ElementTree

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
PAGE = os.path.join(ROOT, "Documentation", "properties.md")
FILES = ["VolumeFractionInput.xml", "VolumeFractionMesh.xml", "VolumeFractionToTet.xml.in", "VolumeFractionFragments.xml",
         "VolumeFractionShapes.xml", "VolumeFractionReaders.xml", "VolumeFractionWriters.xml"]
HEAD = """# Properties

Written by `scripts/list_properties.py` from the XML in `Plugin`; the test `documents` tells when it is not current. Names are those of scripts; the panel shows them with blanks between the
words. *advanced*: shown after a click on the gear beside the search line. What the choices are good for is told in the [user guide](user-guide.md#properties) and in [refined grids](refinement.md)."""
BUILT = {"@VFM_DEFAULT_TET_METHOD@": "TetGen where it was built in, else Lattice"}


def plain(text):
    """Of a Documentation element: one line, fit for a table."""
    return " ".join(text.split()).replace("|", "\\|")


def entries(element):
    """Words of an enumeration by their values."""
    return {entry.get("value"): entry.get("text") for entry in element.iter("Entry")}


def default_of(element):
    default = element.get("default_values", "").split(element.get("default_values_delimiter") or "\n")[-1]
    if element.find("BooleanDomain") is not None:
        return {"0": "off", "1": "on"}[default]
    return BUILT.get(default) or entries(element).get(default, default)


def values_of(element):
    """What it takes."""
    if element.find("BooleanDomain") is not None:
        return "on, off"
    for domain, of in (("ArrayListDomain", "cell "), ("MeshArrayListDomain", "")):
        if element.find(domain) is not None:
            return of + "arrays" if element.get("repeat_command") else "a cell array" if of else "an array"
    if entries(element):
        return ", ".join(entries(element).values())
    kind = {"IntVectorProperty": "whole number", "DoubleVectorProperty": "number", "StringVectorProperty": "text"}[element.tag]
    count = int(element.get("number_of_elements") or element.get("number_of_elements_per_command", "1"))
    kind = kind if count == 1 else "%d %ss" % (count, kind)
    kind += " each" if element.get("repeat_command") else ""
    limits = next((d for d in element if d.tag.endswith("RangeDomain")), None)
    low, high = (limits.get(side, "").split(" ")[0] for side in ("min", "max")) if limits is not None else ("", "")
    if low and high:
        return "%s, %s to %s" % (kind, low, high)
    return "%s, %s or more" % (kind, low) if low else kind


def is_shown(element):
    return (element.tag.endswith("VectorProperty") and not element.get("information_only")
            and element.get("panel_visibility") != "never" and element.get("name") != "FileName")


def own_properties(proxy):
    return {p.get("name"): p for p in proxy if p.tag.endswith("VectorProperty")}


def is_part(proxy):
    """Whether it is no more than a part of others."""
    return proxy is not None and proxy.find("Documentation") is None


def all_properties(proxy, proxies):
    """Its own after those of what it is based on."""
    base = proxies.get(proxy.get("base_proxyname"))
    return {**(all_properties(base, proxies) if base is not None else {}), **own_properties(proxy)}


def properties_of(proxy, proxies):
    """Its own with those of its part, and those that it exposes of the proxy inside."""
    base = proxies.get(proxy.get("base_proxyname"))
    properties = all_properties(proxy, proxies) if is_part(base) else own_properties(proxy)
    for sub in proxy.iter("SubProxy"):
        held = all_properties(proxies[sub.find("Proxy").get("proxyname")], proxies)
        properties.update((p.get("name"), held[p.get("name")]) for p in sub.find("ExposedProperties"))
    return [p for p in properties.values() if is_shown(p)]


def section(proxy, proxies):
    documentation = proxy.find("Documentation")
    label = proxy.get("label") or re.sub(r"(?<=[a-z])(?=[A-Z])", " ", proxy.get("name"))
    yield "\n## %s\n`%s`. %s\n" % (label, proxy.get("name"), documentation.get("long_help"))
    base = proxies.get(proxy.get("base_proxyname"))
    if base is not None and not is_part(base):
        yield "All properties of *%s*, of which these have other words, and its own:\n" % base.get("label")
    properties = properties_of(proxy, proxies)
    if not properties:
        yield "No properties.\n"
        return
    yield "| property | takes | default | |\n|---|---|---|---|"
    for element in properties:
        advanced = " *advanced*" if element.get("panel_visibility") == "advanced" else ""
        yield "| %s%s | %s | %s | %s |" % (element.get("name"), advanced, values_of(element), default_of(element),
                                           plain(element.find("Documentation").text))


def read_proxies():
    """All proxies by name, in the order of the files."""
    proxies = {}
    for name in FILES:
        tree = ElementTree.parse(os.path.join(ROOT, "Plugin", name))
        for group in tree.iter("ProxyGroup"):
            proxies.update((proxy.get("name"), proxy) for proxy in group)
    return proxies


def make_page():
    proxies = read_proxies()
    lines = [HEAD]
    for proxy in proxies.values():
        if not is_part(proxy):
            lines += section(proxy, proxies)
    return "\n".join(lines).rstrip() + "\n"


def main(arguments):
    page = make_page()
    if arguments == ["--check"]:
        with open(PAGE, encoding="utf-8") as file:
            if file.read() != page:
                sys.exit("Documentation/properties.md is not current: run scripts/list_properties.py")
        return
    if arguments:
        sys.exit(__doc__)
    with open(PAGE, "w", encoding="utf-8") as file:
        file.write(page)


if __name__ == "__main__":
    main(sys.argv[1:])
