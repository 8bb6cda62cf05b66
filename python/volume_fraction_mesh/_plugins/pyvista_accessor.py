"""Adds the accessor `volume_fraction_mesh` to the data sets of PyVista 0.48 or later.

PyVista imports this module by the entry point of the package when the accessor is first used.
"""

from __future__ import annotations

from typing import Any, TYPE_CHECKING

import pyvista

from .. import hexes, surface, tets
from ..mesh import Mesh

if TYPE_CHECKING:
    from pyvista import DataSet, UnstructuredGrid

OF_SURFACE = ("cells", "cell_width", "bounds")  # arguments that place the grid around a surface


@pyvista.register_dataset_accessor("volume_fraction_mesh", pyvista.DataSet)
class MeshAccessor:
    """Makes meshes of a data set of PyVista.

    The data set is an image, a rectilinear grid, or a grid of hexahedra that form a Cartesian grid,
    with arrays of volume fractions or labels; or a closed surface (PolyData).

    Examples
    --------
    >>> image = pyvista.ImageData(dimensions=(4, 4, 4))  # doctest: +SKIP
    >>> image.cell_data["label"] = np.ones(27, int)  # doctest: +SKIP
    >>> image.volume_fraction_mesh.hexes(arrays=["label"]).n_cells  # doctest: +SKIP
    27
    """

    def __init__(self, dataset: DataSet) -> None:
        self._dataset = dataset

    def hexes(self, **options: Any) -> UnstructuredGrid:
        """Make hexahedra of all materials.

        Parameters
        ----------
        **options
            Arguments of `volume_fraction_mesh.hexes`, such as ``arrays=["label"]``. Of a closed
            surface also ``cells``, ``cell_width`` and ``bounds``, as in
            `volume_fraction_mesh.surface`.

        Returns
        -------
        pyvista.UnstructuredGrid
            The mesh with all arrays and tables, as `Mesh.to_pyvista` makes it.
        """
        return self._make(hexes, options)

    def tets(self, **options: Any) -> UnstructuredGrid:
        """Make tetrahedra of all materials, as `hexes` makes hexahedra."""
        return self._make(tets, options)

    def _make(self, make: Any, options: Any) -> UnstructuredGrid:
        source: Any = self._dataset
        if isinstance(source, pyvista.PolyData):
            placed = {name: options.pop(name) for name in OF_SURFACE if name in options}
            source = surface(source, **placed)
        mesh: Mesh = make(source, **options)
        return mesh.to_pyvista()
