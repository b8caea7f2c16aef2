! SPDX-License-Identifier: BSD-3-Clause
!> Effects and measures: what Fortran gets is what C gets, and an effect written in Fortran works in C's loop.
module spring
    use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_funptr, c_int, c_int64_t, c_ptr
    use common, only: n
    use vti, only: vti_bodies, vti_show_spring, vti_spring, VTI_OK
    implicit none

    !> U = stiffness/2 sum |x|^2 on (3,n) arrays of the host, reached through self.
    type :: springs
        real(c_double) :: stiffness
        real(c_double), pointer :: x(:, :), force(:, :)
    end type

contains

    subroutine spring_apply(self, bodies) bind(c)
        type(c_ptr), value :: self
        type(vti_bodies), intent(in) :: bodies
        type(springs), pointer :: s
        integer(c_int64_t) :: i
        call c_f_pointer(self, s)
        do i = bodies%first + 1, bodies%first + bodies%count
            s%force(:, i) = s%force(:, i) - s%stiffness*s%x(:, i)
        end do
    end subroutine

    subroutine spring_energy(self, bodies, energies) bind(c)
        type(c_ptr), value :: self
        type(vti_bodies), intent(in) :: bodies
        real(c_double), intent(inout) :: energies(*)
        type(springs), pointer :: s
        call c_f_pointer(self, s)
        energies(1) = s%stiffness/2*sum(s%x(:, bodies%first + 1:bodies%first + bodies%count)**2)
    end subroutine

    !> Each body is held to 0, alike in all directions.
    function spring_springs(self, bodies, at, visit, context) result(status) bind(c)
        type(c_ptr), value :: self, at, context
        type(vti_bodies), intent(in) :: bodies
        type(c_funptr), value :: visit
        integer(c_int) :: status
        type(springs), pointer :: s
        integer(c_int64_t) :: i
        call c_f_pointer(self, s)
        status = VTI_OK
        associate (anywhere => at) ! the same at any deformation
        end associate
        do i = bodies%first + 1, bodies%first + bodies%count
            call vti_show_spring(visit, context, vti_spring(element=i, i=i, axial=s%stiffness, across=s%stiffness))
        end do
    end function
end module

program test_fortran_effects
    use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_funloc, c_int64_t, c_loc
    use common
    use spring
    implicit none

    type(state), target :: s, other
    real(c_double), target :: force(3, n), moment(3, n)
    type(vti_bodies) :: b, r

    s = initial()
    other = initial()
    b = bodies_of(s)
    b%force = vti_view_columns(force)
    b%moment = vti_view_columns(moment)
    r = bodies_of(other)
    other%alpha = -2*other%alpha
    other%x = other%x + 1
    call measures()
    call effects()
    call clumps()
    call probe()
    call sums()
    call books()
    call finish()

