"""Generates the accessors of options in the headers of the filters."""
from options.table import common, of_interfaces, of_tets, put, wrap

MACROS = {"switch": "vfmSwitchOption(%s)", "integer": "vfmNumberOption(%s, int)",
          "choice": "vfmNumberOption(%s, int)",
          "real": "vfmNumberOption(%s, double)", "array": "vfmTextOption(%s)",
          "pairs": "vfmTextOption(%s)", "ranges": "vfmTextOption(%s)",
          "widths": "vfmTextOption(%s)", "sizes": "vfmTextOption(%s)"}


def write_accessors(text, rows):
    lines = []
    for row in rows:
        if row["kind"] in MACROS:  # methods for files, lists and boxes are written by hand
            text_of_row = "%(text)s Allowed: %(allowed)s; default %(default)s." % row
            lines += wrap(text_of_row, "  /// ")
            lines.append("  " + MACROS[row["kind"]] % row["name"] + ";")
    return put(text, "// options: generated", "// end of options", lines)


def files(table):
    """Returns, for each generated file, a function that updates its text."""
    return {"Filters/vtkVolumeFractionMeshAlgorithm.h":
                lambda text: write_accessors(text, common(table)),
            "Filters/vtkVolumeFractionInterfaces.h":
                lambda text: write_accessors(text, of_interfaces(table)),
            "Filters/vtkVolumeFractionToTet.h": lambda text: write_accessors(text, of_tets(table))}
