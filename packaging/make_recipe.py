"""Makes the recipe of conda-forge from an sdist, and checks it by rattler-build if py-rattler-build
is installed: python packaging/make_recipe.py SDIST FOLDER [MAINTAINER]

MAINTAINER is the account on GitHub that conda-forge asks about the recipe.
"""
import email
import hashlib
import os
import re
import sys
import tarfile

TEMPLATE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "recipe.yaml.in")
PYPI = "https://pypi.org/project/%s"


def read_metadata(sdist):
    """Returns the metadata of an sdist, as PyPI reads them."""
    with tarfile.open(sdist) as archive:
        names = [name for name in archive.getnames() if re.fullmatch(r"[^/]+/PKG-INFO", name)]
        if len(names) != 1:
            raise SystemExit("%s is no sdist: it has no PKG-INFO." % sdist)
        return email.message_from_binary_file(archive.extractfile(names[0]))


def find_homepage(metadata):
    """Returns the repository of the metadata, or else the page of PyPI."""
    urls = dict(url.split(", ", 1) for url in metadata.get_all("Project-URL", []))
    return urls.get("Repository", PYPI % metadata["Name"])


def make_recipe(sdist, maintainer):
    """Returns the text of the recipe."""
    metadata = read_metadata(sdist)
    with open(sdist, "rb") as file:
        digest = hashlib.sha256(file.read()).hexdigest()
    values = {
        "version": metadata["Version"], "sha256": digest, "homepage": find_homepage(metadata),
        "summary": metadata["Summary"], "license": metadata["License-Expression"],
        "maintainer": maintainer}
    with open(TEMPLATE, encoding="utf-8") as file:
        text = file.read()
    return re.sub(r"@(\w+)@", lambda match: values[match[1]], text)


def check_recipe(text):
    """Renders the recipe for Linux. Returns the names of the packages, or None without
    rattler-build."""
    try:
        import rattler_build
    except ImportError:
        return None
    variants = rattler_build.VariantConfig.from_yaml(
        "c_compiler: [gcc]\ncxx_compiler: [gxx]\nc_stdlib: [sysroot]\npython: ['3.12.*']\n")
    rendered = rattler_build.Stage0Recipe.from_yaml(text).render(variants)
    return [str(variant.recipe.package.name) for variant in rendered]


def main(sdist, folder, maintainer="MAINTAINER"):
    text = make_recipe(sdist, maintainer)
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, "recipe.yaml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    names = check_recipe(text)
    print(path + ": " + ("not checked, py-rattler-build is not installed" if names is None
                         else "rattler-build accepts " + ", ".join(names)))


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        raise SystemExit(__doc__)
    main(*sys.argv[1:])
