! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_f77 -- the library for codes that have no modules: external procedures, called with an implicit interface.
!>
!>     M           number of a stepper, from VTISTP
!>     N, LB, LC   bodies; doubles from one body to the next, and from one component of a vector to the next, the
!>                 same in all arrays of a call: X(3,N) has LB = 3, LC = 1; X(NMAX,3), or X(NMAX), Y(NMAX), Z(NMAX)
!>                 side by side in a COMMON block, has LB = 1, LC = NMAX. X(I,1) in place of X begins at body I.
!>     X V F       positions, velocities, forces
!>     A W T       attitudes (rescaled Rodrigues vectors), angular velocities, moments
!>     NM RM       masses: one for all (NM = 1), or N of them;  NI RI  the same of moments of inertia; or, for bodies
!>                 that are not spheres, NI = 3*N: then RI is laid out as X and holds the three moments of each body
!>                 about its own axes, and W its angular momentum L. Not for VTIKEN; VTIKCK kicks L by RM = 1, and
!>                 VTITRN and VTITRQ turn spheres
!>     IBODY VALUE the body that is refused, from 1 (0: none), and the value that is wrong; VTIQTY says of what
!>     IER         0, or a negative status, and then nothing has changed; VTITXT says what it means
!>
!> Reals are DOUBLE PRECISION, integers default INTEGERs. Names have six letters and no type matters that is not in this
!> list. Nothing is kept between calls: every call may be made from any thread on bodies that no other touches.

! ---- steppers and texts ---------------------------------------------------------------------------------------------

!> M = number of the stepper NAME; 0, and IER, if there is none.
subroutine vtistp(name, m, ier)
    use vti
    implicit none
    character(len=*), intent(in) :: name
    integer, intent(out) :: m, ier
    type(vti_stepper) :: method
    integer :: k
    m = 0
    ier = VTI_E_STEPPER
    do k = 1, int(vti_stepper_count())
        method = vti_stepper_at(int(k, kind(method%stages)))
        if (vti_text(method%name) == name) m = k
    end do
    if (m > 0) ier = VTI_OK
end subroutine

!> TEXT = one sentence for the status IER, cut off at its length; 400 characters have room for any.
subroutine vtitxt(ier, text)
    use vti
    implicit none
    integer, intent(in) :: ier
    character(len=*), intent(out) :: text
    text = vti_status_text(int(ier, kind(VTI_OK)))
end subroutine

!> TEXT = version of the library that is running.
subroutine vtiver(text)
    use vti
    implicit none
    character(len=*), intent(out) :: text
    text = vti_version()
end subroutine

! ---- one step: VTIBEG, forces, VTIFIN -------------------------------------------------------------------------------

!> Checks everything that can be checked, masses and inertias too: once, before the first step.
subroutine vtichk(n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, ibody, value, ier)
    use vti_f77_arrays
    use vti, only: vti_fault
    implicit none
    integer, intent(in) :: n, lb, lc, nm, ni
    double precision, intent(in) :: x(*), v(*), f(*), a(*), w(*), t(*), rm(*), ri(*)
    integer, intent(out) :: ibody, ier
    double precision, intent(out) :: value
    type(vti_fault) :: fault
    call arrays_check(n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, fault, ier)
    call give_fault(fault, ibody, value)
end subroutine

!> NAME = which of its arrays VTICHK refuses, as vti_quantity_text has it: 'x', 'v', 'force', 'alpha' (A), 'omega' (W),
!> 'moment' (T), 'mass' (RM), 'inertia' (RI), 'moments' and 'spin' (RI and W of NI = 3*N); of two that are the same
!> memory, the one that this list has later (RM and RI, which are only read, may be any). LB and LC are those of all
!> arrays: if they are wrong, 'x' is. 'value' if VTICHK refuses none of them.
subroutine vtiqty(n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, name)
    use vti_f77_arrays
    use vti, only: vti_fault, vti_quantity_text
    implicit none
    integer, intent(in) :: n, lb, lc, nm, ni
    double precision, intent(in) :: x(*), v(*), f(*), a(*), w(*), t(*), rm(*), ri(*)
    character(len=*), intent(out) :: name
    type(vti_fault) :: fault
    integer :: ier
    call arrays_check(n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, fault, ier)
    name = vti_quantity_text(fault%quantity)
end subroutine

!> Kick and drift of all bodies, or of none. F and T are those at X and A: before the first step, compute them.
subroutine vtibeg(m, h, n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, ibody, value, ier)
    implicit none
    integer, intent(in) :: m, n, lb, lc, nm, ni
    double precision, intent(in) :: h, f(*), t(*), rm(*), ri(*)
    double precision, intent(inout) :: x(*), v(*), a(*), w(*)
    integer, intent(out) :: ibody, ier
    double precision, intent(out) :: value
    external :: vtistg
    call vtistg(m, 0, h, n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, ibody, value, ier)
