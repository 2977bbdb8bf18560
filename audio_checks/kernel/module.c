/* The module's table, and how its functions open what they are given. */
#include "kernel.h"

int arguments(const char *name, Py_ssize_t given, Py_ssize_t wanted) {
    if (given == wanted) return 0;
    PyErr_Format(PyExc_TypeError, "%s takes %zd arguments, %zd were given", name, wanted, given);
    return -1;
}

void let_go(holding *held) {
    while (held->count > 0) PyBuffer_Release(&held->views[--held->count]);
}

int take_planar(holding *held, PyObject *object, planar *block, int writable) {
    Py_buffer *view = &held->views[held->count];
    const Py_ssize_t size = (Py_ssize_t)sizeof(double);
    if (PyObject_GetBuffer(object, view, PyBUF_STRIDES | PyBUF_FORMAT | (writable ? PyBUF_WRITABLE : 0)) < 0) return -1;
    held->count++;
    if (view->ndim != 2 || view->itemsize != size || strcmp(view->format, "d") != 0 ||
        (view->strides[1] != size && view->shape[1] > 1) || view->strides[0] % size != 0 || view->strides[0] < 0) {
        PyErr_SetString(PyExc_ValueError, "float64 of shape (channels, frames) is wanted, each channel contiguous");
        return -1;
    }
    block->samples = view->buf;
    block->channels = view->shape[0];
    block->frames = view->shape[1];
    block->row = view->strides[0] / size;
    return 0;
}

void *take_row(holding *held, PyObject *object, Py_ssize_t count, Py_ssize_t size, int writable) {
    Py_buffer *view = &held->views[held->count];
    if (PyObject_GetBuffer(object, view, writable ? PyBUF_CONTIG : PyBUF_CONTIG_RO) < 0) return NULL;
    held->count++;
    if (view->len % size == 0 && (count < 0 || view->len == count * size)) return view->buf;
    PyErr_Format(PyExc_ValueError, "%zd bytes were given; %zd items of %zd bytes are wanted", view->len, count, size);
    return NULL;
}

#ifndef SOURCES_SHA256
#define SOURCES_SHA256 "" /* setup.py says it */
#endif

PyObject *made_from(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module, (void)args;
    return arguments("made_from", count, 0) < 0 ? NULL : PyUnicode_FromString(SOURCES_SHA256);
}

#define ROW(name, text) {#name, (PyCFunction)(void (*)(void))name, METH_FASTCALL, PyDoc_STR(text)},

static PyMethodDef table[] = {FUNCTIONS(ROW){NULL, NULL, 0, NULL}};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT,
    .m_name = "audio_checks.kernel._kernel",
    .m_doc = "The hot loops of measuring, compiled.",
    .m_size = 0,
    .m_methods = table,
};

PyMODINIT_FUNC PyInit__kernel(void) { return PyModuleDef_Init(&definition); }
