/* Fourier transforms of four complex signals at once, one in each lane, and what resampling makes of them.
 *
 * Stockham's self-sorting passes of radix 2, 3, 4, 5 and 7. The lanes never meet, so wider
 * registers change no bit of the answer. Value i of lane l lies at 8i+l (real) and 8i+4+l (imaginary).
 * Turns are a table of exp(-2 pi i j / n), j = 0..n-1, made by the caller.
 */
#include "kernel.h"

#define LANES 4
#define VALUE (2 * LANES)
#define EACH for (int l = 0; l < LANES; l++)

typedef Py_ssize_t length;

CLONES static void pass_2(const double *RESTRICT x, double *RESTRICT y, const double *turns, length m, length s) {
    for (length k = 0; k < m; k++) {
        const double *w = turns + 2 * s * k;
        const double *a = x + VALUE * s * k, *b = a + VALUE * s * m;
        double *p = y + VALUE * s * 2 * k, *q = p + VALUE * s;
        for (length t = 0; t < s; t++, a += VALUE, b += VALUE, p += VALUE, q += VALUE) EACH {
                const double ar = a[l], ai = a[LANES + l], br = b[l], bi = b[LANES + l];
                const double dr = ar - br, di = ai - bi;
                p[l] = ar + br;
                p[LANES + l] = ai + bi;
                q[l] = dr * w[0] - di * w[1];
                q[LANES + l] = dr * w[1] + di * w[0];
            }
    }
}

CLONES static void pass_4(const double *RESTRICT x, double *RESTRICT y, const double *turns, length m, length s) {
    for (length k = 0; k < m; k++) {
        const double *w1 = turns + 2 * s * k, *w2 = turns + 4 * s * k, *w3 = turns + 6 * s * k;
        const double *a = x + VALUE * s * k, *b = a + VALUE * s * m, *c = b + VALUE * s * m, *d = c + VALUE * s * m;
        double *p = y + VALUE * s * 4 * k, *q = p + VALUE * s, *r = q + VALUE * s, *u = r + VALUE * s;
        for (length t = 0; t < s;
             t++, a += VALUE, b += VALUE, c += VALUE, d += VALUE, p += VALUE, q += VALUE, r += VALUE, u += VALUE) EACH {
                const double er = a[l] + c[l], ei = a[LANES + l] + c[LANES + l];
                const double fr = a[l] - c[l], fi = a[LANES + l] - c[LANES + l];
                const double gr = b[l] + d[l], gi = b[LANES + l] + d[LANES + l];
                const double hr = b[LANES + l] - d[LANES + l], hi = d[l] - b[l];
                const double qr = fr + hr, qi = fi + hi, rr = er - gr, ri = ei - gi, ur = fr - hr, ui = fi - hi;
                p[l] = er + gr;
                p[LANES + l] = ei + gi;
                q[l] = qr * w1[0] - qi * w1[1];
                q[LANES + l] = qr * w1[1] + qi * w1[0];
                r[l] = rr * w2[0] - ri * w2[1];
                r[LANES + l] = rr * w2[1] + ri * w2[0];
                u[l] = ur * w3[0] - ui * w3[1];
                u[LANES + l] = ur * w3[1] + ui * w3[0];
            }
    }
}

