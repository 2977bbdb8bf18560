/* What detectors of clicks and of other short faults share. */
#ifndef SHORT_FAULTS_H
#define SHORT_FAULTS_H

#include "kernel.h"

static inline double larger_of(double one, double other) { return one > other ? one : other; }

static inline double mean_of(const double *values, Py_ssize_t count) {
    double sum = 0;
    for (Py_ssize_t at = 0; at < count; at++) sum += values[at];
    return count > 0 ? sum / (double)count : 0;
}

static inline int lowest_bit(uint64_t bits) {
#if defined(__GNUC__)
    return __builtin_ctzll(bits);
#else
    int at = 0;
    while (!(bits >> at & 1)) at++;
    return at;
#endif
}

#endif
