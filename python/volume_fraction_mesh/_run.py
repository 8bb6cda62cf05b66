"""Runs the mesher for hexes() and tets(), and raises its warnings."""

from __future__ import annotations

import warnings
from contextvars import ContextVar
from typing import TYPE_CHECKING, Any, Dict, Mapping, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._call import Run
from ._input import Source, read_field
from ._progress import shown
from ._report import describe
from ._result import data_of
from ._state import StateGiven, add_refinement, list_boxes, list_names, read_state
from ._types import Progress
from ._warning import VolumeFractionMeshWarning
from .mesh import Mesh

if TYPE_CHECKING:
    from ._core import StateChoice

CALLER = 3  # stack level of the caller of hexes(), for warnings
# Words with which messages select an array as labels; sculptor's, unless a front end has others.
LABELS_OPTION = ContextVar("LABELS_OPTION", default="--labels")


def run_mesher(
    options: _core.Options,
    source: Source,
    carried: StateGiven,
    refinement_array: Any,
    refinement_boxes: Optional[Sequence[Sequence[float]]],
    shows: Progress,
) -> Mesh:
    """Makes a mesh. Warnings seem to come from the caller of hexes() or tets()."""
    field = read_field(source._replace(
        others=list_names(carried, refinement_array), tolerance=options.fraction_tolerance))
    state = read_state(carried, field)
    options.threshold = source.threshold
    options.refinement_array = add_refinement(refinement_array, field)
    options.refinement_boxes = list_boxes(refinement_boxes)
    told = [field.note] if field.note else []
    try:
        with shown(shows) as progress:
            result = _core.mesh(
                blocks=field.blocks,
                arrays=field.arrays.items(),
                coordinates=list(field.grid.nodes),
                axes=field.grid.direction.ravel().tolist(),
                origin=list(field.grid.origin),
                are_points=field.grid.are_points,
                fractions=field.fractions,
                labels=field.labels,
                label_names=field.label_names,
                state=state,
                options=options,
                progress=progress,
                warn=told.append,
                guessed=field.guessed,
                labels_option=LABELS_OPTION.get(),
                bodies=field.surfaces,
            )
    finally:
        for text in told:
            warnings.warn(text, VolumeFractionMeshWarning, stacklevel=CALLER)
    run = Run(describe(field), options.changed(), told)
    return Mesh(**data_of(result, _find_roles(state, result["state"]), run))


def _find_roles(state: Optional[StateChoice], carried: Mapping[str, ArrayLike]) -> Dict[str, str]:
    """Returns the names of the arrays of density and velocity. carried: all arrays of the mesh."""
    if state is None:
        return {}
    densities, velocity = ["density", *state["densities"]], state["velocity"]
    kinds = dict(word.split("=", 1) for word in state["kinds"])
    are_volume = bool(state["densities"]) and all(kinds.get(name, "volume") == "volume"
                                                  for name in densities)
    found = {"density": next((name for name in densities if are_volume and name in carried), None)}
    # The core joins components to one array, whose name is part of the names of the components.
    vectors = [name for name in carried if velocity and name in velocity
               and np.shape(carried[name])[1:] == (3,)]
    found["velocity"] = max(vectors, key=len, default=None)
    return {role: name for role, name in found.items() if name}
