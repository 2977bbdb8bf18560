/* Fourier transforms of four complex signals at once, one in each lane, and what resampling makes of them.
 *
 * Stockham's self-sorting passes of radix 2, 3, 4, 5, 7 and 11. The lanes never meet, so wider
 * registers change no bit of the answer. Value i of lane l lies at 8i+l (real) and 8i+4+l (imaginary).
 * Turns are a table of exp(-2 pi i j / n), j = 0..n-1, made by the caller.
 */
#include "fourier.h"

CLONES static void pass_2(const double *RESTRICT x, double *RESTRICT y, const double *turns, length m, length s) {
    for (length k = 0; k < m; k++) {
        const double w[2] = {turns[2 * s * k], turns[2 * s * k + 1]};
        const double *a = x + VALUE * s * k, *b = a + VALUE * s * m;
        double *p = y + VALUE * s * 2 * k, *q = p + VALUE * s;
        for (length t = 0; t < s; t++, a += VALUE, b += VALUE, p += VALUE, q += VALUE) EACH {
                const numbers ar = IN_RE(a), ai = IN_IM(a), br = IN_RE(b), bi = IN_IM(b);
                const numbers dr = ar - br, di = ai - bi;
                RE(p) = ar + br;
                IM(p) = ai + bi;
                RE(q) = dr * w[0] - di * w[1];
                IM(q) = dr * w[1] + di * w[0];
            }
    }
}

