/* Meshes a ball from C on any number of ranks, each with a slab of the grid, and adds up its volume.
 *
 *   mpicc mesh_in_c.c $(pkg-config --cflags --libs sculptor) -o mesh_in_c && mpiexec -n 2 ./mesh_in_c
 */
#include <Sculptor.h>

#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

enum
{
  N = 24 /* cells along each axis of the whole grid */
};

/* Part of the cell (i,j,k) in the ball, from 4 x 4 x 4 samples; the grid is the unit cube. */
static double fraction_of_ball(int i, int j, int k)
{
  const int samples = 4;
  int inside = 0;
  for (int s = 0; s < samples * samples * samples; ++s)
  {
    const double x = (i + (s % 4 + 0.5) / samples) / N - 0.5;
    const double y = (j + (s / 4 % 4 + 0.5) / samples) / N - 0.5;
    const double z = (k + (s / 16 + 0.5) / samples) / N - 0.5;
    inside += x * x + y * y + z * z < 0.35 * 0.35;
  }
  return inside / 64.0;
}

static void check(int code, int sculptor)
{
  if (code != SCULPTOR_OK)
  {
    fprintf(stderr, "sculptor: error %d: %s\n", code, sculptor_error_text(sculptor));
    MPI_Abort(MPI_COMM_WORLD, code);
  }
}

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);

  const int first = N * rank / ranks, last = N * (rank + 1) / ranks;
  double* vfrac = malloc(sizeof(double) * N * N * (last - first));
  for (int k = first, cell = 0; k < last; ++k)
  {
    for (int j = 0; j < N; ++j)
    {
      for (int i = 0; i < N; ++i)
      {
        vfrac[cell++] = fraction_of_ball(i, j, k);
      }
    }
  }
  const double box[6] = { 0, 0, (double)first / N, 1, 1, (double)last / N };
  const int neighbours[6] = { -1, -1, -1, -1, rank - 1, rank + 1 < ranks ? rank + 1 : -1 };

  int sculptor = 0, nodes = 0, hexes = 0, tets = 0, fragments = 0;
  check(sculptor_create(&sculptor), 0);
  check(
    c_mesh_from_data(sculptor, box, N, N, last - first, vfrac, neighbours, 0, 0, 1, 0), sculptor);
  check(c_get_free_totals(sculptor, &nodes, &hexes, &tets), sculptor);
  double* coordinates = malloc(sizeof(double) * 3 * nodes);
  int* connectivity = malloc(sizeof(int) * 8 * hexes);
  check(c_get_free_hexes(sculptor, coordinates, connectivity), sculptor);
  check(c_get_num_fragments(sculptor, &fragments), sculptor);

  double volume = 0, target = 0;
  check(sculptor_get_number(sculptor, "MeshVolume", 0, &volume), sculptor);
  check(sculptor_get_number(sculptor, "TargetVolume", 0, &target), sculptor);
  int total = 0;
  MPI_Reduce(&hexes, &total, 1, MPI_INT, MPI_SUM, 0, MPI_COMM_WORLD);
  if (rank == 0)
  {
    printf(
      "%d hexahedra in %d fragment(s), volume %.6f of %.6f\n", total, fragments, volume, target);
  }
  check(sculptor_delete(sculptor), sculptor);
  free(connectivity);
  free(coordinates);
  free(vfrac);
  MPI_Finalize();
  return 0;
}
