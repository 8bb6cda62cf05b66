"""Meshes an STL file with hexahedra that keep its edges: a nut, its fractions, its mesh, and the
faces for loads.

usage: python stl_to_hexes.py [--stl part.stl] [--mesh part.vtu] [--picture part.png]
"""

import argparse
import os
import tempfile

import numpy as np

import volume_fraction_mesh as vfm

POINTS, WIDTH, HOLE, HEIGHT = 120, 8.0, 4.5, 6.0  # around; millimetres


def write_nut(path: str) -> None:
    """Writes a hexagon with a hole by PyVista."""
    import pyvista

    angle = np.arange(POINTS) * 2 * np.pi / POINTS
    radius = WIDTH * np.cos(np.pi / 6) / np.cos(angle % (np.pi / 3) - np.pi / 6)
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    rings = [np.column_stack([r * circle, np.full(POINTS, z)]) for z in (0, HEIGHT)
             for r in (radius[:, None], HOLE)]
    here = np.arange(POINTS)
    there = np.roll(here, -1)
    outer, inner, top, top_inner = (ring * POINTS for ring in range(4))
    # each strip joins two rings
    sides = [(outer, top), (top, top_inner), (top_inner, inner), (inner, outer)]
    quads = np.concatenate([np.stack([a + here, a + there, b + there, b + here], axis=1)
                            for a, b in sides])
    faces = np.column_stack([np.full(len(quads), 4), quads])
    pyvista.PolyData(np.concatenate(rings), faces.ravel()).triangulate().save(path)


def show(mesh: vfm.Mesh, path: str) -> None:
    import pyvista

    plotter = pyvista.Plotter(off_screen=True, window_size=(900, 700))
    plotter.background_color = "white"
    plotter.add_mesh(
        mesh.to_pyvista("surfaces"),
        scalars="SurfaceId",
        cmap="Set3",
        show_edges=True,
        edge_color="#404040",
        line_width=0.6,
        show_scalar_bar=False,
    )
    plotter.add_mesh(mesh.to_pyvista("curves"), color="black", line_width=3, scalars=None)
    plotter.camera_position = [(16, -22, 24), (0, 0, HEIGHT / 2), (0, 0, 1)]
    plotter.screenshot(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--stl")
    parser.add_argument("--mesh")
    parser.add_argument("--picture")
    words = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        stl = words.stl or os.path.join(folder, "nut.stl")
        if not words.stl:
            write_nut(stl)
        fractions = vfm.surface({"steel": stl}, 44)
    print("%d x %d x %d cells" % fractions["steel"].shape)
    mesh = vfm.hexes(fractions, sharp_edges="on")
    print(mesh)
    print("volume %.3f of %.3f" % (mesh.materials["MeshVolume"][0],
                                   mesh.materials["TargetVolume"][0]))
    fields = mesh.surfaces.fields
    top = int(np.argmax(np.reshape(fields["SurfaceNormals"], (-1, 3)) @ [0, 0, 1]))
    print(
        "%d surfaces, %d curves, %d vertices; surface %d is the top, of area %.2f"
        % (
            mesh.surfaces.surface_id.max(),
            mesh.curves.curve_id.max(),
            len(mesh.vertices.points),
            top + 1,
            fields["SurfaceAreas"][top],
        )
    )
    if words.mesh:
        mesh.save(words.mesh)
    if words.picture:
        show(mesh, words.picture)


if __name__ == "__main__":
    main()
