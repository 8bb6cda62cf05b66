"""The prose of the project keeps to plain words: a limit per kind of text, for words to avoid and
for the length of sentences and lines."""
import collections
import os
import re
import sys
import unittest

from prose import CODE, read_messages, read_prose, split_sentences

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
SKIPPED = (".git", "build", "out", "__pycache__", "Data", ".mirror")
LONGEST_LINE = 100   # columns, of sources
LONGEST_SENTENCE = 35  # words
MOST_PER_1000 = 6.0  # findings in 1,000 words, of each kind of text

# Words to avoid, with what to write instead.
AVOIDED = {
    r"tell(s|ing)?|told": "report, state",
    r"those (of|that|in|on|with|whose)": "the noun again",
    r"alone": "only",
    r"alike|likewise": "equal, also",
    r"anew": "again",
    r"ask(s|ed|ing)?": "request, check",
    r"want(s|ed)?|wish(es|ed)?": "request, require",
    r"(is|are|was|were) (no|none)(?! (longer|more))": "is not",
    r"besides?": "next to, in addition",
    r"(has|have) not(?! (been|yet|\w+ed\b))": "lacks",
    r"but for|(all|none|nothing) but": "except",
    r"whole numbers?": "integer",
    r"so many|so (do|does|is|are|has|have)": "N; also",
    r"(same|other) bits|to the bit|bit for bit": "bitwise identical",
    r"drawn to|strives? for|serves?": "attracted to, target, work",
    r"refus(e|es|ed|al)": "reject",
    r"deal(s|t)|share[sd]? out|g[ia]ven? (up|away)": "distribute, exclude",
    r"mend(s|ed)?|misfits?|crumbs?|rooms?": "fix, mismatch, small fragment, module",
    r"neediest|whoever": "finest, any rank that",
    r"mine|my": "local",
    r"(one|an?|two|\d+) (?!of )\w+ an? (cell|rank|material|fragment|point|element|axis)": "per",
}
PATTERN = re.compile(r"\b(%s)\b" % "|".join(AVOIDED), re.IGNORECASE)
OPENING = re.compile(r"(What|Of|As|But)\b(?![^.]*\?)")
WORD = re.compile(r"[A-Za-z][\w'-]*")


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def kind_of(path):
    """The kind of text that a file holds; None where it is not counted."""
    if path == "Documentation/reference/options.md" or not path.endswith(
        (*CODE, ".py", ".xml", ".md")):
        return None
    if path.endswith(".md"):
        return "changelog" if path == "CHANGELOG.md" else "pages"
    if path.startswith(("Testing/", "Examples/", "scripts/", "python/tests/", "python/examples/")):
        return "tests"
    return "C++" if path.endswith(CODE) else "XML" if path.endswith(".xml") else "Python"


def list_files():
    for folder, folders, files in os.walk(ROOT):
        folders[:] = [name for name in folders if not name.startswith(SKIPPED)]
        if "CMakeCache.txt" in files:
            folders[:], files = [], []
        yield from (os.path.relpath(os.path.join(folder, name), ROOT).replace(os.sep, "/")
                    for name in files)


def find_problems(paragraph):
    """The words to avoid, and the sentences that are too long or begin without a subject."""
    problems = [match.group() for match in PATTERN.finditer(paragraph)]
    for sentence in split_sentences(paragraph):
        opening = OPENING.match(sentence)
        problems += [opening.group()] if opening and opening.group() == "What" else []
        problems += ["a sentence of %d words"
                     % len(WORD.findall(sentence))] if len(
                         WORD.findall(sentence)) > LONGEST_SENTENCE else []
    return problems


class Words(unittest.TestCase):
    def test_kinds_of_text(self):
        words, listed = collections.Counter(), collections.defaultdict(list)
        for path in filter(kind_of, list_files()):
            text, kind = read(path), kind_of(path)
            parts = {kind: list(read_prose(path, text))}
            if kind == "C++":
                parts["messages"] = [t for t in read_messages(text) if len(WORD.findall(t)) > 2]
            for name, paragraphs in parts.items():
                words[name] += sum(len(WORD.findall(paragraph)) for paragraph in paragraphs)
                listed[name] += ["%s: %s" % (path, problem) for paragraph in paragraphs
                                 for problem in find_problems(paragraph)]
        wrong = []
        for kind, count in sorted(words.items()):
            rate = 1000 * len(listed[kind]) / count
            print("%-9s %6d words, %4d findings, %.1f in 1,000"
                  % (kind, count, len(listed[kind]), rate))
            self.assertGreater(count, 1000)
            wrong += listed[kind] if rate >= MOST_PER_1000 else []
        self.assertFalse(wrong, "\n".join(wrong))

    def test_lines(self):
        long = []
        for path in list_files():
            if kind_of(path) not in (None, "pages", "changelog"):
                long += ["%s:%d" % (path, number)
                         for number, line in enumerate(read(path).split("\n"), 1)
                         if len(line) > LONGEST_LINE]
        self.assertFalse(long,
                         "lines of more than %d columns:\n%s" % (LONGEST_LINE, "\n".join(long)))


class Searches(unittest.TestCase):
    """The tests above find what they look for."""

    def test_words(self):
        for text in ("All ranks are told.", "The cells of that rank alone.", "One box a rank.",
                     "What a mesh holds.", "word " * 36):
            self.assertTrue(find_problems(text), text)
        self.assertFalse(find_problems("Returns the fragment of a cell. The mesh is not changed."))

    def test_prose_of_sources(self):
        source = ('const char* a = "// no comment"; // one\n'
                  '/// two that\n/// goes on\n/* and\n * three */')
        for path, text, expected in (
                ("a.cxx", source, ["one", "two that goes on", "and three"]),
                ("a.py", '"""One."""\nx = "# no comment"  # two\n', ["One.", "two"]),
                ("a.md", "# Title\nA `word`.\n\n| a | b |\n\n    code\n", ["a", "b", "A X."])):
            self.assertEqual(list(read_prose(path, text)), expected)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
