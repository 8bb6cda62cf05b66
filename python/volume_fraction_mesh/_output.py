"""Files that are written beside their names, and replace the files of these names when whole."""

from __future__ import annotations

import os
import shutil
import signal
import stat
import tempfile
import threading
from contextlib import ExitStack, contextmanager, suppress
from typing import Any, Callable, Iterator, List, Mapping, Optional, Sequence, Tuple

SIGNALS = (signal.SIGTERM, signal.SIGINT, signal.SIGHUP)  # they end a program
MAXIMUM_LINKS = 40  # as in Linux
FIRST_STATUS = 128  # as in shells: the exit status of signal 0
_endings: List[Callable[[], Any]] = []  # called before a signal ends the program


def find_conflict(outputs: Mapping[str, str], inputs: Sequence[Tuple[str, str]]) -> str:
    """Returns the message for an output that would replace an input or another output, or "".

    outputs: paths of files by the words that name them, such as "--report". inputs: words and paths
    of files that are read.
    """
    earlier = list(inputs)
    for name, path in outputs.items():
        if not _is_written_in_place(path):
            for other, used in earlier:
                if _is_same_file(path, used):
                    return "The %s %s is the same file as the %s %s: every output needs its own " \
                           "name." % (name, path, other, used)
            earlier.append((name, path))
    return ""


def _is_same_file(one: str, other: str) -> bool:
    with suppress(OSError):
        if os.path.samefile(one, other):
            return True
    return os.path.realpath(one) == os.path.realpath(other)


@contextmanager
def whole_file(path: str) -> Iterator[str]:
    """Gives a path in a new folder next to the file. At the end of the block, the files in the
    folder replace files of their names, the file of the path last; after an error they are
    removed. The target of a link is replaced. Devices and pipes are written in place."""
    target = _follow_links(path)
    folder = os.path.dirname(target) or "."
    if _is_written_in_place(target):
        yield path
        return
    if not os.access(folder, os.W_OK | os.X_OK):
        problem = "Permission denied" if os.path.isdir(folder) else "No such file or directory"
        raise OSError("Cannot write the output %s: %s." % (path, problem))
    if os.path.exists(target) and not os.access(target, os.W_OK):
        raise OSError("Cannot write the output %s: Permission denied." % path)
    with temporary_folder(prefix=".unfinished-", place=folder) as unfinished:
        # Files name each other by the name that is given, which is also the name of a link.
        yield os.path.join(unfinished, os.path.basename(path))
        names = sorted(os.listdir(unfinished), key=lambda name: name == os.path.basename(path))
        finals = [target if name == os.path.basename(path) else os.path.join(folder, name)
                  for name in names]
        for name, final in zip(names, finals):
            _finish(os.path.join(unfinished, name), final)
        with _postponed_signals():
            for name, final in zip(names, finals):
                os.replace(os.path.join(unfinished, name), final)


@contextmanager
def temporary_folder(prefix: str = "vfm-", place: Optional[str] = None) -> Iterator[str]:
    """Gives a new folder in a place, by default that of temporary files. It is removed at the end
    of the block, also if a signal ends the program in it."""
    with ExitStack() as stack:
        with _postponed_signals():
            folder = tempfile.mkdtemp(prefix=prefix, dir=place)
            stack.enter_context(at_ending(lambda: shutil.rmtree(folder, ignore_errors=True)))
            stack.callback(shutil.rmtree, folder, ignore_errors=True)
        yield folder


@contextmanager
def at_ending(function: Callable[[], Any]) -> Iterator[None]:
    """Calls a function if a signal ends the program in the block."""
    _endings.append(function)
    try:
        yield
    finally:
        _endings.remove(function)


def _follow_links(path: str) -> str:
    """Returns the path at the end of symbolic links, which need not exist."""
    for _ in range(MAXIMUM_LINKS):
        if not os.path.islink(path) or path.startswith(("/proc/", "/dev/fd/")):
            break
        path = os.path.join(os.path.dirname(path), os.readlink(path))
    return path


def _is_written_in_place(path: str) -> bool:
    if path.startswith(("/proc/", "/dev/fd/")):  # an open file, such as /dev/stdout
        return True
    try:
        mode = os.stat(path).st_mode
    except OSError:
        return False
    return not stat.S_ISREG(mode) and not stat.S_ISDIR(mode)


def _finish(path: str, final: str) -> None:
    """Stores a file on the disk, with owner and permissions of the file that it replaces."""
    if os.path.isfile(final):
        old = os.stat(final)
        try:
            os.chown(path, old.st_uid, old.st_gid)
            shutil.copymode(final, path)
        except PermissionError:
            pass  # the file of another user
    with open(path, "rb") as file:
        os.fsync(file.fileno())


@contextmanager
def _postponed_signals() -> Iterator[None]:
    """Calls the handlers of signals, such as of Ctrl-C, only at the end of the block."""
    arrived: List[int] = []
    handlers: Any = {}
    if threading.current_thread() is threading.main_thread():
        handlers = {number: signal.getsignal(number) for number in SIGNALS
                    if callable(signal.getsignal(number))}
    try:
        for number in handlers:
            signal.signal(number, lambda number, _: arrived.append(number))
        yield
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)
    for number in arrived:
        handlers[number](number, None)


@contextmanager
def ended_by_signals(program: str) -> Iterator[None]:
    """Ends the process by a signal that arrives in the block, after its unfinished files are
    removed, with a line on standard error. Signals that are ignored stay ignored.

    The handler raises no exception: extensions such as VTK crash if one arrives in a call of theirs
    to Python.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    handlers = {number: signal.getsignal(number) for number in SIGNALS
                if signal.getsignal(number) != signal.SIG_IGN}
    with ExitStack() as stack:
        errors = -1  # standard error, of which readers discard what libraries write
        with suppress(OSError):  # there is no standard error
            errors = os.dup(2)
            stack.callback(os.close, errors)

        def end(number: int, _: Any) -> None:
            for each in handlers:
                signal.signal(each, signal.SIG_IGN)
            _end(program, number, errors)

        for number, handler in handlers.items():
            stack.callback(signal.signal, number, handler)
            signal.signal(number, end)
        yield


def _end(program: str, number: int, errors: int) -> None:
    """Ends the process by a signal. errors: the file for the message."""
    for ending in reversed(_endings):
        with suppress(Exception):
            ending()
    line = "%s: ended by %s; unfinished files are removed.\n" % (
        program, signal.Signals(number).name)
    with suppress(OSError):
        os.write(errors, line.encode())
    signal.signal(number, signal.SIG_DFL)
    os.kill(os.getpid(), number)
    os._exit(FIRST_STATUS + number)  # the first process of a container, which no signal ends
