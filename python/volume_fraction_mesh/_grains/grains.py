"""Defines Grains, the orientations and phases of grains, for solvers of crystal plasticity."""

from __future__ import annotations

import os
from typing import Any, Dict, Optional, Sequence, Union

import numpy as np

from .._data import MeshData
from .._output import whole_file
from .._readers import dream3d_grains
from .._readers.report import one_message
from . import grain_files, orientations
from .grain_table import GrainTable


class Grains(GrainTable):
    """Orientations and phases of the grains of a mesh, one row per grain.

    Parameters
    ----------
    euler_angles : array_like, shape (n, 3), optional
        Euler angles of Bunge, phi1, Phi, phi2, in radians.
    quaternions : array_like, shape (n, 4), optional
        Quaternions (w, x, y, z) instead: the rotation that turns the axes of the sample to those
        of the crystal, as in DAMASK. Need not have the length 1.
    degrees : bool, default False
        Whether `euler_angles` are in degrees.
    ids : array_like of int, shape (n,), optional
        Label of each grain, positive: its material in the mesh. Default: 1 to n.
    phases : array_like of int, shape (n,), optional
        Phase of each grain. Default: 1.
    phase_names : dict of int to str, optional
        Names of phases. Default: ``phase 1`` for phase 1.

    Attributes
    ----------
    ids, phases : ndarray of int64, shape (n,)
        Labels, ascending, and phases.
    euler_angles : ndarray of float64, shape (n, 3)
        Euler angles of Bunge in radians, as given.
    quaternions : ndarray of float64, shape (n, 4)
        Unit quaternions with w >= 0.
    phase_names : dict of int to str
        Name of each phase in `phases`, ascending.

    Raises
    ------
    ValueError
        If shapes do not fit, values are not finite, or a label is not positive or occurs twice.
    TypeError
        If both or none of `euler_angles` and `quaternions` are given.

    See Also
    --------
    read_grains : Read the grains of a file of DREAM.3D.

    Examples
    --------
    >>> labels = np.ones((6, 6, 6), int)
    >>> labels[3:] = 2
    >>> mesh = vfm.tets(labels=labels)
    >>> grains = vfm.Grains([[30, 0, 0], [0, 45, 0]], degrees=True, phase_names={1: "copper"})
    >>> grains.quaternions.round(3).tolist()
    [[0.966, 0.0, 0.0, 0.259], [0.924, 0.383, 0.0, 0.0]]
    >>> mesh.state.update(grains.arrays(mesh))
    >>> mesh.save("grains.e")
    """

    def __init__(self, euler_angles: Any = None, *, quaternions: Any = None, degrees: bool = False,
                 ids: Optional[Sequence[int]] = None, phases: Optional[Sequence[int]] = None,
                 phase_names: Optional[Dict[int, str]] = None) -> None:
        if (euler_angles is None) == (quaternions is None):
            raise TypeError("Give either euler_angles or quaternions.")
        if quaternions is None:
            euler = _rows(euler_angles, "euler_angles", 3)
            euler = np.radians(euler) if degrees else euler
            turns = orientations.to_quaternions(euler)
        else:
            turns = orientations.normalized(_rows(quaternions, "quaternions", 4))
            euler = orientations.to_euler(turns)
        count = len(turns)
        numbers = _integers(np.arange(1, count + 1) if ids is None else ids, "ids", count)
        if count and numbers.min() < 1:
            raise ValueError("The label %d in ids is not positive." % numbers.min())
        order = np.argsort(numbers, kind="stable")
        numbers = numbers[order]
        twice = numbers[1:][numbers[1:] == numbers[:-1]]
        if len(twice):
            raise ValueError("The label %d occurs twice in ids." % twice[0])
        own = _integers(np.ones(count, int) if phases is None else phases, "phases", count)[order]
        given = phase_names or {}
        self.ids, self.phases = numbers, own
        self.euler_angles, self.quaternions = euler[order], turns[order]
        self.phase_names = {int(phase): str(given.get(int(phase), "phase %d" % phase))
                            for phase in np.unique(own)}

    def __repr__(self) -> str:
        return "Grains(%d grains, phases %s)" % (
            len(self), ", ".join(self.phase_names.values()) or "none")

    def arrays(self, mesh: MeshData) -> Dict[str, np.ndarray]:
        """Return the rows of the grains as arrays of the elements of a mesh.

        With ``mesh.state.update(grains.arrays(mesh))`` all files of `Mesh.save` that hold state
        have them: VTK, and Exodus as variables of the blocks.

        Parameters
        ----------
        mesh : Mesh
            Mesh whose materials are the grains. Elements of void have angles of 0, the quaternion
            (1, 0, 0, 0) and phase 0.

        Returns
        -------
        dict of str to ndarray
            ``EulerAngles``, shape (m, 3), in degrees, ``Quaternion``, shape (m, 4), and ``Phase``,
            int32, shape (m,).

        Raises
        ------
        ValueError
            If a material of the mesh is none of the grains.

        Examples
        --------
        >>> mesh = vfm.tets(labels=np.full((3, 3, 3), 7))
        >>> arrays = vfm.Grains([[10, 20, 30]], degrees=True, ids=[7]).arrays(mesh)
        >>> arrays["EulerAngles"].shape == (len(mesh), 3), np.unique(arrays["Phase"]).tolist()
        (True, [1])
        """
        self._check(mesh)
        row = np.searchsorted(self.ids, mesh.material)
        row[mesh.material == 0] = len(self)
        euler = np.vstack([np.degrees(self.euler_angles), np.zeros((1, 3))])
        turns = np.vstack([self.quaternions, [[1.0, 0, 0, 0]]])
        phase = np.append(self.phases, 0).astype(np.int32)
        return {"EulerAngles": euler[row], "Quaternion": turns[row], "Phase": phase[row]}

    def save(self, path: Any, mesh: Optional[MeshData] = None) -> None:
        """Write the grains for a solver, beside the mesh. The ending of the name selects the form.

        - ``.inp`` (Abaqus and CalculiX): an ``*ORIENTATION`` and a ``*SOLID SECTION`` per grain,
          to include after the mesh. Materials have the names of the phases in capitals;
        - ``.yaml`` (DAMASK): ``material.yaml`` for the mesh in ``.msh``. The phases have no
          properties yet;
        - ``.txt`` (MOOSE): for ``EulerAngleFileReader``, row k for grain k, in degrees;
        - ``.csv`` (MOOSE): for ``PropertyReadFile`` with ``read_type = block`` and
          ``use_zero_based_block_indexing = false``, row k for block k, in degrees.

        Parameters
        ----------
        path : str or path-like
            File to write.
        mesh : Mesh, optional
            Mesh to check: all of its materials must be among the grains, and only grains that it
            has are written. Default: all grains.

        Raises
        ------
        ValueError
            If the ending is unknown, there are no grains, or a material of `mesh` is none of them.
        OSError
            If the file cannot be written; an incomplete file is removed.

        Examples
        --------
        >>> mesh = vfm.tets(labels=np.full((3, 3, 3), 7))
        >>> grains = vfm.Grains([[10, 20, 30]], degrees=True, ids=[7], phase_names={1: "copper"})
        >>> mesh.save("grains.inp")
        >>> grains.save("orientations.inp", mesh)
        >>> print(open("orientations.inp").read().splitlines()[-1])
        *SOLID SECTION, ELSET=EB7, MATERIAL=COPPER, ORIENTATION=GRAIN_7
        """
        path = os.fspath(path)
        ending = os.path.splitext(path)[1].lower()
        if ending not in grain_files.WRITERS:
            raise ValueError("%r: the ending of a table of grains must be one of %s." % (
                path, ", ".join(grain_files.WRITERS)))
        written = self if mesh is None else self._of(mesh)
        if not len(written):
            raise ValueError("There are no grains to write to %s." % path)
        lines = grain_files.WRITERS[ending](written)
        with whole_file(path) as unfinished:
            with open(unfinished, "w", encoding="utf-8", newline="\n") as file:
                file.write("\n".join([*lines, ""]))

    def _check(self, mesh: MeshData) -> None:
        missing = np.setdiff1d(mesh.material, [0, *self.ids])
        if len(missing):
            raise ValueError("The mesh has the material %d, which is none of the %d grains." % (
                missing[0], len(self)))

    def _of(self, mesh: MeshData) -> Grains:
        """Returns the grains that have elements."""
        self._check(mesh)
        has = np.isin(self.ids, mesh.material)
        found = Grains(quaternions=self.quaternions[has], ids=self.ids[has],
                       phases=self.phases[has], phase_names=self.phase_names)
        found.euler_angles, found.quaternions = self.euler_angles[has], self.quaternions[has]
        return found


