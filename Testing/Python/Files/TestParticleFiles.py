"""Particles in mesh files of all formats, read back: number, places, masses, velocities, and their
sums of mass and momentum. Readers are those of VTK, ncdump, CalculiX (if it is installed), and
parsers of columns as the manuals of the formats give them.

The program ParticleFiles (VFM_PARTICLE_FILES) writes the files.
"""
import os
import re
import shutil
import subprocess
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader
from vtkmodules.vtkIOIOSS import vtkIOSSReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from exodus_dump import Dump, join_parts_of_particles
NAMES = {1: "one_particles", 3: "three_particles"}
IDS = {1: 5, 3: 7}  # of parts: after the materials 1 to 3, and 4 for a void
COUNT = 203
EXACT = 1e-13


class Expected:
    """The particles of a folder, ascending by id."""

    def __init__(self, folder):
        self.folder = folder
        table = np.loadtxt(os.path.join(folder, "particles.txt"))
        self.id, self.material = table[:, :2].T.astype(int)
        self.x, self.v = table[:, 2:5], table[:, 8:11]
        self.radius, self.volume, self.mass = table[:, 5:8].T
        self.energy = table[:, 11]
        assert len(table) == COUNT and (np.diff(self.id) > 0).all()
        self.has_mass = os.path.basename(folder) != "plain"

    def path(self, name):
        return os.path.join(self.folder, name)

    def lines(self, name):
        with open(self.path(name)) as file:
            return file.read().split("\n")


def near(found, wanted, error):
    """Checks that numbers agree, each relative to itself."""
    found, wanted = np.asarray(found, float), np.asarray(wanted, float)
    assert found.shape == wanted.shape, (found.shape, wanted.shape)
    assert (np.abs(found - wanted) <= error * np.abs(wanted)).all(), (
        np.max(np.abs(found - wanted) / np.abs(wanted)))


def check(want, x, mass=None, v=None, errors=(0, 0, 0)):
    """Checks places, masses, velocities, and the sums of mass and momentum.

    errors: relative, of a coordinate, mass and component. Those of sums follow; 1e-13 is added.
    """
    near(x, want.x, errors[0])
    if mass is not None:
        near(mass, want.mass, errors[1])
        assert abs(np.sum(mass) - want.mass.sum()) <= (errors[1] + EXACT) * want.mass.sum()
    if v is not None:
        near(v, want.v, errors[2])
    if mass is not None and v is not None:
        weights = np.abs(want.mass[:, None] * want.v).sum(0)
        momentum = (np.asarray(mass)[:, None] * v).sum(0) - (want.mass[:, None] * want.v).sum(0)
        assert (np.abs(momentum) <= (errors[1] + errors[2] + EXACT) * weights).all()


def check_vtp(folders):
    for want in folders("hex", "tet", "plain"):
        names = ["mesh_particles.vtp", "only.vtp", "parts_particles.vtp"]
        for name in names:
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(want.path(name))
            reader.Update()
            data = reader.GetOutput()
            assert data.GetNumberOfVerts() == data.GetNumberOfPoints() == COUNT
            get = lambda array: vtk_to_numpy(data.GetPointData().GetArray(array))
            assert (get("Id") == want.id).all() and (get("MaterialId") == want.material).all()
            check(want, vtk_to_numpy(data.GetPoints().GetData()),
                  get("Mass") if want.has_mass else None, get("Velocity"))
            assert data.GetPointData().HasArray("Mass") == want.has_mass
            near(get("Radius"), want.radius, 0)
            near(get("Volume"), want.volume, 0)
            near(get("energy"), want.energy, 0)
            assert get("stress").shape == (COUNT, 6)
            field = data.GetFieldData()
            assert field.GetArray("TimeValue").GetValue(0) == 0.5
            assert field.GetAbstractArray("MaterialNames").GetNumberOfValues() == 3
            assert not field.HasArray("DomainBounds")


def read_blocks(path):
    """Returns {name: block} of VTK's IOSS reader; all parts of a decomposed file."""
    reader = vtkIOSSReader()
    reader.AddFileName(path)
    reader.UpdateInformation()
    for selection in (reader.GetElementBlockSelection(), reader.GetElementBlockFieldSelection(),
                      reader.GetNodeBlockFieldSelection()):
        selection.EnableAllArrays()
    reader.Update()
    collection = reader.GetOutputDataObject(0)
    blocks = {}
    for i in range(collection.GetNumberOfPartitionedDataSets()):
        name = collection.GetMetaData(i).Get(collection.NAME())
        parts = collection.GetPartitionedDataSet(i)
        blocks[name] = [parts.GetPartition(p) for p in range(parts.GetNumberOfPartitions())]
    return blocks


