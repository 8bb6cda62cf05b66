! Meshes a ball on a plate as tetrahedra from Fortran and transfers the temperature of the cells to
! the elements. A drop that fills a tenth of a cell becomes a particle. Runs on any number of
! ranks; each rank owns a slab of the grid. Prints volumes, the size of the contact surface and the
! highest temperature, and writes no file. mesh_in_c.c is the same program in C.
!
!   gfortran -c $(pkg-config --variable=includedir sculptor)/sculptor.f90
!   mpif90 mesh_in_fortran.f90 sculptor.o $(pkg-config --libs sculptor) -o mesh_in_fortran
!   mpiexec -n 2 ./mesh_in_fortran
program mesh_in_fortran
  use, intrinsic :: iso_c_binding
  use mpi
  use sculptor
  implicit none

  integer, parameter :: n = 20 ! number of cells along each axis of the whole grid
  integer :: error, rank, ranks, first, last, i, j, k, components
  integer(c_int) :: s, corners
  integer(c_int64_t) :: points, elements
  real(c_double), allocatable, target :: ball(:, :, :), plate(:, :, :), temperature(:, :, :)
  real(c_double), pointer :: values(:)
  integer(c_int), pointer :: materials(:)
  type(c_ptr) :: pointer
  real(c_double) :: volumes(2), hottest, drops(2)
  integer(c_int) :: neighbours(6), counts(3), totals(3)

  call MPI_Init(error)
  call MPI_Comm_rank(MPI_COMM_WORLD, rank, error)
  call MPI_Comm_size(MPI_COMM_WORLD, ranks, error)
  first = n * rank / ranks
  last = n * (rank + 1) / ranks
  allocate (ball(n, n, last - first), plate(n, n, last - first), temperature(n, n, last - first))
  do k = 1, last - first
    do j = 1, n
      do i = 1, n
        ball(i, j, k) = fraction_of_ball(i, j, first + k)
        plate(i, j, k) = merge(1.0_c_double - ball(i, j, k), 0.0_c_double, first + k <= 6)
        temperature(i, j, k) = 300 + first + k
      end do
    end do
  end do

  if (last == n) ball(n, n, last - first) = 0.1_c_double ! the drop

  neighbours = [-1, -1, -1, -1, rank - 1, merge(rank + 1, -1, rank + 1 < ranks)]
  call check(sculptor_create(s))
  call check(sculptor_set_communicator(s, MPI_COMM_WORLD))
  call check(sculptor_set_option(s, "Method", "Lattice"))
  call check(sculptor_set_option(s, "UnmeshedMaterial", "Particles"))
  call check(sculptor_set_box(s, [0.0_c_double, 0.0_c_double, real(first, c_double), &
    real(n, c_double), real(n, c_double), real(last, c_double)], [n, n, last - first]))
  call check(sculptor_set_neighbours(s, neighbours))
  call check(sculptor_add_material(s, "ball", ball))
  call check(sculptor_add_material(s, "plate", plate))
  call check(sculptor_add_state(s, "temperature", 1, temperature))
  call check(sculptor_make_mesh(s, 1))

  call check(sculptor_get_counts(s, points, elements, corners))
  call check(sculptor_get_materials(s, pointer))
  call c_f_pointer(pointer, materials, [elements])
  call check(sculptor_get_state(s, "temperature", components, pointer))
  call c_f_pointer(pointer, values, [elements])
  do i = 1, 2
    counts(i) = count(materials == i)
    call check(sculptor_get_number(s, "MeshVolume", i - 1, volumes(i)))
  end do
  counts(3) = count_contact()
  hottest = maxval(values)
  drops = sums_of_particles()
  call MPI_Allreduce(counts, totals, 3, MPI_INTEGER, MPI_SUM, MPI_COMM_WORLD, error)
  call MPI_Allreduce(MPI_IN_PLACE, hottest, 1, MPI_DOUBLE_PRECISION, MPI_MAX, MPI_COMM_WORLD, error)
  call MPI_Allreduce(MPI_IN_PLACE, drops, 2, MPI_DOUBLE_PRECISION, MPI_SUM, MPI_COMM_WORLD, error)
  if (rank == 0) then
    print '(a, i0, a, f0.3)', 'ball: ', totals(1), ' tetrahedra, volume ', volumes(1)
    print '(a, i0, a, f0.3)', 'plate: ', totals(2), ' tetrahedra, volume ', volumes(2)
    print '(a, i0, a)', 'contact: ', totals(3), ' triangles'
    print '(a, f0.1)', 'hottest: ', hottest
    print '(a, i0, a, f5.3)', 'particles: ', nint(drops(1)), ', volume ', drops(2)
  end if
  call check(sculptor_delete(s))
  deallocate (ball, plate, temperature)
  call MPI_Finalize(error)

contains

  !> Returns the volume fraction of the ball in a cell, from 4 x 4 x 4 samples.
  real(c_double) function fraction_of_ball(i, j, k)
    integer, intent(in) :: i, j, k
    integer :: a, b, c, inside
    inside = 0
    do c = 1, 4
      do b = 1, 4
        do a = 1, 4
          if ((i - 1 + (a - 0.5) / 4 - 10)**2 + (j - 1 + (b - 0.5) / 4 - 10)**2 + &
            (k - 1 + (c - 0.5) / 4 - 11)**2 < 36) inside = inside + 1
        end do
      end do
    end do
    fraction_of_ball = inside / 64.0_c_double
  end function

  !> Returns the number of this rank's triangles between ball and plate.
  integer function count_contact()
    integer(c_int64_t) :: triangles, t
    integer(c_int) :: surfaces, columns
    type(c_ptr) :: connectivity, ids, table
    integer(c_int), pointer :: surface(:), pairs(:, :)
    call check(sculptor_get_surfaces(s, triangles, corners, connectivity, ids))
    call check(sculptor_get_bounds(s, "SurfaceMaterials", surfaces, columns, table))
    count_contact = 0
    if (triangles == 0) return
    call c_f_pointer(ids, surface, [triangles])
    call c_f_pointer(table, pairs, [columns, surfaces])
    do t = 1, triangles
      if (all(pairs(:, surface(t)) == [1, 2])) count_contact = count_contact + 1
    end do
  end function

  !> Returns the number and the volume of this rank's particles.
  function sums_of_particles() result(sums)
    real(c_double) :: sums(2)
    integer(c_int64_t) :: particles
    type(c_ptr) :: positions, ids, ids_of_materials, radii, parts, masses
    real(c_double), pointer :: own(:)
    call check(sculptor_get_particles(s, particles, positions, ids, ids_of_materials, radii, &
      parts, masses))
    sums = 0
    if (particles == 0) return
    call c_f_pointer(parts, own, [particles])
    sums = [real(particles, c_double), sum(own)]
  end function

  subroutine check(code)
    integer(c_int), intent(in) :: code
    if (code /= sculptor_ok) then
      print '(a, i0, 2a)', 'sculptor: error ', code, ': ', sculptor_error_message(s)
      call MPI_Abort(MPI_COMM_WORLD, code, error)
    end if
  end subroutine

end program
