#include "Options/OptionTable.h"

#include "Fractions/ThinFeatures.h"
#include "Options/OptionRow.h"

namespace vfm
{
namespace
{

using M = MesherOptions;

const std::string Conserves = "(StateTransfer=Conserve | StateTransfer=Automatic & DensityArrays)";
const std::string Moves = Conserves + " & VelocityArray";
const char* const Seeks = "Refinement=Automatic";
const char* const Fills = "Method=TetGen";
const char* const Particles = "UnmeshedMaterial=Particles";

OptionTable MaterialsOptions()
{
  return {
    Row("LabelNames", Text(OptionKind::File, &M::LabelNames),
      "File that names the material ids. A text file has an id and its name in each line, "
      "separated by spaces, tabs or commas; # starts a comment. Other formats: label files of "
      "ITK-SNAP, lookup tables of FreeSurfer and MRIcron, and the XML of an FSL atlas. The names "
      "appear in MaterialNames, in the blocks and sets of files, and in the legend.")
      .ShownIf("MaterialIdArray")
      .Advanced()
      .Sculptor("--label-names FILE"),
    Row("ZeroLabel", Choice<&M::ZeroLabel>({ "Void", "Material" }),
      "What cells with material id 0 are. Void: empty space, as in segmentations with a "
      "background. Material: a material, as in codes that number grains from 0. Its id in the mesh "
      "is the largest id plus 1, and its name that of id 0 in the file of names, otherwise "
      "Material 0; all other ids stay.")
      .ShownIf("MaterialIdArray")
      .Advanced()
      .Sculptor("--zero-label WHAT"),
    Row("Threshold", Text(OptionKind::Ranges, &M::Threshold),
      "Make materials of ranges of the values of one array, such as grey values. LOW:HIGH is the "
      "values above LOW, up to and including HIGH; LOW has no upper limit, :HIGH no lower limit. "
      "Several ranges, with commas between them, are materials 1, 2, ..; they must not overlap. "
      "Values in no range are void.")
      .Advanced()
      .Sculptor("--threshold LOW:HIGH"),
    Row("LevelSets", Choice<&M::LevelSets>({ "Off", "Priority", "Lowest", "Fill" }),
      "The volume fraction arrays are level sets: signed distances, or other functions that are "
      "negative inside their material, at the centres of the cells. The part of each cell that is "
      "inside becomes its fraction. Priority: a point belongs to the first array that is negative "
      "there, so each level set may contain those before it, as layers of films do. Lowest: to the "
      "array of the lowest value, if it is negative. Fill: as Lowest, also if it is positive, so "
      "that there is no void. Off: the arrays are volume fractions.")
      .EnabledIf("!MaterialIdArray")
      .Advanced(),
    Row("LevelSetInside", Choice<&M::LevelSetInside>({ "Negative", "Positive" }),
      "Sign of level sets inside their material. With Positive, Lowest and Fill take the highest "
      "value.")
      .EnabledIf("LevelSets!=Off & !MaterialIdArray")
      .Advanced()
      .Sculptor("--level-set-inside SIGN"),
    Row("ImageAxes", Switch<&M::ImageAxes>(),
      "Leave the mesh of an image with a direction matrix in the axes of the image. The sides of "
      "the domain then lie along x, y and z. Off: the mesh is rotated to the position of the image "
      "in space. Refinement boxes are in space; so are state arrays, except Rotated Arrays.")
      .Advanced()
      .Sculptor("--image-axes"),
    Row("MeshVoid", Switch<&M::MeshVoid>(),
      "Mesh the void as well, as material 0, conforming with the materials.")
      .Sculptor("--void"),
    Row("Flat", Switch<&M::Flat>(),
      "Make a mesh of a plane from input that is one layer of cells along an axis: quadrilaterals, "
      "or triangles instead of tetrahedra, of all materials. Interfaces are curves. Volumes in "
      "reports are areas. Off: such input gives a layer of solid elements.")
      .Advanced()
      .Sculptor("--flat"),
    Row("Periodic", Choice<&M::Periodic>({ "Off", "X", "Y", "XY", "Z", "XZ", "YZ", "XYZ" }),
      "Axes along which the input is one period of a material that repeats. The mesh of one side "
      "is then a copy of the mesh of the opposite side, at exactly one period from it, and the "
      "point array PeriodicPartner pairs their nodes. Surfaces, volumes and fragments continue "
      "across these sides. Along each of the axes, the input needs at least 3 cells, and for a "
      "refined mesh an even number of cells of the coarsest level.")
      .Advanced()
      .Sculptor("--periodic AXES"),
    Row("PeriodicSides", Choice<&M::PeriodicSides>({ "Flat", "Free", "Joined" }),
      "Sides across periodic axes. Flat: their nodes stay in the planes. Free: nodes move as "
      "inside the domain, which gives the best surfaces; the sides wave by up to a cell where they "
      "meet surfaces. Joined: there are no sides; elements at opposite sides share nodes, so some "
      "elements seem to extend across the whole domain. Surfaces are those of Free. Tetrahedra are "
      "Flat or Joined.")
      .EnabledIf("Periodic!=Off")
      .Advanced()
      .Sculptor("--periodic-sides KIND"),
    Row("ThinParts", Switch<&M::ThinParts>(),
      "Keep films, threads and drops that are thinner than a cell, and so fill no cell by more "
      "than half: they get the cells in which they have most of their material. Elements of films "
      "and threads that miss their volume may have less quality than others. Oblique threads of "
      "less than a cell can still become thicker than they are; the table of materials tells by "
      "how much. Off: thin parts are torn or lost. Only for volume fractions with an IsoValue of "
      "0.5; material ids stay as they are.")
      .EnabledIf("!MaterialIdArray & IsoValue=0.5"),
    Row("LeastThickness", Number<&M::LeastThickness>(LeastThicknesses),
      "Thickness, in cells, below which Thin Parts gives no cells to a film, thread or drop. Its "
      "material belongs to elements within one cell of it, or else to none (Unmeshed Material). "
      "Below 0.2, elements that are oblique to the cells cannot be thin enough, and make the part "
      "larger than it is.")
      .EnabledIf("ThinParts & !MaterialIdArray")
      .Advanced(),
    Row("MinimumRegionCells", Number<&M::MinimumRegionCells>(0),
      "Remove small fragments and cavities. A face-connected region of one material, or of void, "
      "with fewer cells than this becomes part of the material or void with which it shares the "
      "most faces. 0: all regions stay.")
      .Advanced()
      .Sculptor("--minimum-region N"),
    Row("FractionTolerance", Number<&M::FractionTolerance>(1e-6, 0.1),
      "Clip volume fractions that lie outside [0, 1] by at most this value, such as over- and "
      "undershoots of a simulation. Sums above 1 by at most this value, or by at most 0.001, are "
      "scaled back to 1. Larger deviations are errors. The default of 1e-6 covers rounding only.")
      .Advanced()
      .Sculptor("--clip T"),
    Row("IsoValue", Number<&M::IsoValue>(),
      "A cell is void if its materials together fill less than this fraction of it. Volumes are "
      "conserved only at 0.5.")
      .Above(0)
      .Below(1)
      .Advanced()
      .Sculptor("--iso V"),
  };
}

OptionTable StateOptions()
{
  return {
    Row("StateTransfer", Choice<&M::StateTransfer>({ "Automatic", "Copy", "Conserve" }),
      "How elements get the values of state arrays. Copy: each element takes the values of the "
      "cell that contains its centroid. If its material fills less than half of that cell, the "
      "neighbour cell with most of the material is used. Nothing is averaged, so sums are not "
      "conserved. Conserve: the contents of the cells are distributed to the elements, so that "
      "mass, momentum and energy of each material match the input. Automatic: Conserve if Density "
      "Arrays names an array, otherwise Copy.")
      .Sculptor("--state-transfer HOW"),
    Row("DensityArrays", Texts(OptionKind::Arrays, &M::DensityArrays),
      "Density: mass per volume of the material. Select one array for all materials, or one array "
      "per material (Material density - 1, ..). Transferred like State Arrays.")
      .EnabledIf("StateTransfer!=Copy")
      .Sculptor("--density A,.."),
    Row("StateOrder", Number<&M::StateOrder>(1, 2),
      "How Conserve reconstructs the state within a cell. 1: constant. 2: linear, within the range "
      "of the neighbour cells.")
      .Listed()
      .EnabledIf(Conserves)
      .Advanced()
      .Sculptor("--state-order N"),
    Row("VelocityArray", Text(OptionKind::Array, &M::VelocityArray),
      "Velocity. Conserve preserves and reports the momentum of each material, and reports its "
      "kinetic energy and the part that is lost. Select an array of three components, or one of "
      "three arrays with a component each (X velocity). Transferred like State Arrays.")
      .WithVectors()
      .EnabledIf(Conserves)
      .Sculptor("--velocity ARRAY"),
    Row("EnergyArray", Text(OptionKind::Array, &M::EnergyArray),
      "Internal energy per unit mass. Conserve preserves and reports it for each material. If "
      "every material has its own energy array, select any one of them. Transferred like State "
      "Arrays.")
      .EnabledIf(Conserves)
      .Advanced()
      .Sculptor("--energy ARRAY"),
    Row("NodalVelocity", Switch<&M::NodalVelocity>(),
      "Add the velocity of the nodes as a point array, the initial state of a Lagrangian code. The "
      "momentum of all nodes equals the momentum of all elements.")
      .EnabledIf(Moves)
      .Advanced()
      .Sculptor("--nodal-velocity"),
    Row("LostKineticEnergy", Choice<&M::LostKineticEnergy>({ "Report", "Internal Energy" }),
      "Treatment of the kinetic energy that is lost where one element, or one node, moves with the "
      "mean velocity of several cells. Report: the table of materials lists it. Internal Energy: "
      "it is added to Energy Array, so that the sum of both energies matches the input. With State "
      "Order 2 it may be negative: elements can have slightly more kinetic energy than their "
      "cells.")
      .EnabledIf(Moves + " & EnergyArray")
      .Advanced()
      .Sculptor("--lost-kinetic-energy WHERE"),
    Row("RotatedArrays", Texts(OptionKind::Arrays, &M::RotatedArrays),
      "State arrays whose vectors or tensors are given along the axes of the image, not along x, y "
      "and z. They are rotated with the mesh of an image with a direction matrix. Vectors have "
      "three components, symmetric tensors six (xx, yy, zz, xy, yz, xz), tensors nine (row by "
      "row). All other arrays keep their values.")
      .WithVectors()
      .EnabledIf("!ImageAxes")
      .Advanced()
      .Sculptor("--rotated A,.."),
    Row("UnmeshedMaterial", Choice<&M::UnmeshedMaterial>({ "Give", "Drop", "Particles" }),
      "Treatment of material that is not attached to any element of its kind, such as small drops "
      "and removed regions. Give: Conserve adds it to the nearest fragment of its material within "
      "a few cells. Drop: it is left out. Particles: it becomes one particle per cell, which "
      "elements do not count. The table of materials lists how much is left out.")
      .Advanced()
      .Sculptor("--unmeshed WHAT"),
    Row("ParticleClusters", Switch<&M::ParticleClusters>(),
      "Join particles of neighbour cells, up to 27 into one, with their momentum. Lost Kinetic "
      "Energy tells what happens to the kinetic energy that they lose.")
      .EnabledIf(Particles)
      .Advanced(),
    Row("LeastParticle", Number<&M::LeastParticle>(0, 1),
      "Particles below this part of a cell join one in a neighbour cell.")
      .EnabledIf(Particles)
      .Advanced(),
  };
}

OptionTable StateKindsOptions()
{
  return {
    Row("StateKinds", Texts(OptionKind::Kinds, &M::StateKinds),
      "Quantity that Conserve preserves for an array, one entry array=kind per array. Kind volume: "
      "per volume of the material, such as pressure. Kind cell: per volume of the whole cell, such "
      "as a bulk density. Kind extensive: sums, such as a mass. Kind copy: copied, as by Copy. "
      "Kind mass*other: per mass, weighted by another state array "
      "(temperature=mass*heat_capacity). Arrays without an entry are of kind mass (per mass, such "
      "as velocity), except densities (volume) and arrays of integers (copy).")
      .EnabledIf(Conserves)
      .Advanced()
      .Sculptor("--state-kinds NAME=KIND,.."),
  };
}

OptionTable SurfaceOptions()
{
  return {
    Row("StairStep", Switch<&M::StairStep>(),
      "Turn each cell of a material into one hexahedron and move no nodes: a quick preview.")
      .Sculptor("--stairstep")
      .OfTets("Turn the cells of a material into tetrahedra and move no nodes: a quick preview of "
              "the materials."),
    Row("Smoothing", Choice<&M::Smoothing>({ "Off", "Quadric Surface", "Geometry Based" }),
      "How the nodes are placed. Quadric Surface: surface nodes follow smooth local quadrics of "
      "the surface, which gives the best mesh. Geometry Based: surface nodes stay on the facets of "
      "the initial surface. Off: the surface keeps the steps of the grid, with a thin layer of "
      "hexahedra along them; valid, but neither smooth nor of good quality.")
      .EnabledIf("!StairStep")
      .Sculptor("--smooth ID")
      .OfTets("How the nodes are placed. Quadric Surface: surface nodes follow smooth local "
              "quadrics of the surface, which gives the best mesh. Geometry Based: surface nodes "
              "stay on the facets of the initial surface. Off: the nodes stay at their initial "
              "positions; valid, but not smooth."),
    Row("SharpEdges", Choice<&M::SharpEdges>({ "Off", "On", "Automatic" }),
      "Detect edges and corners in the volume fractions and preserve them, as in machined parts, "
      "shapes and closed surfaces. Off: they are rounded by about a third of a cell. On: all "
      "points of interfaces are tested. Automatic: only between materials where samples of the "
      "points that one surface does not fit show edges, so not in fluids and noise. Requires "
      "Smoothing Quadric Surface and an IsoValue of 0.5.")
      .EnabledIf("!StairStep & Smoothing=Quadric Surface")
      .Sculptor("--sharp-edges WHEN"),
    Row("SurfaceTargets", Choice<&M::UseSurfaces>({ "Off", "On" }),
      "Place the nodes of interfaces on the closed surfaces from which the volume fractions were "
      "computed, and take edges, corners and sides from their triangles. Off: from the fractions "
      "alone. No effect on input without surfaces: they come from surface files and Volume "
      "Fraction Of Surface. Requires Smoothing Quadric Surface and an IsoValue of 0.5.")
      .EnabledIf("!StairStep & Smoothing=Quadric Surface")
      .Advanced()
      .InPython("surface_targets")
      .Sculptor("--surface-targets WHEN"),
    Row("EdgeAngle", Number<&M::EdgeAngle>(EdgeAngles),
      "Least angle between triangles of a surface, in degrees, at which their common edge is a "
      "sharp edge of the mesh and separates two sides. Smaller angles find blunter edges, and also "
      "those of coarse triangles on round surfaces. No effect without Surface Targets, or on input "
      "without surfaces.")
      .EnabledIf("SurfaceTargets=On")
      .Advanced()
      .Sculptor("--edge-angle A"),
    Row("LabelSmoothing", Number<&M::LabelSmoothing>(0, 10),
      "Smooth the steps of material ids, by this number of averaging passes over neighbour cells. "
      "Each material keeps the volume of its cells, and thin parts stay. 2 or 3 passes suit most "
      "images; more round edges. Fractions are not smoothed.")
      .ShownIf("MaterialIdArray")
      .Sculptor("--label-smoothing N"),
    Row("ElementOrder", Choice<&M::ElementOrder>({ "Linear", "Quadratic", "Quadratic27" }),
      "Nodes of the elements. Linear: corners only. Quadratic: also mid nodes of edges, hexahedra "
      "of "
      "20 nodes and tetrahedra of 10. Quadratic27: hexahedra also have mid nodes of faces and a "
      "centre, 27 nodes. Mid nodes of interface edges lie on the curved interface, so elements "
      "follow it more closely; Smoothing must be Quadric Surface. All elements are positive "
      "throughout.")
      .Advanced()
      .Sculptor("--element-order ORDER"),
    Row("ConserveVolume", Switch<&M::ConserveVolume>(),
      "Shift the surfaces until each fragment has the volume given by its volume fractions.")
      .EnabledIf("!StairStep & Smoothing!=Off")
      .Advanced(),
  };
}

OptionTable RefinementOptions()
{
  return {
    Row("CellWidth", Text(OptionKind::Widths, &M::CellWidth),
      "Width of the cells that are meshed, in length units: one number, or three along the axes of "
      "the input. The cells of the input are first replaced by as many equal cells as come nearest "
      "to it, and each material keeps its volume. Twice the width gives an eighth of the elements, "
      "and smooths the steps of material ids. Refinement then refines the new cells; Label "
      "Smoothing smooths material ids before. Parts thinner than half of the width get lost. 0: "
      "the cells of the input.")
      .InPython("cell_width")
      .Sculptor("--cell-width W"),
    Row("MaterialWidths", Text(OptionKind::Sizes, &M::MaterialWidths),
      "Widths of cells of single materials, name=width or id=width with commas between them, in "
      "length units; small=N:width is for all materials of fewer than N cells in the input. All "
      "others have Cell Width. A cell is halved while it is wider than the width of a material in "
      "it or next to it, and interfaces run through cells of several widths. auto: cells are as "
      "wide as Allowed Error lets them be, at most Cell Width, or 4 cells of the input. "
      "Tetrahedra are those of Cells, also with Lattice; TetGen has the smallest width at all "
      "interfaces.")
      .InPython("material_widths")
      .Sculptor("--material-widths LIST"),
    Row("AllowedError", Number<&M::AllowedError>(0),
      "Distance that surfaces may be from those of the input, in cells of the input, if Material "
      "Widths is auto.")
      .EnabledIf("MaterialWidths"),
    Row("Refinement",
      Choice<&M::Refinement>({ "Off", "Input Levels", "Automatic", "Coarsen", "Uniform" }),
      "Where the mesh is refined; each level halves the cells. Input Levels: where the input has "
      "finer levels (AMR). Off: nowhere, all cells are of the coarsest level. Automatic: where the "
      "shape of the materials requires it. Coarsen: the cells of the input stay near interfaces "
      "and get larger away from them. Uniform: everywhere, so that thin parts get more elements "
      "across."),
    Row("MaximumLevel", Number<&M::MaximumLevel>(-1, MaximumHalvings),
      "Maximum number of levels above the coarsest. Automatic (-1) uses all levels of the input. A "
      "refined image gets 1 level, or as many as user-selected cells request. Coarsen makes as "
      "many as the numbers of cells allow, up to 3. Uniform multiplies the number of elements by "
      "eight per level. Finer data of the input are averaged.")
      .Special(-1, "automatic")
      .Listed()
      .ShownIf("Refinement!=Off"),
    Row("FineInterfaces", Switch<&M::FineInterfaces>(),
      "All interfaces get the finest cells. Off: each place gets the level of the input or of the "
      "criteria there, and interfaces cross levels. With Coarsen all cells are then as coarse as "
      "possible. Tetrahedra are those of Cells then, also with Lattice; TetGen always has the "
      "finest cells at interfaces.")
      .ShownIf("Refinement=Input Levels,Automatic,Coarsen")
      .Advanced(),
    Row("FineLayers", Number<&M::FineLayers>(2, 64),
      "Minimum number of finest cells between an interface and larger cells. If Fine Interfaces is "
      "off: fine cells around the places that Automatic refines.")
      .OfTets(
        "Finest cells between an interface and larger cells. With 2, Lattice has them only at "
        "nodes of interfaces, which differ by a few hundredths of a cell from those with 3.")
      .ShownIf("Refinement=Input Levels,Automatic,Coarsen")
      .Advanced(),
    Row("ThinCells", Number<&M::ThinCells>(0, LargestThickness),
      "Refinement Automatic halves cells at films, gaps, rods and small bodies thinner than this "
      "number of cells. 0: off.")
      .Special(0, "off")
      .ShownIf(Seeks)
      .Advanced(),
    Row("CurvaturePerCell", Number<&M::CurvaturePerCell>(0),
      "Refinement Automatic halves cells where an interface turns by more than this angle per "
      "cell, in radians. 0: off.")
      .Special(0, "off")
      .ShownIf(Seeks)
      .Advanced(),
    Row("RefineFlippedCells", Switch<&M::RefineFlippedCells>(),
      "Refinement Automatic halves, once, the cells whose material had to be changed to make the "
      "interfaces manifold.")
      .ShownIf(Seeks)
      .Advanced(),
    Row("InterfaceLayers", Number<&M::InterfaceLayers>(0, 64),
      "Refinement Automatic refines all cells within this number of layers of an interface, to "
      "Maximum Level. 0: off.")
      .ShownIf(Seeks)
      .Advanced(),
    Row("RefinementArray", Text(OptionKind::Array, &M::RefinementArray),
      "Array of the number of times that Refinement Automatic halves each cell, 0 to 10 (0 and 1 "
      "in a mask), up to Maximum Level. With Thin Cells 0 only these cells are refined. Without "
      "Fine Interfaces each place gets the level that is requested there.")
      .ShownIf(Seeks)
      .Advanced(),
    Row("RefinementBoxes", Option(),
      "Boxes in which Refinement Automatic refines all cells that they overlap. A box is seven "
      "numbers: x, y, z of the lower corner, x, y, z of the upper corner, and the number of times "
      "that cells are halved, 0 to 10.")
      .ShownIf(Seeks)
      .Advanced(),
    Row("MaximumAspectRatio", Number<&M::MaximumAspectRatio>(SmallestAspectRatio),
      "Divide cells of high aspect ratio first (slices thicker than their pixels), until no width "
      "of a cell exceeds another by more than this factor. 1.5 gives elements of good shape. 0: "
      "off.")
      .Special(0, "off")
      .Sculptor("--aspect R"),
    Row("ChildFractions", Choice<&M::ChildFractions>({ "Planes", "Parent" }),
      "Volume fractions in the halves, or parts, of a mixed cell where there are no finer data. "
      "Planes: the cell is cut by planes that preserve the volume of each material. Parent: the "
      "parts get the fractions of the cell. Material ids keep their steps with either choice, "
      "unless Label Smoothing is on.")
      .ShownIf("Refinement!=Off | MaximumAspectRatio!=0")
      .Advanced(),
  };
}

OptionTable SplitOptions()
{
  return {
    Row("SplitInterfaces", Text(OptionKind::Pairs, &M::SplitInterfaces),
      "Pairs of materials whose interfaces are split: the elements on each side get their own "
      "nodes, also where several fragments meet at a line or a corner. A pair is two names or ids "
      "with a slash between them, such as steel/copper or 1/3; * is any material. The point array "
      "OriginalPointIds has the ids of the nodes before.")
      .InPython("split_interfaces")
      .Sculptor("--split PAIRS"),
    Row("SplitConnection", Choice<&M::SplitConnection>({ "None", "Cohesive", "Contact", "Tied" }),
      "Connection of both sides of split interfaces in files. Cohesive: elements of zero thickness "
      "in blocks of their own, in .inp, Exodus and .msh files. Contact, Tied: contact pairs or "
      "ties in .inp files. None: the sides are free.")
      .EnabledIf("SplitInterfaces")
      .Sculptor("--split-connection KIND"),
  };
}

OptionTable LayerOptionsTable()
{
  return {
    Row("Layers", Number<&M::Layers>(0, 20),
      "Cut the hexahedra along interfaces into this number of layers, as for boundary layers or "
      "contact. The cell array Layer counts them from the surface. A fragment gets layers along "
      "its whole surface. 0, 1: no layers.")
      .Advanced()
      .NotOfTets()
      .Sculptor("--layers N"),
    Row("LayerGrowth", Number<&M::LayerGrowth>(1.0, 10.0),
      "Thickness of each layer relative to the one before, from the surface.")
      .EnabledIf("Layers")
      .Advanced()
      .NotOfTets()
      .Sculptor("--layer-growth G"),
    Row("FirstLayer", Number<&M::FirstLayer>(0.0),
      "Thickness of the first layer, where there is room: where the hexahedra are high enough for "
      "all layers. Layers grow less where there is less room, and the last one is thicker where "
      "there is more. 0: layers fill the hexahedra along the interface, which are half a cell "
      "high.")
      .EnabledIf("Layers")
      .Advanced()
      .NotOfTets()
      .Sculptor("--first-layer T"),
    Row("FirstLayerUnit", Choice<&M::FirstLayerUnit>({ "Cells", "Length" }),
      "Unit of First Layer. Cells: the mean width of the finest cells. Length: the length unit of "
      "the input.")
      .EnabledIf("Layers")
      .Advanced()
      .NotOfTets()
      .Sculptor("--first-layer-unit UNIT"),
    Row("LayerInterfaces", Text(OptionKind::Pairs, &M::LayerInterfaces),
      "Pairs of materials whose interfaces have layers. A pair is two names or ids with a slash "
      "between them, such as water/steel or 1/3; * is any material, 0 or Void the void. None: all.")
      .InPython("layer_interfaces")
      .EnabledIf("Layers")
      .Advanced()
      .NotOfTets()
      .Sculptor("--layer-interfaces PAIRS"),
    Row("LayersOn", Choice<&M::LayersOn>({ "Both Materials", "First Material" }),
      "Side of the interfaces with layers: the elements of both materials of each pair, or only "
      "those of the first.")
      .EnabledIf("Layers & LayerInterfaces")
      .Advanced()
      .NotOfTets()
      .Sculptor("--layers-on SIDE"),
    Row("LayerSides", Choice<&M::LayerSides>({ "Off", "X", "Y", "XY", "Z", "XZ", "YZ", "XYZ" }),
      "Axes across which the sides of the domain have layers as well, such as walls.")
      .EnabledIf("Layers")
      .Advanced()
      .NotOfTets()
      .Sculptor("--layer-sides AXES"),
  };
}

OptionTable QualityOptions()
{
  return {
    Row("TargetScaledJacobian", Number<&M::TargetScaledJacobian>(0),
      "Target of smoothing for the scaled Jacobian. Larger values give better hexahedra that "
      "follow the surfaces less closely. 0 is automatic: 0.55 with one material, 0.5 with several.")
      .Below(1)
      .Special(0, "automatic")
      .EnabledIf("!StairStep & Smoothing!=Off")
      .Advanced()
      .OfTets("Target of smoothing for the quality of tetrahedra, the sine of their acute dihedral "
              "angles. Larger values give better tetrahedra that follow the surfaces less closely. "
              "0.5 is 30 degrees; 0 is automatic, slightly above 0.5."),
    Row("ComputeQuality", Switch<&M::ComputeQuality>(),
      "Add the cell array ScaledJacobian, and its minimum and mean to the field data. It is 1 for "
      "a cube and above 0 for a valid hexahedron.")
      .Advanced()
      .OfTets(
        "Add the cell array ScaledJacobian, and to the field data its minimum and mean and the "
        "dihedral angles: the smallest, the largest, and a histogram in steps of ten degrees."),
  };
}

OptionTable PerformanceOptions()
{
  return {
    Row("NumberOfThreads", Number<&M::NumberOfThreads>(0),
      "Number of threads. 0 is automatic: all cores on one rank, one thread per rank on several. "
      "The mesh does not depend on it.")
      .Special(0, "automatic")
      .Advanced()
      .InPython("threads"),
    Row("WholeTables", Choice<&M::WholeTables>({ "Automatic", "Off", "On" }),
      "Field data with a row for each fragment, surface, curve and vertex of the whole mesh, such "
      "as "
      "target volumes, areas and materials on both sides, on every rank. Automatic: tables of at "
      "most 100,000 rows. Off: none, so that the memory of a rank depends on its part of the mesh "
      "only. Ids, the table of fragments and the files of each rank do not need them; names of "
      "surfaces in files do.")
      .Advanced()
      .Sculptor("--whole-tables WHEN"),
  };
}

OptionTable TetrahedraOptions()
{
  return {
    Row("Method", Choice<&M::Method>({ "TetGen", "Cells", "Lattice" }),
      "How the tetrahedra are made. Lattice: a lattice of cell centres and grid nodes is cut along "
      "the surfaces, which gives the best angles and the closest fit. Cells: each cell is cut into "
      "tetrahedra around its centre, so that the surfaces have the faces and labels of Volume "
      "Fraction To Hex. TetGen: TetGen fills the surfaces of Cells with tetrahedra that grow away "
      "from them, which gives the fewest tetrahedra. TetGen is an optional part of the build."),
    Row("RelativeSize", Number<&M::RelativeSize>(RelativeSizes),
      "Target length of the edges next to the surfaces, in cells of the grid. The triangles of the "
      "surfaces do not change.")
      .ShownIf(Fills),
    Row("Growth", Number<&M::Growth>(Growths),
      "Increase of the edge length per cell of distance from the surfaces. 0: edges are equally "
      "short everywhere.")
      .ShownIf(Fills),
    Row("RadiusEdgeRatio", Number<&M::RadiusEdgeRatio>(RadiusEdgeRatios),
      "Maximum ratio of the circumradius of a tetrahedron to its shortest edge. Smaller values "
      "give more and better tetrahedra.")
      .ShownIf(Fills)
      .Advanced(),
    Row("MinimumDihedralAngle", Number<&M::MinimumDihedralAngle>(MinimumDihedralAngles),
      "Target of refinement for the smallest dihedral angle, in degrees.")
      .ShownIf(Fills)
      .Advanced(),
    Row("OptimizationLevel", Number<&M::OptimizationLevel>(OptimizationLevels),
      "How much TetGen improves the tetrahedra by flips and smoothing.")
      .ShownIf(Fills)
      .Advanced(),
  };
}
OptionTable JoinGroups()
{
  OptionTable all;
  const auto add = [&all](const char* group, OptionTable options, bool areOfTets = false)
  {
    for (Option& option : options)
    {
      option.Group = group;
      option.OnlyTets = areOfTets;
      all.push_back(std::move(option));
    }
  };
  add("Materials", MaterialsOptions());
  add("State", StateOptions());
  add("State kinds (array=kind)", StateKindsOptions());
  add("Surface", SurfaceOptions());
  add("Refinement", RefinementOptions());
  add("Split interfaces", SplitOptions());
  add("Layers", LayerOptionsTable());
  add("Quality (target 0: automatic)", QualityOptions());
  add("Performance (0: automatic)", PerformanceOptions());
  add("Tetrahedra", TetrahedraOptions(), true);
  return all;
}

} // namespace

bool OptionRange::Holds(double number) const
{
  return (this->Special && number == *this->Special) ||
    ((this->IsMinimumOpen ? number > this->Least : number >= this->Least) &&
      (this->IsMaximumOpen ? number < this->Most : number <= this->Most));
}

const OptionTable& GetOptionTable()
{
  static const OptionTable table = JoinGroups();
  return table;
}

} // namespace vfm
