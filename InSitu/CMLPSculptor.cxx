/**
 * Implements the calls of CMLPSculptor.c.h on the sculptors of Sculptor.h.
 */
#include "CMLPSculptor.c.h"

#include "SculptorCalls.h"

#include <limits>

namespace
{

using vfm::Index;
using vfm::InputError;
using vfm::NotNull;
using vfm::SculptorSession;
using vfm::WithSession;

constexpr int HexCorners = 8, TetCorners = 4;

int ToInt(Index count)
{
  if (count > std::numeric_limits<int>::max())
  {
    throw vfm::InputError(vfm::ErrorCode::TooLarge,
      std::to_string(count) + " exceeds the range of int; use the calls sculptor_get_*.");
  }
  return static_cast<int>(count);
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

/// Sets the numbers of nodes, hexahedra and tetrahedra. If it throws, it sets none of them.
void SetTotals(
  Index points, Index elements, int corners, int* numNodes, int* numHexes, int* numTets)
{
  NotNull(numNodes, "num_nodes");
  NotNull(numHexes, "num_hexes");
  NotNull(numTets, "num_tets");
  const int nodes = ToInt(points), count = ToInt(elements);
  *numNodes = nodes;
  *numHexes = corners == HexCorners ? count : 0;
  *numTets = corners == TetCorners ? count : 0;
}

/// Copies the nodes and elements of the whole mesh, or of `part` unless it is null. If the elements
/// do not have the given number of corners, copies only the nodes.
void CopyMesh(SculptorSession& session, const vfm::FragmentParts::Part* part, int corners,
  double* coords, int* elements)
{
  const vfm::Mesh& mesh = session.GetMesh();
  const Index points = part ? part->Points.size() : mesh.PointIds.size();
  const Index all = part ? part->Elements.size() : mesh.ElementIds.size();
  const Index count = mesh.Corners == corners ? all : 0;
  const double* from = mesh.Points.data();
  double* to = points > 0 ? NotNull(coords, "coords") : nullptr;
  for (Index p = 0; p < points; ++p)
  {
    std::copy_n(from + 3 * (part ? part->Points[p] : p), 3, to + 3 * p);
  }
  const Index* corner = mesh.Elements.data();
  int* node = count > 0 ? NotNull(elements, corners == HexCorners ? "hexes" : "tets") : nullptr;
  const int base = session.GetIndexBase();
  for (Index e = 0; e < count; ++e)
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

int GetFree(int handle, int corners, double* coords, int* elements)
{
  return WithSession(handle,
    [=](SculptorSession& session) { CopyMesh(session, nullptr, corners, coords, elements); });
}

vfm::FragmentParts::Part GetPart(SculptorSession& session, int fragment)
{
  session.GetMesh();
  if (fragment < 1 || fragment > session.GetNumberOfFragments())
  {
    throw InputError("There is no fragment " + std::to_string(fragment) +
      "; fragments are numbered 1 to " + std::to_string(session.GetNumberOfFragments()) + ".");
  }
  return session.GetFragmentParts().Get(fragment);
}

int GetFragment(int handle, int fragment, int corners, double* coords, int* elements)
{
  return WithSession(handle,
    [=](SculptorSession& session)
    {
      const vfm::FragmentParts::Part part = GetPart(session, fragment);
      CopyMesh(session, &part, corners, coords, elements);
    });
}

} // namespace

int c_create_cml_psculptor(void)
{
  int handle = 0;
  sculptor_create(&handle);
  return handle;
}

void c_delete_cml_psculptor(int handle)
{
  sculptor_delete(handle);
}

int c_mesh_from_data(int handle, double xmin, double ymin, double zmin, double xmax, double ymax,
  double zmax, int xint, int yint, int zint, double* vfrac, int neighbor_plus_i,
  int neighbor_negative_i, int neighbor_plus_j, int neighbor_negative_j, int neighbor_plus_k,
  int neighbor_negative_k, int auto_refine, int stair_step, int smooth, int tet_mesh)
{
  const double bounds[6] = { xmin, ymin, zmin, xmax, ymax, zmax };
  const int intervals[3] = { xint, yint, zint };
  const int neighbours[6] = { neighbor_negative_i, neighbor_plus_i, neighbor_negative_j,
    neighbor_plus_j, neighbor_negative_k, neighbor_plus_k };
  return WithSession(handle,
    [&](SculptorSession& session)
    {
      const auto prepare = [&]
      {
        session.Blocks.SetOnly(bounds, intervals);
        session.SetNeighbours(neighbours);
        session.Blocks.ClearFields();
        session.Blocks.AddMaterial("material", NotNull(vfrac, "vfrac"));
        session.SetOption("Refinement", "Automatic");
        session.SetOption("MaximumLevel", std::to_string(NotNegative(auto_refine, "auto_refine")));
        session.SetOption("StairStep", stair_step ? "1" : "0");
        session.SetOption("Smoothing", std::to_string(smooth));
      };
      // The host may free vfrac before its next call.
      struct ForgetFields
      {
        ~ForgetFields() { this->Session.Blocks.ClearFields(); }
        SculptorSession& Session;
      } const forget{ session };
      session.MakeMesh(tet_mesh != 0, prepare);
    });
}

void c_get_free_totals(int handle, int* num_nodes, int* num_hexes, int* num_tets)
{
  for (int* number : { num_nodes, num_hexes, num_tets })
  {
    if (number)
    {
      *number = 0;
    }
  }
  WithSession(handle,
    [=](SculptorSession& session)
    {
      const vfm::Mesh& mesh = session.GetMesh();
      SetTotals(
        mesh.PointIds.size(), mesh.ElementIds.size(), mesh.Corners, num_nodes, num_hexes, num_tets);
    });
}

int c_get_free_hexes(int handle, double* coords, int* hexes)
{
  return GetFree(handle, HexCorners, coords, hexes);
}

int c_get_free_tets(int handle, double* coords, int* tets)
{
  return GetFree(handle, TetCorners, coords, tets);
}

int c_get_num_fragments(int handle)
{
  int fragments = -1;
  WithSession(handle,
    [&](SculptorSession& session)
    {
      session.GetMesh();
      fragments = session.GetNumberOfFragments();
    });
  return fragments;
}

int c_get_fragment_totals(int handle, int ifrag, int* num_nodes, int* num_hexes, int* num_tets)
{
  return WithSession(handle,
    [=](SculptorSession& session)
    {
      const vfm::FragmentParts::Part part = GetPart(session, ifrag);
      SetTotals(static_cast<Index>(part.Points.size()), static_cast<Index>(part.Elements.size()),
        session.GetMesh().Corners, num_nodes, num_hexes, num_tets);
    });
}

int c_get_fragment_hexes(int handle, int ifrag, double* coords, int* hexes)
{
  return GetFragment(handle, ifrag, HexCorners, coords, hexes);
}

int c_get_fragment_tets(int handle, int ifrag, double* coords, int* tets)
{
  return GetFragment(handle, ifrag, TetCorners, coords, tets);
}
