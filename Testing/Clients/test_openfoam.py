"""Tests OpenFOAM: checkMesh of cases from one and three ranks, reconstruction, and conduction."""

import gzip
import os
import re
import shutil
import subprocess

import numpy as np
import pytest
import volume_fraction_mesh as vfm

import flat_cases as flat
import foam_files as foam
from ball_in_block import CONDUCTIVITY, HALF, SHAPES, fixed_points, make_mesh, run_recipe, solve

pytestmark = pytest.mark.skipif(not foam.is_installed(), reason="install Debian's openfoam")
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SCULPTOR = os.environ.get("SCULPTOR", os.path.join(ROOT, "build", "bin", "sculptor"))
ATLAS = "/usr/share/mricron/templates/HarvardOxford-cort-maxprob-thr0-1mm.nii.gz"
WARPED = 100  # of the 250,000 faces of the atlas, at points and curves of several regions


def make_noise(size, width):
    """Returns periodic noise of this correlation width in voxels, shape (size, size, size)."""
    wave = np.fft.fftfreq(size)
    square = sum(np.meshgrid(*3 * [wave ** 2], indexing="ij"))
    noise = np.random.default_rng(1).standard_normal(3 * [size])
    return np.fft.ifftn(np.fft.fftn(noise) * np.exp(-2 * (np.pi * width) ** 2 * square)).real


def make_pores():
    """Returns labels of a porous medium: pores 1, of 60 % of the volume, and void 0."""
    noise = make_noise(48, 3.0)
    return (noise < np.quantile(noise, 0.6)).astype(np.uint8)


def make_grains(count=12, size=24):
    """Returns labels of Voronoi cells."""
    centers = np.random.default_rng(2).random((count, 3)) * size
    cells = np.stack(np.meshgrid(*3 * [np.arange(size) + 0.5], indexing="ij"), axis=-1)
    distances = np.linalg.norm(cells[..., None, :] - centers, axis=-1)
    return (1 + distances.argmin(axis=-1)).astype(np.uint8)


def crop_atlas():
    """Returns labels of a part of the brain, each second voxel."""
    if not os.path.exists(ATLAS):
        pytest.skip("install Debian's mricron-data")
    with gzip.open(ATLAS) as file:
        data = file.read()
    size = np.frombuffer(data, "<i2", 3, 42)
    begin = int(np.frombuffer(data, "<f4", 1, 108)[0])
    labels = np.frombuffer(data, "u1", size.prod(), begin).reshape(size, order="F")
    return np.ascontiguousarray(labels[20:100:2, 60:140:2, 60:140:2])


def make_case(name, make=vfm.hexes):
    if name == "ball and plate":
        shapes = vfm.shapes("sphere radius=0.45 center=0,0,0.9; box size=2,2,1 center=0,0,0 "
                            "material=2", (32, 32, 24), bounds=(-1, 1, -1, 1, 0, 1.5))
        return make(shapes, names=["ball", "plate"])
    if name == "tets":
        return vfm.tets(labels=make_grains(), label_smoothing=3)
    labels = {"pores": make_pores, "grains": make_grains, "atlas": crop_atlas}[name]()
    return make(labels=labels, label_smoothing=3, minimum_region_cells=3)


def check_mesh(case, ranks=1, warped=0):
    """Checks a case by OpenFOAM, and prints its figures.

    warped: number of faces that OpenFOAM may fail to decompose into good tetrahedra.
    """
    report = foam.run(foam.CHECKS, case, ranks)
    problems = foam.find_problems(report)
    faces = re.findall(r"face tets: (\d+) faces", report)
    print("faces with poor tetrahedra: %s" % ", ".join(faces or ["0"]))
    assert len(problems) == len(faces) and all(int(face) <= warped for face in faces), problems
    assert warped or "\nMesh OK.\n" in report, report
    for line in report.splitlines():
        if any(word in line for word in (" cells: ", "non-orthogonality Max", "Max skewness")):
            print(line.strip())
    return report


@pytest.mark.parametrize("name", ["ball and plate", "pores", "grains", "tets", "atlas"])
def test_check_mesh(name, tmp_path):
    mesh = make_case(name)
    for binary in (False, True):
        case = tmp_path / str(binary)
        case.mkdir()
        mesh.save(case / "mesh.foam", binary=binary)
        report = check_mesh(case, warped=WARPED if name == "atlas" else 0)
        found = foam.PolyMesh(case)
        assert np.array_equal(found.points, mesh.points)
        assert found.owner.max() + 1 == len(mesh.cells)
        for material in mesh.materials["Name"]:
            assert " %s " % foam.word(material) in report, material


