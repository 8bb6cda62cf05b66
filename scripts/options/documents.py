"""Generated parts of the pages.

Documentation/reference/options.md explains the options of the mesher, and the properties of the
other filters, sources, readers and writers. Documentation/user/command-line.md has the table of
arguments.

The options of the mesher come from the table of options, all other properties from the XML of the
server manager.
"""
import re
import xml.etree.ElementTree as ElementTree

from options.table import allowed, label, put, read

PAGE = "Documentation/reference/options.md"
COMMAND_LINE = "Documentation/user/command-line.md"
FILES = ["VolumeFractionInput.xml", "VolumeFractionState.xml", "VolumeFractionSurface.xml",
         "VolumeFractionMesh.xml", "VolumeFractionToTet.xml", "VolumeFractionFragments.xml",
         "VolumeFractionInterfaces.xml", "VolumeFractionShapes.xml", "VolumeFractionReaders.xml",
         "VolumeFractionWriters.xml"]
MESHERS = ("VolumeFractionToHex", "VolumeFractionToTet")

# Properties of the meshers that are not in the table of options, by the group that they begin.
INPUTS = {"Materials": ["VolumeFractionArrays", "MaterialIdArray"], "State": ["StateArrays"]}

# Names in front ends that do not follow from the table of options.
PYTHON = {"VolumeFractionArrays": "fractions", "MaterialIdArray": "labels", "StateArrays": "state",
          "LabelNames": "names", "DensityArrays": "density", "VelocityArray": "velocity",
          "EnergyArray": "energy", "StateKinds": "state_kinds", "RotatedArrays": "rotated_arrays",
          "RefinementArray": "refinement_array", "Threshold": "threshold",
          "RefinementBoxes": "refinement_boxes"}
ARGUMENTS = {"VolumeFractionArrays": "--fractions A,B,..", "MaterialIdArray": "--labels ARRAY",
             "StateArrays": "--state A,B,..", "RefinementArray": "--refine-cells ARRAY",
             "RefinementBoxes": "--refine-box BOX", "Method": "--tetmesh [METHOD]"}
CALLS = {"VolumeFractionArrays": "sculptor_add_material()",
         "MaterialIdArray": "sculptor_set_material_ids()", "StateArrays": "sculptor_add_state()",
         "RefinementArray": "sculptor_set_refinement()"}

HEAD = """# Options

Each option of the mesher has one name in ParaView and in C, one in Python, and often a short one in
`sculptor`. [Choosing](../user/choosing.md) says which options suit which data.

| front end | name | values |
|---|---|---|
| ParaView, panel | *Iso Value*; the gear at the search line shows *advanced* options | as listed |
| ParaView, script | `IsoValue=0.4` | 0 and 1 for off and on; words as in the panel |
| VTK in C++ and Python | `SetIsoValue(0.4)` | 0 and 1 for off and on; words as numbers, from 0 |
| Python package | `iso_value=0.4` | `True` and `False`; words as `"quadric_surface"` |
| command `vfmesh` | `--iso-value 0.4` | `--mesh-void`, `--no-mesh-void`; Python words, any case |
| `sculptor` | `--iso 0.4`, `--set IsoValue=0.4` | `on`, `off`; words without spaces, or numbers |
| C, C++ and Fortran | `sculptor_set_option(s, "IsoValue", "0.4")` | as for `sculptor` |

`sculptor` and C ignore upper and lower case. ParaView scripts set *MaximumLevel* to a number (-1:
Automatic), but read a word. `scripts/generate` writes this page from the table of options and the
XML in `Plugin`; the test `structure.Generated` fails if it is not current."""


def plain(text):
    """Returns the text of a Documentation element as one line that fits into a table. A paragraph
    with -- is a list of shapes."""
    paragraphs = [" ".join(part.split()) for part in re.split(r"\n\s*\n", text)]
    for i, paragraph in enumerate(paragraphs):
        if " -- " in paragraph:
            paragraphs[i] = ", ".join("`%s`" % shape for shape in paragraph.split(" -- ")) + "."
    return " ".join(paragraphs).replace("|", "\\|").strip()


