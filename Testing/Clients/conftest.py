"""Meshes of the case, and a table of the clients at the end."""

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


def pytest_terminal_summary(terminalreporter):
    """Prints a row per client: the numbers of its tests, and why tests were skipped."""
    rows = {}
    for outcome in ("passed", "skipped", "failed", "error"):
        for report in terminalreporter.stats.get(outcome, ()):
            file = os.path.basename(report.nodeid.split("::")[0])
            row = rows.setdefault(file[len("test_"):-len(".py")], {})
            row[outcome] = row.get(outcome, 0) + 1
            if outcome == "skipped":
                row.setdefault("reasons", set()).add(find_reason(report).replace("Skipped: ", ""))
    terminalreporter.section("clients")
    line = "%-18s %6s %7s %6s  %s"
    terminalreporter.write_line(line % ("client", "passed", "skipped", "failed", "reason"))
    for client, row in sorted(rows.items()):
        terminalreporter.write_line((line % (
            client, row.get("passed", 0), row.get("skipped", 0),
            row.get("failed", 0) + row.get("error", 0),
            "; ".join(sorted(row.get("reasons", ()))))).rstrip())