def check_exodus_by_vtk(folders):
    for want in folders("hex", "tet", "plain"):
        for name in ("mesh.e", "parts.e.3.0"):
            blocks = read_blocks(want.path(name))
            assert len(blocks) >= 5
            rows = {}
            for material, block in NAMES.items():
                for part in blocks[block]:
                    cells = part.GetCellData()
                    get = lambda array: vtk_to_numpy(cells.GetArray(array))
                    x = vtk_to_numpy(part.GetPoints().GetData())
                    for c in range(part.GetNumberOfCells()):
                        assert part.GetCell(c).GetNumberOfPoints() == 1
                        point = part.GetCell(c).GetPointId(0)
                        rows[int(get("Id")[c])] = (
                            x[point], get("Mass")[c] if want.has_mass else 0, get("Velocity")[c],
                            get("radius")[c], get("volume")[c], get("energy")[c], material)
                        if want.has_mass:
                            nodal = vtk_to_numpy(part.GetPointData().GetArray("NodalVelocity"))
                            assert (nodal[point] == get("Velocity")[c]).all()
            x, mass, v, radius, volume, energy, material = (
                np.array(column) for column in zip(*(rows[i] for i in sorted(rows))))
            assert sorted(rows) == want.id.tolist() and (material == want.material).all()
            check(want, x, mass if want.has_mass else None, v)
            near(radius, want.radius, 0)
            near(volume, want.volume, 0)
            near(energy, want.energy, 0)


def check_exodus_by_ncdump(folders):
    for want in folders("hex", "tet", "plain"):
        found = {}
        for names in (["mesh.e"], ["parts.e.3.%d" % rank for rank in range(3)]):
            dumps = [Dump(want.path(name)) for name in names]
            rows = join_parts_of_particles(dumps)
            assert len(rows) == COUNT
            found[len(names)] = rows
            numbers = [n for dump in dumps for n in dump.get("elem_num_map").tolist()]
            assert len(set(numbers)) == len(numbers) == sum(d.size("num_elem") for d in dumps)
            elements = sorted(numbers)[:-COUNT]
            assert sorted(row["id"] for row in rows) == list(
                range(elements[-1] + 1, elements[-1] + 1 + COUNT))
            # nodes of particles are in no set, also at the corner of the domain
            nodes = {row["node"] for row in rows}
            assert len(nodes) == COUNT
            for dump in dumps:
                ids = dump.get("node_num_map")
                for name, values in dump.values.items():
                    assert not re.fullmatch(r"node_ns\d+", name) or not nodes & set(
                        ids[values - 1].tolist())
            assert {row["block"]: row["name"] for row in rows} == {
                IDS[m]: NAMES[m] for m in NAMES}
            values = lambda key: np.array([row[key] for row in rows])
            check(want, values("x"), values("Mass") if want.has_mass else None,
                  np.stack([values("Velocity_" + axis) for axis in "XYZ"], 1))
            near(values("attributes"), np.stack([want.radius, want.volume], 1), 0)
            assert (values("Id") == want.id).all()
            if len(names) == 3:
                assert all(d.get("el_blk_cnt_global").tolist()[-2:] == [
                    (want.material == m).sum() for m in NAMES] for d in dumps)
                assert dumps[0].size("num_elems_global") == len(numbers)
                for dump in dumps:
                    inner = np.concatenate([dump.get("elem_mapi"), dump.get("elem_mapb")])
                    assert sorted(inner) == list(range(1, dump.size("num_elem") + 1))
        assert found[1] == found[3]


def numbers_of(line, *widths):
    """Returns the fields of a line."""
    ends = np.cumsum(widths)
    return [line[end - width:end] for width, end in zip(widths, ends)]


def block_of(lines, keyword):
    """Returns the lines after a keyword, up to the next one, without comments."""
    block = []
    for line in lines[lines.index(keyword) + 1:]:
        if line[:1] in ("", "*", "/"):
            break
        if line[0] not in "$#":
            block.append(line)
    return block


def by_node(want, pairs):
    """Returns values in the order of nodes."""
    table = dict(pairs)
    assert len(table) == COUNT
    return np.array([table[node] for node in sorted(table)])


