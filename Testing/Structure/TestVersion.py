"""The version of project() is also in the changelog, the citation and the configured files."""
import os
import re
import sys
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
CONFIGURED = sys.argv.pop()  # sculptor.pc of the build
NUMBER = r"(\d+\.\d+\.\d+)"


def find_all(pattern, path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return re.findall(pattern, file.read(), re.MULTILINE)


class Version(unittest.TestCase):
    def setUp(self):
        self.version, = find_all(r"^project\(VolumeFractionMesh VERSION %s " % NUMBER,
                                 "CMakeLists.txt")

    def test_citation(self):
        self.assertEqual(find_all(r"^version: %s$" % NUMBER, "CITATION.cff"), [self.version])

    def test_changelog(self):
        versions = find_all(r"^## \[%s\] - (?:unreleased|\d{4}-\d\d-\d\d)$" % NUMBER,
                            "CHANGELOG.md")
        self.assertEqual(len(versions), len(find_all(r"^## ", "CHANGELOG.md")),
                         "a heading is not a version")
        self.assertEqual(versions[0], self.version)
        steps = [tuple(map(int, version.split("."))) for version in versions]
        self.assertEqual(steps, sorted(set(steps), reverse=True))

    def test_pkg_config(self):
        self.assertEqual(find_all(r"^Version: %s$" % NUMBER, CONFIGURED), [self.version])


unittest.main()
