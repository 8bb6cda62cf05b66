"""Makes a Mesh from the result of the core."""

from __future__ import annotations

from typing import Any, Dict, Mapping

from ._geometry import Curves, Geometry, Surfaces, Vertices
from .mesh import Mesh, Run


def make_mesh(result: Mapping[str, Any], roles: Dict[str, str], run: Run) -> Mesh:
    """Makes a Mesh from the result of the core."""
    result = dict(result)
    surfaces, curves, vertices = result.pop("surfaces"), result.pop("curves"), result.pop(
        "vertices")
    nodal = result.pop("nodal_velocity")
    return Mesh(
        points=result["points"],
        cells=result["cells"],
        material=result["material"],
        fragment=result["fragment"],
        point_ids=result["point_ids"],
        cell_ids=result["cell_ids"],
        partner=result["partner"],
        mids=result["mids"],
        quality=result["scaled_jacobian"],
        geometry=Geometry(result["geometry_dimension"], result["geometry_id"]),
        surfaces=Surfaces(**surfaces, fields=result["surface_fields"]),
        curves=Curves(**curves, fields=result["curve_fields"]),
        vertices=Vertices(**vertices, fields=result["vertex_fields"]),
        state=result["state"],
        point_state=dict([nodal]) if nodal else {},
        materials=result["materials"],
        fields=result["fields"],
        roles=roles,
        run=run,
        original_ids=result["original_ids"],
        layer=result["layer"],
    )
