/* One way through a block: it is decoded and measured piece by piece, while each piece lies in the nearest cache. */
#include "kernel.h"

enum { PIECE = 64 * ROW, FIGURES = 3 }; /* the latter of a channel so far: sum, sum of squares, highest magnitude */
enum { LEAST_SUMMED = 4 }; /* samples of cells of which the sums can be had alone: a register has four lanes */

typedef struct {
    const uint8_t *raw;
    Py_ssize_t width;
    int floats;
    planar samples; /* the block and what stands around it */
    Py_ssize_t first, frames;
    double *figures;
    planar maxima; /* (channels, rows of the block) */
    planar cells; /* (figures * channels, how many); none are wanted where there are no channels */
    int sums_only; /* whether these figures are the first CELL_SUMS, not all CELL_FIGURES */
    Py_ssize_t cell;
    planar hops; /* (how many, STEREO_FIGURES) of two channels; none are wanted where there are no frames */
    Py_ssize_t hop, at; /* frames of a hop, and of the first one those that came before */
} block_to_be;

static double *channel_of(const block_to_be *block, Py_ssize_t channel) {
    return block->samples.samples + channel * block->samples.row + block->first;
}

static void measure_rows(const block_to_be *block, Py_ssize_t channel, Py_ssize_t at, Py_ssize_t frames) {
    const double *start = channel_of(block, channel) + at;
    double *maxima = block->maxima.samples + channel * block->maxima.row + at / ROW;
    if (frames % ROW == 0) {
        in_lanes()->maxima_and_sums(start, frames / ROW, maxima, block->figures + channel * FIGURES);
    } else {
        in_lanes()->maxima(start, frames, maxima);
        in_lanes()->sums(start, frames, block->figures + channel * FIGURES);
    }
}

static void measure_cells_between(const block_to_be *block, Py_ssize_t from, Py_ssize_t until) {
    const Py_ssize_t channels = block->samples.channels;
    for (Py_ssize_t channel = 0; channel < channels && from < until; channel++) {
        (block->sums_only ? in_lanes()->cell_sums : measure_cells)(
            channel_of(block, channel) + from * block->cell, block->cell, until - from,
            block->cells.samples + channel * block->cells.row + from, channels * block->cells.row);
    }
}

/* Compare the two channels from one frame until the last hop that is whole by another, or until that one where the block
 * ends; returns until where. */
static Py_ssize_t measure_hops_between(const block_to_be *block, Py_ssize_t from, Py_ssize_t until) {
    const Py_ssize_t end = until == block->frames ? until : (block->at + until) / block->hop * block->hop - block->at;
    if (!block->hops.frames || end <= from) return from;
    planar hops = block->hops;
    hops.samples += (block->at + from) / block->hop * hops.row;
    measure_stereo(channel_of(block, 0) + from, channel_of(block, 1) + from, end - from, (block->at + from) % block->hop,
                   block->hop, &hops);
    return end;
}

static void measure_pieces(const block_to_be *block, int32_t *used, Py_ssize_t *broken) {
    const Py_ssize_t channels = block->samples.channels;
    Py_ssize_t cells_done = 0, compared = 0;
    for (Py_ssize_t at = 0; at < block->frames; at += PIECE) {
        const Py_ssize_t frames = block->frames - at < PIECE ? block->frames - at : PIECE;
        const uint8_t *raw = block->raw + at * channels * block->width;
        const int is_last = at + frames == block->frames;
        if (!block->floats) *used |= decode_integers(raw, block->width, &block->samples, block->first + at, frames);
        else if ((*broken = decode_floats(raw, block->width, &block->samples, block->first + at, frames))) return;
        const Py_ssize_t cells_known = !block->cells.channels ? 0
                                       : is_last              ? block->cells.frames
                                                              : (at + frames) / block->cell;
        for (Py_ssize_t channel = 0; channel < channels; channel++) measure_rows(block, channel, at, frames);
        measure_cells_between(block, cells_done, cells_known);
        cells_done = cells_known;
        compared = measure_hops_between(block, compared, at + frames);
    }
}

/* The samples of a piece as whole numbers, with what stands before and after them. */
typedef struct {
    int16_t samples[WHOLE_CHANNELS][WHOLE_BEFORE + WHOLE_PIECE + WHOLE_BEFORE];
} whole_piece;

/* Take the history before the first frame as whole numbers, if that is what it holds. */
static int take_history(const block_to_be *block, whole_piece *piece) {
    for (Py_ssize_t channel = 0; channel < block->samples.channels; channel++) {
        for (int back = 1; back <= HISTORY; back++) {
            const double steps = channel_of(block, channel)[-back] * 0x1p15;
            if (!(steps >= INT16_MIN && steps <= INT16_MAX) || steps != (double)(int16_t)steps) return 0;
            piece->samples[channel][WHOLE_BEFORE - back] = (int16_t)steps;
        }
    }
    return 1;
}

static void measure_stereo_piece(const block_to_be *block, const whole_piece *piece, Py_ssize_t at, Py_ssize_t frames) {
    for (Py_ssize_t done = 0; done < frames;) {
        const Py_ssize_t place = block->at + at + done, left = block->hop - place % block->hop;
        const Py_ssize_t count = frames - done < left ? frames - done : left, from = WHOLE_BEFORE + done;
        double *figures = block->hops.samples + place / block->hop * block->hops.row;
        in_whole_numbers()->stereo(piece->samples[0] + from, piece->samples[1] + from, count, figures);
        done += count;
    }
}