end subroutine

!> Stage K of a stepper of more than one; VTIBEG is stage 0.
subroutine vtistg(m, k, h, n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, ibody, value, ier)
    use vti_f77_arrays
    use vti, only: vti_fault
    implicit none
    integer, intent(in) :: m, k, n, lb, lc, nm, ni
    double precision, intent(in) :: h, f(*), t(*), rm(*), ri(*)
    double precision, intent(inout) :: x(*), v(*), a(*), w(*)
    integer, intent(out) :: ibody, ier
    double precision, intent(out) :: value
    type(vti_fault) :: fault
    call arrays_stage(m, k, h, n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, fault, ier)
    call give_fault(fault, ibody, value)
end subroutine

!> The last kick, with the forces at the new X and A.
subroutine vtifin(m, h, n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, ier)
    use vti_f77_arrays
    implicit none
    integer, intent(in) :: m, n, lb, lc, nm, ni
    double precision, intent(in) :: h, f(*), t(*), rm(*), ri(*)
    double precision, intent(inout) :: x(*), v(*), a(*), w(*)
    integer, intent(out) :: ier
    call arrays_finish(m, h, n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, ier)
end subroutine

!> Moves V and W to where the stepper keeps them; does nothing but for 'vti3-leapfrog'.
subroutine vtista(m, h, n, lb, lc, v, f, w, t, nm, rm, ni, ri, ier)
    use vti_f77_arrays
    implicit none
    integer, intent(in) :: m, n, lb, lc, nm, ni
    double precision, intent(in) :: h, f(*), t(*), rm(*), ri(*)
    double precision, intent(inout) :: v(*), w(*)
    integer, intent(out) :: ier
    call arrays_shift(m, -1, h, n, lb, lc, v, f, w, t, nm, rm, ni, ri, ier)
end subroutine

!> Moves V and W back to the time of X and A.
subroutine vtisyn(m, h, n, lb, lc, v, f, w, t, nm, rm, ni, ri, ier)
    use vti_f77_arrays
    implicit none
    integer, intent(in) :: m, n, lb, lc, nm, ni
    double precision, intent(in) :: h, f(*), t(*), rm(*), ri(*)
    double precision, intent(inout) :: v(*), w(*)
    integer, intent(out) :: ier
    call arrays_shift(m, 1, h, n, lb, lc, v, f, w, t, nm, rm, ni, ri, ier)
end subroutine

! ---- the primitives, for codes in which nothing turns, nothing translates, or that write their own step -------------

!> V = V + TIME F/RM; with W, T and RI in place of V, F and RM the same for angular velocities.
subroutine vtikck(time, n, lb, lc, v, f, nm, rm, ier)
    use vti_f77_arrays
    implicit none
    integer, intent(in) :: n, lb, lc, nm
    double precision, intent(in) :: time, f(*), rm(*)
    double precision, intent(inout) :: v(*)
    integer, intent(out) :: ier
    call arrays_kick(time, n, lb, lc, v, f, nm, rm, ier)
end subroutine

!> X = X + TIME V.
subroutine vtidrf(time, n, lb, lc, x, v, ier)
    use vti_f77_arrays
    implicit none
    integer, intent(in) :: n, lb, lc
    double precision, intent(in) :: time, v(*)
    double precision, intent(inout) :: x(*)
    integer, intent(out) :: ier
    call arrays_drift(time, n, lb, lc, x, v, ier)
end subroutine

!> Turns attitudes by W for TIME, as stepper M does.
subroutine vtitrn(m, time, n, lb, lc, a, w, ibody, value, ier)
    use vti_f77_arrays
    use vti, only: vti_fault
    implicit none
    integer, intent(in) :: m, n, lb, lc
    double precision, intent(in) :: time, w(*)
    double precision, intent(inout) :: a(*)
    integer, intent(out) :: ibody, ier
    double precision, intent(out) :: value
    type(vti_fault) :: fault
    call arrays_turn(m, time, n, lb, lc, a, w, fault, ier)
    call give_fault(fault, ibody, value)
end subroutine

!> The same for unit quaternions x, y, z, w, which have distances of their own: Q(4,N) has LQ = 4, LCQ = 1.
subroutine vtitrq(m, time, n, lq, lcq, q, lb, lc, w, ibody, value, ier)
    use vti_f77_arrays
    use vti, only: vti_fault
    implicit none
    integer, intent(in) :: m, n, lq, lcq, lb, lc
    double precision, intent(in) :: time, w(*)
    double precision, intent(inout) :: q(*)
    integer, intent(out) :: ibody, ier
    double precision, intent(out) :: value
    type(vti_fault) :: fault
    call arrays_turn_quat(m, time, n, lq, lcq, q, lb, lc, w, fault, ier)
    call give_fault(fault, ibody, value)