def check_ls_dyna(folders):
    for want in folders("hex", "tet", "plain"):
        lines = want.lines("mesh.k")
        nodes = {int(l[:8]): [float(f) for f in numbers_of(l[8:], 16, 16, 16)]
                 for l in block_of(lines, "*NODE")}
        rows = [(int(a), int(b), float(c)) for a, b, c in (
            numbers_of(l, 8, 8, 16) for l in block_of(lines, "*ELEMENT_SPH"))]
        assert max(nodes) == len(nodes) == max(node for node, _, _ in rows)
        assert (by_node(want, [(n, p) for n, p, _ in rows])
                == [IDS[m] for m in want.material]).all()
        mass = by_node(want, [(n, m) for n, _, m in rows])
        speeds = {int(l[:10]): [float(f) for f in numbers_of(l[10:], 10, 10, 10)]
                  for l in block_of(lines, "*INITIAL_VELOCITY_NODE")}
        v = [speeds[n] for n in sorted(n for n, _, _ in rows)]
        assert len(speeds) == (len(nodes) if want.has_mass else COUNT)
        x = [nodes[n] for n in sorted(n for n, _, _ in rows)]
        check(want, x, mass if want.has_mass else None, v, (5e-10, 5e-10, 5e-4))
        if not want.has_mass:
            near(-mass, want.volume, 5e-9)
        parts = [block_of(lines[i:], "*PART") for i, l in enumerate(lines) if l == "*PART"]
        assert {tuple(int(f) for f in numbers_of(p[1], 10, 10, 10)) for p in parts[3:]} == {
            (IDS[m], 2, m) for m in IDS} and [p[0] for p in parts[3:]] == list(NAMES.values())
        assert block_of(lines, "*SECTION_SPH") == ["         2"]


def check_open_radioss(folders):
    for want in folders("hex", "plain"):
        lines = want.lines("mesh.rad")
        nodes = {int(l[:10]): [float(f) for f in numbers_of(l[10:], 20, 20, 20)]
                 for l in block_of(lines, "/NODE")}
        rows = []
        for material, part in IDS.items():
            name = NAMES[material]
            assert block_of(lines, "/PART/%d" % part) == [
                name, "%10d%10d%10d" % (part, material, 0)]
            title, first, second = block_of(lines, "/PROP/TYPE34/%d" % part)
            masses = want.mass[want.material == material]
            near(float(first[:20]), masses.mean() if want.has_mass else 0, 1e-13)
            assert title == name and len(first) == 100 and len(second) == 50
            for line in block_of(lines, "/SPHCEL/%d" % part):
                node, kind, mass = numbers_of(line, 10, 10, 20)
                assert int(kind) == (1 if want.has_mass else 2) and len(line) == 40
                rows.append((int(node), (part, float(mass))))
        table = by_node(want, rows)
        assert (table[:, 0] == [IDS[m] for m in want.material]).all()
        state = block_of(lines, "/INIVEL/NODE/1")[1::2]
        speeds = {int(l[:10]): [float(f) for f in numbers_of(l[20:], 20, 20, 20)] for l in state}
        assert len(speeds) == (len(nodes) if want.has_mass else COUNT)
        order = sorted(n for n, _ in rows)
        near(table[:, 1], want.mass if want.has_mass else want.volume, 5e-14)
        check(want, [nodes[n] for n in order], table[:, 1] if want.has_mass else None,
              [speeds[n] for n in order], (5e-14, 5e-14, 5e-14))


def check_nastran(folders):
    read = lambda text: float(re.sub(r"(?<=[\d.])([+-])", r"e\1", text.strip()))
    for want in folders("hex", "tet", "plain"):
        lines = want.lines("mesh.bdf")
        nodes = {int(a[8:24]): [read(a[40:56]), read(a[56:72]), read(b[8:24])]
                 for a, b in zip(lines, lines[1:]) if a.startswith("GRID*")}
        cards = [numbers_of(l, 8, 16, 16, 16, 16) for l in lines if l.startswith("CONM2*")]
        if want.has_mass:
            elements = [int(l[8:16]) for l in lines if re.match("CHEXA|CTETRA", l)]
            assert sorted(int(c[1]) for c in cards) == list(
                range(max(elements) + 1, max(elements) + 1 + COUNT))
            mass = by_node(want, [(int(c[2]), read(c[4])) for c in cards])
        assert len(cards) == (COUNT if want.has_mass else 0)
        x = [nodes[n] for n in sorted(nodes)[-COUNT:]]
        check(want, x, mass if want.has_mass else None, None, (5e-11, 5e-11, 0))
        text = "\n".join(lines)
        for material, name in NAMES.items():
            group = re.search(r"\$ Nodes (\d+): %s\nSET1    ((?:.*\n\+)*.*)" % name, text)
            fields = re.sub(r"\n\+", " ", group.group(2)).split()
            first = len(nodes) - COUNT + 1
            assert fields[0] == group.group(1) and [int(f) for f in fields[1:]] == (
                np.flatnonzero(want.material == material) + first).tolist()