/* An odd radix by sums and differences of the values that lie opposite; `HALF` pairs of them. */
#define ODD_PASS(RADIX, HALF)                                                                                          \
    CLONES static void pass_##RADIX(const double *RESTRICT x, double *RESTRICT y, const double *turns, length n,       \
                                    length m, length s) {                                                              \
        double cosine[HALF + 1][HALF + 1], sine[HALF + 1][HALF + 1];                                                   \
        for (int r = 1; r <= HALF; r++)                                                                                \
            for (int j = 1; j <= HALF; j++) {                                                                          \
                const length at = (length)((r * j) % RADIX) * (n / RADIX) * s;                                         \
                cosine[r][j] = turns[2 * at];                                                                          \
                sine[r][j] = turns[2 * at + 1];                                                                        \
            }                                                                                                          \
        for (length k = 0; k < m; k++)                                                                                 \
            for (length t = 0; t < s; t++) {                                                                           \
                const double *a = x + VALUE * (s * k + t);                                                             \
                double *p = y + VALUE * (s * RADIX * k + t);                                                           \
                double sr[HALF + 1][LANES], si[HALF + 1][LANES], dr[HALF + 1][LANES], di[HALF + 1][LANES];             \
                for (int j = 1; j <= HALF; j++) {                                                                      \
                    const double *b = a + VALUE * s * m * j, *c = a + VALUE * s * m * (RADIX - j);                     \
                    EACH {                                                                                             \
                        sr[j][l] = b[l] + c[l];                                                                        \
                        si[j][l] = b[LANES + l] + c[LANES + l];                                                        \
                        dr[j][l] = b[l] - c[l];                                                                        \
                        di[j][l] = b[LANES + l] - c[LANES + l];                                                        \
                    }                                                                                                  \
                }                                                                                                      \
                EACH {                                                                                                 \
                    double zr = a[l], zi = a[LANES + l];                                                               \
                    for (int j = 1; j <= HALF; j++) {                                                                  \
                        zr += sr[j][l];                                                                                \
                        zi += si[j][l];                                                                                \
                    }                                                                                                  \
                    p[l] = zr;                                                                                         \
                    p[LANES + l] = zi;                                                                                 \
                }                                                                                                      \
                for (int r = 1; r <= HALF; r++) {                                                                      \
                    const double *w = turns + 2 * s * k * r, *v = turns + 2 * s * k * (RADIX - r);                     \
                    double *q = p + VALUE * s * r, *u = p + VALUE * s * (RADIX - r);                                   \
                    EACH {                                                                                             \
                        double er = a[l], ei = a[LANES + l], fr = 0.0, fi = 0.0;                                       \
                        for (int j = 1; j <= HALF; j++) {                                                              \
                            er += cosine[r][j] * sr[j][l];                                                             \
                            ei += cosine[r][j] * si[j][l];                                                             \
                            fr -= sine[r][j] * di[j][l];                                                               \
                            fi += sine[r][j] * dr[j][l];                                                               \
                        }                                                                                              \
                        const double ar = er + fr, ai = ei + fi, br = er - fr, bi = ei - fi;                           \
                        q[l] = ar * w[0] - ai * w[1];                                                                  \
                        q[LANES + l] = ar * w[1] + ai * w[0];                                                          \
                        u[l] = br * v[0] - bi * v[1];                                                                  \
                        u[LANES + l] = br * v[1] + bi * v[0];                                                          \
                    }                                                                                                  \
                }                                                                                                      \
            }                                                                                                          \
    }

ODD_PASS(3, 1)
ODD_PASS(5, 2)
ODD_PASS(7, 3)

static const length RADICES[] = {4, 2, 3, 5, 7};

/* The next radix of a length, or 0 where there is none. */
static length radix_of(length n) {
    for (size_t i = 0; i < sizeof RADICES / sizeof *RADICES; i++)
        if (n % RADICES[i] == 0) return RADICES[i];
    return 0;
}

static int transforms(length n) {
    while (n > 1) {
        const length radix = radix_of(n);
        if (!radix) return 0;
        n /= radix;
    }
    return n == 1;
}

/* Transform `n` values in `x`, with `y` as room to work; return which of the two holds the answer. */
static double *transform(double *x, double *y, const double *turns, length n) {
    length s = 1;
    while (n > 1) {
        const length radix = radix_of(n), m = n / radix;
        switch (radix) {
        case 2: pass_2(x, y, turns, m, s); break;
        case 3: pass_3(x, y, turns, n, m, s); break;
        case 4: pass_4(x, y, turns, m, s); break;
        case 5: pass_5(x, y, turns, n, m, s); break;
        default: pass_7(x, y, turns, n, m, s);
        }
        double *swap = x;
        x = y;
        y = swap;
        s *= radix;
        n = m;
    }
    return x;
}

/* Windows side by side: as many as fit, the rest silent. */
static void gather(double *RESTRICT x, const double *const *window, length n) {
    static const double none = 0.0;
    const double *from[VALUE];
    length step[VALUE];
    for (int v = 0; v < VALUE; v++) {
        from[v] = window[v] ? window[v] : &none;
        step[v] = window[v] ? 1 : 0;
    }
    for (length i = 0; i < n; i++, x += VALUE)
        for (int v = 0; v < VALUE; v++) x[v] = from[v][i * step[v]];
}

/* Weight the spectrum and keep the bins below the new Nyquist frequency. Real and imaginary parts change
 * places, here and in the answer: that makes a transform backwards of one forwards. */
CLONES static void cut(const double *RESTRICT x, double *RESTRICT y, const double *response, length n, length m) {
    for (length j = 0; 2 * j < m; j++) {
        const double weight = response[j];
        const double *a = x + VALUE * j, *b = x + VALUE * (n - j);
        double *p = y + VALUE * j, *q = y + VALUE * (m - j);
        EACH {
            p[l] = a[LANES + l] * weight;
            p[LANES + l] = a[l] * weight;
        }
        if (j) EACH {
                q[l] = b[LANES + l] * weight;
                q[LANES + l] = b[l] * weight;
            }
    }
    if (m % 2 == 0) memset(y + VALUE * (m / 2), 0, VALUE * sizeof(double));
}

