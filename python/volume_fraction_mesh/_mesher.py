"""hexes() and tets(): from arrays or images to a mesh."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._input import read_field
from ._options import THREADS, core_options
from ._progress import shown
from ._state import add_refinement, list_boxes, read_state
from ._types import (
    ChildFractions,
    FractionsLike,
    LostEnergy,
    Method,
    Names,
    OfMaterials,
    Order,
    Progress,
    Refinement,
    SharpEdges,
    Smoothing,
    StateLike,
    StateTransfer,
    Triple,
    Unmeshed,
)
from .mesh import Mesh, make_mesh

if TYPE_CHECKING:
    from ._core import StateChoice

CALLER = 3  # of hexes(), for warnings


class VolumeFractionMeshWarning(UserWarning):
    """Of what may surprise in a mesh: fractions that were clipped, materials without an element, material that is
    left out."""


def _run(tets: bool, given: Mapping[str, Any]) -> Mesh:
    """given: the arguments of hexes(), or of tets()."""
    options = core_options(tets, given)
    threads = THREADS.check(given["threads"])
    field = read_field(given)
    state = read_state(given, field)
    options.refinement_array = add_refinement(given, field)
    options.refinement_boxes = list_boxes(given["refinement_boxes"])
    told: List[str] = []
    try:
        with shown(given["progress"]) as progress:
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
                threads=threads,
                progress=progress,
                warn=told.append,
            )
    finally:
        for text in told:
            warnings.warn(text, VolumeFractionMeshWarning, stacklevel=CALLER)
    return make_mesh(result, _find_roles(state, result["state"]))


def _find_roles(state: Optional[StateChoice], carried: Mapping[str, ArrayLike]) -> Dict[str, str]:
    """Which arrays of the mesh are the density and the velocity; carried: all of them."""
    if state is None:
        return {}
    densities, velocity = ["density", *state["densities"]], state["velocity"]
    kinds = dict(word.split("=", 1) for word in state["kinds"])
    are_volume = bool(state["densities"]) and all(kinds.get(name, "volume") == "volume" for name in densities)
    found = {"density": next((name for name in densities if are_volume and name in carried), None)}
    # of components the core makes one array, whose name is part of theirs
    vectors = [name for name in carried if velocity and name in velocity and np.shape(carried[name])[1:] == (3,)]
    found["velocity"] = max(vectors, key=len, default=None)
    return {role: name for role, name in found.items() if name}


def hexes(
    fractions: FractionsLike = None,
    *,
    labels: Any = None,
    spacing: Triple = (1.0, 1.0, 1.0),
    origin: Sequence[float] = (0.0, 0.0, 0.0),
    coordinates: Optional[Sequence[ArrayLike]] = None,
    direction: Optional[ArrayLike] = None,
    order: Order = "xyz",
    names: Names = None,
    arrays: Optional[Sequence[str]] = None,
    state: StateLike = None,
    density: OfMaterials = None,
    velocity: OfMaterials = None,
    energy: OfMaterials = None,
    state_kinds: Union[Mapping[str, str], Sequence[str], None] = None,
    state_transfer: StateTransfer = "automatic",
    state_order: int = 2,
    nodal_velocity: bool = False,
    lost_kinetic_energy: LostEnergy = "report",
    unmeshed_material: Unmeshed = "give",
    mesh_void: bool = False,
    minimum_region_cells: int = 0,
    fraction_tolerance: float = 1e-6,
    iso_value: float = 0.5,
    stair_step: bool = False,
    smoothing: Smoothing = "quadric_surface",
    sharp_edges: SharpEdges = "automatic",
    label_smoothing: int = 0,
    conserve_volume: bool = True,
    refinement: Refinement = "input_levels",
    maximum_level: int = -1,
    fine_interfaces: bool = True,
    fine_layers: int = 2,
    thin_cells: float = 2.0,
    curvature_per_cell: float = 0.0,
    refine_flipped_cells: bool = False,
    interface_layers: int = 0,
    refinement_array: Any = None,
    refinement_boxes: Optional[Sequence[Sequence[float]]] = None,
    maximum_aspect_ratio: float = 0.0,
    child_fractions: ChildFractions = "planes",
    target_scaled_jacobian: float = 0.0,
    compute_quality: bool = True,
    threads: int = 0,
    progress: Progress = None,
) -> Mesh:
    """A conforming mesh of hexahedra of every material, from volume fractions or labels on a grid of cells.

    The mesh follows the surfaces between the materials and the void, every hexahedron has a positive Jacobian at
    every corner, and every material keeps the volume of its fractions. It does not depend on the number of threads,
    to the bit.

    Parameters
    ----------
    fractions : array, image, or a list or dict of them
        The part of each cell that a material fills, one array (nx, ny, nz) a material: real numbers in [0, 1], bool,
        or uint8 from 0 to 255. A dict names the materials. What the arrays of a cell leave of 1 is void. Images:
        pyvista.ImageData and RectilinearGrid (and VTK's own), nibabel (a fourth axis: materials), SimpleITK
        (components: materials), and what read(), shapes() and surface() return; they tell the grid themselves.
        Points of images are the centres of cells.
    labels : array or image
        Instead of fractions: the material of each cell (nx, ny, nz), whole numbers of any type, 0 void.
    spacing : float or three
        Widths of the cells along x, y and z, in any unit of length.
    origin : three floats
        The corner of the first cell, where x, y and z begin.
    coordinates : three arrays (n + 1,)
        The nodes along x, y and z, increasing, instead of spacing and origin: cells of any widths.
    direction : (3, 3) array
        An orthonormal matrix whose columns are the axes of the grid, about its first node (of images about the first
        point).
    order : {"xyz", "zyx"}
        "xyz": array[i, j, k] has i along x. "zyx": array[k, j, i], as of scikit-image, tifffile and SimpleITK's
        arrays. Arrays are not copied if they are in Fortran order with "xyz", in C order with "zyx". All else,
        spacing, origin, results, is x, y, z.
    names : list of str, or dict of labels
        Of the materials; of labels {label: name}.
    arrays : list of str
        Which arrays of an image of PyVista, or of read(), hold the materials; else the active scalars do.
    state : dict, or list of names of arrays of the image or file
        Arrays (nx, ny, nz) or (nx, ny, nz, components) that the mesh carries along as Mesh.state.
    density : array, number, name, or a list or dict of one a material
        Mass per volume of the material, at least 0. With it state is conserved.
    velocity : array (nx, ny, nz, 3), name, or a list or dict of one a material
        Momentum and kinetic energy of which Mesh.materials tells.
    energy : array, number, name, or a list or dict of one a material
        Internal energy per mass.
    state_kinds : dict
        What is conserved of an array: "mass" (per mass, the default of real numbers), "mass*other", "volume" (per
        volume of the material), "cell" (per volume of the cell), "extensive" (sums), "copy" (the default of whole
        numbers).
    state_transfer : {"automatic", "copy", "conserve"}
        "copy": an element has the values of one cell. "conserve": elements share what cells hold of their material,
        so that volume, mass, momentum and energy have the sums of the input. "automatic": "conserve" with a density,
        else "copy".
    state_order : {1, 2}
        1: what is conserved is constant in a cell; 2: linear, limited by the values around.
    nodal_velocity : bool
        Add the velocity of the nodes to Mesh.point_state.
    lost_kinetic_energy : {"report", "internal_energy"}
        What becomes of the kinetic energy that mean velocities lack: it is told in Mesh.materials, or added to energy.
    unmeshed_material : {"give", "drop"}
        Material apart from all elements of its kind goes to the nearest fragment within three cells, or is left out.
    mesh_void : bool
        Mesh the void too, as material 0.
    minimum_region_cells : int
        Regions of a material, or void, of fewer cells go to what they touch most. 0: all stay.
    fraction_tolerance : float
        How far outside [0, 1] fractions may lie to be clipped, 1e-6 to 0.1.
    iso_value : float
        A cell is void when its materials fill less than this part of it. Volumes are conserved at 0.5 alone.
    stair_step : bool
        Turn cells into elements and move nothing.
    smoothing : {"off", "quadric_surface", "geometry_based"}
        How nodes on surfaces are placed.
    sharp_edges : {"off", "on", "automatic"}
        Whether edges and corners are found in the fractions and kept.
    label_smoothing : int
        Passes, 0 to 10, that smooth the steps of labels; 2 or 3 serve most.
    conserve_volume : bool
        Shift the surfaces until every material has the volume of its fractions.
    refinement : {"off", "input_levels", "automatic", "coarsen", "uniform"}
        "automatic": halve cells where films, gaps, curves or the options below ask for it; "coarsen": larger cells
        away from surfaces; "uniform": halve all. "input_levels": the levels of what read() returns; "off": its
        coarsest level.
    maximum_level : int
        How many times cells are halved (or doubled, by "coarsen") at most, 0 to 10. -1: automatic.
    fine_interfaces : bool
        All surfaces get the finest cells. Of tetrahedra they always do.
    fine_layers : int
        How many of the finest cells lie at least between a surface and larger cells, 2 to 64.
    thin_cells : float
        "automatic" halves cells at parts thinner than so many cells, 0 to 3. 0: not.
    curvature_per_cell : float
        "automatic" halves cells where a surface turns by more radians over a cell. 0: not.
    refine_flipped_cells : bool
        "automatic" halves cells whose material was changed to make surfaces manifold.
    interface_layers : int
        "automatic" halves all cells within so many layers of a surface, 0 to 64.
    refinement_array : array or name
        How many times "automatic" is to halve each cell (nx, ny, nz), 0 to 10.
    refinement_boxes : list of seven floats each
        x0, y0, z0, x1, y1, z1, halvings: boxes in which "automatic" halves cells.
    maximum_aspect_ratio : float
        Cut cells that are so many times longer one way than another, 1.1 or more; 1.5 serves most. 0: not.
    child_fractions : {"planes", "parent"}
        What the parts of a cell hold: pieces cut by planes, or the fractions of the cell.
    target_scaled_jacobian : float
        The quality that smoothing strives for, in [0, 1); of tetrahedra the sine of dihedral angles. 0: automatic.
    compute_quality : bool
        Fill Mesh.quality.
    threads : int
        0: all cores.
    progress : bool or callable
        True: a bar of tqdm, or lines to standard error. A function gets the fraction done and the stage; what it
        raises ends the run.

    Returns
    -------
    Mesh

    Raises
    ------
    ValueError
        Of values that cannot be meshed: the message names array and cell (i, j, k along x, y, z), or option and range.
    TypeError
        Of arguments that are none, or of a wrong type.
    MemoryError, KeyboardInterrupt
        Ctrl-C ends a run within a second.

    Warns
    -----
    VolumeFractionMeshWarning
        Of what may surprise in the mesh.

    Examples
    --------
    >>> import numpy as np
    >>> import volume_fraction_mesh as vfm
    >>> labels = np.zeros((8, 8, 8), int)
    >>> labels[2:6, 2:6, 2:6] = 1
    >>> vfm.hexes(labels=labels, label_smoothing=2).materials["Elements"]
    array([...])
    """
    return _run(False, locals())


def tets(
    fractions: FractionsLike = None,
    *,
    labels: Any = None,
    spacing: Triple = (1.0, 1.0, 1.0),
    origin: Sequence[float] = (0.0, 0.0, 0.0),
    coordinates: Optional[Sequence[ArrayLike]] = None,
    direction: Optional[ArrayLike] = None,
    order: Order = "xyz",
    names: Names = None,
    arrays: Optional[Sequence[str]] = None,
    state: StateLike = None,
    density: OfMaterials = None,
    velocity: OfMaterials = None,
    energy: OfMaterials = None,
    state_kinds: Union[Mapping[str, str], Sequence[str], None] = None,
    state_transfer: StateTransfer = "automatic",
    state_order: int = 2,
    nodal_velocity: bool = False,
    lost_kinetic_energy: LostEnergy = "report",
    unmeshed_material: Unmeshed = "give",
    mesh_void: bool = False,
    minimum_region_cells: int = 0,
    fraction_tolerance: float = 1e-6,
    iso_value: float = 0.5,
    stair_step: bool = False,
    smoothing: Smoothing = "quadric_surface",
    sharp_edges: SharpEdges = "automatic",
    label_smoothing: int = 0,
    conserve_volume: bool = True,
    refinement: Refinement = "input_levels",
    maximum_level: int = -1,
    fine_interfaces: bool = True,
    fine_layers: int = 2,
    thin_cells: float = 2.0,
    curvature_per_cell: float = 0.0,
    refine_flipped_cells: bool = False,
    interface_layers: int = 0,
    refinement_array: Any = None,
    refinement_boxes: Optional[Sequence[Sequence[float]]] = None,
    maximum_aspect_ratio: float = 0.0,
    child_fractions: ChildFractions = "planes",
    target_scaled_jacobian: float = 0.0,
    compute_quality: bool = True,
    method: Method = "lattice",
    relative_size: float = 1.0,
    growth: float = 0.3,
    radius_edge_ratio: float = 1.4,
    minimum_dihedral_angle: float = 10.0,
    optimization_level: int = 4,
    threads: int = 0,
    progress: Progress = None,
) -> Mesh:
    """A conforming mesh of tetrahedra, each of a positive volume, of every material. All that hexes() takes, and:

    Parameters
    ----------
    method : {"tetgen", "cells", "lattice"}
        "lattice": a lattice of cell centres and grid nodes, cut along the surfaces: the best angles, the nearest to
        the surface. "cells": every cell is cut around its centre, so that the surfaces have the faces of hexes().
        "tetgen": the surfaces of "cells", filled by TetGen, where volume_fraction_mesh.has_tetgen.
    relative_size : float
        Of "tetgen": the length of edges beside surfaces, in cells.
    growth : float
        Of "tetgen": by how much that grows over each cell of distance.
    radius_edge_ratio : float
        Of "tetgen": the largest ratio of circumradius to shortest edge, 1 or more.
    minimum_dihedral_angle : float
        Of "tetgen": what refinement strives for, 0 to 60 degrees.
    optimization_level : int
        Of "tetgen": how much it flips and smooths, 0 to 10.

    Returns
    -------
    Mesh
    """
    return _run(True, locals())
