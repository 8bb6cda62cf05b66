"""Makes the data of a mesh from the result of the core."""

from __future__ import annotations

from typing import Any, Dict, Mapping

from ._call import Run
from ._geometry import Curves, Geometry, Surfaces, Vertices


def data_of(result: Mapping[str, Any], roles: Dict[str, str], run: Run) -> Dict[str, Any]:
    """Returns the arguments of MeshData, by name."""
    result = dict(result)
    surfaces, curves, vertices = result.pop("surfaces"), result.pop("curves"), result.pop(
        "vertices")
    nodal = result.pop("nodal_velocity")
    return dict(
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
        particles=result["particles"],
    )
