"""The properties of the filters in the server manager's XML, and the groups of their panels.

When a property is shown, or not grey, the table says by names and words: "!StairStep & Smoothing!=Off", "Refinement!=Off |
MaximumAspectRatio!=0", "(A=x | A=y & B) & C". A name alone: the switch is on, an array is named.
"""
import ast
import re
from xml.sax.saxutils import escape, quoteattr

from options.table import common, label, of_tets, put, wrap

# What stands in a group before the options, by hand.
FIRST = {"Materials": ["VolumeFractionArrays", "MaterialIdArray"], "State": ["StateArrays"], "Tetrahedra": ["Input"]}
INPUT_GROUPS = ("Materials", "State", "State kinds (array=kind)")
LONGEST_SLIDER = 1000 # a range that is longer has no slider
BOX = ("x from", "y from", "z from", "x to", "y to", "z to", "halvings")


def element(tag, attributes, inside=()):
    """Lines of an element, indented by what is inside alone."""
    start = "<%s%s" % (tag, "".join(" %s=%s" % (name, quoteattr(str(value))) for name, value in attributes))
    if not inside:
        return [start + " />"]
    return [start + ">"] + ["  " + line for line in inside] + ["</%s>" % tag]


def parse_condition(text):
    """A tree of Python: strings, which are words of the text, joined by "and" and "or"."""
    words = re.sub(r"!?\w+(?:!?=[^&|()]+)?", lambda word: repr(word.group().strip()), text)
    return ast.parse(words.replace("&", "and").replace("|", "or"), mode="eval").body


def write_condition(text, mode, rows):
    """Decorators of the mode, all of which must hold."""
    tree = parse_condition(text)
    parts = tree.values if isinstance(tree, ast.BoolOp) and isinstance(tree.op, ast.And) else [tree]
    return [line for part in parts for line in write_decorator(part, mode, rows)]


def write_decorator(tree, mode, rows, is_inside=False):
    if isinstance(tree, ast.Constant):
        pairs = [("type", "GenericDecorator"), ("mode", mode)] + write_word(tree.value, rows)
        return element("PropertyWidgetDecorator", pairs)
    inside = element("Expression", [("type", type(tree.op).__name__.lower())],
                     [line for part in tree.values for line in write_decorator(part, mode, rows, True)])
    return inside if is_inside else element("PropertyWidgetDecorator", [("type", "CompositeDecorator")], inside)


def write_word(word, rows):
    name, sign, values = re.match(r"!?(\w+)(!?=)?(.*)", word).groups()
    row = rows.get(name)
    if not sign and row and row["kind"] == "switch":
        return [("property", name), ("value", 0 if word.startswith("!") else 1)]
    if not sign:
        none = [("value", "null" if row["kind"] == "arrays" else "None")] if row else [("index", 4), ("value", "None")]
        return [("property", name), *none, ("inverse", 1)]
    numbers = [str(row["words"].index(value)) if row["words"] else value for value in values.split(",")]
    pairs = [("property", name), ("value" if len(numbers) == 1 else "values", " ".join(numbers))]
    return pairs + ([("inverse", 1)] if sign == "!=" else [])


def range_of(row):
    """Ends of a range that sliders have."""
    ends = [end for end in (row["least"], row["special"]) if end is not None]
    pairs = [("min", "%g" % min(ends))] if ends else []
    has_most = row["most"] is not None and row["most"] - row["least"] <= LONGEST_SLIDER
    return pairs + ([("max", "%g" % row["most"])] if has_most else [])


def entries(row):
    """Texts by their numbers."""
    if row["kind"] == "choice":
        return list(enumerate(row["words"]))
    return [(number, row["meaning"].capitalize() if number == row["special"] else number)
            for number in range(int(row["least"]), int(row["most"]) + 1)]


def domain(row):
    kind = row["kind"]
    if kind == "switch":
        return element("BooleanDomain", [("name", "bool")])
    if kind == "choice" or row["listed"]:
        return element("EnumerationDomain", [("name", "enum")],
                       [line for number, text in entries(row) for line in element("Entry", [("text", text), ("value", number)])])
    if kind in ("integer", "real"):
        return element("IntRangeDomain" if kind == "integer" else "DoubleRangeDomain", [("name", "range")] + range_of(row))
    if kind in ("array", "arrays"):
        pairs = [("name", "array_list"), ("input_domain_name", "arrays" if row["vectors"] else "scalar_arrays")]
        pairs += [("none_string", "None")] if kind == "array" else []
        return element("MeshArrayListDomain", pairs, element("RequiredProperties", [], element(
            "Property", [("name", "Input"), ("function", "Input")])))
    return element("FileListDomain", [("name", "files")]) if kind == "file" else []