def read_grains(path: Union[str, "os.PathLike[str]"], trust_input: bool = False) -> Grains:
    """Read the orientations and phases of the grains of a file of DREAM.3D.

    The grains are the features of the image geometry that has ``FeatureIds``, which `read` reads as
    labels.

    Parameters
    ----------
    path : str or path-like
        File ``.dream3d`` of DREAM.3D 6 or DREAM3D-NX. Its table of features has the Euler angles
        ``AvgEulerAngles`` or ``EulerAngles``, or else the quaternions ``AvgQuats``, and may have
        ``Phases``. Names of phases are from ``PhaseName`` or ``MaterialName``.
    trust_input : bool, default False
        Whether values may be in other files.

    Returns
    -------
    Grains
        Rows with the labels 1 to n.

    Raises
    ------
    FileNotFoundError
        If `path` does not exist.
    ValueError
        If the file has no orientations of grains, or is damaged.
    ImportError
        If h5py is not installed.

    Examples
    --------
    >>> grains = vfm.read_grains("grains.dream3d")  # doctest: +SKIP
    >>> mesh = vfm.tets(labels=vfm.read("grains.dream3d"), arrays=["FeatureIds"])  # doctest: +SKIP
    >>> mesh.save("grains.msh")  # doctest: +SKIP
    >>> grains.save("material.yaml", mesh)  # doctest: +SKIP
    """
    path = os.fspath(path)
    if not os.path.exists(path):
        raise FileNotFoundError("There is no file %s." % path)
    with one_message(path):
        data = dream3d_grains.read(path, bool(trust_input))
        if data.euler is not None:
            return Grains(data.euler, phases=data.phases, phase_names=data.phase_names)
        x, y, z, w = np.asarray(data.quaternions, float).T
        # DREAM.3D stores the inverse rotation, with the scalar last.
        return Grains(quaternions=np.stack([w, -x, -y, -z], axis=1), phases=data.phases,
                      phase_names=data.phase_names)


def _rows(values: Any, name: str, width: int) -> np.ndarray:
    rows = np.asarray(values, dtype=np.float64)
    if rows.ndim != 2 or rows.shape[1] != width:
        raise ValueError("%s has the shape %s; it must be (grains, %d)." % (
            name, rows.shape, width))
    if not np.isfinite(rows).all():
        raise ValueError("Row %d of %s is not finite." % (
            np.flatnonzero(~np.isfinite(rows).all(axis=1))[0], name))
    return rows


def _integers(values: Any, name: str, count: int) -> np.ndarray:
    numbers = np.asarray(values)
    if numbers.shape != (count,) or numbers.dtype.kind not in "iu":
        raise ValueError("%s must be %d integers." % (name, count))
    return numbers.astype(np.int64)
