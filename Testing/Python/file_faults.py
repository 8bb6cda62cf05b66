"""Runs programs that a signal, or a full disk, interrupts at a call that changes a file.

VFM_FILE_FAULTS is the library of Testing/Program/FileFaults.cxx. Afterwards each output, which may
consist of several files, must be the earlier one or the new one, and there must be no other file.
"""
import glob
import os
import re
import shutil
import signal
import time

from mpi_run import mpi_run

SIGNALS = (signal.SIGTERM, signal.SIGINT, signal.SIGHUP)
KILL = signal.SIGKILL  # no program can handle it
FULL = 0  # a full disk instead of a signal
# Dates of Exodus files.
DATES = re.compile(rb"\d\d/\d\d/\d{2,4}|\d\d:\d\d:\d\d")


def read_tree(folder):
    """Returns {path: content} of all files; dates of Exodus files are left out."""
    tree = {}
    for place, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(place, name)
            with open(path, "rb") as file:
                tree[os.path.relpath(path, folder)] = DATES.sub(b"", file.read())
    return tree


def part_of(tree, pattern):
    return {path: data for path, data in tree.items() if re.fullmatch(pattern, path)}


class Case:
    """A command that writes outputs into a folder.

    old, new: functions that return the command for an output folder; they write different content.
    outputs: a pattern of paths for each output. line: message of a signal of that name.
    """

    def __init__(self, at, old, new, outputs, ranks=1, line="%s"):
        self.folder, self.kept, self.log = at("out"), at("kept"), at("log")
        self.new, self.outputs, self.ranks, self.line = new, outputs, ranks, line
        self.trees, self.calls = [], {}
        for make in (old, new):
            self.restore(False)
            result = mpi_run(ranks, make(self.folder))
            assert result.returncode == 0, result
            self.trees.append(read_tree(self.folder))
            if make is old:
                shutil.rmtree(self.kept, ignore_errors=True)
                shutil.copytree(self.folder, self.kept)
        for tree in self.trees:
            assert all(part_of(tree, pattern) for pattern in outputs), tree.keys()
        assert all(part_of(self.trees[0], pattern) != part_of(self.trees[1], pattern)
                   for pattern in outputs), "no difference"

    def restore(self, has_old):
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.copytree(self.kept, self.folder) if has_old else os.mkdir(self.folder)

    def run(self, rank, **faults):
        """Runs the command with settings of FileFaults.cxx; `rank` counts the calls."""
        preload = ":".join(filter(None, (os.environ["VFM_FILE_FAULTS"],
                                         os.environ.get("LD_PRELOAD"))))
        settings = {"VFM_" + name.upper(): str(value) for name, value in faults.items()}
        if self.ranks > 1:
            settings["VFM_FAULT_RANK"] = str(rank)
        return mpi_run(self.ranks, self.new(self.folder), LD_PRELOAD=preload,
                       OMPI_MCA_odls_base_sigkill_timeout="3",
                       VFM_FAULT_FOLDER=self.folder, **settings)

    def list_calls(self, rank, has_old):
        """Returns the names of the calls that change files, in their order."""
        if (rank, has_old) not in self.calls:
            self.calls[rank, has_old] = self.log_calls(rank, has_old)
        return self.calls[rank, has_old]

    def log_calls(self, rank, has_old):
        self.restore(has_old)
        if os.path.exists(self.log):
            os.remove(self.log)
        result = self.run(rank, fault_log=self.log)
        assert result.returncode == 0, result
        if not os.path.exists(self.log):
            return []  # a rank that writes nothing
        with open(self.log, encoding="utf-8") as file:
            return [line.split()[0] for line in file]

    def wait_for_ranks(self):
        """Waits until all ranks have ended: some outlive mpiexec, and remove their files."""
        def runs(path):
            try:
                with open(path, "rb") as file:
                    return os.fsencode(self.folder) in file.read()
            except OSError:  # ended meanwhile
                return False

        end = time.monotonic() + 60
        while any(runs(path) for path in glob.glob("/proc/[0-9]*/cmdline")):
            assert time.monotonic() < end, "ranks do not end"
            time.sleep(0.02)

    def interrupt(self, fault, rank, call, has_old, parent=False):
        """Interrupts the command at a call. Returns "old" or "new"; mixed for several outputs."""
        self.restore(has_old)
        result = self.run(rank, fault=int(fault), fault_at=call, fault_parent=int(parent))
        self.wait_for_ranks()
        found = read_tree(self.folder)
        states = []
        for pattern in self.outputs:
            trees = ({} if not has_old else self.trees[0]), self.trees[1]
            same = [part_of(found, pattern) == part_of(tree, pattern) for tree in trees]
            assert any(same), (pattern, call, sorted(found), result)
            states.append("old" if same[0] else "new")
            found = {path: data for path, data in found.items() if not re.fullmatch(pattern, path)}
        assert not found, (call, sorted(found), result)
        self.check_end(fault, result, parent, set(states) == {"new"})
        return states[0] if len(set(states)) == 1 else "some"

    def check_end(self, fault, result, parent, is_whole):
        """Checks the exit status and the message."""
        lines = [line for line in result.stderr.splitlines() if not line.startswith("[warn]")]
        if fault == FULL and result.returncode == 0:
            assert is_whole and not lines, result
        elif fault == FULL:
            assert result.returncode != 0 and len(lines) == 1, result
            assert "No space left on device" in lines[0], result
        elif self.ranks == 1 and not (result.returncode == 0 and is_whole):
            assert result.returncode == -fault, result
            expected = [] if fault == KILL else [self.line % signal.Signals(fault).name]
            assert lines == expected, result
        elif result.returncode == 0:
            assert is_whole, result
        else:
            assert parent or result.returncode == 128 + fault, result
            names = ("SIGTERM", signal.Signals(fault).name)  # mpiexec sends SIGTERM
            assert len(lines) <= 1 and {*lines} <= {self.line % name for name in names}, result


