"""Reads solids of CAD files (STEP, IGES, BREP) as triangles, by OpenCASCADE in gmsh."""

from __future__ import annotations

import contextlib
import re
from typing import Any, Dict, Iterator, List, Optional, Tuple

import numpy as np

SUFFIXES = (".step", ".stp", ".iges", ".igs", ".brep")
DEFLECTION = 1e-4  # distance of triangles from the faces, over the longest side: .01 cells of 100
ANGLE = 0.2  # between neighbouring triangles, radians
DEFAULT_COLOUR = (0, 0, 255)  # of entities without colour
# Kind of faces in gmsh by their name in STEP files
KINDS = {"PLANE": "Plane", "CYLINDRICAL_SURFACE": "Cylinder", "CONICAL_SURFACE": "Cone",
         "SPHERICAL_SURFACE": "Sphere", "TOROIDAL_SURFACE": "Torus"}
ENTITY = re.compile(r"#(\d+)\s*=\s*(\w+)\s*\(((?:[^;']|'(?:[^']|'')*')*)\)\s*;")
TEXT = re.compile(r"'((?:[^']|'')*)'")
REFERENCE = re.compile(r"#(\d+)")
Solid = Tuple[Optional[str], np.ndarray, np.ndarray, np.ndarray, List[str]]


def is_step_file(path: str) -> bool:
    return path.lower().endswith(SUFFIXES)


def read(path: str) -> List[Solid]:
    """Returns name, points, triangles, patches and names of patches of each solid, in millimetres.

    The faces with a name, or else those with a colour, are patches; all others are one patch.
    """
    gmsh = _load(path)
    with _session(gmsh):
        try:
            gmsh.model.occ.importShapes(path)
            gmsh.model.occ.synchronize()
        except Exception as error:
            raise ValueError("Cannot read %s: it is no CAD file, or is damaged (%s)."
                             % (path, error)) from None
        return _tessellate(gmsh, path)


def _load(path: str) -> Any:
    try:
        import gmsh
    except (ImportError, OSError) as error:  # OSError: it lacks a library of the system
        raise ImportError(
            "Reading %s requires gmsh: pip install gmsh (%s)" % (path, error)) from None
    return gmsh


@contextlib.contextmanager
def _session(gmsh: Any) -> Iterator[None]:
    """Makes an empty model; what the caller has in gmsh stays."""
    options = {"General.Terminal": 0, "Geometry.OCCImportLabels": 1,
               "Mesh.StlLinearDeflectionRelative": 0, "Mesh.StlLinearDeflection": 1,
               "Mesh.StlAngularDeflection": ANGLE}
    is_first = not gmsh.isInitialized()
    if is_first:
        gmsh.initialize(readConfigFiles=False, interruptible=False)
    current = None if is_first else gmsh.model.getCurrent()
    before = {name: gmsh.option.getNumber(name) for name in options}
    try:
        for name, value in options.items():
            gmsh.option.setNumber(name, value)
        gmsh.model.add("volume_fraction_mesh")
        try:
            yield
        finally:
            gmsh.model.remove()
    finally:
        if is_first:
            gmsh.finalize()
        else:
            for name, value in before.items():
                gmsh.option.setNumber(name, value)
            gmsh.model.setCurrent(current)


def _tessellate(gmsh: Any, path: str) -> List[Solid]:
    volumes = [tag for _, tag in gmsh.model.getEntities(3)]
    if not gmsh.model.getEntities(2):
        raise ValueError("Cannot read %s: it has no faces." % path)
    box = np.reshape(gmsh.model.getBoundingBox(-1, -1), (2, 3))
    gmsh.option.setNumber("Mesh.StlLinearDeflection", DEFLECTION * (box[1] - box[0]).max())
    gmsh.model.mesh.importStl()
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    order = np.argsort(tags)
    tags, points = tags[order], coordinates.reshape(-1, 3)[order]
    faces = {volume: [face for _, face in gmsh.model.getBoundary(
        [(3, volume)], combined=False, oriented=False)] for volume in volumes}
    if not volumes:  # faces without a solid, as of IGES
        faces = {0: [face for _, face in gmsh.model.getEntities(2)]}
    names = _name_faces(gmsh, path, faces)
    solids = []
    for volume, members in faces.items():
        corners, patches, patch_names = _collect(gmsh, members, names)
        used, numbers = np.unique(np.searchsorted(tags, corners), return_inverse=True)
        solids.append((_name_solid(gmsh, volume), points[used],
                       numbers.reshape(-1, 3).astype(np.int64), patches, patch_names))
    return solids


