/**
 * The C interface: handles, null pointers and exceptions end here.
 */
#include "Sculptor.h"

#include "Base/Runtime.h"
#include "SculptorSession.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkUnstructuredGrid.h"

#include <limits>
#include <memory>
#include <mutex>

namespace
{

using vfm::Index;
using vfm::InputError;
using vfm::SculptorError;
using vfm::SculptorSession;

/// All sculptors of the process.
class SessionTable
{
public:
  int Add()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Sessions.emplace(++this->Last, std::make_shared<SculptorSession>());
    return this->Last;
  }
  std::shared_ptr<SculptorSession> Find(int handle)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto found = this->Sessions.find(handle);
    return found == this->Sessions.end() ? nullptr : found->second;
  }
  void Remove(int handle)
  {
    std::shared_ptr<SculptorSession> last; // ends after the lock
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto found = this->Sessions.find(handle);
    last = std::move(found->second);
    this->Sessions.erase(found);
  }

private:
  std::mutex Mutex;
  std::map<int, std::shared_ptr<SculptorSession>> Sessions;
  int Last = 0;
};

SessionTable& Table()
{
  static SessionTable* table = new SessionTable; // outlives what hosts do in their destructors
  return *table;
}

thread_local std::string ErrorWithoutSession;

/// Does the work and makes a code and a text of what it throws.
template <class Work>
int Catch(std::string& text, const Work& work)
{
  try
  {
    work();
    return SCULPTOR_OK;
  }
  catch (const SculptorError& error)
  {
    text = error.what();
    return error.Code;
  }
  catch (const InputError& error)
  {
    text = error.what();
    return SCULPTOR_ERROR_ARGUMENT;
  }
  catch (const std::bad_alloc&)
  {
    text = "Not enough memory.";
    return SCULPTOR_ERROR_MEMORY;
  }
  catch (const std::exception& error)
  {
    text = error.what();
  }
  catch (...)
  {
    text = "An unknown failure.";
  }
  return SCULPTOR_ERROR_INTERNAL;
}

template <class Work>
int With(int handle, const Work& work)
{
  const std::shared_ptr<SculptorSession> session = Table().Find(handle);
  if (!session)
  {
    ErrorWithoutSession = "There is no sculptor " + std::to_string(handle) +
      ": it was never created, or has been deleted.";
    return SCULPTOR_ERROR_HANDLE;
  }
  return Catch(session->ErrorText, [&] { work(*session); });
}

template <class T>
T* NotNull(T* pointer, const char* name)
{
  if (!pointer)
  {
    throw InputError(std::string(name) + " is a null pointer.");
  }
  return pointer;
}

int ToInt(Index count)
{
  if (count > std::numeric_limits<int>::max())
  {
    throw SculptorError(SCULPTOR_ERROR_SIZE,
      std::to_string(count) + " is more than an int counts; use the calls sculptor_get_*.");
  }
  return static_cast<int>(count);
}

constexpr int HexCorners = 8, TetCorners = 4;

int CornersOf(vtkUnstructuredGrid* mesh)
{
  return mesh->GetNumberOfCells() > 0 ? static_cast<int>(mesh->GetCells()->GetMaxCellSize()) : 0;
}

const Index* ConnectivityOf(vtkUnstructuredGrid* mesh)
{
  return static_cast<const Index*>(mesh->GetCells()->GetConnectivityArray()->GetVoidPointer(0));
}

const double* CoordinatesOf(vtkUnstructuredGrid* mesh)
{
  return mesh->GetNumberOfPoints() > 0
    ? static_cast<const double*>(mesh->GetPoints()->GetVoidPointer(0))
    : nullptr;
}

int NotNegative(int value, const char* name)
{
  if (value < 0)
  {
    throw InputError(
      std::string(name) + " is " + std::to_string(value) + "; it must be 0 or more.");
  }
  return value;
}

/// Nodes, hexahedra and tetrahedra.
void SetTotals(
  Index points, Index elements, int corners, int* numNodes, int* numHexes, int* numTets)
{
  *NotNull(numNodes, "num_nodes") = ToInt(points);
  *NotNull(numHexes, "num_hexes") = corners == HexCorners ? ToInt(elements) : 0;
  *NotNull(numTets, "num_tets") = corners == TetCorners ? ToInt(elements) : 0;
}

