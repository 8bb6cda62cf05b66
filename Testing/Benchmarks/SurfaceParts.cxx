/**
 * Meshes closed surfaces of parts, and compares the meshes with the triangles.
 *
 * usage: SurfaceParts PARTS CELLS [SURFACES, default on,off] [METHODS, default hexes]
 *          [TURNED, default 0] [ANGLE, default 40] [HALVINGS, default 0]
 *   SurfaceParts all 3t on,off hexes 0,1
 *   SurfaceParts part.stl,other.stl 64
 *   SurfaceParts one.stl+two.stl 64
 *   SurfaceParts assembly 40,80 on,off hexes,Lattice
 *   SurfaceParts fixed_top 6t on hexes 0,1 40 0,1
 *
 * PARTS are "all" parts of known thickness, or files, or names in Data/Surfaces, also of a folder
 * of bodies; + joins the bodies of one input. CELLS are numbers of cells along the longest side, or
 * of the thickness of the named parts if t follows. SURFACES are values of the option UseSurfaces;
 * "sharp" is off with SharpEdges On. TURNED 1 rotates the part, so that its faces are oblique to
 * the grid. ANGLE: least angle of sharp edges in degrees. HALVINGS: cells of the input are
 * 2^HALVINGS wide, and those that the surface requests are halved as often (Refinement Automatic,
 * Fine Interfaces off), or none with a minus sign; CELLS and all lengths are in finest cells.
 *
 * Columns, lengths in cells: share of the true sharp edges within 0.25 of the mesh, and their rms
 * distance; distance of the nodes on the surface, rms and largest; Hausdorff and rms distance of
 * the surfaces; sides that a surface of the mesh represents / sides of the part / surfaces of the
 * mesh; error of the areas of sides, worst and mean; error of volumes; points on edges + corners;
 * CPU seconds of the fractions and of the mesh.
 */
#include "Base/ParseText.h"
#include "Base/ThreadRuntime.h"

#include "Input/PlainArrays.h"
#include "LabelInput.h"
#include "Parts/PartFigures.h"
#include "SerialTimes.h"
#include "Surfaces/ReadSurface.h"
#include "Surfaces/SurfaceFractions.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double Padding = 3.0; // cells between part and domain

/// Thickness of a part of Data/Surfaces, relative to its longest side.
struct NamedPart
{
  const char* Name;
  double Thickness;
};
constexpr NamedPart NamedParts[] = { { "plate_with_holes", 6.0 / 60.0 }, { "tray", 2.0 / 60.0 },
  { "fixed_top", 4.0 / 60.0 }, { "flange", 8.0 / 60.0 }, { "fan", 0.1 }, { "tube", 2.0 / 60.0 } };

std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, separator);)
  {
    words.push_back(word);
  }
  return words;
}

std::vector<std::string> ListParts(const std::string& words)
{
  std::vector<std::string> parts = Split(words, ',');
  if (words == "all")
  {
    parts.clear();
    for (const NamedPart& named : NamedParts)
    {
      parts.push_back(named.Name);
    }
  }
  return parts;
}

std::string NameOf(const std::filesystem::path& path)
{
  return path.stem().string();
}

