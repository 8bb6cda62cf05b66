#include "Meshes/OpenFoam/FoamMesh.h"

#include "Meshes/Files/MeshModel.h"
#include "Meshes/OpenFoam/CyclicSides.h"
#include "Meshes/OpenFoam/FoamSurfaces.h"
#include "Ranks/Agreement.h"

#include <limits>
#include <map>

namespace vfm
{
namespace
{

constexpr Index LargestLabel = std::numeric_limits<std::int32_t>::max();

/// Faces of a cyclic patch with their copies on another rank.
struct RemoteCyclic
{
  std::string Name; // of the cyclic patch
  std::vector<Index> Sides, Numbers;
};

/// Builds the lists of a model one after another.
class FoamMeshMaker
{
public:
  FoamMeshMaker(FoamMesh& foam, Ranks& ranks) :
    Foam(foam),
    Surfaces(FindFoamSurfaces(foam.Mesh, ranks)),
    Cells(FindCellSides(foam.Mesh, foam.Cells.Positions, ranks))
  {
  }

  void AddInnerFaces();
  /// @pre Collective
  void AddCyclicPatches(Ranks& ranks);
  /// @pre Collective
  void AddPatches(Ranks& ranks);
  void AddRemoteCyclics();
  void AddRemoteFaces();
  void AddEnds();
  /// @pre Collective
  void AddCellZones(Ranks& ranks);
  /// @pre Collective
  void AddFaceZones(Ranks& ranks);

private:
  bool IsBefore(const RemoteSide& a, const RemoteSide& b) const;

