! The method of the paper in Fortran with LAPACK: equal triangular elements, Newton's method with a dense LU factorisation,
! and pseudo-arclength continuation. Called as: triangles TABLE RESPONSE. Written from Eqs 2, 9, 12, 15 and 16 of the paper.
!
! Lengths in epsilon. The unknowns x are the gaps H at the n nodes and the approach D:
!     H + D - r^2/(2R) - A (1 - cos(2 pi r/lambda)) - c G p(H) = 0,   p(H) = -(8/3) [(1 + H)^-3 - (1 + H)^-9]
! An unbounded surface is cut at r = R; the load beyond is that of the undeformed surfaces.
module sphere
  implicit none
  integer, parameter :: dp = kind(1d0), most = 20000
  real(dp), parameter :: pi = acos(-1d0), peak = 3**(1 / 6d0) - 1    ! the gap of the greatest tension
  type state         ! of the branch: arclength, approach and load, their derivatives by the arclength, contact radius
    real(dp) :: length, value(2), rate(2), contact
  end type
  integer :: n
  real(dp) :: cut, radius
  logical :: unbounded
  real(dp), allocatable :: r(:), shape(:), weights(:), metric(:), matrix(:, :)
contains

  pure function kernel(a, b) result(g)              ! Eq 12, by the arithmetic-geometric mean
    real(dp), intent(in) :: a, b
    real(dp) :: g, x, y, z
    x = a + b
    y = abs(a - b)
    do while (x - y > 1d-13 * x)
      z = (x + y) / 2
      y = sqrt(x * y)
      x = z
    end do
    g = 2 / x
  end function

  elemental function traction(gap) result(p)        ! Eq 9
    real(dp), intent(in) :: gap
    real(dp) :: p
    p = -8 / 3d0 * ((1 + gap)**(-3) - (1 + gap)**(-9))
  end function

  elemental function slope(gap) result(p)
    real(dp), intent(in) :: gap
    real(dp) :: p
    p = 8 * (1 + gap)**(-4) - 24 * (1 + gap)**(-10)
  end function

  subroutine make(nodes, tabor, amplitude, wavelength)
    integer, intent(in) :: nodes
    real(dp), intent(in) :: tabor, amplitude, wavelength
    integer :: i, j, k, m
    real(dp) :: h, t, s, g
    n = nodes
    h = cut / (n - 1)
    r = [(h * i, i = 0, n - 1)]
    shape = r**2 / (2 * radius) + amplitude * (1 - cos(2 * pi / wavelength * r))
    metric = [spread(1d0 / n, 1, n), 1d0]
    weights = 2 / radius * [h**2 / 6, h * r(2:n - 1), h * (cut / 2 - h / 6)]    ! (2/R) int phi_j s ds
    matrix = spread(0 * r, 2, n)
    do k = 1, n - 1                                 ! int G(r_i, s) phi_j(s) s ds, element by element; the midpoints are
      do i = 1, n                                   ! dense at both ends, where the kernel may be singular
        m = merge(40, 16, abs(i - k) < 4)
        do j = 1, m
          t = (j - 0.5d0) / m
          s = t**3 * (10 - 15 * t + 6 * t**2)
          g = kernel(r(i), r(k) + h * s) * (r(k) + h * s) * h * 30 * (t * (1 - t))**2 / m
          matrix(i, k:k + 1) = matrix(i, k:k + 1) + g * [1 - s, s]
        end do
      end do
    end do
    matrix = tabor**1.5d0 / sqrt(radius) * matrix
  end subroutine

  ! Newton's method on the hyperplane through x normal to the tangent. Returned: x, the new tangent, the sign of the
  ! determinant, which changes if the step ends on another part of the branch, and the number of iterations, 0 if they do
  ! not converge.
  subroutine correct(x, tangent, side, iterations)
    real(dp), intent(inout) :: x(:), tangent(:)
    integer, intent(out) :: side, iterations
    real(dp) :: jacobian(n + 1, n + 1), right(n + 1, 2), at(n + 1)
    integer :: j, info, pivots(n + 1)
    at = x
    x(:n) = max(x(:n), -0.5d0)
    do iterations = 1, 12
      do j = 1, n
        jacobian(:n, j) = -matrix(:, j) * slope(x(j))
        jacobian(j, j) = jacobian(j, j) + 1
      end do
      jacobian(:n, n + 1) = 1
      jacobian(n + 1, :) = metric * tangent
      right = 0
      right(:n, 1) = shape - x(n + 1) - x(:n) + matmul(matrix, traction(x(:n)))
      right(n + 1, :) = [dot_product(metric * tangent, at - x), 1d0]
      call dgesv(n + 1, 2, jacobian, n + 1, pivots, right, n + 1, info)
      if (info /= 0 .or. .not. all(abs(right(:, 1)) < 1d9)) exit
      x(:n) = x(:n) + right(:n, 1) / max(1d0, 2 * maxval(-right(:n, 1) / (1 + x(:n))))
      x(n + 1) = x(n + 1) + right(n + 1, 1)
      if (maxval(abs(right(:, 1))) < 1d-9) then
        tangent = right(:, 2) / sqrt(dot_product(metric, right(:, 2)**2))
        side = count(pivots /= [(j, j = 1, n + 1)]) + count([(jacobian(j, j) < 0, j = 1, n + 1)])
        side = merge(1, -1, mod(side, 2) == 0)
        return
      end if
    end do
    iterations = 0
  end subroutine

  function look(x, tangent, length) result(s)
    real(dp), intent(in) :: x(:), tangent(:), length
    type(state) :: s
    integer :: i
    s%length = length
    s%value = [x(n + 1), dot_product(weights, traction(x(:n)))]
    s%rate = [tangent(n + 1), dot_product(weights, slope(x(:n)) * tangent(:n))]
    if (unbounded) s%value(2) = s%value(2) - 8 / 3d0 / (cut**2 / (2 * radius) - x(n + 1) + 1)**2
    i = findloc(x(:n) < peak, .true., dim=1, back=.true.)
    s%contact = merge(cut, 0d0, i == n)
    if (i > 0 .and. i < n) s%contact = r(i) + r(2) * (peak - x(i)) / (x(i + 1) - x(i))
  end function

  ! Equilibria from an approach on until the approach or the load reaches an end. Returned: their number, 0 on failure.
  subroutine trace(start, furthest, hardest, branch, count)
    real(dp), intent(in) :: start, furthest, hardest
    type(state), intent(out) :: branch(most)
    integer, intent(out) :: count
    real(dp) :: x(n + 1), tangent(n + 1), new(n + 1), turned(n + 1), step, length
    integer :: k, side, new_side, iterations
    count = 0
    side = 0
    step = 0
    length = 0
    new = [shape - start, start]
    tangent = [spread(0d0, 1, n), 1d0]
    do k = 1, most
      do
        turned = tangent
        call correct(new, turned, new_side, iterations)
        if (k == 1) side = new_side
        if (iterations > 0 .and. new_side == side .and. (k == 1 .or. dot_product(metric * turned, tangent) > 0.97d0)) exit
        step = step / 2
        new = x + step * tangent
        if (step < 1d-7) return
      end do
      x = new
      tangent = turned
      length = length + step
      branch(k) = look(x, tangent, length)
      if (branch(k)%value(1) >= furthest .or. branch(k)%value(2) >= hardest) then
        count = k
        return
      end if
      if (k == 1) step = 0.04d0
      step = min(0.1d0 * max(1d0, x(1)), step * merge(1.5d0, merge(1d0, 0.6d0, iterations < 6), iterations < 4))
      new = x + step * tangent
    end do
  end subroutine

  ! Where the approach (which = 1) or the load (2) turns between two states, on the Hermite cubics.
  function turn(a, b, which) result(at)
    type(state), intent(in) :: a, b
    integer, intent(in) :: which
    type(state) :: at
    real(dp) :: l, t, c(0:2)                        ! the derivative is c0 + c1 t + c2 t^2, t in [0, 1]
    l = b%length - a%length
    c(0) = l * a%rate(which)
    c(1) = 6 * (b%value(which) - a%value(which)) - 2 * l * (2 * a%rate(which) + b%rate(which))
    c(2) = l * b%rate(which) - c(0) - c(1)
    t = 2 * c(0) / (-c(1) + sign(sqrt(c(1)**2 - 4 * c(0) * c(2)), c(0)))
    at%value = (1 - t)**2 * ((1 + 2 * t) * a%value + t * l * a%rate) + t**2 * ((3 - 2 * t) * b%value - (1 - t) * l * b%rate)
    at%contact = a%contact + t * (b%contact - a%contact)
  end function
