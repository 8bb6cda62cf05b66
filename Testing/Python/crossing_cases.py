"""Bodies that need fine cells in one place only, so that their interfaces cross levels.

The option FineInterfaces is off.
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from vfmtest import VolumeFractionShapes

AUTOMATIC = {"VolumeFractionArrays": ["body"], "Refinement": "Automatic", "MaximumLevel": 1}
CROSSING = {**AUTOMATIC, "FineInterfaces": 0}
FILM = 0.7  # thickness in cells


def text(values):
    return ",".join(map(repr, map(float, values)))


def ball_with_film(n, fin):
    """Returns exact fractions (z, y, x) of a ball and an oblique film on n^3 cells.

    The film lies next to the ball; with `fin`, it sticks out of the ball. The centre and the radius
    of the ball, in cells, are returned also.
    """
    cell = 2 / n  # The box extends from -1 to 1.
    radius = 0.25 * n
    centre = np.array([-0.16 * n, 0.01 * n, 0.007 * n])
    normal = np.array([0.25, 0.15, 1]) if fin else np.array([1, 0.3, 0.2])
    normal /= np.linalg.norm(normal)
    film = centre if fin else centre + (radius + 5) * normal
    shapes = "sphere radius=%r center=%s; plate thickness=%r center=%s normal=%s" % (
        radius * cell, text(centre * cell), FILM * cell, text(film * cell), text(normal))
    sides = [((0, 0, 0), (-1, 0, 0)), ((1.9, 0, 0), (1, 0, 0.1)), ((0, 0.7, 0), (0, 1, 0.05)),
             ((0, -0.7, 0), (0, -1, 0.1))]
    for place, outwards in sides if fin else []:
        shapes += " cut=%s,%s" % (text((centre + radius * np.array(place)) * cell), text(outwards))
    source = VolumeFractionShapes(Dimensions=[n] * 3, Shapes=shapes)
    algorithm = source.GetClientSideObject()
    algorithm.UpdatePiece(0, 1, 0)  # the whole image on every rank
    data = algorithm.GetOutputDataObject(0).GetCellData()
    return vtk_to_numpy(data.GetArray("Material1")).reshape(n, n, n).copy(), centre + n / 2, radius
