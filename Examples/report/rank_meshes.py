"""Meshes that sculptor wrote in one piece per rank: their arrays, shared points, digests for
comparison, and angles of the surface. `meshes` is a list with the mesh of each rank."""
import glob
import hashlib
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


def read_ranks(path):
    """Returns the meshes of a .pvtu file, one per rank."""
    stem = os.path.splitext(path)[0]
    count = len(glob.glob(os.path.join(stem, "*.vtu")))
    assert count > 0, "no mesh " + path
    meshes = []
    for rank in range(count):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(os.path.join(stem, "%s_%d.vtu" % (os.path.basename(stem), rank)))
        reader.Update()
        meshes.append(reader.GetOutput())
    return meshes


def points_of(mesh):
    return (vtk_to_numpy(mesh.GetPoints().GetData()) if mesh.GetNumberOfPoints()
            else np.zeros((0, 3)))


def values(meshes, name, of="Cell"):
    """Returns the values of an array, concatenated over the ranks."""
    arrays = [getattr(mesh, "Get%sData" % of)().GetArray(name) for mesh in meshes]
    return np.concatenate([vtk_to_numpy(array) for array in arrays if array])


def field_value(meshes, name):
    """Returns a number of the whole mesh, which each rank stores."""
    return meshes[0].GetFieldData().GetArray(name).GetValue(0)


def connectivity(meshes):
    """Returns the global point ids of the elements of all ranks, shape (elements, corners)."""
    rows = []
    for mesh in meshes:
        if mesh.GetNumberOfCells():
            ids = vtk_to_numpy(mesh.GetPointData().GetArray("GlobalPointIds"))
            rows.append(ids[vtk_to_numpy(mesh.GetCells().GetConnectivityArray())].reshape(
                mesh.GetNumberOfCells(), -1))
    return np.concatenate(rows)


def shared_points(meshes):
    """Returns the number of points that several ranks share, and the number of these whose
    coordinates differ between ranks in any bit."""
    ids, places = (values(meshes, "GlobalPointIds", "Point"),
                   np.concatenate([points_of(mesh) for mesh in meshes]))
    order = np.argsort(ids, kind="stable")
    again = ids[order][1:] == ids[order][:-1]
    moved = (places[order][1:] != places[order][:-1]).any(axis=1) & again
    return len(np.unique(ids[order][1:][again])), int(moved.sum())


def digest(meshes):
    """Returns a digest of ids, coordinates, elements and materials in the order of the ids. It does
    not depend on the distribution over ranks."""
    ids, first = np.unique(values(meshes, "GlobalPointIds", "Point"), return_index=True)
    order = np.argsort(values(meshes, "GlobalCellIds"))
    parts = [ids, np.concatenate([points_of(mesh) for mesh in meshes])[first],
             values(meshes, "GlobalCellIds")[order],
             connectivity(meshes)[order], values(meshes, "MaterialId")[order]]
    total = hashlib.sha256()
    for part in parts:
        total.update(np.ascontiguousarray(part).tobytes())
    return total.hexdigest()


def facets(meshes):
    """Returns the faces of hexahedra on the surface, as global ids of their corners, oriented
    outward, and the rank of each face."""
    faces = np.array([[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1],
                      [4, 5, 6, 7]])
    corners = connectivity(meshes)[:, faces].reshape(-1, 4)
    rank = np.repeat(np.arange(len(meshes)), [6 * mesh.GetNumberOfCells() for mesh in meshes])
    _, first, count = np.unique(np.sort(corners, axis=1), axis=0, return_index=True,
                                return_counts=True)
    return corners[first[count == 1]], rank[first[count == 1]]


def surface_angles(meshes):
    """Returns the angles in degrees between facets that share an edge: at edges inside a rank's
    part of the surface, and at edges between ranks."""
    corners, rank = facets(meshes)
    ids, first = np.unique(values(meshes, "GlobalPointIds", "Point"), return_index=True)
    places = np.concatenate([points_of(mesh) for mesh in meshes])[first][
        np.searchsorted(ids, corners)]
    normals = np.cross(places[:, 2] - places[:, 0], places[:, 3] - places[:, 1])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    edges = np.sort(np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2),
                    axis=1)
    order = np.lexsort(edges.T)
    left, right = order[0::2], order[1::2]
    assert (edges[left] == edges[right]).all(), "the surface is not closed, or touches itself"
    left, right = left // 4, right // 4
    cosines = (normals[left] * normals[right]).sum(axis=1)
    angles, between = np.degrees(np.arccos(np.clip(cosines, -1, 1))), rank[left] != rank[right]
    return angles[~between], angles[between]
