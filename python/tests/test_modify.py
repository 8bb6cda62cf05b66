"""Tests of Mesh.split and Mesh.cut_layers: the same meshes as by the options."""

import numpy as np
import pytest

import volume_fraction_mesh as vfm

GRAINS = vfm.shapes("polycrystal grains=6 seed=2", 8, bounds=[-1, 1] * 3)


def check_same(made, expected):
    for name in ("points", "cells", "material", "fragment", "point_ids", "cell_ids", "quality",
                 "layer", "original_ids"):
        one, other = getattr(made, name), getattr(expected, name)
        assert (one is None) == (other is None) and np.array_equal(one, other), name
    for part in ("geometry", "surfaces", "curves", "vertices"):
        for name, values in vars(getattr(expected, part)).items():
            if name != "fields":
                assert np.array_equal(getattr(getattr(made, part), name), values), (part, name)
    for table in ("fields", "materials"):
        for name, values in getattr(expected, table).items():
            assert np.array_equal(getattr(made, table)[name], values), name


def test_split():
    options = {"split_interfaces": "all", "split_connection": "cohesive"}
    check_same(vfm.hexes(GRAINS).split(connection="cohesive"), vfm.hexes(GRAINS, **options))


def test_layers():
    made = vfm.hexes(GRAINS).cut_layers(3, first_layer=0.02)
    check_same(made, vfm.hexes(GRAINS, layers=3, first_layer=0.02, first_layer_unit="length"))


def test_refusals():
    with pytest.raises(ValueError, match="split already"):
        vfm.hexes(GRAINS).split().split()
    with pytest.raises(ValueError, match="Layers are for hexahedra"):
        vfm.tets(GRAINS).cut_layers(2)
