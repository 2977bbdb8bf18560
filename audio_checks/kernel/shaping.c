/* Rounding whose error is fed back: the noise of a depth, moved to where it is less heard. */
#include "kernel.h"

enum { WEIGHTS = 5 };

/* Rounds in place what is wanted of one channel; `errors` are the last ones, the newest first. Silence stays silent,
 * and forgets them. */
static void shape_channel(double *wanted, const double *noise, const uint8_t *silent, Py_ssize_t frames,
                          const double *weights, double *errors) {
    double one = errors[0], two = errors[1], three = errors[2], four = errors[3], five = errors[4];
    for (Py_ssize_t i = 0; i < frames; i++) {
        if (silent[i]) {
            one = two = three = four = five = 0.0;
            wanted[i] = 0.0;
            continue;
        }
        const double fed = weights[0] * one + weights[1] * two + weights[2] * three + weights[3] * four + weights[4] * five;
        const double aim = wanted[i] - fed;
        const double step = floor(aim + noise[i] + 0.5);
        five = four;
        four = three;
        three = two;
        two = one;
        one = step - aim;
        wanted[i] = step;
    }
    errors[0] = one;
    errors[1] = two;
    errors[2] = three;
    errors[3] = four;
    errors[4] = five;
}

PyObject *shaped_steps(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar wanted, noise;
    const uint8_t *silent;
    const double *weights;
    double *errors;
    if (arguments("shaped_steps", count, 5) < 0) return NULL;
    if (take_planar(&held, args[0], &wanted, 1) < 0 || take_planar(&held, args[1], &noise, 0) < 0 ||
        !(silent = take_row(&held, args[2], wanted.channels * wanted.frames, 1, 0)) ||
        !(weights = TAKE_DOUBLES(&held, args[3], WEIGHTS, 0)) ||
        !(errors = TAKE_DOUBLES(&held, args[4], wanted.channels * WEIGHTS, 1))) {
        goto refused;
    }
    if (noise.channels != wanted.channels || noise.frames != wanted.frames) {
        PyErr_SetString(PyExc_ValueError, "as much noise is wanted as there are samples");
        goto refused;
    }
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t channel = 0; channel < wanted.channels; channel++)
        shape_channel(wanted.samples + channel * wanted.row, noise.samples + channel * noise.row,
                      silent + channel * wanted.frames, wanted.frames, weights, errors + channel * WEIGHTS);
    Py_END_ALLOW_THREADS
    let_go(&held);
    Py_RETURN_NONE;
refused:
    let_go(&held);
    return NULL;
}
