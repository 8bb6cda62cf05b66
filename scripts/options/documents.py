"""The tables of the documents: Documentation/properties.md, the properties of all filters, sources, readers and writers, as the server
manager's XML has them; the options of the mesher that have a name in the program sculptor.
"""
import xml.etree.ElementTree as ElementTree

from options.table import allowed, label, put, read

FILES = ["VolumeFractionInput.xml", "VolumeFractionMesh.xml", "VolumeFractionToTet.xml", "VolumeFractionFragments.xml",
         "VolumeFractionShapes.xml", "VolumeFractionReaders.xml", "VolumeFractionWriters.xml"]
MESHERS = ("VolumeFractionToHex", "VolumeFractionToTet")
HEAD = """# Properties

Written by `scripts/generate` from the XML in `Plugin` and the table of options; the test `structure.Generated` tells when it is not current. Names are those of scripts; the panel shows them with blanks between the
words. *advanced*: shown after a click on the gear beside the search line. What the choices are good for is told in the [user guide](user-guide.md#properties) and in [refined grids](refinement.md)."""


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
    return entries(element).get(default, default)


def values_of(element, numbers):
    """What it takes. numbers: what options of the mesher that are numbers take."""
    if element.get("name") in numbers and not entries(element):
        return numbers[element.get("name")]
    if element.find("BooleanDomain") is not None:
        return "on, off"
    for domain, of in (("ArrayListDomain", "cell "), ("MeshArrayListDomain", "")):
        if element.find(domain) is not None:
            return of + "arrays" if element.get("repeat_command") else "a cell array" if of else "an array"
    if entries(element):
        return ", ".join(entries(element).values())
    kind = {"IntVectorProperty": "integer", "DoubleVectorProperty": "number", "StringVectorProperty": "text"}[element.tag]
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


def section(proxy, proxies, numbers):
    documentation = proxy.find("Documentation")
    title = proxy.get("label") or label(proxy.get("name"))
    yield "\n## %s\n`%s`. %s\n" % (title, proxy.get("name"), documentation.get("long_help"))
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
        yield "| %s%s | %s | %s | %s |" % (element.get("name"), advanced, values_of(element, numbers), default_of(element),
                                           plain(element.find("Documentation").text))


def read_proxies(texts=read):
    """All proxies by name, in the order of the files. texts: of files by their paths."""
    proxies = {}
    for name in FILES:
        for group in ElementTree.fromstring(texts("Plugin/" + name)).iter("ProxyGroup"):
            proxies.update((proxy.get("name"), proxy) for proxy in group)
    return proxies


def make_page(table, texts):
    proxies = read_proxies(texts)
    numbers = {row["name"]: allowed(row) for row in table if row["kind"] in ("integer", "real")}
    lines = [HEAD]
    for name, proxy in proxies.items():
        if not is_part(proxy):
            lines += section(proxy, proxies, numbers if name in MESHERS else {})
    return "\n".join(lines).rstrip() + "\n"


def write_arguments(text, table):
    """The options of the mesher that the program sculptor has a name for."""
    named = [row for row in table if row["argument"]]
    lines = ["| `%(argument)s` | %(name)s | %(takes)s | %(default)s | %(text)s |" % {**row, "takes": allowed(row)} for row in named]
    return put(text, "options: generated", "end of options",
               ["", "| option | sets | takes | default | |", "|---|---|---|---|---|"] + lines + [""])


def files(table, texts):
    """How each file of the tree becomes current: a function of its text. texts: of all files by their paths."""
    return {"Documentation/properties.md": lambda text: make_page(table, texts),
            "Documentation/sculptor.md": lambda text: write_arguments(text, table)}