CLONES static void pass_4(const double *RESTRICT x, double *RESTRICT y, const double *turns, length m, length s) {
    for (length k = 0; k < m; k++) {
        const double *at = turns + 2 * s * k, w1[2] = {at[0], at[1]}, w2[2] = {at[2 * s * k], at[2 * s * k + 1]};
        const double w3[2] = {at[4 * s * k], at[4 * s * k + 1]};
        const double *a = x + VALUE * s * k, *b = a + VALUE * s * m, *c = b + VALUE * s * m, *d = c + VALUE * s * m;
        double *p = y + VALUE * s * 4 * k, *q = p + VALUE * s, *r = q + VALUE * s, *u = r + VALUE * s;
        for (length t = 0; t < s;
             t++, a += VALUE, b += VALUE, c += VALUE, d += VALUE, p += VALUE, q += VALUE, r += VALUE, u += VALUE) EACH {
                const numbers er = IN_RE(a) + IN_RE(c), ei = IN_IM(a) + IN_IM(c);
                const numbers fr = IN_RE(a) - IN_RE(c), fi = IN_IM(a) - IN_IM(c);
                const numbers gr = IN_RE(b) + IN_RE(d), gi = IN_IM(b) + IN_IM(d);
                const numbers hr = IN_IM(b) - IN_IM(d), hi = IN_RE(d) - IN_RE(b);
                const numbers qr = fr + hr, qi = fi + hi, rr = er - gr, ri = ei - gi, ur = fr - hr, ui = fi - hi;
                RE(p) = er + gr;
                IM(p) = ei + gi;
                RE(q) = qr * w1[0] - qi * w1[1];
                IM(q) = qr * w1[1] + qi * w1[0];
                RE(r) = rr * w2[0] - ri * w2[1];
                IM(r) = rr * w2[1] + ri * w2[0];
                RE(u) = ur * w3[0] - ui * w3[1];
                IM(u) = ur * w3[1] + ui * w3[0];
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
            for (length t = 0; t < s; t++) EACH {                                                                      \
                    const double *a = x + VALUE * (s * k + t);                                                         \
                    double *p = y + VALUE * (s * RADIX * k + t);                                                       \
                    const numbers ar = IN_RE(a), ai = IN_IM(a);                                                        \
                    numbers sr[HALF + 1], si[HALF + 1], dr[HALF + 1], di[HALF + 1], zr = ar, zi = ai;                  \
                    for (int j = 1; j <= HALF; j++) {                                                                  \
                        const double *b = a + VALUE * s * m * j, *c = a + VALUE * s * m * (RADIX - j);                 \
                        sr[j] = IN_RE(b) + IN_RE(c);                                                                   \
                        si[j] = IN_IM(b) + IN_IM(c);                                                                   \
                        dr[j] = IN_RE(b) - IN_RE(c);                                                                   \
                        di[j] = IN_IM(b) - IN_IM(c);                                                                   \
                        zr += sr[j];                                                                                   \
                        zi += si[j];                                                                                   \
                    }                                                                                                  \
                    RE(p) = zr;                                                                                        \
                    IM(p) = zi;                                                                                        \
                    for (int r = 1; r <= HALF; r++) {                                                                  \
                        const double *w = turns + 2 * s * k * r, *v = turns + 2 * s * k * (RADIX - r);                 \
                        double *q = p + VALUE * s * r, *u = p + VALUE * s * (RADIX - r);                               \
                        numbers er = ar, ei = ai, fr = NONE, fi = NONE;                                                \
                        for (int j = 1; j <= HALF; j++) {                                                              \
                            er += cosine[r][j] * sr[j];                                                                \
                            ei += cosine[r][j] * si[j];                                                                \
                            fr -= sine[r][j] * di[j];                                                                  \
                            fi += sine[r][j] * dr[j];                                                                  \
                        }                                                                                              \
                        const numbers gr = er + fr, gi = ei + fi, hr = er - fr, hi = ei - fi;                          \
                        RE(q) = gr * w[0] - gi * w[1];                                                                 \
                        IM(q) = gr * w[1] + gi * w[0];                                                                 \
                        RE(u) = hr * v[0] - hi * v[1];                                                                 \
                        IM(u) = hr * v[1] + hi * v[0];                                                                 \
                    }                                                                                                  \
                }                                                                                                      \
    }

ODD_PASS(3, 1)
ODD_PASS(5, 2)
ODD_PASS(7, 3)
ODD_PASS(11, 5)

static const length RADICES[] = {4, 2, 3, 5, 7, 11};

/* The next radix of a length, or 0 where there is none. */
static length radix_of(length n) {
    for (size_t i = 0; i < sizeof RADICES / sizeof *RADICES; i++)
        if (n % RADICES[i] == 0) return RADICES[i];
    return 0;
}

int transforms(length n) {
    while (n > 1) {
        const length radix = radix_of(n);
        if (!radix) return 0;
        n /= radix;
    }
    return n == 1;
}

double *transform(double *x, double *y, const double *turns, length n) {
    length s = 1;
    while (n > 1) {
        const length radix = radix_of(n), m = n / radix;
        switch (radix) {
        case 2: pass_2(x, y, turns, m, s); break;
        case 3: pass_3(x, y, turns, n, m, s); break;
        case 4: pass_4(x, y, turns, m, s); break;
        case 5: pass_5(x, y, turns, n, m, s); break;
        case 7: pass_7(x, y, turns, n, m, s); break;
        default: pass_11(x, y, turns, n, m, s);
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
            RE(p) = IN_IM(a) * weight;
            IM(p) = IN_RE(a) * weight;
        }
        if (j) EACH {
                RE(q) = IN_IM(b) * weight;
                IM(q) = IN_RE(b) * weight;
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

length items(const holding *held, Py_ssize_t size) { return held->views[held->count - 1].len / size; }

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
        PyErr_SetString(PyExc_ValueError, "two parts of one shape are wanted, their length a product of 2, 3, 5, 7 and 11");
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

CLONES void split_powers(const double *RESTRICT z, length n, length bins, double *RESTRICT powers) {
    for (length k = 0; k < bins; k++) {
        const double *here = z + VALUE * k, *mirror = z + VALUE * (k ? n - k : 0);
        double *to = powers + VALUE * k;
        EACH {
            const numbers ar = IN_RE(here) + IN_RE(mirror), ai = IN_IM(here) - IN_IM(mirror);
            const numbers br = IN_RE(here) - IN_RE(mirror), bi = IN_IM(here) + IN_IM(mirror);
            RE(to) = (ar * ar + ai * ai) * 0.25;
            IM(to) = (br * br + bi * bi) * 0.25;
        }
    }
}

int take_windows(holding *held, PyObject *signal, PyObject *shape, PyObject *turns, windows *w) {
    if (take_planar(held, signal, &w->signal, 0) < 0 || !(w->shape = TAKE_DOUBLES(held, shape, -1, 0))) return -1;
    w->n = items(held, sizeof(double));
    return (w->turns = take_row(held, turns, w->n, TURN, 0)) ? 0 : -1;
}

int lie_inside(const windows *w) {
    return w->n >= 1 && transforms(w->n) && w->first >= 0 && w->hop >= 0 && w->count >= 0 &&
           (!w->count || w->first + (w->count - 1) * w->hop + w->n <= w->signal.frames);
}

CLONES void gather_faded(double *RESTRICT x, const double *const *window, const double *RESTRICT shape, length n) {
    const double *a = window[0], *b = window[1], *c = window[2], *d = window[3];
    const double *e = window[4], *f = window[5], *g = window[6], *h = window[7];
    for (length i = 0; i < n; i++, x += VALUE) {
        const double weight = shape[i];
        x[0] = a[i] * weight, x[1] = b[i] * weight, x[2] = c[i] * weight, x[3] = d[i] * weight;
        x[4] = e[i] * weight, x[5] = f[i] * weight, x[6] = g[i] * weight, x[7] = h[i] * weight;
    }
}

PyObject *restore_silence(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar stream, out;
    const int64_t *from, *until;
    if (arguments("restore_silence", count, 4) < 0) return NULL;
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
