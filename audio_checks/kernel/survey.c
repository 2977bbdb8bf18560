/* One way through a block: it is decoded and measured piece by piece, while each piece lies in the nearest cache. */
#include "kernel.h"

enum { PIECE = 64 * ROW, SUMS = 2 };

typedef struct {
    const uint8_t *raw;
    Py_ssize_t width;
    int floats;
    planar samples; /* the block and what stands around it */
    Py_ssize_t first, frames;
    double *maxima, *sums;
    planar cells; /* (CELL_FIGURES * channels, how many); none are wanted where there are no channels */
    Py_ssize_t cell;
} block_to_be;

static void measure_pieces(const block_to_be *block, int32_t *used, Py_ssize_t *broken) {
    const Py_ssize_t channels = block->samples.channels;
    Py_ssize_t cells_done = 0;
    for (Py_ssize_t at = 0; at < block->frames; at += PIECE) {
        const Py_ssize_t frames = block->frames - at < PIECE ? block->frames - at : PIECE;
        const uint8_t *raw = block->raw + at * channels * block->width;
        const int is_last = at + frames == block->frames;
        if (!block->floats) *used |= decode_integers(raw, block->width, &block->samples, block->first + at, frames);
        else if ((*broken = decode_floats(raw, block->width, &block->samples, block->first + at, frames))) return;
        const Py_ssize_t cells_known = !block->cells.channels ? 0
                                       : is_last              ? block->cells.frames
                                                              : (at + frames) / block->cell;
        for (Py_ssize_t channel = 0; channel < channels; channel++) {
            const double *start = block->samples.samples + channel * block->samples.row + block->first;
            double *maxima = block->maxima + channel * rows_of(block->frames) + at / ROW;
            if (frames % ROW == 0) {
                in_lanes()->maxima_and_sums(start + at, frames / ROW, maxima, block->sums + channel * SUMS);
            } else {
                in_lanes()->maxima(start + at, frames, maxima);
                in_lanes()->sums(start + at, frames, block->sums + channel * SUMS);
            }
            if (cells_known == cells_done) continue;
            measure_cells(start + cells_done * block->cell, block->cell, cells_known - cells_done,
                          block->cells.samples + channel * block->cells.row + cells_done, channels * block->cells.row);
        }
        cells_done = cells_known;
    }
}

/* bytes, container bits, whether they are floats, samples, first frame to fill, maxima, sums to add to, cells or None,
 * frames of a cell -> integers or-ed together, first channel that is not finite or 0 */
PyObject *survey(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    block_to_be block = {.cells = {.channels = 0}};
    if (arguments("survey", count, 9) < 0) return NULL;
    block.floats = PyObject_IsTrue(args[2]);
    block.first = PyLong_AsSsize_t(args[4]), block.cell = PyLong_AsSsize_t(args[8]);
    if (PyErr_Occurred() || (block.width = sample_bytes(args[1], block.floats)) < 0 ||
        take_planar(&held, args[3], &block.samples, 1) < 0 || !(block.raw = take_row(&held, args[0], -1, 1, 0))) {
        goto refused;
    }
    const Py_ssize_t bytes = held.views[held.count - 1].len, frame_bytes = block.samples.channels * block.width;
    block.frames = frame_bytes ? bytes / frame_bytes : 0;
    if (!(block.maxima = TAKE_DOUBLES(&held, args[5], block.samples.channels * rows_of(block.frames), 1)) ||
        !(block.sums = TAKE_DOUBLES(&held, args[6], block.samples.channels * SUMS, 1)) ||
        (args[7] != Py_None && take_planar(&held, args[7], &block.cells, 1) < 0)) {
        goto refused;
    }
    const Py_ssize_t space = block.samples.frames - block.first;
    if (!frame_bytes || bytes % frame_bytes || block.first < HISTORY || block.frames > space || block.cell < 1 ||
        (block.cells.channels && (block.cells.channels != CELL_FIGURES * block.samples.channels ||
                                  block.cells.frames < block.frames / block.cell || block.cells.frames > space / block.cell))) {
        PyErr_SetString(PyExc_ValueError, "whole frames, room for them after six frames of history, and five figures of"
                                          " each channel for every cell that they fill are wanted");
        goto refused;
    }
    int32_t used = 0;
    Py_ssize_t broken = 0;
    Py_BEGIN_ALLOW_THREADS
    measure_pieces(&block, &used, &broken);
    Py_END_ALLOW_THREADS
    let_go(&held);
    return Py_BuildValue("in", (int)used, broken);
refused:
    let_go(&held);
    return NULL;
}
