"""Meshes of the case, and a table of the clients at the end."""

import json
import os

import pytest

from ball_in_block import make_mesh


@pytest.fixture(scope="session", params=["hexes", "tets"])
def mesh(request):
    """The ball in a block as hexahedra and as tetrahedra (Lattice)."""
    return make_mesh(request.param)


@pytest.fixture(scope="session")
def hexes():
    return make_mesh("hexes")


@pytest.fixture(scope="session")
def tets():
    return make_mesh("tets")


def find_reason(report):
    """Returns why a test was skipped."""
    where = report.longrepr
    return where[2] if isinstance(where, tuple) else str(where)


def gather_rows(stats):
    """Returns {client: {outcome: number, "reasons": list}}."""
    rows = {}
    for outcome in ("passed", "skipped", "failed", "error"):
        for report in stats.get(outcome, ()):
            file = os.path.basename(report.nodeid.split("::")[0])
            row = rows.setdefault(file[len("test_"):-len(".py")], {"reasons": []})
            row[outcome] = row.get(outcome, 0) + 1
            reason = find_reason(report).replace("Skipped: ", "") if outcome == "skipped" else ""
            if reason and reason not in row["reasons"]:
                row["reasons"].append(reason)
    return rows


def pytest_terminal_summary(terminalreporter):
    """Prints a row per client: the numbers of its tests, and why tests were skipped.

    The file VFM_CLIENTS keeps the rows, so that the table of a second run has those of the first.
    """
    rows, kept = gather_rows(terminalreporter.stats), os.environ.get("VFM_CLIENTS")
    if kept and os.path.exists(kept):
        with open(kept, encoding="utf-8") as file:
            rows = {**json.load(file), **rows}
    if kept:
        with open(kept, "w", encoding="utf-8") as file:
            json.dump(rows, file)
    terminalreporter.section("clients")
    line = "%-18s %6s %7s %6s  %s"
    terminalreporter.write_line(line % ("client", "passed", "skipped", "failed", "reason"))
    for client, row in sorted(rows.items()):
        terminalreporter.write_line((line % (
            client, row.get("passed", 0), row.get("skipped", 0),
            row.get("failed", 0) + row.get("error", 0), "; ".join(row["reasons"]))).rstrip())
