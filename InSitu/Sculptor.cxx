/**
 * Implements the calls of Sculptor.h, except for the geometry. Checks handles and pointers and
 * converts exceptions to codes.
 */
#include "Sculptor.h"

#include "SculptorCalls.h"

#include <algorithm>

using vfm::NotNull;
using vfm::SculptorSession;
using vfm::WithSession;

namespace
{

/// Returns an array of the mesh, null if it is empty.
template <class Value>
int GetArray(
  int sculptor, vfm::Buffer<Value> vfm::Mesh::*array, const Value** values, const char* name)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      const vfm::Buffer<Value>& own = session.GetMesh().*array;
      *NotNull(values, name) = own.empty() ? nullptr : own.data();
    });
}

void ReturnState(const vfm::TransferredArray& state, int* components, const double** values)
{
  *NotNull(components, "components") = state.Components;
  *NotNull(values, "values") = reinterpret_cast<const double*>(state.Values.data());
}

} // namespace

int sculptor_create(int* sculptor)
{
  return vfm::CallWithoutSculptor().Do(
    [=]
    {
      NotNull(sculptor, "sculptor");
      *sculptor = vfm::AddSculptor();
    });
}

int sculptor_delete(int sculptor)
{
  return vfm::CallWithoutSculptor().Do([=] { vfm::RemoveSculptor(sculptor); });
}

int sculptor_set_communicator(int sculptor, int communicator)
{
  return WithSession(
    sculptor, [=](SculptorSession& session) { session.SetCommunicator(communicator); });
}

int sculptor_set_option(int sculptor, const char* name, const char* value)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    { session.SetOption(NotNull(name, "name"), NotNull(value, "value")); });
}

int sculptor_set_box(int sculptor, const double* bounding_box, const int* intervals)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      session.Blocks.SetOnly(
        NotNull(bounding_box, "bounding_box"), NotNull(intervals, "intervals"));
    });
}

int sculptor_add_block(int sculptor, int level, const double* bounding_box, const int* intervals)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      session.Blocks.Begin(
        level, NotNull(bounding_box, "bounding_box"), NotNull(intervals, "intervals"));
    });
}

int sculptor_clear_blocks(int sculptor)
{
  return WithSession(sculptor,
    [](SculptorSession& session)
    {
      session.Blocks.Clear();
      session.Requests = {};
    });
}

int sculptor_set_neighbours(int sculptor, const int* neighbours)
{
  return WithSession(
    sculptor, [=](SculptorSession& session) { session.SetNeighbours(neighbours); });
}

int sculptor_add_material(int sculptor, const char* name, const double* vfrac)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    { session.Blocks.AddMaterial(NotNull(name, "name"), NotNull(vfrac, "vfrac")); });
}

int sculptor_set_material_ids(int sculptor, const int* ids)
{
  return WithSession(sculptor,
    [=](SculptorSession& session) { session.Blocks.SetMaterialIds(NotNull(ids, "ids")); });
}

int sculptor_add_state(int sculptor, const char* name, int components, const double* values)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    { session.Blocks.AddState(NotNull(name, "name"), components, NotNull(values, "values")); });
}

int sculptor_set_refinement(int sculptor, const int* halvings)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    { session.Requests.Set(std::max<std::size_t>(session.Blocks.Count(), 1) - 1, halvings); });
}

int sculptor_clear_fields(int sculptor)
{
  return WithSession(sculptor, [](SculptorSession& session) { session.Blocks.ClearFields(); });
}

int sculptor_make_mesh(int sculptor, int tet_mesh)
{
  return WithSession(
    sculptor, [=](SculptorSession& session) { session.MakeMesh(tet_mesh != 0, [] {}); });
}

int sculptor_get_counts(int sculptor, int64_t* points, int64_t* elements, int* corners)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      const vfm::Mesh& mesh = session.GetMesh();
      *NotNull(points, "points") = static_cast<int64_t>(mesh.PointIds.size());
      *NotNull(elements, "elements") = static_cast<int64_t>(mesh.ElementIds.size());
      *NotNull(corners, "corners") = mesh.ElementIds.empty() ? 0 : mesh.Corners;
    });
}

int sculptor_get_points(int sculptor, const double** coordinates)
{
  return GetArray(sculptor, &vfm::Mesh::Points, coordinates, "coordinates");
}