def entries(element):
    """Returns the words of an enumeration by their values."""
    return {entry.get("value"): entry.get("text") for entry in element.iter("Entry")}


def default_of(element):
    separator = element.get("default_values_delimiter") or "\n"
    default = element.get("default_values", "").split(separator)[-1]
    if element.find("BooleanDomain") is not None:
        return {"0": "off", "1": "on"}[default]
    return entries(element).get(default, default)


def values_of(element):
    """Returns the values that a property accepts."""
    if element.find("BooleanDomain") is not None:
        return "on, off"
    for domain, of in (("ArrayListDomain", "cell "), ("MeshArrayListDomain", "")):
        if element.find(domain) is not None:
            one = "a cell array" if of else "an array"
            return of + "arrays" if element.get("repeat_command") else one
    if entries(element):
        return ", ".join(entries(element).values())
    kind = {"IntVectorProperty": "integer", "DoubleVectorProperty": "number",
            "StringVectorProperty": "text"}[element.tag]
    count = int(element.get("number_of_elements")
                or element.get("number_of_elements_per_command", "1"))
    kind = kind if count == 1 else "%d %ss" % (count, kind)
    kind += " each" if element.get("repeat_command") else ""
    limits = next((d for d in element if d.tag.endswith("RangeDomain")), None)
    low, high = "", ""
    if limits is not None:
        low, high = (limits.get(side, "").split(" ")[0] for side in ("min", "max"))
    if low and high:
        return "%s, %s to %s" % (kind, low, high)
    return "%s, %s or more" % (kind, low) if low else kind


def is_shown(element):
    return (element.tag.endswith("VectorProperty") and not element.get("information_only")
            and element.get("panel_visibility") != "never" and element.get("name") != "FileName")


def own_properties(proxy):
    return {p.get("name"): p for p in proxy if p.tag.endswith("VectorProperty")}


def is_part(proxy):
    """Returns whether a proxy is only a part of other proxies."""
    return proxy is not None and proxy.find("Documentation") is None


def all_properties(proxy, proxies):
    """Returns the properties of the base of a proxy, then its own."""
    base = proxies.get(proxy.get("base_proxyname"))
    return {**(all_properties(base, proxies) if base is not None else {}), **own_properties(proxy)}


def properties_of(proxy, proxies):
    """Returns the properties of a proxy and those that it exposes of the proxy inside."""
    base = proxies.get(proxy.get("base_proxyname"))
    properties = all_properties(proxy, proxies) if is_part(base) else own_properties(proxy)
    for sub in proxy.iter("SubProxy"):
        inside = all_properties(proxies[sub.find("Proxy").get("proxyname")], proxies)
        properties.update((p.get("name"), inside[p.get("name")])
                          for p in sub.find("ExposedProperties"))
    return [p for p in properties.values() if is_shown(p)]


def write_section(proxy, proxies):
    """Yields the section of a filter, source, reader or writer other than the meshers."""
    title = proxy.get("label") or label(proxy.get("name"))
    help_text = proxy.find("Documentation").get("long_help")
    yield "\n## %s\n`%s`. %s\n" % (title, proxy.get("name"), help_text)
    properties = properties_of(proxy, proxies)
    if not properties:
        yield "No properties.\n"
        return
    yield "| property | values | default | |\n|---|---|---|---|"
    for element in properties:
        advanced = " *advanced*" if element.get("panel_visibility") == "advanced" else ""
        yield "| %s%s | %s | %s | %s |" % (element.get("name"), advanced, values_of(element),
                                           default_of(element),
                                           plain(element.find("Documentation").text))


def read_proxies(texts=read):
    """Returns all proxies by name, in the order of the files. texts: returns the text of a path."""
    proxies = {}
    for name in FILES:
        for group in ElementTree.fromstring(texts("Plugin/" + name)).iter("ProxyGroup"):
            proxies.update((proxy.get("name"), proxy) for proxy in group)
    return proxies


