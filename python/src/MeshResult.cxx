#include "MeshResult.h"

#include "NumpyFields.h"
#include "NumpyParticles.h"

namespace vfm
{
namespace
{

namespace nb = nanobind;

nb::dict TakeSurfaces(SurfaceFacets& facets, int corners)
{
  nb::dict surfaces;
  surfaces["cells"] = ToNumpy(facets.Points, corners);
  surfaces["surface_id"] = ToNumpy(facets.SurfaceId);
  surfaces["material_pair"] = ToNumpy(facets.MaterialPair, 2);
  surfaces["domain_side"] = ToNumpy(facets.DomainSide);
  return surfaces;
}

nb::dict TakeCurves(CurveEdges& edges)
{
  nb::dict curves;
  curves["cells"] = ToNumpy(edges.Points, 2);
  curves["curve_id"] = ToNumpy(edges.CurveId);
  return curves;
}

nb::dict TakeVertices(VertexPoints& points)
{
  nb::dict vertices;
  vertices["points"] = ToNumpy(points.Points);
  vertices["vertex_id"] = ToNumpy(points.VertexId);
  return vertices;
}

void TakeMesh(Mesh& mesh, nb::dict& all)
{
  all["points"] = ToNumpy(mesh.Points, 3);
  all["cells"] = ToNumpy(mesh.Elements, mesh.Corners);
  const bool isLinear = mesh.MidsPerElement == 0;
  all["mids"] = isLinear ? nb::object(nb::none()) : ToNumpy(mesh.MidPoints, mesh.MidsPerElement);
  all["point_ids"] = ToNumpy(mesh.PointIds);
  all["cell_ids"] = ToNumpy(mesh.ElementIds);
  const bool isPeriodic = !mesh.PeriodicPartner.empty();
  all["partner"] = isPeriodic ? ToNumpy(mesh.PeriodicPartner) : nb::object(nb::none());
  const bool isSplit = !mesh.OriginalPointIds.empty();
  all["original_ids"] = isSplit ? ToNumpy(mesh.OriginalPointIds) : nb::object(nb::none());
  all["material"] = ToNumpy(mesh.Material);
  all["fragment"] = ToNumpy(mesh.Fragment);
  all["geometry_dimension"] = ToNumpy(mesh.GeometryDimension);
  all["geometry_id"] = ToNumpy(mesh.GeometryId);
  all["surfaces"] = TakeSurfaces(mesh.Surfaces, mesh.CornersOfFacet());
  all["curves"] = TakeCurves(mesh.Curves);
  all["vertices"] = TakeVertices(mesh.Vertices);
}

void TakeState(OutputState& state, nb::dict& all)
{
  nb::dict arrays;
  for (TransferredArray& array : state.Arrays)
  {
    arrays[array.Name.c_str()] = ToNumpy(array);
  }
  all["state"] = arrays;
  all["nodal_velocity"] = nb::none();
  if (state.NodalVelocity)
  {
    all["nodal_velocity"] =
      nb::make_tuple(state.NodalVelocity->Name.c_str(), ToNumpy(*state.NodalVelocity));
  }
  all["particles"] = state.TheParticles ? TakeParticles(*state.TheParticles) : nb::dict();
}

} // namespace

nb::dict ToPython(MesherResult result)
{
  nb::dict all;
  Mesh& mesh = result.TheMesh;
  const bool hasQuality = mesh.ScaledJacobian.size() == mesh.ElementIds.size();
  TakeMesh(mesh, all);
  const bool hasLayers = !mesh.Layer.empty();
  all["layer"] = hasLayers ? ToNumpy(mesh.Layer) : nb::object(nb::none());
  all["scaled_jacobian"] = hasQuality ? ToNumpy(mesh.ScaledJacobian) : nb::object(nb::none());
  TakeState(result.State, all);
  all["fields"] = ToDict(result.Fields);
  all["materials"] = ToDict(result.MaterialFields);
  all["surface_fields"] = ToDict(ListSurfaces(mesh.Tables));
  all["curve_fields"] = ToDict(ListCurves(mesh.Tables));
  all["vertex_fields"] = ToDict(ListVertices(mesh.Tables));
  return all;
}

} // namespace vfm
