/* Transforms of four complex signals at once, for the files that make something of spectra.
 *
 * Value i of lane l lies at 8i+l (real) and 8i+4+l (imaginary). Two real signals may be the parts of a complex one.
 * Turns are a table of exp(-2 pi i j / n), j = 0..n-1, made by the caller.
 */
#ifndef AUDIO_CHECKS_FOURIER_H
#define AUDIO_CHECKS_FOURIER_H

#include "kernel.h"

#define LANES 4
#define VALUE (2 * LANES)

/* Numbers of some lanes; where the compiler has no such type, one lane at a time. */
#if defined(__GNUC__)
typedef double numbers __attribute__((vector_size(LANES * sizeof(double)), aligned(sizeof(double))));
enum { LANES_AT_ONCE = LANES };
#define NONE ((numbers){0})
#else
typedef double numbers;
enum { LANES_AT_ONCE = 1 };
#define NONE 0.0
#endif
#define EACH for (int l = 0; l < LANES; l += LANES_AT_ONCE)
#define RE(value) (*(numbers *)((value) + l))
#define IM(value) (*(numbers *)((value) + LANES + l))
#define IN_RE(value) (*(const numbers *)((value) + l))
#define IN_IM(value) (*(const numbers *)((value) + LANES + l))

typedef Py_ssize_t length;

enum { TURN = 2 * sizeof(double) };

/* Whether a length is a product of the radices that there are. */
int transforms(length n);

/* Transform `n` values in `x`, with `y` as room to work; return which of the two holds the answer. */
double *transform(double *x, double *y, const double *turns, length n);

/* How many items the buffer holds that was taken last. */
length items(const holding *held, Py_ssize_t size);

typedef struct {
    planar signal;
    const double *shape, *turns; /* of a window of n frames */
    length n, first, hop, count; /* windows of each channel start `hop` apart */
} windows;

/* Open a signal, the shape of its windows and the turns; 0, or -1 with an error set. */
int take_windows(holding *held, PyObject *signal, PyObject *shape, PyObject *turns, windows *w);

/* Whether all windows lie inside the signal, and can be transformed. */
int lie_inside(const windows *w);

/* Multiply eight windows by their shape, side by side: the first four become real parts. */
void gather_faded(double *RESTRICT x, const double *const *window, const double *RESTRICT shape, length n);

/* Power of the bins of two real signals that were transformed as the parts of a complex one, z = a + ib: twice the
 * spectrum of a is z[k] + z*[n-k], and twice that of b, but for a quarter turn, z[k] - z*[n-k]. */
void split_powers(const double *RESTRICT z, length n, length bins, double *RESTRICT powers);

#endif
