"""Reports the progress of a run to a function, a tqdm bar or standard error."""

from __future__ import annotations

import sys
from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional

from ._output import at_ending
from ._types import Progress


class _Lines:
    """Prints one line per stage."""

    def __init__(self) -> None:
        self.stage = ""

    def __call__(self, fraction: float, stage: str) -> None:
        if stage != self.stage:
            self.stage = stage
            print("%3.0f %% %s" % (100 * fraction, stage), file=sys.stderr, flush=True)


class _Bar:
    """Shows a tqdm bar from 0 to 100."""

    def __init__(self, tqdm: Any) -> None:
        self.bar = tqdm(total=100, bar_format="{desc:30}{percentage:3.0f}%|{bar}| {elapsed}")

    def __call__(self, fraction: float, stage: str) -> None:
        self.bar.set_description_str(stage, refresh=False)
        self.bar.n = max(self.bar.n, min(100, int(100 * fraction)))
        self.bar.refresh()


@contextmanager
def shown(progress: Progress) -> Iterator[Optional[Callable[[float, str], Any]]]:
    """Yields the function for the core to call, None without progress."""
    if progress is None or progress is False:
        yield None
        return
    if callable(progress):
        yield progress
        return
    if progress is not True:
        raise TypeError(
            "progress is %r: it must be True, False or a function of the fraction done and the "
            "stage." % (progress,)
        )
    try:
        from tqdm.auto import tqdm
    except ImportError:
        yield _Lines()
        return
    bar = _Bar(tqdm)
    try:
        with at_ending(bar.bar.close):
            yield bar
    finally:
        bar.bar.close()