def check_abaqus(folders):
    for want in folders("hex", "tet", "plain"):
        text = "\n".join(want.lines("mesh.inp"))
        nodes = {int(l.split(",")[0]): [float(f) for f in l.split(",")[1:]]
                 for l in block_of(text.split("\n"), "*NODE, NSET=NALL")}
        pairs = re.findall(r"\*ELEMENT, TYPE=MASS, ELSET=(\w+)\n(\d+),(\d+)\n"
                           r"\*MASS, ELSET=\1\n(.*)\n", text)
        assert len(pairs) == len({p[1] for p in pairs}) == (COUNT if want.has_mass else 0)
        speeds = {}
        for line in block_of(text.split("\n"), "*INITIAL CONDITIONS, TYPE=VELOCITY"):
            node, axis, value = line.split(",")
            speeds.setdefault(int(node), []).append(float(value))
        order = sorted(nodes)[-COUNT:]
        mass = by_node(want, [(int(p[2]), float(p[3])) for p in pairs]) if pairs else None
        check(want, [nodes[n] for n in order], mass, [speeds[n] for n in order],
              (5e-14, 5e-14, 5e-14))
        for material, name in NAMES.items():
            chosen = np.flatnonzero(want.material == material)
            keys = ["*NSET, NSET=" + name.upper()]
            wanted = [chosen + order[0]]
            if pairs:
                first = min(int(p[1]) for p in pairs)
                keys.append("*ELSET, ELSET=" + name.upper())
                wanted.append(chosen + first)
            for key, numbers in zip(keys, wanted):
                found = "".join(block_of(text.split("\n"), key)).strip(",").split(",")
                assert [int(f) for f in found] == numbers.tolist()


def check_calculix(folders):
    """A force of 1000 times the mass moves each particle by 500 in a unit of time."""
    if not shutil.which("ccx"):
        print("ccx is not installed")
        return
    want, = folders("hex")
    first = max(int(l.split(",")[0]) for l in block_of(
        want.lines("mesh.inp"), "*NODE, NSET=NALL")) - COUNT + 1
    # CalculiX applies no forces to nodes of which no element has a stiffness: springs of nearly 0
    springs = "\n".join("%d,%d,%d" % (900000 + i, first + i, first - 1) for i in range(COUNT))
    forces = "\n".join("%d,3,%.12e" % (first + i, 1000 * m) for i, m in enumerate(want.mass))
    with open(want.path("run.inp"), "w") as file:
        file.write("""*INCLUDE, INPUT=mesh.inp
*NSET, NSET=MESH, GENERATE
1,%d
*MATERIAL, NAME=STEEL
*ELASTIC
210e9, 0.3
*DENSITY
7800
*SOLID SECTION, ELSET=EALL, MATERIAL=STEEL
*ELEMENT, TYPE=SPRINGA, ELSET=SPRINGS
%s
*SPRING, ELSET=SPRINGS

1.e-18
*BOUNDARY
MESH, 1, 3
*STEP
*DYNAMIC, ALPHA=0, DIRECT
0.1, 1.
*CLOAD
%s
*NODE PRINT, NSET=ONE_PARTICLES, FREQUENCY=10
U
*NODE PRINT, NSET=THREE_PARTICLES, FREQUENCY=10
U
*END STEP
""" % (first - 1, springs, forces))
    run = subprocess.run(["ccx", "run"], cwd=want.folder, stdout=subprocess.PIPE, text=True)
    assert run.returncode == 0 and "*ERROR" not in run.stdout, run.stdout
    rows = [l.split() for l in want.lines("run.dat") if re.match(r"\s+\d+(\s+\S+){3}$", l)]
    u = by_node(want, [(int(r[0]), [float(f) for f in r[1:]]) for r in rows])
    near(u[:, :2], want.v[:, :2], 1e-6)
    assert np.abs(u[:, 2] - want.v[:, 2] - 500).max() < 1e-3


