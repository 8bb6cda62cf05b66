#include "StateArrays.h"

#include "Agreement.h"
#include "InputArrays.h"
#include "InputRoute.h"
#include "Transfer/StateCells.h"

#include <deque>
#include <memory>
#include <sstream>

namespace vfm
{
namespace
{

constexpr const char* ArraysOfMesh[] = { "MaterialId", "FragmentId", "GlobalCellIds",
  "ScaledJacobian", "vtkGhostType" };

void CheckNames(const std::vector<std::string>& names)
{
  for (const std::string& name : names)
  {
    if (std::find(std::begin(ArraysOfMesh), std::end(ArraysOfMesh), name) != std::end(ArraysOfMesh))
    {
      throw InputError("The state array '" + name +
        "' has the name of an array that the mesh itself may have: rename it, or leave it "
        "out.");
    }
  }
}

StateLayout LayoutOf(vtkDataArray* array)
{
  StateLayout layout{ array->GetDataType(), array->GetNumberOfComponents(), {} };
  for (int c = 0; array->HasAComponentName() && c < layout.Components; ++c)
  {
    const char* name = array->GetComponentName(c);
    layout.ComponentNames.emplace_back(name ? name : "");
  }
  return layout;
}

std::string Text(const StateLayout& layout)
{
  return std::to_string(layout.Components) + " component" + (layout.Components == 1 ? "" : "s") +
    " of type " + vtkImageScalarTypeNameMacro(layout.Type);
}

void CheckLayout(const InputBlock& block, const std::string& name, const StateLayout& expected)
{
  const StateLayout layout = LayoutOf(FindTuples(block, name));
  if (layout.Type != expected.Type || layout.Components != expected.Components)
  {
    throw InputError(block.Name + ": the state array '" + name + "' has " + Text(layout) +
      ", but in other blocks it has " + Text(expected) + ".");
  }
}

/// Layouts as a message: numbers and names, each ended by a zero.
Bytes PackLayouts(const std::vector<StateLayout>& layouts)
{
  std::ostringstream text;
  for (const StateLayout& layout : layouts)
  {
    text << layout.Type << '\0' << layout.Components << '\0' << layout.ComponentNames.size()
         << '\0';
    for (const std::string& name : layout.ComponentNames)
    {
      text << name << '\0';
    }
  }
  const std::string packed = text.str();
  return { packed.begin(), packed.end() };
}

std::vector<StateLayout> UnpackLayouts(const Bytes& bytes, std::size_t count)
{
  std::istringstream text(std::string(bytes.begin(), bytes.end()));
  const auto take = [&text]
  {
    std::string item;
    std::getline(text, item, '\0');
    return item;
  };
  std::vector<StateLayout> layouts(count);
  for (StateLayout& layout : layouts)
  {
    layout.Type = std::stoi(take());
    layout.Components = std::stoi(take());
    layout.ComponentNames.resize(std::stoi(take()));
    std::generate(layout.ComponentNames.begin(), layout.ComponentNames.end(), take);
  }
  return layouts;
}

/// Collective: mine of the lowest rank that has any.
std::vector<StateLayout> AgreeOnLayouts(
  const std::vector<StateLayout>& mine, std::size_t count, Ranks& ranks)
{
  const int rank = mine.empty() ? ranks.Count() : ranks.Rank();
  const bool isFirst = -ranks.Max(-rank) == ranks.Rank();
  for (const Bytes& message : ranks.Gather(isFirst ? PackLayouts(mine) : Bytes()))
  {
    if (!message.empty())
    {
      return UnpackLayouts(message, count);
    }
  }
  return {};
}

/// Bits travel as bytes.
int CarrierType(int type)
{
  return type == VTK_BIT ? VTK_UNSIGNED_CHAR : type;
}

std::size_t TupleSize(const StateLayout& layout)
{
  return static_cast<std::size_t>(layout.Components) *
    vtkDataArray::GetDataTypeSize(CarrierType(layout.Type));
}

vtkSmartPointer<vtkDataArray> MakeArray(int type, int components, Index tuples)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

/// Fills an array with tuples of another, one by one, for arrays that are not plain memory.
void CopyValues(vtkDataArray* from, Index first, vtkDataArray* to)
{
  const bool isBits = from->GetDataType() == VTK_BIT || to->GetDataType() == VTK_BIT;
  const int components = to->GetNumberOfComponents();
  for (Index v = 0; v < to->GetNumberOfValues(); ++v)
  {
    if (isBits) // these have no variants
    {
      const Index tuple = v / components;
      const int c = static_cast<int>(v % components);
      to->SetComponent(tuple, c, from->GetComponent(first + tuple, c));
    }
    else // doubles do not hold all integers
    {
      to->SetVariantValue(v, from->GetVariantValue(first * components + v));
    }
  }
}

/// An array as plain memory, in its carrier's type: its own, or a copy of the cells of one block.
class PlainTuples
{
public:
  PlainTuples(vtkDataArray* array, Index first, Index count, std::size_t size)
  {
    if (array->HasStandardMemoryLayout() && array->GetDataType() != VTK_BIT)
    {
      this->Values =
        static_cast<const char*>(array->GetVoidPointer(first * array->GetNumberOfComponents()));
      return;
    }
    const auto plain =
      MakeArray(CarrierType(array->GetDataType()), array->GetNumberOfComponents(), count);
    CopyValues(array, first, plain);
    const char* values = static_cast<const char*>(plain->GetVoidPointer(0));
    this->Copy.assign(values, values + count * size);
  }
  const char* Data() const { return this->Values ? this->Values : this->Copy.data(); }

private:
  const char* Values = nullptr;
  Bytes Copy;
};

/// The cells of a block of this rank, or of a part of one that another sent, and the values of the arrays there.
struct StateSource
{
  IndexBox Box, Stored; ///< the cells; those of the arrays, of which they are some
  std::vector<const char*> Values;

