! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_controls -- steps of variable length: by their errors, or by a density. Part of module vti; contracts are those
!> of vti_control.h.
module vti_controls
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use vti_types
    implicit none
    private
    public :: vti_control_start, vti_control_judge, vti_step_keeps, vti_step_keep, vti_step_undo, vti_density_start, &
        vti_density_next

    interface
        !> For a method with estimates (srkn6, srkn11, srkn14), the error that a step may have, and the first h to try.
        function vti_control_start(method, tolerance, h, control) result(status) bind(c)
            import :: c_double, c_int, vti_control, vti_stepper
            type(vti_stepper), intent(in) :: method
            real(c_double), value :: tolerance, h
            type(vti_control), intent(inout) :: control
            integer(c_int) :: status
        end function

        !> Whether the step of h with these errors is accepted, 1 or 0; control%h is what to try next. Where it is 0,
        !> and where the status is not VTI_OK, vti_step_undo is due.
        function vti_control_judge(control, h, velocity, omega, accepted) result(status) bind(c)
            import :: c_double, c_int, c_int64_t, vti_control
            type(vti_control), intent(inout) :: control
            real(c_double), value :: h, velocity, omega
            integer(c_int64_t), intent(inout) :: accepted
            integer(c_int) :: status
        end function

        !> Numbers that vti_step_keep copies of each body, at most 36; negative for bodies that are refused.
        function vti_step_keeps(bodies) result(width) bind(c)
            import :: c_int64_t, vti_bodies
            type(vti_bodies), intent(in) :: bodies
            integer(c_int64_t) :: width
        end function

        !> Copies the state and the forces of the slice.
        function vti_step_keep(bodies, kept) result(status) bind(c)
            import :: c_int, vti_bodies, vti_kept
            type(vti_bodies), intent(in) :: bodies
            type(vti_kept), intent(in) :: kept
            integer(c_int) :: status
        end function

        !> Puts the slice back as it was then, bit by bit.
        function vti_step_undo(bodies, kept) result(status) bind(c)
            import :: c_int, vti_bodies, vti_kept
            type(vti_bodies), intent(in) :: bodies
            type(vti_kept), intent(in) :: kept
            integer(c_int) :: status
        end function

        !> At the start: epsilon, the wish s for the step, and G = -(1/s) ds/dt.
        function vti_density_start(epsilon, wish, rate, density) result(status) bind(c)
            import :: c_double, c_int, vti_density
            real(c_double), value :: epsilon, wish, rate
            type(vti_density), intent(inout) :: density
            integer(c_int) :: status
        end function

        !> After each step, with G at its end: density%h is the next one.
        function vti_density_next(density, rate) result(status) bind(c)
            import :: c_double, c_int, vti_density
            type(vti_density), intent(inout) :: density
            real(c_double), value :: rate
            integer(c_int) :: status
        end function
    end interface
end module
