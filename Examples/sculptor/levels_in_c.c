/* Meshes a ball on a refined grid from C. Blocks of two levels are distributed over any number of
 * ranks; blocks with the ball's surface have cells half as wide. Prints the numbers of blocks and
 * elements and the volume, and writes no file.
 *
 *   mpicc levels_in_c.c $(pkg-config --cflags --libs sculptor) -o levels_in_c
 *   mpiexec -n 3 ./levels_in_c
 */
#include <Sculptor.h>

#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

enum
{
  BLOCKS = 6, /* number along each axis of the unit cube */
  CELLS = 2   /* number along each axis of a block of level 0 */
};

/* Returns the volume fraction of the ball in a cell, from 4 x 4 x 4 samples. */
static double fraction_of_ball(const double* lower, double width)
{
  int inside = 0;
  for (int s = 0; s < 64; ++s)
  {
    const int at[3] = { s % 4, s / 4 % 4, s / 16 };
    double distance = 0;
    for (int a = 0; a < 3; ++a)
    {
      const double x = lower[a] + width * (at[a] + 0.5) / 4 - 0.5;
      distance += x * x;
    }
    inside += distance < 0.35 * 0.35;
  }
  return inside / 64.0;
}

/* Returns the fractions of a block's n x n x n cells. Sets *mixed to the number of mixed cells. */
static double* make_fractions(const double* box, int n, int* mixed)
{
  double* vfrac = malloc(sizeof(double) * n * n * n);
  const double width = (box[3] - box[0]) / n;
  *mixed = 0;
  for (int cell = 0; cell < n * n * n; ++cell)
  {
    const double lower[3] = { box[0] + width * (cell % n), box[1] + width * (cell / n % n),
      box[2] + width * (cell / (n * n)) };
    vfrac[cell] = fraction_of_ball(lower, width);
    *mixed += vfrac[cell] > 0 && vfrac[cell] < 1;
  }
  return vfrac;
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
  int rank = 0, ranks = 1, sculptor = 0, counts[2] = { 0, 0 };
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  double* fields[BLOCKS * BLOCKS * BLOCKS] = { NULL };
  check(sculptor_create(&sculptor), 0);

  /* If the grid changes between steps, call sculptor_clear_blocks and then add all blocks again. */
  for (int b = rank; b < BLOCKS * BLOCKS * BLOCKS; b += ranks)
  {
    const int at[3] = { b % BLOCKS, b / BLOCKS % BLOCKS, b / (BLOCKS * BLOCKS) };
    double box[6];
    for (int a = 0; a < 3; ++a)
    {
      box[a] = (double)at[a] / BLOCKS;
      box[3 + a] = (double)(at[a] + 1) / BLOCKS;
    }
    int mixed = 0, level = 0;
    fields[b] = make_fractions(box, CELLS, &mixed);
    if (mixed > 0) /* the ball's surface: cells half as wide */
    {
      free(fields[b]);
      level = 1;
      fields[b] = make_fractions(box, CELLS << level, &mixed);
    }
    counts[level]++;
    const int intervals[3] = { CELLS << level, CELLS << level, CELLS << level };
    check(sculptor_add_block(sculptor, level, box, intervals), sculptor);
    check(sculptor_add_material(sculptor, "ball", fields[b]), sculptor);
  }
  check(sculptor_make_mesh(sculptor, 0), sculptor);

  int64_t points = 0, elements = 0, all = 0;
  int corners = 0, blocks[2];
  double volume = 0, target = 0;
  check(sculptor_get_counts(sculptor, &points, &elements, &corners), sculptor);
  check(sculptor_get_number(sculptor, "MeshVolume", 0, &volume), sculptor);
  check(sculptor_get_number(sculptor, "TargetVolume", 0, &target), sculptor);
  MPI_Reduce(&elements, &all, 1, MPI_INT64_T, MPI_SUM, 0, MPI_COMM_WORLD);
  MPI_Reduce(counts, blocks, 2, MPI_INT, MPI_SUM, 0, MPI_COMM_WORLD);
  if (rank == 0)
  {
    printf("%d coarse and %d fine blocks: %ld hexahedra, volume of the ball %.6f of %.6f\n",
      blocks[0], blocks[1], (long)all, volume, target);
  }
  check(sculptor_delete(sculptor), sculptor);
  for (int b = 0; b < BLOCKS * BLOCKS * BLOCKS; ++b)
  {
    free(fields[b]);
  }
  MPI_Finalize();
  return 0;
}
