"""A small polycrystal and files of it, for tests of voxel readers."""
import numpy as np

SIZE = (9, 11, 13)  # cells along x, y, z
ORDERS = ("XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX")


def grains():
    """Returns labels a[x, y, z] of grains around random points: 0 void, and four materials."""
    generator = np.random.default_rng(11)
    centres, materials = generator.random((12, 3)) * SIZE, np.arange(12) % 5
    cells = np.stack(np.meshgrid(*[np.arange(n) + 0.5 for n in SIZE], indexing="ij"), axis=-1)
    nearest = np.argmin(((cells[..., None, :] - centres) ** 2).sum(axis=-1), axis=-1)
    return materials[nearest]


def turned(labels, order):
    """Returns the same labels with the indices in that order."""
    return labels.transpose(["XYZ".index(axis) for axis in order])


def write_text(path, labels, order="XYZ"):
    np.savetxt(path, turned(labels, order).ravel(), fmt="%d")
    return path


def write_numpy(path, labels, dtype=np.uint8, order="XYZ", fortran=False):
    array = turned(labels, order).astype(dtype)
    # A file object, because numpy.save(path) would append .npy to .NPY.
    with open(path, "wb") as file:
        np.save(file, np.asfortranarray(array) if fortran else np.ascontiguousarray(array))
    return path
