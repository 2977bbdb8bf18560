/* What detectors of clicks and of other short faults share. */
#ifndef SHORT_FAULTS_H
#define SHORT_FAULTS_H

#include "kernel.h"

static inline double larger_of(double one, double other) { return one > other ? one : other; }

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
