"""Distances between two curves that may turn back, as a branch does at a fold."""

import numpy
from scipy.interpolate import CubicSpline

SAMPLES = 24      # samples of the spline between two points, to find the nearest segment
REFINEMENTS = 6   # Newton steps on the foot of the normal; convergence is quadratic
UPRIGHT = 0.02    # largest cosine of the angle between the tangent and the direction to the point
ROUND_OFF = 1e-12  # distances below this have no reliable direction
PAPER = (7.0, 4.2)  # width and height of a figure's frame, in the unit of the distances between markers


def through(curve_x, curve_y, position):
    """The cubic spline through the points of a curve, in `position`; None for fewer than four points."""
    order = numpy.concatenate([[True], numpy.diff(position) > 0])
    if order.sum() < 4:
        return None
    return CubicSpline(position[order], numpy.column_stack([curve_x[order], curve_y[order]]))


def dense(curve_x, curve_y, position, between=8):
    """Points of the curve that are dense enough to be joined by straight lines."""
    spline = through(curve_x, curve_y, position)
    if spline is None:
        return numpy.column_stack([curve_x, curve_y])
    knots = spline.x
    steps = numpy.arange(between) / between
    fine = (knots[:-1, None] + numpy.diff(knots)[:, None] * steps).ravel()
    return spline(numpy.append(fine, knots[-1]))


def inside(window, heights, x, y):
    """Which points lie in a frame; window and heights are its ranges of x and y."""
    return (x >= window[0]) & (x <= window[1]) & (y >= heights[0]) & (y <= heights[1])


def thinned(x, y, window, heights, apart):
    """Points of a dense curve in a frame whose successive distances on paper are at least `apart`."""
    chosen = inside(window, heights, x, y)
    size = (PAPER[0] / (window[1] - window[0]), PAPER[1] / (heights[1] - heights[0]))
    kept = []
    for px, py in zip(x[chosen], y[chosen]):
        if not kept or numpy.hypot(size[0] * (px - kept[-1][0]), size[1] * (py - kept[-1][1])) >= apart:
            kept.append((float(px), float(py)))
    return kept


def common_range(curve_x, curve_y, x, y):
    """Which of the points (x, y) of one curve lie between the ends of the other curve.

    For points beyond these ends, the nearest part of the other curve would belong to another branch.
    """
    ends = [int(numpy.argmin(numpy.hypot(x - curve_x[end], y - curve_y[end]))) for end in (0, -1)]
    place = numpy.arange(len(x))
    return (place >= min(ends)) & (place <= max(ends))


def distances(curve_x, curve_y, position, x, y):
    """Distance from each point (x, y) to the curve, measured along the curve's normal.

    The curve is interpolated by a cubic spline in `position`, so it may turn back; the nearest part counts.
    The distance is NaN for a point beyond either end of the curve, which lies on no normal.
    """
    spline = through(curve_x, curve_y, position)
    if spline is None:
        return numpy.full(len(x), numpy.nan)
    knots = spline.x
    first, second = spline.derivative(1), spline.derivative(2)

    steps = numpy.arange(SAMPLES) / SAMPLES
    fine = numpy.append((knots[:-1, None] + numpy.diff(knots)[:, None] * steps).ravel(), knots[-1])
    at = spline(fine)
    foot = numpy.array([fine[numpy.argmin((at[:, 0] - px) ** 2 + (at[:, 1] - py) ** 2)]
                        for px, py in zip(x, y)])
    spacing = numpy.interp(foot, fine[1:], numpy.diff(fine))
    target = numpy.column_stack([x, y])
    for _ in range(REFINEMENTS):
        offset = spline(foot) - target
        tangent = first(foot)
        slope = (offset * tangent).sum(axis=1)
        bend = (tangent ** 2).sum(axis=1) + (offset * second(foot)).sum(axis=1)
        step = numpy.where(bend > 0, -slope / numpy.where(bend > 0, bend, 1), 0.0)
        foot = foot + numpy.clip(step, -spacing, spacing)
    foot = numpy.clip(foot, knots[0], knots[-1])
    offset, tangent = spline(foot) - target, first(foot)
    result = numpy.hypot(*offset.T)
    # If the direction to the point is not normal to the curve, the foot is an end of the curve.
    lean = numpy.abs((offset * tangent).sum(axis=1)) / numpy.hypot(*tangent.T)
    return numpy.where(lean > UPRIGHT * result + ROUND_OFF, numpy.nan, result)
