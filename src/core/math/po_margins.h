/* Numbers of one meaning that several modules use: margins, and how steps and searches go on. */
#ifndef PO_MARGINS_H
#define PO_MARGINS_H

/* Factor of an estimated error in a stated one. */
static const double PO_SAFETY = 3.0;

/* What one of several causes of an error may take of the tolerance of their sum. */
static const double PO_PART_OF_TOLERANCE = 0.1;

/* Step control. A step is refused if its error is more than PO_REFUSED times the one that is aimed
 * at; the next step is at most PO_STEP_GROWTH times as long as the last one and, if that was
 * refused, at least PO_STEP_CUT times. */
static const double PO_REFUSED = 3.0, PO_STEP_GROWTH = 2.0, PO_STEP_CUT = 0.25;

/* Factor by which a search or a trace goes farther that did not suffice. */
static const double PO_FARTHER = 1.5;

/* The part of what is allowed that the next attempt aims at. */
static const double PO_AIM = 0.8;

/* A contact radius that stands for zero, of the length in which a curve changes beside it. */
static const double PO_NEAR_AXIS = 1e-3;

/* Ratio of successive radii that are looked at one by one. */
static const double PO_NEXT_RADIUS = 1.05;

/* Points in a wavelength at which a function of the radius is looked at: slope and load have two
 * extrema in a wavelength and vary on the scale of a quarter of it. */
enum { PO_POINTS_PER_WAVE = 16 };

#endif
