"""Properties of the filters in the server manager's XML, and the groups of their panels.

Conditions in the table (when a property is shown, or enabled) consist of names and words:
"!StairStep & Smoothing!=Off", "Refinement!=Off | MaximumAspectRatio!=0", "(A=x | A=y & B) & C".
A name without a word holds if the switch is on or an array is selected.
"""
import ast
import re
from xml.sax.saxutils import escape, quoteattr

from options.table import common, label, of_interfaces, of_tets, put, wrap

# Hand-written properties that come first in a group.
FIRST = {"Materials": ["VolumeFractionArrays", "MaterialIdArray"], "State": ["StateArrays"],
         "Tetrahedra": ["Input"]}
# Properties after one of the table that are not in it, with their XML.
AFTER = {"CellWidth": ("CellCount", """\
      <!-- CellCountDomain writes this text. The link keeps it out of traces. -->
      <StringVectorProperty name="CellCount"
                            label="Cells"
                            number_of_elements="1"
                            default_values=""
                            animateable="0"
                            state_ignored="1">
        <CellCountDomain name="count">
          <RequiredProperties>
            <Property name="Input" function="Input" />
            <Property name="InputSpacing" function="Spacing" />
            <Property name="MaterialIdArray" function="Labels" />
            <Property name="CellWidth" function="Width" />
          </RequiredProperties>
        </CellCountDomain>
        <Hints>
          <PropertyLink group="settings" proxy="None" property="None" />
          <PropertyWidgetDecorator type="GenericDecorator" mode="enabled_state"
                                   property="CellCount" value="never" />
        </Hints>
        <Documentation>
          The number of cells along each axis that Cell Width makes, and their width in the length
          unit of the input. If Cell Width is 0: the cells of the input and their mean width, of an
          image or a rectilinear grid.
        </Documentation>
      </StringVectorProperty>
""")}
# Groups of the files that come before VolumeFractionMesh.xml.
PARTS = {"Input": ("Materials",), "State": ("State", "State kinds (array=kind)"),
         "Surface": ("Surface", "Refinement")}
LONGEST_SLIDER = 1000  # a longer range has no slider
WIDTH = 100
BOX = ("x from", "y from", "z from", "x to", "y to", "z to", "halvings")


def element(tag, attributes, inside=()):
    """Returns the lines of an element; inside: lines of its content."""
    pairs = [" %s=%s" % (name, quoteattr(str(value))) for name, value in attributes]
    start = "<%s%s" % (tag, "".join(pairs))
    if not inside:
        return [start + " />"]
    return [start + ">"] + ["  " + line for line in inside] + ["</%s>" % tag]


def fold(line):
    """Breaks the start tag of an element between attributes where the line is too long."""
    start = len(line) - len(line.lstrip())
    if len(line) <= WIDTH or line[start] != "<":
        return [line]
    words = re.findall(r'(?:[^\s"]|"[^"]*")+', line)
    folded = [" " * start + " ".join(words[:2])]
    for word in words[2:]:
        if len(folded[-1]) + 1 + len(word) > WIDTH:
            folded.append(" " * (start + len(words[0])))
        folded[-1] += " " + word
    return folded


def parse_condition(text):
    """Returns a syntax tree of Python: words of the text as strings, joined by "and" and "or"."""
    words = re.sub(r"!?\w+(?:!?=[^&|()]+)?", lambda word: repr(word.group().strip()), text)
    return ast.parse(words.replace("&", "and").replace("|", "or"), mode="eval").body


def write_condition(text, mode, rows):
    """Returns the lines of decorators with a mode, all of which must hold."""
    tree = parse_condition(text)
    parts = tree.values if isinstance(tree, ast.BoolOp) and isinstance(tree.op, ast.And) else [tree]
    return [line for part in parts for line in write_decorator(part, mode, rows)]


def write_decorator(tree, mode, rows, is_inside=False):
    if isinstance(tree, ast.Constant):
        pairs = [("type", "GenericDecorator"), ("mode", mode)] + write_word(tree.value, rows)
        return element("PropertyWidgetDecorator", pairs)
    parts = [line for part in tree.values for line in write_decorator(part, mode, rows, True)]
    inside = element("Expression", [("type", type(tree.op).__name__.lower())], parts)
    if is_inside:
        return inside
    return element("PropertyWidgetDecorator", [("type", "CompositeDecorator")], inside)


def write_word(word, rows):
    name, sign, values = re.match(r"!?(\w+)(!?=)?(.*)", word).groups()
    row = rows.get(name)
    if not sign and row and row["kind"] == "switch":
        return [("property", name), ("value", 0 if word.startswith("!") else 1)]
    if not sign:
        none = [("index", 4), ("value", "None")]
        if row:
            none = [("value", "null" if row["kind"] == "arrays" else "None")]
        return [("property", name), *none] + ([] if word.startswith("!") else [("inverse", 1)])
    numbers = values.split(",")
    if row["words"]:
        numbers = [str(row["words"].index(value)) for value in numbers]
    pairs = [("property", name), ("value" if len(numbers) == 1 else "values", " ".join(numbers))]
    return pairs + ([("inverse", 1)] if sign == "!=" else [])


def range_of(row):
    """Returns the limits of a slider as attributes."""
    ends = [end for end in (row["least"], row["special"]) if end is not None]
    pairs = [("min", "%g" % min(ends))] if ends else []
    has_most = row["most"] is not None and row["most"] - row["least"] <= LONGEST_SLIDER
    return pairs + ([("max", "%g" % row["most"])] if has_most else [])


def entries(row):
    """Returns the entries of an enumeration as (number, text)."""
    if row["kind"] == "choice":
        return list(enumerate(row["words"]))
    return [(number, row["meaning"].capitalize() if number == row["special"] else number)
            for number in range(int(row["least"]), int(row["most"]) + 1)]


