/* Meshes half a sphere from C with only the ten calls of Sculptor's report, first as hexahedra,
 * then as tetrahedra. Runs on any number of ranks; each rank owns a box of the grid. Prints the
 * numbers of nodes and elements and the volume, and writes no file. half_sphere.cpp and
 * half_sphere.f90 are the same program in C++ and Fortran.
 *
 *   mpicc half_sphere.c $(pkg-config --cflags --libs sculptor) -o half_sphere
 *   mpiexec -n 4 ./half_sphere
 */
#include <CMLPSculptor.c.h>

#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The whole grid has cubic cells of width 1. The sphere's centre lies on its lower z side. */
static const int cells[3] = { 20, 20, 10 };
static const double centre[3] = { 10, 10, 0 }, radius = 7;

/* Returns the volume fraction of the sphere in cell (i,j,k), from 4 x 4 x 4 samples. */
static double fraction_of_sphere(int i, int j, int k)
{
  int inside = 0;
  for (int s = 0; s < 64; ++s)
  {
    const double x = i + (s % 4 + 0.5) / 4 - centre[0];
    const double y = j + (s / 4 % 4 + 0.5) / 4 - centre[1];
    const double z = k + (s / 16 + 0.5) / 4 - centre[2];
    inside += x * x + y * y + z * z < radius * radius;
  }
  return inside / 64.0;
}

