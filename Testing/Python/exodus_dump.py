"""Reads Exodus files through the text of ncdump.

ncdump shares no code with the writer or with ParaView's readers. Parts of one mesh are joined by
global ids, so that meshes can be compared however they are split into files.
"""
import re
import subprocess

import numpy as np

# Nodes of the sides, from 0, as drawn in the Exodus manual: counterclockwise from outside.
SIDES = {8: np.array([[1, 2, 6, 5], [2, 3, 7, 6], [3, 4, 8, 7], [1, 5, 8, 4], [1, 4, 3, 2],
                      [5, 6, 7, 8]]) - 1,
         4: np.array([[1, 2, 4], [2, 3, 4], [1, 4, 3], [1, 3, 2]]) - 1}


def run_ncdump(*arguments):
    return subprocess.run(["ncdump", *arguments], check=True, stdout=subprocess.PIPE,
                          text=True).stdout


def kind(path):
    """Returns the file format: '64-bit offset', 'netCDF-4', ..."""
    return run_ncdump("-k", path).strip()


def parse_values(text):
    if '"' in text:
        return [re.sub(r"\\(.)", r"\1", value)
                for value in re.findall(r'"((?:[^"\\]|\\.)*)"', text)]
    words = text.replace("\n", " ").split(",")
    whole = all(re.fullmatch(r"\s*-?\d+\s*", word) for word in words)
    return np.array([int(word) for word in words],
                    np.int64) if whole else np.array([float(word) for word in words])


class Dump:
    """Contents of one file: sizes, attributes and variables as flat lists.

    The keys are the names that the Exodus library uses.
    """

    def __init__(self, path):
        text = run_ncdump("-p", "9,17", path)
        head, _, data = text.partition("\ndata:\n")
        self.sizes = {name: int(size)
                      for name, size in re.findall(r"^\t(\w+) = (?:UNLIMITED ; // \()?(\d+)", head,
                                                   re.M)}
        self.attributes = dict(re.findall(r'^\t\t(\w*:\w+) = "?(.*?)"? ;$', head, re.M))
        self.types = {name: word
                      for word, name in re.findall(r"^\t(\w+) (\w+)(?:\(|;| ;)", head, re.M)}
        # A value may contain ";"; a line that ends with " ;" ends the variable.
        self.values = {name: parse_values(values)
                       for name, values in re.findall(r"^ (\w+) =\s(.*?) ;$", data, re.M | re.S)}

    def size(self, name):
        return self.sizes.get(name, 0)

    def get(self, name):
        return self.values.get(name, np.zeros(0, np.int64))

    def names(self, kind):
        return self.values.get(kind + "_names", [])

    def elements(self):
        """Returns (block, corner numbers from 0) for each element."""
        found = []
        for i in range(self.size("num_el_blk")):
            count = self.size("num_el_in_blk%d" % (i + 1))
            if count:
                corners = self.get("connect%d" % (i + 1)).reshape(count, -1) - 1
                found += [(i, corners_of) for corners_of in corners]
        return found

    def sides(self, i):
        """Returns element numbers and side numbers of a side set, from 0."""
        return self.get("elem_ss%d" % (i + 1)) - 1, self.get("side_ss%d" % (i + 1)) - 1

    def points(self):
        return np.stack([self.get("coord" + axis) for axis in "xyz"], axis=1).astype(float)

    def variables(self, kind, prefix):
        """Returns {name: values in the order of the elements or nodes}."""
        result = {}
        for v, name in enumerate(self.values.get("name_%s_var" % kind, []), 1):
            parts = ["%s%deb%d" % (prefix, v, b + 1) for b in range(self.size("num_el_blk"))]
            result[name] = np.concatenate([self.get(part)
                                           for part in (parts if kind == "elem"
                                                        else [prefix + str(v)])])
        return result

    def globals(self):
        return dict(zip(self.values.get("name_glo_var", []), self.get("vals_glo_var").tolist()))


def side_corners(dump, i, elements):
    """Returns the corners of each face of a side set, in order."""
    return [elements[e][1][SIDES[len(elements[e][1])][s]] for e, s in zip(*dump.sides(i))]


def add(items, key, value, what):
    """Adds an item and checks that all parts that hold it have the same value."""
    assert items.setdefault(key, value) == value, (what, key)


def rows(variables, count):
    """Returns for each of `count` items a tuple of all variables, ordered by name."""
    return list(zip(*(variables[name].tolist()
                      for name in sorted(variables)))) if variables else [()] * count


