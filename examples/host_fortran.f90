! SPDX-License-Identifier: BSD-3-Clause
! A host with (3,n) arrays: a chain of bonded spheres, by VTI-2.                        host_fortran chain/bodies.csv
program host_fortran
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use, intrinsic :: iso_fortran_env, only: error_unit
    use vti
    implicit none
    integer(c_int64_t), parameter :: n = 10, steps = 5120
    real(c_double), parameter :: h = 1.0_c_double/512
    real(c_double), dimension(3, n), target :: x, v, force, alpha, omega, moment
    real(c_double), target :: mass(n), inertia(n), rest(4, n - 1), stiffness(3) = [10, 200, 200]
    integer(c_int64_t), target :: pair(2, n - 1)
    integer(c_int64_t) :: i, k
    type(vti_bodies) :: bodies
    type(vti_bonds), target :: bonds
    type(vti_effect) :: binder
    type(vti_stepper) :: method
    type(vti_fault) :: fault

    call read_spheres()
    bodies = vti_bodies_none(n)
    bodies%x = vti_view_columns(x)
    bodies%v = vti_view_columns(v)
    bodies%force = vti_view_columns(force)
    bodies%alpha = vti_view_columns(alpha)
    bodies%omega = vti_view_columns(omega)
    bodies%moment = vti_view_columns(moment)
    bodies%mass = vti_scalars_array(mass)
    bodies%inertia = vti_scalars_array(inertia)
    call must(vti_bodies_check_values(bodies, fault))

    pair = reshape([(i, i + 1, i=1, n - 1)], [2, int(n) - 1])
    call must(vti_bonds_rest(pair, bodies, rest, fault))
    bonds = vti_bonds_between(pair, rest)
    bonds%moment = vti_scalars_one(stiffness(1))
    bonds%axial = vti_scalars_one(stiffness(2))
    bonds%shear = vti_scalars_one(stiffness(3))
    call must(vti_bonds_check(bonds, n, fault))
    binder = vti_bonds_effect(bonds)

    method = vti_stepper_find('vti2')
    call forces() ! prime: the first kick needs them
    do k = 1, steps
        call must(vti_step_begin(method, h, bodies, fault))
        call forces() ! at the new positions and attitudes
        call must(vti_step_finish(method, h, bodies))
    end do
    do i = 1, n
        print '(12es25.16e3)', x(:, i), v(:, i), alpha(:, i), omega(:, i)
    end do

contains
    !> This host's forces: those of the library's binder. A host with forces of its own computes them here.
    subroutine forces()
        call must(vti_apply([binder], bodies))
    end subroutine

    subroutine read_spheres()
        character(len=256) :: path
        integer :: unit, failed
        path = 'chain/bodies.csv'
        if (command_argument_count() > 0) call get_command_argument(1, path)
        open (newunit=unit, file=trim(path), status='old', action='read', iostat=failed)
        if (failed /= 0) then
            write (error_unit, '(2a)') trim(path), &
                ': cannot be opened; call this in the folder examples, or with the path of the table'
            stop 1
        end if
        read (unit, *)
        do i = 1, n
            read (unit, *) x(:, i), v(:, i), alpha(:, i), omega(:, i), mass(i), inertia(i)
        end do
        close (unit)
    end subroutine

    subroutine must(status)
        integer(c_int), intent(in) :: status
        if (status == VTI_OK) return
        write (error_unit, '(a, i0, 3a, g0, 2a)') 'sphere ', fault%body, ', ', vti_quantity_text(fault%quantity), ' ', &
            fault%value, ': ', vti_status_text(status)
        stop 1
    end subroutine
end program
