! SPDX-License-Identifier: BSD-3-Clause
!> The procedures without modules: the code of f77_run.f, on COMMON blocks of (NMAX,3) arrays and on (3,N) arrays, is
!> after 1000 steps where the run in C is, to the last bit; and what it does wrong comes back as a status with a text.
program test_f77
    use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use common, only: expect, expect_status, finish, number, same_bits
    use lattice
    use vti
    implicit none

    integer, parameter :: nmax = 256, mbond = 600, chain(3) = [10, 1, 1], block(3) = [7, 6, 5]
    external :: f77row, f77col, f77qua, vtibeg, vtibnd, vtibrs, vtichk, vtidrf, vtifin, vtikck, vtiqty, vtistg, &
        vtistp, vtitrn, vtitrq, vtitxt, vtiver
    double precision :: x(nmax, 3), v(nmax, 3), a(nmax, 3), w(nmax, 3), rm(nmax), ri(nmax), rest(4, mbond)
    integer :: ipair(2, mbond)
    common /state/ x, v, a, w, rm, ri, rest
    common /bonds/ ipair

    call rows('vti2', chain, 'chain')
    call rows('vti3-leapfrog', chain, 'chain')
    call rows('srkn14', chain, 'chain')
    call rows('vti2', block, 'block')
    call columns(chain, 'chain')
    call columns(block, 'block')
    call quaternions()
    call moments()
    call texts()
    call refusals()
    call finish()