def check_lammps(folders):
    for want in folders("hex", "tet"):
        text = "\n".join(want.lines("mesh.data"))
        head, atoms = text.split("\nAtoms # sphere\n\n")
        atoms, speeds = atoms.split("\n\nVelocities\n\n")
        assert re.search(r"^203 atoms$", head, re.M) and re.search(r"^3 atom types$", head, re.M)
        assert "# type 1: material 1, one\n" in head and "# type 3: material 3, three\n" in head
        table = np.array([l.split() for l in atoms.split("\n")], float)
        assert (table[:, 0] == np.arange(1, COUNT + 1)).all()
        assert (table[:, 1] == want.material).all()
        near(table[:, 2], 2 * want.radius, 0)
        v = np.array([l.split() for l in speeds.strip().split("\n")], float)
        assert (v[:, 0] == table[:, 0]).all() and not v[:, 4:].any()
        mass = table[:, 3] * np.pi / 6 * table[:, 2]**3
        check(want, table[:, 4:], mass, v[:, 1:4], (0, 2e-15, 0))
        box = np.array([re.search(r"^(\S+) (\S+) %slo %shi$" % (a, a), head, re.M).groups()
                        for a in "xyz"], float)
        assert (table[:, 4:] >= box[:, 0]).all() and (table[:, 4:] <= box[:, 1]).all()


def read_cloud(want, folder, name, columns):
    """Returns the values of a field of a cloud."""
    lines = want.lines(os.path.join(folder, "0/lagrangian/particles", name))
    first = lines.index("(")
    rows = [re.sub("[()]", "", l).split() for l in lines[first + 1:lines.index(")")]]
    assert int(lines[first - 1]) == len(rows)
    return np.array(rows, float).reshape(-1, columns)


def check_open_foam(folders):
    for want in folders("hex", "tet", "plain"):
        parts = ["parts/processor%d" % rank for rank in range(3)]
        for places in ([""], parts):
            get = lambda name, columns: np.concatenate(
                [read_cloud(want, place, name, columns) for place in places])
            x = get("positions", 4)
            assert (x[:, 3] == -1).all()
            keys = {tuple(row): i for i, row in enumerate(want.x.tolist())}
            order = np.argsort([keys[tuple(row)] for row in x[:, :3].tolist()])
            diameter, number = get("d", 1)[order, 0], get("nParticle", 1)[order, 0]
            assert (number == 1).all() and len(order) == COUNT
            mass = get("rho", 1)[order, 0] * np.pi / 6 * diameter**3 if want.has_mass else None
            check(want, x[order, :3], mass, get("U", 3)[order], (0, 2e-15, 0))
            assert os.path.exists(want.path(os.path.join(
                places[0], "0/lagrangian/particles/rho"))) == want.has_mass


def check_open_foam_by_vtk(folders):
    """VTK's reader has floats of points."""
    want, = folders("hex")
    reader = vtkOpenFOAMReader()
    reader.SetFileName(want.path("mesh.foam"))
    reader.UpdateInformation()
    reader.EnableAllLagrangianArrays()
    reader.EnableAllPatchArrays()
    reader.UpdateTimeStep(0)
    reader.Update()
    iterator = reader.GetOutput().NewIterator()
    clouds = []
    while not iterator.IsDoneWithTraversal():
        data = iterator.GetCurrentDataObject()
        if data.GetPointData().HasArray("nParticle"):
            clouds.append(data)
        iterator.GoToNextItem()
    assert len(clouds) == 1
    get = lambda name: vtk_to_numpy(clouds[0].GetPointData().GetArray(name))
    check(want, vtk_to_numpy(clouds[0].GetPoints().GetData()), None, get("U"), (1e-7, 0, 1e-7))


CHECKS = (check_vtp, check_exodus_by_vtk, check_exodus_by_ncdump, check_ls_dyna, check_open_radioss,
          check_nastran, check_abaqus, check_lammps, check_open_foam, check_open_foam_by_vtk,
          check_calculix)
with tempfile.TemporaryDirectory() as at:
    subprocess.run([os.environ["VFM_PARTICLE_FILES"], at], check=True)
    for check_format in CHECKS:
        check_format(lambda *names: [Expected(os.path.join(at, name)) for name in names])
        print(check_format.__name__, flush=True)