def make_plane(name):
    """Returns meshes of a plane."""
    make = vfm.tets if name.startswith("triangles") else vfm.hexes
    if name.endswith("disc"):
        return flat.make_disc(make.__name__, 24)
    labels = make_grains()[:, :, 12]
    words = {"periodic": "xy"} if name.endswith("periodic") else {}
    axis = {"across x": 0, "across y": 1}.get(name, 2)
    return make(labels=np.expand_dims(labels, axis), flat=True, label_smoothing=3, **words)


@pytest.mark.parametrize("name", ["quads", "triangles", "quads disc", "triangles disc", "across x",
                                  "across y", "quads periodic", "triangles periodic"])
def test_planes(name, tmp_path):
    """A mesh of a plane is a layer of prisms of two dimensions for OpenFOAM. Triangles with two
    edges on the boundary are its only cells of small determinant: it counts inner faces only."""
    mesh = make_plane(name)
    alone = 0 if "periodic" in name else int(((mesh.neighbours() >= 0).sum(axis=1) < 2).sum())
    print("%s: %d elements, with one neighbour: %d" % (name, len(mesh), alone))
    assert alone == 0 or mesh.kind == "triangle"
    small = ["Cells with small determinant (< 0.001) found, number of cells: %d" % alone] * (
        alone > 0)
    axis = "xyz"[int(mesh.fields["FlatAxis"][0])]
    for binary in (False, True):
        case = tmp_path / str(binary)
        case.mkdir()
        mesh.save(case / "mesh.foam", binary=binary)
        report = foam.run(foam.CHECKS, case)
        assert foam.find_problems(report) == small, report
        assert "Mesh has 2 geometric (non-empty/wedge) directions" in report, report
        found = foam.PolyMesh(case)
        assert len(found.points) == 2 * len(mesh.points)
        assert np.array_equal(found.points[:len(mesh.points)], mesh.points)
        assert found.owner.max() + 1 == len(mesh)
        ends = [found.patches[axis + end] for end in ("_min", "_max")]
        assert all(patch["type"] == "empty" and int(patch["nFaces"]) == len(mesh)
                   for patch in ends)
        for material in mesh.materials["Name"]:
            assert " %s " % foam.word(material) in report, material


@pytest.mark.parametrize("name", ["ball and plate", "pores", "grains", "atlas"])
def test_polyhedra(name, tmp_path):
    """checkMesh accepts polyhedra around the nodes of tetrahedra; materials keep their volumes."""
    mesh = make_case(name, vfm.tets)
    mesh.save(tmp_path / "mesh.foam", polyhedra=True, binary=True)
    report = foam.run("checkMesh -constant", tmp_path)
    assert report.rstrip().endswith("Mesh OK.\n\nEnd"), report
    for line in report.splitlines():
        if any(word in line for word in (" cells: ", "non-orthogonality Max", "Max skewness")):
            print(line.strip())
    cells = int(re.search(r"cells: +(\d+)", report).group(1))
    print("tetrahedra: %d, %.2f a cell" % (len(mesh.cells), len(mesh.cells) / cells))
    assert 4 * cells < len(mesh.cells)
    total = float(re.search(r"Total volume = ([\d.e+-]+)\.", report).group(1))
    assert abs(total / mesh.volumes().sum() - 1) < 1e-9


def make_round_pores():
    """Returns labels of 40 pores, spheres at random places that overlap: pores 1, solid 0."""
    random = np.random.default_rng(0)
    centers, radii = random.uniform(0, 32, (40, 3)), random.uniform(2, 32 / 6, 40)
    cells = np.stack(np.meshgrid(*3 * [np.arange(32) + 0.5], indexing="ij"), axis=-1)
    distances = np.linalg.norm(cells[..., None, :] - centers, axis=-1)
    return (distances < radii).any(axis=-1).astype(np.uint8)


