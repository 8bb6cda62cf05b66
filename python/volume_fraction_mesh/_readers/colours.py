"""Converts colours to labels."""

from __future__ import annotations

from typing import Dict, Tuple

import numpy as np

MOST = 255  # colours that become labels, as in sculptor


def label_colours(values: np.ndarray) -> Tuple[np.ndarray, Dict[int, str]]:
    """Returns a label per colour and the names of the labels, such as "rgb 255 0 0".

    values: shape (.., 3) or (.., 4), of the type uint8 or uint16. Black and transparent points are
    void; the other colours are numbered from 1 by red, green and blue. If all points are grey,
    they keep their values up to 255, without names.
    """
    if values.shape[-1] == 4:
        values = np.where(values[..., 3:] == 0, 0, values)[..., :3]
    if (values == values[..., :1]).all() and values.max() <= MOST:
        return np.ascontiguousarray(values[..., 0]), {}
    bits = 8 * values.dtype.itemsize
    codes = np.zeros(values.shape[:-1], np.uint64)
    for channel in range(3):
        codes = (codes << np.uint64(bits)) | values[..., channel].astype(np.uint64)
    found, labels = np.unique(codes, return_inverse=True)
    first = 0 if found[0] == 0 else 1
    colours = found[1 - first:]
    if len(colours) > MOST:
        raise ValueError(
            "it has %d colours; at most %d become labels. Save it without blended colours (no "
            "smooth edges, no JPEG), or as a grey image, for which threshold=.. (--threshold "
            "LOW:HIGH) selects materials." % (len(colours), MOST))
    mask = (1 << bits) - 1
    names = {label: "rgb %d %d %d" % (int(code) >> 2 * bits, int(code) >> bits & mask,
                                      int(code) & mask)
             for label, code in enumerate(colours, 1)}
    return (labels.reshape(codes.shape) + first).astype(np.uint8), names
