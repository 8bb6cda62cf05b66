/* Meshes half a sphere from C++ with only the calls of Sculptor's report, first as hexahedra, then
 * as tetrahedra. Runs on any number of ranks; each rank owns a box of the grid. Prints the numbers
 * of nodes and elements and the volume, and writes no file. half_sphere.c and half_sphere.f90 are
 * the same program in C and Fortran.
 *
 *   mpicxx -std=c++11 half_sphere.cpp $(pkg-config --cflags --libs sculptor) -o half_sphere
 *   mpiexec -n 4 ./half_sphere
 */
#include <CMLPSculptor.hpp>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <stdexcept>
#include <vector>

namespace
{

using Point = std::array<double, 3>;

// The whole grid has cubic cells of width 1. The sphere's centre lies on its lower z side.
const int Cells[3] = { 20, 20, 10 };
const double Centre[3] = { 10, 10, 0 }, Radius = 7;

/// Returns the volume fraction of the sphere in cell (i,j,k), from 4 x 4 x 4 samples.
double FractionOfSphere(int i, int j, int k)
{
  int inside = 0;
  for (int s = 0; s < 64; ++s)
  {
    const double x = i + (s % 4 + 0.5) / 4 - Centre[0];
    const double y = j + (s / 4 % 4 + 0.5) / 4 - Centre[1];
    const double z = k + (s / 16 + 0.5) / 4 - Centre[2];
    inside += x * x + y * y + z * z < Radius * Radius;
  }
  return inside / 64.0;
}

/// Division of the grid into one box per rank. This rank owns the cells [Lower, Upper).
struct Boxes
{
  Boxes()
  {
    int ranks, rank, layout[3] = { 0, 0, 0 }, place[3];
    const int periodic[3] = { 0, 0, 0 };
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    MPI_Dims_create(ranks, 3, layout);
    MPI_Cart_create(MPI_COMM_WORLD, 3, layout, periodic, 0, &this->Communicator);
    MPI_Comm_rank(this->Communicator, &rank);
    MPI_Cart_coords(this->Communicator, rank, 3, place);
    for (int a = 0; a < 3; ++a)
    {
      this->Lower[a] = Cells[a] * place[a] / layout[a];
      this->Upper[a] = Cells[a] * (place[a] + 1) / layout[a];
    }
  }
  ~Boxes() { MPI_Comm_free(&this->Communicator); }
  Boxes(const Boxes&) = delete;
  Boxes& operator=(const Boxes&) = delete;

  /// Returns the rank of the adjacent box, -1 where the grid ends.
  int Neighbor(int axis, int step) const
  {
    int from, to;
    MPI_Cart_shift(this->Communicator, axis, step, &from, &to);
    return to == MPI_PROC_NULL ? -1 : to;
  }
  std::vector<double> Fractions() const
  {
    std::vector<double> vfrac;
    for (int k = this->Lower[2]; k < this->Upper[2]; ++k)
    {
      for (int j = this->Lower[1]; j < this->Upper[1]; ++j)
      {
        for (int i = this->Lower[0]; i < this->Upper[0]; ++i)
        {
          vfrac.push_back(FractionOfSphere(i, j, k));
        }
      }
    }
    return vfrac;
  }

  MPI_Comm Communicator;
  int Lower[3], Upper[3];
};

/// Returns the number of nodes of all ranks, shared nodes counted once; valid on rank 0.
std::size_t CountNodes(const std::vector<double>& coords)
{
  int ranks;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const int count = static_cast<int>(coords.size());
  std::vector<int> counts(ranks), first(ranks + 1);
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, MPI_COMM_WORLD);
  for (int r = 0; r < ranks; ++r)
  {
    first[r + 1] = first[r] + counts[r];
  }
  std::vector<Point> nodes(first[ranks] / 3);
  MPI_Gatherv(coords.data(), count, MPI_DOUBLE, nodes.data(), counts.data(), first.data(),
    MPI_DOUBLE, 0, MPI_COMM_WORLD);
  std::sort(nodes.begin(), nodes.end());
  return std::unique(nodes.begin(), nodes.end()) - nodes.begin();
}

double VolumeOfTet(const double* a, const double* b, const double* c, const double* d)
{
  const double u[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const double v[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  const double w[3] = { d[0] - a[0], d[1] - a[1], d[2] - a[2] };
  return (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
           u[2] * (v[0] * w[1] - v[1] * w[0])) /
    6;
}

/// Returns the volume of all elements of this rank. Divides a hexahedron into six tetrahedra around
/// its diagonal.
double AddVolumes(const cml::Mesh& mesh)
{
  const int around[7] = { 1, 2, 3, 7, 4, 5, 1 };
  const auto at = [&mesh](int node) { return mesh.coords.data() + 3 * node; };
  double sum = 0;
  for (auto hex = mesh.hexes.begin(); hex != mesh.hexes.end(); hex += 8)
  {
    for (int t = 0; t < 6; ++t)
    {
      sum += VolumeOfTet(at(hex[0]), at(hex[around[t]]), at(hex[around[t + 1]]), at(hex[6]));
    }
  }
  for (auto tet = mesh.tets.begin(); tet != mesh.tets.end(); tet += 4)
  {
    sum += VolumeOfTet(at(tet[0]), at(tet[1]), at(tet[2]), at(tet[3]));
  }
  return sum;
}

/// Prints the totals of the mesh over all ranks.
void Report(const cml::PSculptor& sculptor)
{
  const cml::Mesh mesh = sculptor.get_free_mesh();
  const cml::Totals totals = sculptor.get_free_totals();
  if (sculptor.get_num_fragments() != 1)
  {
    throw std::runtime_error("not one fragment");
  }
  const cml::Mesh fragment = sculptor.get_fragment_mesh(1); // the only one
  if (fragment.hexes != mesh.hexes || fragment.tets != mesh.tets)
  {
    throw std::runtime_error("the fragment is not the mesh");
  }
  const int mine[2] = { totals.hexes, totals.tets };
  const double volume = AddVolumes(mesh);
  int rank, all[2] = { 0, 0 };
  double sum = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Reduce(mine, all, 2, MPI_INT, MPI_SUM, 0, MPI_COMM_WORLD);
  MPI_Reduce(&volume, &sum, 1, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
  const std::size_t nodes = CountNodes(mesh.coords);
  if (rank == 0)
  {
    std::printf("%zu nodes, %d %s, volume %.3f\n", nodes, all[0] + all[1],
      all[0] > 0 ? "hexes" : "tets", sum);
  }
}

void MeshHalfSphere()
{
  const Boxes boxes;
  const int *lower = boxes.Lower, *upper = boxes.Upper;
  const std::vector<double> vfrac = boxes.Fractions();
  cml::PSculptor sculptor;
  for (int tet_mesh = 0; tet_mesh < 2; ++tet_mesh)
  {
    sculptor.mesh_from_data(lower[0], lower[1], lower[2], upper[0], upper[1], upper[2],
      upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2], vfrac.data(),
      boxes.Neighbor(0, 1), boxes.Neighbor(0, -1), boxes.Neighbor(1, 1), boxes.Neighbor(1, -1),
      boxes.Neighbor(2, 1), boxes.Neighbor(2, -1), 0, 0, 1, tet_mesh);
    Report(sculptor);
  }
}

} // namespace

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  try
  {
    MeshHalfSphere();
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "half_sphere: %s\n", error.what());
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  MPI_Finalize();
  return 0;
}