def choose_moments(calls, count):
    """Returns numbers of calls, spread over all; renames are preferred."""
    renames = [number for number, call in enumerate(calls, 1) if call == "rename"]
    spread = {1 + (len(calls) - 1) * i // max(count - 1, 1) for i in range(count)}
    chosen = sorted(spread)
    for rename in (renames[:1] + renames[-1:])[:count - 1]:
        if rename not in chosen:
            nearest = min(chosen, key=lambda number: abs(number - rename))
            chosen[chosen.index(nearest)] = rename
    return sorted(set(chosen))


def interrupt_all(name, case, faults, count):
    """Interrupts a case at `count` moments per fault; prints a row of outcomes per fault."""
    wrong = 0
    for fault in faults:
        counts = {"old": 0, "new": 0, "some": 0, "wrong": 0}
        for turn in range(count):
            has_old = turn % 5 != 1
            rank = turn % case.ranks if case.list_calls(turn % case.ranks, has_old) else 0
            calls = case.list_calls(rank, has_old)
            if fault == FULL:
                calls = calls[:1 + max(at for at, call in enumerate(calls) if call == "fsync")]
            elif fault == KILL:
                calls = calls[:1 + calls.index("linkat")]  # until files have names
            moments = choose_moments(calls, count)
            try:
                outcome = case.interrupt(fault, rank, moments[turn % len(moments)], has_old,
                                         parent=case.ranks > 1 and turn % 2 == 1
                                         and fault not in (FULL, KILL))  # ranks outlive mpiexec
            except AssertionError as error:
                print("call %d: %s" % (moments[turn % len(moments)], error))
                outcome = "wrong"
            counts[outcome] += 1
        print("%-14s %d ranks  %-8s moments %3d  earlier %3d  new %3d  some of several outputs %3d"
              "  wrong %d"
              % (name, case.ranks, "full" if fault == FULL else fault.name, count,
                 counts["old"], counts["new"], counts["some"], counts["wrong"]), flush=True)
        wrong += counts["wrong"]
    assert wrong == 0, name