/// The whole mesh where part is null. Elements of another kind than corners: nothing but the nodes.
void CopyMesh(SculptorSession& session, const vfm::FragmentParts::Part* part, int corners,
  double* coordinates, int* connectivity)
{
  vtkUnstructuredGrid* mesh = session.GetMesh();
  const Index points = part ? static_cast<Index>(part->Points.size()) : mesh->GetNumberOfPoints();
  const Index all = part ? static_cast<Index>(part->Elements.size()) : mesh->GetNumberOfCells();
  const Index elements = CornersOf(mesh) == corners ? all : 0;
  const double* from = CoordinatesOf(mesh);
  double* to = points > 0 ? NotNull(coordinates, "coordinates") : nullptr;
  for (Index p = 0; p < points; ++p)
  {
    std::copy_n(from + 3 * (part ? part->Points[p] : p), 3, to + 3 * p);
  }
  const Index* corner = elements > 0 ? ConnectivityOf(mesh) : nullptr;
  int* node = elements > 0 ? NotNull(connectivity, "connectivity") : nullptr;
  const int base = session.GetIndexBase();
  for (Index e = 0; e < elements; ++e)
  {
    const Index first = corners * (part ? part->Elements[e] : e);
    for (int c = 0; c < corners; ++c)
    {
      Index point = corner[first + c];
      if (part)
      {
        point =
          std::lower_bound(part->Points.begin(), part->Points.end(), point) - part->Points.begin();
      }
      *node++ = ToInt(point + base);
    }
  }
}

int GetFree(int sculptor, int corners, double* coordinates, int* connectivity)
{
  return With(sculptor,
    [=](SculptorSession& session)
    { CopyMesh(session, nullptr, corners, coordinates, connectivity); });
}

vfm::FragmentParts::Part GetPart(SculptorSession& session, int fragment)
{
  session.GetMesh();
  if (fragment < 1 || fragment > session.GetNumberOfFragments())
  {
    throw InputError("There is no fragment " + std::to_string(fragment) +
      "; they are numbered 1 to " + std::to_string(session.GetNumberOfFragments()) + ".");
  }
  return session.GetFragmentParts().Get(fragment);
}

int GetFragment(int sculptor, int fragment, int corners, double* coordinates, int* connectivity)
{
  return With(sculptor,
    [=](SculptorSession& session)
    {
      const vfm::FragmentParts::Part part = GetPart(session, fragment);
      CopyMesh(session, &part, corners, coordinates, connectivity);
    });
}

} // namespace

int c_create_sculptor(int* sculptor)
{
  return Catch(ErrorWithoutSession, [=] { *NotNull(sculptor, "sculptor") = Table().Add(); });
}

int c_delete_sculptor(int sculptor)
{
  return With(sculptor, [=](SculptorSession&) { Table().Remove(sculptor); });
}

int c_mesh_from_data(int sculptor, const double* bounding_box, int xint, int yint, int zint,
  const double* vfrac, const int* neighbours, int auto_refine, int stair_step, int smooth,
  int tet_mesh)
{
  return With(sculptor,
    [=](SculptorSession& session)
    {
      session.MakeMesh(tet_mesh != 0,
        [&]
        {
          const int intervals[3] = { xint, yint, zint };
          session.SetBox(NotNull(bounding_box, "bounding_box"), intervals);
          session.SetNeighbours(NotNull(neighbours, "neighbours"));
          session.ClearFields();
          session.AddMaterial("material", NotNull(vfrac, "vfrac"));
          session.SetOption("Refinement", "Automatic");
          session.SetOption(
            "MaximumLevel", std::to_string(NotNegative(auto_refine, "auto_refine")));
          session.SetOption("StairStep", stair_step ? "1" : "0");
          session.SetOption("Smoothing", std::to_string(smooth));
        });
    });
}

int c_get_free_totals(int sculptor, int* num_nodes, int* num_hexes, int* num_tets)
{
  return With(sculptor,
    [=](SculptorSession& session)
    {
      vtkUnstructuredGrid* mesh = session.GetMesh();
      SetTotals(mesh->GetNumberOfPoints(), mesh->GetNumberOfCells(), CornersOf(mesh), num_nodes,
        num_hexes, num_tets);
    });
}

int c_get_free_hexes(int sculptor, double* coordinates, int* connectivity)
{
  return GetFree(sculptor, HexCorners, coordinates, connectivity);
}

int c_get_free_tets(int sculptor, double* coordinates, int* connectivity)
{
  return GetFree(sculptor, TetCorners, coordinates, connectivity);
}

int c_get_num_fragments(int sculptor, int* num_fragments)
{
  return With(sculptor,
    [=](SculptorSession& session)
    {
      session.GetMesh();
      *NotNull(num_fragments, "num_fragments") = session.GetNumberOfFragments();
    });
}

int c_get_fragment_totals(int sculptor, int fragment, int* num_nodes, int* num_hexes, int* num_tets)
{
  return With(sculptor,
    [=](SculptorSession& session)
    {
      const vfm::FragmentParts::Part part = GetPart(session, fragment);
      SetTotals(static_cast<Index>(part.Points.size()), static_cast<Index>(part.Elements.size()),
        CornersOf(session.GetMesh()), num_nodes, num_hexes, num_tets);
    });
}

int c_get_fragment_hexes(int sculptor, int fragment, double* coordinates, int* connectivity)
{
  return GetFragment(sculptor, fragment, HexCorners, coordinates, connectivity);
}

int c_get_fragment_tets(int sculptor, int fragment, double* coordinates, int* connectivity)
{
  return GetFragment(sculptor, fragment, TetCorners, coordinates, connectivity);
}

