"""Defines Run, the call that made a mesh."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Dict, List


@dataclass
class Run:
    """Call of `hexes` or `tets` that made a mesh, for its quality report.

    Attributes
    ----------
    source : dict of str to str
        Description of the input, such as its "Grid" and the origin of the materials.
    options : dict
        Options that differ from their defaults, by their names as arguments.
    warnings : list of str
        Texts of the warnings.

    Examples
    --------
    >>> fractions = vfm.shapes("sphere radius=4 center=6,6,6", 12)
    >>> mesh = vfm.hexes(fractions, smoothing="off", iso_value=0.4)
    >>> mesh.run.options
    {'iso_value': 0.4, 'smoothing': 'off'}
    >>> mesh.run.source["Grid"]
    '12 x 12 x 12 cells'
    """

    source: Dict[str, str] = field(default_factory=dict)
    options: Dict[str, Any] = field(default_factory=dict)
    warnings: List[str] = field(default_factory=list)