  Index Place(const Index3& cell) const { return IndexInBox(this->Stored, cell); }
};

/// The values of all arrays in the cells of one level that this rank needs.
class LevelValues
{
public:
  LevelValues(const InputBlocks& input, const std::vector<std::string>& names,
    const std::vector<StateLayout>& layouts) :
    Input(input), Names(names), Layouts(layouts)
  {
  }

  /// Collective: sends the parts of blocks that other ranks need, and receives what this rank needs.
  void Exchange(const InputRoute& route, Ranks& ranks)
  {
    std::vector<Bytes> outgoing;
    WorkTogether(ranks,
      [&]
      {
        this->AddBlocks();
        for (const IndexBox& wanted : route.Wanted)
        {
          outgoing.push_back(this->Pack(wanted));
        }
      });
    this->Messages = ranks.Exchange(route.Peers, outgoing);
    for (const Bytes& message : this->Messages)
    {
      this->AddParts(message);
    }
  }

  /// What has the values of a cell, or null.
  const StateSource* Find(const Index3& cell)
  {
    if (this->Last < this->Sources.size() && this->Sources[this->Last].Box.Contains(cell))
    {
      return &this->Sources[this->Last];
    }
    const auto found = std::find_if(this->Sources.begin(), this->Sources.end(),
      [&cell](const StateSource& source) { return source.Box.Contains(cell); });
    this->Last = found - this->Sources.begin();
    return found == this->Sources.end() ? nullptr : &*found;
  }

private:
  void AddBlocks()
  {
    for (const InputBlock& block : this->Input.Blocks)
    {
      StateSource source;
      source.Box = block.Box;
      for (int a = 0; a < 3; ++a)
      {
        source.Stored.Lower[a] = block.Box.Lower[a] - block.Kept.Lower[a];
        source.Stored.Upper[a] = source.Stored.Lower[a] + block.Dimensions[a];
      }
      for (std::size_t a = 0; a < this->Names.size(); ++a)
      {
        this->Tuples.emplace_back(FindTuples(block, this->Names[a]), block.FirstCell,
          source.Stored.NumberOfCells(), TupleSize(this->Layouts[a]));
        source.Values.push_back(this->Tuples.back().Data());
      }
      this->Sources.push_back(std::move(source));
    }
  }

  /// Of each block the box that is wanted, then its values, one array after the other.
  Bytes Pack(const IndexBox& wanted) const
  {
    Bytes message;
    for (const StateSource& source : this->Sources)
    {
      const IndexBox box = Intersect(source.Box, wanted);
      if (box.NumberOfCells() == 0)
      {
        continue;
      }
      const char* first = reinterpret_cast<const char*>(&box);
      message.insert(message.end(), first, first + sizeof(box));
      for (std::size_t a = 0; a < this->Names.size(); ++a)
      {
        const std::size_t size = TupleSize(this->Layouts[a]);
        ForRows(box,
          [&](Index j, Index k)
          {
            const char* row = source.Values[a] + source.Place({ { box.Lower[0], j, k } }) * size;
            message.insert(message.end(), row, row + box.Size(0) * size);
          });
      }
    }
    return message;
  }

  void AddParts(const Bytes& message)
  {
    for (std::size_t at = 0; at < message.size();)
    {
      StateSource source;
      std::memcpy(&source.Box, message.data() + at, sizeof(source.Box));
      source.Stored = source.Box;
      at += sizeof(source.Box);
      for (const StateLayout& layout : this->Layouts)
      {
        source.Values.push_back(message.data() + at);
        at += source.Box.NumberOfCells() * TupleSize(layout);
      }
      this->Sources.push_back(std::move(source));
    }
  }

