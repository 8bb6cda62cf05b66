"""Files that are written beside their names, and replace the files of these names when whole."""

from __future__ import annotations

import os
import shutil
import signal
import stat
import sys
import tempfile
import threading
from contextlib import contextmanager
from typing import Any, Iterator, List

SIGNALS = (signal.SIGTERM, signal.SIGINT, signal.SIGHUP)  # they end a program
MAXIMUM_LINKS = 40  # as in Linux


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
    with tempfile.TemporaryDirectory(prefix=".unfinished-", dir=folder) as unfinished:
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


class Ended(BaseException):
    """Raised in the main thread by a signal that ends the program."""

    def __init__(self, number: int) -> None:
        super().__init__()
        self.number = number


@contextmanager
def ended_by_signals(program: str) -> Iterator[None]:
    """Ends the process by a signal that arrives in the block, after the block has removed its
    unfinished files, with a line on standard error. Signals that are ignored stay ignored."""
    def end(number: int, _: Any) -> None:
        raise Ended(number)

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    handlers = {number: signal.getsignal(number) for number in SIGNALS
                if signal.getsignal(number) != signal.SIG_IGN}
    try:
        for number in handlers:
            signal.signal(number, end)
        yield
    except Ended as ended:
        for number in handlers:
            signal.signal(number, signal.SIG_DFL)
        print("%s: ended by %s; unfinished files are removed."
              % (program, signal.Signals(ended.number).name), file=sys.stderr, flush=True)
        os.kill(os.getpid(), ended.number)
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)