int sculptor_get_elements(int sculptor, const int64_t** connectivity)
{
  return GetArray(sculptor, &vfm::Mesh::Elements, connectivity, "connectivity");
}

int sculptor_get_point_ids(int sculptor, const int64_t** ids)
{
  return GetArray(sculptor, &vfm::Mesh::PointIds, ids, "ids");
}

int sculptor_get_element_ids(int sculptor, const int64_t** ids)
{
  return GetArray(sculptor, &vfm::Mesh::ElementIds, ids, "ids");
}

int sculptor_get_original_ids(int sculptor, const int64_t** ids)
{
  return GetArray(sculptor, &vfm::Mesh::OriginalPointIds, ids, "ids");
}

int sculptor_get_cohesive(int sculptor, int64_t* elements, int* corners,
  const int64_t** connectivity, const int64_t** ids, const int** materials)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      const vfm::CohesiveElements& all = session.GetCohesive();
      const bool areNone = all.Ids.empty();
      *NotNull(elements, "elements") = static_cast<int64_t>(all.Ids.size());
      *NotNull(corners, "corners") =
        areNone ? 0 : static_cast<int>(all.Points.size() / all.Ids.size());
      *NotNull(connectivity, "connectivity") = areNone ? nullptr : all.Points.data();
      *NotNull(ids, "ids") = areNone ? nullptr : all.Ids.data();
      *NotNull(materials, "materials") = areNone ? nullptr : all.Materials.data();
    });
}

int sculptor_get_materials(int sculptor, const int** ids)
{
  return GetArray(sculptor, &vfm::Mesh::Material, ids, "ids");
}

int sculptor_get_fragments(int sculptor, const int** ids)
{
  return GetArray(sculptor, &vfm::Mesh::Fragment, ids, "ids");
}

int sculptor_get_layers(int sculptor, const int** layers)
{
  return GetArray(sculptor, &vfm::Mesh::Layer, layers, "layers");
}

int sculptor_get_state(int sculptor, const char* name, int* components, const double** values)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    { ReturnState(session.GetState(NotNull(name, "name")), components, values); });
}

int sculptor_get_point_state(int sculptor, const char* name, int* components, const double** values)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    { ReturnState(session.GetPointState(NotNull(name, "name")), components, values); });
}

int sculptor_get_particles(int sculptor, int64_t* particles, const double** positions,
  const int64_t** ids, const int** materials, const double** radii, const double** volumes,
  const double** masses)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      const vfm::ParticleData all = session.GetParticles();
      *NotNull(particles, "particles") = static_cast<int64_t>(all.NumberOfParticles);
      *NotNull(positions, "positions") = all.Positions;
      *NotNull(ids, "ids") = all.Ids;
      *NotNull(materials, "materials") = all.Material;
      *NotNull(radii, "radii") = all.Radius;
      *NotNull(volumes, "volumes") = all.Volume;
      *NotNull(masses, "masses") = all.Mass;
    });
}

int sculptor_get_particle_state(
  int sculptor, const char* name, int* components, const double** values)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    { ReturnState(session.GetParticleState(NotNull(name, "name")), components, values); });
}

int sculptor_get_number(int sculptor, const char* name, int index, double* value)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    { *NotNull(value, "value") = session.GetNumber(NotNull(name, "name"), index); });
}

int sculptor_write(int sculptor, const char* path)
{
  return WithSession(sculptor, [=](SculptorSession& session) { session.Write(path); });
}

int sculptor_error_code(int sculptor)
{
  const std::shared_ptr<vfm::Sculptor> found = vfm::FindSculptor(sculptor);
  if (!found && sculptor != 0)
  {
    return SCULPTOR_ERROR_HANDLE;
  }
  return found ? found->Call.GetCode() : vfm::CallWithoutSculptor().GetCode();
}

const char* sculptor_error_text(int sculptor)
{
  const std::shared_ptr<vfm::Sculptor> found = vfm::FindSculptor(sculptor);
  return (found ? found->Call : vfm::CallWithoutSculptor()).GetText().c_str();
}

const char* sculptor_warning_text(int sculptor)
{
  const std::shared_ptr<vfm::Sculptor> found = vfm::FindSculptor(sculptor);
  return found ? found->Session.GetWarningText().c_str() : "";
}