typedef struct {
    planar stream, out;
    const double *response, *turns_in, *turns_out;
    length hop_in, hop_out, edge_out, n, m;
} conversion;

static void convert_blocks(const conversion *c, double *x, double *y) {
    const length blocks = c->out.frames / c->hop_out, windows = blocks * c->stream.channels;
    for (length first = 0; first < windows; first += VALUE) {
        const double *window[VALUE] = {0};
        double *to[VALUE] = {0};
        for (int v = 0; v < VALUE && first + v < windows; v++) {
            const length block = (first + v) / c->stream.channels, channel = (first + v) % c->stream.channels;
            window[v] = c->stream.samples + channel * c->stream.row + block * c->hop_in;
            to[v] = c->out.samples + channel * c->out.row + block * c->hop_out;
        }
        gather(x, window, c->n);
        double *spectrum = transform(x, y, c->turns_in, c->n), *room = spectrum == x ? y : x;
        cut(spectrum, room, c->response, c->n, c->m);
        const double *answer = transform(room, spectrum, c->turns_out, c->m);
        for (int v = 0; v < VALUE; v++) {
            if (!to[v]) continue;
            const double *from = answer + VALUE * c->edge_out + (v + LANES) % VALUE;
            for (length i = 0; i < c->hop_out; i++) to[v][i] = from[VALUE * i];
        }
    }
}

/* How many items the buffer holds that was taken last. */
static length items(const holding *held, Py_ssize_t size) { return held->views[held->count - 1].len / size; }

enum { TURN = 2 * sizeof(double) };

PyObject *convert(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    conversion c;
    double *room = NULL;
    if (arguments("convert", count, 8) < 0) return NULL;
    c.hop_in = PyLong_AsSsize_t(args[5]);
    c.hop_out = PyLong_AsSsize_t(args[6]);
    c.edge_out = PyLong_AsSsize_t(args[7]);
    if (PyErr_Occurred() || take_planar(&held, args[0], &c.stream, 0) < 0 || take_planar(&held, args[1], &c.out, 1) < 0 ||
        !(c.response = TAKE_DOUBLES(&held, args[2], -1, 0))) {
        goto refused;
    }
    const length bins = items(&held, sizeof(double));
    if (!(c.turns_in = take_row(&held, args[3], -1, TURN, 0))) goto refused;
    c.n = items(&held, TURN);
    if (!(c.turns_out = take_row(&held, args[4], -1, TURN, 0))) goto refused;
    c.m = items(&held, TURN);
    const length blocks = c.hop_out > 0 ? c.out.frames / c.hop_out : 0;
    if (!transforms(c.n) || !transforms(c.m) || c.hop_out < 1 || c.hop_in < 1 || c.edge_out < 0 || c.m < 1 || c.m > c.n ||
        c.edge_out + c.hop_out > c.m || c.out.channels != c.stream.channels || blocks * c.hop_out != c.out.frames ||
        blocks < 1 || (blocks - 1) * c.hop_in + c.n > c.stream.frames || bins < c.m / 2 + 1) {
        PyErr_SetString(PyExc_ValueError, "the stream, the room for its blocks and their plan do not fit together");
        goto refused;
    }
    if (!(room = PyMem_Malloc((size_t)c.n * 2 * VALUE * sizeof(double)))) {
        PyErr_NoMemory();
        goto refused;
    }
    Py_BEGIN_ALLOW_THREADS
    convert_blocks(&c, room, room + VALUE * c.n);
    Py_END_ALLOW_THREADS
    PyMem_Free(room);
    let_go(&held);
    Py_RETURN_NONE;
refused:
    let_go(&held);
    return NULL;
}