int sculptor_set_communicator(int sculptor, int communicator)
{
  return With(sculptor, [=](SculptorSession& session) { session.SetCommunicator(communicator); });
}

int sculptor_set_option(int sculptor, const char* name, const char* value)
{
  return With(sculptor,
    [=](SculptorSession& session)
    { session.SetOption(NotNull(name, "name"), NotNull(value, "value")); });
}

int sculptor_set_box(int sculptor, const double* bounding_box, const int* intervals)
{
  return With(sculptor,
    [=](SculptorSession& session)
    { session.SetBox(NotNull(bounding_box, "bounding_box"), NotNull(intervals, "intervals")); });
}

int sculptor_set_neighbours(int sculptor, const int* neighbours)
{
  return With(sculptor, [=](SculptorSession& session) { session.SetNeighbours(neighbours); });
}

int sculptor_add_material(int sculptor, const char* name, const double* vfrac)
{
  return With(sculptor,
    [=](SculptorSession& session)
    { session.AddMaterial(NotNull(name, "name"), NotNull(vfrac, "vfrac")); });
}

int sculptor_set_material_ids(int sculptor, const int* ids)
{
  return With(
    sculptor, [=](SculptorSession& session) { session.SetMaterialIds(NotNull(ids, "ids")); });
}

int sculptor_add_state(int sculptor, const char* name, int components, const double* values)
{
  return With(sculptor,
    [=](SculptorSession& session)
    { session.AddState(NotNull(name, "name"), components, NotNull(values, "values")); });
}

int sculptor_clear_fields(int sculptor)
{
  return With(sculptor, [](SculptorSession& session) { session.ClearFields(); });
}

int sculptor_make_mesh(int sculptor, int tet_mesh)
{
  return With(sculptor, [=](SculptorSession& session) { session.MakeMesh(tet_mesh != 0, [] {}); });
}

int sculptor_get_counts(int sculptor, int64_t* points, int64_t* elements, int* corners)
{
  return With(sculptor,
    [=](SculptorSession& session)
    {
      vtkUnstructuredGrid* mesh = session.GetMesh();
      *NotNull(points, "points") = mesh->GetNumberOfPoints();
      *NotNull(elements, "elements") = mesh->GetNumberOfCells();
      *NotNull(corners, "corners") = CornersOf(mesh);
    });
}

int sculptor_get_points(int sculptor, const double** coordinates)
{
  return With(sculptor,
    [=](SculptorSession& session)
    { *NotNull(coordinates, "coordinates") = CoordinatesOf(session.GetMesh()); });
}

int sculptor_get_elements(int sculptor, const int64_t** connectivity)
{
  return With(sculptor,
    [=](SculptorSession& session)
    { *NotNull(connectivity, "connectivity") = ConnectivityOf(session.GetMesh()); });
}

int sculptor_get_point_ids(int sculptor, const int64_t** ids)
{
  return With(sculptor,
    [=](SculptorSession& session)
    { *NotNull(ids, "ids") = session.GetPointValues<int64_t>("GlobalPointIds"); });
}

int sculptor_get_element_ids(int sculptor, const int64_t** ids)
{
  return With(sculptor,
    [=](SculptorSession& session)
    { *NotNull(ids, "ids") = session.GetCellValues<int64_t>("GlobalCellIds"); });
}

int sculptor_get_materials(int sculptor, const int** ids)
{
  return With(sculptor,
    [=](SculptorSession& session)
    { *NotNull(ids, "ids") = session.GetCellValues<int>("MaterialId"); });
}

int sculptor_get_fragments(int sculptor, const int** ids)
{
  return With(sculptor,
    [=](SculptorSession& session)
    { *NotNull(ids, "ids") = session.GetCellValues<int>("FragmentId"); });
}

int sculptor_get_state(int sculptor, const char* name, int* components, const double** values)
{
  return With(sculptor,
    [=](SculptorSession& session)
    {
      vtkDoubleArray* state = session.GetState(NotNull(name, "name"));
      *NotNull(components, "components") = state->GetNumberOfComponents();
      *NotNull(values, "values") = state->GetPointer(0);
    });
}

int sculptor_get_number(int sculptor, const char* name, int index, double* value)
{
  return With(sculptor,
    [=](SculptorSession& session)
    { *NotNull(value, "value") = session.GetNumber(NotNull(name, "name"), index); });
}

int sculptor_write(int sculptor, const char* path)
{
  return With(sculptor, [=](SculptorSession& session) { session.Write(path); });
}

const char* sculptor_error_text(int sculptor)
{
  const std::shared_ptr<SculptorSession> session = Table().Find(sculptor);
  return session ? session->ErrorText.c_str() : ErrorWithoutSession.c_str();
}

const char* sculptor_warning_text(int sculptor)
{
  const std::shared_ptr<SculptorSession> session = Table().Find(sculptor);
  return session ? session->GetWarningText().c_str() : "";
}