end subroutine

! ---- attitudes, for forces that need directions ---------------------------------------------------------------------

!> R(3) = P(3), which is fixed in a body of attitude A(3), as it stands in space.
subroutine vtirot(a, p, r)
    use vti, only: vti_rrv_rotate
    implicit none
    double precision, intent(in) :: a(3), p(3)
    double precision, intent(out) :: r(3)
    r = vti_rrv_rotate(a, p)
end subroutine

!> TH(3) = the rotation vector, of at most a half turn, that takes attitude B(3) to A(3).
subroutine vtirel(a, b, th)
    use vti, only: vti_rrv_relative, vti_rrv_to_rotvec
    implicit none
    double precision, intent(in) :: a(3), b(3)
    double precision, intent(out) :: th(3)
    th = vti_rrv_to_rotvec(vti_rrv_relative(a, b))
end subroutine

! ---- measures -------------------------------------------------------------------------------------------------------

!> E = sum of RM |V|^2/2; with W and RI the energy of rotation.
subroutine vtiken(n, lb, lc, v, nm, rm, e, ier)
    use vti_f77_arrays
    implicit none
    integer, intent(in) :: n, lb, lc, nm
    double precision, intent(in) :: v(*), rm(*)
    double precision, intent(out) :: e
    integer, intent(out) :: ier
    call arrays_kinetic(n, lb, lc, v, nm, rm, e, ier)
end subroutine

!> P(3) = sum of RM V, SL(3) = sum of (X - ABOUT) x RM V + RI W, or W of NI = 3*N.
subroutine vtimom(n, lb, lc, x, v, w, nm, rm, ni, ri, about, p, sl, ier)
    use vti_f77_arrays
    implicit none
    integer, intent(in) :: n, lb, lc, nm, ni
    double precision, intent(in) :: x(*), v(*), w(*), rm(*), ri(*), about(3)
    double precision, intent(out) :: p(3), sl(3)
    integer, intent(out) :: ier
    call arrays_momenta(n, lb, lc, x, v, w, nm, rm, ni, ri, about, p, sl, ier)
end subroutine

! ---- bonds: NB pairs IPAIR(2,NB), rest vectors REST(4,NB), energies SK = K of moment, axial and shear (0: absent) ----
! ---- IFORM: 1 objective (the usual), 2 quartic, 3 as printed; IBOND is the bond that is refused ----------------------

!> REST of the pairs at the positions X.
subroutine vtibrs(nb, ipair, n, lb, lc, x, rest, ibond, value, ier)
    use vti_f77_bonds
    use vti_f77_arrays, only: give_fault
    use vti, only: vti_fault
    implicit none
    integer, intent(in) :: nb, ipair(2, *), n, lb, lc
    double precision, intent(in) :: x(*)
    double precision, intent(inout) :: rest(4, *)
    integer, intent(out) :: ibond, ier
    double precision, intent(out) :: value
    type(vti_fault) :: fault
    call arrays_rest(nb, ipair, n, lb, lc, x, rest, fault, ier)
    call give_fault(fault, ibond, value)
end subroutine

!> Adds the bonds' forces to F and their moments to T.
subroutine vtibnd(nb, ipair, rest, sk, iform, n, lb, lc, x, a, f, t, ibond, ier)
    use vti_f77_bonds
    implicit none
    integer, intent(in) :: nb, ipair(2, *), iform, n, lb, lc
    double precision, intent(in) :: rest(4, *), sk(3), x(*), a(*)
    double precision, intent(inout) :: f(*), t(*)
    integer, intent(out) :: ibond, ier
    call arrays_bonds(nb, ipair, rest, sk, iform, n, lb, lc, x, a, f, t, ibond, ier)
end subroutine

!> E(3) = energies of moment, axial and shear.
subroutine vtiben(nb, ipair, rest, sk, iform, n, lb, lc, x, a, e, ibond, ier)
    use vti_f77_bonds
    implicit none
    integer, intent(in) :: nb, ipair(2, *), iform, n, lb, lc
    double precision, intent(in) :: rest(4, *), sk(3), x(*), a(*)
    double precision, intent(out) :: e(3)
    integer, intent(out) :: ibond, ier
    call arrays_bond_energies(nb, ipair, rest, sk, iform, n, lb, lc, x, a, e, ibond, ier)
end subroutine
