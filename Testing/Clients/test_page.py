"""Tests the page of recipes: its mesh is the case, and each recipe is run by a test."""

import os
import re

import numpy as np

from ball_in_block import PAGE

HERE = os.path.dirname(os.path.abspath(__file__))


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def test_mesh(hexes):
    names = {}
    exec(re.search(r"```python\n(.*?)```", read(PAGE), re.DOTALL)[1], names)
    assert np.array_equal(names["mesh"].points, hexes.points)
    assert np.array_equal(names["mesh"].cells, hexes.cells)


def test_every_recipe_is_run():
    tests = "".join(read(os.path.join(HERE, name)) for name in os.listdir(HERE)
                    if name.startswith("test_"))
    sections = re.split(r"^## ", read(PAGE), flags=re.MULTILINE)[1:]
    clients = [section.split("\n", 1)[0] for section in sections if "```" in section]
    assert len(clients) > 5
    assert not [client for client in clients if not re.search(
        r'\b(?:run_recipe|recipe)\("%s"' % re.escape(client), tests)]


def test_sections_are_sorted():
    clients = re.findall(r"^## (.*)$", read(PAGE), re.MULTILINE)
    assert clients == sorted(clients, key=str.lower)
