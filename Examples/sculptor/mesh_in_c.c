/* Meshes a ball on a plate as tetrahedra from C and transfers the temperature of the cells to the
 * elements. A drop that fills a tenth of a cell becomes a particle. Runs on any number of ranks;
 * each rank owns a slab of the grid. Prints volumes, the size of the contact surface and the
 * highest temperature, and writes no file. mesh_in_fortran.f90 is the same program in Fortran.
 *
 *   mpicc mesh_in_c.c $(pkg-config --cflags --libs sculptor) -o mesh_in_c
 *   mpiexec -n 2 ./mesh_in_c
 */
#include <Sculptor.h>

#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

enum
{
  N = 20 /* number of cells along each axis of the whole grid; they are cubes of width 1 */
};

/* Values of this rank's cells. */
typedef struct
{
  double *ball, *plate, *temperature;
} Fields;

/* Returns the volume fraction of the ball in cell (i,j,k), from 4 x 4 x 4 samples. */
static double fraction_of_ball(int i, int j, int k)
{
  int inside = 0;
  for (int s = 0; s < 64; ++s)
  {
    const double x = i + (s % 4 + 0.5) / 4 - 10;
    const double y = j + (s / 4 % 4 + 0.5) / 4 - 10;
    const double z = k + (s / 16 + 0.5) / 4 - 11;
    inside += x * x + y * y + z * z < 36;
  }
  return inside / 64.0;
}

/* Returns the fields on the layers [first, last). */
static Fields make_fields(int first, int last)
{
  const size_t size = sizeof(double) * N * N * (last - first);
  const Fields fields = { malloc(size), malloc(size), malloc(size) };
  for (int cell = 0; cell < N * N * (last - first); ++cell)
  {
    const int k = first + cell / (N * N);
    fields.ball[cell] = fraction_of_ball(cell % N, cell / N % N, k);
    fields.plate[cell] = k < 6 ? 1 - fields.ball[cell] : 0;
    fields.temperature[cell] = 301 + k;
  }
  if (last == N)
  {
    fields.ball[N * N * (last - first) - 1] = 0.1; /* the drop */
  }
  return fields;
}

static void check(int code, int sculptor)
{
  if (code != SCULPTOR_OK)
  {
    fprintf(stderr, "sculptor: error %d: %s\n", code, sculptor_error_text(sculptor));
    MPI_Abort(MPI_COMM_WORLD, code);
  }
}

/* Returns the number of this rank's triangles between ball and plate. */
static int count_contact(int s)
{
  int64_t triangles;
  int corners, surfaces, columns, count = 0;
  const int64_t* points;
  const int *ids, *pairs;
  check(sculptor_get_surfaces(s, &triangles, &corners, &points, &ids), s);
  check(sculptor_get_bounds(s, "SurfaceMaterials", &surfaces, &columns, &pairs), s);
  for (int64_t t = 0; t < triangles; ++t)
  {
    const int* pair = pairs + 2 * (ids[t] - 1);
    count += pair[0] == 1 && pair[1] == 2;
  }
  return count;
}

/* Adds the number and the volume of this rank's particles to sums. */
static void add_particles(int s, double* sums)
{
  int64_t particles;
  const int64_t* ids;
  const int* materials;
  const double *positions, *radii, *volumes, *masses;
  check(
    sculptor_get_particles(s, &particles, &positions, &ids, &materials, &radii, &volumes, &masses),
    s);
  for (int64_t p = 0; p < particles; ++p)
  {
    sums[0] += 1;
    sums[1] += volumes[p];
  }
}

/* Prints the totals of the mesh over all ranks. */
static void report(int s, int rank)
{
  int64_t points, elements;
  int corners, components, counts[3] = { 0, 0, count_contact(s) }, totals[3];
  const int* materials;
  const double* temperature;
  double volumes[2], mine = 0, hottest, drops[2] = { 0, 0 }, all_drops[2];
  check(sculptor_get_counts(s, &points, &elements, &corners), s);
  check(sculptor_get_materials(s, &materials), s);
  check(sculptor_get_state(s, "temperature", &components, &temperature), s);
  for (int64_t e = 0; e < elements; ++e)
  {
    ++counts[materials[e] - 1];
    mine = temperature[e] > mine ? temperature[e] : mine;
  }
  for (int m = 0; m < 2; ++m)
  {
    check(sculptor_get_number(s, "MeshVolume", m, &volumes[m]), s);
  }
  MPI_Reduce(counts, totals, 3, MPI_INT, MPI_SUM, 0, MPI_COMM_WORLD);
  add_particles(s, drops);
  MPI_Reduce(drops, all_drops, 2, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
  MPI_Reduce(&mine, &hottest, 1, MPI_DOUBLE, MPI_MAX, 0, MPI_COMM_WORLD);
  if (rank == 0)
  {
    printf("ball: %d tetrahedra, volume %.3f\n", totals[0], volumes[0]);
    printf("plate: %d tetrahedra, volume %.3f\n", totals[1], volumes[1]);
    printf("contact: %d triangles\n", totals[2]);
    printf("hottest: %.1f\n", hottest);
    printf("particles: %.0f, volume %.3f\n", all_drops[0], all_drops[1]);
  }
}

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  int rank, ranks, s = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const int first = N * rank / ranks, last = N * (rank + 1) / ranks;
  const Fields fields = make_fields(first, last);
  const double box[6] = { 0, 0, first, N, N, last };
  const int intervals[3] = { N, N, last - first };
  const int neighbours[6] = { -1, -1, -1, -1, rank - 1, rank + 1 < ranks ? rank + 1 : -1 };

  check(sculptor_create(&s), 0);
  check(sculptor_set_communicator(s, MPI_Comm_c2f(MPI_COMM_WORLD)), s);
  check(sculptor_set_option(s, "Method", "Lattice"), s);
  check(sculptor_set_option(s, "UnmeshedMaterial", "Particles"), s);
  check(sculptor_set_box(s, box, intervals), s);
  check(sculptor_set_neighbours(s, neighbours), s);
  check(sculptor_add_material(s, "ball", fields.ball), s);
  check(sculptor_add_material(s, "plate", fields.plate), s);
  check(sculptor_add_state(s, "temperature", 1, fields.temperature), s);
  check(sculptor_make_mesh(s, 1), s);
  report(s, rank);
  check(sculptor_delete(s), 0);
  free(fields.ball);
  free(fields.plate);
  free(fields.temperature);
  MPI_Finalize();
  return 0;
}