def domain(row):
    kind = row["kind"]
    if kind == "switch":
        return element("BooleanDomain", [("name", "bool")])
    if kind == "choice" or row["listed"]:
        lines = [line for number, text in entries(row)
                 for line in element("Entry", [("text", text), ("value", number)])]
        return element("EnumerationDomain", [("name", "enum")], lines)
    if kind in ("integer", "real"):
        tag = "IntRangeDomain" if kind == "integer" else "DoubleRangeDomain"
        return element(tag, [("name", "range")] + range_of(row))
    if kind in ("array", "arrays"):
        pairs = [("name", "array_list"),
                 ("input_domain_name", "arrays" if row["vectors"] else "scalar_arrays")]
        pairs += [("none_string", "None")] if kind == "array" else []
        return element("MeshArrayListDomain", pairs, element("RequiredProperties", [], element(
            "Property", [("name", "Input"), ("function", "Input")])))
    return element("FileListDomain", [("name", "files")]) if kind == "file" else []


def hints(row, rows, is_hidden):
    lines = []
    if row["kind"] == "file":
        lines += element("FileChooser", [("extensions", "txt csv tsv lut label xml"),
                                         ("file_description", "Names of labels")])
    if row["kind"] == "boxes":
        lines += element("ShowLabel", []) + element("ShowComponentLabels", [], [
            line for i, text in enumerate(BOX)
            for line in element("ComponentLabel", [("component", i), ("label", text)])])
    for key, mode in (("shown", "visibility"), ("enabled", "enabled_state")):
        if row[key] and not is_hidden:
            lines += write_condition(row[key], mode, rows)
    return element("Hints", [], lines) if lines else []


def commands(row):
    """Returns the attributes that set the option in the filter, and its default."""
    name, kind = row["name"], row["kind"]
    one = re.sub("(s|es)$" if kind != "boxes" else "es$", "", name)
    if kind in ("arrays", "kinds", "boxes"):
        return [("command", "Add" + one), ("clean_command", "Clear" + name), ("repeat_command", 1),
                ("number_of_elements_per_command", len(BOX) if kind == "boxes" else 1)]
    defaults = {"file": "", "array": "None", "pairs": "None", "ranges": "None",
                "widths": row["default"], "integer": row["default"], "real": row["default"]}
    return [("command", "Set%s%s" % (name, "File" if kind == "file" else "")),
            ("number_of_elements", 1), ("default_values", defaults.get(kind, row["number"]))]


def write_property(row, rows, of_tets_too=False):
    """Returns the lines of a property.

    of_tets_too: the property overrides that of hexahedra in the filter for tetrahedra.
    """
    is_hidden = of_tets_too and row["hidden_of_tets"]
    tags = {"real": "Double", "boxes": "Double", "switch": "Int", "integer": "Int", "choice": "Int"}
    tag = tags.get(row["kind"], "String")
    pairs = [("name", row["name"])]
    pairs += [("label", label(row["name"]))] if label(row["name"]) != row["name"] else []
    pairs += commands(row)
    pairs += [("panel_visibility", "never" if is_hidden else "advanced")] if row["advanced"] else []
    pairs += [("override", 1)] if of_tets_too else []
    text = row["text_of_tets"] if of_tets_too else row["text"]
    documentation = element("Documentation", [], wrap(escape(text), "", width=WIDTH - 10))
    inside = domain(row) + hints(row, rows, is_hidden) + documentation
    tag += "VectorProperty"
    start = "      <" + tag + " "
    attributes = ["%s=%s" % (name, quoteattr(str(value))) for name, value in pairs]
    return ([start + attributes[0]] + [" " * len(start) + pair for pair in attributes[1:-1]] +
            [" " * len(start) + attributes[-1] + ">"] + ["        " + line for line in inside] +
            ["      </%s>" % tag, ""])


def write_group(name, rows):
    names = FIRST.get(name, []) + [
        member for row in rows if row["group"] == name
        for member in (row["name"], *AFTER.get(row["name"], ())[:1])]
    inside = [line for n in names for line in element("Property", [("name", n)])]
    lines = element("PropertyGroup", [("label", name)], inside)
    return ["      " + line for line in lines] + [""]


def write_part(text, table, rows, overrides=()):
    """Writes the properties of rows, and their groups, into the text of a file."""
    by_name = {row["name"]: row for row in table}
    lines = [""]
    for row in rows:
        lines += write_property(row, by_name)
        lines += AFTER.get(row["name"], ("", ""))[1].split("\n")[:-1] + (
            [""] if row["name"] in AFTER else [])
    for row in overrides:
        lines += write_property(row, by_name, True)
    for name in dict.fromkeys(row["group"] for row in rows):
        lines += write_group(name, rows)
    folded = [part for line in lines[:-1] for part in fold(line)]
    return put(text, "options: generated", "end of options", folded)


def files(table):
    """Returns, for each generated file, a function that updates its text."""
    hexes = common(table)
    overrides = [row for row in hexes if row["text_of_tets"]]

    def of_groups(names):
        rows = [row for row in hexes if row["group"] in names]
        return lambda text: write_part(text, table, rows)

    rest = {row["group"] for row in hexes} - {name for part in PARTS.values() for name in part}
    return {**{"Plugin/VolumeFraction%s.xml" % part: of_groups(names)
               for part, names in PARTS.items()},
            "Plugin/VolumeFractionMesh.xml": of_groups(rest),
            "Plugin/VolumeFractionInterfaces.xml":
                lambda text: write_part(text, table, of_interfaces(table)),
            "Plugin/VolumeFractionToTet.xml":
                lambda text: write_part(text, table, of_tets(table), overrides)}