def values_of_row(row):
    """Returns the values that an option accepts, with words as panels show them."""
    if row["kind"] == "choice":
        return ", ".join(row["words"])
    return {"switch": "on, off", "array": "an array", "arrays": "arrays",
            "kinds": "array=kind, ..", "pairs": "all, or A/B, ..", "ranges": "LOW:HIGH, ..",
            "widths": "W or X,Y,Z", "sizes": "auto, or MATERIAL=W, ..",
            "file": "file"}.get(row["kind"], allowed(row))


def default_of_row(row):
    if row["kind"] == "choice":
        return row["words"][row["number"]]
    if row["special"] is not None and str(row["special"]) == row["default"]:
        return "%s (%s)" % (row["default"], row["meaning"])
    return row["default"]


def write_entry(name, is_advanced, names, values, default, paragraphs):
    """Yields the heading of an option, the row of its names and values, and its explanation.
    names: in Python, sculptor and C."""
    yield "\n### %s" % name
    yield "| ParaView | Python | `sculptor` | C | values | default |\n|---|---|---|---|---|---|"
    shown = name + (" *advanced*" if is_advanced else "")
    quoted = ["`%s`" % each for each in names]
    yield "| %s | %s | %s | %s |" % (shown, " | ".join(quoted), values, default)
    for paragraph in paragraphs:
        yield "\n" + plain(paragraph)


def write_input(element):
    """Yields the entry of an input of the meshers that is not in the table of options."""
    name = element.get("name")
    yield from write_entry(name, False, (PYTHON[name], ARGUMENTS[name], CALLS[name]),
                           values_of(element), default_of(element),
                           [element.find("Documentation").text])


def write_row(row):
    """Yields the entry of an option."""
    name = row["name"]
    own = row["argument"] or ARGUMENTS.get(name) or "--set %s=.." % name
    names = (row["python"] or PYTHON[name], own, CALLS.get(name, name))
    paragraphs = [row["text"]]
    if row["text_of_tets"]:
        paragraphs.append("*Tetrahedra:* " + row["text_of_tets"])
    yield from write_entry(name, row["advanced"], names, values_of_row(row), default_of_row(row),
                           paragraphs)


def group_rows(table):
    """Returns the rows by the groups of the panel, in order."""
    groups = {}
    for row in table:
        title = re.sub(r" *\(.*\)$", "", row["group"])
        groups.setdefault("State" if title.startswith("State") else title, []).append(row)
    return groups


def write_options(table, proxies):
    """Yields the sections of the options of the meshers."""
    elements = all_properties(proxies["VolumeFractionToHex"], proxies)
    groups = group_rows(table)
    for title, rows in groups.items():
        names = INPUTS.get(title, []) + [row["name"] for row in rows]
        links = ["[%s](#%s)" % (name, name.lower()) for name in names]
        yield "\n## %s\n%s" % (title, " · ".join(links))
        for name in INPUTS.get(title, []):
            yield from write_input(elements[name])
        for row in rows:
            yield from write_row(row)


def make_page(table, texts):
    proxies = read_proxies(texts)
    lines = [HEAD, *write_options(table, proxies)]
    for name, proxy in proxies.items():
        if not is_part(proxy) and name not in MESHERS:
            lines += write_section(proxy, proxies)
    return "\n".join(lines).rstrip() + "\n"


def summary(row):
    """Returns the first sentence of the explanation of an option."""
    return re.match(r".*?\.(?= |$)", row["text"]).group()


def write_arguments(text, table):
    """Writes the options of the mesher that have an argument of sculptor."""
    lines = ["| `%s` | [%s](../reference/options.md#%s) | %s | %s | %s |"
             % (row["argument"], row["name"], row["name"].lower(), values_of_row(row),
                default_of_row(row), summary(row))
             for row in table if row["argument"]]
    return put(text, "options: generated", "end of options",
               ["", "| argument | option | values | default | |", "|---|---|---|---|---|"] + lines
               + [""])


def files(table, texts):
    """Returns, for each generated page, a function that updates its text. texts: returns the text
    of a path."""
    return {PAGE: lambda text: make_page(table, texts),
            COMMAND_LINE: lambda text: write_arguments(text, table)}
