"""Compares two builds of the benchmark Speed by alternating runs.

usage: compare_speed.py BEFORE AFTER RUNS [CASE ...]
"""
import math
import statistics
import subprocess
import sys

COLUMNS = ('threads ranks elements seconds cpu speed min mean largest rms points sweeps visits '
           'peak fragments off material bytes memory').split()


def list_cases(program):
    return subprocess.run([program, 'list'], check=True, capture_output=True,
                          text=True).stdout.split()


def measure(program, case):
    """Runs a case once and returns the row that the program prints, by column."""
    lines = subprocess.run([program, case, '1'], check=True, capture_output=True,
                           text=True).stdout.splitlines()
    row = next(line for line in lines if line.startswith(f'| {case} |'))
    return dict(zip(COLUMNS, map(float, row.split('|')[2:-1])))


def compare(before, after, runs, case):
    """Prints a row for a case: values of the fastest run of each build, and the median ratio of CPU
    times of successive runs."""
    pairs = [(measure(before, case), measure(after, case)) for _ in range(runs)]
    ratio = statistics.median(b['cpu'] / a['cpu'] for b, a in pairs)
    old, new = (min((pair[i] for pair in pairs), key=lambda row: row['seconds']) for i in (0, 1))

    def both(key, digits):
        return f'{old.get(key, math.nan):.{digits}f} -> {new[key]:.{digits}f}'

    print('|', ' | '.join([
        case, both('seconds', 3), f'{ratio:.2f}', both('speed', 0), both('sweeps', 0),
        both('visits', 1), both('min', 3), both('mean', 4), both('largest', 3), both('rms', 5),
        both('peak', 0), both('memory', 1), both('off', 0)]), '|', flush=True)


def main():
    before, after, runs, *cases = sys.argv[1:]
    print('| case | seconds | ratio | elements/s | sweeps | visits per point | SJ min | SJ mean '
          '| distance max | rms | peak MB | memory | off |\n|' + '---|' * 13)
    for case in cases or list_cases(after):
        compare(before, after, int(runs), case)


if __name__ == '__main__':
    main()
