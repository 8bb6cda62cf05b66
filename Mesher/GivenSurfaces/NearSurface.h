/**
 * NearSurface: samples, sharp edges and corners of the surface of one body near the cells of a
 * grid. Samples may lie beyond the domain; edges end at its sides. Triangles in the sides of the
 * domain, where bodies are cut off, do not count, nor do their edges.
 */
#pragma once

#include "GivenSurfaces/BodySurfaces.h"
#include "SharpFeatures/FeatureData.h"

namespace vfm
{

/// Point of a surface, in the local frame of a node.
struct NearSample
{
  Vector3 At, Normal; ///< unit normal, outwards
  double Weight;      ///< area that the sample stands for, cells^2
  int Sheet;
};

/// Point of a sharp edge that is nearest to a node, in the local frame of the node.
struct NearEdge
{
  Vector3 At;
  double Distance;
  std::array<int, 2> Sheets;
  std::array<Vector3, 2> Normals; ///< unit, outwards
  bool IsConvex;
};

/// Point where sharp edges of three or more sheets meet, in the local frame of a node.
struct NearCorner
{
  Vector3 At;
  double Distance;
  std::vector<int> Sheets;      ///< ascending
  std::vector<Vector3> Normals; ///< unit, outwards, of one triangle per sheet
};

/// Finds what is near a node. The results do not depend on the box of cells, except for its
/// limits. The object is constant; threads may use it at the same time.
class NearSurface
{
public:
  /// @param body  position in BodySurfaces::Bodies()
  /// @param ratio  factor from grid coordinates of the interface to those of the bodies
  /// @param interface  interface of the grid; what is near nodes of its local box is found
  NearSurface(const BodySurfaces& bodies, int body, double ratio, const Interface& interface);

  /// Collects the samples whose distance to the node is at most a radius in cells, 4.5 at most.
  void ListSamples(const NodeFrame& frame, double radius, std::vector<NearSample>& samples) const;
  /// Collects the edges in the order of their numbers.
  void ListEdges(const NodeFrame& frame, double radius, std::vector<NearEdge>& edges) const;
  void ListCorners(const NodeFrame& frame, double radius, std::vector<NearCorner>& corners) const;

private:
  struct Sample
  {
    Vector3 At;
    double Area; // in cells of mean width
    int Triangle;
  };
  struct Edge
  {
    std::array<Vector3, 2> Ends;
    std::array<int, 2> Sheets, Triangles;
    bool IsConvex;
  };
  struct Corner
  {
    Vector3 At;
    std::vector<int> Sheets, Triangles;
  };
  /// Numbers of items by unit cells of mean width, for the cells near the local box.
  struct Bins
  {
    IndexBox Box;
    std::vector<Index> RowBegin; // first item of each row along x
    std::vector<int> Cells;      // cell of each item along x, ascending in a row
    std::vector<int> Items;
  };
  using BinnedItem = std::pair<Index, int>; // cell and number of an item

  using Points = std::vector<Vector3>;
  void PlaceBox(const CartesianGrid& grid, const Interface& interface);
  void SetNormals(const GivenBody& body, const Bounds& domain);
  void AddSamples(const Points& points, const PointTriangle& corners, int triangle);
  void AddEdges(const Points& points, const SurfaceSheets& sheets);
  void AddCorners(const Points& points, const SurfaceSheets& sheets);
  void FillBins();
  Bins MakeBins(std::vector<BinnedItem> items) const;
  Index3 BinOf(const Vector3& x) const;
  bool Counts(const std::array<int, 2>& triangles) const
  {
    return this->Normals[triangles[0]] != Vector3{} && this->Normals[triangles[1]] != Vector3{};
  }
  template <class Visitor>
  void Visit(const Bins& bins, const NodeFrame& frame, double radius, const Visitor& visit) const;

  Vector3 Lengths;              // of the domain with its copies, grid coordinates
  Vector3 Widths;               // mean widths of cells, grid coordinates
  IndexBox Box;                 // bins near the local box
  std::vector<Vector3> Normals; // of triangles that count; others are zero
  std::vector<int> SheetOf;
  std::vector<Sample> Samples;
  std::vector<Edge> Edges;
  std::vector<Corner> Corners;
  Bins SampleBins, EdgeBins, CornerBins;
};

} // namespace vfm
