"""Reads pictures (PNG, BMP, ..) by Pillow."""

from __future__ import annotations

import numpy as np

from .report import load_library

ENDINGS = (".png", ".bmp", ".jpg", ".jpeg", ".gif", ".pgm", ".ppm", ".pbm", ".pnm")
GREY = {"1", "L", "P", "I", "I;16", "I;16B", "I;16L", "F"}


def read(path: str) -> np.ndarray:
    """Returns the values, shape (rows, columns), or (rows, columns, 3 or 4) for colours. A picture
    with a palette has the indices of its colours."""
    image = load_library("PIL.Image", path)
    with image.open(path) as picture:
        if getattr(picture, "n_frames", 1) > 1:
            raise ValueError("it has %d frames: a picture has one." % picture.n_frames)
        if picture.mode in ("LA", "La", "PA"):
            values = np.asarray(picture.convert("RGBA"))
        elif picture.mode in GREY or picture.mode in ("RGB", "RGBA"):
            values = np.asarray(picture)
        else:
            values = np.asarray(picture.convert("RGB"))
    return values.view(np.uint8) if values.dtype == np.bool_ else values
