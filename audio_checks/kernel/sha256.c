/* SHA-256 of two streams at once: the file and the sound in it are the same bytes, cut into blocks differently.
 *
 * A processor with instructions for SHA-256 waits for each round of one stream; a second stream fills the wait. Where
 * there are no such instructions, `hashes_two` says so and Python's hashlib does it. Source: FIPS 180-4, section 6.2.
 */
#include "kernel.h"

enum { BLOCK = 64, WORDS = 8 };

/* What is kept between calls: the hash so far, the bytes taken, and those that fill no block yet. */
typedef struct {
    uint32_t hash[WORDS];
    uint64_t taken;
    uint8_t rest[BLOCK];
} stream;

#if defined(__GNUC__) && defined(__x86_64__)
#include <cpuid.h>
#include <immintrin.h>

#define WITH_SHA __attribute__((target("sha,sse4.1")))
#define INLINE static inline __attribute__((always_inline)) WITH_SHA

static const uint32_t CONSTANTS[BLOCK] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2,
};

/* One block on its way through the rounds; the state as the instructions want it: A B E F and C D G H. */
typedef struct {
    __m128i abef, cdgh, abef_before, cdgh_before, words[4];
} rounds;

INLINE void load_state(rounds *run, const uint32_t *hash) {
    const __m128i abcd = _mm_shuffle_epi32(_mm_loadu_si128((const __m128i *)hash), 0xb1);       /* C D A B */
    const __m128i efgh = _mm_shuffle_epi32(_mm_loadu_si128((const __m128i *)(hash + 4)), 0x1b); /* E F G H */
    run->abef = _mm_alignr_epi8(abcd, efgh, 8);
    run->cdgh = _mm_blend_epi16(efgh, abcd, 0xf0);
}

INLINE void store_state(const rounds *run, uint32_t *hash) {
    const __m128i feba = _mm_shuffle_epi32(run->abef, 0x1b), dchg = _mm_shuffle_epi32(run->cdgh, 0xb1);
    _mm_storeu_si128((__m128i *)hash, _mm_blend_epi16(feba, dchg, 0xf0));
    _mm_storeu_si128((__m128i *)(hash + 4), _mm_alignr_epi8(dchg, feba, 8));
}

INLINE void open_block(rounds *run, const uint8_t *bytes) {
    const __m128i big_endian = _mm_set_epi64x(0x0c0d0e0f08090a0b, 0x0405060700010203);
    for (int which = 0; which < 4; which++) {
        run->words[which] = _mm_shuffle_epi8(_mm_loadu_si128((const __m128i *)(bytes + 16 * which)), big_endian);
    }
    run->abef_before = run->abef, run->cdgh_before = run->cdgh;
}

/* Four rounds, and the words for those that come twelve rounds later. */
INLINE void four_rounds(rounds *run, int four) {
    const __m128i words = run->words[four % 4];
    const __m128i keyed = _mm_add_epi32(words, _mm_loadu_si128((const __m128i *)(CONSTANTS + 4 * four)));
    run->cdgh = _mm_sha256rnds2_epu32(run->cdgh, run->abef, keyed);
    run->abef = _mm_sha256rnds2_epu32(run->abef, run->cdgh, _mm_shuffle_epi32(keyed, 0x0e));
    if (four < 12) {
        const __m128i second = run->words[(four + 1) % 4], third = run->words[(four + 2) % 4];
        const __m128i fourth = run->words[(four + 3) % 4];
        const __m128i sum = _mm_add_epi32(_mm_sha256msg1_epu32(words, second), _mm_alignr_epi8(fourth, third, 4));
        run->words[four % 4] = _mm_sha256msg2_epu32(sum, fourth);
    }
}

INLINE void close_block(rounds *run) {
    run->abef = _mm_add_epi32(run->abef, run->abef_before);
    run->cdgh = _mm_add_epi32(run->cdgh, run->cdgh_before);
}

WITH_SHA static void hash_one(stream *one, const uint8_t *bytes, Py_ssize_t blocks) {
    rounds run;
    load_state(&run, one->hash);
    for (; blocks > 0; blocks--, bytes += BLOCK) {
        open_block(&run, bytes);
#pragma GCC unroll 16
        for (int four = 0; four < 16; four++) four_rounds(&run, four);
        close_block(&run);
    }
    store_state(&run, one->hash);
}

WITH_SHA static void hash_both(stream *one, const uint8_t *bytes, stream *other, const uint8_t *others,
                               Py_ssize_t blocks) {
    rounds run, beside;
    load_state(&run, one->hash);
    load_state(&beside, other->hash);
    for (; blocks > 0; blocks--, bytes += BLOCK, others += BLOCK) {
        open_block(&run, bytes);
        open_block(&beside, others);
#pragma GCC unroll 16
        for (int four = 0; four < 16; four++) {
            four_rounds(&run, four);
            four_rounds(&beside, four);
        }
        close_block(&run);
        close_block(&beside);
    }
    store_state(&run, one->hash);
    store_state(&beside, other->hash);
}

