#include "GatherMesh.h"

#include "PackMesh.h"
#include "Ranks/Agreement.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace vfm
{
namespace
{

using MeshPointer = vtkSmartPointer<vtkUnstructuredGrid>;

/// An item (a point or a cell) of the whole mesh: where it comes from.
struct Item
{
  vtkIdType Id; ///< global
  std::size_t Piece;
  vtkIdType Place; ///< in the piece
};

/// All items of the pieces in the order of their ids, each id once.
template <class GetData>
std::vector<Item> SortItems(const std::vector<MeshPointer>& pieces, const GetData& getData)
{
  std::vector<Item> items;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    auto ids = vtkIdTypeArray::SafeDownCast(getData(pieces[p])->GetGlobalIds());
    for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
    {
      items.push_back({ ids->GetValue(i), p, i });
    }
  }
  std::stable_sort(
    items.begin(), items.end(), [](const Item& a, const Item& b) { return a.Id < b.Id; });
  items.erase(std::unique(items.begin(), items.end(),
                [](const Item& a, const Item& b) { return a.Id == b.Id; }),
    items.end());
  return items;
}

/// Whether the items of a mesh are in the order of their ids, each once.
bool IsInOrder(vtkDataArray* ids)
{
  for (vtkIdType i = 1; ids && i < ids->GetNumberOfTuples(); ++i)
  {
    if (ids->GetComponent(i - 1, 0) >= ids->GetComponent(i, 0))
    {
      return false;
    }
  }
  return true;
}

/// getArray: of a piece.
template <class GetArray>
vtkSmartPointer<vtkDataArray> MergeArray(
  const std::vector<MeshPointer>& pieces, const std::vector<Item>& items, const GetArray& getArray)
{
  vtkDataArray* first = getArray(pieces[0]);
  vtkSmartPointer<vtkDataArray> merged;
  merged.TakeReference(first->NewInstance());
  merged->SetName(first->GetName());
  merged->SetNumberOfComponents(first->GetNumberOfComponents());
  merged->SetNumberOfTuples(static_cast<vtkIdType>(items.size()));
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    merged->SetTuple(static_cast<vtkIdType>(i), items[i].Place, getArray(pieces[items[i].Piece]));
  }
  return merged;
}

template <class GetData>
void MergeArrays(const std::vector<MeshPointer>& pieces, const std::vector<Item>& items,
  const GetData& getData, vtkDataSetAttributes* merged)
{
  vtkDataSetAttributes* first = getData(pieces[0]);
  for (int a = 0; a < first->GetNumberOfArrays(); ++a)
  {
    const std::string name = first->GetArrayName(a);
    const int place = merged->AddArray(MergeArray(pieces, items,
      [&](vtkUnstructuredGrid* piece) { return getData(piece)->GetArray(name.c_str()); }));
    const int attribute = first->IsArrayAnAttribute(a);
    if (attribute >= 0)
    {
      merged->SetActiveAttribute(place, attribute);
    }
  }
}

void MergeCells(const std::vector<MeshPointer>& pieces, const std::vector<Item>& points,
  const std::vector<Item>& cells, vtkUnstructuredGrid* merged)
{
  const vtkIdType corners = pieces[0]->GetCells()->GetCellSize(0);
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(corners * static_cast<vtkIdType>(cells.size()));
  vtkIdType next = 0;
  for (const Item& cell : cells)
  {
    vtkUnstructuredGrid* piece = pieces[cell.Piece];
    auto ids = vtkIdTypeArray::SafeDownCast(piece->GetPointData()->GetGlobalIds());
    vtkIdType size = 0;
    const vtkIdType* local = nullptr;
    piece->GetCells()->GetCellAtId(cell.Place, size, local);
    for (vtkIdType c = 0; c < size; ++c)
    {
      const auto point = std::lower_bound(points.begin(), points.end(), ids->GetValue(local[c]),
        [](const Item& item, vtkIdType id) { return item.Id < id; });
      connectivity->SetValue(next++, point - points.begin());
    }
  }
  vtkNew<vtkCellArray> array;
  array->SetData(corners, connectivity);
  merged->SetCells(pieces[0]->GetCellType(0), array);
}

/// pieces: at least one, all with cells.
MeshPointer MergePieces(const std::vector<MeshPointer>& pieces)
{
  const auto pointData = [](vtkUnstructuredGrid* piece) { return piece->GetPointData(); };
  const auto cellData = [](vtkUnstructuredGrid* piece) { return piece->GetCellData(); };
  const std::vector<Item> points = SortItems(pieces, pointData);
  const std::vector<Item> cells = SortItems(pieces, cellData);
  auto merged = MeshPointer::New();
  vtkNew<vtkPoints> coordinates;
  coordinates->SetData(MergeArray(
    pieces, points, [](vtkUnstructuredGrid* piece) { return piece->GetPoints()->GetData(); }));
  merged->SetPoints(coordinates);
  MergeCells(pieces, points, cells, merged);
  MergeArrays(pieces, points, pointData, merged->GetPointData());
  MergeArrays(pieces, cells, cellData, merged->GetCellData());
  merged->GetFieldData()->ShallowCopy(pieces[0]->GetFieldData());
  return merged;
}

} // namespace

MeshPointer GatherMesh(vtkUnstructuredGrid* mesh, Ranks& ranks)
{
  if (ranks.Count() == 1 && IsInOrder(mesh->GetPointData()->GetGlobalIds()) &&
    IsInOrder(mesh->GetCellData()->GetGlobalIds()))
  {
    return mesh;
  }
  std::vector<int> peers(ranks.Rank() == 0 ? ranks.Count() - 1 : 1, 0);
  std::vector<Bytes> outgoing(peers.size());
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() == 0)
      {
        std::iota(peers.begin(), peers.end(), 1);
      }
      else if (mesh->GetNumberOfCells() > 0)
      {
        outgoing[0] = PackGrid(mesh);
      }
    });
  std::vector<Bytes> incoming = ranks.Exchange(peers, outgoing);
  MeshPointer merged;
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() > 0)
      {
        return;
      }
      std::vector<MeshPointer> pieces;
      if (mesh->GetNumberOfCells() > 0)
      {
        pieces.emplace_back(mesh);
      }
      for (Bytes& bytes : incoming)
      {
        if (!bytes.empty())
        {
          pieces.push_back(UnpackGrid(bytes));
          bytes = Bytes();
        }
      }
      merged = pieces.empty() ? MeshPointer(mesh) : MergePieces(pieces);
      vtkInformation* information = mesh->GetInformation();
      if (information->Has(vtkDataObject::DATA_TIME_STEP()))
      {
        merged->GetInformation()->Set(
          vtkDataObject::DATA_TIME_STEP(), information->Get(vtkDataObject::DATA_TIME_STEP()));
      }
    });
  return merged;
}

} // namespace vfm
