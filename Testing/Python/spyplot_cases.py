"""A ball and a plate at two times, as SpyPlot blocks and as an image."""
import numpy as np

from spyplot import Block, split
from vfmtest import ORIGIN, SPACING, ball_and_plate, image, rectilinear

SPY = ["Material volume fraction - 1", "Material volume fraction - 2"]
STATE = "X velocity"
TIMES = [0, 2e-6]
NODES = [x + h * np.arange(13) for x, h in zip(ORIGIN, SPACING)]
# These coordinates are not binary fractions, which only flat meshes allow: the mesh uses the
# float32 values in the file.
UNEVEN_NODES = [(x + np.arange(13) * 0.1).astype(np.float32) for x in (-0.35, 0.2, 1.7)]
# Numbers of blocks in x, y, z and of files. Files of one block each are a flat mesh (rectilinear
# grids), others are block-structured.
LAYOUTS = [((1, 1, 1), 1), ((2, 1, 2), 1), ((2, 1, 2), 2), ((2, 1, 2), 4)]


def steps():
    """Returns the arrays of both times, float32 as in the files."""
    ball, plate = ball_and_plate()
    return [{name: value.astype(np.float32) for name, value in (
        ("Pressure", 1e5 * b), (SPY[0], b), (SPY[1], np.minimum(p, 1 - b)), (STATE, b - p))}
            for b, p in ((ball, plate), (ball[::-1], plate))]


def refined_blocks():
    """Returns blocks, some of which are repeated on a second level."""
    fine = [np.linspace(x[0], x[-1], 25) for x in NODES]
    doubled = [{name: np.kron(value, np.ones((2, 2, 2))) for name, value in step.items()}
               for step in steps()]
    return split(NODES, steps(), (2, 1, 2)) + [
        Block(block.coordinates, block.steps, level=1)
        for block in split(fine, doubled, (4, 4, 4))[:2]]


def as_bytes(arrays):
    """Converts the fractions to bytes like ParaView's reader: truncated, not rounded."""
    return {name: (value * np.float32(255)).astype(np.uint8) if name in SPY else value
            for name, value in arrays.items()}


def data_of_step(step, nodes=None, to_bytes=False):
    """Returns one time as an image, or as a rectilinear grid on these nodes."""
    arrays = as_bytes(steps()[step]) if to_bytes else steps()[step]
    return rectilinear(arrays, nodes) if nodes else image(arrays)


def without_reader_fields(mesh):
    """Returns a copy without the field data that ParaView's reader and writer add."""
    copy = mesh.NewInstance()
    copy.ShallowCopy(mesh)
    for name in ("GlobalBounds", "GlobalBoxSize", "MinLevel", "MinLevelSpacing", "TimeValue"):
        copy.GetFieldData().RemoveArray(name)
    return copy
