/* Where a signal first reaches each level, from its head or from its tail. */
#include "kernel.h"

static double magnitude(const planar *block, Py_ssize_t frame) {
    double size = 0;
    for (Py_ssize_t channel = 0; channel < block->channels; channel++) {
        const double sample = fabs(block->samples[channel * block->row + frame]);
        size = sample > size ? sample : size;
    }
    return size;
}

/* Each record is louder than all before it; those within a grain of one that is kept give way to later ones. */
static Py_ssize_t find_records(const planar *block, double loudest, double ceiling, double grain, int backward,
                               double *RESTRICT levels, int64_t *RESTRICT places) {
    Py_ssize_t count = 0;
    for (Py_ssize_t step = 0; step < block->frames && loudest < ceiling; step++) {
        const Py_ssize_t frame = backward ? block->frames - 1 - step : step;
        double level = magnitude(block, frame);
        if (level <= loudest) continue;
        if (level > ceiling) level = ceiling;
        loudest = level;
        if (count > 1 && level < levels[count - 2] * grain) count--;
        levels[count] = level;
        places[count] = frame;
        count++;
    }
    return count;
}

PyObject *records(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block;
    double *levels;
    int64_t *places;
    if (arguments("records", count, 7) < 0) return NULL;
    const double loudest = PyFloat_AsDouble(args[1]), ceiling = PyFloat_AsDouble(args[2]), grain = PyFloat_AsDouble(args[3]);
    const int backward = PyObject_IsTrue(args[4]);
    if (PyErr_Occurred() || take_planar(&held, args[0], &block, 0) < 0 ||
        !(levels = TAKE_DOUBLES(&held, args[5], block.frames, 1)) ||
        !(places = take_row(&held, args[6], block.frames, sizeof(int64_t), 1))) {
        let_go(&held);
        return NULL;
    }
    Py_ssize_t found;
    Py_BEGIN_ALLOW_THREADS
    found = find_records(&block, loudest, ceiling, grain, backward, levels, places);
    Py_END_ALLOW_THREADS
    let_go(&held);
    return PyLong_FromSsize_t(found);
}