/// Returns the paths of the bodies of a part, sorted by name in folders.
std::vector<std::filesystem::path> ListBodies(const std::string& words)
{
  std::vector<std::filesystem::path> paths;
  for (const std::string& word : Split(words, '+'))
  {
    const std::filesystem::path named = std::filesystem::path(VFM_SURFACES) / word;
    if (!std::filesystem::is_directory(named))
    {
      paths.push_back(word.find('.') == std::string::npos ? named.string() + ".stl" : word);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(named))
    {
      paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
  }
  return paths;
}

/// Rotates by 0.4, 0.3, 0.5 about x, y, z.
Vector3 Turn(Vector3 x)
{
  constexpr std::array<double, 3> Angles{ { 0.4, 0.3, 0.5 } };
  for (int a = 0; a < 3; ++a)
  {
    const double c = std::cos(Angles[a]), s = std::sin(Angles[a]);
    double &u = x[(a + 1) % 3], &v = x[(a + 2) % 3];
    const double turned = c * u - s * v;
    v = s * u + c * v;
    u = turned;
  }
  return x;
}

template <class Visit>
void ForPoints(std::vector<SurfaceFile>& files, const Visit& visit)
{
  for (SurfaceFile& file : files)
  {
    std::for_each(file.Points.begin(), file.Points.end(), visit);
  }
}

/// Returns the lower and the upper corner of all bodies.
std::array<Vector3, 2> FindBounds(std::vector<SurfaceFile>& files)
{
  Vector3 lower = files[0].Points[0], upper = lower;
  ForPoints(files,
    [&](const Vector3& x)
    {
      for (int a = 0; a < 3; ++a)
      {
        lower[a] = std::min(lower[a], x[a]);
        upper[a] = std::max(upper[a], x[a]);
      }
    });
  return { { lower, upper } };
}

double LongestSide(const std::array<Vector3, 2>& bounds)
{
  const Vector3 sides = bounds[1] - bounds[0];
  return *std::max_element(sides.begin(), sides.end());
}

/// Returns the number of cells along the longest side of a part that is not turned.
double CellsOf(const std::string& part, const std::string& text)
{
  const bool isThickness = text.back() == 't';
  const std::optional<double> cells =
    ParseNumber(isThickness ? text.substr(0, text.size() - 1) : text, 0.1, 1e4);
  if (!cells)
  {
    throw InputError("There is no number of cells '" + text + "'.");
  }
  if (!isThickness)
  {
    return *cells;
  }
  for (const NamedPart& named : NamedParts)
  {
    if (named.Name == part)
    {
      return *cells / named.Thickness;
    }
  }
  throw InputError("The thickness of '" + part + "' is not known.");
}

/// Bodies in units of the finest cells, inside a domain from 0.
struct Part
{
  std::string Name;
  std::shared_ptr<const InputSurfaces> Surfaces;
  Index3 Cells; ///< of the input
  double Width; ///< of these
};

Part ReadPart(const std::string& words, const std::string& cells, bool isTurned, double width)
{
  const std::vector<std::filesystem::path> paths = ListBodies(words);
  std::vector<SurfaceFile> files;
  for (const std::filesystem::path& path : paths)
  {
    files.push_back(ReadSurface(path.string()));
  }
  const double scale = CellsOf(words, cells) / LongestSide(FindBounds(files));
  ForPoints(files, [&](Vector3& x) { x = scale * (isTurned ? Turn(x) : x); });
  const auto [lower, upper] = FindBounds(files);
  Part part{ NameOf(words), nullptr, {}, width };
  Vector3 shift;
  for (int a = 0; a < 3; ++a)
  {
    const double size = upper[a] - lower[a];
    part.Cells[a] =
      static_cast<Index>(std::ceil(size / width - 1e-6)) + 2 * static_cast<Index>(Padding);
    shift[a] = 0.5 * (width * static_cast<double>(part.Cells[a]) - size) - lower[a];
  }
  ForPoints(files, [&](Vector3& x) { x = x + shift; });
  InputSurfaces surfaces;
  for (std::size_t b = 0; b < files.size(); ++b)
  {
    surfaces.Bodies.push_back(MakeBody(NameOf(paths[b]), std::move(files[b].Points),
      std::move(files[b].Triangles), std::move(files[b].Patches), std::move(files[b].PatchNames)));
  }
  part.Surfaces = std::make_shared<const InputSurfaces>(std::move(surfaces));
  return part;
}

/// Returns the fractions of the bodies; an earlier body keeps its volume.
MesherInput MakeInput(const Part& part, Runtime& runtime)
{
  const IndexBox cells{ {}, part.Cells };
  std::array<std::vector<double>, 3> coordinates;
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 0; i <= part.Cells[a]; ++i)
    {
      coordinates[a].push_back(part.Width * static_cast<double>(i));
    }
  }
  auto arrays = std::make_shared<PlainArrays>(cells.NumberOfCells());
  std::vector<Buffer<double>> fractions =
    FractionsOfSurfaces(coordinates, cells, *part.Surfaces, runtime);
  std::vector<std::string> names;
  for (std::size_t b = 0; b < fractions.size(); ++b)
  {
    names.push_back(part.Surfaces->Bodies[b].Name);
    arrays->Store(names[b], ValueType::Double, std::move(fractions[b]));
  }
  MesherInput input =
    testing::MakeInput({ MakeBlock(cells, {}, part.Width, arrays) }, runtime.Group());
  input.Arrays.Fractions = std::move(names);
  input.Surfaces = part.Surfaces;
  return input;
}

MesherOptions OptionsOf(const std::string& method, double angle, int halvings)
{
  MesherOptions options;
  options.Elements = method == "hexes" ? ElementKind::Hexes : ElementKind::Tets;
  options.Method = method == "Cells" ? TetMethod::Cells : TetMethod::Lattice;
  options.EdgeAngle = angle;
  if (halvings > 0)
  {
    options.Refinement = RefinementMode::Automatic;
    options.MaximumLevel = halvings;
    options.FineInterfaces = false;
  }
  return options;
}