contains

    function bodies_of(s) result(b)
        type(state), intent(in), target :: s
        type(vti_bodies) :: b
        b = vti_bodies_none(n)
        b%x = vti_view_columns(s%x)
        b%v = vti_view_columns(s%v)
        b%alpha = vti_view_columns(s%alpha)
        b%omega = vti_view_columns(s%omega)
        b%mass = vti_scalars_array(s%mass)
        b%inertia = vti_scalars_array(s%inertia)
    end function

    subroutine measures()
        real(c_double) :: theirs(21), ours(21), arm(3), energy
        type(vti_pendulum), target :: pendulum = & ! the shim's
            vti_pendulum(0.75_c_double, [0.3_c_double, -0.4_c_double, 0.8_c_double])
        type(vti_effect) :: effect
        integer :: i
        character(len=2) :: place
        call shim_measures(b, r, theirs)
        effect = vti_pendulum_effect(pendulum)
        ours(1) = vti_kinetic_translation(b)
        ours(2) = vti_kinetic_rotation(b)
        ours(3) = vti_energy([effect], b)
        ours(4) = vti_max_turn(0.5_c_double, b)
        ours(5) = vti_h1_density(b)
        ours(6) = vti_h1_distance(b, r)
        ours(7) = vti_attitude_distance(b, r)
        call vti_momentum(b, ours(8:10))
        call vti_spin(b, ours(11:13))
        call vti_angular_momentum(b, [0.25_c_double, -0.5_c_double, 1.0_c_double], ours(14:16))
        call vti_pendulum_arm(pendulum, b, 5_c_int64_t, ours(17:19))
        ours(20:21) = real([effect%terms, effect%breaks], c_double)
        do i = 1, size(ours)
            write (place, '(i0)') i
            call expect(same_bits(ours(i:i), theirs(i:i)), 'measure '//place)
        end do
        call expect(vti_text(effect%name) == 'pendulum', 'name of the effect')
        energy = ours(1) + ours(2)
        do i = 1, n
            call vti_pendulum_arm(pendulum, b, int(i, c_int64_t), arm)
            energy = energy + vti_pendulum_potential(pendulum, arm)
        end do
        call expect(abs(energy - ours(3)) <= n*epsilon(1d0)*(ours(1) + ours(2) + n*pendulum%weight), &
            'potentials of all bodies')
        call expect(abs(vti_max_turn(1.0_c_double, b) - maxval(norm2(s%omega, 1))) <= 4*epsilon(1.0_c_double)* &
            maxval(norm2(s%omega, 1)), 'largest |Omega|') ! two evaluations of a norm, each good to 2 eps
    end subroutine

    !> The pendulum of the library and the spring above, together, on a slice.
    subroutine effects()
        type(vti_pendulum), target :: pendulum = vti_pendulum(2.0_c_double, [0.0_c_double, 0.0_c_double, 1.0_c_double])
        type(springs), target :: own
        type(vti_effect) :: both(2)
        type(vti_stable) :: stable
        real(c_double) :: arm(3), scratch(n), expected
        own%stiffness = 3
        own%x => s%x
        own%force => force
        both(1) = vti_pendulum_effect(pendulum)
        both(2)%apply = c_funloc(spring_apply)
        both(2)%energy = c_funloc(spring_energy)
        both(2)%self = c_loc(own)
        both(2)%terms = 1
        force = 5
        moment = 5
        call expect_status(vti_apply(both, vti_bodies_slice(b, 2_c_int64_t, n - 1)), VTI_OK, 'apply')
        call expect(same_bits(force(:, 2:), -3*s%x(:, 2:)), 'the force of the spring')
        call vti_pendulum_arm(pendulum, b, n, arm)
        call expect(same_bits(moment(:, n), [2*arm(2), -2*arm(1), 0.0_c_double]), 'the moment of the pendulum')
        call expect(all(abs([force(:, 1), moment(:, 1)] - 5) <= 0), 'bodies outside the slice are left alone')
        call expect(abs(vti_energy(both, b) - vti_energy(both(1:1), b) - 1.5_c_double*sum(s%x**2)) <= &
            8*epsilon(1.0_c_double)*vti_energy(both, b), 'energies add up') ! three sums, each good to 2 eps
        ! an effect that says nothing of its springs leaves no bound; with them, the lightest body sets it
        call expect_status(vti_stable_step(both, b, scratch, stable), VTI_E_SPRINGS, 'springs that are not told')
        call expect(stable%effect == 2 .and. stable%element == 0 .and. stable%i == 0, 'the effect that does not tell')
        both(2)%springs = c_funloc(spring_springs)
        expected = 2/sqrt(3/minval(s%mass))
        call expect_status(vti_stable_step(both(2:), b, scratch, stable), VTI_OK, 'springs of a host')
        call expect(abs(stable%h - expected) <= 4*epsilon(expected)*expected, 'the bound of springs of a host')
        call expect(stable%effect == 1 .and. stable%i == minloc(s%mass, 1) .and. stable%element == stable%i &
            .and. stable%j == 0, 'what sets it')
        call expect_status(vti_stable_step(both, b, scratch, stable, vti_deformation()), VTI_OK, 'with the pendulum')
        call expect(stable%h < expected, 'two effects are stiffer than one')
        both(2)%springs = c_funloc(vti_springs_none)
        call expect_status(vti_stable_step(both(2:), b, scratch, stable), VTI_OK, 'no springs')
        call expect(stable%h > huge(1.0_c_double) .and. stable%effect == 0, 'no springs do not oscillate')
    end subroutine

    !> Spheres at two places of each body, of which the second are pulled: F and RM = r x F, by calls and as an effect.
    subroutine clumps()
        type(vti_clumps), target :: of_all
        type(vti_clumped), target :: clumped
        type(vti_clumped), pointer :: at
        type(vti_solid) :: solid
        type(vti_gravity), target :: field = vti_gravity([0.0_c_double, 0.0_c_double, 2.0_c_double])
        type(vti_gravity), pointer :: g
        type(vti_effect), target :: inner
        type(vti_effect) :: effect(1)
        type(vti_bodies) :: spheres, slice
        type(vti_fault) :: fault
        real(c_double), target :: offset(3, 2*n), x(3, 2*n), pull(3, 2*n), mass
        integer(c_int64_t), target :: body(2*n)
        integer(c_int64_t), pointer, contiguous :: bodies(:)
        real(c_double), pointer, contiguous :: offsets(:, :)
        real(c_double) :: r(3, n)
        integer(c_int64_t) :: i
        body(::2) = [(i, i=1, n)]
        body(2::2) = body(::2)
        offset = 0
        offset(1, 2::2) = 0.5_c_double
        pull = 0
        pull(3, 2::2) = 2
        mass = 1
        spheres = vti_bodies_none(2*n)
        spheres%x = vti_view_columns(x)
        spheres%force = vti_view_columns(pull)
        spheres%mass = vti_scalars_one(mass)
        bodies => body
        offsets => offset
        of_all = vti_clumps_of(bodies, offsets, spheres)
        call expect_status(vti_clumps_check(of_all, n, fault), VTI_OK, 'clumps')
        call expect_status(vti_clumps_check(of_all, n - 1, fault), VTI_E_CLUMP, 'a body that is not there')
        call expect(fault%body == 2*n - 1, 'the first of its spheres')
        slice = vti_clumps_spheres(of_all, vti_bodies_slice(b, 2_c_int64_t, 1_c_int64_t))
        call expect(slice%first == 2 .and. slice%count == 2, 'spheres of a slice')
        call expect_status(vti_clumps_spread(of_all, b), VTI_OK, 'spread')
        call expect(same_bits(x(:, ::2), s%x), 'spheres at the centres')
        r = x(:, 2::2) - s%x
        call expect(all(abs(norm2(r, 1) - 0.5_c_double) < 1e-14_c_double), 'spheres at their offsets')
        force = 0
        moment = 0
        call expect_status(vti_clumps_gather(of_all, b), VTI_OK, 'gather')
        call expect(same_bits(force(3, :), pull(3, 2::2)), 'forces')
        call expect(all(abs(moment(1, :) - 2*r(2, :)) < 1e-14_c_double) .and. &
            all(abs(moment(2, :) + 2*r(1, :)) < 1e-14_c_double), 'moments')
        g => field
        inner = vti_gravity_effect(g)
        clumped%clumps = c_loc(of_all)
        clumped%effect = c_loc(inner)
        at => clumped
        effect(1) = vti_clumped_effect(at)
        call expect_status(vti_apply(effect, b), VTI_OK, 'an effect on clumps')
        call expect(all(abs(force(3, :) - 4) <= 0), 'the weight of two spheres')
        call expect_status(vti_clump_solid(offset(:, 1:1), [2.0_c_double], 3.0_c_double, 1_c_int64_t, solid), VTI_OK, &
            'a sphere')
        call expect(abs(solid%moments(3) - 0.4_c_double*solid%mass) < 1e-14_c_double*solid%mass, 'its moments')
        call expect_status(vti_clump_solid(offset(:, 1:2), [1.0_c_double, -1.0_c_double], 3.0_c_double, 8_c_int64_t, &
            solid, fault), VTI_E_CLUMP, 'a diameter below 0')
        call expect(fault%body == 2, 'of the second sphere')
        call expect_status(vti_clump_solid(offset(1:2, :), [1.0_c_double], 3.0_c_double, 8_c_int64_t, solid, fault), &
            VTI_E_COUNT, 'places in a plane')
        nullify (offsets)
        of_all = vti_clumps_of(bodies, offsets, spheres)
        call expect_status(vti_clumps_check(of_all, n), VTI_E_COUNT, 'no offsets')
    end subroutine

    !> chin4 takes the forces of a kick at x + probe h^2 F/m.
    subroutine probe()
        type(vti_stepper) :: method
        type(vti_bodies) :: probed
        real(c_double), target :: x(3, n), alpha(3, n)
        real(c_double), pointer :: factor(:)
        real(c_double), parameter :: h = 0.125_c_double
        integer :: k
        method = vti_stepper_find('chin4')
        call c_f_pointer(method%probe, factor, [method%stages + 1])
        k = maxloc(abs(factor), 1)
        force = cshift(s%v, 1)
        moment = 0
        probed = b
        probed%x = vti_view_columns(x)
        probed%alpha = vti_view_columns(alpha)
        call expect_status(vti_step_probe(method, int(k - 1, c_int64_t), h, b, probed), VTI_OK, 'probe')
        call expect(all(abs(x - s%x - factor(k)*h**2*force/spread(s%mass, 1, 3)) <= 4*epsilon(h)*abs(x) + epsilon(h)), &
            'probe, positions') ! two sums and three products, each good to eps/2
        call expect(maxval(abs(x - s%x)) > 1e-6_c_double, 'probe, bodies are displaced')
    end subroutine

    !> A sum of terms that cancel keeps what doubles alone lose, and the trapezoid rule is exact for a straight line.
    subroutine sums()
        type(vti_sum) :: total
        type(vti_integral) :: q
        integer :: i
        do i = 1, 1000
            call vti_sum_add(total, 1e16_c_double)
            call vti_sum_add(total, 1.0_c_double)
            call vti_sum_add(total, -1e16_c_double)
        end do
        call expect(abs(vti_sum_value(total) - 1000) <= 0, 'sum')
        do i = 0, 64
            call vti_integral_add(q, 0.125_c_double, 3*0.125_c_double*i)
        end do
        call expect(abs(vti_integral_value(q) - 96) <= 0 .and. q%values == 65, 'integral of 3 t up to t = 8')
        call expect(same_bits([q%last], [24.0_c_double]), 'last value of the integral')
    end subroutine

    !> What drag takes of each body is what that body loses of its kinetic energy.
    subroutine books()
        type(state), target :: slowed
        type(vti_sum), target :: lost(2), by_body(2, n)
        type(vti_drag), target :: drag
        type(vti_effect) :: effect(1)
        type(vti_bodies) :: body
        real(c_double), target :: coefficient = 0.5_c_double
        real(c_double) :: before(n), each(n)
        integer(c_int64_t) :: i
        slowed = initial()
        drag%linear = vti_scalars_one(coefficient)
        drag%angular = vti_scalars_one(coefficient)
        drag%lost = c_loc(lost)
        drag%by_body = c_loc(by_body)
        effect(1) = vti_drag_effect(drag)
        body = bodies_of(slowed)
        before = slowed%mass*sum(slowed%v**2, 1)/2 + slowed%inertia*sum(slowed%omega**2, 1)/2
        call expect_status(vti_effects_flow(effect, 0.25_c_double, 0.25_c_double, body), VTI_OK, 'drag')
        before = before - slowed%mass*sum(slowed%v**2, 1)/2 - slowed%inertia*sum(slowed%omega**2, 1)/2
        do i = 1, n
            each(i) = vti_booked_of_body(effect, i)
        end do
        call expect(all(before > 0 .and. abs(each - before) <= 40*epsilon(1.0_c_double)*(before + each)), &
            'what each body has lost') ! some 40 operations
        call expect(abs(sum(each) - vti_booked(effect)) <= n*epsilon(1.0_c_double)*sum(each), 'and all of them')
    end subroutine
end program