static int find_able(void) {
    unsigned int a, b, c, d;
    const unsigned int ssse3_and_sse4_1 = 1u << 9 | 1u << 19;
    if (!__get_cpuid(1, &a, &b, &c, &d) || (c & ssse3_and_sse4_1) != ssse3_and_sse4_1) return 0;
    return __get_cpuid_count(7, 0, &a, &b, &c, &d) && (b >> 29 & 1);
}
#else
static void hash_one(stream *one, const uint8_t *bytes, Py_ssize_t blocks) { (void)one, (void)bytes, (void)blocks; }
static void hash_both(stream *one, const uint8_t *bytes, stream *other, const uint8_t *others, Py_ssize_t blocks) {
    (void)one, (void)bytes, (void)other, (void)others, (void)blocks;
}
static int find_able(void) { return 0; }
#endif

/* Asked once: in a virtual machine the question takes as long as hashing 50 kB. */
static int able(void) {
    static int known = -1;
    if (known < 0) known = find_able();
    return known;
}

/* Fill up the block that has begun, and return how many of the bytes that took. */
static Py_ssize_t fill(stream *one, const uint8_t *bytes, Py_ssize_t count) {
    const Py_ssize_t begun = (Py_ssize_t)(one->taken % BLOCK);
    if (!begun) return 0;
    const Py_ssize_t wanted = BLOCK - begun < count ? BLOCK - begun : count;
    memcpy(one->rest + begun, bytes, (size_t)wanted);
    one->taken += (uint64_t)wanted;
    if (begun + wanted == BLOCK) hash_one(one, one->rest, 1);
    return wanted;
}

static void keep(stream *one, const uint8_t *bytes, Py_ssize_t count) {
    hash_one(one, bytes, count / BLOCK);
    memcpy(one->rest, bytes + count / BLOCK * BLOCK, (size_t)(count % BLOCK));
    one->taken += (uint64_t)count;
}

static void finish(stream *one, uint8_t *digest) {
    uint8_t end[2 * BLOCK] = {0x80};
    const uint64_t bits = one->taken * 8;
    const Py_ssize_t padding = (Py_ssize_t)((2 * BLOCK - 9 - one->taken % BLOCK) % BLOCK) + 1;
    for (int byte = 0; byte < 8; byte++) end[padding + byte] = (uint8_t)(bits >> (56 - 8 * byte));
    const Py_ssize_t filled = fill(one, end, padding + 8);
    keep(one, end + filled, padding + 8 - filled);
    for (int word = 0; word < WORDS; word++) {
        for (int byte = 0; byte < 4; byte++) digest[4 * word + byte] = (uint8_t)(one->hash[word] >> (24 - 8 * byte));
    }
}

static stream *take_stream(holding *held, PyObject *object) { return take_row(held, object, 1, sizeof(stream), 1); }

PyObject *hashes_two(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module, (void)args;
    if (arguments("hashes_two", count, 0) < 0) return NULL;
    return PyBool_FromLong(able());
}

PyObject *hash_begin(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module, (void)args;
    if (arguments("hash_begin", count, 0) < 0) return NULL;
    if (!able()) {
        PyErr_SetString(PyExc_RuntimeError, "this processor has no instructions for SHA-256; hashlib is wanted");
        return NULL;
    }
    const stream fresh = {.hash = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab,
                                   0x5be0cd19}};
    return PyByteArray_FromStringAndSize((const char *)&fresh, sizeof fresh);
}

PyObject *hash_add(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    stream *one, *other = NULL;
    const uint8_t *bytes;
    if (count != 3) count = arguments("hash_add", count, 2) < 0 ? 0 : 2;
    if (!count || !(one = take_stream(&held, args[0])) || (count == 3 && !(other = take_stream(&held, args[1]))) ||
        !(bytes = take_row(&held, args[count - 1], -1, 1, 0))) {
        let_go(&held);
        return NULL;
    }
    const Py_ssize_t size = held.views[held.count - 1].len;
    Py_BEGIN_ALLOW_THREADS
    Py_ssize_t first = fill(one, bytes, size), second = 0, together_blocks = 0;
    if (other) {
        second = fill(other, bytes, size);
        together_blocks = (size - (first > second ? first : second)) / BLOCK;
        hash_both(one, bytes + first, other, bytes + second, together_blocks);
        one->taken += (uint64_t)(together_blocks * BLOCK), other->taken += (uint64_t)(together_blocks * BLOCK);
        second += together_blocks * BLOCK;
        keep(other, bytes + second, size - second);
    }
    first += together_blocks * BLOCK;
    keep(one, bytes + first, size - first);
    Py_END_ALLOW_THREADS
    let_go(&held);
    Py_RETURN_NONE;
}

PyObject *hash_end(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    stream *one;
    uint8_t digest[4 * WORDS];
    if (arguments("hash_end", count, 1) < 0 || !(one = take_stream(&held, args[0]))) {
        let_go(&held);
        return NULL;
    }
    stream last = *one; /* what was given can go on */
    finish(&last, digest);
    let_go(&held);
    return PyBytes_FromStringAndSize((const char *)digest, sizeof digest);
}