@pytest.mark.parametrize("first, bent", [(0, 150), (0.1, 360)], ids=["even", "first"])
def test_layers_on_walls(first, bent, tmp_path):
    """checkMesh accepts layers on the walls of pores. With all checks, some of the 85,395 faces
    fail: they are bent too much for tetrahedra, which only the tracking of particles uses."""
    words = {"layers": 3, "layer_growth": 1.5, "first_layer": first} if first else {"layers": 3}
    mesh = vfm.hexes(labels=make_round_pores(), label_smoothing=3, **words)
    assert (mesh.layer == 3).sum() == (mesh.layer == 1).sum() > 5000
    mesh.save(tmp_path / "mesh.foam")
    report = foam.run("checkMesh -constant", tmp_path)
    assert report.rstrip().endswith("Mesh OK.\n\nEnd"), report
    check_mesh(tmp_path, warped=bent)


def write_input(folder, labels):
    np.save(folder / "labels.npy", labels)


def run_sculptor(folder, case, ranks, *options):
    """Meshes labels.npy in a folder as a case."""
    if not os.access(SCULPTOR, os.X_OK):
        pytest.skip("there is no %s: build it, or set SCULPTOR" % SCULPTOR)
    if not shutil.which("mpirun"):
        pytest.skip("there is no mpirun")
    case.mkdir(exist_ok=True)
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    subprocess.run([*foam.MPI_RUN, str(ranks), SCULPTOR, folder / "labels.npy",
                    case / "mesh.foam", "--label-smoothing", "3", "--quiet", *options],
                   check=True, env=environment)


def canonical(mesh):
    """Returns the faces of a mesh by coordinates of their corners, ordered."""
    corners = np.round(np.sort(mesh.points[mesh.faces].view("f8,f8,f8")[..., 0], axis=1)
                       .view(float).reshape(len(mesh.faces), -1), 6)
    return corners[np.lexsort(corners.T)]


def write_field(case, count, body):
    """Writes the field T, with its cell numbers or given values, at time 1."""
    patches = "boundaryField { \".*\" { type zeroGradient; } \"proc.*\" { type processor; } }\n"
    foam.write(case, "1/T", "dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform List<scalar> "
               "%d\n(\n%s\n);\n%s" % (count, "\n".join(body), patches), "volScalarField")


@pytest.mark.parametrize("binary", [False, True])
def test_three_ranks(binary, tmp_path):
    """checkMesh runs on the case of three ranks. It reconstructs to the case of one rank: its mesh
    by reconstructParMesh, a field by reconstructPar, whose addressing is the writer's."""
    write_input(tmp_path, make_pores())
    options = ["--binary"] if binary else []
    one, three = tmp_path / "one", tmp_path / "three"
    run_sculptor(tmp_path, one, 1, *options)
    run_sculptor(tmp_path, three, 3, *options)
    check_mesh(three, 3)
    whole = foam.PolyMesh(one)
    for rank in range(3):
        part = foam.PolyMesh(three / ("processor%d" % rank))
        cells = part.addressing["cell"]
        write_field(three / ("processor%d" % rank), len(cells), cells.astype(str))
    rebuilt = tmp_path / "rebuilt"
    shutil.copytree(three, rebuilt)
    shutil.copytree(one / "constant", three / "constant")
    foam.run("reconstructPar -time 1", three)
    found = foam.read_field(three / "1" / "T")
    assert np.array_equal(found, np.arange(whole.owner.max() + 1))
    foam.run("reconstructParMesh -constant -mergeTol 1e-9", rebuilt)
    check_mesh(rebuilt)
    again = foam.PolyMesh(rebuilt)
    assert len(again.points) == len(whole.points) and len(again.neighbour) == len(whole.neighbour)
    assert np.allclose(canonical(again), canonical(whole), rtol=0, atol=1e-5)
    assert ({name: patch["nFaces"] for name, patch in again.patches.items()} ==
            {name: patch["nFaces"] for name, patch in whole.patches.items()})


