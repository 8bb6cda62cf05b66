"""Reads NIfTI, MGH and Analyze images by nibabel."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from .report import keep_log, load_library

ENDINGS = (".nii", ".nii.gz", ".mgz", ".mgh", ".img", ".hdr")
LARGEST_RATIO = 1100  # of gzip


def read(path: str) -> Any:
    """Returns an image of nibabel whose values are in memory."""
    nibabel = load_library("nibabel", path)
    with keep_log("nibabel.global"):
        image = nibabel.load(path)
    size = float(np.prod(image.shape, dtype=float)) * image.get_data_dtype().itemsize
    names = {holder.filename for holder in image.file_map.values()
             if isinstance(holder.filename, str) and os.path.exists(holder.filename)}
    length = sum(map(os.path.getsize, names))
    if size > LARGEST_RATIO * length:
        raise ValueError("its header announces %r voxels, more than its %d bytes hold."
                         % (image.shape, length))
    values = np.asanyarray(image.dataobj)
    return type(image)(values, image.affine, image.header)
