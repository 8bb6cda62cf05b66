"""Reads files and folders as input of hexes() and tets()."""

from __future__ import annotations

import os
import warnings
from typing import Any, Callable, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._arrays import CellArrays, as_numbers, check_order, flatten
from ._core import Blocks
from ._grid import (NOWHERE, UNIT, Grid, check_spacing, even_nodes, is_default, make_grid,
                    point_nodes)
from ._images import (Arrays, Image, check_names, choose_volume, read_nibabel, read_sitk,
                      read_vtk, volume_hint)
from ._readers import dream3d_files, itk_files, nifti_files, numpy_files, pictures, tiff_files
from ._readers import vtk_files
from ._readers.colours import label_colours
from ._readers.report import one_line, one_message
from ._readers.slices import Slice, describe_gaps, join_slices, list_slices, natural_key
from ._types import Order, Triple
from ._warning import VolumeFractionMeshWarning

PathLike = Union[str, "os.PathLike[str]"]
CALLER = 3  # stack level of the caller of read(), for warnings
SURFACES = (".obj", ".ply", ".off")  # by meshio
VTK = (*vtk_files.READERS, ".vtk")
SLICES = (*tiff_files.ENDINGS, *pictures.ENDINGS)


class Choice(NamedTuple):
    """Arguments of read() that select parts of a file."""

    step: int
    volume: Optional[int]
    spacing: Any
    origin: Any
    order: str
    trust_input: bool


def read(path: Union[PathLike, Sequence[PathLike]], *, step: int = 0,
         arrays: Optional[Sequence[str]] = None, volume: Optional[int] = None,
         spacing: Optional[Triple] = None, origin: Sequence[float] = NOWHERE,
         order: Order = "xyz", trust_input: bool = False) -> Union[Arrays, Blocks]:
    """Read arrays, an image, slices or blocks of cells as input of `hexes` and `tets`.

    Parameters
    ----------
    path : str, path-like or list of them
        A file, or a folder. NumPy: ``.npy``, ``.npz``. VTK: ``.vti``, ``.vtr``, ``.vts``, ``.vtu``,
        ``.vtk`` (images, rectilinear grids, hexahedra that form a Cartesian grid). nibabel:
        ``.nii``, ``.nii.gz``, ``.mgz``, ``.mgh``, ``.img``, ``.hdr``. SimpleITK: ``.nrrd``,
        ``.nhdr``, ``.mha``, ``.mhd``, ``.gipl``, ``.mrc``, ``.dcm``. tifffile: ``.tif``,
        ``.tiff``. Pillow: ``.png``, ``.bmp``, ``.jpg``, ``.gif``, ``.pgm`` and others, one layer of
        cells. One picture becomes a mesh of a plane (`Arrays.is_picture`). h5py: ``.dream3d``.
        Slices: a folder, a pattern such as ``slices/*.tif``, or a list of files. Blocks: a case
        file ``.spcth`` of CTH or one of its binary files, versions 101 to 105; the folder of an
        AMReX plotfile; Exodus files of hexahedra that form a Cartesian grid, ``.e``, ``.ex2``,
        ``.exo``, ``.exii``, ``.g``, or any of the parts ``FILE.N.0`` to ``FILE.N.N-1``. Exodus
        files in the form netCDF-4 are read only if the package was built with the netCDF library.
    step : int, default 0
        Index of the time step; negative values count from the end.
    arrays : list of str, optional
        Names of the arrays to read. Default: all. Of Exodus files also "object_id", the ids of the
        element blocks.
    volume : int, optional
        Index of the volume, from 0, of a file with several volumes. Default: all, as materials.
    spacing : float or sequence of 3 floats, optional
        Widths of the cells along x, y and z, instead of those of the file.
    origin : sequence of 3 floats, default (0, 0, 0)
        Corner of the first cell, for ``.npy`` and ``.npz``.
    order : {"xyz", "zyx"}, default "xyz"
        Order of the axes of arrays in ``.npy`` and ``.npz``.
    trust_input : bool, default False
        Whether a header may name files outside of its folder: ``.mhd``, ``.nhdr``, ``.pvti`` and
        the like, ``.dream3d``, ``.spcth``, plotfiles.

    Returns
    -------
    Arrays or Blocks
        Arrays: a dict of arrays by name with their grid. Blocks, from ``.spcth``, plotfiles and
        Exodus files: blocks of cells on all levels, without ghost cells; ``len(blocks)`` is their
        number. Attributes: ``path``, ``times`` (of all steps), ``time`` (None without times),
        ``names`` (of the arrays) and ``fractions`` (arrays that hold materials, the default of
        `arrays` in `hexes`).

    Raises
    ------
    FileNotFoundError
        If `path` does not exist.
    ValueError
        If the format is unknown, the file is damaged, or it lacks the step, volume or array. The
        message names the file and the place.
    ImportError
        If the package that reads the format is missing. The message names it.

    Warns
    -----
    VolumeFractionMeshWarning
        If a stack of TIFF lacks the width of its voxels, or numbers are missing among the names of
        slices.

    See Also
    --------
    hexes, tets : Make a mesh of the result.

    Examples
    --------
    An impact in a file of CTH; state arrays are selected by their names:

    >>> blocks = vfm.read("impact.spcth", step=-1)
    >>> len(blocks), len(blocks.times)
    (4, 4)
    >>> blocks.fractions
    ['Material volume fraction - 1', 'Material volume fraction - 2']
    >>> mesh = vfm.hexes(blocks, state=["X velocity"])
    >>> list(mesh.state)
    ['X velocity']
    """
    names = None if arrays is None else check_names(arrays)
    choice = Choice(step, volume, spacing, origin, check_order(order), bool(trust_input))
    if isinstance(path, (list, tuple)):
        files = [os.fspath(each) for each in path]
        if not files:
            raise ValueError("path is an empty list: the files of slices are required.")
        return _finish(_read_slices(files, choice), files[0], names, choice)
    path = os.fspath(path)
    if _core.is_block_file(path):
        return _read_blocks(path, names, choice)
    slices = list_slices(path, SLICES)
    if slices is not None:
        return _finish(_read_slices(slices, choice), path, names, choice)
    return _finish(_read_file(path, names, choice), path, names, choice)


