#include "Input/ImageFrame.h"

#include "Ranks/Agreement.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double Orthonormal = 1e-5; // tolerance of products of axes; files have single precision
constexpr double Rounding = 1e-6;    // tolerance of a matrix element, in single precision

using Axes = std::array<double, 9>;

Vector3 Column(const Axes& axes, int c)
{
  return { { axes[c], axes[3 + c], axes[6 + c] } };
}

double Determinant(const Axes& axes)
{
  return Dot(Column(axes, 0), Cross(Column(axes, 1), Column(axes, 2)));
}

std::string TextOf(const Axes& axes)
{
  std::ostringstream text;
  for (int i = 0; i < 9; ++i)
  {
    text << (i == 0 ? "(" : i % 3 == 0 ? "; " : " ") << axes[i];
  }
  return text.str() + ")";
}

void CheckAxes(const Axes& axes, const std::string& name)
{
  for (int a = 0; a < 3; ++a)
  {
    for (int b = a; b < 3; ++b)
    {
      const double product = Dot(Column(axes, a), Column(axes, b));
      if (!(std::fabs(product - (a == b ? 1.0 : 0.0)) <= Orthonormal)) // nor NaN
      {
        throw InputError(name + " has the direction matrix " + TextOf(axes) +
          ", which is sheared or scaled: its columns must be at right angles and of length 1. "
          "Resample it onto such an image (ParaView's filter Resample To Image).");
      }
    }
  }
}

/// Replaces the tensor t by A t A^T, both row-major.
void RotateTensor(const Axes& axes, double* t)
{
  Axes half{};
  for (int i = 0; i < 9; ++i)
  {
    const double *row = axes.data() + i / 3 * 3, *column = t + i % 3;
    half[i] = row[0] * column[0] + row[1] * column[3] + row[2] * column[6];
  }
  for (int i = 0; i < 9; ++i)
  {
    const double *row = half.data() + i / 3 * 3, *other = axes.data() + i % 3 * 3;
    t[i] = row[0] * other[0] + row[1] * other[1] + row[2] * other[2];
  }
}

template <class Swap>
void SwapCorners(Buffer<Index>& elements, int corners, const Swap& swap)
{
  for (std::size_t e = 0; e < elements.size(); e += corners)
  {
    swap(elements.data() + e);
  }
}

/// Exchanges the two sides of elements that change places when corners are swapped.
void ReverseSides(Mesh& mesh)
{
  const int lower = mesh.HasHexes() ? 4 : 0, upper = mesh.HasHexes() ? 5 : 3;
  for (MeshFacet& facet : mesh.Facets)
  {
    facet.Side = facet.Side == lower ? upper : facet.Side == upper ? lower : facet.Side;
  }
  std::sort(mesh.Facets.begin(), mesh.Facets.end());
}

/// Reverses the orientation of elements and facets.
void ReverseCorners(Mesh& mesh)
{
  if (mesh.HasHexes())
  {
    SwapCorners(mesh.Elements, 8,
      [](Index* corners) { std::swap_ranges(corners, corners + 4, corners + 4); });
  }
  else
  {
    SwapCorners(mesh.Elements, 4, [](Index* corners) { std::swap(corners[2], corners[3]); });
  }
  ReverseSides(mesh);
  const int corners = mesh.CornersOfFacet();
  SwapCorners(mesh.Surfaces.Points, corners,
    [corners](Index* facet) { std::swap(facet[1], facet[corners - 1]); });
}

} // namespace

bool ImageFrame::IsAligned() const
{
  return std::all_of(this->Axes.begin(), this->Axes.end(),
    [](double x) { return std::min(std::fabs(x), std::fabs(std::fabs(x) - 1.0)) <= Rounding; });
}

bool ImageFrame::IsMirrored() const
{
  return Determinant(this->Axes) < 0.0;
}

