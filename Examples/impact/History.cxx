#include "History.h"

#include "WorkTogether.h"

#include <stdexcept>

namespace impact
{
namespace
{

constexpr const char* Quantities[] = { "mass [mg]", "momentum x [mg km/s]", "momentum y [mg km/s]",
  "momentum z [mg km/s]", "kinetic energy [J]", "internal energy [J]" };

void WriteTotals(std::ofstream& file, const std::array<Totals, NumberOfBodies>& totals)
{
  for (const Totals& t : totals)
  {
    for (double value :
      { t.Mass, t.Momentum[0], t.Momentum[1], t.Momentum[2], t.Kinetic, t.Internal })
    {
      file << "," << value;
    }
  }
}

} // namespace

History::History(const Domain& domain, const std::string& path) : Grid(domain), Path(path)
{
  if (path.empty())
  {
    return;
  }
  WorkTogether(domain.GetCommunicator(),
    [this]
    {
      if (this->Grid.GetRank() > 0)
      {
        return;
      }
      this->File.open(this->Path);
      this->File.precision(17);
      this->File << "step,time [us]";
      for (const char* place : { "", " left" })
      {
        for (const char* body : { "ball", "plate" })
        {
          for (const char* quantity : Quantities)
          {
            this->File << "," << body << place << " " << quantity;
          }
        }
      }
      this->File << "\n";
      this->Check();
    });
}

void History::Add(std::int64_t step, const Solver& motion)
{
  if (this->Path.empty())
  {
    return;
  }
  const auto inside = motion.TotalsInside(), outside = motion.TotalsOutside();
  WorkTogether(this->Grid.GetCommunicator(),
    [&]
    {
      if (this->Grid.GetRank() > 0)
      {
        return;
      }
      this->File << step << "," << static_cast<double>(step) * motion.GetTimeStep();
      WriteTotals(this->File, inside);
      WriteTotals(this->File, outside);
      this->File << "\n";
      this->Check();
    });
}

void History::Check()
{
  if (!this->File.flush())
  {
    throw std::runtime_error("cannot write " + this->Path);
  }
}

} // namespace impact