def hints(row, rows, is_hidden):
    lines = []
    if row["kind"] == "file":
        lines += element("FileChooser", [("extensions", "txt csv tsv lut label xml"), ("file_description", "Names of labels")])
    if row["kind"] == "boxes":
        lines += element("ShowLabel", []) + element("ShowComponentLabels", [], [
            line for i, text in enumerate(BOX) for line in element("ComponentLabel", [("component", i), ("label", text)])])
    for key, mode in (("shown", "visibility"), ("enabled", "enabled_state")):
        if row[key] and not is_hidden:
            lines += write_condition(row[key], mode, rows)
    return element("Hints", [], lines) if lines else []


def commands(row):
    """How the property reaches the filter, and its default."""
    name, kind = row["name"], row["kind"]
    one = re.sub("(s|es)$" if kind != "boxes" else "es$", "", name)
    if kind in ("arrays", "kinds", "boxes"):
        return [("command", "Add" + one), ("clean_command", "Clear" + name), ("repeat_command", 1),
                ("number_of_elements_per_command", len(BOX) if kind == "boxes" else 1)]
    default = {"file": "", "array": "None", "integer": row["default"], "real": row["default"]}.get(kind, row["number"])
    return [("command", "Set%s%s" % (name, "File" if kind == "file" else "")), ("number_of_elements", 1), ("default_values", default)]


def write_property(row, rows, of_tets_too=False):
    """of_tets_too: that of tetrahedra, which takes the place of that of hexahedra."""
    is_hidden = of_tets_too and row["hidden_of_tets"]
    tag = {"real": "Double", "boxes": "Double", "switch": "Int", "integer": "Int", "choice": "Int"}.get(row["kind"], "String")
    pairs = [("name", row["name"])]
    pairs += [("label", label(row["name"]))] if label(row["name"]) != row["name"] else []
    pairs += commands(row)
    pairs += [("panel_visibility", "never" if is_hidden else "advanced")] if row["advanced"] else []
    pairs += [("override", 1)] if of_tets_too else []
    text = row["text_of_tets"] if of_tets_too else row["text"]
    inside = domain(row) + hints(row, rows, is_hidden) + element("Documentation", [], wrap(escape(text), "", width=110))
    tag += "VectorProperty"
    start = "      <" + tag + " "
    attributes = ["%s=%s" % (name, quoteattr(str(value))) for name, value in pairs]
    return ([start + attributes[0]] + [" " * len(start) + pair for pair in attributes[1:-1]] +
            [" " * len(start) + attributes[-1] + ">"] + ["        " + line for line in inside] + ["      </%s>" % tag, ""])


def write_group(name, rows):
    names = FIRST.get(name, []) + [row["name"] for row in rows if row["group"] == name]
    lines = element("PropertyGroup", [("label", name)], [line for n in names for line in element("Property", [("name", n)])])
    return ["      " + line for line in lines] + [""]


def write_part(text, table, rows, overrides=()):
    """The properties of rows, and their groups."""
    by_name = {row["name"]: row for row in table}
    lines = [""]
    for row in rows:
        lines += write_property(row, by_name)
    for row in overrides:
        lines += write_property(row, by_name, True)
    for name in dict.fromkeys(row["group"] for row in rows):
        lines += write_group(name, rows)
    return put(text, "options: generated", "end of options", lines[:-1])


def files(table):
    hexes = common(table)
    inputs = [row for row in hexes if row["group"] in INPUT_GROUPS]
    others = [row for row in hexes if row["group"] not in INPUT_GROUPS]
    overrides = [row for row in hexes if row["text_of_tets"]]
    return {"Plugin/VolumeFractionInput.xml": lambda text: write_part(text, table, inputs),
            "Plugin/VolumeFractionMesh.xml": lambda text: write_part(text, table, others),
            "Plugin/VolumeFractionToTet.xml": lambda text: write_part(text, table, of_tets(table), overrides)}
