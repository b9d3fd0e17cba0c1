! SPDX-License-Identifier: MIT
! An Iwan joint inside of someone's implicit integrator: a mass on a spring and a damper, with a joint to the wall
! beside them,
!
!     m x'' + c x' + k x + F(x) = f(t),
!
! by Newmark's rule of average acceleration [N. M. Newmark, J. Eng. Mech. Div. 85 (1959) 67], each step by Newton's
! method. The joint is asked at each iteration (trial) and moved once a step (advance).
!
! Usage: newmark [FILE.csv]; the file gets time, force and displacement of each step.
program newmark
  use, intrinsic :: iso_fortran_env, only: error_unit, real64
  use microslip
  implicit none

  real(real64), parameter :: mass = 1.0_real64        ! kg
  real(real64), parameter :: damper = 0.01_real64     ! N s/m
  real(real64), parameter :: spring = 0.75_real64     ! N/m
  real(real64), parameter :: amplitude = 0.1_real64   ! of the force, N
  real(real64), parameter :: period = 6.8_real64      ! of the force, s: near resonance
  integer, parameter :: periods = 10, steps_per_period = 2000
  real(real64), parameter :: h = period/steps_per_period

  !> State of the integrator at a time.
  type :: state
    real(real64) :: time = 0.0_real64, x = 0.0_real64, v = 0.0_real64, a = 0.0_real64, force = 0.0_real64
  end type state

  type(c_ptr) :: joint, memory
  type(state) :: s, n
  real(real64) :: work = 0.0_real64, lost_in_joint = 0.0_real64, lost_in_damper = 0.0_real64
  real(real64) :: peak = 0.0_real64, stored, final_energy
  integer :: i, unit = 0

  call open_table()
  joint = made_joint()
  call must(microslip_memory_create(joint, memory))
  call microslip_joint_destroy(joint) ! the memory holds what it needs
  do i = 1, periods*steps_per_period
    n = solved(s)
    call commit()
    s = n
    s%time = i*h ! no sum of roundings
    peak = max(peak, abs(s%x))
    if (unit /= 0) write (unit, '(es24.17,",",es24.17,",",es24.17)') s%time, s%force, s%x
  end do
  call must(microslip_memory_stored_energy(memory, stored))
  call microslip_memory_destroy(memory)
  final_energy = 0.5_real64*mass*s%v**2 + 0.5_real64*spring*s%x**2 + stored
  print '(a,f8.6,a)', 'largest displacement  ', peak, ' m'
  print '(a,f8.6,a)', 'work of the force     ', work, ' J'
  print '(a,f8.6,a)', 'lost in the joint     ', lost_in_joint, ' J'
  print '(a,f8.6,a)', 'lost in the damper    ', lost_in_damper, ' J'
  print '(a,f8.6,a)', 'energy at the end     ', final_energy, ' J'
  print '(a,es7.1,a)', 'imbalance             ', abs(work - lost_in_joint - lost_in_damper - final_energy)/work, ' of the work'

contains

  subroutine must(status)
    integer(c_int), intent(in) :: status
    if (status == MICROSLIP_OK) return
    write (error_unit, '(2a)') 'microslip: ', microslip_text(microslip_last_error())
    stop 1
  end subroutine must

  subroutine open_table()
    character(len=1000) :: file
    if (command_argument_count() == 0) return
    call get_command_argument(1, file)
    open (newunit=unit, file=trim(file), action='write', status='replace')
    write (unit, '(a)') 'time [s],force [N],displacement [m]', '0,0,0'
  end subroutine open_table

  !> Segalman's four parameters.
  function made_joint() result(made)
    type(c_ptr) :: made
    type(microslip_part) :: part(1)
    call must(microslip_part_defaults(part(1), c_sizeof(part(1))))
    part(1)%kind = MICROSLIP_PART_FOUR_PARAMETER
    part(1)%macroslip_force = 0.2_real64 ! N
    part(1)%chi = -0.5_real64
    part(1)%beta = 0.0_real64
    call must(microslip_joint_create(0.25_real64, part, 1_c_size_t, made)) ! N/m
  end function made_joint

  real(real64) function force_at(time)
    real(real64), intent(in) :: time
    force_at = amplitude*sin(2.0_real64*acos(-1.0_real64)*time/period)
  end function force_at

  !> The end of a step: x by Newton's method on the residual of the equation of motion.
  type(state) function solved(from) result(to)
    type(state), intent(in) :: from
    real(real64) :: f, tangent, residual, change
    integer :: iteration
    to = from
    to%time = from%time + h
    to%force = force_at(to%time)
    do iteration = 1, 50
      to%a = 4.0_real64*(to%x - from%x)/h**2 - 4.0_real64*from%v/h - from%a
      to%v = 2.0_real64*(to%x - from%x)/h - from%v
      call must(microslip_memory_trial(memory, to%x, f, tangent)) ! asks, and leaves the joint as it is
      residual = mass*to%a + damper*to%v + spring*to%x + f - to%force
      change = residual/(4.0_real64*mass/h**2 + 2.0_real64*damper/h + spring + tangent)
      if (abs(change) <= 1e-14_real64) return
      to%x = to%x - change
    end do
    write (error_unit, '(a,g0)') 'no equilibrium at ', to%time
    stop 1
  end function solved

  !> Takes the step: the joint moves, and its loss over the step is added up.
  subroutine commit()
    real(real64) :: lost, force
    call must(microslip_memory_dissipation(memory, n%x, lost))
    call must(microslip_memory_advance(memory, n%x, force))
    lost_in_joint = lost_in_joint + lost
    work = work + 0.5_real64*(s%force + n%force)*(n%x - s%x)
    lost_in_damper = lost_in_damper + damper*0.5_real64*(s%v + n%v)*(n%x - s%x)
  end subroutine commit

end program newmark
