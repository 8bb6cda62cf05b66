#include "Surfaces/OffFile.h"

#include "Ranks/Errors.h"
#include "Surfaces/PolygonTriangles.h"
#include "Surfaces/TextScan.h"

namespace vfm
{
namespace
{

/// Returns the text without comments, which begin with #. Their characters become spaces.
std::string WithoutComments(std::string_view bytes)
{
  std::string text(bytes);
  bool isComment = false;
  for (char& c : text)
  {
    isComment = c != '\n' && (isComment || c == '#');
    c = isComment ? ' ' : c;
  }
  return text;
}

} // namespace

SurfaceFile ReadOff(std::string_view bytes)
{
  const std::string plain = WithoutComments(bytes);
  TextScan text(plain);
  const std::string_view kind = text.Word();
  if (kind != "OFF" && kind != "COFF" && kind != "NOFF" && kind != "CNOFF" && kind != "STOFF")
  {
    throw InputError("it is not an OFF file of text: it begins with " + QuoteText(kind) + ".");
  }
  const Index most = static_cast<Index>(plain.size() / 2); // each number has a space
  const Index points = text.Integer(0, most, "number of points");
  const Index polygons = text.Integer(0, most, "number of polygons");
  text.Integer(0, std::numeric_limits<Index>::max(), "number of edges");
  SurfaceFile file;
  file.PatchNames = { "" };
  for (Index p = 0; p < points; ++p)
  {
    Vector3 point{};
    for (double& x : point)
    {
      x = text.Number("coordinate of a point");
    }
    text.RestOfLine();
    file.Points.push_back(point);
  }
  std::vector<Index> corners;
  for (Index p = 0; p < polygons; ++p)
  {
    corners.resize(text.Integer(0, most, "number of corners"));
    for (Index& corner : corners)
    {
      corner = text.Integer(0, points - 1, "point of a polygon");
    }
    text.RestOfLine();
    AddPolygon(corners, 0, file);
  }
  return file;
}

} // namespace vfm
