/// Files of meshes with bins: the same bytes from any number of ranks, and the parts of a mesh.
#include "FileCases.h"
#include "Meshes/Exodus/ExodusModel.h"
#include "Meshes/Files/MeshModel.h"
#include "Meshes/WriteMesh.h"
#include "Report/Sets/MaterialBins.h"

#include <cmath>
#include <regex>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// A part of a mesh with bins; owns the values of its arrays.
struct BinnedPart
{
  /// @pre Collective
  BinnedPart(const MeshData& mesh, Ranks& ranks) : Data(mesh)
  {
    for (Index element = 0; element < mesh.NumberOfElements; ++element)
    {
      Vector3 centre{};
      for (int c = 0; c < mesh.Corners; ++c)
      {
        centre = centre + (1.0 / mesh.Corners) * mesh.PointAt(mesh.Element(element)[c]);
      }
      this->Values.push_back(1.0 + std::sqrt(centre[0] + 2.0 * centre[1]));
    }
    this->Data.ElementArrays.push_back(
      { "density", ValueType::Double, 1, {}, this->Values.data() });
    // Material 3 keeps its elements.
    this->Bins = BinElements(
      this->Data, { "density", 6, { 1, 2 }, ElasticLaw{ 6850.0, 1.49, 0.3, 0.0, 1.0 } }, ranks);
    this->Data.ElementArrays.push_back({ BinIdName, ValueType::Int, 1, {}, this->Bins.Ids.data() });
    ReplaceBins(this->Bins.Fields, this->Data.Fields);
  }

  MeshData Data;
  std::vector<double> Values;
  BinnedElements Bins;
};

constexpr MeshMaker Makers[] = { MakeHexMesh, MakeTetMesh };

TEST(WriteBins, SameBytesOnRanks)
{
  const Folder folder;
  OutputForm form;
  for (MeshMaker make : Makers)
  {
    for (const char* suffix : { ".inp", ".k", ".feb", ".rad", ".bdf", ".e" })
    {
      form.IsSingle = suffix == std::string(".e");
      for (int count : { 1, 2, 3 })
      {
        WithMesh(count, make,
          [&](const FileCase& part, Ranks& ranks)
          {
            const BinnedPart binned(part.Mesh, ranks);
            WriteMesh(binned.Data, folder / (std::to_string(count) + suffix), ranks, form);
          });
      }
      const auto bytes = [&](const char* name)
      {
        const std::string text = ReadBytes(folder / (std::string(name) + suffix));
        return std::regex_replace(text, std::regex("[0-9]{2}:[0-9]{2}:[0-9]{2}"), "time");
      };
      const std::string one = bytes("1");
      EXPECT_GT(one.size(), 1000u);
      EXPECT_TRUE(one == bytes("2")) << suffix;
      EXPECT_TRUE(one == bytes("3")) << suffix;
    }
  }
}

TEST(WriteBins, PartsHaveTheElementsOfTheBins)
{
  WithMesh(2, MakeHexMesh,
    [](const FileCase& part, Ranks& ranks)
    {
      const BinnedPart binned(part.Mesh, ranks);
      const std::vector<MaterialPart> whole = FindMaterialParts(binned.Data, ranks);
      const std::vector<MaterialPart> parts = DivideByBins(whole, binned.Data, ranks);
      ASSERT_EQ(parts.size(), binned.Bins.Bins.size() + 1);
      Index elements = 0;
      for (std::size_t p = 0; p < parts.size(); ++p)
      {
        const bool isBin = parts[p].Material < 3;
        EXPECT_EQ(parts[p].Bin.has_value(), isBin);
        EXPECT_EQ(parts[p].Name, isBin ? binned.Bins.Bins[p].Name : "three");
        for (Index element : parts[p].Elements)
        {
          EXPECT_EQ(binned.Bins.Ids[element], isBin ? parts[p].Id : 0);
          EXPECT_EQ(binned.Data.Material[element], parts[p].Material);
        }
        elements += static_cast<Index>(parts[p].Elements.size());
      }
      EXPECT_EQ(elements, binned.Data.NumberOfElements);
    });
}

TEST(WriteBins, ExodusNumbersFollowTheBlocks)
{
  WithMesh(1, MakeTetMesh,
    [](const FileCase& part, Ranks& ranks)
    {
      const BinnedPart binned(part.Mesh, ranks);
      const ExodusModel model = MakeExodusModel(binned.Data, ranks);
      std::vector<Index> numbers(model.Numbers.size(), 0);
      Index number = 0;
      for (const ExodusBlock& block : model.Blocks)
      {
        for (Index element : block.Elements)
        {
          EXPECT_EQ(model.Numbers[element], ++number) << block.Name;
        }
      }
      EXPECT_EQ(number, binned.Data.NumberOfElements);
      EXPECT_EQ(model.Blocks.size(), binned.Bins.Bins.size() + 1);
      // Named sets do not depend on bins.
      const ExodusModel plain = MakeExodusModel(part.Mesh, ranks);
      ASSERT_EQ(model.Sets.SideSets.size(), plain.Sets.SideSets.size());
      for (std::size_t s = 0; s < plain.Sets.SideSets.size(); ++s)
      {
        EXPECT_EQ(model.Sets.SideSets[s].Name, plain.Sets.SideSets[s].Name);
        EXPECT_EQ(model.Sets.SideSets[s].Id, plain.Sets.SideSets[s].Id);
        EXPECT_EQ(model.Sets.SideSets[s].Sides.size(), plain.Sets.SideSets[s].Sides.size());
      }
    });
}

TEST(WriteBins, UnknownBinsAreAnError)
{
  WithMesh(2, MakeHexMesh,
    [](const FileCase& part, Ranks& ranks)
    {
      BinnedPart binned(part.Mesh, ranks);
      if (ranks.Rank() == 1)
      {
        binned.Bins.Ids[0] = 99;
      }
      const std::vector<MaterialPart> whole = FindMaterialParts(binned.Data, ranks);
      try
      {
        DivideByBins(whole, binned.Data, ranks);
        ADD_FAILURE();
      }
      catch (const InputError& error)
      {
        EXPECT_NE(std::string(error.what()).find("has the BinId 99"), std::string::npos);
      }
    });
}

} // namespace