/* The same in whole numbers, with the same results; returns whether these can be measured so. */
static int measure_whole_pieces(const block_to_be *block, int32_t *used) {
    const Py_ssize_t channels = block->samples.channels;
    whole_piece piece = {{{0}}};
    if (block->floats || block->width != 2 || channels > WHOLE_CHANNELS || block->cell > LONGEST_CELL ||
        !in_whole_numbers() || !take_history(block, &piece)) {
        return 0;
    }
    const Py_ssize_t unit = ROW * block->cell, most = WHOLE_PIECE / unit * unit;
    Py_ssize_t cells_done = 0;
    for (Py_ssize_t at = 0; at < block->frames; at += most) {
        const Py_ssize_t frames = block->frames - at < most ? block->frames - at : most, whole = frames / ROW * ROW;
        const Py_ssize_t cells = block->cells.channels ? frames / block->cell / CELLS_AT_ONCE * CELLS_AT_ONCE : 0;
        int16_t *rows[WHOLE_CHANNELS];
        double *to[WHOLE_CHANNELS];
        for (Py_ssize_t channel = 0; channel < channels; channel++) {
            rows[channel] = piece.samples[channel] + WHOLE_BEFORE;
            to[channel] = channel_of(block, channel) + at;
        }
        *used |= in_whole_numbers()->split(block->raw + at * channels * 2, frames, channels, rows, to);
        for (Py_ssize_t channel = 0; channel < channels; channel++) {
            in_whole_numbers()->maxima_and_sums(rows[channel], whole / ROW,
                                                block->maxima.samples + channel * block->maxima.row + at / ROW,
                                                block->figures + channel * FIGURES);
            if (whole < frames) measure_rows(block, channel, at + whole, frames - whole);
            if (!cells || block->sums_only) continue;
            in_whole_numbers()->cells(rows[channel], block->cell, cells,
                                      block->cells.samples + channel * block->cells.row + cells_done,
                                      channels * block->cells.row);
        }
        if (block->sums_only) measure_cells_between(block, cells_done, cells_done + cells);
        if (block->hops.frames) measure_stereo_piece(block, &piece, at, frames);
        for (Py_ssize_t channel = 0; channel < channels; channel++) {
            memmove(piece.samples[channel], rows[channel] + frames - WHOLE_BEFORE, WHOLE_BEFORE * sizeof(int16_t));
        }
        cells_done += cells;
    }
    if (block->cells.channels) measure_cells_between(block, cells_done, block->cells.frames);
    return 1;
}

/* bytes, container bits, whether they are floats, samples, first frame to fill, maxima, figures to add to, cells or None,
 * frames of a cell, hops of stereo to add to or None, frames of a hop, those of the first that came before -> integers or-ed together, first channel that is not finite, or too large (< 0), or 0 */
PyObject *survey(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    block_to_be block = {.cells = {.channels = 0}, .hops = {.frames = 0}};
    if (arguments("survey", count, 12) < 0) return NULL;
    block.floats = PyObject_IsTrue(args[2]);
    block.first = PyLong_AsSsize_t(args[4]), block.cell = PyLong_AsSsize_t(args[8]);
    block.hop = PyLong_AsSsize_t(args[10]), block.at = PyLong_AsSsize_t(args[11]);
    if (PyErr_Occurred() || (block.width = sample_bytes(args[1], block.floats)) < 0 ||
        take_planar(&held, args[3], &block.samples, 1) < 0 || !(block.raw = take_row(&held, args[0], -1, 1, 0))) {
        goto refused;
    }
    const Py_ssize_t bytes = held.views[held.count - 1].len, frame_bytes = block.samples.channels * block.width;
    block.frames = frame_bytes ? bytes / frame_bytes : 0;
    if (take_maxima(&held, args[5], &block.samples, block.frames, &block.maxima, 1) < 0 ||
        !(block.figures = TAKE_DOUBLES(&held, args[6], block.samples.channels * FIGURES, 1)) ||
        (args[7] != Py_None && take_planar(&held, args[7], &block.cells, 1) < 0) ||
        (args[9] != Py_None && take_planar(&held, args[9], &block.hops, 1) < 0)) {
        goto refused;
    }
    const Py_ssize_t space = block.samples.frames - block.first;
    block.sums_only = block.cell >= LEAST_SUMMED && block.cells.channels == CELL_SUMS * block.samples.channels;
    const Py_ssize_t figures = block.sums_only ? CELL_SUMS : CELL_FIGURES;
    if (!frame_bytes || bytes % frame_bytes || block.first < HISTORY || block.frames > space || block.cell < 1 ||
        (block.cells.channels && (block.cells.channels != figures * block.samples.channels ||
                                  block.cells.frames < block.frames / block.cell || block.cells.frames > space / block.cell))) {
        PyErr_SetString(PyExc_ValueError, "whole frames, room for them after six frames of history, and five figures of"
                                          " each channel, or two of cells of four frames or more, for every cell that"
                                          " they fill are wanted");
        goto refused;
    }
    if (args[9] != Py_None && ensure_stereo(&block.samples, block.frames, &block.hops, block.hop, block.at) < 0) goto refused;
    int32_t used = 0;
    Py_ssize_t broken = 0;
    Py_BEGIN_ALLOW_THREADS
    if (!measure_whole_pieces(&block, &used)) measure_pieces(&block, &used, &broken);
    for (Py_ssize_t channel = 0; channel < block.samples.channels; channel++) {
        double *highest = block.figures + channel * FIGURES + 2;
        const double peak = in_lanes()->highest(block.maxima.samples + channel * block.maxima.row, block.maxima.frames);
        if (peak > *highest) *highest = peak;
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    return Py_BuildValue("in", (int)used, broken);
refused:
    let_go(&held);
    return NULL;
}