contains

    !> Puts a crowd into the COMMON blocks.
    subroutine fill(c)
        type(crowd), intent(in) :: c
        integer :: n
        n = size(c%mass)
        x(:n, :) = transpose(c%x)
        v(:n, :) = transpose(c%v)
        a(:n, :) = transpose(c%alpha)
        w(:n, :) = transpose(c%omega)
        rm(:n) = c%mass
        ri(:n) = c%inertia
        ipair(:, :size(c%pair, 2)) = int(c%pair)
    end subroutine

    subroutine rows(name, counts, what)
        character(len=*), intent(in) :: name, what
        integer, intent(in) :: counts(3)
        type(crowd) :: theirs
        type(vti_stepper) :: method
        double precision :: results(11)
        integer :: n, nb, ier
        theirs = run_in_c(name, counts, 1)
        call fill(new_crowd(counts))
        n = size(theirs%mass)
        nb = size(theirs%pair, 2)
        method = vti_stepper_find(name)
        call f77row(name, int(method%stages), h, int(steps), n, nb, bond_energy, results, ier)
        call expect_status(int(ier, c_int), VTI_OK, name//', F77 rows')
        call compare(theirs, transpose(x(:n, :)), transpose(v(:n, :)), transpose(a(:n, :)), transpose(w(:n, :)), &
            rest(:, :nb), name//', F77 rows, '//what)
        ! parts of at most 256 bonds are summed each for itself: two roundings more
        call expect(abs(sum(results(1:5)) - theirs%results(2)) <= 8*epsilon(1d0)*theirs%results(2), &
            name//', F77 energies, '//what)
        call expect(maxval(abs(results(4:5) - theirs%results(3:4))) <= 8*epsilon(1d0)*maxval(theirs%results(3:4)), &
            name//', F77 energies of terms, '//what)
        call expect(maxval(abs(results(6:8) - matmul(theirs%v, theirs%mass))) <= n*epsilon(1d0)* &
            sum(abs(theirs%v)), name//', F77 momentum, '//what)
        call expect(maxval(abs(results(9:11) - angular(theirs))) <= n*epsilon(1d0)*10*n, &
            name//', F77 angular momentum, '//what)
    end subroutine

    !> Sum of x x m v + J Omega, plainly.
    pure function angular(c) result(l)
        type(crowd), intent(in) :: c
        real(c_double) :: l(3)
        integer :: i
        l = matmul(c%omega, c%inertia)
        do i = 1, size(c%mass)
            l = l + c%mass(i)*(cshift(c%x(:, i), 1)*cshift(c%v(:, i), 2) - cshift(c%x(:, i), 2)*cshift(c%v(:, i), 1))
        end do
    end function

    subroutine columns(counts, what)
        integer, intent(in) :: counts(3)
        character(len=*), intent(in) :: what
        type(crowd) :: theirs, c
        double precision, allocatable :: f(:, :), t(:, :)
        integer :: ier
        theirs = run_in_c('vti2', counts, 1)
        c = new_crowd(counts)
        allocate (f, t, mold=c%x)
        call f77col(h, int(steps), size(c%mass), c%x, c%v, c%alpha, c%omega, c%mass, c%inertia, size(c%pair, 2), &
            int(c%pair), c%rest, bond_energy, f, t, ier)
        call expect_status(int(ier, c_int), VTI_OK, 'F77 columns')
        call compare(theirs, c%x, c%v, c%alpha, c%omega, c%rest, 'F77 columns, '//what)
    end subroutine

    !> NI = 3*N: bodies of three moments and L, as the packed calls have them, in rows.
    subroutine moments()
        integer, parameter :: n = 5
        double precision, parameter :: step = 0.25d0
        double precision :: x0(3, n), v0(3, n), f0(3, n), a0(3, n), l0(3, n), t0(3, n), i0(3, n), m0(n), about(3)
        double precision :: x1(n, 3), v1(n, 3), f1(n, 3), a1(n, 3), l1(n, 3), t1(n, 3), i1(n, 3), p(3), sl(3), value
        integer :: i, j, m, ier, body
        integer(c_int) :: status
        external :: vtimom
        do i = 1, n
            m0(i) = 1 + abs(number(i))
            do j = 1, 3
                x0(j, i) = number(20*i + j)
                v0(j, i) = number(20*i + j + 3)
                f0(j, i) = number(20*i + j + 6)
                a0(j, i) = number(20*i + j + 9)
                l0(j, i) = number(20*i + j + 12)
                t0(j, i) = number(20*i + j + 15)
                i0(j, i) = 4 + number(20*i + j + 18)
            end do
        end do
        x1 = transpose(x0)
        v1 = transpose(v0)
        f1 = transpose(f0)
        a1 = transpose(a0)
        l1 = transpose(l0)
        t1 = transpose(t0)
        i1 = transpose(i0)
        call vtistp('vti2', m, ier)
        call vtichk(n, 1, n, x1, v1, f1, a1, l1, t1, n, m0, 3*n, i1, body, value, ier)
        call expect_status(int(ier, c_int), VTI_OK, 'F77 moments, check')
        call vtibeg(m, step, n, 1, n, x1, v1, f1, a1, l1, t1, n, m0, 3*n, i1, body, value, ier)
        call expect_status(int(ier, c_int), VTI_OK, 'F77 moments, begin')
        call vtifin(m, step, n, 1, n, x1, v1, f1, a1, l1, t1, n, m0, 3*n, i1, ier)
        call expect_status(int(ier, c_int), VTI_OK, 'F77 moments, finish')
        status = vti_packed_begin(int(m, c_int64_t), step, int(n, c_int64_t), x0, v0, f0, a0, l0, t0, &
            int(n, c_int64_t), m0, int(3*n, c_int64_t), i0)
        call expect_status(status, VTI_OK, 'packed moments, begin')
        status = vti_packed_finish(int(m, c_int64_t), step, int(n, c_int64_t), v0, f0, l0, t0, int(n, c_int64_t), m0, &
            int(3*n, c_int64_t), i0)
        call expect_status(status, VTI_OK, 'packed moments, finish')
        call expect(same_bits(transpose(x1), x0) .and. same_bits(transpose(v1), v0) .and. same_bits(transpose(a1), a0) &
            .and. same_bits(transpose(l1), l0), 'F77 moments are the packed ones')
        about = 0
        call vtimom(n, 1, n, x1, v1, l1, n, m0, 3*n, i1, about, p, sl, ier)
        do i = 1, n
            sl = sl - l0(:, i) - m0(i)*(cshift(x0(:, i), 1)*cshift(v0(:, i), 2) - &
                cshift(x0(:, i), 2)*cshift(v0(:, i), 1))
        end do
        call expect(ier == 0 .and. maxval(abs(sl)) <= 100*n*epsilon(1d0), 'F77 moments, angular momentum')
        i1(3, 2) = -1
        call vtichk(n, 1, n, x1, v1, f1, a1, l1, t1, n, m0, 3*n, i1, body, value, ier)
        call expect_status(int(ier, c_int), VTI_E_MOMENTS, 'F77 moments, one below 0')
        call expect(body == 3, 'F77 moments, the body of it')
    end subroutine

    subroutine quaternions()
        integer, parameter :: n = 5
        real(c_double), target :: q(4, n), r(n, 4), w3(3, n), ours(4, n)
        type(vti_bodies) :: b
        integer :: i, ier
        do i = 1, n
            q(:, i) = [number(7*i), number(7*i + 1), number(7*i + 2), 1.5_c_double]
            q(:, i) = q(:, i)/norm2(q(:, i))
            w3(:, i) = [number(7*i + 3), number(7*i + 4), number(7*i + 5)]
        end do
        r = transpose(q)
        ours = q
        b = vti_bodies_none(int(n, kind(b%count)))
        b%quat = vti_quat_view_columns(ours)
        b%omega = vti_view_columns(w3)
        call expect_status(vti_drift(VTI_LAW_CAYLEY, VTI_FRAME_SPACE, 0.5_c_double, b), VTI_OK, 'quaternions')
        call f77qua(0.5d0, n, q, r, w3, ier)
        call expect_status(int(ier, c_int), VTI_OK, 'F77 quaternions')
        call expect(same_bits(q, ours) .and. same_bits(transpose(r), ours), 'F77 quaternions in columns and rows')
    end subroutine

    subroutine texts()
        character(len=160) :: text
        integer :: m, ier
        call vtiver(text)
        call expect(text == vti_version(), 'F77 version')
        call vtitxt(-10, text)
        call expect(index(text, 'h|Omega| < 1') > 0, 'F77 text of a status')
        call vtistp('vti2  ', m, ier)
        call expect(m == 2 .and. ier == 0, 'F77 stepper vti2')
        call vtistp('vti', m, ier)
        call expect(m == 0 .and. ier == VTI_E_STEPPER, 'F77 stepper that there is not')
    end subroutine

    !> Wrong calls of each kind have their status, name the body and leave the bodies as they are.
    subroutine refusals()
        type(crowd) :: before
        before = new_crowd(chain)
        call fill(before)
        call step(2, h, 10, 1, nmax, 10, VTI_OK, 0, 'a good call')
        call step(0, h, 10, 1, nmax, 10, VTI_E_STEPPER, 0, 'no stepper')
        call step(2, -h, 10, 1, nmax, 10, VTI_E_TIME, 0, 'h < 0')
        call step(2, h, 10, 1, nmax, 9, VTI_E_COUNT, 0, 'masses neither 1 nor n')
        call step(2, h, 10, 0, nmax, 10, VTI_E_STRIDE, 0, 'LB = 0')
        call step(2, h, 10, 1, 9, 10, VTI_E_STRIDE, 0, 'LC one too small')
        w(4, :) = [0d0, 600d0, 0d0]
        call step(1, h, 10, 1, nmax, 10, VTI_E_TOO_LARGE, 4, 'a body that turns too far')
        call quantities()
        call primitives()
        call bonds()
    end subroutine

    subroutine step(m, h, n, lb, lc, nm, wanted, body, what)
        integer, intent(in) :: m, n, lb, lc, nm, body
        double precision, intent(in) :: h
        integer(c_int), intent(in) :: wanted
        character(len=*), intent(in) :: what
        double precision :: f(nmax, 3), t(nmax, 3), value, keep(nmax, 3, 4)
        integer :: ibody, ier(4)
        f = 0
        t = 0
        call fill_unset()
        keep = reshape([x, v, a, w], [nmax, 3, 4])
        call vtibeg(m, h, n, lb, lc, x, v, f, a, w, t, nm, rm, nm, ri, ibody, value, ier(1))
        call expect_status(int(ier(1), c_int), wanted, 'F77 begin, '//what)
        call expect(ibody == body, 'F77 begin, the body, '//what)
        if (wanted /= VTI_OK) call expect(all(abs(reshape([x, v, a, w], [nmax, 3, 4]) - keep) <= 0), &
            'F77 begin, nothing has changed, '//what)
        call vtistg(m, 1, h, n, lb, lc, x, v, f, a, w, t, nm, rm, nm, ri, ibody, value, ier(2))
        call expect(ier(2) /= VTI_OK, 'F77 stage 1 of a method of one, '//what)
        if (wanted == VTI_E_TOO_LARGE) return
        call vtifin(m, h, n, lb, lc, x, v, f, a, w, t, nm, rm, nm, ri, ier(3))
        call expect_status(int(ier(3), c_int), wanted, 'F77 finish, '//what)
        if (wanted == VTI_E_STEPPER .or. wanted == VTI_E_TIME) return
        call vtichk(n, lb, lc, x, v, f, a, w, t, nm, rm, nm, ri, ibody, value, ier(4))
        call expect_status(int(ier(4), c_int), wanted, 'F77 check, '//what)
    end subroutine

    !> What VTICHK refuses has a name, and a body.
    subroutine quantities()
        double precision :: f(nmax, 3), t(nmax, 3), keep, value
        integer :: ibody, ier
        f = 0
        t = 0
        keep = w(4, 2)
        call named(nmax, x, v, f, t, rm, 10, 'value')
        call named(nmax, x, x, f, t, rm, 10, 'v')
        call named(nmax, x, v, f, t, f, 10, 'mass')
        w(4, 2) = ieee_value(keep, ieee_quiet_nan)
        call named(nmax, x, v, f, t, rm, 10, 'omega')
        call vtichk(10, 1, nmax, x, v, f, a, w, t, 10, rm, 10, ri, ibody, value, ier)
        call expect(ier == VTI_E_STATE .and. ibody == 4, 'F77 check, a NaN')
        w(4, 2) = keep
    end subroutine

    subroutine named(lc, x, v, f, t, rm, nm, wanted)
        integer, intent(in) :: lc, nm
        double precision, intent(in) :: x(nmax, 3), v(nmax, 3), f(nmax, 3), t(nmax, 3), rm(nmax)
        character(len=*), intent(in) :: wanted
        character(len=9) :: name
        call vtiqty(10, 1, lc, x, v, f, a, w, t, nm, rm, 10, ri, name)
        call expect(name == wanted, 'F77 quantity, '//wanted//': '//name)
    end subroutine

    !> What lies behind the last body is a number too.
    subroutine fill_unset()
        x(11:, :) = 0
        v(11:, :) = 0
        a(11:, :) = 0
        w(11:, :) = 0
    end subroutine

    subroutine primitives()
        double precision :: value, q(4, 10)
        integer :: ibody, ier
        call vtikck(h, 10, 1, nmax, v, x, 3, rm, ier)
        call expect_status(int(ier, c_int), VTI_E_COUNT, 'F77 kick, 3 masses for 10')
        call vtikck(h, 10, 1, nmax, v, v, 10, rm, ier)
        call expect_status(int(ier, c_int), VTI_E_ALIAS, 'F77 kick of v by v')
        call vtitrn(0, h, 10, 1, nmax, a, w, ibody, value, ier)
        call expect_status(int(ier, c_int), VTI_E_STEPPER, 'F77 turn by no stepper')
        call vtitrn(1, h, 10, 1, nmax, a, w, ibody, value, ier)
        call expect(ier == VTI_E_TOO_LARGE .and. ibody == 4 .and. value > 1, 'F77 turn, a body that turns too far')
        q = 0.5d0
        call vtitrq(2, h, 10, 1, 4, q, 1, nmax, w, ibody, value, ier)
        call expect_status(int(ier, c_int), VTI_E_STRIDE, 'F77 quaternions, distances mixed up')
    end subroutine

    subroutine bonds()
        double precision :: f(nmax, 3), t(nmax, 3), value, r(4, 9)
        integer :: pairs(2, 9), ibond, ier
        pairs = ipair(:, :9)
        f = 7
        t = 7
        call vtibrs(9, pairs, 10, 1, nmax, x, r, ibond, value, ier)
        call expect(ier == VTI_OK .and. ibond == 0, 'F77 rest of good bonds')
        pairs(2, 5) = 11
        r = 7
        call vtibrs(9, pairs, 10, 1, nmax, x, r, ibond, value, ier)
        call expect(ier == VTI_E_BOND .and. ibond == 5, 'F77 rest, body 11 of 10')
        call expect(nint(value) == 11, 'F77 rest, which body')
        call expect(all(nint(r) == 7), 'F77 rest, and nothing has changed')
        call vtibnd(9, pairs, r, bond_energy, 1, 10, 1, nmax, x, a, f, t, ibond, ier)
        call expect(ier == VTI_E_BOND .and. ibond == 5, 'F77 bonds, body 11 of 10')
        pairs = ipair(:, :9)
        call vtibnd(9, pairs, r, bond_energy, 0, 10, 1, nmax, x, a, f, t, ibond, ier)
        call expect(ier == VTI_E_BOND, 'F77 bonds, no such form of shear')
        call vtibnd(-1, pairs, r, bond_energy, 1, 10, 1, nmax, x, a, f, t, ibond, ier)
        call expect(ier == VTI_E_COUNT, 'F77 bonds, fewer than none')
        call expect(all(abs(f - 7) <= 0) .and. all(abs(t - 7) <= 0), 'F77 bonds that are refused add nothing')
    end subroutine
end program
