"""Reports errors of libraries that read files: one line, with the path."""

from __future__ import annotations

import logging
import os
import re
import warnings
from contextlib import contextmanager
from importlib import import_module
from typing import Any, Iterator, List

LONGEST = 300  # characters of a text of a library
LIBRARIES = {"PIL": "pillow", "vtkmodules": "vtk"}  # modules with another name at PyPI


def one_line(text: Any) -> str:
    """Returns a text in one line, without control characters."""
    words = " ".join(str(text).split())
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in words)


@contextmanager
def one_message(path: str) -> Iterator[None]:
    """Turns every error of the block into one exception of one line that contains the path."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    except (ImportError, FileNotFoundError):
        raise
    except MemoryError:
        raise MemoryError("Cannot read %s: there is not enough memory for the values that it "
                          "announces." % one_line(path)) from None
    except OSError as error:
        _reject(path, error.strerror or error)
    except (ValueError, TypeError) as error:
        _reject(path, error)
    except Exception as error:  # each library has its own classes
        _reject(path, "it is damaged or of another format: %s"
                % (one_line(error) or type(error).__name__))


def _reject(path: str, problem: Any) -> None:
    text = one_line(problem) or "it is damaged."
    # the prefix of SimpleITK: source file, line and address
    text = re.sub(r"^Exception thrown in SimpleITK .*?sitk::ERROR: ", "", text)
    text = re.sub(r"\S*/(\w+\.\w+:\d+:)|ITK ERROR: |\w+\(0x[0-9a-f]+\): ", "", text).strip()
    if len(text) > LONGEST:
        text = text[:LONGEST] + " .."
    raise ValueError("Cannot read %s: %s" % (one_line(path), text)) from None


def load_library(name: str, path: str) -> Any:
    """Returns a module, or raises ImportError with the command that installs it."""
    try:
        return import_module(name)
    except ImportError:
        package = LIBRARIES.get(name.split(".")[0], name.split(".")[0])
        raise ImportError("Reading %s requires %s: pip install %s"
                          % (path, package, package)) from None


class _Keeper(logging.Handler):
    def __init__(self) -> None:
        super().__init__()
        self.texts: List[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        self.texts.append(record.getMessage())


@contextmanager
def keep_log(name: str) -> Iterator[List[str]]:
    """Gives the texts that a library logs during the block, and prints none of them."""
    logger, keeper = logging.getLogger(name), _Keeper()
    before = logger.handlers, logger.propagate
    logger.handlers, logger.propagate = [keeper], False
    try:
        yield keeper.texts
    finally:
        logger.handlers, logger.propagate = before


@contextmanager
def quiet() -> Iterator[None]:
    """Discards what libraries in C and C++ write to standard error during the block."""
    try:
        kept = os.dup(2)
    except OSError:  # there is no standard error
        yield
        return
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nowhere, 2)
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(nowhere)
