"""Measures meshes of hexahedra, tetrahedra or other polyhedra by the faces of their cells."""
import numpy as np

# Faces with the corners counterclockwise from outside, for corners in the order of VTK.
FACES = {4: [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)],
         8: [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]}
NEAR = 1.0  # voxels: facets that are nearer to the sides of the box are not interfaces


class CellFaces:
    """Points, the material of each cell, and faces by their number of corners: {number: (cells,
    corners)}. The corners of a face are counterclockwise from outside of its cell."""

    def __init__(self, points, faces, material):
        self.points, self.faces, self.material = points, faces, np.asarray(material)


def of_elements(points, cells, material):
    """Returns the faces of hexahedra or tetrahedra."""
    table = np.array(FACES[cells.shape[1]])
    corners = cells[:, table].reshape(-1, table.shape[1])
    return CellFaces(points, {table.shape[1]: (np.repeat(np.arange(len(cells)), len(table)),
                                               corners)}, material)


def of_polyhedra(points, faces, owner, neighbour):
    """Returns the faces of polyhedra of OpenFOAM: corners of each face counterclockwise from
    outside of its owner; the first faces have neighbours."""
    found, sizes = {}, np.array([len(face) for face in faces])
    for size in np.unique(sizes):
        chosen = np.flatnonzero(sizes == size)
        inner = chosen[chosen < len(neighbour)]
        corners = [np.array([faces[f] for f in some], int).reshape(-1, size)
                   for some in (chosen, inner)]
        found[size] = (np.concatenate([owner[chosen], neighbour[inner]]),
                       np.concatenate([corners[0], corners[1][:, ::-1]]))
    return CellFaces(points, found, np.ones(owner.max() + 1, int))


def find_volumes(mesh):
    """Returns the volume of each cell. Faces are triangles between their edges and their centre."""
    volumes = np.zeros(len(mesh.material))
    for cells, corners in mesh.faces.values():
        at = mesh.points[corners]
        centre = at.mean(1, keepdims=True)
        products = np.cross(at - centre, np.roll(at, -1, 1) - centre)
        volumes += np.bincount(cells, (products * centre).sum((1, 2)) / 6, len(volumes))
    return volumes


def find_corner_jacobians(mesh):
    """Returns (cells, scaled Jacobians) of the corners of hexahedra and tetrahedra: the volume that
    their edges span over the product of the lengths."""
    columns, is_element = [], find_elements(mesh)
    for cells, corners in mesh.faces.values():
        cells, corners = cells[is_element[cells]], corners[is_element[cells]]
        columns.append([np.repeat(cells, corners.shape[1]), corners.ravel(),
                        np.roll(corners, -1, 1).ravel(), np.roll(corners, 1, 1).ravel()])
    cell, corner, following, previous = np.concatenate(columns, axis=1)
    order = np.lexsort((corner, cell))
    cell, corner, following, previous = (
        column[order] for column in (cell, corner, following, previous))
    begin = np.flatnonzero(np.diff(cell, prepend=-1) | np.diff(corner, prepend=-1))
    ends = following[begin] + following[begin + 1] + following[begin + 2]
    third = ends - following[begin] - previous[begin]
    edges = [mesh.points[end] - mesh.points[corner[begin]]
             for end in (previous[begin], following[begin], third)]
    lengths = np.prod([np.linalg.norm(edge, axis=1) for edge in edges], axis=0)
    determinants = (np.cross(edges[0], edges[1]) * edges[2]).sum(1)
    return cell[begin], determinants / np.maximum(lengths, 1e-300)


def find_elements(mesh):
    """Returns for each cell whether it is a hexahedron or a tetrahedron, by its faces."""
    count = len(mesh.material)
    of_all = np.bincount(np.concatenate([cells for cells, _ in mesh.faces.values()]),
                         minlength=count)
    of_size = {size: np.bincount(cells, minlength=count)
               for size, (cells, _) in mesh.faces.items()}
    return np.any([(of_all == faces) & (of_size.get(size, 0) == faces)
                   for size, faces in ((3, 4), (4, 6))], axis=0)


def count_inverted(volumes, cells, jacobians):
    """Returns the number of cells whose volume or whose Jacobian at a corner is not positive."""
    inverted = volumes <= 0
    inverted[cells[jacobians <= 0]] = True
    return int(inverted.sum())


def find_angles(points, cells):
    """Returns the smallest and the largest dihedral angle of tetrahedra in degrees."""
    at = points[cells]
    normals = [np.cross(at[:, b] - at[:, a], at[:, c] - at[:, a]) for a, b, c in FACES[4]]
    normals = [n / np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-300) for n in normals]
    cosines = [-(normals[i] * normals[j]).sum(1) for i in range(4) for j in range(i)]
    return tuple(np.degrees(np.arccos(np.clip((np.max(cosines), np.min(cosines)), -1, 1))))


def find_facets(mesh):
    """Yields (corners, cells): faces of one cell, with -1 as their second cell, and faces between
    two materials, by their number of corners."""
    for cells, corners in mesh.faces.values():
        names = np.sort(corners, axis=1)
        order = np.lexsort(names.T)
        names = names[order]
        equal = (names[1:] == names[:-1]).all(1)
        second = np.full(len(order), -1)
        second[:-1][equal] = cells[order[1:][equal]]
        first = np.concatenate([[True], ~equal])
        pairs = np.column_stack([cells[order], second])[first]
        chosen = (pairs[:, 1] < 0) | (mesh.material[pairs[:, 0]] != mesh.material[pairs[:, 1]])
        yield corners[order][first][chosen], pairs[chosen]


def is_near_sides(mesh, corners, box):
    """Returns whether each corner of a facet is near a side of the box from 0 to `box`."""
    at = mesh.points[corners]
    return ((at < NEAR) | (at > np.asarray(box) - NEAR)).any(2).all(1)


def count_open_faces(mesh, box):
    """Returns the number of faces of one cell that are not near the sides of the box."""
    return sum(int((~is_near_sides(mesh, corners, box) & (pairs[:, 1] < 0)).sum())
               for corners, pairs in find_facets(mesh))


def find_distances(mesh, image):
    """Returns two rms distances to the true surfaces of the points of facets inside of the box: of
    points between two materials, and of those where more meet, NaN without such points.

    A point counts once per pair of materials. If all of the box is meshed, only facets between two
    materials count."""
    rows = []
    for corners, pairs in find_facets(mesh):
        chosen = ~is_near_sides(mesh, corners, image.labels.shape)
        if image.fills_box:
            chosen &= pairs[:, 1] >= 0
        sides = np.where(pairs < 0, 0, mesh.material[pairs])[chosen]
        rows.append(np.column_stack([corners[chosen].ravel(), np.repeat(
            np.sort(sides, axis=1), corners.shape[1], axis=0)]))
    rows = np.unique(np.concatenate(rows), axis=0)
    squares = image.distance(mesh.points[rows[:, 0]], rows[:, 1:]) ** 2
    is_single = np.bincount(rows[:, 0])[rows[:, 0]] == 1
    return tuple(np.sqrt(some.mean()) if len(some) else np.nan
                 for some in (squares[is_single], squares[~is_single]))


def find_volume_errors(mesh, volumes, labels):
    """Returns for each label of the image the relative error of its volume against its voxels, and
    whether it has an element."""
    expected = np.bincount(labels.ravel())
    meshed = np.flatnonzero(expected[1:]) + 1
    found = np.bincount(mesh.material, volumes, len(expected))[meshed]
    elements = np.bincount(mesh.material, minlength=len(expected))[meshed]
    return np.abs(found / expected[meshed] - 1), elements > 0
