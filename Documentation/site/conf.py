"""Sphinx builds the site from the pages of the repository; scripts/docs calls it with the root of
the repository as source."""
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))


def read(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as file:
        return file.read()


project = "VolumeFractionMesh"
author = "The VolumeFractionMesh developers"
version = release = re.search(r"project\(VolumeFractionMesh VERSION ([\d.]+)",
                              read("CMakeLists.txt")).group(1)

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.viewcode"]
root_doc = "README"
include_patterns = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "Data/README.md",
                    "python/README.md", "Documentation/**.md", "Documentation/site/*.rst"]
exclude_patterns = ["build*", "out", "Testing", "Examples", "Grid", ".git"]
myst_heading_anchors = 4
myst_enable_extensions = ["dollarmath"]
myst_links_external_new_tab = True
autodoc_member_order = "bysource"
autodoc_typehints = "none"  # the docstrings give the types
napoleon_google_docstring = False
napoleon_use_ivar = True

html_theme = "pydata_sphinx_theme"
html_title = "%s %s" % (project, version)
html_show_sourcelink = False
html_extra_path = [os.environ["VFM_SITE_EXTRA"]] if "VFM_SITE_EXTRA" in os.environ else []
templates_path = ["templates"]
html_static_path = ["static"]
html_css_files = ["site.css"]
html_sidebars = {"**": ["pages.html"]}
html_theme_options = {"navbar_center": [], "navbar_persistent": ["search-button-field"],
                      "show_prev_next": False, "secondary_sidebar_items": ["page-toc"],
                      "footer_end": []}

# The sections of the sidebar: a caption, and the pages in their order.
SECTIONS = (
    ("User guide", "Documentation/user",
     ("install", "tutorial", "examples", "choosing", "paraview", "command-line",
                                          "simulation", "labels", "refined-grids", "sharp-edges",
                                          "state")),
    ("Reference", "Documentation/reference",
     ("options", "files", "mesh-data", "messages", "limits")),
    ("Programming interfaces", "Documentation/site", ("python-api", "cxx-api")),
    ("Theory", "Documentation/theory",
     ("algorithm", "refined-grids", "state-transfer", "parallel", "papers")),
    ("Validation", "Documentation/validation", ()),
    ("Maintainer", "Documentation/maintainer", ("code-structure", "tested-versions", "glossary")),
)
OTHER_PAGES = ("Documentation/site/scenes", "Documentation/README", "python/README", "Data/README",
               "CONTRIBUTING", "CHANGELOG")


def list_pages(folder, first):
    """The pages of a folder: first the named ones, then all others by name."""
    names = sorted(os.path.splitext(name)[0] for name in os.listdir(os.path.join(ROOT, folder))
                   if name.endswith(".md"))
    return ["/%s/%s" % (folder, name)
            for name in [*first, *(name for name in names if name not in first)]]


def make_toctree(caption, pages):
    return "\n```{toctree}\n:hidden:\n:caption: %s\n\n%s\n```\n" % (caption, "\n".join(pages))


def add_toctrees(app, docname, source):
    """Appends the table of contents to the first page: pages in the repository stay plain
    Markdown."""
    if docname == root_doc:
        for caption, folder, first in SECTIONS:
            source[0] += make_toctree(caption, list_pages(folder, first))
        source[0] += make_toctree("More", ["/" + page for page in OTHER_PAGES])


def setup(app):
    app.connect("source-read", add_toctrees)
