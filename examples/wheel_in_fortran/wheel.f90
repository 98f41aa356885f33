! SPDX-License-Identifier: LGPL-2.1-or-later
! Calls wheel.c: prints the force on the right wheel at 3 mm of lateral shift.
program wheel
  use iso_c_binding
  implicit none
  interface
    function wheel_create(side, friction) bind(c)
      import :: c_ptr, c_int, c_double
      integer(c_int), value :: side
      real(c_double), value :: friction
      type(c_ptr) :: wheel_create
    end function
    function wheel_force(pair, motion, force) bind(c)
      import :: c_ptr, c_int, c_double
      type(c_ptr), value :: pair
      real(c_double) :: motion(5), force(3)
      integer(c_int) :: wheel_force
    end function
  end interface
  type(c_ptr) :: pair
  real(c_double) :: force(3)
  pair = wheel_create(1, 0.3d0)
  if (.not. c_associated(pair)) stop 2
  if (wheel_force(pair, [0.003d0, 0.001d0, 20d0, 20d0/0.46d0, 50d3], force) /= 0) stop 1
  print '(3f10.0)', force
end program
