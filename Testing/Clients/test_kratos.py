"""Tests Kratos: a model part from arrays."""

import numpy as np
import pytest

from ball_in_block import (CONDUCTIVITY, SIDES, check_maximum, check_volumes, elastic_reference,
                           run_recipe, volume_of)

Kratos = pytest.importorskip("KratosMultiphysics")


def test_recipe(mesh, tmp_path):
    pytest.importorskip("KratosMultiphysics.StructuralMechanicsApplication")
    names = run_recipe("Kratos", mesh, tmp_path)
    check_maximum(mesh, names["u"], elastic_reference)
    part, found = names["part"], {}
    points = np.array([[node.X, node.Y, node.Z] for node in part.Nodes])
    for name in ("ball", "block"):
        found[name] = volume_of(points, [[node.Id - 1 for node in element.GetNodes()]
                                         for element in part.GetSubModelPart(name).Elements])
    check_volumes(mesh, found)
    for name in SIDES:
        found = np.array([[node.X, node.Y, node.Z] for node in part.GetSubModelPart(name).Nodes])
        expected = mesh.points[np.unique(mesh.facets(name).points)]
        assert np.array_equal(found, expected)


def make_part(mesh, parts):
    """Returns a model part for heat with the points of mesh.separate(), and its model."""
    model = Kratos.Model()
    part = model.CreateModelPart("heat")
    settings = Kratos.ConvectionDiffusionSettings()
    settings.SetDiffusionVariable(Kratos.CONDUCTIVITY)
    settings.SetUnknownVariable(Kratos.TEMPERATURE)
    settings.SetVolumeSourceVariable(Kratos.HEAT_FLUX)
    part.ProcessInfo.SetValue(Kratos.CONVECTION_DIFFUSION_SETTINGS, settings)
    for variable in (Kratos.TEMPERATURE, Kratos.REACTION_FLUX, Kratos.HEAT_FLUX,
                     Kratos.CONDUCTIVITY):
        part.AddNodalSolutionStepVariable(variable)
    for at, (point, material) in enumerate(zip(parts.points.tolist(), parts.material.tolist())):
        node = part.CreateNewNode(at + 1, *point)
        node.SetSolutionStepValue(Kratos.CONDUCTIVITY, CONDUCTIVITY[material])
        node.SetSolutionStepValue(Kratos.HEAT_FLUX, 1.0)
    properties = part.CreateNewProperties(0)
    for at, corners in enumerate((parts.cells + 1).tolist()):
        part.CreateNewElement("LaplacianElement3D4N", at + 1, corners, properties)
    Kratos.VariableUtils().AddDof(Kratos.TEMPERATURE, Kratos.REACTION_FLUX, part)
    for name in SIDES:
        side = part.CreateSubModelPart(name)
        side.AddNodes((np.unique(parts.corners(mesh.facets(name))) + 1).tolist())
        Kratos.VariableUtils().ApplyFixity(Kratos.TEMPERATURE, True, side.Nodes)
    return model, part


def tie(part, original):
    """Ties nodes of materials that were one point."""
    _, first, points = np.unique(original, return_index=True, return_inverse=True)
    for at in np.flatnonzero(first[points] != np.arange(len(original))).tolist():
        part.CreateNewMasterSlaveConstraint(
            "LinearMasterSlaveConstraint", at + 1, part.Nodes[int(first[points[at]]) + 1],
            Kratos.TEMPERATURE, part.Nodes[at + 1], Kratos.TEMPERATURE, 1.0, 0.0)


def test_poisson(tets):
    """Its conductivity belongs to nodes, so each material has nodes of its own."""
    pytest.importorskip("KratosMultiphysics.ConvectionDiffusionApplication")
    pytest.importorskip("KratosMultiphysics.LinearSolversApplication")
    from KratosMultiphysics.python_linear_solver_factory import ConstructSolver

    parts = tets.separate()
    model, part = make_part(tets, parts)
    tie(part, parts.original)
    solver = ConstructSolver(Kratos.Parameters(
        '{"solver_type": "LinearSolversApplication.sparse_lu"}'))
    Kratos.ResidualBasedLinearStrategy(
        part, Kratos.ResidualBasedIncrementalUpdateStaticScheme(),
        Kratos.ResidualBasedBlockBuilderAndSolver(solver), False, False, False, False).Solve()
    check_maximum(tets, [node.GetSolutionStepValue(Kratos.TEMPERATURE) for node in part.Nodes])