def find_files(path: str) -> List[str]:
    """Returns a path, or the files of slices in a folder or pattern."""
    if _core.is_block_file(path):
        return [path]
    return list_slices(path, SLICES) or [path]


def is_surface(path: str) -> bool:
    """Returns whether a path is a file of a closed surface, by its ending."""
    return _core.is_surface_file(path) or path.lower().endswith(SURFACES)


def _read_blocks(path: str, names: Optional[List[str]], choice: Choice) -> Blocks:
    if not os.path.exists(path):
        raise FileNotFoundError("There is no file %s." % path)
    if choice.volume is not None or choice.spacing is not None:
        raise TypeError("volume and spacing do not apply to %s: it contains its grid." % path)
    return _core.read_blocks(path, choice.step, names, choice.trust_input)


Reader = Callable[[str, Optional[List[str]], Choice], Image]


def _list_readers() -> List[Tuple[Tuple[str, ...], Reader]]:
    """Returns the endings of files and the function that reads them."""
    return [
        ((".npy", ".npz"), _read_numpy),
        (nifti_files.ENDINGS, lambda path, names, choice: read_nibabel(
            nifti_files.read(path), choice.volume)._replace(has_labels=True)),
        (VTK, lambda path, names, choice: read_vtk(
            vtk_files.read(path, choice.trust_input), names, is_file=True)),
        (tuple(itk_files.READERS), _read_itk),
        (tiff_files.ENDINGS, _read_tiff),
        (pictures.ENDINGS, lambda path, names, choice: _read_slices([path], choice)),
        ((dream3d_files.ENDING,), _read_dream3d),
    ]


