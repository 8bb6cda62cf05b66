/**
 * A small simulation with Catalyst for TestCatalyst.py: a ball sinks into
 * a plate, on 14 x 12 x 10 cells.
 *
 * usage: CatalystHost [--boxes N] [--refined] [--drop] [--bad-step S] SCRIPT ...
 *
 * It takes 4 steps. The grid is cut along x into N boxes (default: two per rank), which are
 * distributed to the ranks in turn. --refined adds as many boxes of a finer level in the middle.
 * --drop fills a tenth of the last cell by the ball. In step S the last rank passes a box outside
 * the grid. The program prints a line per step, and at the end the number of steps made for the
 * scripts. Exit status 0: every step succeeded; 3: some failed; 4: error messages differ between
 * ranks.
 *
 * The adaptor may use the fields only during the call: afterwards they are overwritten.
 */
#include "CatalystAdaptor.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace
{

using namespace vfm;

constexpr Index3 Cells{ { 14, 12, 10 } };
constexpr Vector3 Origin{ { -0.7, 0.3, 2.1 } }, Spacing{ { 0.1, 0.125, 0.11 } };
constexpr IndexBox Middle{ { { 8, 4, 2 } }, { { 22, 20, 16 } } }; // refined, in cells of level 1
constexpr int Steps = 4, Samples = 4;

struct Options
{
  int Boxes = 0, BadStep = -1;
  bool IsRefined = false, HasDrop = false;
  std::vector<std::string> Scripts;
};

/// Fields of one box. The fraction of a body in a cell comes from samples;
/// all numbers are exact in binary.
struct Box
{
  int Level;
  IndexBox Cells;
  std::vector<double> Ball, Velocity;
  std::vector<float> Plate;
  std::vector<int> Labels;

  void Set(int step);
  void Spoil();
};

/// Returns whether a layer of cells is in the plate, which has three layers of level 0.
bool IsInPlate(Index k, int level)
{
  return k < 3 << level;
}

double PartInBall(const Index3& cell, int level, int step)
{
  const double centre[3] = { 5.5 + 0.5 * step, 6.0, 6.5 - 0.25 * step };
  int inside = 0;
  for (int s = 0; s < Samples * Samples * Samples; ++s)
  {
    const int at[3] = { s % Samples, s / Samples % Samples, s / (Samples * Samples) };
    double distance = 0.0;
    for (int a = 0; a < 3; ++a)
    {
      const double sample = static_cast<double>(cell[a]) + (at[a] + 0.5) / Samples;
      const double x = std::ldexp(sample, -level) - centre[a];
      distance += x * x;
    }
    inside += distance < 10.5625;
  }
  return inside / static_cast<double>(Samples * Samples * Samples);
}

void Box::Set(int step)
{
  *this = Box{ this->Level, this->Cells, {}, {}, {}, {} };
  for (Index k = this->Cells.Lower[2]; k < this->Cells.Upper[2]; ++k)
  {
    for (Index j = this->Cells.Lower[1]; j < this->Cells.Upper[1]; ++j)
    {
      for (Index i = this->Cells.Lower[0]; i < this->Cells.Upper[0]; ++i)
      {
        const double ball = PartInBall({ { i, j, k } }, this->Level, step);
        const double plate = IsInPlate(k, this->Level) ? 1.0 - ball : 0.0;
        this->Ball.push_back(ball);
        this->Plate.push_back(static_cast<float>(plate));
        this->Labels.push_back(ball + plate < 0.5 ? 0 : ball >= plate ? 1 : 2);
        this->Velocity.insert(this->Velocity.end(), { 0.5 * ball, 0.0, -0.25 * ball });
      }
    }
  }
}

void Box::Spoil()
{
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  this->Ball.assign(this->Ball.size(), nothing);
  this->Velocity.assign(this->Velocity.size(), nothing);
  this->Plate.assign(this->Plate.size(), static_cast<float>(nothing));
  this->Labels.assign(this->Labels.size(), -1);
}

Options ParseOptions(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string name = argv[i];
    if (name == "--boxes" && i + 1 < argc)
    {
      options.Boxes = std::atoi(argv[++i]);
    }
    else if (name == "--bad-step" && i + 1 < argc)
    {
      options.BadStep = std::atoi(argv[++i]);
    }
    else if (name == "--refined")
    {
      options.IsRefined = true;
    }
    else if (name == "--drop")
    {
      options.HasDrop = true;
    }
    else
    {
      options.Scripts.push_back(name);
    }
  }
  return options;
}

