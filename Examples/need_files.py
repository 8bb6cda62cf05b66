"""Check of scripts before they start: a missing file ends the script with one message and exit
status 1."""
import os
import sys


def need_files(*paths):
    for path in paths:
        if not os.path.exists(path):
            sys.exit("%s: %s: no such file" % (os.path.basename(sys.argv[0]), path))
