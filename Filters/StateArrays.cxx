#include "StateArrays.h"

#include "Agreement.h"
#include "Buffer.h"
#include "InputArrays.h"
#include "InputRoute.h"
#include "MakePartition.h"
#include "StateCells.h"

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
        "' has the name of an array that the mesh itself may have: rename it (filter Calculator), "
        "or leave it out.");
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
  const StateLayout layout = LayoutOf(FindCellArray(block, name));
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

/// Copies tuples of an array, in its carrier's type, to plain memory; size: bytes of a tuple.
void CopyTuples(vtkDataArray* array, Index first, Index count, std::size_t size, char* to)
{
  const int type = array->GetDataType(), components = array->GetNumberOfComponents();
  if (array->HasStandardMemoryLayout() && type != VTK_BIT)
  {
    std::memcpy(to, array->GetVoidPointer(first * components), count * size);
    return;
  }
  const auto plain = MakeArray(CarrierType(type), components, count);
  CopyValues(array, first, plain);
  std::memcpy(to, plain->GetVoidPointer(0), count * size);
}

/// Calls visit(first cell) for the rows along x of a box.
template <class Visit>
void VisitRows(const IndexBox& box, const Visit& visit)
{
  for (Index k = box.Lower[2]; box.NumberOfCells() > 0 && k < box.Upper[2]; ++k)
  {
    for (Index j = box.Lower[1]; j < box.Upper[1]; ++j)
    {
      visit(Index3{ { box.Lower[0], j, k } });
    }
  }
}

/// The values of an array in the cells of a box, x fastest, as plain memory.
struct BoxValues
{
  IndexBox Box;
  std::size_t TupleSize;
  char* Values;

  char* At(const Index3& cell) const
  {
    return this->Values + PlaceInBox(this->Box, cell) * this->TupleSize;
  }
  /// The cells that the block has too.
  void CopyFrom(const InputBlock& block, const std::string& name) const
  {
    vtkDataArray* array = FindCellArray(block, name);
    const IndexBox common = Intersect(block.Box, this->Box);
    VisitRows(common,
      [&](const Index3& first) {
        CopyTuples(array, block.CellId(first), common.Size(0), this->TupleSize, this->At(first));
      });
  }
  /// All cells of a box within this one.
  void CopyFrom(const BoxValues& part) const
  {
    VisitRows(part.Box,
      [&](const Index3& first)
      { std::memcpy(this->At(first), part.At(first), part.Box.Size(0) * this->TupleSize); });
  }
};

/// Sends the parts of blocks that other ranks need, and receives what this rank needs.
class StateExchange
{
public:
  StateExchange(const InputBlocks& input, const std::vector<std::string>& names,
    const std::vector<StateLayout>& layouts) :
    Input(input), Names(names), Layouts(layouts)
  {
  }

  /// Collective. Result: of each array the parts from other ranks.
  std::vector<std::vector<BoxValues>> Run(const InputRoute& route, Ranks& ranks)
  {
    std::vector<Bytes> outgoing;
    WorkTogether(ranks,
      [&]
      {
        for (const IndexBox& wanted : route.Wanted)
        {
          outgoing.push_back(this->Pack(wanted));
        }
      });
    this->Messages = ranks.Exchange(route.Peers, outgoing);
    return this->Unpack();
  }

private:
  /// Of each block the box that is wanted, then its values, one array after the other.
  Bytes Pack(const IndexBox& wanted) const
  {
    Bytes message;
    for (const InputBlock& block : this->Input.Blocks)
    {
      const IndexBox box = Intersect(block.Box, wanted);
      if (box.NumberOfCells() == 0)
      {
        continue;
      }
      const char* first = reinterpret_cast<const char*>(&box);
      message.insert(message.end(), first, first + sizeof(box));
      for (std::size_t a = 0; a < this->Names.size(); ++a)
      {
        const std::size_t size = TupleSize(this->Layouts[a]), at = message.size();
        message.resize(at + box.NumberOfCells() * size);
        BoxValues{ box, size, message.data() + at }.CopyFrom(block, this->Names[a]);
      }
    }
    return message;
  }