def join(dumps):
    """Joins the parts of a mesh to dictionaries by global ids.

    - blocks: {id: name}
    - nodes: {id: (x, y, z, variables ..)}
    - elements: {id: (block id, node ids, variables ..)}
    - sides: {(id, name): set of (element id, node ids of the face)}
    - node sets: {(id, name): set of node ids}
    """
    mesh = {"blocks": {}, "nodes": {}, "elements": {}, "sides": {}, "node sets": {},
            "globals": None}
    for dump in dumps:
        node_ids, element_ids = dump.get("node_num_map").tolist(), dump.get("elem_num_map").tolist()
        elements, points = dump.elements(), dump.points()
        blocks = dump.get("eb_prop1").tolist()
        for block, name in zip(blocks, dump.names("eb")):
            add(mesh["blocks"], block, name, "block")
        variables = rows(dump.variables("nod", "vals_nod_var"), len(node_ids))
        for node, point, values in zip(node_ids, points.tolist(), variables):
            add(mesh["nodes"], node, (*point, *values), "node")
        variables = rows(dump.variables("elem", "vals_elem_var"), len(element_ids))
        for element, (block, corners), values in zip(element_ids, elements, variables):
            assert element not in mesh["elements"], "an element is in two parts"
            mesh["elements"][element] = (blocks[block], tuple(node_ids[c] for c in corners),
                                         *values)
        for i, key in enumerate(zip(dump.get("ss_prop1").tolist(), dump.names("ss"))):
            faces = mesh["sides"].setdefault(key, set())
            new = {(element_ids[e], tuple(sorted(node_ids[c] for c in corners)))
                   for e, corners in zip(dump.sides(i)[0], side_corners(dump, i, elements))}
            assert len(new) == len(dump.sides(i)[0]) and not new & faces, "a side is there twice"
            faces |= new
        for i, key in enumerate(zip(dump.get("ns_prop1").tolist(), dump.names("ns"))):
            mesh["node sets"].setdefault(key,
                                         set()).update(node_ids[n - 1]
                                                       for n in dump.get("node_ns%d" % (i + 1)))
        mesh["globals"] = dump.globals()
    return mesh


def check_parts(dumps):
    """Checks that the Nemesis data of each part agree with all parts together.

    The communication maps must be mutual.
    """
    mesh, shared = join(dumps), {}
    for rank, dump in enumerate(dumps):
        assert (dump.size("num_processors"), dump.size("num_procs_file")) == (len(dumps), 1)
        assert dump.size("num_nodes_global") == len(mesh["nodes"])
        assert dump.size("num_elems_global") == len(mesh["elements"])
        assert dump.get("el_blk_ids_global").tolist() == list(mesh["blocks"]) == dump.get(
            "eb_prop1").tolist()
        counts = [sum(e[0] == block for e in mesh["elements"].values()) for block in mesh["blocks"]]
        assert dump.get("el_blk_cnt_global").tolist() == counts
        for kind, sets, count in (("ss", mesh["sides"], "ss_side_cnt_global"),
                                  ("ns", mesh["node sets"], "ns_node_cnt_global")):
            assert dump.get("%s_ids_global" % kind).tolist() == [key[0] for key in sets]
            assert dump.get(count).tolist() == [len(items) for items in sets.values()]
        node_ids = dump.get("node_num_map")
        ends = dump.get("n_comm_data_idx").tolist()
        assert len(ends) == dump.size("num_n_cmaps")
        nodes, others = dump.get("n_comm_nids") - 1, dump.get("n_comm_proc")
        for start, end, map_id in zip([0] + ends, ends, dump.get("n_comm_ids").tolist()):
            assert set(others[start:end]) == {map_id - 1} and end > start
            shared[rank, map_id - 1] = node_ids[nodes[start:end]].tolist()
        border = set(nodes.tolist())
        assert set((dump.get("node_mapb") - 1).tolist()) == border
        assert set((dump.get("node_mapi") - 1).tolist()) == set(range(len(node_ids))) - border
        on_border = {e for e, (_, corners) in enumerate(dump.elements())
                     if border & set(corners.tolist())}
        assert set((dump.get("elem_mapb") - 1).tolist()) == on_border
        assert len(dump.get("elem_mapi")) + len(on_border) == dump.size("num_elem")
    nodes_of = [set(dump.get("node_num_map").tolist()) for dump in dumps]
    for one in range(len(dumps)):
        for other in range(len(dumps)):
            both = nodes_of[one] & nodes_of[other] if one != other else set()
            assert set(shared.get((one, other), [])) == both, "nodes of %d and %d" % (one, other)
            assert shared.get((one, other)) == shared.get((other,
                                                           one)), "the maps of %d and %d differ" % (
                                                               one, other)


def join_parts_of_particles(dumps):
    """Returns a row per particle of all files, by the variable Id.

    A row has the element and node ids, the block and its name, the place, attributes, variables.
    """
    rows = []
    for dump in dumps:
        count = dump.size("num_el_blk")
        names = dump.get("name_elem_var")
        table = np.reshape(dump.get("elem_var_tab"), (count, len(names)))
        first = 0
        for b in range(count):
            size = dump.size("num_el_in_blk%d" % (b + 1))
            if size and dump.attributes["connect%d:elem_type" % (b + 1)] == "SPHERE":
                nodes = dump.get("connect%d" % (b + 1)) - 1
                assert len(nodes) == size
                assert dump.get("attrib_name%d" % (b + 1)) == ["radius", "volume"]
                attributes = np.reshape(dump.get("attrib%d" % (b + 1)), (size, 2))
                values = {name: dump.get("vals_elem_var%deb%d" % (n + 1, b + 1))
                          for n, name in enumerate(names) if table[b, n]}
                for e, node in enumerate(nodes):
                    rows.append({
                        "id": int(dump.get("elem_num_map")[first + e]),
                        "node": int(dump.get("node_num_map")[node]),
                        "block": int(dump.get("eb_prop1")[b]), "name": dump.get("eb_names")[b],
                        "x": tuple(float(dump.get("coord" + axis)[node]) for axis in "xyz"),
                        "attributes": tuple(attributes[e].tolist()),
                        **{name: float(column[e]) for name, column in values.items()}})
            first += size
    return sorted(rows, key=lambda row: row["Id"])
