"""The mesher itself, without conveniences: what the functions of the package are made of.

Cells are numbered with x fastest. Raises ValueError where the input cannot be meshed, MemoryError where memory runs out, and what `progress`
or `warn` raise, or a signal (KeyboardInterrupt), as it is.
"""
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, TypedDict, Union

import numpy as np
from numpy.typing import NDArray

Progress = Optional[Callable[[float, str], object]]
"""Called with the part that is done (0..1) and the name of the stage, by the thread that called."""
Coordinates = Sequence[NDArray[np.float64]]
"""Of the nodes along x, y and z: increasing, two or more each, in one unit of length."""
Fields = Dict[str, Union[NDArray[Any], List[str]]]

version: str
has_tetgen: bool
"""Whether the method TetGen is built in (AGPL-3)."""

class Options:
    """Of a run, with the defaults of the filters, whose help tells what they mean. Ranges are checked where the mesher needs them alone."""

    tets: bool
    iso_value: float
    fraction_tolerance: float
    target_scaled_jacobian: float
    maximum_aspect_ratio: float
    thin_cells: float
    curvature_per_cell: float
    mesh_void: bool
    stair_step: bool
    conserve_volume: bool
    compute_quality: bool
    fine_interfaces: bool
    refine_flipped_cells: bool
    label_smoothing: int
    minimum_region_cells: int
    maximum_level: int
    fine_layers: int
    interface_layers: int
    smoothing: int
    """0 off, 1 quadric surface, 2 geometry based."""
    sharp_edges: int
    """0 off, 1 on, 2 automatic."""
    refinement: int
    """0 off, 1 levels of the input, 2 automatic, 3 coarsen, 4 uniform."""
    child_fractions: int
    """0 planes, 1 those of the parent."""
    method: int
    """Of tetrahedra: 0 TetGen, 1 cells, 2 lattice."""
    relative_size: float
    growth: float
    radius_edge_ratio: float
    minimum_dihedral_angle: float
    optimization_level: int
    state_order: int
    give_unmeshed: bool
    nodal_velocity: bool
    lost_to_internal: bool
    refinement_array: str
    """Empty: none."""
    refinement_boxes: List[Sequence[float]]
    """Seven numbers each: x0, y0, z0, x1, y1, z1 and how many times cells are halved."""

    def __init__(self) -> None: ...

class Blocks:
    """Blocks of cells of a file, with arrays. Made by read_blocks()."""

    path: str
    times: List[float]
    """Of all steps."""
    time: float
    names: List[str]
    """Of the arrays."""
    fractions: List[str]
    """Arrays that hold materials."""

    def __len__(self) -> int: ...

class StateChoice(TypedDict, total=False):
    arrays: List[str]
    conserved: bool
    densities: List[str]
    kinds: List[str]
    """Words name=kind."""
    velocity: str
    energy: str

class Surfaces(TypedDict):
    cells: NDArray[np.int64]
    """(k, 4), of tetrahedra (k, 3): points of the mesh, the normal from the second material of the pair to the first."""
    surface_id: NDArray[np.int32]
    material_pair: NDArray[np.int32]
    """(k, 2), the smaller first; 0 is void or outside."""
    domain_side: NDArray[np.int32]
    """-1, or 0..5 for -x +x -y +y -z +z."""

class Curves(TypedDict):
    cells: NDArray[np.int64]
    """(k, 2): points of the mesh."""
    curve_id: NDArray[np.int32]

class Vertices(TypedDict):
    points: NDArray[np.int64]
    vertex_id: NDArray[np.int32]

class MeshDict(TypedDict):
    points: NDArray[np.float64]
    """(n, 3)"""
    cells: NDArray[np.int64]
    """(m, 8), of tetrahedra (m, 4): points in the order of VTK."""
    point_ids: NDArray[np.int64]
    cell_ids: NDArray[np.int64]
    material: NDArray[np.int32]
    fragment: NDArray[np.int32]
    scaled_jacobian: Optional[NDArray[np.float32]]
    geometry_dimension: NDArray[np.int32]
    """Of each point: 3 in a volume, 2 on a surface, 1 on a curve, 0 a vertex."""
    geometry_id: NDArray[np.int32]
    surfaces: Surfaces
    curves: Curves
    vertices: Vertices
    state: Dict[str, NDArray[Any]]
    """Of the elements: (m,) or (m, components)."""
    nodal_velocity: Optional[Tuple[str, NDArray[np.float64]]]
    fields: Fields
    materials: Fields
    surface_fields: Fields
    curve_fields: Fields
    vertex_fields: Fields

def mesh(
    blocks: Optional[Blocks],
    arrays: Sequence[Tuple[str, NDArray[Any]]],
    coordinates: Coordinates,
    axes: Sequence[float],
    origin: Sequence[float],
    are_points: bool,
    fractions: Sequence[str],
    labels: str,
    label_names: Dict[int, str],
    state: Optional[StateChoice],
    options: Options,
    threads: int,
    progress: Progress,
    warn: Callable[[str], object],
) -> MeshDict:
    """Meshes cells.

    blocks: of a file, or None: one of the cells that follow. arrays: names and values of shape (cells,) or (cells, components), C-contiguous, whole numbers or reals of 32 or 64 bits; not copied,
    and not to be changed meanwhile. axes: the direction matrix by rows; origin: the point about which it turns. fractions: names of arrays, one a
    material, or labels: that of one array of whole numbers, else "". are_points: what messages call a cell. threads: 0 for all cores.
    The arrays of the result own their memory.
    """

def shape_fractions(
    text: str, coordinates: Coordinates, tolerance: float, threads: int, progress: Progress
) -> List[NDArray[np.float64]]:
    """Exact volume fractions of shapes written as text: of each material an array of shape (cells,)."""

def read_blocks(path: str, step: int, names: Optional[Sequence[str]]) -> Blocks:
    """Blocks of a SpyPlot case or an AMReX plotfile. names: of the arrays to read, None for all. Raises ValueError."""

def read_label_names(path: str) -> Dict[int, str]:
    """What a text table calls labels: lines of a label and its name, a label file of ITK-SNAP, a table of FreeSurfer or MRIcron.

    Raises ValueError, with path and line, on a file that is none, and a label or a name twice.
    """

def triangle_fractions(
    points: NDArray[np.float64],
    triangles: NDArray[np.int64],
    coordinates: Coordinates,
    tolerance: float,
    threads: int,
    progress: Progress,
) -> NDArray[np.float64]:
    """Exact volume fractions of what a closed surface holds, (cells,). points: (n, 3), those at one place are one; triangles: (m, 3).

    Raises ValueError on a surface that is open or not manifold.
    """