  std::vector<std::vector<BoxValues>> Unpack()
  {
    std::vector<std::vector<BoxValues>> parts(this->Layouts.size());
    for (Bytes& message : this->Messages)
    {
      for (std::size_t at = 0; at < message.size();)
      {
        IndexBox box;
        std::memcpy(&box, message.data() + at, sizeof(box));
        at += sizeof(box);
        for (std::size_t a = 0; a < parts.size(); ++a)
        {
          parts[a].push_back({ box, TupleSize(this->Layouts[a]), message.data() + at });
          at += box.NumberOfCells() * parts[a].back().TupleSize;
        }
      }
    }
    return parts;
  }

  const InputBlocks& Input;
  const std::vector<std::string>& Names;
  const std::vector<StateLayout>& Layouts;
  std::vector<Bytes> Messages; // the parts point into them
};

/// The array of the mesh: of each element the values at its cell's place.
vtkSmartPointer<vtkDataArray> MakeOutput(const StateLayout& layout, const std::string& name,
  const char* values, const std::vector<Index>& cells)
{
  const std::size_t size = TupleSize(layout);
  const Index count = static_cast<Index>(cells.size());
  auto array = MakeArray(CarrierType(layout.Type), layout.Components, count);
  char* to = static_cast<char*>(array->GetVoidPointer(0));
  for (Index cell : cells)
  {
    std::memcpy(to, values + cell * size, size);
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

/// From a cell's place in a box of a grid that was refined to the place of the cell of the input around it.
Index PlaceOfParent(Index place, const IndexBox& refined, int refinement, const IndexBox& box)
{
  const Index nx = refined.Size(0), ny = refined.Size(1);
  const Index3 cell{ { (place % nx + refined.Lower[0]) >> refinement,
    (place / nx % ny + refined.Lower[1]) >> refinement,
    (place / (nx * ny) + refined.Lower[2]) >> refinement } };
  return PlaceInBox(box, cell);
}

} // namespace

StateArrays::StateArrays(
  const InputBlocks& input, const std::vector<std::string>& names, Ranks& ranks) :
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
      for (const InputBlock& block : input.Blocks)
      {
        for (const std::string& name : names)
        {
          mine.push_back(LayoutOf(FindCellArray(block, name)));
        }
      }
    });
  mine.resize(std::min(mine.size(), names.size())); // those of the first block
  this->Layouts = AgreeOnLayouts(mine, names.size(), ranks);
  WorkTogether(ranks,
    [&]
    {
      for (const InputBlock& block : input.Blocks)
      {
        for (std::size_t a = 0; a < names.size(); ++a)
        {
          CheckLayout(block, names[a], this->Layouts[a]);
        }
      }
    });
}

std::vector<vtkSmartPointer<vtkDataArray>> StateArrays::Carry(const Mesh& mesh,
  const CartesianGrid& grid, const FractionField& fractions, int refinement,
  const std::vector<BlockPlace>& owners, Runtime& runtime) const
{
  std::vector<vtkSmartPointer<vtkDataArray>> arrays;
  if (this->Names.empty())
  {
    return arrays;
  }
  Ranks& ranks = runtime.Group();
  StateExchange exchange(this->Input, this->Names, this->Layouts);
  const std::vector<std::vector<BoxValues>> parts =
    exchange.Run(FindInputRoute(owners, this->Input, ranks.Rank()), ranks);
  WorkTogether(ranks,
    [&]
    {
      const IndexBox box = Grow(BoxOfRank(owners, ranks.Rank()), GhostLevels, this->Input.Global());
      std::vector<Index> cells = FindStateCells(mesh, grid, fractions, runtime);
      for (Index& cell : cells)
      {
        cell = PlaceOfParent(cell, grid.Local(), refinement, box);
      }
      for (std::size_t a = 0; a < this->Names.size(); ++a)
      {
        const std::size_t size = TupleSize(this->Layouts[a]);
        Buffer<char> memory(box.NumberOfCells() * size);
        const BoxValues values{ box, size, memory.data() };
        for (const InputBlock& block : this->Input.Blocks)
        {
          values.CopyFrom(block, this->Names[a]);
        }
        for (const BoxValues& part : parts[a])
        {
          values.CopyFrom(part);
        }
        arrays.push_back(MakeOutput(this->Layouts[a], this->Names[a], memory.data(), cells));
      }
    });
  return arrays;
}

} // namespace vfm