void PrintHeader()
{
  std::printf("| part | cells | surfaces | elements | scaled Jacobian or angles | "
              "edges within 0.25, %% | edges rms | nodes rms, largest | Hausdorff, rms | "
              "sides found/all/mesh | side areas worst, mean %% | volume | edge+corner points | "
              "fractions, mesh s |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void PrintRow(const std::string& name, const std::string& surfaces, const MesherResult& result,
  const PartFigures& f, bool isSingle)
{
  const MeshReport& report = result.Report;
  std::printf(
    "| %s | %s | %zu | ", name.c_str(), surfaces.c_str(), result.TheMesh.ElementIds.size());
  if (result.TheMesh.Corners == 8)
  {
    std::printf("%.3f", report.MinimumScaledJacobian);
  }
  else
  {
    std::printf("%.1f-%.1f", report.MinimumDihedralAngle, report.MaximumDihedralAngle);
  }
  std::printf(" | %.1f | %.3f | %.4f, %.3f | %.2f, %.4f | ", 100.0 * f.EdgesNear,
    f.Edges.RootMeanSquare, f.Nodes.RootMeanSquare, f.Nodes.Largest, f.Hausdorff, f.RmsDistance);
  if (isSingle)
  {
    std::printf("%lld/%lld/%lld | %.1f, %.2f", static_cast<long long>(f.SidesFound),
      static_cast<long long>(f.Sides), static_cast<long long>(f.MeshSurfaces),
      100.0 * f.WorstSideArea, 100.0 * f.MeanSideArea);
  }
  else // contacts divide sides of bodies
  {
    std::printf("%lld | ", static_cast<long long>(f.MeshSurfaces));
  }
  std::printf(" | %.0e | %lld+%lld | ", f.VolumeError, static_cast<long long>(report.EdgePoints),
    static_cast<long long>(report.CornerPoints));
}

std::string NameHalvings(int halvings)
{
  const std::string width = std::to_string(1 << std::abs(halvings)) + " wide";
  return halvings == 0 ? "" : (halvings < 0 ? ", all " : ", coarse ones ") + width;
}

void MeasureSizes(const std::string& words, const std::string& cells,
  const std::vector<std::string>& surfaces, const std::vector<std::string>& methods, bool isTurned,
  double angle, int halvings)
{
  const Part part = ReadPart(words, cells, isTurned, 1 << std::abs(halvings));
  const TrueSurface truth(*part.Surfaces, angle);
  ThreadRuntime runtime(1);
  double begin = CpuSeconds(CLOCK_PROCESS_CPUTIME_ID);
  const MesherInput input = MakeInput(part, runtime);
  const double fractions = CpuSeconds(CLOCK_PROCESS_CPUTIME_ID) - begin;
  for (const std::string& method : methods)
  {
    for (const std::string& use : surfaces)
    {
      MesherOptions options = OptionsOf(method, angle, halvings);
      options.UseSurfaces = use == "on";
      options.SharpEdges = use == "sharp" ? SharpEdgeMode::On : options.SharpEdges;
      begin = CpuSeconds(CLOCK_PROCESS_CPUTIME_ID);
      const MesherResult result = RunMesher(input, options, runtime);
      const double seconds = CpuSeconds(CLOCK_PROCESS_CPUTIME_ID) - begin;
      PrintRow(part.Name + (isTurned ? ", turned" : "") + (method == "hexes" ? "" : ", " + method) +
          " | " + cells + NameHalvings(halvings),
        use, result, MeasurePart(truth, result.TheMesh, result.Report),
        part.Surfaces->Bodies.size() == 1);
      std::printf("%.2f, %.2f |\n", fractions, seconds);
      std::fflush(stdout);
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 3)
  {
    std::fprintf(
      stderr, "usage: SurfaceParts PARTS CELLS [SURFACES] [METHODS] [TURNED] [ANGLE] [HALVINGS]\n");
    return 2;
  }
  try
  {
    PrintHeader();
    for (const std::string& part : ListParts(argv[1]))
    {
      for (const std::string& turned : Split(argc > 5 ? argv[5] : "0", ','))
      {
        for (const std::string& cells : Split(argv[2], ','))
        {
          for (const std::string& halvings : Split(argc > 7 ? argv[7] : "0", ','))
          {
            MeasureSizes(part, cells, Split(argc > 3 ? argv[3] : "on,off", ','),
              Split(argc > 4 ? argv[4] : "hexes", ','), turned == "1",
              argc > 6 ? std::atof(argv[6]) : 40.0, std::atoi(halvings.c_str()));
          }
        }
      }
    }
  }
  catch (const InputError& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
