"""Prints the slowest tests of a run of ctest, and the total time.

usage: slowest_tests.py FILE [COUNT]      FILE: written by ctest --output-junit
"""
import sys
import xml.etree.ElementTree as ElementTree


def main(path, count="20"):
    seconds = {case.get("name"): float(case.get("time"))
               for case in ElementTree.parse(path).getroot().iter("testcase")}
    slowest = sorted(seconds, key=seconds.get, reverse=True)[:int(count)]
    print("Slowest of %d tests, %.0f s in all:" % (len(seconds), sum(seconds.values())))
    for name in slowest:
        print("%8.1f s  %s" % (seconds[name], name))


main(*sys.argv[1:])