THERMO = """thermoType { type heSolidThermo; mixture pureMixture; transport constIso; thermo hConst;
  equationOfState rhoConst; specie specie; energy sensibleEnthalpy; }
mixture { specie { molWeight 1; } equationOfState { rho 1; } transport { kappa %g; }
  thermodynamics { Hf 0; Cp 1; } }
"""
SOURCE = """heat { type scalarSemiImplicitSource; active yes; scalarSemiImplicitSourceCoeffs
{ selectionMode all; volumeMode specific; injectionRateSuSp { h (1 0); } } }
"""
SCHEMES = """ddtSchemes { default steadyState; } gradSchemes { default leastSquares; }
divSchemes { default none; } laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; } snGradSchemes { default corrected; }
"""
SOLUTION = """solvers { h { solver PCG; preconditioner DIC; tolerance 1e-12; relTol 0.001; } }
SIMPLE { nNonOrthogonalCorrectors 2; }
"""
TEMPERATURE = """dimensions [0 0 0 1 0 0 0]; internalField uniform 300;
boundaryField { "[xyz]_m.*" { type fixedValue; value uniform 300; }
  "b.*" { type compressible::turbulentTemperatureRadCoupledMixed; Tnbr T; value uniform 300;
    kappaMethod solidThermo; } }
"""
PRESSURE = """dimensions [1 -1 -2 0 0 0 0]; internalField uniform 1e5;
boundaryField { ".*" { type calculated; value uniform 1e5; } }
"""


def set_up_regions(case):
    """Makes a case of conjugate heat transfer, a region per cell zone."""
    foam.write(case, "constant/regionProperties", "regions ( fluid () solid (ball block) );\n")
    foam.write(case, "constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);\n",
               "uniformDimensionedVectorField")
    foam.run("splitMeshRegions -cellZones -overwrite", case)
    for number, region in enumerate(("ball", "block"), 1):
        constant, system = "constant/%s/" % region, "system/%s/" % region
        foam.write(case, constant + "thermophysicalProperties", THERMO % CONDUCTIVITY[number])
        foam.write(case, constant + "radiationProperties",
                   "radiation off; radiationModel none;\n")
        foam.write(case, constant + "fvOptions", SOURCE)
        foam.write(case, system + "fvSchemes", SCHEMES)
        foam.write(case, system + "fvSolution", SOLUTION)
        foam.write(case, "0/%s/T" % region, TEMPERATURE, "volScalarField")
        foam.write(case, "0/%s/p" % region, PRESSURE, "volScalarField")
    foam.set_entry(case, "system/controlDict", "endTime", 300)
    foam.set_entry(case, "system/controlDict", "writeInterval", 300)


def make_finer(kind):
    """Returns the ball in a block with cells of half the width."""
    bounds = np.stack([-HALF, HALF], axis=1).ravel()
    return getattr(vfm, kind)(vfm.shapes(SHAPES, (20, 24, 16), bounds=bounds),
                              names=["ball", "block"])


def test_two_conductivities(tmp_path):
    """Regions by cell zones: the greatest temperature agrees with finite elements up to the errors
    of both methods."""
    mesh = make_finer("hexes")
    mesh.save(tmp_path / "mesh.foam")
    set_up_regions(tmp_path)
    foam.run("chtMultiRegionSimpleFoam", tmp_path)
    cells = {region: foam.read_numbers(tmp_path / "constant" / region / foam.MESH /
                                       "cellRegionAddressing") for region in ("ball", "block")}
    assert all((mesh.material[cells[region]] == number).all()
               for number, region in enumerate(("ball", "block"), 1))
    found = max(foam.read_field(tmp_path / "300" / region / "T").max() - 300 for region in cells)
    expected = solve(mesh.points, mesh.cells, mesh.material, fixed_points(mesh.points)).max()
    print("greatest u %.6g, by finite elements %.6g" % (found, expected))
    assert abs(found / expected - 1) < 0.03


def exact_mean():
    """Returns the mean of u in the block with conductivity 1, from its series."""
    odd = np.arange(1, 200, 2)
    x, y, z = np.meshgrid(odd, odd, odd, indexing="ij")
    waves = sum((np.pi * n / (2 * half)) ** 2 for n, half in zip((x, y, z), HALF))
    return (512 / (np.pi ** 6 * (x * y * z) ** 2.0) / waves).sum()


@pytest.mark.parametrize("kind", ["hexes", "tets"])
def test_recipe(kind, tmp_path):
    """Conductivity 1: the error of the mean of u falls with the cell width, or is small (tets)."""
    errors = []
    for name, mesh in (("coarse", make_mesh(kind)), ("fine", make_finer(kind))):
        case = tmp_path / name
        case.mkdir()
        run_recipe("OpenFOAM", mesh, case)
        found = foam.read_field(case / "100" / "T")
        mean = (found * mesh.volumes()).sum() / mesh.volumes().sum()
        errors.append(abs(mean / exact_mean() - 1))
    print("%s: errors of the mean of u %.4f, %.4f" % (kind, *errors))
    assert errors[1] < max(errors[0] / 3, 0.005), errors