  FoamMesh& Foam;
  const FoamSurfaces Surfaces;
  const CellSides Cells;
  std::vector<Index> Open; ///< sides on patches that are added later
  /// Patches of cyclic faces with their copy on another rank, by rank and number of the patch.
  std::map<std::pair<int, std::size_t>, RemoteCyclic> RemoteCyclics;
};

void FoamMeshMaker::AddInnerFaces()
{
  const MeshData& mesh = this->Foam.Mesh;
  const Index sides = SidesOf(mesh);
  std::vector<Index> owned;
  for (Index cell = 0; cell < mesh.NumberOfElements; ++cell)
  {
    const auto behind = [this](Index side) { return this->Cells.Behind[side]; };
    owned.clear();
    for (Index side = sides * cell; side < sides * (cell + 1); ++side)
    {
      if (behind(side) > cell)
      {
        owned.push_back(side);
      }
    }
    std::sort(owned.begin(), owned.end(),
      [&](Index a, Index b)
      {
        return behind(a) != behind(b) ? behind(a) < behind(b)
                                      : SortedPointsOfSide(mesh, a) < SortedPointsOfSide(mesh, b);
      });
    for (Index side : owned)
    {
      this->Foam.Sides.push_back(side);
      this->Foam.Neighbours.push_back(behind(side));
    }
  }
}

void FoamMeshMaker::AddCyclicPatches(Ranks& ranks)
{
  std::vector<Index> open;
  for (Index side = 0; side < static_cast<Index>(this->Cells.Behind.size()); ++side)
  {
    if (this->Cells.Behind[side] == NothingBehind)
    {
      open.push_back(side);
    }
  }
  FoamMesh& foam = this->Foam;
  CyclicSides cyclic = FindCyclicSides(foam.Mesh, open, ranks);
  for (const CyclicPatches& both : cyclic.Patches)
  {
    for (int p = 0; p < 2; ++p)
    {
      foam.Patches.push_back({ both.Names[p], "cyclic", "", 0, -1, both.Names[1 - p] });
      for (const CyclicSide& side : both.Sides[p])
      {
        if (side.CopyRank == foam.Rank)
        {
          ++foam.Patches.back().Count;
          foam.Sides.push_back(side.Side);
          foam.CyclicNumbers.push_back(foam.TotalCyclic + side.Number);
        }
        else
        {
          RemoteCyclic& remote = this->RemoteCyclics[{ side.CopyRank, foam.Patches.size() }];
          remote.Name = both.Names[p];
          remote.Sides.push_back(side.Side);
          remote.Numbers.push_back(foam.TotalCyclic + side.Number);
        }
      }
      foam.TotalCyclic += both.Count;
    }
  }
  this->Open = std::move(cyclic.Others);
}

std::string NameOfPatchTo(int rank, int other)
{
  return "procBoundary" + std::to_string(rank) + "to" + std::to_string(other);
}

void FoamMeshMaker::AddRemoteCyclics()
{
  FoamMesh& foam = this->Foam;
  for (const auto& [key, remote] : this->RemoteCyclics)
  {
    foam.Patches.push_back({ NameOfPatchTo(foam.Rank, key.first) + "through" + remote.Name,
      "processorCyclic", "", static_cast<Index>(remote.Sides.size()), key.first, "", remote.Name });
    foam.Sides.insert(foam.Sides.end(), remote.Sides.begin(), remote.Sides.end());
    foam.CyclicNumbers.insert(
      foam.CyclicNumbers.end(), remote.Numbers.begin(), remote.Numbers.end());
  }
}

void FoamMeshMaker::AddPatches(Ranks& ranks)
{
  UniqueNames used;
  for (const FoamPatch& cyclic : this->Foam.Patches)
  {
    used.Add(cyclic.Name);
  }
  std::vector<FoamPatch> patches = ListPatches(this->Surfaces, used);
  std::vector<std::vector<Index>> sides(patches.size());
  for (Index side : this->Open)
  {
    const SideSurface* entry = this->Surfaces.Find(SideOfNumber(this->Foam.Mesh, side));
    (entry ? sides[entry->Surface] : sides.back()).push_back(side);
  }
  std::vector<Index> totals;
  for (const std::vector<Index>& list : sides)
  {
    totals.push_back(static_cast<Index>(list.size()));
  }
  ranks.Sum(totals);
  for (std::size_t p = 0; p < patches.size(); ++p)
  {
    if (totals[p] > 0)
    {
      patches[p].Count = static_cast<Index>(sides[p].size());
      this->Foam.Patches.push_back(patches[p]);
      this->Foam.Sides.insert(this->Foam.Sides.end(), sides[p].begin(), sides[p].end());
    }
  }
  RemoveEqualGroups(this->Foam.Patches);
}

/// Orders faces to other ranks by rank, then as both ranks order them: by the lower cell, the
/// upper cell, and the points.
bool FoamMeshMaker::IsBefore(const RemoteSide& a, const RemoteSide& b) const
{
  const FoamMesh& foam = this->Foam;
  const Index sides = SidesOf(foam.Mesh);
  const auto key = [&](const RemoteSide& side)
  {
    const Index cell = foam.Cells.Positions[side.Side / sides];
    return std::array<Index, 3>{ { side.Rank, std::min(cell, side.Cell),
      std::max(cell, side.Cell) } };
  };
  const std::array<Index, 3> first = key(a), second = key(b);
  return first != second
    ? first < second
    : SortedPointsOfSide(foam.Mesh, a.Side) < SortedPointsOfSide(foam.Mesh, b.Side);
}

void FoamMeshMaker::AddRemoteFaces()
{
  FoamMesh& foam = this->Foam;
  foam.Remote = this->Cells.Remote;
  std::sort(foam.Remote.begin(), foam.Remote.end(),
    [this](const RemoteSide& a, const RemoteSide& b) { return this->IsBefore(a, b); });
  for (const RemoteSide& side : foam.Remote)
  {
    const bool isSame = !foam.Patches.empty() && foam.Patches.back().Type == "processor" &&
      foam.Patches.back().Neighbour == side.Rank;
    if (!isSame)
    {
      foam.Patches.push_back(
        { NameOfPatchTo(foam.Rank, side.Rank), "processor", "", 0, side.Rank });
    }
    ++foam.Patches.back().Count;
    foam.Sides.push_back(side.Side);
  }
}

/// Adds the patches of the lower and upper faces of a mesh of a plane.
void FoamMeshMaker::AddEnds()
{
  FoamMesh& foam = this->Foam;
  const std::vector<double> axis = NumbersOfField(foam.Mesh.Fields, FlatAxisName);
  for (const char* end : { "_min", "_max" })
  {
    const std::string name = std::string(1, "xyz"[static_cast<int>(axis.at(0))]) + end;
    foam.Patches.push_back({ name, "empty", "", foam.Mesh.NumberOfElements });
  }
}

void FoamMeshMaker::AddCellZones(Ranks& ranks)
{
  UniqueNames used;
  for (MaterialPart& part : FindMaterialParts(this->Foam.Mesh, ranks))
  {
    this->Foam.CellZones.push_back({ used.Add(FoamWord(part.Name)), std::move(part.Elements), {} });
  }
}

void FoamMeshMaker::AddFaceZones(Ranks& ranks)
{
  FoamMesh& foam = this->Foam;
  std::vector<FoamZone> zones(this->Surfaces.Surfaces.size());
  const auto add = [&](Index face)
  {
    const ElementSide number = SideOfNumber(foam.Mesh, foam.Sides[face]);
    if (const SideSurface* side = this->Surfaces.Find(number))
    {
      FoamZone& zone = zones[this->Surfaces.Surfaces[side->Surface].Interface];
      zone.Members.push_back(face);
      zone.IsFlipped.push_back(side->IsFlipped);
    }
  };
  const Index inner = static_cast<Index>(foam.Neighbours.size());
  const Index faces = static_cast<Index>(foam.Sides.size());
  for (Index face = 0; face < inner; ++face)
  {
    add(face);
  }
  for (Index face = faces - static_cast<Index>(foam.Remote.size()); face < faces; ++face)
  {
    add(face);
  }
  for (std::size_t s = 0; s < zones.size(); ++s)
  {
    if (ranks.Any(!zones[s].Members.empty()))
    {
      zones[s].Name = this->Surfaces.Surfaces[s].Name;
      foam.FaceZones.push_back(std::move(zones[s]));
    }
  }
}

/// Returns the number of faces of all ranks.
/// @pre Collective
Index CountFaces(const FoamMesh& foam, Ranks& ranks)
{
  const Index remote = SumOverRanks(static_cast<Index>(foam.Remote.size()), ranks);
  return SumOverRanks(foam.NumberOfFaces(), ranks) - remote / 2;
}

} // namespace

FoamMesh MakeFoamMesh(const MeshData& mesh, Ranks& ranks)
{
  FoamMesh foam;
  foam.Mesh = mesh;
  foam.Rank = ranks.Rank();
  WorkTogether(ranks,
    [&]
    {
      Require(mesh.Material, "MaterialId", mesh);
      foam.Points = OrderIds(mesh.PointIds, mesh.NumberOfPoints, ranks);
      foam.Cells = OrderIds(mesh.ElementIds, mesh.NumberOfElements, ranks);
      FoamMeshMaker maker(foam, ranks);
      maker.AddInnerFaces();
      maker.AddCyclicPatches(ranks);
      maker.AddPatches(ranks);
      maker.AddRemoteCyclics();
      maker.AddRemoteFaces();
      if (IsFlat(mesh))
      {
        maker.AddEnds();
      }
      maker.AddCellZones(ranks);
      maker.AddFaceZones(ranks);
      foam.TotalFaces = CountFaces(foam, ranks);
    });
  return foam;
}

void CheckSizes(const FoamMesh& foam)
{
  const bool isFlat = IsFlat(foam.Mesh);
  const Index offsets = (isFlat ? 4 : CornersOfSide(foam.Mesh)) * foam.NumberOfFaces();
  const Index largest =
    std::max({ (isFlat ? 2 : 1) * foam.Points.Total, foam.Cells.Total, foam.TotalFaces, offsets });
  if (largest > LargestLabel)
  {
    throw InputError("The mesh has " + std::to_string(foam.TotalFaces) +
      " faces. OpenFOAM's labels of 32 bits count at most 2147483647 points, cells, faces, and "
      "corners of the faces of one rank.");
  }
}

} // namespace vfm
