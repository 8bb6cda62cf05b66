! Meshes half a sphere from Fortran with only the ten calls of Sculptor's report, first as
! hexahedra, then as tetrahedra. Runs on any number of ranks; each rank owns a box of the grid.
! Prints the numbers of nodes and elements and the volume, and writes no file. half_sphere.c and
! half_sphere.cpp are the same program in C and C++.
!
!   gfortran -c $(pkg-config --variable=includedir sculptor)/cmlpsculptor.f90
!   mpif90 half_sphere.f90 cmlpsculptor.o $(pkg-config --libs sculptor) -o half_sphere
!   mpiexec -n 4 ./half_sphere
program half_sphere
  use, intrinsic :: iso_c_binding
  use mpi
  use cml_psculptor
  implicit none

  ! The whole grid has cubic cells of width 1. The sphere's centre lies on its lower z side.
  integer, parameter :: cells(3) = [20, 20, 10]
  real(c_double), parameter :: centre(3) = [10, 10, 0], radius = 7

  integer :: error, rank, boxes, i, j, k
  integer :: lower(3), upper(3)
  integer(c_int) :: handle, tet_mesh
  real(c_double), allocatable :: vfrac(:, :, :)

  call MPI_Init(error)
  call MPI_Comm_rank(MPI_COMM_WORLD, rank, error)
  call divide_grid()
  allocate (vfrac(lower(1) + 1:upper(1), lower(2) + 1:upper(2), lower(3) + 1:upper(3)))
  do k = lower(3) + 1, upper(3)
    do j = lower(2) + 1, upper(2)
      do i = lower(1) + 1, upper(1)
        vfrac(i, j, k) = fraction_of_sphere([i, j, k] - 1)
      end do
    end do
  end do

  handle = c_create_cml_psculptor()
  call require(handle /= 0, "c_create_cml_psculptor")
  do tet_mesh = 0, 1
    call require(c_mesh_from_data(handle, real(lower(1), c_double), real(lower(2), c_double), &
      real(lower(3), c_double), real(upper(1), c_double), real(upper(2), c_double), &
      real(upper(3), c_double), upper(1) - lower(1), upper(2) - lower(2), upper(3) - lower(3), &
      vfrac, neighbor(0, 1), neighbor(0, -1), neighbor(1, 1), neighbor(1, -1), neighbor(2, 1), &
      neighbor(2, -1), 0, 0, 1, tet_mesh) == 0, "c_mesh_from_data")
    call report()
  end do
  call c_delete_cml_psculptor(handle)
  deallocate (vfrac)
  call MPI_Comm_free(boxes, error)
  call MPI_Finalize(error)

