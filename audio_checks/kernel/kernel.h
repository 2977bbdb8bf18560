/* What the kernel's files share: the limited API, planar blocks, and how loops are compiled.
 *
 * Figures must be the same on every machine. So sums run in a fixed order, in lanes that are written
 * out; nothing is contracted into fused multiply-adds; and no flag names one CPU.
 */
#ifndef AUDIO_CHECKS_KERNEL_H
#define AUDIO_CHECKS_KERNEL_H

#define Py_LIMITED_API 0x030b0000
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#if defined(_MSC_VER)
#define RESTRICT __restrict
#else
#define RESTRICT restrict
#endif

/* Several versions of a loop, chosen when the module loads. Wider registers change no result: lanes
 * stay lanes, and without contraction every operation rounds alike. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__)
#define CLONES __attribute__((target_clones("avx2", "default")))
#else
#define CLONES
#endif

/* Samples by channel: each row contiguous, rows `row` apart. */
typedef struct {
    Py_buffer view;
    double *samples;
    Py_ssize_t channels, frames, row;
} planar;

/* Open `object` as a planar block of float64, shape (channels, frames); 0, or -1 with an error set. */
int planar_open(PyObject *object, planar *block, int writable);
void planar_close(planar *block);

/* Open `object` as `count` numbers of `size` bytes in a row; a count of -1 takes any. */
int row_open(PyObject *object, Py_buffer *view, Py_ssize_t count, Py_ssize_t size, int writable);

int arguments(const char *name, Py_ssize_t given, Py_ssize_t wanted);

PyObject *convert(PyObject *module, PyObject *const *args, Py_ssize_t count);
PyObject *fourier(PyObject *module, PyObject *const *args, Py_ssize_t count);
PyObject *hush(PyObject *module, PyObject *const *args, Py_ssize_t count);

PyObject *decode_pcm(PyObject *module, PyObject *const *args, Py_ssize_t count);
PyObject *decode_float(PyObject *module, PyObject *const *args, Py_ssize_t count);

#endif