static void require(int is_well, const char* what)
{
  if (!is_well)
  {
    fprintf(stderr, "half_sphere: %s failed\n", what);
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
}

/* Divides the grid into one box per rank. Sets the range of cells of this rank, [lower, upper). */
static void divide_grid(MPI_Comm* boxes, int* lower, int* upper)
{
  int ranks, rank, layout[3] = { 0, 0, 0 }, place[3];
  const int periodic[3] = { 0, 0, 0 };
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  MPI_Dims_create(ranks, 3, layout);
  MPI_Cart_create(MPI_COMM_WORLD, 3, layout, periodic, 0, boxes);
  MPI_Comm_rank(*boxes, &rank);
  MPI_Cart_coords(*boxes, rank, 3, place);
  for (int a = 0; a < 3; ++a)
  {
    lower[a] = cells[a] * place[a] / layout[a];
    upper[a] = cells[a] * (place[a] + 1) / layout[a];
  }
}

/* Returns the rank of the adjacent box, -1 where the grid ends. */
static int neighbor(MPI_Comm boxes, int axis, int step)
{
  int from, to;
  MPI_Cart_shift(boxes, axis, step, &from, &to);
  return to == MPI_PROC_NULL ? -1 : to;
}

static int compare_nodes(const void* left, const void* right)
{
  const double *a = left, *b = right;
  for (int i = 0; i < 3; ++i)
  {
    if (a[i] != b[i])
    {
      return a[i] < b[i] ? -1 : 1;
    }
  }
  return 0;
}

/* Returns the number of nodes of all ranks, shared nodes counted once; valid on rank 0. */
static int count_nodes(int nodes, const double* coords)
{
  int ranks, all = 0, different = 0, count = 3 * nodes;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  int* counts = malloc(sizeof(int) * ranks);
  int* first = malloc(sizeof(int) * ranks);
  MPI_Allgather(&count, 1, MPI_INT, counts, 1, MPI_INT, MPI_COMM_WORLD);
  for (int r = 0; r < ranks; ++r)
  {
    first[r] = all;
    all += counts[r];
  }
  double* gathered = malloc(sizeof(double) * all);
  MPI_Gatherv(coords, count, MPI_DOUBLE, gathered, counts, first, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  qsort(gathered, all / 3, 3 * sizeof(double), compare_nodes);
  for (int n = 0; n < all; n += 3)
  {
    different += n == 0 || compare_nodes(gathered + n - 3, gathered + n) != 0;
  }
  free(gathered);
  free(first);
  free(counts);
  return different;
}

static double volume_of_tet(const double* a, const double* b, const double* c, const double* d)
{
  const double u[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const double v[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  const double w[3] = { d[0] - a[0], d[1] - a[1], d[2] - a[2] };
  return (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
           u[2] * (v[0] * w[1] - v[1] * w[0])) /
    6;
}

/* Returns the volume of all elements of all ranks, valid on rank 0. Divides a hexahedron into six
 * tetrahedra around its diagonal. */
static double add_volumes(int elements, int corners, const double* coords, const int* nodes)
{
  const int around[7] = { 1, 2, 3, 7, 4, 5, 1 };
  double mine = 0, all = 0;
  for (const int* n = nodes; n < nodes + corners * elements; n += corners)
  {
    const double* corner[8];
    for (int c = 0; c < corners; ++c)
    {
      corner[c] = coords + 3 * n[c];
    }
    if (corners == 4)
    {
      mine += volume_of_tet(corner[0], corner[1], corner[2], corner[3]);
    }
    for (int t = 0; corners == 8 && t < 6; ++t)
    {
      mine += volume_of_tet(corner[0], corner[around[t]], corner[around[t + 1]], corner[6]);
    }
  }
  MPI_Reduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
  return all;
}

/* Checks that the mesh is one fragment, with the same elements. */
static void check_fragment(int handle, int tet_mesh, int nodes, int elements, const int* expected)
{
  int num_nodes, num_hexes, num_tets;
  require(c_get_num_fragments(handle) == 1, "c_get_num_fragments");
  require(c_get_fragment_totals(handle, 1, &num_nodes, &num_hexes, &num_tets) == 0,
    "c_get_fragment_totals");
  require(num_nodes == nodes && num_hexes + num_tets == elements, "the count of the fragment");
  const size_t size = sizeof(int) * (tet_mesh ? 4 : 8) * elements;
  double* coords = malloc(sizeof(double) * 3 * nodes);
  int* own = malloc(size);
  require((tet_mesh ? c_get_fragment_tets : c_get_fragment_hexes)(handle, 1, coords, own) == 0,
    "c_get_fragment_hexes or _tets");
  require(elements == 0 || memcmp(own, expected, size) == 0, "the comparison of the fragment");
  free(own);
  free(coords);
}

/* Gets the mesh and prints its totals over all ranks. */
static void report(int handle, int tet_mesh)
{
  const int corners = tet_mesh ? 4 : 8;
  int rank, nodes, hexes, tets, all = 0;
  c_get_free_totals(handle, &nodes, &hexes, &tets);
  const int elements = tet_mesh ? tets : hexes;
  double* coords = malloc(sizeof(double) * 3 * nodes);
  int* connectivity = malloc(sizeof(int) * corners * elements);
  require((tet_mesh ? c_get_free_tets : c_get_free_hexes)(handle, coords, connectivity) == 0,
    "c_get_free_hexes or _tets");
  check_fragment(handle, tet_mesh, nodes, elements, connectivity);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Reduce(&elements, &all, 1, MPI_INT, MPI_SUM, 0, MPI_COMM_WORLD);
  const int different = count_nodes(nodes, coords);
  const double volume = add_volumes(elements, corners, coords, connectivity);
  if (rank == 0)
  {
    printf("%d nodes, %d %s, volume %.3f\n", different, all, tet_mesh ? "tets" : "hexes", volume);
  }
  free(connectivity);
  free(coords);
}

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  MPI_Comm boxes;
  int lower[3], upper[3], size[3], cell = 0;
  divide_grid(&boxes, lower, upper);
  for (int a = 0; a < 3; ++a)
  {
    size[a] = upper[a] - lower[a];
  }
  double* vfrac = malloc(sizeof(double) * size[0] * size[1] * size[2]);
  for (int k = lower[2]; k < upper[2]; ++k)
  {
    for (int j = lower[1]; j < upper[1]; ++j)
    {
      for (int i = lower[0]; i < upper[0]; ++i)
      {
        vfrac[cell++] = fraction_of_sphere(i, j, k);
      }
    }
  }
  const int handle = c_create_cml_psculptor();
  require(handle != 0, "c_create_cml_psculptor");
  for (int tet_mesh = 0; tet_mesh < 2; ++tet_mesh)
  {
    require(c_mesh_from_data(handle, lower[0], lower[1], lower[2], upper[0], upper[1], upper[2],
              size[0], size[1], size[2], vfrac, neighbor(boxes, 0, 1), neighbor(boxes, 0, -1),
              neighbor(boxes, 1, 1), neighbor(boxes, 1, -1), neighbor(boxes, 2, 1),
              neighbor(boxes, 2, -1), 0, 0, 1, tet_mesh) == 0,
      "c_mesh_from_data");
    report(handle, tet_mesh);
  }
  c_delete_cml_psculptor(handle);
  free(vfrac);
  MPI_Comm_free(&boxes);
  MPI_Finalize();
  return 0;
}