Vector3 ImageFrame::ToSpace(const Vector3& own) const
{
  const Vector3 d = own - this->Origin;
  return this->Origin + (d[0] * Column(this->Axes, 0) + d[1] * Column(this->Axes, 1)) +
    d[2] * Column(this->Axes, 2);
}

Vector3 ImageFrame::ToOwn(const Vector3& inSpace) const
{
  const Vector3 d = inSpace - this->Origin;
  return this->Origin +
    Vector3{ { Dot(Column(this->Axes, 0), d), Dot(Column(this->Axes, 1), d),
      Dot(Column(this->Axes, 2), d) } };
}

Vector3 ImageFrame::OriginOf(const Vector3& origin) const
{
  return this->IsIdentity() || origin == this->Origin ? origin : this->ToOwn(origin);
}

ImageFrame MakeImageFrame(
  const std::array<double, 9>& axes, const Vector3& origin, const std::string& name)
{
  CheckAxes(axes, name);
  ImageFrame frame;
  frame.Axes = axes;
  if (!frame.IsIdentity()) // otherwise the origin has no effect
  {
    frame.Origin = origin;
  }
  return frame;
}

ImageFrame AgreeOnFrame(std::vector<ImageFrame> frames, Ranks& ranks)
{
  const bool isTurned = std::any_of(
    frames.begin(), frames.end(), [](const ImageFrame& frame) { return !frame.IsIdentity(); });
  if (!ranks.Any(isTurned))
  {
    return {};
  }
  frames = UnionOverRanks(ranks, std::move(frames));
  const ImageFrame &first = frames.front(), &last = frames.back();
  if (first.Axes != last.Axes)
  {
    throw InputError("Blocks of the input have different direction matrices, " +
      TextOf(first.Axes) + " and " + TextOf(last.Axes) +
      ": all must have the same, to lie on one grid.");
  }
  return first;
}

bool CanRotate(int components)
{
  return components == 3 || components == 6 || components == 9;
}

void RotateTuple(const ImageFrame& frame, int components, double* values)
{
  if (frame.IsIdentity())
  {
    return;
  }
  if (components == 3)
  {
    const Vector3 rotated = values[0] * Column(frame.Axes, 0) + values[1] * Column(frame.Axes, 1) +
      values[2] * Column(frame.Axes, 2);
    std::copy_n(rotated.begin(), 3, values);
  }
  else if (components == 6)
  {
    constexpr int places[9] = { 0, 3, 5, 3, 1, 4, 5, 4, 2 };
    Axes tensor;
    std::transform(places, places + 9, tensor.begin(), [values](int p) { return values[p]; });
    RotateTensor(frame.Axes, tensor.data());
    for (int i = 0; i < 9; ++i)
    {
      values[places[i]] = tensor[i];
    }
  }
  else if (components == 9)
  {
    RotateTensor(frame.Axes, values);
  }
}

void TurnPoints(const ImageFrame& frame, std::span<double> points)
{
  for (std::size_t p = 0; p < points.size() && !frame.IsIdentity(); p += 3)
  {
    const Vector3 turned = frame.ToSpace({ { points[p], points[p + 1], points[p + 2] } });
    std::copy(turned.begin(), turned.end(), points.begin() + p);
  }
}

void TurnMesh(const ImageFrame& frame, Mesh& mesh)
{
  if (frame.IsIdentity())
  {
    return;
  }
  TurnPoints(frame, { mesh.Points.data(), mesh.Points.size() });
  for (Vector3& centroid : mesh.Tables.SurfaceCentroids)
  {
    centroid = frame.ToSpace(centroid);
  }
  for (Vector3& normal : mesh.Tables.SurfaceNormals)
  {
    normal = frame.ToSpace(frame.Origin + normal) - frame.Origin;
  }
  for (EdgePull& pull : mesh.Pulls)
  {
    pull.Pull = frame.ToSpace(frame.Origin + pull.Pull) - frame.Origin;
  }
  if (frame.IsMirrored())
  {
    ReverseCorners(mesh);
  }
}

} // namespace vfm