def _read_file(path: str, names: Optional[List[str]], choice: Choice) -> Image:
    if not os.path.exists(path):
        raise FileNotFoundError("There is no file %s." % path)
    if not os.path.isfile(path):
        raise ValueError("Cannot read %s: it is not a regular file." % path)
    readers = _list_readers()
    for endings, reader in readers:
        if path.lower().endswith(endings):
            with one_message(path):
                image = reader(path, names, choice)
            _check_applies(path, image, choice)
            return image
    if is_surface(path):
        raise ValueError("%s is a closed surface: vfm.surface(path, cells) computes its volume "
                         "fractions." % one_line(path))
    raise ValueError(
        "%s is of an unknown format. Supported: %s, .spcth, Exodus (.e, .ex2, .exo, .exii, .g), "
        "folders of AMReX plotfiles, and folders of slices." % (
            one_line(path), ", ".join(end for endings, _ in readers for end in endings)))


def _check_applies(path: str, image: Image, choice: Choice) -> None:
    """Raises an exception for arguments that do not apply to the file."""
    low = path.lower()
    if choice.step not in (0, -1) and not low.endswith(tiff_files.ENDINGS):
        raise ValueError("Cannot read %s: there is no step %d: it has 1, counted from 0."
                         % (path, choice.step))
    if choice.volume not in (None, 0) and low.endswith((*VTK, ".npz", dream3d_files.ENDING)):
        raise ValueError("Cannot read %s: there is no volume %d: its arrays have names, which "
                         "arrays=[..] (--array) selects." % (path, choice.volume))
    is_numpy = low.endswith((".npy", ".npz"))
    if not (is_numpy or (is_default(choice.origin, NOWHERE) and choice.order == "xyz")):
        raise TypeError("origin and order apply to .npy and .npz: %s contains its grid." % path)


def _finish(image: Image, path: str, names: Optional[List[str]], choice: Choice) -> Arrays:
    """Returns the selected arrays of an image, with the spacing that is given."""
    if names is not None:
        missing = [name for name in names if name not in image.arrays]
        if missing:
            raise ValueError("%s has no array %r. Its arrays: %s." % (
                path, missing[0], ", ".join(map(repr, image.arrays)) or "none"))
        chosen = None if image.chosen is None else [n for n in image.chosen if n in names]
        image = image._replace(arrays={name: image.arrays[name] for name in names},
                               chosen=chosen or None)
    if choice.spacing is not None:
        image = image._replace(grid=_with_widths(image.grid, check_spacing(choice.spacing)))
    for text in (image.warning, image.note if choice.spacing is None else ""):
        if text:
            warnings.warn(one_line(text), VolumeFractionMeshWarning, stacklevel=CALLER)
    return Arrays(image, path)


def _with_widths(grid: Grid, widths: np.ndarray) -> Grid:
    """Returns a grid with other widths of cells, and the first corner or point in its place."""
    starts = [x[0] for x in grid.nodes]
    if grid.are_points:
        firsts = [0.5 * (x[0] + x[1]) for x in grid.nodes]
        return grid._replace(nodes=point_nodes(firsts, widths, grid.cells))
    return grid._replace(nodes=tuple(even_nodes(start, width, 0, count) for start, width, count
                                     in zip(starts, widths, grid.cells)))


def _read_numpy(path: str, names: Optional[List[str]], choice: Choice) -> Image:
    found = numpy_files.read(path)
    is_one = path.lower().endswith(".npy")
    is_image = is_one and len(found) == 1
    if is_one:
        if names is not None:
            raise ValueError("it holds one array without a name: omit arrays (--array).")
        found = choose_volume(list(found.values()), choice.volume)
    arrays = CellArrays(choice.order)
    for name, array in numpy_files.select(found, names).items():
        arrays.add(name, as_numbers(array, name))
    grid = make_grid(arrays.cells or (), UNIT, choice.origin, None, None)
    return Image(grid, arrays.flat, list(arrays.flat) if is_one else None, choice.order,
                 has_labels=is_image, hint=volume_hint(arrays.flat) if is_one else "")


