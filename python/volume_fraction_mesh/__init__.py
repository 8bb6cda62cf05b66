"""Makes hexahedral and tetrahedral meshes of all materials from volume fractions or labels on
Cartesian and AMR grids.

>>> import volume_fraction_mesh as vfm
>>> mesh = vfm.hexes(vfm.shapes("sphere radius=0.7", 20, bounds=[-1, 1] * 3))
>>> mesh.save("ball.vtu")

`has_tetgen` is True if TetGen is in the build: then `tets` supports ``method="tetgen"``.
"""

from ._call import Run
from ._core import Blocks, Bodies, has_tetgen
from ._core import version as __version__
from ._convert.to_dolfinx import DolfinxMesh
from ._facets import Facets, Separated
from ._fragments import fragments
from ._geometry import Curves, Geometry, Surfaces, Vertices
from ._grains.grains import Grains, read_grains
from ._hexes import hexes
from ._images import Arrays, Fractions
from ._level_set import level_set
from ._load import load
from ._read import read
from ._shapes import shapes, surface
from ._split import Cohesive
from ._tets import tets
from ._warning import VolumeFractionMeshWarning
from .mesh import Mesh

__all__ = [
    "Arrays",
    "Blocks",
    "Bodies",
    "Cohesive",
    "Curves",
    "DolfinxMesh",
    "Facets",
    "Fractions",
    "Geometry",
    "Grains",
    "Mesh",
    "Run",
    "Separated",
    "Surfaces",
    "Vertices",
    "VolumeFractionMeshWarning",
    "__version__",
    "fragments",
    "has_tetgen",
    "hexes",
    "level_set",
    "load",
    "read",
    "read_grains",
    "shapes",
    "surface",
    "tets",
]