  const InputBlocks& Input;
  const std::vector<std::string>& Names;
  const std::vector<StateLayout>& Layouts;
  std::deque<PlainTuples> Tuples;
  std::vector<Bytes> Messages; // some sources point into them
  std::vector<StateSource> Sources;
  std::size_t Last = 0; // the source found last: elements lie near each other
};

/// Where the values of an element are.
struct StatePlace
{
  const StateSource* Source;
  Index Place;
};

/// The finest cell of the input around the middle of a cell of a level. values: of each level.
StatePlace FindPlace(
  const Index3& cell, int level, std::vector<std::unique_ptr<LevelValues>>& values)
{
  const int finest = static_cast<int>(values.size()) - 1;
  for (int l = finest; l >= 0; --l)
  {
    Index3 own = cell;
    for (Index& i : own)
    {
      i = l <= level ? i >> (level - l) : (2 * i + 1) << (l - level - 1);
    }
    if (const StateSource* source = values[l]->Find(own))
    {
      return { source, source->Place(own) };
    }
  }
  throw InputError("A cell of the input has no state."); // the levels fill a box
}

/// The array of the mesh: number: of the array among all.
vtkSmartPointer<vtkDataArray> MakeOutput(const StateLayout& layout, const std::string& name,
  std::size_t number, const std::vector<StatePlace>& places)
{
  const std::size_t size = TupleSize(layout);
  const Index count = static_cast<Index>(places.size());
  auto array = MakeArray(CarrierType(layout.Type), layout.Components, count);
  char* to = static_cast<char*>(array->GetVoidPointer(0));
  for (const StatePlace& place : places)
  {
    std::memcpy(to, place.Source->Values[number] + place.Place * size, size);
    to += size;
  }
  if (layout.Type == VTK_BIT)
  {
    const auto bits = MakeArray(VTK_BIT, layout.Components, count);
    CopyValues(array, 0, bits);
    array = bits;
  }
  array->SetName(name.c_str());
  for (std::size_t c = 0; c < layout.ComponentNames.size(); ++c)
  {
    if (!layout.ComponentNames[c].empty())
    {
      array->SetComponentName(static_cast<vtkIdType>(c), layout.ComponentNames[c].c_str());
    }
  }
  return array;
}

} // namespace

StateArrays::StateArrays(
  const InputLevels& input, const std::vector<std::string>& names, Ranks& ranks) :
  Input(input), Names(names)
{
  if (names.empty())
  {
    return;
  }
  std::vector<StateLayout> mine;
  WorkTogether(ranks,
    [&]
    {
      CheckNames(names);
      this->VisitArrays([&](const InputBlock& block, std::size_t a)
        { mine.push_back(LayoutOf(FindTuples(block, names[a]))); });
    });
  mine.resize(std::min(mine.size(), names.size())); // those of the first block
  this->Layouts = AgreeOnLayouts(mine, names.size(), ranks);
  WorkTogether(ranks,
    [&]
    {
      this->VisitArrays([&](const InputBlock& block, std::size_t a)
        { CheckLayout(block, names[a], this->Layouts[a]); });
    });
}

void StateArrays::VisitArrays(
  const std::function<void(const InputBlock&, std::size_t)>& visit) const
{
  for (const InputBlocks& level : this->Input.Levels)
  {
    for (const InputBlock& block : level.Blocks)
    {
      for (std::size_t a = 0; a < this->Names.size(); ++a)
      {
        visit(block, a);
      }
    }
  }
}

std::vector<vtkSmartPointer<vtkDataArray>> StateArrays::Carry(const Mesh& mesh,
  const CartesianGrid& grid, const FractionField& fractions, int level,
  const CellDivision& division, const std::vector<BlockPlace>& owners, Runtime& runtime) const
{
  std::vector<vtkSmartPointer<vtkDataArray>> arrays;
  if (this->Names.empty())
  {
    return arrays;
  }
  Ranks& ranks = runtime.Group();
  std::vector<std::unique_ptr<LevelValues>> values;
  for (int l = 0; l <= this->Input.Finest(); ++l)
  {
    const InputBlocks& input = this->Input.Levels[l];
    values.push_back(std::make_unique<LevelValues>(input, this->Names, this->Layouts));
    values.back()->Exchange(FindInputRoute(ChangeLevel(owners, l), input, ranks.Rank(),
                              Index(GhostLayers) << std::max(l - level, 0)),
      ranks);
  }
  WorkTogether(ranks,
    [&]
    {
      std::vector<StatePlace> places;
      for (Index cell : FindStateCells(mesh, grid, fractions, runtime))
      {
        const Index3 whole = division.ParentOf(CellInBox(grid.Local(), cell));
        places.push_back(FindPlace(whole, level, values));
      }
      for (std::size_t a = 0; a < this->Names.size(); ++a)
      {
        arrays.push_back(MakeOutput(this->Layouts[a], this->Names[a], a, places));
      }
    });
  return arrays;
}

} // namespace vfm