PyObject *fourier(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar re, im;
    const double *turns;
    double *x = NULL;
    if (arguments("fourier", count, 3) < 0) return NULL;
    if (take_planar(&held, args[0], &re, 1) < 0 || take_planar(&held, args[1], &im, 1) < 0 ||
        !(turns = take_row(&held, args[2], re.frames, TURN, 0))) {
        goto refused;
    }
    if (im.frames != re.frames || im.channels != re.channels || !transforms(re.frames)) {
        PyErr_SetString(PyExc_ValueError, "two parts of one shape are wanted, their length a product of 2, 3, 5 and 7");
        goto refused;
    }
    if (!(x = PyMem_Malloc((size_t)re.frames * 2 * VALUE * sizeof(double)))) {
        PyErr_NoMemory();
        goto refused;
    }
    Py_BEGIN_ALLOW_THREADS
    for (length first = 0; first < re.channels; first += LANES) {
        const double *from[VALUE] = {0};
        const length here = re.channels - first < LANES ? re.channels - first : LANES;
        for (length l = 0; l < here; l++) {
            from[l] = re.samples + (first + l) * re.row;
            from[LANES + l] = im.samples + (first + l) * im.row;
        }
        gather(x, from, re.frames);
        const double *done = transform(x, x + VALUE * re.frames, turns, re.frames);
        for (length l = 0; l < here; l++)
            for (length i = 0; i < re.frames; i++) {
                re.samples[(first + l) * re.row + i] = done[VALUE * i + l];
                im.samples[(first + l) * im.row + i] = done[VALUE * i + LANES + l];
            }
    }
    Py_END_ALLOW_THREADS
    PyMem_Free(x);
    let_go(&held);
    Py_RETURN_NONE;
refused:
    let_go(&held);
    return NULL;
}

/* Power of the bins of two real signals that were transformed as the parts of a complex one, z = a + ib: twice the
 * spectrum of a is z[k] + z*[n-k], and twice that of b, but for a quarter turn, z[k] - z*[n-k]. */
CLONES static void split_powers(const double *RESTRICT z, length n, length bins, double *RESTRICT powers) {
    for (length k = 0; k < bins; k++) {
        const double *here = z + VALUE * k, *mirror = z + VALUE * (k ? n - k : 0);
        double *to = powers + VALUE * k;
        EACH {
            const double ar = here[l] + mirror[l], ai = here[LANES + l] - mirror[LANES + l];
            const double br = here[l] - mirror[l], bi = here[LANES + l] + mirror[LANES + l];
            to[l] = (ar * ar + ai * ai) * 0.25;
            to[LANES + l] = (br * br + bi * bi) * 0.25;
        }
    }
}

typedef struct {
    planar signal;
    const double *shape, *turns; /* of a window of n frames */
    length n, first, hop, count; /* windows of each channel start `hop` apart */
} windows;

/* Open what powers() and power_sums() are both given. */
static int take_windows(holding *held, PyObject *signal, PyObject *shape, PyObject *turns, windows *w) {
    if (take_planar(held, signal, &w->signal, 0) < 0 || !(w->shape = TAKE_DOUBLES(held, shape, -1, 0))) return -1;
    w->n = items(held, sizeof(double));
    return (w->turns = take_row(held, turns, w->n, TURN, 0)) ? 0 : -1;
}

static int lie_inside(const windows *w) {
    return w->n >= 1 && transforms(w->n) && w->first >= 0 && w->hop >= 0 && w->count >= 0 &&
           (!w->count || w->first + (w->count - 1) * w->hop + w->n <= w->signal.frames);
}

CLONES static void gather_faded(double *RESTRICT x, const double *const *window, const double *RESTRICT shape, length n) {
    const double *a = window[0], *b = window[1], *c = window[2], *d = window[3];
    const double *e = window[4], *f = window[5], *g = window[6], *h = window[7];
    for (length i = 0; i < n; i++, x += VALUE) {
        const double weight = shape[i];
        x[0] = a[i] * weight, x[1] = b[i] * weight, x[2] = c[i] * weight, x[3] = d[i] * weight;
        x[4] = e[i] * weight, x[5] = f[i] * weight, x[6] = g[i] * weight, x[7] = h[i] * weight;
    }
}

/* Find the powers of the next windows, numbers `done` on, side by side; `x` is room for two transforms. */
static const double *next_powers(const windows *w, length done, length here, length bins, double *x) {
    const double *from[VALUE];
    for (length v = 0; v < VALUE; v++) { /* where fewer are left, the last one comes again and is not looked at */
        const length number = done + (v < here ? v : here - 1), channel = number % w->signal.channels;
        from[v] = w->signal.samples + channel * w->signal.row + w->first + number / w->signal.channels * w->hop;
    }
    gather_faded(x, from, w->shape, w->n);
    double *spectrum = transform(x, x + VALUE * w->n, w->turns, w->n), *room = spectrum == x ? x + VALUE * w->n : x;
    split_powers(spectrum, w->n, bins, room);
    return room;
}

/* signal, window, first start, distance of starts, turns, powers to fill: (windows of all channels, bins), the channels
 * of one window after each other */
