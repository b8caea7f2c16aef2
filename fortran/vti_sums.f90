! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_sums -- sums that carry their rounding error along, and integrals over time (inline in vti_sum.h, so that
!> this is the one place with formulas of its own: the same, with the same bits). Part of module vti.
module vti_sums
    use, intrinsic :: iso_c_binding, only: c_double
    use vti_types, only: vti_integral, vti_sum
    implicit none
    private
    public :: vti_sum_add, vti_sum_value, vti_integral_add, vti_integral_value

contains

    !> s + x (Neumaier). A new vti_sum is 0.
    pure subroutine vti_sum_add(s, x)
        type(vti_sum), intent(inout) :: s
        real(c_double), intent(in) :: x
        real(c_double) :: t
        t = s%high + x
        if (abs(s%high) >= abs(x)) then
            s%low = s%low + ((s%high - t) + x)
        else
            s%low = s%low + ((x - t) + s%high)
        end if
        s%high = t
    end subroutine

    pure function vti_sum_value(s) result(value)
        type(vti_sum), intent(in) :: s
        real(c_double) :: value
        value = s%high
        if (abs(s%high) <= huge(s%high)) value = s%high + s%low
    end function

    !> The value at the next step, h after the one before (h is not used for the first).
    pure subroutine vti_integral_add(q, h, value)
        type(vti_integral), intent(inout) :: q
        real(c_double), intent(in) :: h, value
        if (q%values > 0) call vti_sum_add(q%sum, 0.5_c_double*h*(q%last + value))
        q%values = q%values + 1
        q%last = value
    end subroutine

    pure function vti_integral_value(q) result(value)
        type(vti_integral), intent(in) :: q
        real(c_double) :: value
        value = vti_sum_value(q%sum)
    end function
end module
