! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_c_bonds -- the functions of vti_binder.h, vti_rupture.h and vti_bond_dashpot.h as C has them; called by module
!> vti_effects_bonds only.
module vti_c_bonds
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_ptr
    use vti_types
    implicit none
    public
    private :: c_double, c_int, c_int64_t, c_ptr

    interface
        function c_bonds_effect(bonds) result(effect) bind(c, name='vti_bonds_effect')
            import :: c_ptr, vti_effect
            type(c_ptr), value :: bonds
            type(vti_effect) :: effect
        end function

        function c_bonds_rest(count, pair, base, x, rest, fault) result(status) bind(c, name='vti_bonds_rest')
            import :: c_double, c_int, c_int64_t, vti_fault, vti_view
            integer(c_int64_t), value :: count, base
            integer(c_int64_t), intent(in) :: pair(2, *)
            type(vti_view), intent(in) :: x
            real(c_double), intent(inout) :: rest(4, *)
            type(vti_fault), intent(out) :: fault
            integer(c_int) :: status
        end function

        function c_bonds_rest_now(count, pair, base, b, rest, turn, fault) result(status) &
                bind(c, name='vti_bonds_rest_now')
            import :: c_double, c_int, c_int64_t, vti_bodies, vti_fault
            integer(c_int64_t), value :: count, base
            integer(c_int64_t), intent(in) :: pair(2, *)
            type(vti_bodies), intent(in) :: b
            real(c_double), intent(inout) :: rest(4, *), turn(4, *)
            type(vti_fault), intent(out) :: fault
            integer(c_int) :: status
        end function

        function c_bonds_check(bonds, n, fault) result(status) bind(c, name='vti_bonds_check')
            import :: c_int, c_int64_t, vti_bonds, vti_fault
            type(vti_bonds), intent(in) :: bonds
            integer(c_int64_t), value :: n
            type(vti_fault), intent(out) :: fault
            integer(c_int) :: status
        end function

        function c_bonds_loads(bonds, bodies, first, last, loads) result(status) bind(c, name='vti_bonds_loads')
            import :: c_double, c_int, c_int64_t, vti_bodies, vti_bonds
            type(vti_bonds), intent(in) :: bonds
            type(vti_bodies), intent(in) :: bodies
            integer(c_int64_t), value :: first, last
            real(c_double), intent(inout) :: loads(*)
            integer(c_int) :: status
        end function

        function c_bonds_measure(bonds, bodies, first, last, measures) result(status) bind(c, name='vti_bonds_measure')
            import :: c_double, c_int, c_int64_t, vti_bodies, vti_bonds
            type(vti_bonds), intent(in) :: bonds
            type(vti_bodies), intent(in) :: bodies
            integer(c_int64_t), value :: first, last
            real(c_double), intent(inout) :: measures(*)
            integer(c_int) :: status
        end function

        function c_bonds_sum(bonds, loads, first, last, bodies) result(status) bind(c, name='vti_bonds_sum')
            import :: c_double, c_int, c_int64_t, vti_bodies, vti_bonds
            type(vti_bonds), intent(in) :: bonds
            real(c_double), intent(in) :: loads(*)
            integer(c_int64_t), value :: first, last
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function

        function c_rupture_effect(rupture) result(effect) bind(c, name='vti_rupture_effect')
            import :: c_ptr, vti_effect
            type(c_ptr), value :: rupture
            type(vti_effect) :: effect
        end function

        function c_rupture_check(rupture, fault) result(status) bind(c, name='vti_rupture_check')
            import :: c_int, vti_fault, vti_rupture
            type(vti_rupture), intent(in) :: rupture
            type(vti_fault), intent(out) :: fault
            integer(c_int) :: status
        end function

        function c_rupture_take_out(rupture, count, id) result(status) bind(c, name='vti_rupture_take_out')
            import :: c_int, c_int64_t, vti_rupture
            type(vti_rupture), intent(in) :: rupture
            integer(c_int64_t), value :: count
            integer(c_int64_t), intent(in) :: id(*)
            integer(c_int) :: status
        end function

        function c_bond_dashpots_effect(dashpots) result(effect) bind(c, name='vti_bond_dashpots_effect')
            import :: c_ptr, vti_effect
            type(c_ptr), value :: dashpots
            type(vti_effect) :: effect
        end function
    end interface
end module