/// Returns the boxes of this rank; count: boxes on each level.
std::vector<Box> MakeBoxes(int count, int levels, int rank, int ranks)
{
  std::vector<Box> boxes;
  for (int b = rank; b < count * levels; b += ranks)
  {
    const int level = b / count;
    const IndexBox whole = level ? Middle : IndexBox{ {}, Cells };
    Box box{ level, whole, {}, {}, {}, {} };
    box.Cells.Lower[0] = whole.Lower[0] + whole.Size(0) * (b % count) / count;
    box.Cells.Upper[0] = whole.Lower[0] + whole.Size(0) * (b % count + 1) / count;
    boxes.push_back(box);
  }
  return boxes;
}

HostGrid Describe(const std::vector<Box>& boxes)
{
  HostGrid grid{ Origin, Spacing, Cells, {} };
  for (const Box& box : boxes)
  {
    grid.Boxes.push_back({ box.Cells,
      { MakeHostArray("ball", box.Ball.data()), MakeHostArray("plate", box.Plate.data()),
        MakeHostArray("id", box.Labels.data()), MakeHostArray("velocity", box.Velocity.data(), 3) },
      box.Level });
  }
  return grid;
}

/// Returns the global numbers, among them the address of the first box's ball, which scripts read.
std::vector<HostNumber> FindNumbers(int step, const std::vector<Box>& boxes)
{
  const double address =
    boxes.empty() ? 0.0 : reinterpret_cast<std::uintptr_t>(boxes[0].Ball.data());
  return { { "Fragments", step < 2 ? 2.0 : 1.0 }, { "BallAddress", address } };
}

bool IsSameOnAllRanks(std::string text)
{
  const std::string mine = text;
  int size = static_cast<int>(text.size()), same = 0;
  MPI_Bcast(&size, 1, MPI_INT, 0, MPI_COMM_WORLD);
  text.resize(size);
  MPI_Bcast(&text[0], size, MPI_CHAR, 0, MPI_COMM_WORLD);
  const int equal = text == mine;
  MPI_Allreduce(&equal, &same, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  return same > 0;
}

int Run(const Options& options)
{
  int rank = 0, ranks = 1, status = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::vector<Box> boxes = MakeBoxes(
    options.Boxes > 0 ? options.Boxes : 2 * ranks, options.IsRefined ? 2 : 1, rank, ranks);
  CatalystAdaptor catalyst(MPI_COMM_WORLD, options.Scripts);
  for (int step = 0; step < Steps; ++step)
  {
    for (Box& box : boxes)
    {
      box.Set(step);
      if (options.HasDrop && box.Level == 0 && box.Cells.Upper == Cells)
      {
        box.Ball.back() = 0.1;
      }
    }
    HostGrid grid = Describe(boxes);
    if (step == options.BadStep && rank == ranks - 1)
    {
      grid.Boxes.at(0).Cells.Upper[0] = Cells[0] + 1;
    }
    const bool done =
      catalyst.Process(grid, 0.125 * step, step, FindNumbers(step, boxes), step + 1 == Steps);
    for (Box& box : boxes)
    {
      box.Spoil();
    }
    if (!IsSameOnAllRanks((done ? "done" : "failed") + catalyst.GetError()))
    {
      return 4;
    }
    status = done ? status : 3;
    if (rank == 0)
    {
      std::printf(
        "host: step %d %s %s\n", step, done ? "done" : "failed:", catalyst.GetError().c_str());
    }
  }
  if (rank == 0)
  {
    std::printf("host: %d steps made\n", catalyst.GetNumberOfStepsMade());
  }
  return status;
}

} // namespace

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  const int status = Run(ParseOptions(argc, argv));
  MPI_Finalize();
  return status;
}
