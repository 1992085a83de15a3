/* Numbers of one meaning that several modules use: margins, and how steps and searches go on. */
#ifndef PO_MARGINS_H
#define PO_MARGINS_H

/* Factor of an estimated error in a stated one. */
static const double PO_SAFETY = 3.0;

/* What one of several causes of an error may take of the tolerance of their sum. */
static const double PO_PART_OF_TOLERANCE = 0.1;

/* Step control: the greatest growth of a step, and what is left of one at least if it is refused.
 */
static const double PO_STEP_GROWTH = 2.0, PO_STEP_CUT = 0.25;

/* Ratio of successive radii that are looked at one by one. */
static const double PO_NEXT_RADIUS = 1.05;

/* Points in a wavelength at which a function of the radius is looked at: slope and load have two
 * extrema in a wavelength and vary on the scale of a quarter of it. */
enum { PO_POINTS_PER_WAVE = 16 };

#endif
