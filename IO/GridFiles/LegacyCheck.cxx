#include "GridFiles/LegacyCheck.h"

#include "Base/ParseText.h"
#include "GridFiles/LegacyStream.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>

namespace vfm
{
namespace
{

/// Walks through the keywords of a file.
class LegacyCheck
{
public:
  explicit LegacyCheck(const std::string& path) : File(path) {}
  void Run();

private:
  void ReadHead();
  bool ReadGeometry(const std::string& key);
  bool ReadCells(const std::string& key);
  bool ReadAttribute(const std::string& key);
  bool ReadSpecial(const std::string& key);
  void ReadExtent(bool hasLower);
  void ReadList();
  void ReadOffsets();
  void ReadCellList(const std::string& name, std::int64_t count, const VisitVtkValue& visit);
  void ReadField();
  void ReadData(bool isOfPoints);
  void Array(std::int64_t components, const std::string& name);

  LegacyStream File;
  int Version = 0;                                  // major
  std::optional<std::array<std::int64_t, 3>> Nodes; // of structured grids
  std::optional<std::int64_t> Points, Cells, Tuples;
};

void LegacyCheck::ReadHead()
{
  constexpr const char* magic = "# vtk DataFile Version ";
  const std::string first = this->File.Line();
  if (first.rfind(magic, 0) != 0)
  {
    throw InputError(
      std::string("it is not a legacy VTK file: it does not begin with '") + magic + "'.");
  }
  const std::string version = TrimText(first.substr(std::string(magic).size()));
  const std::size_t point = version.find('.');
  const auto major = ParseCount(version.substr(0, point), 1, 99);
  if (!major || point == std::string::npos || !ParseCount(version.substr(point + 1), 0, 99))
  {
    RejectLegacyFile("its version is " + QuoteWord(version));
  }
  this->Version = *major;
  this->File.Line(); // the title
  const std::string form = this->File.Keyword();
  if (form != "ascii" && form != "binary")
  {
    RejectLegacyFile("its third line is " + QuoteWord(form) + ", ASCII or BINARY is required");
  }
  this->File.IsBinary = form == "binary";
}

void LegacyCheck::Run()
{
  this->ReadHead();
  for (std::string key = this->File.Keyword(); !key.empty(); key = this->File.Keyword())
  {
    if (!this->ReadGeometry(key) && !this->ReadCells(key) && !this->ReadAttribute(key) &&
      !this->ReadSpecial(key))
    {
      RejectLegacyFile("it has the unknown keyword " + QuoteWord(key) + this->File.AfterArray());
    }
    this->File.SkipMetadata();
  }
  if (this->Nodes && this->Points &&
    *this->Points != (*this->Nodes)[0] * (*this->Nodes)[1] * (*this->Nodes)[2])
  {
    RejectLegacyFile("its number of points is not the product of its dimensions");
  }
}

/// Reads the values of an array whose type follows.
void LegacyCheck::Array(std::int64_t components, const std::string& name)
{
  if (!this->Tuples)
  {
    RejectLegacyFile("its " + name + " is neither of points nor of cells");
  }
  this->File.ReadValues(this->File.Keyword(), *this->Tuples * components, name);
}

void LegacyCheck::ReadExtent(bool hasLower)
{
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max() - 1;
  std::array<std::int64_t, 3> nodes{};
  double points = 1.0;
  for (std::int64_t& count : nodes)
  {
    const std::int64_t lower = hasLower ? this->File.Int(-most, most, "extent") : 1;
    count = this->File.Int(hasLower ? lower : 1, most, "dimension") - lower + 1;
    points *= static_cast<double>(count);
  }
  if (points > static_cast<double>(MostLegacyValues))
  {
    RejectLegacyFile("its dimensions are too large");
  }
  this->Nodes = nodes;
}

bool LegacyCheck::ReadGeometry(const std::string& key)
{
  static const std::array<const char*, 3> axes{ { "x_coordinates", "y_coordinates",
    "z_coordinates" } };
  const auto axis = std::find(axes.begin(), axes.end(), key);
  if (key == "dataset")
  {
    const std::string type = this->File.Keyword();
    if (type != "structured_points" && type != "structured_grid" && type != "rectilinear_grid" &&
      type != "unstructured_grid")
    {
      throw InputError("its data set is " + QuoteWord(type) +
        ". STRUCTURED_POINTS, RECTILINEAR_GRID, STRUCTURED_GRID and UNSTRUCTURED_GRID are "
        "supported.");
    }
  }
  else if (key == "dimensions" || key == "extent")
  {
    this->ReadExtent(key == "extent");
  }
  else if (key == "spacing" || key == "aspect_ratio" || key == "origin")
  {
    this->File.Numbers(key);
  }
  else if (key == "points")
  {
    this->Points = this->File.Int(0, MostLegacyValues, "number of points");
    this->File.ReadValues(this->File.Keyword(), 3 * *this->Points, "points");
  }
  else if (axis != axes.end())
  {
    const std::int64_t count = this->File.Int(1, MostLegacyValues, "number of coordinates");
    if (!this->Nodes || (*this->Nodes)[axis - axes.begin()] != count)
    {
      RejectLegacyFile("its number of coordinates is not its dimension");
    }
    this->File.ReadValues(this->File.Keyword(), count, "coordinates");
  }
  else
  {
    return false;
  }
  return true;
}

/// Reads a list of numbers of points with their points (before version 5.0).
void LegacyCheck::ReadList()
{
  const std::int64_t size = this->File.Int(0, MostLegacyValues, "size of cells");
  std::int64_t cells = 0, left = 0;
  this->File.ReadValues("int", size, "list of cells",
    [&](double number)
    {
      const auto value = static_cast<std::int64_t>(number);
      if (left > 0)
      {
        --left;
        if (value < 0 || (this->Points && value >= *this->Points))
        {
          RejectLegacyFile("a cell has the point " + std::to_string(value));
        }
        return;
      }
      if (value < 0)
      {
        RejectLegacyFile("a cell has " + std::to_string(value) + " points");
      }
      left = value;
      ++cells;
    });
  if (cells != *this->Cells || left != 0)
  {
    RejectLegacyFile("its list of cells does not hold " + std::to_string(*this->Cells) + " cells");
  }
}

bool LegacyCheck::ReadCells(const std::string& key)
{
  if (key == "cell_types")
  {
    const std::int64_t count = this->File.Int(0, MostLegacyValues, "number of types");
    if (!this->Cells || *this->Cells != count)
    {
      RejectLegacyFile("its number of types is not its number of cells");
    }
    this->File.ReadValues("int", count, "list of types",
      [](double type)
      {
        if (type < 0.0 || type > 255.0)
        {
          RejectLegacyFile("a cell is of the type " + FormatNumber(type));
        }
      });
    return true;
  }
  if (key != "cells")
  {
    return false;
  }
  this->Cells = this->File.Int(0, MostLegacyValues, "number of cells");
  if (this->Version < 5)
  {
    this->ReadList();
    return true;
  }
  this->ReadOffsets();
  return true;
}

/// Reads the ends of the lists of points, and the points (from version 5.0).
void LegacyCheck::ReadOffsets()
{
  const std::int64_t offsets = *this->Cells;
  const std::int64_t size = this->File.Int(0, MostLegacyValues, "size of cells");
  this->Cells = std::max<std::int64_t>(offsets - 1, 0);
  if (offsets == 0)
  {
    return;
  }
  double end = 0.0;
  this->ReadCellList("offsets", offsets,
    [&](double value)
    {
      if (!(value >= end && value <= static_cast<double>(size)))
      {
        RejectLegacyFile("a cell ends at point " + FormatNumber(value) + " after " +
          FormatNumber(end) + " of " + std::to_string(size));
      }
      end = value;
    });
  this->ReadCellList("connectivity", size,
    [&](double point)
    {
      if (!(point >= 0.0 && (!this->Points || point < static_cast<double>(*this->Points))))
      {
        RejectLegacyFile("a cell has the point " + FormatNumber(point));
      }
    });
}

void LegacyCheck::ReadCellList(
  const std::string& name, std::int64_t count, const VisitVtkValue& visit)
{
  if (this->File.Keyword() != name)
  {
    RejectLegacyFile("its cells have no " + name);
  }
  this->File.ReadValues(this->File.Keyword(), count, name, visit);
}

/// Reads the begin of the arrays of points or of cells.
void LegacyCheck::ReadData(bool isOfPoints)
{
  const std::int64_t count = this->File.Int(0, MostLegacyValues, "number of values");
  auto expected = isOfPoints ? this->Points : this->Cells;
  if (this->Nodes)
  {
    expected = 1;
    for (std::int64_t nodes : *this->Nodes)
    {
      *expected *= isOfPoints ? nodes : std::max<std::int64_t>(nodes - 1, 1);
    }
  }
  if (expected.value_or(0) != count)
  {
    RejectLegacyFile("it has values of " + std::to_string(count) +
      (isOfPoints ? " points, " : " cells, ") + std::to_string(expected.value_or(0)) +
      " are required");
  }
  this->Tuples = count;
}

bool LegacyCheck::ReadAttribute(const std::string& key)
{
  static const std::map<std::string, int> components{ { "vectors", 3 }, { "normals", 3 },
    { "tensors", 9 }, { "tensors6", 6 }, { "global_ids", 1 }, { "pedigree_ids", 1 },
    { "edge_flags", 1 } };
  const auto known = components.find(key);
  if (key == "point_data" || key == "cell_data")
  {
    this->ReadData(key == "point_data");
  }
  else if (known != components.end())
  {
    const std::string name = "array " + QuoteWord(this->File.Word());
    this->Array(known->second, name);
  }
  else if (key == "texture_coordinates")
  {
    const std::string name = "array " + QuoteWord(this->File.Word());
    this->Array(this->File.Int(1, 3, "number of texture coordinates"), name);
  }
  else if (key == "scalars")
  {
    const std::string name = "array " + QuoteWord(this->File.Word()), type = this->File.Keyword();
    const std::string count = this->File.Keyword();
    const bool isSingle = count == "lookup_table";
    const auto parsed = isSingle ? 1 : ParseCount(count, 1, 1 << 20);
    if (!parsed || !this->Tuples || (!isSingle && this->File.Keyword() != "lookup_table"))
    {
      RejectLegacyFile("its " + name + " has no number of components or no LOOKUP_TABLE");
    }
    this->File.Word(); // name of the table
    this->File.ReadValues(type, *this->Tuples * *parsed, name);
  }
  else
  {
    return false;
  }
  return true;
}

/// Reads arrays of other forms: fields, colours, tables of colours, blanked points.
bool LegacyCheck::ReadSpecial(const std::string& key)
{
  const std::string ofColours = this->File.IsBinary ? "unsigned_char" : "float";
  if (key == "field")
  {
    this->ReadField();
  }
  else if (key == "metadata")
  {
    this->File.SkipDescription();
  }
  else if (key == "color_scalars" || key == "lookup_table")
  {
    const bool isTable = key == "lookup_table";
    const std::string name = "array " + QuoteWord(this->File.Word());
    const std::int64_t count = this->File.Int(0, 1 << 20, "number of colours");
    this->File.ReadValues(ofColours, isTable ? 4 * count : this->Tuples.value_or(0) * count, name,
      [&](double value)
      {
        if (!(value >= 0.0 && value <= (this->File.IsBinary ? 255.0 : 1.0)))
        {
          RejectLegacyFile("its " + name + " has the colour " + FormatNumber(value) +
            ", from 0 to 1 are required");
        }
      });
  }
  else if (key == "blanking")
  {
    const std::int64_t count = this->File.Int(0, MostLegacyValues, "number of blanked points");
    this->File.ReadValues(this->File.Keyword(), count, "blanking");
  }
  else
  {
    return false;
  }
  return true;
}

void LegacyCheck::ReadField()
{
  this->File.Word(); // its name
  const std::int64_t arrays = this->File.Int(0, 1 << 20, "number of fields");
  for (std::int64_t a = 0; a < arrays; ++a)
  {
    const std::string word = this->File.Word(), name = "array " + QuoteWord(word);
    const std::string of = " of its " + name + this->File.AfterArray();
    if (word == "NULL_ARRAY")
    {
      continue;
    }
    const std::int64_t components = this->File.Int(0, 1 << 20, "number of components" + of);
    const std::int64_t tuples = this->File.Int(0, MostLegacyValues, "number of values" + of);
    if (components > 0 && tuples > MostLegacyValues / components)
    {
      RejectLegacyFile("its " + name + " has too many values");
    }
    if (this->Tuples && *this->Tuples != tuples)
    {
      RejectLegacyFile("its " + name + " has " + std::to_string(tuples) + " values, " +
        std::to_string(*this->Tuples) + " are required");
    }
    this->File.ReadValues(this->File.Keyword(), components * tuples, name);
    this->File.SkipMetadata();
  }
}

} // namespace

void CheckLegacyFile(const std::string& path)
{
  LegacyCheck(path).Run();
}

} // namespace vfm