PyObject *powers(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    windows w;
    planar out;
    double *x = NULL;
    if (arguments("powers", count, 6) < 0) return NULL;
    w.first = PyLong_AsSsize_t(args[2]), w.hop = PyLong_AsSsize_t(args[3]);
    if (PyErr_Occurred() || take_windows(&held, args[0], args[1], args[4], &w) < 0 || take_planar(&held, args[5], &out, 1) < 0) {
        goto refused;
    }
    w.count = w.signal.channels ? out.channels / w.signal.channels : 0;
    if (!lie_inside(&w) || out.frames > w.n || w.count * w.signal.channels != out.channels) {
        PyErr_SetString(PyExc_ValueError, "windows inside the signal and a row of bins for each channel of each are wanted");
        goto refused;
    }
    if (!(x = PyMem_Malloc((size_t)w.n * 2 * VALUE * sizeof(double)))) {
        PyErr_NoMemory();
        goto refused;
    }
    Py_BEGIN_ALLOW_THREADS
    for (length done = 0; done < out.channels; done += VALUE) {
        const length here = out.channels - done < VALUE ? out.channels - done : VALUE;
        const double *found = next_powers(&w, done, here, out.frames, x);
        for (length v = 0; v < here; v++)
            for (length k = 0; k < out.frames; k++) out.samples[(done + v) * out.row + k] = found[VALUE * k + v];
    }
    Py_END_ALLOW_THREADS
    PyMem_Free(x);
    let_go(&held);
    Py_RETURN_NONE;
refused:
    let_go(&held);
    return NULL;
}

/* signal, window, first start, distance of starts, how many windows, turns, sums to add to, one for each bin */
PyObject *power_sums(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    windows w;
    double *sums, *x = NULL;
    if (arguments("power_sums", count, 7) < 0) return NULL;
    w.first = PyLong_AsSsize_t(args[2]), w.hop = PyLong_AsSsize_t(args[3]), w.count = PyLong_AsSsize_t(args[4]);
    if (PyErr_Occurred() || take_windows(&held, args[0], args[1], args[5], &w) < 0 ||
        !(sums = TAKE_DOUBLES(&held, args[6], -1, 1))) {
        goto refused;
    }
    const length bins = items(&held, sizeof(double)), all = w.count * w.signal.channels;
    if (!lie_inside(&w) || bins > w.n) {
        PyErr_SetString(PyExc_ValueError, "windows inside the signal and sums for their bins are wanted");
        goto refused;
    }
    if (!(x = PyMem_Malloc((size_t)w.n * 2 * VALUE * sizeof(double)))) {
        PyErr_NoMemory();
        goto refused;
    }
    Py_BEGIN_ALLOW_THREADS
    for (length done = 0; done < all; done += VALUE) {
        const length here = all - done < VALUE ? all - done : VALUE;
        const double *found = next_powers(&w, done, here, bins, x);
        for (length k = 0; k < bins; k++)
            for (length v = 0; v < here; v++) sums[k] += found[VALUE * k + v];
    }
    Py_END_ALLOW_THREADS
    PyMem_Free(x);
    let_go(&held);
    Py_RETURN_NONE;
refused:
    let_go(&held);
    return NULL;
}

PyObject *hush(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar stream, out;
    const int64_t *from, *until;
    if (arguments("hush", count, 4) < 0) return NULL;
    if (take_planar(&held, args[0], &stream, 0) < 0 || take_planar(&held, args[1], &out, 1) < 0 ||
        !(from = take_row(&held, args[2], out.frames, sizeof(int64_t), 0)) ||
        !(until = take_row(&held, args[3], out.frames, sizeof(int64_t), 0))) {
        goto refused;
    }
    int64_t least = 0;
    for (length i = 0; i < out.frames; i++) {
        if (from[i] < least || until[i] < from[i] || until[i] >= stream.frames) {
            PyErr_SetString(PyExc_ValueError, "what a frame hears must lie inside the stream, in rising order");
            goto refused;
        }
        least = from[i];
    }
    if (out.channels != stream.channels) {
        PyErr_SetString(PyExc_ValueError, "the stream and what came of it have different channels");
        goto refused;
    }
    Py_BEGIN_ALLOW_THREADS
    for (length channel = 0; channel < out.channels; channel++) {
        const double *heard = stream.samples + channel * stream.row;
        double *to = out.samples + channel * out.row;
        length sounding = 0; /* the first frame from from[i] on that is not zero */
        for (length i = 0; i < out.frames; i++) {
            if (sounding < from[i]) sounding = from[i];
            while (sounding <= until[i] && heard[sounding] == 0.0) sounding++;
            if (sounding > until[i]) to[i] = 0.0;
        }
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    Py_RETURN_NONE;
refused:
    let_go(&held);
    return NULL;
}