contains

  !> Returns the volume fraction of the sphere in a cell, from 4 x 4 x 4 samples.
  real(c_double) function fraction_of_sphere(cell)
    integer, intent(in) :: cell(3)
    integer :: s, inside
    real(c_double) :: sample(3)
    inside = 0
    do s = 0, 63
      sample = cell + ([mod(s, 4), mod(s / 4, 4), s / 16] + 0.5_c_double) / 4
      if (sum((sample - centre)**2) < radius**2) inside = inside + 1
    end do
    fraction_of_sphere = inside / 64.0_c_double
  end function

  subroutine require(is_well, what)
    logical, intent(in) :: is_well
    character(*), intent(in) :: what
    if (is_well) return
    print '(3a)', 'half_sphere: ', what, ' failed'
    call MPI_Abort(MPI_COMM_WORLD, 1, error)
  end subroutine

  !> Divides the grid into one box per rank. This rank owns the cells lower + 1 to upper.
  subroutine divide_grid()
    integer :: ranks, layout(3), place(3)
    call MPI_Comm_size(MPI_COMM_WORLD, ranks, error)
    layout = 0
    call MPI_Dims_create(ranks, 3, layout, error)
    call MPI_Cart_create(MPI_COMM_WORLD, 3, layout, [.false., .false., .false.], .false., boxes, &
      error)
    call MPI_Cart_coords(boxes, rank, 3, place, error)
    lower = cells * place / layout
    upper = cells * (place + 1) / layout
  end subroutine

  !> Returns the rank of the adjacent box, -1 where the grid ends.
  integer(c_int) function neighbor(axis, step)
    integer, intent(in) :: axis, step
    integer :: from, to
    call MPI_Cart_shift(boxes, axis, step, from, to, error)
    neighbor = merge(-1, to, to == MPI_PROC_NULL)
  end function

  !> Gets the mesh and prints its totals over all ranks.
  subroutine report()
    integer(c_int) :: nodes, hexes, tets
    integer(c_int), allocatable :: connectivity(:, :)
    real(c_double), allocatable :: coords(:, :)
    real(c_double) :: mine, volume
    integer :: different, all
    call c_get_free_totals(handle, nodes, hexes, tets)
    allocate (coords(3, nodes), connectivity(merge(4, 8, tet_mesh == 1), hexes + tets))
    if (tet_mesh == 1) then
      call require(c_get_free_tets(handle, coords, connectivity) == 0, "c_get_free_tets")
    else
      call require(c_get_free_hexes(handle, coords, connectivity) == 0, "c_get_free_hexes")
    end if
    call check_fragment(nodes, connectivity)
    mine = sum_of_volumes(coords, connectivity)
    call MPI_Reduce(mine, volume, 1, MPI_DOUBLE_PRECISION, MPI_SUM, 0, MPI_COMM_WORLD, error)
    call MPI_Reduce(hexes + tets, all, 1, MPI_INTEGER, MPI_SUM, 0, MPI_COMM_WORLD, error)
    different = count_nodes(coords)
    if (rank == 0) print '(i0, a, i0, 1x, 2a, f0.3)', different, ' nodes, ', all, &
      trim(merge('tets ', 'hexes', tet_mesh == 1)), ', volume ', volume
  end subroutine

  !> Checks that the mesh is one fragment, with the same elements.
  subroutine check_fragment(nodes, expected)
    integer(c_int), intent(in) :: nodes, expected(:, :)
    integer(c_int) :: own_nodes, hexes, tets, connectivity(size(expected, 1), size(expected, 2))
    real(c_double) :: coords(3, nodes)
    call require(c_get_num_fragments(handle) == 1, "c_get_num_fragments")
    call require(c_get_fragment_totals(handle, 1, own_nodes, hexes, tets) == 0, &
      "c_get_fragment_totals")
    call require(own_nodes == nodes .and. hexes + tets == size(expected, 2), &
      "the count of the fragment")
    if (tet_mesh == 1) then
      call require(c_get_fragment_tets(handle, 1, coords, connectivity) == 0, "c_get_fragment_tets")
    else
      call require(c_get_fragment_hexes(handle, 1, coords, connectivity) == 0, &
        "c_get_fragment_hexes")
    end if
    call require(all(connectivity == expected), "the comparison of the fragment")
  end subroutine

  !> Returns the number of nodes of all ranks, shared nodes counted once; valid on rank 0. A node is
  !> compared only with nodes of the same cell.
  integer function count_nodes(coords)
    real(c_double), intent(in) :: coords(:, :)
    integer, allocatable :: counts(:), first(:), next(:)
    real(c_double), allocatable :: nodes(:, :)
    integer :: newest(0:cells(1), 0:cells(2), 0:cells(3)), cell(3), ranks, r, n, m
    call MPI_Comm_size(MPI_COMM_WORLD, ranks, error)
    allocate (counts(ranks), first(ranks))
    call MPI_Allgather(size(coords), 1, MPI_INTEGER, counts, 1, MPI_INTEGER, MPI_COMM_WORLD, error)
    do r = 1, ranks
      first(r) = sum(counts(:r - 1))
    end do
    allocate (nodes(3, sum(counts) / 3), next(sum(counts) / 3))
    call MPI_Gatherv(coords, size(coords), MPI_DOUBLE_PRECISION, nodes, counts, first, &
      MPI_DOUBLE_PRECISION, 0, MPI_COMM_WORLD, error)
    count_nodes = 0
    if (rank > 0) return
    newest = 0
    do n = 1, size(nodes, 2)
      cell = int(nodes(:, n))
      m = newest(cell(1), cell(2), cell(3))
      next(n) = m
      do while (m > 0)
        if (all(nodes(:, m) == nodes(:, n))) exit
        m = next(m)
      end do
      if (m == 0) then
        count_nodes = count_nodes + 1
        newest(cell(1), cell(2), cell(3)) = n
      end if
    end do
  end function

  !> Returns the volume of all elements of this rank. Divides a hexahedron into six tetrahedra
  !> around its diagonal.
  real(c_double) function sum_of_volumes(coords, connectivity)
    real(c_double), intent(in) :: coords(:, :)
    integer(c_int), intent(in) :: connectivity(:, :)
    integer, parameter :: around(7) = [2, 3, 4, 8, 5, 6, 2]
    real(c_double) :: corner(3, size(connectivity, 1))
    integer :: e, t
    sum_of_volumes = 0
    do e = 1, size(connectivity, 2)
      corner = coords(:, connectivity(:, e) + 1)
      if (tet_mesh == 1) then
        sum_of_volumes = sum_of_volumes + volume_of_tet(corner)
      else
        do t = 1, 6
          sum_of_volumes = sum_of_volumes + &
            volume_of_tet(corner(:, [1, around(t), around(t + 1), 7]))
        end do
      end if
    end do
  end function

  real(c_double) function volume_of_tet(corner)
    real(c_double), intent(in) :: corner(3, 4)
    real(c_double) :: u(3), v(3), w(3)
    u = corner(:, 2) - corner(:, 1)
    v = corner(:, 3) - corner(:, 1)
    w = corner(:, 4) - corner(:, 1)
    volume_of_tet = dot_product(u, cshift(v, 1) * cshift(w, -1) - cshift(v, -1) * cshift(w, 1)) / 6
  end function

end program half_sphere
