#include "HostBlocks.h"

namespace vfm
{
namespace
{

BoundedCells MakeCells(int level, const double* bounds, const int* intervals)
{
  BoundedCells cells;
  cells.Level = level;
  for (int a = 0; a < 3; ++a)
  {
    cells.Lower[a] = bounds[a];
    cells.Upper[a] = bounds[3 + a];
    cells.Intervals[a] = intervals[a];
  }
  return cells;
}

std::vector<FieldName> NamesOf(const std::vector<HostArray>& arrays)
{
  std::vector<FieldName> names;
  for (const HostArray& array : arrays)
  {
    names.push_back({ array.Name, array.Components });
  }
  return names;
}

std::string TextOf(const std::vector<FieldName>& names)
{
  std::string text;
  for (const FieldName& field : names)
  {
    text += (text.empty() ? "'" : ", '") + field.Name + "'";
    text += field.Components == 1 ? "" : " (" + std::to_string(field.Components) + ")";
  }
  return text;
}

/// Returns a text for messages, with the numbers of components.
std::string TextOf(const FieldNames& names)
{
  return (names.HasMaterialIds ? "material ids" : "materials " + TextOf(names.Materials)) +
    (names.States.empty() ? ", no states" : ", states " + TextOf(names.States));
}

/// Returns a message if the names differ, otherwise an empty text.
std::string ReportDifference(const FieldNames& mine, const FieldNames& others)
{
  const bool same = mine.Materials == others.Materials && mine.States == others.States &&
    mine.HasMaterialIds == others.HasMaterialIds;
  return same ? ""
              : TextOf(mine) + "; others have " + TextOf(others) +
      ". All blocks of all ranks must have the same fields, in the same order.";
}

///@{ Packs names to send them, and unpacks them. Names end with a zero byte.
void Append(const std::vector<FieldName>& names, char kind, Bytes& bytes)
{
  for (const FieldName& field : names)
  {
    const std::string text = kind + std::to_string(field.Components) + ' ' + field.Name;
    bytes.insert(bytes.end(), text.c_str(), text.c_str() + text.size() + 1);
  }
}

constexpr char MaterialKind = 'm', StateKind = 's', IdsKind = 'i';

Bytes Pack(const FieldNames& names)
{
  Bytes bytes;
  Append(names.Materials, MaterialKind, bytes);
  Append(names.States, StateKind, bytes);
  if (names.HasMaterialIds)
  {
    Append({ { MaterialIdName, 1 } }, IdsKind, bytes);
  }
  return bytes;
}

FieldNames Unpack(const Bytes& bytes)
{
  FieldNames names;
  for (const char* at = bytes.data(); at != bytes.data() + bytes.size();)
  {
    const std::string text = at;
    const std::size_t space = text.find(' ');
    const FieldName field{ text.substr(space + 1), std::stoi(text.substr(1, space)) };
    names.HasMaterialIds = names.HasMaterialIds || text[0] == IdsKind;
    if (text[0] != IdsKind)
    {
      (text[0] == MaterialKind ? names.Materials : names.States).push_back(field);
    }
    at += text.size() + 1;
  }
  return names;
}
///@}

} // namespace

FieldNames HostBlocks::Block::Names() const
{
  return { NamesOf(this->Materials), NamesOf(this->States), this->MaterialIds != nullptr };
}

HostBlocks::Block& HostBlocks::Last()
{
  if (this->Blocks.empty())
  {
    this->Blocks.emplace_back();
  }
  return this->Blocks.back();
}

void HostBlocks::SetOnly(const double* bounds, const int* intervals)
{
  this->Blocks.resize(1);
  this->Blocks[0].Cells = MakeCells(0, bounds, intervals);
}

void HostBlocks::Begin(int level, const double* bounds, const int* intervals)
{
  this->Blocks.emplace_back();
  this->Blocks.back().Cells = MakeCells(level, bounds, intervals);
}

void HostBlocks::AddMaterial(const std::string& name, const double* fractions)
{
  this->Last().Materials.push_back(MakeHostArray(name, fractions));
}

void HostBlocks::AddState(const std::string& name, int components, const double* values)
{
  this->Last().States.push_back(MakeHostArray(name, values, components));
}

void HostBlocks::SetMaterialIds(const int* ids)
{
  this->Last().MaterialIds = ids;
}

void HostBlocks::ClearFields()
{
  for (Block& block : this->Blocks)
  {
    block = { block.Cells, {}, {}, nullptr };
  }
}

void HostBlocks::Block::Check(const FieldNames& first) const
{
  if (!this->Cells)
  {
    throw InputError("No box of cells is set (sculptor_set_box, sculptor_add_block).");
  }
  CheckBoundedCells(*this->Cells);
  if (this->Materials.empty() == !this->MaterialIds)
  {
    throw InputError(
      "Give either the volume fractions of materials (sculptor_add_material) or material ids "
      "(sculptor_set_material_ids).");
  }
  const std::string differs = ReportDifference(this->Names(), first);
  if (!differs.empty())
  {
    throw InputError("It has " + differs);
  }
}

void HostBlocks::Check() const
{
  for (std::size_t b = 0; b < this->Blocks.size(); ++b)
  {
    NameBlock(b, this->Blocks.size(), [&] { this->Blocks[b].Check(this->Blocks[0].Names()); });
  }
}

FieldNames HostBlocks::AgreeOnNames(Ranks& ranks) const
{
  const bool hasBlocks = !this->Blocks.empty();
  const double first = -ranks.Max(-(hasBlocks ? ranks.Rank() : ranks.Count()));
  if (first == ranks.Count())
  {
    throw InputError("No box of cells is set on any rank (sculptor_set_box, sculptor_add_block).");
  }
  const int owner = static_cast<int>(first);
  const Bytes mine = owner == ranks.Rank() ? Pack(this->Blocks[0].Names()) : Bytes();
  const FieldNames names = Unpack(ranks.Gather(mine)[owner]);
  const std::string differs =
    hasBlocks ? ReportDifference(this->Blocks[0].Names(), names) : std::string();
  if (!differs.empty())
  {
    throw InputError(
      "The ranks do not agree: rank " + std::to_string(ranks.Rank()) + " has " + differs);
  }
  return names;
}

HostGrid HostBlocks::Place(Ranks& ranks) const
{
  std::vector<BoundedCells> cells;
  for (const Block& block : this->Blocks)
  {
    cells.push_back(*block.Cells);
  }
  HostGrid grid = PlaceHostBoxes(cells, ranks);
  for (std::size_t b = 0; b < this->Blocks.size(); ++b)
  {
    const Block& block = this->Blocks[b];
    std::vector<HostArray>& arrays = grid.Boxes[b].Arrays;
    arrays = block.Materials;
    arrays.insert(arrays.end(), block.States.begin(), block.States.end());
    if (block.MaterialIds)
    {
      arrays.push_back(MakeHostArray(MaterialIdName, block.MaterialIds));
    }
  }
  return grid;
}

} // namespace vfm
