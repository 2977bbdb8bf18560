/* The module's table, and how its functions open what they are given. */
#include "kernel.h"

int arguments(const char *name, Py_ssize_t given, Py_ssize_t wanted) {
    if (given == wanted) return 0;
    PyErr_Format(PyExc_TypeError, "%s takes %zd arguments, %zd were given", name, wanted, given);
    return -1;
}

int planar_open(PyObject *object, planar *block, int writable) {
    int flags = PyBUF_STRIDES | PyBUF_FORMAT | (writable ? PyBUF_WRITABLE : 0);
    if (PyObject_GetBuffer(object, &block->view, flags) < 0) return -1;
    const Py_buffer *view = &block->view;
    const Py_ssize_t size = (Py_ssize_t)sizeof(double);
    if (view->ndim != 2 || view->itemsize != size || strcmp(view->format, "d") != 0 ||
        (view->strides[1] != size && view->shape[1] > 1) || view->strides[0] % size != 0 || view->strides[0] < 0) {
        PyBuffer_Release(&block->view);
        PyErr_SetString(PyExc_ValueError, "float64 of shape (channels, frames) is wanted, each channel contiguous");
        return -1;
    }
    block->samples = view->buf;
    block->channels = view->shape[0];
    block->frames = view->shape[1];
    block->row = view->strides[0] / size;
    return 0;
}

void planar_close(planar *block) { PyBuffer_Release(&block->view); }

int row_open(PyObject *object, Py_buffer *view, Py_ssize_t count, Py_ssize_t size, int writable) {
    if (PyObject_GetBuffer(object, view, writable ? PyBUF_CONTIG : PyBUF_CONTIG_RO) < 0) return -1;
    if (view->len % size != 0 || (count >= 0 && view->len != count * size)) {
        PyErr_Format(PyExc_ValueError, "%zd bytes were given, %zd items of %zd bytes are wanted", view->len, count, size);
        PyBuffer_Release(view);
        return -1;
    }
    return 0;
}

#define FUNCTION(name, text) {#name, (PyCFunction)(void (*)(void))name, METH_FASTCALL, PyDoc_STR(text)}

static PyMethodDef table[] = {
    FUNCTION(decode_pcm, "Decode interleaved PCM into planar float64; return all samples or-ed together."),
    FUNCTION(decode_float, "Decode interleaved IEEE float; return the first channel that is not finite, or 0."),
    FUNCTION(convert, "Filter blocks of a stream and bring them to a lower rate."),
    FUNCTION(fourier, "Transform rows of complex numbers in place."),
    FUNCTION(hush, "Set to zero what came of zeros alone."),
    {NULL, NULL, 0, NULL},
};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT,
    .m_name = "audio_checks.kernel._kernel",
    .m_doc = "The hot loops of measuring, compiled.",
    .m_size = 0,
    .m_methods = table,
};

PyMODINIT_FUNC PyInit__kernel(void) { return PyModuleDef_Init(&definition); }
