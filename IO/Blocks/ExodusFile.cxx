#include "Blocks/ExodusFile.h"

#include "Base/ParseText.h"
#include "Blocks/NetcdfFile.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>

namespace vfm
{
namespace
{

constexpr std::size_t CornersOfHex = 8;

[[noreturn]] void RejectDamaged(const std::string& what)
{
  throw InputError("the file is damaged or not an Exodus file: " + what + ".");
}

std::unique_ptr<NetcdfFile> OpenExodus(const std::string& path)
{
  auto file = OpenNetcdf(path);
  const auto& dimensions = file->Header().Dimensions;
  if (std::none_of(dimensions.begin(), dimensions.end(),
        [](const NetcdfHeader::Dimension& dimension)
        { return dimension.Name == "num_dim" && dimension.Length >= 1 && dimension.Length <= 3; }))
  {
    RejectDamaged("it has no number of dimensions, num_dim");
  }
  return file;
}

std::vector<double> ReadTimes(NetcdfFile& file)
{
  std::vector<double> times;
  const StoredVariable* variable = file.Find("time_whole");
  for (Index record = 0; record < file.Header().Records; ++record)
  {
    if (!variable)
    {
      RejectDamaged("it has no variable time_whole");
    }
    if (!variable->HasRecords || variable->Count != 1)
    {
      RejectDamaged("time_whole is not one number for each time");
    }
    times.push_back(file.ReadReals(*variable, record)[0]);
    if (!std::isfinite(times.back()))
    {
      RejectDamaged("its time " + std::to_string(record) + " is not finite");
    }
  }
  return times;
}

/// Returns the names of the element variables, in the order of the file.
std::vector<std::string> ReadNames(NetcdfFile& file)
{
  const StoredVariable* variable = file.Find("name_elem_var");
  if (!variable)
  {
    return {};
  }
  if (variable->HasRecords || variable->Shape.size() != 2)
  {
    RejectDamaged("name_elem_var is not a list of names");
  }
  const std::string text = file.ReadText(*variable);
  std::vector<std::string> names;
  for (Index i = 0; i < variable->Shape[0]; ++i)
  {
    std::string name = text.substr(i * variable->Shape[1], variable->Shape[1]).c_str();
    name.erase(name.find_last_not_of(' ') + 1);
    const auto isControl = [](unsigned char c) { return std::iscntrl(c) != 0; };
    std::replace_if(name.begin(), name.end(), isControl, '?');
    names.push_back(std::move(name));
  }
  return names;
}

/// Reads the coordinates of the points along each axis; a plane mesh has no z.
std::array<std::vector<double>, 3> ReadCoordinates(NetcdfFile& file)
{
  std::array<std::vector<double>, 3> coordinates;
  if (const StoredVariable* table = file.Find("coord")) // as in files of the first versions
  {
    const std::vector<double> all = file.ReadReals(*table);
    const std::size_t axes = table->Shape.size() == 2 ? table->Shape[0] : 0;
    for (std::size_t a = 0; a < std::min<std::size_t>(axes, 3); ++a)
    {
      const auto first = all.begin() + static_cast<std::ptrdiff_t>(a * (all.size() / axes));
      coordinates[a].assign(first, first + static_cast<std::ptrdiff_t>(all.size() / axes));
    }
    return coordinates;
  }
  for (int a = 0; a < 3; ++a)
  {
    const StoredVariable* axis = file.Find(std::string("coord") + "xyz"[a]);
    coordinates[a] = axis ? file.ReadReals(*axis) : std::vector<double>();
  }
  return coordinates;
}

std::vector<Vector3> ReadPoints(NetcdfFile& file)
{
  const auto coordinates = ReadCoordinates(file);
  std::vector<Vector3> points(coordinates[0].size(), Vector3{});
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = coordinates[a];
    if (!x.empty() && x.size() != points.size())
    {
      RejectDamaged("its points have different numbers of coordinates");
    }
    for (std::size_t p = 0; p < x.size(); ++p)
    {
      points[p][a] = x[p];
    }
  }
  return points;
}

/// Tests whether the name of a type of elements, in any case, begins with one of some words.
/// @param words  in lower case
bool BeginsWith(const std::string& type, std::initializer_list<std::string> words)
{
  const std::string lower = ToLower(type);
  return std::any_of(words.begin(), words.end(),
    [&lower](const std::string& word) { return lower.compare(0, word.size(), word) == 0; });
}

/// Returns whether elements of a type have less than three dimensions.
bool IsFlatType(const std::string& type)
{
  return BeginsWith(type,
    { "sphere", "circle", "point", "truss", "beam", "bar", "edge", "line", "rod", "spring", "tri",
      "quad", "shell", "nsided", "null" });
}

/// Reads the elements of a block; Corners stays empty if the block does not exist or is empty.
void ReadElements(NetcdfFile& file, const std::string& number, ElementBlock& block)
{
  const StoredVariable* connect = file.Find("connect" + number);
  if (!connect || connect->Count == 0 || IsFlatType(connect->ElemType))
  {
    return;
  }
  if (connect->HasRecords || connect->Shape.empty())
  {
    RejectDamaged("connect" + number + " is not a table of points");
  }
  block.Type = connect->ElemType;
  block.Count = connect->Shape[0];
  block.Corners = file.ReadIntegers(*connect);
  for (Index& point : block.Corners)
  {
    point = point > 0 ? point - 1 : -1;
  }
}

/// Reads the element variables of a block at a step, and its id.
std::shared_ptr<PlainArrays> ReadArrays(NetcdfFile& file, const std::string& number,
  const ElementBlock& block, const std::optional<Index>& step,
  const std::vector<std::string>& names, const std::vector<std::string>& known, Index id)
{
  const auto arrays = std::make_shared<PlainArrays>(block.Count);
  for (const std::string& name : names)
  {
    const auto place = std::find(known.begin(), known.end(), name) - known.begin();
    const StoredVariable* variable =
      file.Find("vals_elem_var" + std::to_string(place + 1) + "eb" + number);
    if (place == static_cast<std::ptrdiff_t>(known.size()))
    {
      if (name == BlockIds)
      {
        arrays->Store(name, ValueType::Id, std::vector<Index>(block.Count, id));
      }
      continue;
    }
    if (!variable || !step)
    {
      continue; // the block does not have it
    }
    if (!variable->HasRecords || variable->Count != block.Count)
    {
      RejectDamaged(variable->Name + " is not one number for each element and time");
    }
    arrays->Store(name, ValueType::Double, file.ReadReals(*variable, *step));
  }
  return arrays;
}

/// Returns the ids of the blocks.
std::vector<Index> ReadIds(NetcdfFile& file)
{
  const StoredVariable* ids = file.Find("eb_prop1");
  if (ids && !ids->HasRecords)
  {
    return file.ReadIntegers(*ids);
  }
  std::vector<Index> numbers; // from 1
  while (file.Find("connect" + std::to_string(numbers.size() + 1)))
  {
    numbers.push_back(static_cast<Index>(numbers.size()) + 1);
  }
  return numbers;
}

/// The elements of a block.
class CellsOfBlock : public HexCells
{
public:
  explicit CellsOfBlock(const ElementBlock& block) : Block(block) {}
  Index NumberOfPoints() const override { return static_cast<Index>(this->Block.Points->size()); }
  Vector3 GetPoint(Index point) const override { return (*this->Block.Points)[point]; }
  std::span<const Index> GetCorners(Index cell) override { return this->Block.GetPoints(cell); }

private:
  const ElementBlock& Block;
};

/// Returns the tuples of cells.
std::shared_ptr<const PlainArrays> Arrange(
  const PlainArrays& arrays, const std::vector<Index>& cells)
{
  const auto arranged = std::make_shared<PlainArrays>(static_cast<Index>(cells.size()));
  for (const std::string& name : arrays.Names())
  {
    const auto array = arrays.Find(name);
    VisitType(array->Type,
      [&](auto tag)
      {
        using Value = typename decltype(tag)::Type;
        const auto* from = static_cast<const Value*>(array->Memory);
        std::vector<Value> values(cells.size());
        std::transform(
          cells.begin(), cells.end(), values.begin(), [from](Index cell) { return from[cell]; });
        arranged->Store(name, array->Type, std::move(values));
      });
  }
  return arranged;
}

} // namespace