def _collect(gmsh: Any, faces: List[int], names: Dict[int, str]) -> Tuple[
        np.ndarray, np.ndarray, List[str]]:
    """Returns tags of the corners of triangles, patches, and names of patches."""
    corners, patches = [], []
    patch_names: List[str] = []
    for face in faces:
        _, nodes = gmsh.model.mesh.getElementsByType(2, face)
        name = names.get(face, "")
        if name not in patch_names:
            patch_names.append(name)
        corners.append(nodes)
        patches.append(np.full(len(nodes) // 3, patch_names.index(name), dtype=np.int32))
    return np.concatenate(corners), np.concatenate(patches), patch_names


def _name_solid(gmsh: Any, volume: int) -> Optional[str]:
    """Returns the last part of a label such as Shapes/assembly/part."""
    label = gmsh.model.getEntityName(3, volume) if volume else ""
    name = label.rsplit("/", 1)[-1].strip()
    return None if not name or name.startswith("Open CASCADE") else name


def _name_faces(gmsh: Any, path: str, faces: Dict[int, List[int]]) -> Dict[int, str]:
    """Returns the names of faces: labels, else those in the text of the file, else colours."""
    every = [face for members in faces.values() for face in members]
    labels = {face: gmsh.model.getEntityName(2, face).rsplit("/", 1)[-1] for face in every}
    labels = {face: label for face, label in labels.items() if label}
    if not labels and path.lower().endswith((".step", ".stp")):
        with open(path, encoding="latin-1") as file:
            labels = _match(gmsh, faces, _list_solids(file.read()))
    if labels:
        return labels
    colours = {face: gmsh.model.getColor(2, face)[:3] for face in every}
    return {face: "colour_%02x%02x%02x" % colour for face, colour in colours.items()
            if colour != DEFAULT_COLOUR}


def _list_solids(text: str) -> List[List[Tuple[str, str]]]:
    """Returns the kind and the name of the faces of each solid, in the order of the file."""
    found = {number: (kind, arguments) for number, kind, arguments in ENTITY.findall(text)}

    def refer(number: str) -> List[str]:
        return REFERENCE.findall(TEXT.sub("", found.get(number, ("", ""))[1]))

    def describe(face: str) -> Tuple[str, str]:
        kinds = [found.get(other, ("", ""))[0] for other in refer(face)[-1:]]
        name = TEXT.search(found[face][1])
        return KINDS.get(kinds[0] if kinds else "", ""), name.group(1) if name else ""

    solids = []
    for number, (kind, _) in found.items():
        if kind in ("MANIFOLD_SOLID_BREP", "BREP_WITH_VOIDS"):
            shells = [other for shell in refer(number) for other in (
                refer(shell) if found.get(shell, ("",))[0] == "ORIENTED_CLOSED_SHELL" else [shell])]
            solids.append([describe(face) for shell in shells for face in refer(shell)
                           if found.get(face, ("",))[0] == "ADVANCED_FACE"])
    return solids


def _match(gmsh: Any, faces: Dict[int, List[int]],
           solids: List[List[Tuple[str, str]]]) -> Dict[int, str]:
    """Returns the names of the faces of volumes that have faces of the same kinds as a solid of the
    file, in the same order. Volumes get the names if one such solid exists, or as many as volumes.
    """
    names: Dict[int, str] = {}
    alike: Dict[Tuple[str, ...], List[List[int]]] = {}
    for members in faces.values():
        kinds = (gmsh.model.getType(2, face) for face in members)
        alike.setdefault(tuple(kind if kind in KINDS.values() else "" for kind in kinds),
                         []).append(members)
    for kinds, volumes in alike.items():
        candidates = [solid for solid in solids if tuple(kind for kind, _ in solid) == kinds]
        if len(candidates) == 1:
            candidates *= len(volumes)
        if len(candidates) == len(volumes):
            for members, solid in zip(volumes, candidates):
                names.update((face, name) for face, (_, name) in zip(members, solid) if name)
    return names
