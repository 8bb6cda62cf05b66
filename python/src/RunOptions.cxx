#include "RunOptions.h"

#include "Mesher.h"
#include "TetPipeline.h"

#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <string>
#include <type_traits>

namespace vfm
{
namespace
{

namespace nb = nanobind;

using Box = std::array<double, 7>; // from, to, halvings

class OptionBinder
{
public:
  explicit OptionBinder(nb::module_& module) : Class(module, "Options")
  {
    this->Class.def("__init__",
      [](MesherOptions* self)
      {
        MesherOptions& options = *new (self) MesherOptions();
        options.Edges = SharpEdges::Automatic;
        options.Tets = HasTetGen() ? TetMethod::TetGen : TetMethod::Lattice;
      });
  }

  /// get: the member of options.
  template <class Get>
  void Add(const char* name, Get get)
  {
    using Value = std::decay_t<decltype(get(std::declval<MesherOptions&>()))>;
    this->Class.def_prop_rw(
      name, [get](MesherOptions& self) -> Value { return get(self); },
      [get](MesherOptions& self, Value value) { get(self) = value; });
  }

  /// The same of an enumeration, as numbers from 0 to last.
  template <class Get, class Value>
  void Add(const char* name, Get get, Value last)
  {
    this->Class.def_prop_rw(
      name, [get](MesherOptions& self) { return static_cast<int>(get(self)); },
      [get, last, name](MesherOptions& self, int value)
      {
        if (value < 0 || value > static_cast<int>(last))
        {
          const std::string most = std::to_string(static_cast<int>(last));
          throw nb::value_error((std::string(name) + " must be from 0 to " + most + ".").c_str());
        }
        get(self) = static_cast<Value>(value);
      });
  }

  void AddElements()
  {
    this->Class.def_prop_rw(
      "tets", [](MesherOptions& self) { return self.Elements == ElementKind::Tets; },
      [](MesherOptions& self, bool tets)
      { self.Elements = tets ? ElementKind::Tets : ElementKind::Hexes; });
  }

  void AddBoxes()
  {
    this->Class.def_prop_rw(
      "refinement_boxes",
      [](MesherOptions& self)
      {
        std::vector<Box> boxes;
        for (const auto& [l, u, halvings] : self.RefinementBoxes)
        {
          boxes.push_back({ { l[0], l[1], l[2], u[0], u[1], u[2], halvings } });
        }
        return boxes;
      },
      [](MesherOptions& self, const std::vector<Box>& boxes)
      {
        self.RefinementBoxes.clear();
        for (const Box& b : boxes)
        {
          self.RefinementBoxes.push_back(
            { { { b[0], b[1], b[2] } }, { { b[3], b[4], b[5] } }, b[6] });
        }
      });
  }

private:
  nb::class_<MesherOptions> Class;
};

using Options = MesherOptions;

void AddMeshOptions(OptionBinder& to)
{
  to.Add("iso_value", [](Options& o) -> double& { return o.IsoValue; });
  to.Add("mesh_void", [](Options& o) -> bool& { return o.MeshVoid; });
  to.Add("stair_step", [](Options& o) -> bool& { return o.StairStep; });
  to.Add(
    "smoothing", [](Options& o) -> Smoothing& { return o.Method; }, Smoothing::GeometryBased);
  to.Add("target_scaled_jacobian", [](Options& o) -> double& { return o.TargetScaledJacobian; });
  to.Add(
    "sharp_edges", [](Options& o) -> SharpEdges& { return o.Edges; }, SharpEdges::Automatic);
  to.Add("conserve_volume", [](Options& o) -> bool& { return o.ConserveVolume; });
  to.Add("compute_quality", [](Options& o) -> bool& { return o.ComputeQuality; });
}

void AddInputOptions(OptionBinder& to)
{
  to.Add("fraction_tolerance", [](Options& o) -> double& { return o.FractionTolerance; });
  to.Add("label_smoothing", [](Options& o) -> int& { return o.LabelSmoothing; });
  to.Add("minimum_region_cells", [](Options& o) -> int& { return o.MinimumRegionCells; });
  to.Add("maximum_aspect_ratio", [](Options& o) -> double& { return o.MaximumAspectRatio; });
}

void AddRefinementOptions(OptionBinder& to)
{
  to.Add(
    "refinement", [](Options& o) -> Refinement& { return o.Where; }, Refinement::Uniform);
  to.Add("maximum_level", [](Options& o) -> int& { return o.MaximumLevel; });
  to.Add(
    "child_fractions", [](Options& o) -> ChildRule& { return o.Children; }, ChildRule::Parent);
  to.Add("fine_interfaces", [](Options& o) -> bool& { return o.FineInterfaces; });
  to.Add("fine_layers", [](Options& o) -> int& { return o.FineLayers; });
  to.Add("thin_cells", [](Options& o) -> double& { return o.ThinCells; });
  to.Add("curvature_per_cell", [](Options& o) -> double& { return o.CurvaturePerCell; });
  to.Add("refine_flipped_cells", [](Options& o) -> bool& { return o.RefineFlippedCells; });
  to.Add("interface_layers", [](Options& o) -> int& { return o.InterfaceLayers; });
  to.Add("refinement_array", [](Options& o) -> std::string& { return o.RefinementArray; });
  to.AddBoxes();
}

void AddTetOptions(OptionBinder& to)
{
  to.Add(
    "method", [](Options& o) -> TetMethod& { return o.Tets; }, TetMethod::Lattice);
  to.Add("relative_size", [](Options& o) -> double& { return o.RelativeSize; });
  to.Add("growth", [](Options& o) -> double& { return o.Growth; });
  to.Add("radius_edge_ratio", [](Options& o) -> double& { return o.RadiusEdgeRatio; });
  to.Add("minimum_dihedral_angle", [](Options& o) -> double& { return o.MinimumDihedralAngle; });
  to.Add("optimization_level", [](Options& o) -> int& { return o.OptimizationLevel; });
}

void AddStateOptions(OptionBinder& to)
{
  to.Add("state_order", [](Options& o) -> int& { return o.StateOrder; });
  to.Add(
    "give_unmeshed", [](Options& o) -> Unmeshed& { return o.UnmeshedMaterial; }, Unmeshed::Drop);
  to.Add("nodal_velocity", [](Options& o) -> bool& { return o.NodalVelocity; });
  to.Add(
    "lost_to_internal", [](Options& o) -> LostEnergy& { return o.LostKineticEnergy; },
    LostEnergy::InternalEnergy);
}

} // namespace

void BindOptions(nb::module_& module)
{
  OptionBinder binder(module);
  binder.AddElements();
  AddMeshOptions(binder);
  AddInputOptions(binder);
  AddRefinementOptions(binder);
  AddTetOptions(binder);
  AddStateOptions(binder);
}

} // namespace vfm
