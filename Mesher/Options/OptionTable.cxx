#include "Options/OptionTable.h"

#include "Base/ParseText.h"
#include "Fractions/ThinFeatures.h"

#include <type_traits>

namespace vfm
{
namespace
{

using M = MesherOptions;

/// A row as it is written down: what an option takes, then what else there is to say.
struct Row : Option
{
  Row(const char* name, Option value, const char* meaning) : Option(std::move(value))
  {
    this->Name = name;
    this->Meaning = meaning;
    this->Python = this->GetNumber ? SnakeCase(name) : "";
  }

  Row& Above(double least)
  {
    this->Range.IsMinimumOpen = true;
    return this->Set(this->Range.Least, least);
  }
  Row& Below(double most)
  {
    this->Range.IsMaximumOpen = true;
    return this->Set(this->Range.Most, most);
  }
  Row& Special(double number, const char* meaning)
  {
    this->Range.Special = number;
    this->Range.Meaning = meaning;
    return *this;
  }
  Row& ShownIf(std::string condition) { return this->Set(this->Shown, std::move(condition)); }
  Row& EnabledIf(std::string condition) { return this->Set(this->Enabled, std::move(condition)); }
  Row& Advanced() { return this->Set(this->IsAdvanced, true); }
  Row& Listed() { return this->Set(this->IsListed, true); }
  Row& WithVectors() { return this->Set(this->TakesVectors, true); }
  Row& NotOfTets() { return this->Set(this->IsHiddenOfTets, true); }
  Row& OfTets(const char* text) { return this->Set(this->MeaningOfTets, text); }
  Row& Sculptor(const char* argument) { return this->Set(this->Argument, argument); }
  Row& InPython(const char* name) { return this->Set(this->Python, name); }

private:
  template <class Member, class Given>
  Row& Set(Member& member, Given value)
  {
    member = std::move(value);
    return *this;
  }
};

constexpr double NoEnd = std::numeric_limits<double>::infinity();

template <auto Member>
Option MakeNumber(OptionKind kind)
{
  Option option;
  option.Kind = kind;
  option.GetNumber = [](const M& options) { return static_cast<double>(options.*Member); };
  option.SetNumber = [](M& options, double number)
  {
    auto& place = options.*Member;
    place = static_cast<std::decay_t<decltype(place)>>(number);
  };
  return option;
}

template <auto Member>
Option Switch()
{
  return MakeNumber<Member>(OptionKind::Switch);
}

template <auto Member>
Option Number(double least, double most = NoEnd)
{
  const bool isWhole = std::is_same_v<std::decay_t<decltype(M().*Member)>, int>;
  Option option = MakeNumber<Member>(isWhole ? OptionKind::Integer : OptionKind::Real);
  option.Range = { least, most };
  return option;
}

template <auto Member>
Option Number(const NumberRange& range = { -NoEnd, NoEnd })
{
  return Number<Member>(range.Least, range.Most);
}

/// words: of the enumerators, in their order.
template <auto Member>
Option Choice(std::vector<std::string> words)
{
  Option option = MakeNumber<Member>(OptionKind::Choice);
  option.Words = std::move(words);
  return option;
}

Option Text(OptionKind kind, std::string M::*member)
{
  Option option;
  option.Kind = kind;
  option.Text = member;
  return option;
}

Option Texts(OptionKind kind, std::vector<std::string> M::*member)
{
  Option option;
  option.Kind = kind;
  option.Texts = member;
  return option;
}

const std::string Conserves = "(StateTransfer=Conserve | StateTransfer=Automatic & DensityArrays)";
const std::string Moves = Conserves + " & VelocityArray";
const char* const Seeks = "Refinement=Automatic";
const char* const Fills = "Method=TetGen";

OptionTable MaterialsOptions()
{
  return {
    Row("LabelNames", Text(OptionKind::File, &M::LabelNames),
      "A file that names the material ids: a text with an id and its name in each line (with a "
      "space, tab or comma between; # for comments), a label file of ITK-SNAP, a lookup table of "
      "FreeSurfer or MRIcron, or the XML of an atlas of FSL. The names are those of MaterialNames, "
      "of the blocks and sets of files, and of the legend.")
      .ShownIf("MaterialIdArray")
      .Advanced()
      .Sculptor("--label-names FILE"),
    Row("ImageAxes", Switch<&M::ImageAxes>(),
      "Leave the mesh of an image with a direction matrix in the axes of the image, so that sides "
      "of "
      "the domain lie along x, y and z. Off: the mesh is turned to where the image lies in space. "
      "State arrays and refinement boxes are not turned.")
      .Advanced()
      .Sculptor("--image-axes"),
    Row("MeshVoid", Switch<&M::MeshVoid>(),
      "Mesh the void as well, as material 0, conforming with the materials.")
      .Sculptor("--void"),
    Row("MinimumRegionCells", Number<&M::MinimumRegionCells>(0),
      "Remove spray, crumbs and small cavities: a region of one material, or of void, of fewer "
      "cells than this is given to the material or void with which it shares the most faces. 0: "
      "all stay.")
      .Advanced()
      .Sculptor("--minimum-region N"),
    Row("FractionTolerance", Number<&M::FractionTolerance>(1e-6, 0.1),
      "Clip volume fractions that lie outside [0, 1] by no more than this (a code's over- and "
      "undershoots), and scale back sums above 1 by no more. Others are refused. 1e-6 is for "
      "rounding alone.")
      .Advanced()
      .Sculptor("--clip T"),
    Row("IsoValue", Number<&M::IsoValue>(),
      "A cell is void when its materials together fill less than this part of it. Volumes are "
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
    Row("StateTransfer", Choice<&M::Transfer>({ "Automatic", "Copy", "Conserve" }),
      "How elements get the values of state arrays. Copy: every element has the values of the cell "
      "that holds its centroid, or of the cell "
      "beside it with most of the element's material where that cell holds less than half. Nothing "
      "is averaged, so sums are not conserved. Conserve: elements share what the cells hold of "
      "their material, so that mass, momentum, energy of every material are those of the input. "
      "Automatic: Conserve where Density Arrays names one, else Copy.")
      .Sculptor("--state-transfer HOW"),
    Row("DensityArrays", Texts(OptionKind::Arrays, &M::DensityArrays),
      "The density: mass per volume of the material. One array for all materials, or one a "
      "material (Material density - 1, ..). Carried along as State Arrays are.")
      .EnabledIf("StateTransfer!=Copy")
      .Sculptor("--density A,.."),
    Row("StateOrder", Number<&M::StateOrder>(1, 2),
      "What Conserve takes the state to be in a cell. 1: constant. 2: linear, within the bounds of "
      "the cells around.")
      .Listed()
      .EnabledIf(Conserves)
      .Advanced()
      .Sculptor("--state-order N"),
    Row("VelocityArray", Text(OptionKind::Array, &M::VelocityArray),
      "The velocity, of which Conserve tells momentum and kinetic energy of every material, and "
      "what the mesh lacks of it: an array of three components, or one of three (X velocity). "
      "Carried along as State Arrays are.")
      .WithVectors()
      .EnabledIf(Conserves)
      .Sculptor("--velocity ARRAY"),
    Row("EnergyArray", Text(OptionKind::Array, &M::EnergyArray),
      "The internal energy per mass, of which Conserve tells the energy of every material. Of "
      "arrays a material any one. Carried along as State Arrays are.")
      .EnabledIf(Conserves)
      .Advanced()
      .Sculptor("--energy ARRAY"),
    Row("NodalVelocity", Switch<&M::NodalVelocity>(),
      "Add the velocity of the nodes as a point array, with which a Lagrangian code starts. The "
      "momentum of all nodes is that of all elements.")
      .EnabledIf(Moves)
      .Advanced()
      .Sculptor("--nodal-velocity"),
    Row("LostKineticEnergy", Choice<&M::LostKineticEnergy>({ "Report", "Internal Energy" }),
      "The kinetic energy that is lost where one element, or one node, moves with the mean "
      "velocity of several cells. Report: the table of materials tells it. Internal Energy: it is "
      "added to Energy Array, so that the sum of both energies is that of the input.")
      .EnabledIf(Moves + " & EnergyArray")
      .Advanced()
      .Sculptor("--lost-kinetic-energy WHERE"),
    Row("UnmeshedMaterial", Choice<&M::UnmeshedMaterial>({ "Give", "Drop" }),
      "Material apart from all elements of its kind: spray, removed regions. Give: Conserve gives "
      "it to the nearest fragment of its material within a few cells. Drop: it is left out. What "
      "is left out the table of materials tells.")
      .EnabledIf(Conserves)
      .Advanced()
      .Sculptor("--unmeshed WHAT"),
  };
}

OptionTable StateKindsOptions()
{
  return {
    Row("StateKinds", Texts(OptionKind::Kinds, &M::StateKinds),
      "What Conserve keeps of an array, a row for each that is no velocity, specific energy or "
      "temperature: array=volume (per volume of the material, as pressure), cell (per volume of "
      "the whole cell, as a bulk density), extensive (sums, as a mass), copy (copied as by Copy), "
      "mass*other (per mass, weighed with another state array: temperature=mass*heat_capacity). "
      "Arrays that are not named are of the kind mass (per mass), those of whole numbers copy, "
      "densities volume.")
      .EnabledIf(Conserves)
      .Advanced()
      .Sculptor("--state-kinds NAME=KIND,.."),
  };
}

OptionTable SurfaceOptions()
{
  return {
    Row("StairStep", Switch<&M::StairStep>(),
      "Turn every cell of a material into one hexahedron and move nothing: a quick look at the "
      "materials.")
      .Sculptor("--stairstep")
      .OfTets("Turn the cells of a material into tetrahedra and move nothing: a quick look at the "
              "materials."),
    Row("Smoothing", Choice<&M::Method>({ "Off", "Quadric Surface", "Geometry Based" }),
      "How the nodes are placed. Quadric Surface: surface nodes follow smooth local quadrics of "
      "the surface; the best mesh. Geometry Based: surface nodes stay on the facets of the surface "
      "as first found. Off: the steps of the grid with a thin layer of hexahedra along them; "
      "valid, but neither smooth nor of good quality.")
      .EnabledIf("!StairStep")
      .Sculptor("--smooth ID")
      .OfTets(
        "How the nodes are placed. Quadric Surface: surface nodes follow smooth local quadrics of "
        "the surface; the best mesh. Geometry Based: surface nodes stay on the facets of the "
        "surface as first found. Off: the nodes stay where they start; valid, but not smooth."),
    Row("SharpEdges", Choice<&M::Edges>({ "Off", "On", "Automatic" }),
      "Whether edges and corners are found in the volume fractions and kept: those of machined "
      "parts, of shapes and of closed surfaces. Off: they are rounded, by about a third of a cell. "
      "On: wherever two or three surfaces that cut each other explain the fractions around better "
      "than one. Automatic: of two materials that meet, only where that is so in much of what one "
      "surface does not explain, so not in fluids and noise. Has an effect with Smoothing Quadric "
      "Surface and an IsoValue of 0.5 alone.")
      .EnabledIf("!StairStep & Smoothing=Quadric Surface")
      .Sculptor("--sharp-edges WHEN"),
    Row("LabelSmoothing", Number<&M::LabelSmoothing>(0, 10),
      "Smooth the steps that material ids make, by this many passes of an average over the cells "
      "around. Every material keeps the volume of its cells, thin parts stay. 2 or 3 serve most; "
      "more rounds off edges. Volume fractions are not smoothed.")
      .ShownIf("MaterialIdArray")
      .Sculptor("--label-smoothing N"),
    Row("ConserveVolume", Switch<&M::ConserveVolume>(),
      "Shift the surfaces until every fragment has the volume of its volume fractions.")
      .EnabledIf("!StairStep & Smoothing!=Off")
      .Advanced(),
  };
}

OptionTable RefinementOptions()
{
  return {
    Row("Refinement",
      Choice<&M::Where>({ "Off", "Input Levels", "Automatic", "Coarsen", "Uniform" }),
      "Where the mesh is finer than elsewhere; each level halves the cells. Input Levels: where "
      "the input is, if it has levels (AMR). Off: nowhere, all cells are those of the coarsest "
      "level. Automatic: where the shape needs it. Coarsen: the cells of the input stay near "
      "interfaces and get larger away from them. Uniform: everywhere, so that thin parts get more "
      "elements across."),
    Row("MaximumLevel", Number<&M::MaximumLevel>(-1, MaximumHalvings),
      "Levels finer than the coarsest, at most. Automatic, -1: all that the input has; 1 where an "
      "image is refined, or what named cells ask for; by Coarsen as many as the numbers of cells "
      "allow, at most 3. By Uniform each makes eight times as many elements. Finer data of the "
      "input are averaged.")
      .Special(-1, "automatic")
      .Listed()
      .ShownIf("Refinement!=Off"),
    Row("FineInterfaces", Switch<&M::FineInterfaces>(),
      "All interfaces get the finest cells. Off: cells are as fine as the levels of the input or "
      "the criteria ask at each place, and interfaces cross levels; by Coarsen all cells are then "
      "as coarse as can be. Hexahedra only: tetrahedra at interfaces are always fine.")
      .ShownIf("Refinement=Input Levels,Automatic,Coarsen")
      .Advanced()
      .NotOfTets()
      .OfTets("No effect on tetrahedra: all interfaces get the finest cells."),
    Row("FineLayers", Number<&M::FineLayers>(2, 64),
      "How many of the finest cells lie at least between an interface and larger cells. Without "
      "Fine Interfaces: around places where Automatic asks for them.")
      .ShownIf("Refinement=Input Levels,Automatic,Coarsen")
      .Advanced(),
    Row("ThinCells", Number<&M::ThinCells>(0, LargestThickness),
      "Refinement Automatic halves cells at films, gaps, rods and small bodies thinner than so "
      "many cells. 0: it does not look for them.")
      .Special(0, "off")
      .ShownIf(Seeks)
      .Advanced(),
    Row("CurvaturePerCell", Number<&M::CurvaturePerCell>(0),
      "Refinement Automatic halves cells where an interface turns by more than so many radians "
      "over a cell. 0: it does not look for that.")
      .Special(0, "off")
      .ShownIf(Seeks)
      .Advanced(),
    Row("RefineFlippedCells", Switch<&M::RefineFlippedCells>(),
      "Refinement Automatic halves cells once whose material had to be changed to make the "
      "interfaces manifold.")
      .ShownIf(Seeks)
      .Advanced(),
    Row("InterfaceLayers", Number<&M::InterfaceLayers>(0, 64),
      "Refinement Automatic refines all cells within so many layers of an interface, to Maximum "
      "Level. 0: it does not.")
      .ShownIf(Seeks)
      .Advanced(),
    Row("RefinementArray", Text(OptionKind::Array, &M::RefinementArray),
      "Cells that Refinement Automatic refines whatever they hold: the array that tells how many "
      "times each is to be halved, 0 to 10 (0 and 1 of a mask), up to Maximum Level. Thin Cells 0 "
      "leaves these alone; without Fine Interfaces each place gets what it asks for.")
      .ShownIf(Seeks)
      .Advanced(),
    Row("RefinementBoxes", Option(),
      "Boxes in which Refinement Automatic refines all cells that they reach into. Seven numbers "
      "each: x, y, z of the lower corner, x, y, z of the upper one, and how many times cells are "
      "halved, 0 to 10.")
      .ShownIf(Seeks)
      .Advanced(),
    Row("MaximumAspectRatio", Number<&M::MaximumAspectRatio>(SmallestAspectRatio),
      "Cut long cells (slices thicker than their pixels) across first, until no cell is so many "
      "times longer one way than another. 1.5 makes elements of good shape. 0: cells stay as they "
      "are.")
      .Special(0, "off")
      .Sculptor("--aspect R"),
    Row("ChildFractions", Choice<&M::Children>({ "Planes", "Parent" }),
      "What the halves, or parts, of a mixed cell hold where there is no finer data. Planes: the "
      "cell is cut by planes that keep the volume of every material. Parent: the fractions of the "
      "cell. Material ids hold no planes: their steps stay, unless Label Smoothing makes planes of "
      "them.")
      .ShownIf("Refinement!=Off | MaximumAspectRatio!=0")
      .Advanced(),
  };
}

OptionTable QualityOptions()
{
  return {
    Row("TargetScaledJacobian", Number<&M::TargetScaledJacobian>(0),
      "The scaled Jacobian that smoothing strives for. Larger values give better hexahedra that "
      "follow the surfaces less closely. 0 is automatic: 0.55 with one material, 0.5 with several.")
      .Below(1)
      .Special(0, "automatic")
      .EnabledIf("!StairStep & Smoothing!=Off")
      .Advanced()
      .OfTets("The quality that smoothing strives for: of tetrahedra the sine of the acute "
              "dihedral angles. Larger values give better tetrahedra that follow the surfaces less "
              "closely. 0.5 is 30 degrees; 0 is automatic, a little more than 0.5."),
    Row("ComputeQuality", Switch<&M::ComputeQuality>(),
      "Add the cell array ScaledJacobian, and its minimum and mean to the field data. A cube has "
      "1, a valid hexahedron more than 0.")
      .Advanced()
      .OfTets(
        "Add the cell array ScaledJacobian, and to the field data its minimum and mean and the "
        "dihedral angles: the smallest, the largest, and how many lie in each ten degrees."),
  };
}

OptionTable PerformanceOptions()
{
  return {
    Row("NumberOfThreads", Number<&M::NumberOfThreads>(0),
      "Threads to work with. 0 is automatic: all cores on one process, one thread on each of "
      "several. The mesh does not depend on it.")
      .Special(0, "automatic")
      .Advanced()
      .InPython("threads"),
  };
}

OptionTable TetrahedraOptions()
{
  return {
    Row("Method", Choice<&M::Tets>({ "TetGen", "Cells", "Lattice" }),
      "How the tetrahedra are made. Lattice: a lattice of cell centres and grid nodes, cut along "
      "the surfaces; the best angles, and the nearest to the surface. Cells: every cell is cut "
      "into tetrahedra around its centre, so that the surfaces have the faces and labels of Volume "
      "Fraction To Hex. TetGen: the surfaces of Cells, filled by TetGen with tetrahedra that grow "
      "away from them; the fewest tetrahedra. TetGen is there only where it was built in."),
    Row("RelativeSize", Number<&M::RelativeSize>(RelativeSizes),
      "Wished length of the edges beside the surfaces, in cells of the grid. The triangles of the "
      "surfaces stay as they are.")
      .ShownIf(Fills),
    Row("Growth", Number<&M::Growth>(Growths),
      "By how much the edges grow over each cell of distance from the surfaces. 0 keeps them as "
      "short everywhere.")
      .ShownIf(Fills),
    Row("RadiusEdgeRatio", Number<&M::RadiusEdgeRatio>(RadiusEdgeRatios),
      "Largest ratio of the circumradius of a tetrahedron to its shortest edge. Smaller values "
      "give more and better tetrahedra.")
      .ShownIf(Fills)
      .Advanced(),
    Row("MinimumDihedralAngle", Number<&M::MinimumDihedralAngle>(MinimumDihedralAngles),
      "The dihedral angle, in degrees, that refinement strives for.")
      .ShownIf(Fills)
      .Advanced(),
    Row("OptimizationLevel", Number<&M::OptimizationLevel>(OptimizationLevels),
      "How much TetGen flips and smooths the tetrahedra.")
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