end module

program triangles
  use sphere
  implicit none
  character(*), parameter :: plain = '(*(a, es24.16e3))', numbers = '(a, *(es24.16e3, :, ","))'
  character(4096) :: path, line
  character(64) :: names(64), row(64)
  integer :: table, out, error, k
  call get_command_argument(1, path)
  open(newunit=table, file=path, status='old', action='read')
  call get_command_argument(2, path)
  open(newunit=out, file=path, action='write', access='stream', form='formatted')
  read(table, '(a)', iostat=error) line
  names = split(line)
  do
    read(table, '(a)', iostat=error) line
    if (error /= 0) exit
    row = split(line)
    do k = 1, nint(number('repeats', 1d0))
      write(out, '(3a, i0, a)', advance='no') '{"id": "', trim(row(1)), '", "repeat": ', k, ', '
      call answer()
      flush(out)
    end do
  end do
contains

  function split(text) result(words)                ! at commas; '-' and '' are no value
    character(*), intent(in) :: text
    character(64) :: words(64)
    integer :: i, begin, comma
    words = '-'
    begin = 1
    do i = 1, size(words)
      comma = index(text(begin:) // ',', ',')
      if (comma > 1) words(i) = text(begin:begin + comma - 2)
      begin = begin + comma
      if (begin > len_trim(text)) return
    end do
  end function

  function number(name, absent) result(x)           ! in the column of that name
    character(*), intent(in) :: name
    real(dp), intent(in) :: absent
    real(dp) :: x
    integer :: i
    x = absent
    i = findloc(names, name, dim=1)
    if (i == 0) return
    if (row(i) /= '-') read(row(i), *) x
  end function

  subroutine answer()
    character(*), parameter :: known(*) = [character(16) :: 'id', 'limit_s', 'repeats', 'load_unit', 'preload_approach', &
      'preload_load', 'approach_start', 'approach_end', 'nodes', 'tabor', 'amplitude', 'wavelength', 'radius', 'outer_radius']
    real(dp), parameter :: infinite = huge(1d0)
    type(state), allocatable :: branch(:)
    type(state) :: deepest
    integer :: count, i
    integer(8) :: begin, end, per_second
    do i = 1, size(names)
      if (row(i) == '-' .or. any(names(i) == known)) cycle
      write(out, '(3a)') '"status": "unsupported", "reason": "', trim(names(i)), ' is not known here"}'
      return
    end do
    call system_clock(begin, per_second)
    radius = number('radius', 0d0)
    cut = number('outer_radius', 0d0)
    unbounded = cut > infinite
    if (unbounded) cut = radius
    call make(nint(number('nodes', 501d0)), number('tabor', 0d0), number('amplitude', 0d0), number('wavelength', 1d0))
    allocate(branch(most))
    call trace(number('approach_start', -12 - 2 * number('amplitude', 0d0)), number('preload_approach', infinite), &
      number('preload_load', infinite), branch, count)
    if (count == 0) then
      write(out, '(a)') '"status": "failed", "reason": "the continuation does not converge"}'
      return
    end if
    write(out, plain, advance='no') '"status": "ok", "start":', branch(1)%value(1), ', "end":', branch(count)%value(1)
    call turns('folds', 1, ['jump_out', 'jump_in '], branch(:count), deepest)
    call turns('extrema', 2, ['minimum', 'maximum'], branch(:count), deepest)
    write(out, plain, advance='no') ', "pull_off": {"force":', -deepest%value(2), ', "approach":', deepest%value(1), &
      ', "contact_radius":', deepest%contact, '}'
    write(out, numbers, advance='no') ', "curve": {"approach": [', branch(:count)%value(1)
    write(out, numbers, advance='no') '], "load": [', branch(:count)%value(2)
    call system_clock(end)
    write(out, plain) ']}, "seconds": {"solve":', real(end - begin, dp) / per_second, '}}'
  end subroutine

  subroutine turns(name, which, kinds, branch, lowest)    ! writes the folds (which = 1) or the extrema (2)
    character(*), intent(in) :: name, kinds(2)
    integer, intent(in) :: which
    type(state), intent(in) :: branch(:)
    type(state), intent(out) :: lowest
    type(state) :: at
    character(:), allocatable :: between
    integer :: i
    lowest%value = 0
    between = ''
    write(out, '(3a)', advance='no') ', "', name, '": ['
    do i = 1, size(branch) - 1
      if (branch(i)%rate(which) * branch(i + 1)%rate(which) >= 0) cycle
      at = turn(branch(i), branch(i + 1), which)
      if (at%value(2) < lowest%value(2)) lowest = at
      write(out, plain, advance='no') between // '{"kind": "' // trim(kinds(merge(2, 1, branch(i)%rate(which) > 0))) // &
        '", "approach":', at%value(1), ', "load":', at%value(2), '}'
      between = ', '
    end do
    write(out, '(a)', advance='no') ']'
  end subroutine
end program
