"""Finds the prose of the sources: comments, docstrings, help texts and paragraphs of pages."""
import ast
import io
import re
import tokenize

CODE = (".h", ".hpp", ".cxx", ".cpp", ".c")
# A string or a character is matched too, since it may contain the marks of a comment.
CXX_TOKEN = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:[^\"\\\n]|\\.)*\"|'(?:[^'\\\n]|\\.)+'", re.DOTALL)
DOXYGEN = re.compile(
    r"[@\\](?:(?:param(?:\[[a-z,]*\])?|tparam|throws) \S+|note|pre|returns?|file|brief)")

# An item of a list, or a parameter of numpydoc: "name : type".
NEW_PARAGRAPH = re.compile(r"\d+\. |[\w*, ]+ : ")


def join_lines(lines):
    """Yields the paragraphs of lines. An empty line, an item or a tag begins a new one."""
    paragraph = []
    for line in [*lines, ""]:
        line = line.strip()
        if paragraph and (not line or line.startswith(("@", "\\", "- ", "* ", "usage:"))
                          or NEW_PARAGRAPH.match(line)):
            yield " ".join(paragraph)
            paragraph = []
        if line:
            paragraph.append(re.sub(r"^(?:[-*]|\d+\.) ", "", line))


def read_cxx(text):
    """Yields the comments of C++ and C. Consecutive lines of one kind are one comment."""
    lines, last = [], (-2, "")
    for match in CXX_TOKEN.finditer(text):
        token = match.group()
        if not token.startswith("/"):
            continue
        starts_line = not text[text.rfind("\n", 0, match.start()) + 1:match.start()].strip()
        here = (text.count("\n", 0, match.start()), re.match("/[/*<]*", token).group())
        if lines and not (starts_line and here == (last[0] + 1, last[1])):
            yield from join_lines(lines)
            lines = []
        last = here
        if token.startswith("/*"):
            inside = token[2:-2].strip("*").split("\n")
            yield from join_lines(re.sub(r"^\s*\*", "", line) for line in inside)
        else:
            lines.append(token.lstrip("/").lstrip("<! "))
    yield from join_lines(lines)


def read_messages(text):
    """Yields the string literals of C++. Neighbouring literals are one."""
    last, literals = -1, []
    for match in CXX_TOKEN.finditer(text):
        if match.group().startswith('"'):
            if literals and text[last:match.start()].strip():
                yield "".join(literals)
                literals = []
            literals.append(match.group()[1:-1].replace("\\n", " ").replace('\\"', "'"))
            last = match.end()
    yield "".join(literals)


def read_python(text):
    """Yields the docstrings and comments of Python."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node,
                      (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node):
            prose = re.sub(r"^\s*(>>>|\.\.\.).*$|^-+$", "", ast.get_docstring(node),
                           flags=re.MULTILINE)
            yield from join_lines(prose.split("\n"))
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            yield token.string.lstrip("#! ")


def read_xml(text):
    """Yields the help texts of properties and proxies."""
    for help_text in re.findall(r"<Documentation[^>]*>(.*?)</Documentation>", text, re.DOTALL):
        yield from join_lines(re.sub(r"<[^>]+>", " ", help_text).split("\n"))


def read_markdown(text):
    """Yields paragraphs, list items and cells of tables, without code and addresses."""
    text = re.sub(r"^```.*?^```|^ {4}.*?$", "", text, flags=re.DOTALL | re.MULTILINE)
    text = re.sub(r"`[^`\n]+`", "X", re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text))
    for line in re.findall(r"^\|.*$", text, re.MULTILINE):
        yield from (cell.strip() for cell in line.strip("|").split("|"))
    yield from join_lines(line for line in text.split("\n") if not line.startswith(("|", "#", "[")))


def read_prose(path, text):
    """Yields all prose of a file, as paragraphs."""
    if path.endswith(CODE):
        found = read_cxx(text)
    else:
        found = {"py": read_python, "xml": read_xml,
                 "md": read_markdown}[path.rsplit(".", 1)[1]](text)
    yield from (DOXYGEN.sub("", paragraph) for paragraph in found)


def split_sentences(paragraph):
    return re.split(r"(?<=[.!?])\s+(?=[A-Z(*'\"])", paragraph)
