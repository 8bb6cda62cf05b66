"""Documentation/user/command-line.md shows the tables that sculptor prints, except for seconds:
numbers agree to 2 % of their range."""
import os
import re
import sys

from sculptor_program import sculptor
from vfmtest import in_folder, main

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
sys.path.insert(0, os.path.join(ROOT, "scripts"))
import printed
COMMANDS = [  # ranks and arguments of the blocks of the page, in order
    (4, "--input Data/splash_3500us.vti --output splash.pvtu"),
    (1, "--input Data/ball_and_plate.vti --tetmesh Lattice --output tets.vtu"),
    (1, "Data/impact.spcth impact.e --step 2 --velocity velocity --state-transfer conserve "
        "--nodal-velocity"),
    (1, "--list Data/impact.spcth"),
    (1, "--list Data/AMReX/plt00000")]


def with_seconds(text, line):
    return re.sub(r"^seconds: .*$", line, text, flags=re.MULTILINE)


def without_seconds(text):
    return with_seconds(text, "").strip()


@in_folder
def test_page(at):
    path = os.path.join(ROOT, "Documentation", "user", "command-line.md")
    with open(path, encoding="utf-8") as file:
        blocks = re.findall(r"^```\n(.*?)^```$", file.read(), re.DOTALL | re.MULTILINE)
    assert len(blocks) == len(COMMANDS), blocks
    os.symlink(os.path.join(ROOT, "Data"), at("Data"))
    for block, (ranks, words) in zip(blocks, COMMANDS):
        result = sculptor(*words.split(), ranks=ranks, folder=at(""))
        assert result.returncode == 0, result
        lines = result.stdout.splitlines(keepends=True)
        count = block.count("\n")
        found = ["".join(lines[i:i + count]) for i in range(len(lines) - count + 1)]
        shown = without_seconds(block)
        if any(printed.is_equal(shown, without_seconds(text)) for text in found):
            continue
        same = [text for text in found if text.split(None, 1)[0:1] == block.split(None, 1)[0:1]]
        assert printed.accepts() and same, result.stdout
        seconds = re.search(r"^seconds: .*$", block, re.MULTILINE)
        printed.replace_in(path, block, with_seconds(same[0], seconds[0]) if seconds else same[0])


main(globals())
