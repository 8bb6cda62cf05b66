"""Tests that the examples run and print a mesh."""

import os
import shutil
import subprocess
import sys

import pytest

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "examples")
SCREEN = [shutil.which("xvfb-run"),
          "-a"] if shutil.which("xvfb-run") and not os.environ.get("DISPLAY") else []


@pytest.mark.parametrize(
    "name", sorted(name for name in os.listdir(EXAMPLES) if name.endswith(".py"))
    if os.path.isdir(EXAMPLES) else []
)
def test_example(name, tmp_path):
    pytest.importorskip("pyvista")
    picture = tmp_path / "picture.png"
    run = subprocess.run(
        [*SCREEN, sys.executable, os.path.join(EXAMPLES, name), "--picture", str(picture)],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert run.returncode == 0, run.stderr
    assert "hexahedra" in run.stdout and picture.stat().st_size > 5000