ExodusContents ReadExodusContents(const std::string& path)
{
  const auto file = OpenExodus(path);
  return { ReadTimes(*file), ReadNames(*file) };
}

std::vector<ElementBlock> ReadElementBlocks(
  const std::string& path, const std::optional<Index>& step, const std::vector<std::string>& names)
{
  const auto file = OpenExodus(path);
  const auto points = std::make_shared<const std::vector<Vector3>>(ReadPoints(*file));
  const std::vector<std::string> known = ReadNames(*file);
  const std::vector<Index> ids = ReadIds(*file);
  std::vector<ElementBlock> blocks;
  for (std::size_t b = 0; b < ids.size(); ++b)
  {
    ElementBlock block;
    const std::string number = std::to_string(b + 1);
    ReadElements(*file, number, block);
    if (!block.Corners.empty())
    {
      block.Points = points;
      block.Arrays = ReadArrays(*file, number, block, step, names, known, ids[b]);
      blocks.push_back(std::move(block));
    }
  }
  return blocks;
}

std::vector<InputBlock> FindBoxes(const ElementBlock& block, int number, const std::string& name)
{
  if (!BeginsWith(block.Type, { "hex" }) || block.GetPoints(0).size() != CornersOfHex)
  {
    RejectCell(name, 0,
      "is of the type '" + block.Type +
        "'. Only hexahedra that are the cells of a Cartesian grid can be meshed: bring other cells "
        "onto a grid first (ParaView's filter Resample To Image).");
  }
  std::vector<Index> cells(block.Count);
  std::iota(cells.begin(), cells.end(), 0);
  CellsOfBlock corners(block);
  HexBoxes boxes = FindHexBoxes(corners, cells, number, name);
  const auto arrays =
    boxes.HaveOrderOf(block.Count) ? block.Arrays : Arrange(*block.Arrays, boxes.Cells);
  for (InputBlock& box : boxes.Blocks)
  {
    box.Arrays = arrays;
  }
  return std::move(boxes.Blocks);
}

} // namespace vfm
