! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_multisteps -- multistep methods: one force evaluation a step. Part of module vti; contracts are those of
!> vti_multistep.h.
module vti_multisteps
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_int, c_int64_t, c_loc, &
        c_null_char, c_null_ptr, c_ptr
    use vti_steps, only: from_one
    use vti_types
    implicit none
    private
    public :: vti_multistep_find, vti_multistep_at, vti_multistep_count, vti_multistep_record, vti_multistep_predict, &
        vti_multistep_correct, vti_multistep_error, vti_multistep_touch

    interface
        !> Number of methods that vti_multistep_at knows.
        function vti_multistep_count() result(n) bind(c)
            import :: c_int64_t
            integer(c_int64_t) :: n
        end function

        !> Remembers the accelerations by the force and moment of now: at the start and after any jump once before each
        !> of K - 1 steps of h by another method, and once after the last; where its steps end with a drift (srkn14),
        !> forces are computed again first.
        function vti_multistep_record(past, bodies) result(status) bind(c)
            import :: c_int, vti_bodies, vti_past
            type(vti_past), intent(inout) :: past
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function

        !> After the forces that follow vti_multistep_predict: corrects, and remembers.
        function vti_multistep_correct(method, h, past, bodies) result(status) bind(c)
            import :: c_double, c_int, vti_bodies, vti_multistep, vti_past
            type(vti_multistep), intent(in) :: method
            real(c_double), value :: h
            type(vti_past), intent(inout) :: past
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function

        !> Between the forces and vti_multistep_correct: by how much v and Omega are about to be corrected, at most.
        function vti_multistep_error(method, h, past, bodies, velocity, omega) result(status) bind(c)
            import :: c_double, c_int, vti_bodies, vti_multistep, vti_past
            type(vti_multistep), intent(in) :: method
            real(c_double), value :: h
            type(vti_past), intent(in) :: past
            type(vti_bodies), intent(in) :: bodies
            real(c_double), intent(out) :: velocity, omega
            integer(c_int) :: status
        end function

        function c_multistep_find(name) result(method) bind(c, name='vti_multistep_find')
            import :: c_char, c_ptr
            character(kind=c_char), intent(in) :: name(*)
            type(c_ptr) :: method
        end function

        function c_multistep_at(index) result(method) bind(c, name='vti_multistep_at')
            import :: c_int64_t, c_ptr
            integer(c_int64_t), value :: index
            type(c_ptr) :: method
        end function

        function c_multistep_predict(method, h, past, bodies, fault) result(status) &
            bind(c, name='vti_multistep_predict')
            import :: c_double, c_int, vti_bodies, vti_fault, vti_multistep, vti_past
            type(vti_multistep), intent(in) :: method
            real(c_double), value :: h
            type(vti_past), intent(in) :: past
            type(vti_bodies), intent(in) :: bodies
            type(vti_fault), intent(inout) :: fault
            integer(c_int) :: status
        end function

        function c_multistep_touch(h, before, contacts, walls, bodies) result(status) &
            bind(c, name='vti_multistep_touch')
            import :: c_double, c_int, c_ptr, vti_bodies, vti_view
            real(c_double), value :: h
            type(vti_view), intent(in) :: before
            type(c_ptr), value :: contacts, walls
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function
    end interface

contains

    !> By its name in vti_multistep.h ("an4", ...); trailing blanks do not matter. Depth 0, which every call refuses
    !> with VTI_E_STEPPER, if there is none.
    function vti_multistep_find(name) result(method)
        character(len=*), intent(in) :: name
        type(vti_multistep) :: method
        method = value_of(c_multistep_find(trim(name)//c_null_char))
    end function

    !> 1 <= index <= vti_multistep_count().
    function vti_multistep_at(index) result(method)
        integer(c_int64_t), intent(in) :: index
        type(vti_multistep) :: method
        method = value_of(c_multistep_at(index - 1))
    end function

    function value_of(p) result(method)
        type(c_ptr), intent(in) :: p
        type(vti_multistep) :: method
        type(vti_multistep), pointer :: constant
        if (.not. c_associated(p)) return
        call c_f_pointer(p, constant)
        method = constant
    end function

    !> Moves the bodies to where they will be but for the correction. VTI_E_PAST, and nothing is written, while less
    !> than K accelerations are known.
    function vti_multistep_predict(method, h, past, bodies, fault) result(status)
        type(vti_multistep), intent(in) :: method
        real(c_double), intent(in) :: h
        type(vti_past), intent(in) :: past
        type(vti_bodies), intent(in) :: bodies
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_multistep_predict(method, h, past, bodies, found)
        if (present(fault)) fault = from_one(found)
    end function

    !> After vti_multistep_correct: takes off what the step missed of contacts and walls that have begun or ended to
    !> touch in it. before is x as it was at its start.
    function vti_multistep_touch(h, before, bodies, contacts, walls) result(status)
        real(c_double), intent(in) :: h
        type(vti_view), intent(in) :: before
        type(vti_bodies), intent(in) :: bodies
        type(vti_contacts), intent(in), target, optional :: contacts
        type(vti_walls), intent(in), target, optional :: walls
        integer(c_int) :: status
        type(c_ptr) :: place(2)
        place = c_null_ptr
        if (present(contacts)) place(1) = c_loc(contacts)
        if (present(walls)) place(2) = c_loc(walls)
        status = c_multistep_touch(h, before, place(1), place(2), bodies)
    end function

end module