def _read_itk(path: str, names: Optional[List[str]], choice: Choice) -> Image:
    image = itk_files.read(path, choice.trust_input)  # owns the values until they are copied
    found = read_sitk(image, choice.volume)
    copies = {name: array.copy() for name, array in found.arrays.items()}
    return found._replace(arrays=copies, has_labels=True)


def _read_dream3d(path: str, names: Optional[List[str]], choice: Choice) -> Image:
    grid, arrays = dream3d_files.read(path, names, choice.trust_input)
    chosen = [dream3d_files.DEFAULT] if dream3d_files.DEFAULT in arrays else None
    return Image(grid, arrays, chosen, "zyx", {}, True)


def _read_tiff(path: str, names: Optional[List[str]], choice: Choice) -> Image:
    stack = tiff_files.read(path, choice.step)
    if len(stack.volumes) == 1 and stack.volumes[0].ndim == 4:
        return _stack_image(Slice(stack.volumes[0], stack.widths), path)
    if stack.volumes[0].ndim == 4:
        raise ValueError("it has %d channels of colours: one is required." % len(stack.volumes))
    volumes = [flatten(as_numbers(volume, "image"), "zyx") for volume in stack.volumes]
    arrays = choose_volume(volumes, choice.volume)
    grid, note = _place_stack(stack.volumes[0].shape[2::-1], stack.widths, path)
    return Image(grid, arrays, list(arrays), "zyx", {}, True, volume_hint(arrays), note,
                 is_picture=grid.cells[2] == 1)


def _read_slice(path: str) -> Slice:
    if not os.path.exists(path):
        raise FileNotFoundError("There is no file %s." % path)
    low = path.lower()
    if low.endswith(tiff_files.ENDINGS):
        stack = tiff_files.read(path, 0, is_slice=True)
        values = stack.volumes[0]
        if len(stack.volumes) > 1 or len(values) > 1:
            raise ValueError("it has %d pages: each file of several is one slice."
                             % (len(stack.volumes) * len(values)))
        return Slice(values[0], stack.widths)
    if low.endswith(pictures.ENDINGS):
        return Slice(pictures.read(path), (None, None, None))
    raise ValueError("its format is not one of slices: %s." % ", ".join(SLICES))


def _read_slices(files: Sequence[str], choice: Choice) -> Image:
    if choice.volume not in (None, 0):
        raise ValueError("Cannot read %s: there is no volume %d: slices form one volume."
                         % (files[0], choice.volume))
    volume = join_slices(files, _read_slice)
    gaps = describe_gaps(sort_slices(files))
    with one_message(files[0]):
        image = _stack_image(volume, files[0])
    return image._replace(warning="%s: %s" % (files[0], gaps) if gaps else "")


def _stack_image(stack: Slice, path: str) -> Image:
    """Returns the image of values of shape (slices, rows, columns), or with channels of colours as
    a fourth axis."""
    values, names = (label_colours(stack.values) if stack.values.ndim == 4 else (stack.values, {}))
    grid, note = _place_stack(values.shape[::-1], stack.widths, path)
    arrays = {"Material 1": flatten(as_numbers(values, "image"), "zyx")}
    return Image(grid, arrays, list(arrays), "zyx", names, True, note=note,
                 is_picture=grid.cells[2] == 1)


def _place_stack(cells: Sequence[int], widths: Sequence[Optional[float]],
                 path: str) -> Tuple[Grid, str]:
    """Returns the grid of voxels whose first one is at 0, and a note if the file does not contain
    their widths. Slices without a width are as thick as the voxels along x."""
    x, y, z = widths
    note = ""
    if z is None and cells[2] > 1:
        note = ("%s has no size %s: %g is used%s. Give spacing=(x, y, z), --spacing X Y Z, if the "
                "voxels have another size." % (path, "of voxels" if x is None else "along z",
                                               x or 1.0, "" if x is None else ", as along x"))
    x = x or 1.0
    return Grid(point_nodes(NOWHERE, (x, y or x, z or x), cells), are_points=True), note


def sort_slices(files: Sequence[str]) -> List[str]:
    """Returns files in natural order of their names."""
    return sorted(files, key=natural_key)
