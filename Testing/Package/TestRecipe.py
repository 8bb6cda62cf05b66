"""packaging/make_recipe.py fills the recipe of conda-forge in, from the metadata of an sdist."""
import hashlib
import io
import os
import re
import sys
import tarfile
import tempfile
import tomllib
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.append(os.path.join(ROOT, "packaging"))
import make_recipe

METADATA = """Metadata-Version: 2.4
Name: volume-fraction-mesh
Version: 1.2.3
Summary: Meshes
License-Expression: BSD-3-Clause
%s
Text
"""


def make_sdist(folder, urls=""):
    """Returns the path of an archive that has only metadata."""
    path, text = os.path.join(folder, "sdist.tar.gz"), (METADATA % urls).encode()
    with tarfile.open(path, "w:gz") as archive:
        member = tarfile.TarInfo("volume_fraction_mesh-1.2.3/PKG-INFO")
        member.size = len(text)
        archive.addfile(member, io.BytesIO(text))
    return path


class Recipe(unittest.TestCase):
    def setUp(self):
        with tempfile.TemporaryDirectory() as folder:
            sdist = make_sdist(folder)
            with open(sdist, "rb") as file:
                self.digest = hashlib.sha256(file.read()).hexdigest()
            self.text = make_recipe.make_recipe(sdist, "somebody")
        with open(os.path.join(ROOT, "pyproject.toml"), "rb") as file:
            self.project = tomllib.load(file)

    def test_values(self):
        self.assertNotIn("@", self.text.replace("between @", ""))
        for line in ('version: "1.2.3"', "sha256: " + self.digest, "license: BSD-3-Clause",
                     "homepage: https://pypi.org/project/volume-fraction-mesh", "- somebody"):
            self.assertIn(line + "\n", self.text)

    def test_repository(self):
        with tempfile.TemporaryDirectory() as folder:
            sdist = make_sdist(folder, "Project-URL: Repository, https://example.org/mesh\n")
            self.assertIn("homepage: https://example.org/mesh\n",
                          make_recipe.make_recipe(sdist, "somebody"))

    def test_requirements(self):
        """Those of building and of running, and the command, are those of pyproject.toml."""
        host, run = re.search(r"  host:\n(.*?)  run:\n(.*?)\n\n", self.text, re.DOTALL).groups()
        project = self.project["project"]
        for name in self.project["build-system"]["requires"]:
            if not name.startswith("cmeel-eigen"):  # eigen of conda-forge
                self.assertIn("- %s\n" % name.replace(">", " >", 1), host)
        self.assertEqual(re.findall(r"- (.*)", run), ["python", *project["dependencies"]])
        for command in project["scripts"].items():
            self.assertIn("- %s = %s\n" % command, self.text)

    def test_no_sdist(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "empty.tar.gz")
            tarfile.open(path, "w:gz").close()
            with self.assertRaisesRegex(SystemExit, "is no sdist"):
                make_recipe.read_metadata(path)


unittest.main()
