/* RNA 1.0 in C; rna.h says what it offers.
 *
 *     1 Reports          what is wrong with a package
 *     2 Hashes           CRC-32 and SHA-256
 *     3 JSON             strict: UTF-8, no key twice, finite numbers, 64 levels
 *     4 Rules            tables of the members an object may have
 *     5 Container        the ZIP shape
 *     6 Manifest
 *     7 Tensor files     safetensors: planes and curves
 *     8 Mesh             binary glTF
 *     9 ONNX             the structure of a decoder, whatever it computes
 *    10 Decoder          chains of layers: loaded, and run on 48 rows at a time
 *    11 Queries          what a decoder sees of a point
 *    12 The interface
 *
 * Nothing read from a package is trusted before it was compared with the bytes that are there. */
#define _POSIX_C_SOURCE 200809L
#include "rna.h"

#include <fcntl.h>
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "packages are little-endian and used in place"
#endif
#ifdef __FAST_MATH__
#error "-ffast-math breaks rounding and the handling of NaN; leave it out for this file"
#endif

#if defined(__GNUC__)
#define PRINTF(text, first) __attribute__((format(printf, text, first)))
#define PREFETCH(address) __builtin_prefetch(address)
#else
#define PRINTF(text, first)
#define PREFETCH(address) ((void)(address))
#endif

/* Limits of section 11. */
enum {
    ALIGNMENT = 64,
    MAX_ENTRIES = 256,
    MAX_NAME = 200,
    MAX_MANIFEST = 1 << 20,
    MAX_DEPTH = 64,
    MAX_TIERS = 16,
    MAX_CHANNELS = 64,
    MAX_HEADER = 1 << 16, /* JSON of a mesh, header of a tensor file */
    MAX_POINTS = 1 << 26,
    MAX_STRANDS = 1 << 25,
    MAX_DECODER = 1 << 26,
    MAX_NODES = 4096,
    MAX_WIDTH = 8192,
    MAX_WIRE_ITEMS = 1 << 18
};

/* Some bytes of the package; where they are text, without an end mark. */
typedef struct Span {
    const uint8_t *at;
    size_t size;
} Span;

static bool span_is(Span span, const char *text) {
    return span.size == strlen(text) && memcmp(span.at, text, span.size) == 0;
}

static bool same_span(Span a, Span b) {
    return a.size == b.size && (a.size == 0 || memcmp(a.at, b.at, a.size) == 0);
}

static uint32_t u16_at(const uint8_t *at) { return at[0] | (uint32_t)at[1] << 8; }
static uint32_t u32_at(const uint8_t *at) { return u16_at(at) | u16_at(at + 2) << 16; }
static uint64_t u64_at(const uint8_t *at) { return u32_at(at) | (uint64_t)u32_at(at + 4) << 32; }

/* ---------------------------------------------------------------- 1 Reports */

static void put_text(char *out, size_t size, const char *format, va_list arguments) {
    vsnprintf(out, size, format, arguments);
    for (; *out; out++)
        if ((unsigned char)*out < 0x20 || (unsigned char)*out > 0x7e) *out = '?';
}

static void add_issue(RnaReport *report, bool is_error, const char *code, const char *where,
                      const char *expected, const char *found, va_list arguments) {
    report->errors += is_error;
    if (report->count == RNA_MAX_ISSUES) return;
    RnaIssue *issue = &report->issues[report->count++];
    issue->code = code;
    issue->is_error = is_error;
    snprintf(issue->where, sizeof issue->where, "%s", where);
    snprintf(issue->expected, sizeof issue->expected, "%s", expected);
    put_text(issue->found, sizeof issue->found, found, arguments);
}

/* Notes an error.  Returns false, so that a check can end with it. */
PRINTF(5, 6)
static bool refuse(RnaReport *report, const char *code, const char *where, const char *expected,
                   const char *found, ...) {
    va_list arguments;
    va_start(arguments, found);
    add_issue(report, true, code, where, expected, found, arguments);
    va_end(arguments);
    return false;
}

PRINTF(5, 6)
static void warn(RnaReport *report, const char *code, const char *where, const char *expected,
                 const char *found, ...) {
    va_list arguments;
    va_start(arguments, found);
    add_issue(report, false, code, where, expected, found, arguments);
    va_end(arguments);
}

/* "byte N" for the place of an issue in the file. */
typedef struct Place {
    char text[32];
} Place;

static Place byte_place(size_t offset) {
    Place place;
    snprintf(place.text, sizeof place.text, "byte %zu", offset);
    return place;
}

/* ----------------------------------------------------------------- 2 Hashes */

static uint32_t crc32(Span data) {
    uint32_t table[256];
    for (uint32_t i = 0; i < 256; i++) {
        uint32_t c = i;
        for (int bit = 0; bit < 8; bit++) c = c >> 1 ^ (c & 1 ? 0xEDB88320u : 0);
        table[i] = c;
    }
    uint32_t crc = ~0u;
    for (size_t i = 0; i < data.size; i++) crc = table[(crc ^ data.at[i]) & 0xff] ^ crc >> 8;
    return ~crc;
}

static uint32_t rotated(uint32_t x, int n) { return x >> n | x << (32 - n); }

/* One block of SHA-256 (FIPS 180-4, 6.2.2). */
static void sha256_block(uint32_t state[8], const uint8_t *block) {
    static const uint32_t K[64] = {
        0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4,
        0xab1c5ed5, 0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe,
        0x9bdc06a7, 0xc19bf174, 0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f,
        0x4a7484aa, 0x5cb0a9dc, 0x76f988da, 0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7,
        0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967, 0x27b70a85, 0x2e1b2138, 0x4d2c6dfc,
        0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85, 0xa2bfe8a1, 0xa81a664b,
        0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070, 0x19a4c116,
        0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
        0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7,
        0xc67178f2};
    uint32_t w[64], s[8];
    for (int i = 0; i < 16; i++)
        w[i] = (uint32_t)block[4 * i] << 24 | (uint32_t)block[4 * i + 1] << 16 |
               (uint32_t)block[4 * i + 2] << 8 | block[4 * i + 3];
    for (int i = 16; i < 64; i++) {
        uint32_t a = w[i - 15], b = w[i - 2];
        w[i] = w[i - 16] + w[i - 7] + (rotated(a, 7) ^ rotated(a, 18) ^ a >> 3) +
               (rotated(b, 17) ^ rotated(b, 19) ^ b >> 10);
    }
    memcpy(s, state, sizeof s);
    for (int i = 0; i < 64; i++) {
        uint32_t e = s[4], a = s[0];
        uint32_t t1 = s[7] + (rotated(e, 6) ^ rotated(e, 11) ^ rotated(e, 25)) +
                      ((e & s[5]) ^ (~e & s[6])) + K[i] + w[i];
        uint32_t t2 = (rotated(a, 2) ^ rotated(a, 13) ^ rotated(a, 22)) +
                      ((a & s[1]) ^ (a & s[2]) ^ (s[1] & s[2]));
        memmove(s + 1, s, 7 * sizeof *s);
        s[4] += t1;
        s[0] = t1 + t2;
    }
    for (int i = 0; i < 8; i++) state[i] += s[i];
}

/* 64 lower-case hexadecimal digits and an end mark. */
static void sha256(Span data, char digits[65]) {
    uint32_t state[8] = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    size_t whole = data.size / 64 * 64, rest = data.size - whole;
    for (size_t i = 0; i < whole; i += 64) sha256_block(state, data.at + i);
    uint8_t tail[128] = {0};
    if (rest) memcpy(tail, data.at + whole, rest);
    tail[rest] = 0x80;
    size_t end = rest < 56 ? 64 : 128;
    for (size_t i = 0; i < 8; i++) tail[end - 1 - i] = (uint8_t)((uint64_t)data.size * 8 >> 8 * i);
    for (size_t i = 0; i < end; i += 64) sha256_block(state, tail + i);
    for (int i = 0; i < 8; i++) snprintf(digits + 8 * i, 9, "%08x", (unsigned)state[i]);
}

/* ------------------------------------------------------------------- 3 JSON */

typedef enum JsonType {
    JSON_NULL,
    JSON_FALSE,
    JSON_TRUE,
    JSON_NUMBER,
    JSON_STRING,
    JSON_ARRAY,
    JSON_OBJECT
} JsonType;

typedef struct Json {
    JsonType type;
    Span key;    /* of a member */
    Span string; /* unescaped, with a zero byte behind it */
    double number;
    struct Json *first, *next; /* items or members, and the next one beside this */
    size_t count;
} Json;

/* A parsed text.  Its strings and values are in two blocks of memory. */
typedef struct JsonText {
    const uint8_t *at, *end;
    uint8_t *strings; /* where the next string goes */
    Json *values;     /* where the next value goes */
    int depth;
    const char *code;    /* of the issue, once there is one */
    const char *found;
    uint8_t *string_block;
    Json *value_block;
} JsonText;

static bool json_fails(JsonText *text, const char *code, const char *found) {
    if (!text->code) text->code = code, text->found = found;
    return false;
}

static const char MALFORMED[] = "malformed"; /* stands for the caller's code */

static bool is_utf8(Span text) {
    const uint8_t *at = text.at, *end = text.at + text.size;
    while (at < end) {
        if (*at < 0x80) {
            at++;
            continue;
        }
        int more = *at >= 0xc2 && *at < 0xe0 ? 1 : *at >= 0xe0 && *at < 0xf0 ? 2 : 3;
        if (*at < 0xc2 || *at > 0xf4 || end - at <= more) return false;
        uint8_t low = *at == 0xe0 ? 0xa0 : *at == 0xf0 ? 0x90 : 0x80;
        uint8_t high = *at == 0xed ? 0x9f : *at == 0xf4 ? 0x8f : 0xbf;
        if (at[1] < low || at[1] > high) return false;
        for (int i = 2; i <= more; i++)
            if (at[i] < 0x80 || at[i] > 0xbf) return false;
        at += more + 1;
    }
    return true;
}

static void skip_space(JsonText *text) {
    while (text->at < text->end && memchr(" \t\r\n", *text->at, 4)) text->at++;
}

static bool take(JsonText *text, char c) {
    if (text->at == text->end || *text->at != (uint8_t)c) return false;
    text->at++;
    return true;
}

static bool take_word(JsonText *text, const char *word) {
    size_t size = strlen(word);
    if ((size_t)(text->end - text->at) < size || memcmp(text->at, word, size)) return false;
    text->at += size;
    return true;
}

/* Four hexadecimal digits; -1 where they are not there. */
static int32_t take_hex(JsonText *text) {
    int32_t value = 0;
    if (text->end - text->at < 4) return -1;
    for (int i = 0; i < 4; i++) {
        int c = *text->at++;
        int digit = c >= '0' && c <= '9'   ? c - '0'
                    : c >= 'a' && c <= 'f' ? c - 'a' + 10
                    : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                           : -1;
        if (digit < 0) return -1;
        value = value << 4 | digit;
    }
    return value;
}

static void put_utf8(JsonText *text, uint32_t c) {
    uint8_t *out = text->strings;
    if (c < 0x80) {
        *out++ = (uint8_t)c;
    } else if (c < 0x800) {
        *out++ = (uint8_t)(0xc0 | c >> 6);
        *out++ = (uint8_t)(0x80 | (c & 0x3f));
    } else {
        if (c < 0x10000) {
            *out++ = (uint8_t)(0xe0 | c >> 12);
        } else {
            *out++ = (uint8_t)(0xf0 | c >> 18);
            *out++ = (uint8_t)(0x80 | (c >> 12 & 0x3f));
        }
        *out++ = (uint8_t)(0x80 | (c >> 6 & 0x3f));
        *out++ = (uint8_t)(0x80 | (c & 0x3f));
    }
    text->strings = out;
}

static bool take_escape(JsonText *text) {
    static const char NAMES[] = "\"\\/bfnrt", VALUES[] = "\"\\/\b\f\n\r\t";
    if (text->at == text->end) return json_fails(text, MALFORMED, "a string cut short");
    int c = *text->at++;
    const char *name = c ? strchr(NAMES, c) : NULL;
    if (name) {
        *text->strings++ = (uint8_t)VALUES[name - NAMES];
        return true;
    }
    int32_t unit = c == 'u' ? take_hex(text) : -1;
    if (unit < 0) return json_fails(text, MALFORMED, "an unknown escape");
    if (unit >= 0xd800 && unit < 0xdc00) {
        int32_t low = take_word(text, "\\u") ? take_hex(text) : -1;
        if (low >= 0xdc00 && low < 0xe000) {
            put_utf8(text, 0x10000 + ((uint32_t)(unit - 0xd800) << 10 | (uint32_t)(low - 0xdc00)));
            return true;
        }
    }
    if (unit >= 0xd800 && unit < 0xe000) return json_fails(text, MALFORMED, "half of a surrogate pair");
    put_utf8(text, (uint32_t)unit);
    return true;
}

/* The string behind an opening quote.  An escape is never shorter than what it stands for, and the
 * quotes make room for the zero byte: all strings fit into as many bytes as the text has. */
static bool take_string(JsonText *text, Span *string) {
    string->at = text->strings;
    while (text->at < text->end) {
        uint8_t c = *text->at++;
        if (c == '"') {
            string->size = (size_t)(text->strings - string->at);
            *text->strings++ = 0;
            return true;
        }
        if (c < 0x20) return json_fails(text, MALFORMED, "a control character in a string");
        if (c != '\\')
            *text->strings++ = c;
        else if (!take_escape(text))
            return false;
    }
    return json_fails(text, MALFORMED, "a string cut short");
}

static bool is_digit(const JsonText *text) {
    return text->at < text->end && *text->at >= '0' && *text->at <= '9';
}

/* A number in JSON's form, whatever the locale.  Nineteen digits count. */
static bool take_number(JsonText *text, Json *value) {
    bool negative = take(text, '-');
    uint64_t digits = 0;
    long exponent = 0;
    value->type = JSON_NUMBER;
    if (!is_digit(text)) return json_fails(text, MALFORMED, "no JSON value");
    bool leading_zero = *text->at == '0';
    for (int part = 0; part < 2; part++) { /* before and behind the point */
        const uint8_t *start = text->at;
        for (; is_digit(text) && !(part == 0 && leading_zero && text->at > start); text->at++) {
            bool fits = digits < UINT64_MAX / 10 - 1;
            if (fits) digits = digits * 10 + (uint64_t)(*text->at - '0');
            exponent += part == 0 ? !fits : -(long)fits;
        }
        if (part == 1 && text->at == start) return json_fails(text, MALFORMED, "a bare point");
        if (part == 1 || !take(text, '.')) break;
    }
    if (text->at < text->end && (*text->at | 0x20) == 'e') {
        text->at++;
        bool down = take(text, '-');
        if (!down) take(text, '+');
        if (!is_digit(text)) return json_fails(text, MALFORMED, "an exponent without digits");
        long power = 0;
        for (; is_digit(text); text->at++)
            if (power < 10 * MAX_MANIFEST) power = power * 10 + (*text->at - '0');
        exponent += down ? -power : power;
    }
    long double scaled = (long double)digits;
    if (digits && exponent < -400) scaled = 0;
    if (digits && exponent >= -400 && exponent < 0) {
        long part = exponent / 2; /* 10^400 is too much for some machines */
        scaled = scaled / powl(10, (long double)-part) / powl(10, (long double)(part - exponent));
    }
    if (digits && exponent > 0) scaled *= exponent > 310 ? (long double)HUGE_VAL : powl(10, exponent);
    value->number = scaled > DBL_MAX ? HUGE_VAL : (double)scaled;
    if (value->number > DBL_MAX) return json_fails(text, "JSON_NOT_FINITE", "a number too large");
    if (negative) value->number = -value->number;
    return true;
}

static int compare_keys(const void *a, const void *b) {
    Span x = (*(Json *const *)a)->key, y = (*(Json *const *)b)->key;
    int order = memcmp(x.at, y.at, x.size < y.size ? x.size : y.size);
    return order ? order : (x.size > y.size) - (x.size < y.size);
}

static bool keys_are_unique(JsonText *text, const Json *object) {
    if (object->count < 2) return true;
    const Json **members = malloc(object->count * sizeof *members);
    if (!members) return json_fails(text, MALFORMED, "more than the memory holds");
    size_t n = 0;
    for (const Json *m = object->first; m; m = m->next) members[n++] = m;
    qsort(members, n, sizeof *members, compare_keys);
    bool unique = true;
    for (size_t i = 1; i < n; i++) unique &= !same_span(members[i - 1]->key, members[i]->key);
    free(members);
    return unique || json_fails(text, "JSON_DUPLICATE_KEY", "a key twice in an object");
}

static Json *take_value(JsonText *text);

/* The items or members behind an opening bracket. */
static bool take_items(JsonText *text, Json *parent) {
    const char close = parent->type == JSON_OBJECT ? '}' : ']';
    Json **link = &parent->first;
    skip_space(text);
    if (take(text, close)) return true;
    for (;;) {
        Span key = {0};
        skip_space(text);
        if (parent->type == JSON_OBJECT) {
            if (!take(text, '"')) return json_fails(text, MALFORMED, "a member without a key");
            if (!take_string(text, &key)) return false;
            skip_space(text);
            if (!take(text, ':')) return json_fails(text, MALFORMED, "a key without a colon");
            skip_space(text);
        }
        Json *item = take_value(text);
        if (!item) return false;
        item->key = key;
        *link = item;
        link = &item->next;
        parent->count++;
        skip_space(text);
        if (take(text, close)) return parent->type == JSON_ARRAY || keys_are_unique(text, parent);
        if (!take(text, ',')) return json_fails(text, MALFORMED, "items without a comma");
    }
}

static Json *take_value(JsonText *text) {
    Json *value = text->values++;
    memset(value, 0, sizeof *value);
    bool good = true;
    if (take_word(text, "null")) {
        value->type = JSON_NULL;
    } else if (take_word(text, "true")) {
        value->type = JSON_TRUE;
    } else if (take_word(text, "false")) {
        value->type = JSON_FALSE;
    } else if (take_word(text, "NaN") || take_word(text, "Infinity") || take_word(text, "-Infinity")) {
        good = json_fails(text, "JSON_NOT_FINITE", "NaN or Infinity");
    } else if (take(text, '"')) {
        value->type = JSON_STRING;
        good = take_string(text, &value->string);
    } else if (take(text, '{') || take(text, '[')) {
        value->type = text->at[-1] == '{' ? JSON_OBJECT : JSON_ARRAY;
        if (++text->depth > MAX_DEPTH) good = json_fails(text, MALFORMED, "more than 64 levels");
        good = good && take_items(text, value);
        text->depth--;
    } else {
        good = take_number(text, value);
    }
    return good ? value : NULL;
}

static void free_json(JsonText *text) {
    free(text->string_block);
    free(text->value_block);
    memset(text, 0, sizeof *text);
}

/* The JSON object in `data`, and in `text` what it lives on, which the caller frees in any case;
 * NULL after an issue.  `malformed`: code for what is no JSON object. */
static const Json *parse_json(Span data, const char *where, const char *malformed, JsonText *text,
                              RnaReport *report) {
    /* Each value but the first has one of these before it. */
    size_t values = 1;
    for (size_t i = 0; i < data.size; i++) values += memchr("[,:", data.at[i], 3) != NULL;
    *text = (JsonText){.at = data.at, .end = data.at + data.size};
    text->strings = text->string_block = malloc(data.size + 1);
    text->values = text->value_block = malloc((values + 1) * sizeof(Json));
    const Json *root = NULL;
    if (!text->strings || !text->values) {
        json_fails(text, MALFORMED, "more than the memory holds");
    } else if (!is_utf8(data)) {
        json_fails(text, MALFORMED, "bytes that are no UTF-8");
    } else {
        skip_space(text);
        root = take_value(text);
        skip_space(text);
        if (root && text->at < text->end) json_fails(text, MALFORMED, "bytes behind the value");
        if (root && root->type != JSON_OBJECT) json_fails(text, MALFORMED, "another type");
    }
    if (!text->code) return root;
    const char *code = text->code == MALFORMED ? malformed : text->code;
    refuse(report, code, where, "a JSON object in UTF-8, finite numbers, each key once", "%s",
           text->found);
    return NULL;
}

static const Json *member(const Json *object, const char *name) {
    if (!object || object->type != JSON_OBJECT) return NULL;
    for (const Json *m = object->first; m; m = m->next)
        if (span_is(m->key, name)) return m;
    return NULL;
}

/* Whether it is a number of whole value that a binary64 tells from its neighbours. */
static bool is_integer(const Json *value) {
    double number = value->number;
    return value->type == JSON_NUMBER && fabs(number) < 0x1p53 && floor(number) == number;
}

static bool is_string(const Json *value, const char *text) {
    return value && value->type == JSON_STRING && span_is(value->string, text);
}

/* ------------------------------------------------------------------ 4 Rules */

/* What values a member may have. */
typedef enum RuleKind {
    END,
    ANYTHING,
    TEXT,    /* of `low` characters at least */
    NAME,    /* of a tier or an extension */
    PATH,    /* of an entry */
    VERSION, /* MAJOR.MINOR */
    SHA256,
    NUMBER,  /* from `low` to `high` */
    INTEGER, /* the same, of whole value */
    CHOICE,  /* one of the words in `choices` */
    FALSE,
    OBJECT, /* with the members in `of` */
    MAP,    /* an object with any members like `of`, whose keys are like `key` */
    LIST,   /* from `low` to `high` items like `of` */
    REGION  /* of directions: a word, or a list of cones */
} RuleKind;

enum { REQUIRED = 1, NULLABLE = 2 };

typedef struct Schema Schema;
typedef struct Rule Rule;

struct Rule {
    const char *name;
    RuleKind kind;
    unsigned flags;
    double low, high;
    const Rule *of;
    const char *choices;
    RuleKind key;
    void (*also)(Schema *schema, const Json *value); /* called where the rest is as it must be */
};

/* A check that is going on. */
struct Schema {
    RnaReport *report;
    const char *unknown, *missing, *value; /* codes */
    bool only_first;                       /* stop at the first issue */
    int issues;
    char where[128]; /* JSON pointer, behind what the caller put there */
    size_t length;
};

static size_t push_place(Schema *schema, Span name) {
    size_t before = schema->length, room = sizeof schema->where - 3;
    if (schema->length < room) schema->where[schema->length++] = '/';
    for (size_t i = 0; i < name.size && schema->length < room; i++) {
        char c = (char)name.at[i];
        if (c == '~' || c == '/') schema->where[schema->length++] = '~';
        schema->where[schema->length++] = (char)(c == '~' ? '0' : c == '/' ? '1' : c);
    }
    schema->where[schema->length] = 0;
    return before;
}

static size_t push_text(Schema *schema, const char *name) {
    return push_place(schema, (Span){(const uint8_t *)name, strlen(name)});
}

static size_t push_index(Schema *schema, size_t index) {
    char text[24];
    snprintf(text, sizeof text, "%zu", index);
    return push_text(schema, text);
}

static void pop_place(Schema *schema, size_t length) { schema->where[schema->length = length] = 0; }

PRINTF(4, 5)
static void break_rule(Schema *schema, const char *code, const char *expected, const char *found,
                       ...) {
    if (schema->only_first && schema->issues) return;
    schema->issues++;
    va_list arguments;
    va_start(arguments, found);
    add_issue(schema->report, true, code, schema->where, expected, found, arguments);
    va_end(arguments);
}

/* [A-Za-z0-9] and what else `more` has. */
static bool is_word(uint8_t c, const char *more) {
    bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    return plain || (c && strchr(more, c));
}

static bool is_name(Span text) {
    if (text.size == 0 || text.size > 64 || !is_word(text.at[0], "")) return false;
    for (size_t i = 1; i < text.size; i++)
        if (!is_word(text.at[i], "._-")) return false;
    return true;
}

/* Parts with `/` between them, none empty, none that starts with a dot (section 2). */
static bool is_path(Span text) {
    bool starts_part = true;
    if (text.size > MAX_NAME) return false;
    for (size_t i = 0; i < text.size; i++) {
        bool slash = text.at[i] == '/';
        if (slash ? starts_part : !is_word(text.at[i], starts_part ? "_-" : "._-")) return false;
        starts_part = slash;
    }
    return !starts_part;
}

/* The number at *at, of `most` digits; -1 where there is none. */
static long take_digits(Span text, size_t *at, size_t most) {
    long value = 0;
    size_t start = *at;
    for (; *at < text.size && text.at[*at] >= '0' && text.at[*at] <= '9'; ++*at) {
        if (*at - start == most) return -1;
        value = value * 10 + (text.at[*at] - '0');
    }
    return *at > start ? value : -1;
}

/* MAJOR.MINOR of at most four digits each. */
static bool take_version(Span text, long *major, long *minor) {
    size_t at = 0;
    *major = take_digits(text, &at, 4);
    if (*major < 0 || at == text.size || text.at[at++] != '.') return false;
    *minor = take_digits(text, &at, 4);
    return *minor >= 0 && at == text.size;
}

/* [1-9][0-9]{0,3} and a point and 0 or the like. */
static bool is_version(Span text) {
    long major, minor;
    if (!take_version(text, &major, &minor) || text.at[0] == '0') return false;
    const uint8_t *point = memchr(text.at, '.', text.size);
    return point[1] != '0' || point + 2 == text.at + text.size;
}

static bool is_sha256(Span text) {
    for (size_t i = 0; i < text.size; i++)
        if (!memchr("0123456789abcdef", text.at[i], 16)) return false;
    return text.size == 64;
}

static size_t characters(Span text) {
    size_t count = 0;
    for (size_t i = 0; i < text.size; i++) count += (text.at[i] & 0xc0) != 0x80;
    return count;
}

static bool is_choice(Span text, const char *choices) {
    for (const char *word = choices; *word; word += strspn(word, " ")) {
        size_t size = strcspn(word, " ");
        if (size == text.size && memcmp(word, text.at, size) == 0) return true;
        word += size;
    }
    return false;
}

static bool is_text_like(RuleKind kind, const Rule *rule, Span text) {
    switch (kind) {
    case TEXT: return (double)characters(text) >= rule->low;
    case NAME: return is_name(text);
    case PATH: return is_path(text);
    case VERSION: return is_version(text);
    case SHA256: return is_sha256(text);
    default: return is_choice(text, rule->choices);
    }
}

static const char *kind_text(const Rule *rule) {
    static const char *const TEXTS[] = {
        [ANYTHING] = "anything",
        [TEXT] = "a string that is long enough",
        [NAME] = "a name: letters, digits and ._-, at most 64",
        [PATH] = "a relative path, at most 200 bytes",
        [VERSION] = "a version like 1.0",
        [SHA256] = "64 lower-case hexadecimal digits",
        [NUMBER] = "a number in its range",
        [INTEGER] = "an integer in its range",
        [FALSE] = "false",
        [OBJECT] = "an object",
        [MAP] = "an object",
        [LIST] = "an array with the right number of items",
        [REGION] = "sphere, hemisphere, or 1 to 16 cones"};
    return rule->kind == CHOICE ? rule->choices : TEXTS[rule->kind];
}

static void check_rule(Schema *schema, const Rule *rule, const Json *value);

static void check_members(Schema *schema, const Rule *rules, const Json *object) {
    for (const Json *m = object->first; m; m = m->next) {
        const Rule *rule = rules;
        while (rule->kind && !span_is(m->key, rule->name)) rule++;
        size_t before = push_place(schema, m->key);
        if (rule->kind)
            check_rule(schema, rule, m);
        else
            break_rule(schema, schema->unknown, "no such member", "%.*s", (int)m->key.size,
                       (const char *)m->key.at);
        pop_place(schema, before);
    }
    for (const Rule *rule = rules; rule->kind; rule++) {
        if (!(rule->flags & REQUIRED) || member(object, rule->name)) continue;
        size_t before = push_text(schema, rule->name);
        break_rule(schema, schema->missing, kind_text(rule), "nothing");
        pop_place(schema, before);
    }
}

static void check_map(Schema *schema, const Rule *rule, const Json *object) {
    for (const Json *m = object->first; m; m = m->next) {
        size_t before = push_place(schema, m->key);
        if (rule->key != ANYTHING && !is_text_like(rule->key, rule, m->key))
            break_rule(schema, schema->value, "a well-formed key", "%.*s", (int)m->key.size,
                       (const char *)m->key.at);
        if (rule->of) check_rule(schema, rule->of, m);
        pop_place(schema, before);
    }
}

static void check_items(Schema *schema, const Rule *rule, const Json *list) {
    size_t index = 0;
    for (const Json *item = list->first; item; item = item->next) {
        size_t before = push_index(schema, index++);
        check_rule(schema, rule->of, item);
        pop_place(schema, before);
    }
}

static const Rule CONES;

/* Whether the value is of the rule's kind, without a look at what is in it. */
static bool is_of_kind(const Rule *rule, const Json *value) {
    bool in_range = value->number >= rule->low && value->number <= rule->high;
    double count = (double)value->count;
    switch (rule->kind) {
    case ANYTHING: return true;
    case NUMBER: return value->type == JSON_NUMBER && in_range;
    case INTEGER: return is_integer(value) && in_range;
    case FALSE: return value->type == JSON_FALSE;
    case OBJECT:
    case MAP: return value->type == JSON_OBJECT;
    case LIST: return value->type == JSON_ARRAY && count >= rule->low && count <= rule->high;
    case REGION:
        if (value->type == JSON_ARRAY) return is_of_kind(&CONES, value);
        return value->type == JSON_STRING && is_choice(value->string, "sphere hemisphere");
    default: return value->type == JSON_STRING && is_text_like(rule->kind, rule, value->string);
    }
}

static void check_rule(Schema *schema, const Rule *rule, const Json *value) {
    if (value->type == JSON_NULL && rule->flags & NULLABLE) return;
    int before = schema->issues;
    if (!is_of_kind(rule, value)) {
        static const char *const TYPES[] = {"null",     "false",    "true",     "a number",
                                            "a string", "an array", "an object"};
        if (value->type == JSON_STRING)
            break_rule(schema, schema->value, kind_text(rule), "\"%.*s\"", (int)value->string.size,
                       (const char *)value->string.at);
        else if (value->type == JSON_NUMBER)
            break_rule(schema, schema->value, kind_text(rule), "%g", value->number);
        else
            break_rule(schema, schema->value, kind_text(rule), "%s", TYPES[value->type]);
        return;
    }
    if (rule->kind == OBJECT) check_members(schema, rule->of, value);
    if (rule->kind == MAP) check_map(schema, rule, value);
    if (rule->kind == LIST) check_items(schema, rule, value);
    if (rule->kind == REGION && value->type == JSON_ARRAY) check_items(schema, &CONES, value);
    if (rule->also && schema->issues == before) rule->also(schema, value);
}

/* -------------------------------------------------------------- 5 Container */

typedef struct Entry {
    char name[MAX_NAME + 1];
    size_t header, data, size; /* offsets in the file; bytes */
    uint32_t crc;
    bool intact; /* as the manifest declares it */
} Entry;

typedef struct Container {
    Span file;
    Entry entries[MAX_ENTRIES];
    int count;
} Container;

enum { LOCAL_SIZE = 30, CENTRAL_SIZE = 46, END_SIZE = 22, PADDING_ID = 0x4E52 };

static Span entry_data(const Container *zip, const Entry *entry) {
    return (Span){zip->file.at + entry->data, entry->size};
}

static Entry *find_entry(Container *zip, Span name) {
    for (int i = 0; i < zip->count; i++)
        if (span_is(name, zip->entries[i].name)) return &zip->entries[i];
    return NULL;
}

static bool same_name(const char *a, const char *b) {
    for (; *a && *b; a++, b++) {
        int x = *a >= 'A' && *a <= 'Z' ? *a + 32 : *a, y = *b >= 'A' && *b <= 'Z' ? *b + 32 : *b;
        if (x != y) return false;
    }
    return *a == *b;
}

/* The central header at *offset, and *offset behind it; `end`: of the directory. */
static bool read_central(Container *zip, size_t *offset, size_t end, RnaReport *report) {
    const uint8_t *at = zip->file.at + *offset;
    Place where = byte_place(*offset);
    if (end - *offset < CENTRAL_SIZE)
        return refuse(report, "ZIP_DIRECTORY", where.text, "a central header", "one cut short");
    size_t name_size = u16_at(at + 28);
    if (u32_at(at) != 0x02014B50 || u16_at(at + 30) || u16_at(at + 32))
        return refuse(report, "ZIP_DIRECTORY", where.text, "a central header, nothing behind its name",
                      "signature %08x", (unsigned)u32_at(at));
    if (u32_at(at + 20) == UINT32_MAX || u32_at(at + 24) == UINT32_MAX || u32_at(at + 42) == UINT32_MAX)
        return refuse(report, "ZIP_ZIP64", where.text, "sizes and offsets below 4 GiB", "more");
    if (u16_at(at + 8) & 1)
        return refuse(report, "ZIP_ENCRYPTED", where.text, "flags 0", "flags %u", (unsigned)u16_at(at + 8));
    bool fixed = u16_at(at + 4) == 20 && u16_at(at + 6) == 20 && u16_at(at + 8) == 0 &&
                 u16_at(at + 12) == 0 && u16_at(at + 14) == 0x0021 && u16_at(at + 34) == 0 &&
                 u16_at(at + 36) == 0 && u32_at(at + 38) == 0;
    if (!fixed)
        return refuse(report, "ZIP_HEADER", where.text, "the fixed versions, flags, times, attributes",
                      "others");
    if (u16_at(at + 10))
        return refuse(report, "ZIP_COMPRESSED", where.text, "method 0 (stored)", "method %u",
                      (unsigned)u16_at(at + 10));
    if (u32_at(at + 20) != u32_at(at + 24))
        return refuse(report, "ZIP_SIZE", where.text, "equal sizes", "%u and %u",
                      (unsigned)u32_at(at + 20), (unsigned)u32_at(at + 24));
    if (end - *offset - CENTRAL_SIZE < name_size)
        return refuse(report, "ZIP_DIRECTORY", where.text, "a name inside the directory", "%zu bytes",
                      name_size);
    Span name = {at + CENTRAL_SIZE, name_size};
    if (!is_path(name))
        return refuse(report, "ZIP_NAME", where.text, "a relative path, at most 200 bytes", "%.*s",
                      (int)name_size, (const char *)name.at);
    Entry *entry = &zip->entries[zip->count];
    *entry = (Entry){.header = u32_at(at + 42), .size = u32_at(at + 24), .crc = u32_at(at + 16)};
    memcpy(entry->name, name.at, name.size);
    entry->data = *offset; /* of the central header, until the local one was read */
    for (int i = 0; i < zip->count; i++)
        if (same_name(entry->name, zip->entries[i].name))
            return refuse(report, "ZIP_DUPLICATE", where.text, "each name once", "%s", entry->name);
    zip->count++;
    *offset += CENTRAL_SIZE + name_size;
    return true;
}

/* Finds the entry's data, once the local header agrees with the central one. */
static bool read_local(const Container *zip, Entry *entry, size_t directory, RnaReport *report) {
    const uint8_t *central = zip->file.at + entry->data, *at = zip->file.at + entry->header;
    Place where = byte_place(entry->header);
    if (entry->header + LOCAL_SIZE > directory)
        return refuse(report, "ZIP_TRUNCATED", where.text, "a local header", "one cut short");
    size_t extra_size = u16_at(at + 28), extra_offset = entry->header + LOCAL_SIZE + u16_at(at + 26);
    const uint8_t *extra = zip->file.at + extra_offset;
    entry->data = extra_offset + extra_size;
    if (entry->data + entry->size > directory)
        return refuse(report, "ZIP_TRUNCATED", where.text, "data that ends before the directory",
                      "%zu bytes at %zu", entry->size, entry->data);
    bool same = u32_at(at) == 0x04034B50 && memcmp(at + 4, central + 6, 24) == 0 &&
                memcmp(at + LOCAL_SIZE, entry->name, u16_at(at + 26)) == 0;
    if (!same)
        return refuse(report, "ZIP_LOCAL_HEADER", where.text, "the central header's values", "others");
    bool zero = extra_size == 0 || (extra_size >= 4 && u16_at(extra) == PADDING_ID &&
                                    u16_at(extra + 2) == extra_size - 4);
    for (size_t i = 4; i < extra_size; i++) zero &= extra[i] == 0;
    if (!zero)
        return refuse(report, "ZIP_EXTRA", byte_place(extra_offset).text, "the padding field, zeros",
                      "%zu other bytes", extra_size);
    if (entry->data % ALIGNMENT)
        return refuse(report, "ZIP_ALIGNMENT", byte_place(entry->data).text, "a multiple of 64", "%s",
                      entry->name);
    if (strcmp(entry->name, "manifest.json") == 0 && entry->size > MAX_MANIFEST)
        return refuse(report, "MANIFEST_TOO_LARGE", where.text, "at most 1 MiB", "%zu bytes",
                      entry->size);
    return true;
}

static int compare_headers(const void *a, const void *b) {
    size_t x = ((const Entry *)a)->header, y = ((const Entry *)b)->header;
    return (x > y) - (x < y);
}

/* Entries follow each other with no overlap and no gap, the manifest first. */
static bool check_layout(Container *zip, size_t directory, RnaReport *report) {
    qsort(zip->entries, (size_t)zip->count, sizeof *zip->entries, compare_headers);
    size_t behind = 0;
    for (int i = 0; i <= zip->count; i++) {
        const Entry *entry = &zip->entries[i];
        size_t start = i < zip->count ? entry->header : directory;
        const char *name = i < zip->count ? entry->name : "the directory";
        if (start < behind)
            return refuse(report, "ZIP_OVERLAP", byte_place(start).text, "no shared bytes", "%s", name);
        if (start > behind)
            return refuse(report, "ZIP_GAP", byte_place(behind).text, "no bytes left over",
                          "%zu before %s", start - behind, name);
        if (i < zip->count) behind = entry->data + entry->size;
    }
    if (zip->count == 0 || strcmp(zip->entries[0].name, "manifest.json"))
        return refuse(report, "ZIP_ORDER", "byte 0", "manifest.json", "%s",
                      zip->count ? zip->entries[0].name : "no entry");
    return true;
}

static bool read_container(Container *zip, RnaReport *report) {
    Span file = zip->file;
    if (file.size == 0) return refuse(report, "FILE_EMPTY", "byte 0", "a ZIP archive", "0 bytes");
    if (file.size > UINT32_MAX - 1)
        return refuse(report, "FILE_TOO_LARGE", "byte 0", "at most 2^32 - 2 bytes", "%zu", file.size);
    size_t end_offset = file.size < END_SIZE ? 0 : file.size - END_SIZE;
    const uint8_t *end = file.at + end_offset;
    Place where = byte_place(end_offset);
    if (file.size < END_SIZE || u32_at(end) != 0x06054B50) {
        bool starts_well = file.size >= 4 && u32_at(file.at) == 0x04034B50;
        return refuse(report, starts_well ? "ZIP_TRUNCATED" : "ZIP_NOT_ZIP", where.text,
                      "an end record as the last 22 bytes", "none");
    }
    uint32_t count = u16_at(end + 10), size = u32_at(end + 12), offset = u32_at(end + 16);
    if (count == 0xFFFF || u16_at(end + 4) || u16_at(end + 6))
        return refuse(report, "ZIP_ZIP64", where.text, "one disk, no ZIP64", "more");
    if (count > MAX_ENTRIES)
        return refuse(report, "ZIP_TOO_MANY", where.text, "at most 256", "%u", (unsigned)count);
    if ((uint64_t)offset + size != end_offset || u16_at(end + 20) || u16_at(end + 8) != count)
        return refuse(report, "ZIP_DIRECTORY", where.text, "a directory that ends here",
                      "%u bytes at %u", (unsigned)size, (unsigned)offset);
    size_t at = offset;
    for (uint32_t i = 0; i < count; i++)
        if (!read_central(zip, &at, end_offset, report)) return false;
    if (at != end_offset)
        return refuse(report, "ZIP_DIRECTORY", byte_place(at).text, "the end record", "%zu bytes more",
                      end_offset - at);
    for (int i = 0; i < zip->count; i++)
        if (!read_local(zip, &zip->entries[i], offset, report)) return false;
    return check_layout(zip, offset, report);
}

static bool check_crc(const Container *zip, const Entry *entry, RnaReport *report) {
    uint32_t crc = crc32(entry_data(zip, entry));
    return crc == entry->crc || refuse(report, "ZIP_CRC", byte_place(entry->data).text,
                                       "the CRC-32 of the header", "%s: %08x", entry->name, crc);
}

/* --------------------------------------------------------------- 6 Manifest */

/* Columns of `queries`, in groups (section 6.3). */
enum Block {
    FEATURES,
    POSITION,
    NORMAL,
    TANGENT,
    H,
    WO,
    WI,
    HALF_VECTOR,
    HIGHLIGHT,
    LEARNED_NORMAL,
    FIBER_ANGLES,
    FIBER_LOBES,
    BLOCKS
};

enum { FOR_SURFACE = 1 << RNA_SURFACE, FOR_FIBER = 1 << RNA_FIBER, FOR_BOTH = 3 };

static const struct {
    const char *name;
    int width; /* 0: as many as the tier has channels */
    unsigned kinds;
} BLOCK_TABLE[BLOCKS] = {
    [FEATURES] = {"features", 0, FOR_BOTH},
    [POSITION] = {"position", 3, FOR_BOTH},
    [NORMAL] = {"normal", 3, FOR_SURFACE},
    [TANGENT] = {"tangent", 3, FOR_FIBER},
    [H] = {"h", 1, FOR_FIBER},
    [WO] = {"wo", 3, FOR_BOTH},
    [WI] = {"wi", 3, FOR_BOTH},
    [HALF_VECTOR] = {"half_vector", 5, FOR_SURFACE},
    [HIGHLIGHT] = {"highlight", 1, FOR_SURFACE},
    [LEARNED_NORMAL] = {"learned_normal", 2, FOR_SURFACE},
    [FIBER_ANGLES] = {"fiber_angles", 6, FOR_FIBER},
    [FIBER_LOBES] = {"fiber_lobes", 3, FOR_FIBER},
};

static int block_of(Span name) {
    for (int block = 0; block < BLOCKS; block++)
        if (span_is(name, BLOCK_TABLE[block].name)) return block;
    return -1;
}

static void bounds_have_an_extent(Schema *schema, const Json *bounds) {
    const Json *low = member(bounds, "min")->first, *high = member(bounds, "max")->first;
    for (; low; low = low->next, high = high->next)
        if ((double)(float)high->number - (double)(float)low->number < 1e-18) {
            size_t before = push_text(schema, "max");
            break_rule(schema, "BOUNDS_EMPTY", "max - min >= 1e-18 in float32", "%g to %g", low->number,
                       high->number);
            pop_place(schema, before);
            return;
        }
}

static void axis_is_unit(Schema *schema, const Json *axis) {
    double square = 0;
    for (const Json *c = axis->first; c; c = c->next) square += c->number * c->number;
    if (!(fabs(sqrt(square) - 1) <= 1e-3))
        break_rule(schema, schema->value, "a unit vector", "length %g", sqrt(square));
}

static void heights_descend(Schema *schema, const Json *list) {
    double before = HUGE_VAL;
    for (const Json *item = list->first; item; item = item->next) {
        double height = member(item, "height")->number;
        if (!(height < before))
            break_rule(schema, schema->value, "each height below the one before", "%g", height);
        before = height;
    }
}

static void blocks_are_known(Schema *schema, const Json *inputs) {
    for (const Json *a = inputs->first; a; a = a->next) {
        bool again = false;
        for (const Json *b = inputs->first; b != a; b = b->next) again |= same_span(a->string, b->string);
        if (again || block_of(a->string) < 0) {
            break_rule(schema, "INPUT_UNKNOWN", "known blocks, each once", "%s",
                       (const char *)a->string.at);
            return;
        }
    }
}

static void tiers_are_unique(Schema *schema, const Json *tiers) {
    for (const Json *a = tiers->first; a; a = a->next)
        for (const Json *b = tiers->first; b != a; b = b->next)
            if (same_span(member(a, "name")->string, member(b, "name")->string)) {
                break_rule(schema, "TIER_DUPLICATE", "each tier name once", "%s",
                           (const char *)member(a, "name")->string.at);
                return;
            }
}

#define MEASURE 0, HUGE_VAL
#define ANY_NUMBER -HUGE_VAL, HUGE_VAL
#define ANY_COUNT 0, HUGE_VAL

static const Rule COORDINATE = {"", NUMBER, 0, ANY_NUMBER};
static const Rule CORNER = {"", NUMBER, 0, -1e18, 1e18};
static const Rule BOUNDS[] = {{"min", LIST, REQUIRED, 3, 3, &CORNER},
                              {"max", LIST, REQUIRED, 3, 3, &CORNER},
                              {0}};
static const Rule CONE[] = {{"axis", LIST, REQUIRED, 3, 3, &COORDINATE, .also = axis_is_unit},
                            {"halfAngle", NUMBER, REQUIRED, 0, 3.141592653589793},
                            {0}};
static const Rule A_CONE = {"", OBJECT, .of = CONE};
static const Rule CONES = {"", LIST, 0, 1, 16, &A_CONE};
static const Rule DOMAIN[] = {{"wo", REGION, REQUIRED}, {"wi", REGION, REQUIRED}, {0}};
static const Rule UNITS[] = {{"length", CHOICE, REQUIRED, .choices = "metre"}, {0}};
static const Rule FLIP_AT[] = {{"height", INTEGER, REQUIRED, 1, HUGE_VAL},
                               {"flip", NUMBER, REQUIRED, MEASURE},
                               {0}};
static const Rule A_FLIP_AT = {"", OBJECT, .of = FLIP_AT};
static const Rule VALIDATION[] = {
    {"psnr", NUMBER, REQUIRED, ANY_NUMBER},
    {"flip", NUMBER, REQUIRED, MEASURE},
    {"relativeMse", NUMBER, REQUIRED, MEASURE},
    {"images", INTEGER, REQUIRED, 1, HUGE_VAL},
    {"definition", TEXT, REQUIRED},
    {"flipAtHeight", LIST, 0, ANY_COUNT, &A_FLIP_AT, .also = heights_descend},
    {0}};
static const Rule COST[] = {{"multiplyAdds", INTEGER, REQUIRED, MEASURE},
                            {"nsPerQuery", NUMBER, REQUIRED, MEASURE},
                            {"threads", INTEGER, REQUIRED, 1, HUGE_VAL},
                            {"machine", TEXT, REQUIRED},
                            {0}};
static const Rule AGREEMENT[] = {{"maxAbsolute", NUMBER, REQUIRED, MEASURE},
                                 {"maxRelative", NUMBER, REQUIRED, MEASURE},
                                 {0}};
static const Rule A_BLOCK = {"", TEXT};
static const Rule TIER[] = {
    {"name", NAME, REQUIRED},
    {"planes", PATH, REQUIRED},
    {"decoder", PATH, REQUIRED},
    {"inputs", LIST, REQUIRED, 1, HUGE_VAL, &A_BLOCK, .also = blocks_are_known},
    {"resolution", INTEGER, REQUIRED, 1, 4096},
    {"channels", INTEGER, REQUIRED, 1, MAX_CHANNELS},
    {"planePrecision", CHOICE, REQUIRED, .choices = "int8 float16 float32"},
    {"decoderPrecision", CHOICE, REQUIRED, .choices = "float32 int8"},
    {"validation", OBJECT, NULLABLE, .of = VALIDATION},
    {"cost", OBJECT, NULLABLE, .of = COST},
    {"agreement", OBJECT, NULLABLE, .of = AGREEMENT},
    {0}};
static const Rule A_TIER = {"", OBJECT, .of = TIER};
static const Rule RECORD[] = {{"size", INTEGER, REQUIRED, MEASURE}, {"sha256", SHA256, REQUIRED}, {0}};
static const Rule A_RECORD = {"", OBJECT, .of = RECORD};
static const Rule PROVENANCE[] = {{"source", TEXT, REQUIRED},
                                  {"tool", TEXT, REQUIRED},
                                  {"capture", MAP, .key = ANYTHING},
                                  {"training", MAP, .key = ANYTHING},
                                  {0}};
static const Rule AN_EXTENSION = {"", NAME};
static const Rule MANIFEST[] = {
    {"format", CHOICE, REQUIRED, .choices = "rna"},
    {"version", VERSION, REQUIRED},
    {"minReaderVersion", VERSION, REQUIRED},
    {"generator", TEXT, REQUIRED},
    {"name", TEXT, REQUIRED, 1},
    {"kind", CHOICE, REQUIRED, .choices = "surface fiber"},
    {"bounds", OBJECT, REQUIRED, .of = BOUNDS, .also = bounds_have_an_extent},
    {"domain", OBJECT, REQUIRED, .of = DOMAIN},
    {"units", OBJECT, REQUIRED, .of = UNITS},
    {"geometry", PATH, REQUIRED},
    {"tiers", LIST, REQUIRED, 1, MAX_TIERS, &A_TIER, .also = tiers_are_unique},
    {"entries", MAP, REQUIRED, .key = PATH, .of = &A_RECORD},
    {"provenance", OBJECT, REQUIRED, .of = PROVENANCE},
    {"license", TEXT, REQUIRED, 1},
    {"extensionsUsed", LIST, 0, ANY_COUNT, &AN_EXTENSION},
    {"extensionsRequired", LIST, 0, ANY_COUNT, &AN_EXTENSION},
    {"extensions", MAP, .key = NAME},
    {"extras", MAP, .key = ANYTHING},
    {0}};

/* What must hold before the members of this version mean anything. */
static bool manifest_is_readable(const Json *root, RnaReport *report) {
    if (!is_string(member(root, "format"), "rna"))
        return refuse(report, "FORMAT_UNKNOWN", "/format", "\"rna\"", "something else");
    const Json *version = member(root, "minReaderVersion"), *kind = member(root, "kind");
    if (version && version->type == JSON_STRING && is_version(version->string)) {
        long major, minor;
        take_version(version->string, &major, &minor);
        if (major > 1 || minor > 0)
            return refuse(report, "VERSION_TOO_NEW", "/minReaderVersion", "at most 1.0", "%ld.%ld", major,
                          minor);
    }
    if (kind && !is_string(kind, "surface") && !is_string(kind, "fiber"))
        return refuse(report, "KIND_UNSUPPORTED", "/kind", "surface or fiber", "something else");
    const Json *required = member(root, "extensionsRequired");
    if (required && required->type == JSON_ARRAY)
        for (const Json *name = required->first; name; name = name->next)
            if (name->type == JSON_STRING)
                return refuse(report, "EXTENSION_REQUIRED", "/extensionsRequired", "a known extension", "%s",
                              (const char *)name->string.at);
    return true;
}

static bool has_string(const Json *list, Span text) {
    for (const Json *item = list ? list->first : NULL; item; item = item->next)
        if (same_span(item->string, text)) return true;
    return false;
}

/* Whether the entry belongs to an extension that is used: extensions/NAME/... */
static bool is_of_extension(const Json *root, Span path) {
    const size_t prefix = strlen("extensions/");
    if (path.size <= prefix || memcmp(path.at, "extensions/", prefix)) return false;
    const uint8_t *slash = memchr(path.at + prefix, '/', path.size - prefix);
    Span name = {path.at + prefix, slash ? (size_t)(slash - path.at) - prefix : 0};
    return slash && has_string(member(root, "extensionsUsed"), name);
}

/* The member `path` of `object`, at `where`, names a declared entry. */
static void check_reference(const Json *root, const Json *object, const char *path,
                            const char *where, RnaReport *report) {
    Span name = member(object, path)->string;
    for (const Json *entry = member(root, "entries")->first; entry; entry = entry->next)
        if (same_span(entry->key, name)) return;
    refuse(report, "REFERENCE_MISSING", where, "a key of /entries", "%s", (const char *)name.at);
}

static bool is_referenced(const Json *root, Span path) {
    if (same_span(member(root, "geometry")->string, path) || is_of_extension(root, path)) return true;
    for (const Json *tier = member(root, "tiers")->first; tier; tier = tier->next)
        if (same_span(member(tier, "planes")->string, path) ||
            same_span(member(tier, "decoder")->string, path))
            return true;
    return false;
}

/* Paths name declared entries, and declared entries are named by a path. */
static void check_references(const Json *root, RnaReport *report) {
    char where[64];
    int i = 0;
    check_reference(root, root, "geometry", "/geometry", report);
    for (const Json *tier = member(root, "tiers")->first; tier; tier = tier->next, i++) {
        snprintf(where, sizeof where, "/tiers/%d/planes", i);
        check_reference(root, tier, "planes", where, report);
        snprintf(where, sizeof where, "/tiers/%d/decoder", i);
        check_reference(root, tier, "decoder", where, report);
    }
    for (const Json *entry = member(root, "entries")->first; entry; entry = entry->next)
        if (!is_referenced(root, entry->key))
            refuse(report, "ENTRY_UNREFERENCED", "/entries", "a path that is used", "%s",
                   (const char *)entry->key.at);
}

static void check_blocks(const Json *root, RnaReport *report) {
    bool is_fiber = is_string(member(root, "kind"), "fiber");
    unsigned kind = is_fiber ? FOR_FIBER : FOR_SURFACE;
    for (const Json *tier = member(root, "tiers")->first; tier; tier = tier->next)
        for (const Json *name = member(tier, "inputs")->first; name; name = name->next)
            if (!(BLOCK_TABLE[block_of(name->string)].kinds & kind))
                refuse(report, "INPUT_KIND", "/tiers", "blocks for this kind of asset", "%s",
                       (const char *)name->string.at);
}

static void check_extensions(const Json *root, RnaReport *report) {
    const Json *used = member(root, "extensionsUsed"), *data = member(root, "extensions");
    for (const Json *m = data ? data->first : NULL; m; m = m->next)
        if (!has_string(used, m->key))
            refuse(report, "EXTENSION_UNDECLARED", "/extensions", "a name in extensionsUsed", "%s",
                   (const char *)m->key.at);
}

/* The manifest; NULL after an error. */
static const Json *read_manifest(Span data, JsonText *text, RnaReport *report) {
    const Json *root = parse_json(data, "manifest.json", "MANIFEST_NOT_JSON", text, report);
    if (!root || !manifest_is_readable(root, report)) return NULL;
    Schema schema = {report, "FIELD_UNKNOWN", "FIELD_MISSING", "FIELD_VALUE", .only_first = false};
    check_members(&schema, MANIFEST, root);
    if (schema.issues) return NULL;
    int errors = report->errors;
    check_extensions(root, report);
    check_blocks(root, report);
    check_references(root, report);
    if (report->errors > errors) return NULL;
    const Json *used = member(root, "extensionsUsed");
    for (const Json *name = used ? used->first : NULL; name; name = name->next)
        warn(report, "EXTENSION_UNKNOWN", "/extensionsUsed", "a known extension", "%s",
             (const char *)name->string.at);
    return root;
}

/* Compares the archive with the manifest; notes which entries are as declared. */
static void check_entries(Container *zip, const Json *root, RnaReport *report) {
    const Json *records = member(root, "entries");
    for (int i = 1; i < zip->count; i++)
        if (!member(records, zip->entries[i].name))
            refuse(report, "ENTRY_UNDECLARED", byte_place(zip->entries[i].header).text,
                   "a declared entry", "%s", zip->entries[i].name);
    for (const Json *record = records->first; record; record = record->next) {
        char where[128], digest[65];
        snprintf(where, sizeof where, "/entries/%.100s", (const char *)record->key.at);
        Entry *entry = find_entry(zip, record->key);
        if (!entry) {
            refuse(report, "ENTRY_MISSING", where, "an entry of the archive", "nothing");
            continue;
        }
        double size = member(record, "size")->number;
        if ((double)entry->size != size) {
            refuse(report, "ENTRY_SIZE", where, "the declared size", "%zu bytes, not %.0f", entry->size,
                   size);
            continue;
        }
        sha256(entry_data(zip, entry), digest);
        if (!is_string(member(record, "sha256"), digest)) {
            refuse(report, "ENTRY_HASH", where, "the declared SHA-256", "%s", digest);
            continue;
        }
        entry->intact = check_crc(zip, entry, report);
    }
}

/* ----------------------------------------------------------- 7 Tensor files */

enum { MAX_RANK = 4 };

/* What a tensor must be, and where it was found. */
typedef struct Tensor {
    const char *name, *dtype;
    unsigned item; /* bytes of a value */
    int rank;
    uint64_t low[MAX_RANK], high[MAX_RANK]; /* range of each dimension */
    uint64_t shape[MAX_RANK];
    const uint8_t *data;
} Tensor;

/* Codes of one sort of tensor file. */
typedef struct TensorCodes {
    const char *header, *tensors, *dtype, *shape, *offsets, *alignment;
} TensorCodes;

/* The shape, once the header's record of the tensor is as it must be. */
static bool check_form(const Json *record, Tensor *tensor, const char *entry,
                       const TensorCodes *codes, RnaReport *report) {
    if (record->type != JSON_OBJECT)
        return refuse(report, codes->tensors, entry, "an object", "%s, another type", tensor->name);
    if (!is_string(member(record, "dtype"), tensor->dtype))
        return refuse(report, codes->dtype, entry, tensor->dtype, "%s of another dtype", tensor->name);
    const Json *shape = member(record, "shape");
    bool fits = shape && shape->type == JSON_ARRAY && shape->count == (size_t)tensor->rank;
    const Json *size = fits ? shape->first : NULL;
    for (int i = 0; size; size = size->next, i++) {
        fits &= is_integer(size) && size->number >= (double)tensor->low[i] &&
                size->number <= (double)tensor->high[i];
        if (fits) tensor->shape[i] = (uint64_t)size->number;
    }
    return fits || refuse(report, codes->shape, entry, "the shape that the manifest asks for",
                          "%s of another shape", tensor->name);
}

/* Whether the record's data_offsets are [start, end]. */
static bool has_offsets(const Json *record, uint64_t start, uint64_t end) {
    const Json *list = member(record, "data_offsets");
    if (!list || list->type != JSON_ARRAY || list->count != 2) return false;
    const Json *first = list->first, *second = first->next;
    return is_integer(first) && first->number == (double)start && is_integer(second) &&
           second->number == (double)end;
}

/* Finds the tensors, in the order of their data (section 4.3). */
static bool find_tensors(Span file, const Json *header, size_t start, Tensor *tensors, int count,
                         const char *entry, const TensorCodes *codes, RnaReport *report) {
    const Json *metadata = member(header, "__metadata__");
    size_t known = 0;
    for (int i = 0; i < count; i++) known += member(header, tensors[i].name) != NULL;
    if (known != (size_t)count || header->count != known + (metadata != NULL))
        return refuse(report, codes->tensors, entry, "the tensors of the format", "%zu members",
                      header->count);
    if (metadata && metadata->type != JSON_OBJECT)
        return refuse(report, codes->tensors, entry, "an object", "__metadata__ of another type");
    uint64_t end = 0;
    for (int i = 0; i < count; i++) {
        Tensor *tensor = &tensors[i];
        const Json *record = member(header, tensor->name);
        if (!check_form(record, tensor, entry, codes, report)) return false;
        uint64_t begin = end, size = tensor->item;
        for (int k = 0; k < tensor->rank; k++) size *= tensor->shape[k];
        end += size;
        if (!has_offsets(record, begin, end) || end > file.size - start)
            return refuse(report, codes->offsets, entry, "tensors one after another, in the file",
                          "%s to byte %llu of %zu", tensor->name, (unsigned long long)end,
                          file.size - start);
        tensor->data = file.at + start + begin;
    }
    if (end != file.size - start)
        return refuse(report, codes->offsets, entry, "the end of the file", "%zu bytes more",
                      (size_t)(file.size - start - end));
    return start % ALIGNMENT == 0 ||
           refuse(report, codes->alignment, entry, "data at a multiple of 64", "byte %zu", start);
}

static bool read_tensors(Span file, Tensor *tensors, int count, const char *entry,
                         const TensorCodes *codes, RnaReport *report) {
    uint64_t size = file.size < 8 ? UINT64_MAX : u64_at(file.at);
    if (file.size < 8 || size > MAX_HEADER || size > file.size - 8)
        return refuse(report, codes->header, entry, "a header of at most 64 KiB, inside the file",
                      "%zu bytes", file.size);
    JsonText text;
    Span data = {file.at + 8, (size_t)size};
    if (size == 0 || data.at[0] != '{')
        return refuse(report, codes->header, entry, "a header from { on", "another");
    const Json *header = parse_json(data, entry, codes->header, &text, report);
    bool good = header && find_tensors(file, header, 8 + data.size, tensors, count, entry, codes, report);
    free_json(&text);
    return good;
}

static bool are_finite(const float *values, size_t count) {
    uint32_t all = 0;
    for (size_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, &values[i], sizeof bits);
        all |= (bits & 0x7f800000u) == 0x7f800000u;
    }
    return all == 0;
}

static bool are_within(const float *values, size_t count, float limit) {
    int beyond = 0;
    for (size_t i = 0; i < count; i++) beyond |= !(fabsf(values[i]) <= limit); /* NaN, too */
    return beyond == 0;
}

static bool halves_are_finite(const uint16_t *values, size_t count) {
    uint16_t all = 0;
    for (size_t i = 0; i < count; i++) all |= (values[i] & 0x7c00u) == 0x7c00u;
    return all == 0;
}

/* The planes of a tier, in the file (section 5). */
typedef struct Planes {
    enum { INT8, FLOAT16, FLOAT32 } precision;
    int resolution, channels;
    const void *texels;  /* [3, R, R, C] */
    const float *scales; /* [3, C] of int8 */
} Planes;

static bool read_planes(Span file, Planes *planes, const char *entry, RnaReport *report) {
    static const TensorCodes CODES = {"PLANES_HEADER", "PLANES_TENSOR", "PLANES_DTYPE",
                                      "PLANES_SHAPE",  "PLANES_HEADER", "PLANES_ALIGNMENT"};
    static const struct {
        const char *dtype;
        unsigned item;
    } TYPES[] = {[INT8] = {"I8", 1}, [FLOAT16] = {"F16", 2}, [FLOAT32] = {"F32", 4}};
    uint64_t r = (uint64_t)planes->resolution, c = (uint64_t)planes->channels;
    Tensor tensors[] = {{"scales", "F32", 4, 2, {3, c}, {3, c}, {0}, NULL},
                        {"planes", TYPES[planes->precision].dtype, TYPES[planes->precision].item, 4,
                         {3, r, r, c}, {3, r, r, c}, {0}, NULL}};
    int skipped = planes->precision != INT8;
    if (!read_tensors(file, tensors + skipped, 2 - skipped, entry, &CODES, report)) return false;
    planes->scales = (const float *)(const void *)tensors[0].data;
    planes->texels = tensors[1].data;
    size_t count = (size_t)(3 * r * r * c);
    bool good = planes->precision == INT8      ? are_within(planes->scales, (size_t)(3 * c), 1e18f / 128)
                : planes->precision == FLOAT16 ? halves_are_finite(planes->texels, count)
                                               : are_within(planes->texels, count, 1e18f);
    return good || refuse(report, "PLANES_NOT_FINITE", entry, "values within 1e18", "others");
}

/* Strands of two points and more that share out all points, no two in a row equal. */
static bool check_strands(const RnaCurves *curves, const char *entry, RnaReport *report) {
    const uint32_t *offsets = curves->offsets;
    if (offsets[0] != 0 || offsets[curves->strand_count] != curves->point_count)
        return refuse(report, "GEOMETRY_STRANDS", entry, "offsets from 0 to the number of points",
                      "%u to %u", (unsigned)offsets[0], (unsigned)offsets[curves->strand_count]);
    for (uint32_t s = 0; s < curves->strand_count; s++)
        if ((int64_t)offsets[s + 1] - offsets[s] < 2)
            return refuse(report, "GEOMETRY_STRANDS", entry, "2 points and more in each",
                          "%lld in strand %u", (long long)offsets[s + 1] - offsets[s], (unsigned)s);
    for (uint32_t s = 0; s < curves->strand_count; s++)
        for (uint32_t i = offsets[s]; i + 1 < offsets[s + 1]; i++) {
            const float *a = &curves->points[3 * (size_t)i], *b = a + 3;
            if (a[0] == b[0] && a[1] == b[1] && a[2] == b[2])
                return refuse(report, "GEOMETRY_SEGMENT", entry, "a segment of some length",
                              "points %u and %u are equal", (unsigned)i, (unsigned)i + 1);
        }
    return true;
}

static bool read_curves(Span file, RnaCurves *curves, const char *entry, RnaReport *report) {
    static const TensorCodes CODES = {"GEOMETRY_CONTAINER", "GEOMETRY_PROFILE", "GEOMETRY_PROFILE",
                                      "GEOMETRY_PROFILE",   "GEOMETRY_RANGE",   "GEOMETRY_PROFILE"};
    Tensor tensors[] = {{"points", "F32", 4, 2, {2, 3}, {MAX_POINTS, 3}, {0}, NULL},
                        {"radii", "F32", 4, 1, {2}, {MAX_POINTS}, {0}, NULL},
                        {"offsets", "U32", 4, 1, {2}, {MAX_STRANDS + 1}, {0}, NULL}};
    if (!read_tensors(file, tensors, 3, entry, &CODES, report)) return false;
    curves->point_count = (uint32_t)tensors[0].shape[0];
    curves->strand_count = (uint32_t)tensors[2].shape[0] - 1;
    curves->points = (const float *)(const void *)tensors[0].data;
    curves->radii = (const float *)(const void *)tensors[1].data;
    curves->offsets = (const uint32_t *)(const void *)tensors[2].data;
    if (tensors[1].shape[0] != curves->point_count)
        return refuse(report, "GEOMETRY_ARRAY", entry, "a radius for each point", "%u points",
                      (unsigned)curves->point_count);
    if (!check_strands(curves, entry, report)) return false;
    if (!are_finite(curves->points, 3 * (size_t)curves->point_count) ||
        !are_finite(curves->radii, curves->point_count))
        return refuse(report, "GEOMETRY_NOT_FINITE", entry, "finite points and radii", "others");
    for (uint32_t i = 0; i < curves->point_count; i++)
        if (!(curves->radii[i] > 0))
            return refuse(report, "GEOMETRY_RADIUS", entry, "radii greater than 0", "%g at point %u",
                          curves->radii[i], (unsigned)i);
    return true;
}

/* ------------------------------------------------------------------- 8 Mesh */

enum { GLTF_UINT = 5125, GLTF_FLOAT = 5126 };
#define LARGEST_UINT 4294967295.0

#define INDEX 0, LARGEST_UINT
#define COUNT 1, LARGEST_UINT

static const Rule NODE_NUMBER = {"", INTEGER, 0, 0, 0};
static const Rule GLTF_ASSET[] = {{"version", CHOICE, REQUIRED, .choices = "2.0"},
                                  {"generator", TEXT},
                                  {"copyright", TEXT},
                                  {0}};
static const Rule GLTF_SCENE[] = {{"nodes", LIST, REQUIRED, 1, 1, &NODE_NUMBER}, {"name", TEXT}, {0}};
static const Rule GLTF_NODE[] = {{"mesh", INTEGER, REQUIRED, 0, 0}, {"name", TEXT}, {0}};
static const Rule ATTRIBUTES[] = {{"POSITION", INTEGER, REQUIRED, INDEX},
                                  {"NORMAL", INTEGER, REQUIRED, INDEX},
                                  {"TEXCOORD_0", INTEGER, 0, INDEX},
                                  {0}};
static const Rule PRIMITIVE[] = {{"attributes", OBJECT, REQUIRED, .of = ATTRIBUTES},
                                 {"indices", INTEGER, REQUIRED, INDEX},
                                 {"mode", INTEGER, 0, 4, 4},
                                 {0}};
static const Rule A_PRIMITIVE = {"", OBJECT, .of = PRIMITIVE};
static const Rule GLTF_MESH[] = {{"primitives", LIST, REQUIRED, 1, 1, &A_PRIMITIVE}, {"name", TEXT}, {0}};
static const Rule ACCESSOR[] = {{"bufferView", INTEGER, REQUIRED, INDEX},
                                {"byteOffset", INTEGER, 0, INDEX},
                                {"componentType", INTEGER, REQUIRED, GLTF_UINT, GLTF_FLOAT},
                                {"normalized", FALSE},
                                {"count", INTEGER, REQUIRED, COUNT},
                                {"type", CHOICE, REQUIRED, .choices = "SCALAR VEC2 VEC3"},
                                {"min", LIST, 0, ANY_COUNT, &COORDINATE},
                                {"max", LIST, 0, ANY_COUNT, &COORDINATE},
                                {"name", TEXT},
                                {0}};
static const Rule BUFFER_VIEW[] = {{"buffer", INTEGER, REQUIRED, 0, 0},
                                   {"byteOffset", INTEGER, 0, INDEX},
                                   {"byteLength", INTEGER, REQUIRED, COUNT},
                                   {"target", INTEGER, 0, 34962, 34963},
                                   {"name", TEXT},
                                   {0}};
static const Rule BUFFER[] = {{"byteLength", INTEGER, REQUIRED, COUNT}, {"name", TEXT}, {0}};
static const Rule A_SCENE = {"", OBJECT, .of = GLTF_SCENE}, A_NODE = {"", OBJECT, .of = GLTF_NODE};
static const Rule A_MESH = {"", OBJECT, .of = GLTF_MESH}, AN_ACCESSOR = {"", OBJECT, .of = ACCESSOR};
static const Rule A_VIEW = {"", OBJECT, .of = BUFFER_VIEW}, A_BUFFER = {"", OBJECT, .of = BUFFER};
static const Rule GLTF[] = {{"asset", OBJECT, REQUIRED, .of = GLTF_ASSET},
                            {"scene", INTEGER, 0, 0, 0},
                            {"scenes", LIST, REQUIRED, 1, 1, &A_SCENE},
                            {"nodes", LIST, REQUIRED, 1, 1, &A_NODE},
                            {"meshes", LIST, REQUIRED, 1, 1, &A_MESH},
                            {"accessors", LIST, REQUIRED, 3, 4, &AN_ACCESSOR},
                            {"bufferViews", LIST, REQUIRED, 1, 4, &A_VIEW},
                            {"buffers", LIST, REQUIRED, 1, 1, &A_BUFFER},
                            {"extras", ANYTHING},
                            {0}};

/* A member that is an integer from 0, which it is where it is absent. */
static uint64_t integer_of(const Json *object, const char *name) {
    const Json *value = member(object, name);
    return value ? (uint64_t)value->number : 0;
}

static const Json *item_at(const Json *list, uint64_t index) {
    const Json *item = list->first;
    while (item && index--) item = item->next;
    return item;
}

/* The values of accessor `index`, which must be of this type; *count: of its elements. */
static const void *gltf_array(const Json *gltf, Span blob, uint64_t index, const char *type,
                              uint32_t *count, const char *entry, RnaReport *report) {
    const Json *accessor = item_at(member(gltf, "accessors"), index);
    unsigned width = strcmp(type, "VEC3") == 0 ? 3 : strcmp(type, "VEC2") == 0 ? 2 : 1;
    if (!accessor) {
        refuse(report, "GEOMETRY_RANGE", entry, "an existing accessor", "%u", (unsigned)index);
        return NULL;
    }
    if (!is_string(member(accessor, "type"), type) ||
        integer_of(accessor, "componentType") != (width == 1 ? GLTF_UINT : GLTF_FLOAT)) {
        refuse(report, "GEOMETRY_PROFILE", entry, type, "accessor %u of another type", (unsigned)index);
        return NULL;
    }
    const Json *view = item_at(member(gltf, "bufferViews"), integer_of(accessor, "bufferView"));
    if (!view) {
        refuse(report, "GEOMETRY_RANGE", entry, "an existing view", "accessor %u without it",
               (unsigned)index);
        return NULL;
    }
    uint64_t view_start = integer_of(view, "byteOffset"), elements = integer_of(accessor, "count");
    uint64_t view_end = view_start + integer_of(view, "byteLength");
    uint64_t start = view_start + integer_of(accessor, "byteOffset");
    if (start + 4 * width * elements > view_end || view_end > blob.size || start % 4) {
        refuse(report, "GEOMETRY_RANGE", entry, "aligned bytes inside view and buffer",
               "accessor %u of %llu elements", (unsigned)index, (unsigned long long)elements);
        return NULL;
    }
    *count = (uint32_t)elements;
    return blob.at + start;
}

/* The chunks of a .glb. */
static bool split_glb(Span file, Span *json, Span *blob, const char *entry, RnaReport *report) {
    if (file.size < 28 || u32_at(file.at) != 0x46546C67 || u32_at(file.at + 4) != 2 ||
        u32_at(file.at + 8) != file.size)
        return refuse(report, "GEOMETRY_CONTAINER", entry, "a glTF header and two chunks", "%zu bytes",
                      file.size);
    uint64_t size = u32_at(file.at + 12), bin = 20 + size + 8;
    if (u32_at(file.at + 16) != 0x4E4F534A || size > MAX_HEADER || bin > file.size)
        return refuse(report, "GEOMETRY_CONTAINER", entry, "a JSON chunk of at most 64 KiB",
                      "another of %llu bytes", (unsigned long long)size);
    *json = (Span){file.at + 20, (size_t)size};
    *blob = (Span){file.at + bin, file.size - (size_t)bin};
    if (u32_at(file.at + bin - 4) != 0x004E4942 || u32_at(file.at + bin - 8) != blob->size || bin % 4 ||
        blob->size % 4)
        return refuse(report, "GEOMETRY_CONTAINER", entry, "a BIN chunk that fills the file",
                      "another of %u bytes", (unsigned)u32_at(file.at + bin - 8));
    return true;
}

static bool check_mesh(const RnaMesh *mesh, const char *entry, RnaReport *report) {
    size_t vertices = mesh->vertex_count;
    if (!are_finite(mesh->positions, 3 * vertices) || !are_finite(mesh->normals, 3 * vertices) ||
        (mesh->uvs && !are_finite(mesh->uvs, 2 * vertices)))
        return refuse(report, "GEOMETRY_NOT_FINITE", entry, "finite attributes", "others");
    uint32_t largest = 0;
    for (size_t i = 0; i < 3 * (size_t)mesh->triangle_count; i++)
        largest = mesh->triangles[i] > largest ? mesh->triangles[i] : largest;
    if (largest >= vertices)
        return refuse(report, "GEOMETRY_INDEX", entry, "existing vertices", "%u of %zu",
                      (unsigned)largest, vertices);
    for (size_t i = 0; i < vertices; i++) {
        double x = mesh->normals[3 * i], y = mesh->normals[3 * i + 1], z = mesh->normals[3 * i + 2];
        double length = sqrt(x * x + y * y + z * z);
        if (fabs(length - 1) > 1e-3)
            return refuse(report, "GEOMETRY_NORMAL", entry, "unit within 0.001", "length %g", length);
    }
    return true;
}

/* The box around n points, radii included where there are any. */
static void box_around(const float *points, const float *radii, size_t n, float low[3], float high[3]) {
    for (int axis = 0; axis < 3; axis++) {
        low[axis] = HUGE_VALF;
        high[axis] = -HUGE_VALF;
        for (size_t i = 0; i < n; i++) {
            float x = points[3 * i + (size_t)axis], r = radii ? radii[i] : 0;
            if (x - r < low[axis]) low[axis] = x - r;
            if (x + r > high[axis]) high[axis] = x + r;
        }
    }
}

/* Whether the list has these three values, as float32. */
static bool has_values(const Json *list, const float values[3]) {
    if (!list || list->type != JSON_ARRAY || list->count != 3) return false;
    const Json *item = list->first;
    for (int i = 0; i < 3; i++, item = item->next)
        if (fabs(item->number) > 2 * (double)FLT_MAX || (float)item->number != values[i]) return false;
    return true;
}

static bool find_arrays(const Json *gltf, Span blob, RnaMesh *mesh, const char *entry,
                        RnaReport *report) {
    const Json *primitive = member(member(gltf, "meshes")->first, "primitives")->first;
    const Json *attributes = member(primitive, "attributes"), *uvs = member(attributes, "TEXCOORD_0");
    uint64_t at_positions = integer_of(attributes, "POSITION");
    uint32_t indices, normals, coordinates;
    mesh->triangles = gltf_array(gltf, blob, integer_of(primitive, "indices"), "SCALAR", &indices,
                                 entry, report);
    if (!mesh->triangles) return false;
    if (indices % 3)
        return refuse(report, "GEOMETRY_ARRAY", entry, "a multiple of 3", "%u indices",
                      (unsigned)indices);
    mesh->triangle_count = indices / 3;
    mesh->positions = gltf_array(gltf, blob, at_positions, "VEC3", &mesh->vertex_count, entry, report);
    if (!mesh->positions) return false;
    mesh->normals = gltf_array(gltf, blob, integer_of(attributes, "NORMAL"), "VEC3", &normals, entry,
                               report);
    if (!mesh->normals) return false;
    if (uvs) {
        mesh->uvs = gltf_array(gltf, blob, integer_of(attributes, "TEXCOORD_0"), "VEC2", &coordinates,
                               entry, report);
        if (!mesh->uvs) return false;
    }
    if (normals != mesh->vertex_count || (mesh->uvs && coordinates != mesh->vertex_count))
        return refuse(report, "GEOMETRY_ARRAY", entry, "attributes of equal counts", "others");
    if (!check_mesh(mesh, entry, report)) return false;
    const Json *accessor = item_at(member(gltf, "accessors"), at_positions);
    float low[3], high[3];
    box_around(mesh->positions, NULL, mesh->vertex_count, low, high);
    return (has_values(member(accessor, "min"), low) && has_values(member(accessor, "max"), high)) ||
           refuse(report, "GEOMETRY_BOUNDS", entry, "min and max of POSITION", "others");
}

static bool read_mesh(Span file, RnaMesh *mesh, const char *entry, RnaReport *report) {
    Span json, blob;
    if (!split_glb(file, &json, &blob, entry, report)) return false;
    JsonText text;
    Schema schema = {report, "GEOMETRY_PROFILE", "GEOMETRY_PROFILE", "GEOMETRY_PROFILE", true};
    schema.length = (size_t)snprintf(schema.where, sizeof schema.where / 2, "%s#", entry);
    if (schema.length >= sizeof schema.where / 2) schema.length = sizeof schema.where / 2 - 1;
    const Json *gltf = parse_json(json, entry, "GEOMETRY_CONTAINER", &text, report);
    bool good = gltf != NULL;
    if (good) check_members(&schema, GLTF, gltf);
    good = good && schema.issues == 0;
    if (good) {
        uint64_t declared = integer_of(member(gltf, "buffers")->first, "byteLength");
        if (declared > blob.size || blob.size > declared + 3)
            good = refuse(report, "GEOMETRY_RANGE", entry, "a buffer as long as its chunk", "%llu bytes",
                          (unsigned long long)declared);
        blob.size = (size_t)declared;
    }
    good = good && find_arrays(gltf, blob, mesh, entry, report);
    free_json(&text);
    return good;
}

/* ------------------------------------------------------------------- 9 ONNX */

/* The protobuf wire format.  All messages of a model draw on one budget of items. */
typedef struct Wire {
    unsigned items;
    const char *broken; /* what is wrong, once something is */
} Wire;

enum { VARINT = 0, FIXED64 = 1, BYTES = 2, FIXED32 = 5 };

typedef struct Field {
    uint64_t number, integer;
    Span bytes; /* of all but varints */
    bool is_integer;
} Field;

static bool breaks(Wire *wire, const char *what) {
    if (!wire->broken) wire->broken = what;
    return false;
}

static bool take_varint(Wire *wire, Span *data, uint64_t *value) {
    *value = 0;
    for (int shift = 0; shift < 70 && data->size; shift += 7) {
        uint8_t byte = *data->at++;
        data->size--;
        if (shift < 64) *value |= (uint64_t)(byte & 0x7f) << shift;
        if (byte < 0x80) return true;
    }
    return breaks(wire, "a varint cut short");
}

static bool spend(Wire *wire) {
    return wire->items++ < MAX_WIRE_ITEMS || breaks(wire, "more than 2^18 fields and numbers");
}

/* The next field of `message`; false at its end, and where it is broken. */
static bool next_field(Wire *wire, Span *message, Field *field) {
    uint64_t tag, size = 0;
    *field = (Field){0};
    if (wire->broken || message->size == 0) return false;
    if (!take_varint(wire, message, &tag)) return false;
    *field = (Field){.number = tag >> 3, .is_integer = (tag & 7) == VARINT};
    if (field->is_integer) return take_varint(wire, message, &field->integer) && spend(wire);
    switch (tag & 7) {
    case BYTES:
        if (!take_varint(wire, message, &size)) return false;
        break;
    case FIXED64: size = 8; break;
    case FIXED32: size = 4; break;
    default: return breaks(wire, "an unknown wire type");
    }
    if (size > message->size || field->number == 0) return breaks(wire, "a field past the end");
    field->bytes = (Span){message->at, (size_t)size};
    message->at += size;
    message->size -= (size_t)size;
    return spend(wire);
}

/* Protobuf merges a field that comes twice, so that two readers may see two models. */
static bool once(Wire *wire, uint64_t *seen, const Field *field) {
    uint64_t bit = (uint64_t)1 << (field->number & 63);
    if (*seen & bit) return breaks(wire, "a field comes twice");
    *seen |= bit;
    return true;
}

static bool need_bytes(Wire *wire, const Field *field, Span *bytes) {
    if (field->is_integer) return breaks(wire, "a varint for bytes");
    *bytes = field->bytes;
    return true;
}

static bool need_text(Wire *wire, const Field *field, Span *text) {
    return need_bytes(wire, field, text) && (is_utf8(*text) || breaks(wire, "a name that is no UTF-8"));
}

static bool need_integer(Wire *wire, const Field *field, uint64_t *value) {
    if (!field->is_integer) return breaks(wire, "bytes for a varint");
    *value = field->integer;
    return true;
}

/* The array, with room for one more behind its `count` items. */
static void *grown(Wire *wire, void *array, size_t count, size_t *room, size_t item) {
    if (count < *room) return array;
    size_t more = *room ? 2 * *room : 16;
    void *moved = realloc(array, more * item);
    if (!moved) {
        breaks(wire, "more than the memory holds");
        return array;
    }
    *room = more;
    return moved;
}

/* The place of a new last item; NULL where memory is out. */
#define APPEND(wire, list)                                                                      \
    ((list)->at = grown(wire, (list)->at, (list)->count, &(list)->room, sizeof *(list)->at),    \
     (list)->count < (list)->room ? &(list)->at[(list)->count++] : NULL)

/* TensorProto.DataType */
enum { ONNX_FLOAT = 1, ONNX_UINT8 = 2, ONNX_INT8 = 3, ONNX_INT32 = 6 };

typedef struct OnnxTensor {
    Span name;
    uint64_t type;
    uint64_t dims[2];
    size_t rank;
    uint64_t widest; /* the largest dimension, 1 where there is none */
    bool external, elsewhere; /* elsewhere: the values are not in raw_data alone */
    bool has_raw;
    Span raw;
} OnnxTensor;

typedef struct OnnxNode {
    Span operator, domain;
    size_t first_name;      /* in OnnxModel.names: the inputs, then the outputs */
    size_t inputs, outputs; /* how many */
    uint64_t widest;        /* of the lists and tensors in its attributes */
    size_t attributes;
    bool nested, has_axis;
    int64_t axis;
} OnnxNode;

typedef struct OnnxValue { /* an input or output of the graph */
    Span name;
    uint64_t type, dims[2];
    bool symbolic[2];
    size_t rank;
} OnnxValue;

typedef struct OnnxModel {
    uint64_t ir_version;
    size_t opsets;
    bool foreign_domain, bad_opset, nested;
    size_t initializers; /* how many of the tensors; the others are in attributes */
    struct { OnnxTensor *at; size_t count, room; } tensors;
    struct { OnnxNode *at; size_t count, room; } nodes;
    struct { Span *at; size_t count, room; } names;
    OnnxValue input, output; /* the last ones */
    size_t inputs, outputs;
} OnnxModel;

static void free_onnx(OnnxModel *model) {
    free(model->tensors.at);
    free(model->nodes.at);
    free(model->names.at);
}

static void read_dims(Wire *wire, OnnxTensor *tensor, const Field *field) {
    Span packed = field->is_integer ? (Span){0} : field->bytes;
    bool single = field->is_integer;
    while (single || packed.size) {
        uint64_t size = field->integer;
        if (!single && !(spend(wire) && take_varint(wire, &packed, &size))) return;
        if (tensor->rank < 2) tensor->dims[tensor->rank] = size;
        if (tensor->rank == 0 || size > tensor->widest) tensor->widest = size;
        tensor->rank++;
        single = false;
    }
}

static void read_location(Wire *wire, OnnxTensor *tensor, const Field *field) {
    Span packed = field->is_integer ? (Span){0} : field->bytes;
    if (field->is_integer) tensor->external |= field->integer != 0;
    while (packed.size) {
        uint64_t value;
        if (!(spend(wire) && take_varint(wire, &packed, &value))) return;
        tensor->external |= value != 0;
    }
}

static void read_tensor(Wire *wire, Span message, OnnxModel *model) {
    OnnxTensor *tensor = APPEND(wire, &model->tensors);
    if (!tensor) return;
    *tensor = (OnnxTensor){.widest = 1};
    uint64_t seen = 0;
    Field field;
    while (next_field(wire, &message, &field)) switch (field.number) {
        case 1: read_dims(wire, tensor, &field); break;
        case 2:
            if (once(wire, &seen, &field)) need_integer(wire, &field, &tensor->type);
            break;
        case 8:
            if (once(wire, &seen, &field)) need_text(wire, &field, &tensor->name);
            break;
        case 9:
            if (once(wire, &seen, &field)) tensor->has_raw = !field.is_integer;
            tensor->raw = field.bytes;
            break;
        case 12: break; /* doc_string */
        case 13: tensor->external = true; break;
        case 14: read_location(wire, tensor, &field); break;
        default: tensor->elsewhere = true;
        }
}

static void read_attribute(Wire *wire, Span message, OnnxModel *model, OnnxNode *node) {
    uint64_t floats = 0, integers = 0, strings = 0, value = 0, item, seen = 0;
    Span name = {0};
    Field field;
    while (next_field(wire, &message, &field)) switch (field.number) {
        case 1:
            if (once(wire, &seen, &field)) need_text(wire, &field, &name);
            break;
        case 3:
            if (once(wire, &seen, &field)) need_integer(wire, &field, &value);
            break;
        case 5:
        case 10: {
            Span tensor;
            if (!need_bytes(wire, &field, &tensor)) return;
            read_tensor(wire, tensor, model);
            if (wire->broken) return;
            uint64_t widest = model->tensors.at[model->tensors.count - 1].widest;
            if (widest > node->widest) node->widest = widest;
            break;
        }
        case 7: floats += field.is_integer ? 0 : field.bytes.size / 4; break;
        case 8:
            if (field.is_integer) integers++;
            while (!field.is_integer && field.bytes.size) {
                if (!(spend(wire) && take_varint(wire, &field.bytes, &item))) return;
                integers++;
            }
            break;
        case 9: strings++; break;
        case 6:
        case 11:
        case 14:
        case 15:
        case 21:
        case 22:
        case 23: node->nested = true; break;
        default: break;
        }
    uint64_t longest = floats > integers ? floats : integers;
    longest = longest > strings ? longest : strings;
    if (longest > node->widest) node->widest = longest;
    if (span_is(name, "axis")) node->has_axis = true, node->axis = (int64_t)value;
}

/* The names in fields `number` of a node; how many there are. */
static size_t read_names(Wire *wire, Span message, uint64_t number, OnnxModel *model) {
    size_t before = model->names.count;
    Wire unlimited = {0}; /* these fields were paid for already */
    Field field;
    while (next_field(&unlimited, &message, &field)) {
        unlimited.items = 0;
        Span *name = field.number == number ? APPEND(wire, &model->names) : NULL;
        if (name && !need_text(wire, &field, name)) break;
    }
    return model->names.count - before;
}

static void read_node(Wire *wire, Span message, OnnxModel *model) {
    OnnxNode node = {.first_name = model->names.count};
    Span rest = message;
    uint64_t seen = 0;
    Field field;
    while (next_field(wire, &rest, &field)) switch (field.number) {
        case 4:
            if (once(wire, &seen, &field)) need_text(wire, &field, &node.operator);
            break;
        case 5: {
            Span attribute;
            node.attributes++;
            if (need_bytes(wire, &field, &attribute)) read_attribute(wire, attribute, model, &node);
            break;
        }
        case 7:
            if (once(wire, &seen, &field)) need_text(wire, &field, &node.domain);
            break;
        default: break;
        }
    if (wire->broken) return;
    node.inputs = read_names(wire, message, 1, model);
    node.outputs = read_names(wire, message, 2, model);
    OnnxNode *place = APPEND(wire, &model->nodes);
    if (place) *place = node;
}

static void read_dimension(Wire *wire, Span message, OnnxValue *value) {
    uint64_t seen = 0, size = 0;
    bool known = false;
    Field field;
    Span name;
    while (next_field(wire, &message, &field)) {
        if (field.number == 1 && once(wire, &seen, &field)) known = need_integer(wire, &field, &size);
        if (field.number == 2 && once(wire, &seen, &field)) need_text(wire, &field, &name);
    }
    if (value->rank < 2) {
        value->dims[value->rank] = size;
        value->symbolic[value->rank] = !known;
    }
    value->rank++;
}

/* The message in field `number`, empty where it is absent; `name` and `type` of fields 1. */
static Span one_message(Wire *wire, Span message, uint64_t number, Span *name, uint64_t *type) {
    Span found = {0};
    uint64_t seen = 0;
    Field field;
    while (next_field(wire, &message, &field)) {
        if (field.number == number && once(wire, &seen, &field)) need_bytes(wire, &field, &found);
        if (field.number == 1 && name && once(wire, &seen, &field)) need_text(wire, &field, name);
        if (field.number == 1 && type && once(wire, &seen, &field)) need_integer(wire, &field, type);
    }
    return found;
}

static OnnxValue read_value(Wire *wire, Span message) {
    OnnxValue value = {0};
    Span type = one_message(wire, message, 2, &value.name, NULL);
    Span tensor = one_message(wire, type, 1, NULL, NULL);
    Span shape = one_message(wire, tensor, 2, NULL, &value.type);
    Field field;
    while (next_field(wire, &shape, &field)) {
        Span dimension;
        if (field.number == 1 && need_bytes(wire, &field, &dimension))
            read_dimension(wire, dimension, &value);
    }
    return value;
}

/* The messages in fields `number` of the graph, each handed to what reads it. */
static void read_graph(Wire *wire, Span graph, OnnxModel *model) {
    Span rest = graph, message;
    Field field;
    while (next_field(wire, &rest, &field)) {
        bool wanted = field.number == 1 || field.number == 11 || field.number == 12;
        if (field.number == 15) model->nested = true;
        if (field.number == 5) {
            if (!need_bytes(wire, &field, &message)) return;
            read_tensor(wire, message, model);
            model->initializers = model->tensors.count;
        }
        if (wanted && !need_bytes(wire, &field, &message)) return;
    }
    Wire paid = {0};
    while (next_field(&paid, &graph, &field)) {
        paid.items = 0;
        if (field.number == 1) read_node(wire, field.bytes, model);
        if (field.number == 11) model->inputs++, model->input = read_value(wire, field.bytes);
        if (field.number == 12) model->outputs++, model->output = read_value(wire, field.bytes);
    }
}

static bool is_default_domain(Span domain) { return domain.size == 0 || span_is(domain, "ai.onnx"); }

static void read_opset(Wire *wire, Span message, OnnxModel *model) {
    Span domain = {0};
    uint64_t version = 0, seen = 0;
    Field field;
    while (next_field(wire, &message, &field)) {
        if (field.number == 1 && once(wire, &seen, &field)) need_text(wire, &field, &domain);
        if (field.number == 2 && once(wire, &seen, &field)) need_integer(wire, &field, &version);
    }
    model->foreign_domain |= !is_default_domain(domain) || model->opsets > 0;
    model->bad_opset |= version < 13 || version > 21;
    model->opsets++;
}

static void read_onnx(Wire *wire, Span data, OnnxModel *model) {
    uint64_t seen = 0;
    Span graph = {0}, message;
    Field field;
    while (next_field(wire, &data, &field)) switch (field.number) {
        case 1:
            if (once(wire, &seen, &field)) need_integer(wire, &field, &model->ir_version);
            break;
        case 7:
            if (once(wire, &seen, &field)) need_bytes(wire, &field, &graph);
            break;
        case 8:
            if (need_bytes(wire, &field, &message)) read_opset(wire, message, model);
            break;
        case 20:
        case 25: model->nested = true; break;
        default: break;
        }
    read_graph(wire, graph, model);
}

/* Values by name: what is known of each before the node at hand. */
typedef struct Value {
    Span name;
    bool known;
    uint64_t bound; /* on its width */
    int tensor;     /* of an initializer, else -1 */
    int node;       /* that made it, else -1 */
} Value;

typedef struct ValueTable {
    Value *at;
    size_t mask;
} ValueTable;

static Value *find_value(const ValueTable *table, Span name) {
    uint32_t hash = 2166136261u; /* FNV-1a */
    for (size_t i = 0; i < name.size; i++) hash = (hash ^ name.at[i]) * 16777619u;
    size_t i = hash & table->mask;
    while (table->at[i].known && !same_span(table->at[i].name, name)) i = (i + 1) & table->mask;
    return &table->at[i];
}

static void set_value(ValueTable *table, Span name, uint64_t bound, int tensor, int node) {
    *find_value(table, name) = (Value){name, true, bound, tensor, node};
}

static const Span QUERIES = {(const uint8_t *)"queries", 7}, TRANSPORT = {(const uint8_t *)"transport", 9};

static bool check_nodes(const OnnxModel *model, bool is_int8, const char *entry, RnaReport *report) {
    static const char OPERATORS[] =
        "Abs Add And Atan Cast Ceil Clip Concat Constant Cos DequantizeLinear Div Elu Equal Erf Exp "
        "Floor Gelu Gemm Greater GreaterOrEqual HardSigmoid HardSwish Identity IsInf IsNaN "
        "LayerNormalization LeakyRelu Less LessOrEqual Log MatMul Max Min Mish Mul Neg Not Or PRelu "
        "Pow QuantizeLinear Reciprocal Relu Selu Sigmoid Sign Sin Slice Softplus Softsign Split Sqrt "
        "Sub Sum Tanh ThresholdedRelu Where Xor";
    if (model->nested)
        return refuse(report, "DECODER_NESTED", entry, "no functions, training or sparse tensors", "some");
    if (model->nodes.count > MAX_NODES)
        return refuse(report, "DECODER_GRAPH", entry, "at most 4096 nodes", "%zu", model->nodes.count);
    bool quantized = false;
    for (size_t i = 0; i < model->nodes.count; i++) {
        const OnnxNode *node = &model->nodes.at[i];
        int size = (int)(node->operator.size < 64 ? node->operator.size : 64);
        const char *name = (const char *)node->operator.at;
        if (!is_default_domain(node->domain))
            return refuse(report, "DECODER_DOMAIN", entry, "the default domain", "another in node %zu", i);
        if (node->nested)
            return refuse(report, "DECODER_NESTED", entry, "no graphs", "one in node %zu", i);
        if (!is_choice(node->operator, OPERATORS))
            return refuse(report, "DECODER_OPERATOR", entry, "an operator of the list", "%.*s", size, name);
        quantized |= is_choice(node->operator, "QuantizeLinear DequantizeLinear");
    }
    return quantized == is_int8 || refuse(report, "DECODER_PRECISION", entry, is_int8 ? "int8" : "float32",
                                          quantized ? "int8" : "float32");
}

static bool check_onnx_tensors(const OnnxModel *model, const char *entry, RnaReport *report) {
    static const uint64_t TYPES = 1 << 1 | 1 << 2 | 1 << 3 | 1 << 6 | 1 << 7 | 1 << 9 | 1 << 10;
    for (size_t i = 0; i < model->tensors.count; i++) {
        const OnnxTensor *tensor = &model->tensors.at[i];
        if (tensor->external)
            return refuse(report, "DECODER_EXTERNAL", entry, "data in the file", "external data");
        bool known = tensor->type < 64 && TYPES >> tensor->type & 1;
        if (!known || tensor->rank > 2 || tensor->widest > MAX_WIDTH)
            return refuse(report, "DECODER_TENSOR", entry, "at most 2 dimensions of at most 8192",
                          "type %llu, %zu dimensions", (unsigned long long)tensor->type, tensor->rank);
    }
    return true;
}

/* Each value is made once and before its use, and no width can pass the limit. */
static bool check_widths(const OnnxModel *model, ValueTable *values, const char *entry,
                         RnaReport *report) {
    for (size_t i = 0; i < model->nodes.count; i++) {
        const OnnxNode *node = &model->nodes.at[i];
        const Span *names = model->names.at ? model->names.at + node->first_name : NULL;
        uint64_t sum = 0, most = node->inputs ? 0 : 1;
        for (size_t k = 0; k < node->inputs; k++) {
            const Value *value = find_value(values, names[k]);
            if (!value->known)
                return refuse(report, "DECODER_GRAPH", entry, "values made before their use",
                              "node %zu", i);
            sum += value->bound;
            most = value->bound > most ? value->bound : most;
        }
        uint64_t bound = span_is(node->operator, "Concat") ? sum : most;
        if (node->widest > bound) bound = node->widest;
        for (size_t k = node->inputs; k < node->inputs + node->outputs; k++)
            if (names[k].size && find_value(values, names[k])->known)
                return refuse(report, "DECODER_GRAPH", entry, "each value made once", "node %zu", i);
        if (bound > MAX_WIDTH)
            return refuse(report, "DECODER_TENSOR", entry, "a width of at most 8192", "%llu",
                          (unsigned long long)bound);
        for (size_t k = node->inputs; k < node->inputs + node->outputs; k++)
            if (names[k].size) set_value(values, names[k], bound, -1, (int)i);
    }
    return find_value(values, TRANSPORT)->known ||
           refuse(report, "DECODER_GRAPH", entry, "a value transport", "nothing makes it");
}

static bool is_interface(const OnnxValue *value, size_t count, Span name, uint64_t width) {
    return count == 1 && same_span(value->name, name) && value->type == ONNX_FLOAT && value->rank == 2 &&
           value->symbolic[0] && !value->symbolic[1] && value->dims[1] == width;
}

/* Checks the structure (section 6.2).  `values`: written, of the whole graph; the caller frees it. */
static bool check_onnx(Span data, int columns, bool is_int8, OnnxModel *model, ValueTable *values,
                       const char *entry, RnaReport *report) {
    if (data.size > MAX_DECODER)
        return refuse(report, "DECODER_TOO_LARGE", entry, "at most 64 MiB", "%zu bytes", data.size);
    Wire wire = {0};
    read_onnx(&wire, data, model);
    if (wire.broken || model->opsets == 0 || model->nodes.count == 0)
        return refuse(report, "DECODER_NOT_ONNX", entry, "an ONNX ModelProto", "%s",
                      wire.broken ? wire.broken : "no operator set or no nodes");
    if (model->foreign_domain)
        return refuse(report, "DECODER_DOMAIN", entry, "the default domain, once", "more");
    if (model->bad_opset || model->ir_version < 7 || model->ir_version > 10)
        return refuse(report, "DECODER_VERSION", entry, "IR 7 to 10 and operator set 13 to 21", "others");
    if (!is_interface(&model->input, model->inputs, QUERIES, (uint64_t)columns))
        return refuse(report, "DECODER_INPUT", entry, "queries float32 [N, K], N symbolic", "another");
    if (!is_interface(&model->output, model->outputs, TRANSPORT, 6))
        return refuse(report, "DECODER_OUTPUT", entry, "transport float32 [N, 6], N symbolic", "another");
    if (!check_nodes(model, is_int8, entry, report) || !check_onnx_tensors(model, entry, report))
        return false;
    size_t room = 64;
    while (room < 2 * (model->tensors.count + model->names.count + 2)) room *= 2;
    *values = (ValueTable){calloc(room, sizeof(Value)), room - 1};
    if (!values->at)
        return refuse(report, "DECODER_LOAD", entry, "memory for its values", "not enough");
    set_value(values, (Span){0}, 1, -1, -1);
    set_value(values, QUERIES, (uint64_t)columns, -1, -1);
    for (size_t i = 0; i < model->initializers; i++) {
        const OnnxTensor *tensor = &model->tensors.at[i];
        if (find_value(values, tensor->name)->known)
            return refuse(report, "DECODER_GRAPH", entry, "each value made once", "a name made twice");
        set_value(values, tensor->name, tensor->widest, (int)i, -1);
    }
    return check_widths(model, values, entry, report);
}

/* --------------------------------------------------------------- 10 Decoder */

/* Values lie column after column, ROWS queries in each, and every loop over rows has this constant
 * length: compilers make it whole vectors.  Multiply-adds are written as such, so that a row's result
 * does not hang on what the compiler contracts, nor on the rows beside it. */
#if defined(__AVX512F__)
enum { LANES = 16 };
#elif defined(__AVX__)
enum { LANES = 8 };
#else
enum { LANES = 4 };
#endif
enum { ROWS = 48, GROUP = 3 * LANES, OUTPUTS = 4 }; /* GROUP x OUTPUTS sums stay in registers */

#ifdef FP_FAST_FMAF
#define MULTIPLY_ADD(a, b, c) fmaf(a, b, c)
#else
#define MULTIPLY_ADD(a, b, c) ((a) * (b) + (c))
#endif

enum { EXACT_INPUTS = 512 }; /* 512 * 255 * 128 < 2^24: float32 holds such sums of integers exactly */

/* One operator of a chain, or an int8 layer. */
typedef struct Step {
    enum { CLIP, MULTIPLY, ADD, EXP, PRODUCT, INT8_PRODUCT } kind;
    int inputs, outputs;
    float low, high;      /* CLIP; of an INT8_PRODUCT, the range of the stored integers */
    float step;           /* INT8_PRODUCT: what 1 means in its uint8 inputs */
    bool relu;            /* of the products */
    float *values;        /* MULTIPLY, ADD: one a column */
    float *weights;       /* products: [outputs / OUTPUTS][inputs][OUTPUTS] */
    float *bias;          /* PRODUCT: one an output */
    float *unit;          /* INT8_PRODUCT: (sum + whole_bias) * unit, one an output */
    double *whole_bias;
} Step;

typedef struct Decoder {
    int columns, widest, count;
    Step *steps;
    bool runs;       /* it is a chain, and loaded */
    bool in_profile; /* and one of the decoder profile */
} Decoder;

static int rounded_up(int n, int to) { return (n + to - 1) / to * to; }

static void free_decoder(Decoder *decoder) {
    for (int i = 0; i < decoder->count; i++) {
        free(decoder->steps[i].values);
        free(decoder->steps[i].weights);
        free(decoder->steps[i].bias);
        free(decoder->steps[i].unit);
        free(decoder->steps[i].whole_bias);
    }
    free(decoder->steps);
    *decoder = (Decoder){0};
}

static float clamp(float x, float low, float high) {
    x = x > low ? x : low; /* low for NaN */
    return x < high ? x : high;
}

/* Sums of OUTPUTS columns for GROUP rows: sums[j][r] = sum over k of weights[k][j] * x[k][r]. */
static void multiply(int inputs, const float *restrict x, const float *restrict weights,
                     float sums[restrict OUTPUTS][GROUP]) {
    float s[OUTPUTS][GROUP] = {{0}};
    for (int k = 0; k < inputs; k++, x += ROWS, weights += OUTPUTS)
        for (int j = 0; j < OUTPUTS; j++)
            for (int r = 0; r < GROUP; r++) s[j][r] = MULTIPLY_ADD(weights[j], x[r], s[j][r]);
    memcpy(sums, s, sizeof s);
}

static void run_product(const Step *step, const float *restrict x, float *restrict y) {
    const float floor = step->relu ? 0 : -FLT_MAX;
    for (int j = 0; j < step->outputs; j += OUTPUTS)
        for (int g = 0; g < ROWS; g += GROUP) {
            float sums[OUTPUTS][GROUP];
            multiply(step->inputs, x + g, step->weights + (size_t)j * (size_t)step->inputs, sums);
            for (int i = 0; i < OUTPUTS; i++)
                for (int r = 0; r < GROUP; r++) {
                    float value = sums[i][r] + step->bias[j + i];
                    y[(j + i) * ROWS + g + r] = value < floor ? floor : value; /* NaN stays */
                }
        }
}

/* Rounds to nearest, ties to even, for |x| below 2^22. */
static float rounded(float x) { return (x + 12582912.0f) - 12582912.0f; }

static void quantize(const Step *step, float *x) {
    for (int k = 0; k < step->inputs; k++)
        for (int r = 0; r < ROWS; r++)
            x[k * ROWS + r] = rounded(clamp(x[k * ROWS + r] / step->step, step->low, step->high));
}

/* Sums of integers, exact: in float32 over up to EXACT_INPUTS inputs, in int32 over all. */
static void run_int8_product(const Step *step, float *restrict x, float *restrict y) {
    const float floor = step->relu ? 0 : -FLT_MAX;
    quantize(step, x);
    for (int j = 0; j < step->outputs; j += OUTPUTS)
        for (int g = 0; g < ROWS; g += GROUP) {
            float sums[OUTPUTS][GROUP];
            int32_t total[OUTPUTS][GROUP] = {{0}};
            for (int k = 0; k < step->inputs; k += EXACT_INPUTS) {
                int part = step->inputs - k < EXACT_INPUTS ? step->inputs - k : EXACT_INPUTS;
                multiply(part, x + k * ROWS + g,
                         step->weights + (size_t)j * (size_t)step->inputs + (size_t)k * OUTPUTS, sums);
                for (int i = 0; i < OUTPUTS; i++)
                    for (int r = 0; r < GROUP; r++) total[i][r] += (int32_t)sums[i][r];
            }
            for (int i = 0; i < OUTPUTS; i++)
                for (int r = 0; r < GROUP; r++) {
                    double sum = total[i][r] + step->whole_bias[j + i];
                    float value = (float)(sum * step->unit[j + i]);
                    y[(j + i) * ROWS + g + r] = value < floor ? floor : value; /* NaN stays */
                }
        }
}

/* e^x to some 1e-7; infinity beyond the largest float32. */
static float exponential(float x) {
    float y = clamp(x, -87.0f, 89.0f);
    float n = rounded(y * 1.44269504f);
    float r = MULTIPLY_ADD(n, -0.693145752f, y);
    r = MULTIPLY_ADD(n, -1.42860677e-6f, r);
    float p = 1.0f / 5040;
    p = MULTIPLY_ADD(p, r, 1.0f / 720);
    p = MULTIPLY_ADD(p, r, 1.0f / 120);
    p = MULTIPLY_ADD(p, r, 1.0f / 24);
    p = MULTIPLY_ADD(p, r, 1.0f / 6);
    p = MULTIPLY_ADD(p, r, 0.5f);
    p = MULTIPLY_ADD(p, r, 1.0f);
    p = MULTIPLY_ADD(p, r, 1.0f);
    uint32_t bits = (uint32_t)((int32_t)n + 126) << 23; /* 2^(n - 1) */
    float power;
    memcpy(&power, &bits, sizeof power);
    return x == x ? p * power * 2.0f : x;
}

static void run_elementwise(const Step *step, float *x) {
    for (int k = 0; k < step->inputs; k++, x += ROWS) switch (step->kind) {
        case CLIP:
            for (int r = 0; r < ROWS; r++) { /* NaN stays, to be found in the end */
                float raised = x[r] < step->low ? step->low : x[r];
                x[r] = raised > step->high ? step->high : raised;
            }
            break;
        case MULTIPLY:
            for (int r = 0; r < ROWS; r++) x[r] *= step->values[k];
            break;
        case ADD:
            for (int r = 0; r < ROWS; r++) x[r] += step->values[k];
            break;
        default:
            for (int r = 0; r < ROWS; r++) x[r] = exponential(x[r]);
        }
}

/* Runs ROWS queries; returns their transport, [6][ROWS], which is in `a` or `b`.  a: the queries,
 * [columns][ROWS].  Both have room for `widest` columns. */
static const float *run_decoder(const Decoder *decoder, float *a, float *b) {
    for (int i = 0; i < decoder->count; i++) {
        const Step *step = &decoder->steps[i];
        if (step->kind != PRODUCT && step->kind != INT8_PRODUCT) {
            run_elementwise(step, a);
            continue;
        }
        if (step->kind == PRODUCT)
            run_product(step, a, b);
        else
            run_int8_product(step, a, b);
        float *swap = a;
        a = b;
        b = swap;
    }
    return a;
}

static void *aligned(size_t size) {
    return aligned_alloc(ALIGNMENT, (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT);
}

/* A graph on its way to a Decoder. */
typedef struct Builder {
    const OnnxModel *model;
    const ValueTable *values;
    Decoder *decoder;
    size_t node; /* the next one */
    Span value;  /* what the chain has made so far */
    int width;
    char kinds[MAX_NODES + 1]; /* one letter a step, for the profile */
    int letters;
    bool plain; /* constants have no other shapes than the profile's */
    size_t used; /* nodes that the chain holds */
} Builder;

typedef enum Outcome {
    LOADED,
    NO_CHAIN, /* needs an ONNX engine */
    DOES_NOT_FIT
} Outcome;

/* The initializer `name` of this type, with all its values in raw_data; NULL where it is none. */
static const OnnxTensor *constant(const Builder *b, Span name, uint64_t type) {
    const Value *value = find_value(b->values, name);
    if (!value->known || value->tensor < 0 || name.size == 0) return NULL;
    const OnnxTensor *tensor = &b->model->tensors.at[value->tensor];
    return tensor->type == type && tensor->has_raw && !tensor->elsewhere ? tensor : NULL;
}

static uint64_t element_count(const OnnxTensor *tensor) {
    return (tensor->rank > 0 ? tensor->dims[0] : 1) * (tensor->rank > 1 ? tensor->dims[1] : 1);
}

static bool has_bytes(const OnnxTensor *tensor, unsigned item) {
    return tensor->raw.size == element_count(tensor) * item;
}

static float float_at(const OnnxTensor *tensor, uint64_t i) {
    float value;
    memcpy(&value, tensor->raw.at + 4 * i, sizeof value);
    return value;
}

static Outcome one_float(Builder *b, Span name, float *value) {
    const OnnxTensor *tensor = constant(b, name, ONNX_FLOAT);
    if (!tensor) return NO_CHAIN;
    if (element_count(tensor) != 1 || !has_bytes(tensor, 4)) return DOES_NOT_FIT;
    b->plain &= tensor->rank == 0;
    *value = float_at(tensor, 0);
    return LOADED;
}

/* A value for each of `width` columns, from a constant of one or of so many.  rank: that the profile
 * asks for. */
static Outcome column_floats(Builder *b, Span name, int width, size_t rank, float **values) {
    const OnnxTensor *tensor = constant(b, name, ONNX_FLOAT);
    if (!tensor || tensor->rank > 1) return NO_CHAIN;
    uint64_t count = element_count(tensor);
    if ((count != 1 && count != (uint64_t)width) || !has_bytes(tensor, 4)) return DOES_NOT_FIT;
    b->plain &= tensor->rank == rank && (rank == 0 || count == (uint64_t)width);
    *values = aligned(sizeof(float) * (size_t)rounded_up(width, OUTPUTS));
    if (!*values) return DOES_NOT_FIT;
    for (int i = 0; i < rounded_up(width, OUTPUTS); i++)
        (*values)[i] = i < width ? float_at(tensor, count == 1 ? 0 : (uint64_t)i) : 0;
    return LOADED;
}

static const OnnxNode *node_that_makes(const Builder *b, Span name) {
    const Value *value = find_value(b->values, name);
    return value->known && value->node >= 0 ? &b->model->nodes.at[value->node] : NULL;
}

static Span name_of(const Builder *b, const OnnxNode *node, size_t i) {
    return b->model->names.at[node->first_name + i];
}

/* Packs a weight [inputs, outputs] of the step's sizes; of int8 where `is_int8`. */
static Outcome pack_weights(Step *step, const OnnxTensor *weight, bool is_int8) {
    if (weight->rank != 2 || weight->dims[0] != (uint64_t)step->inputs || weight->dims[1] == 0 ||
        !has_bytes(weight, is_int8 ? 1 : 4))
        return DOES_NOT_FIT;
    step->outputs = (int)weight->dims[1];
    size_t inputs = (size_t)step->inputs, outputs = (size_t)step->outputs;
    size_t padded = (size_t)rounded_up(step->outputs, OUTPUTS);
    step->weights = aligned(sizeof(float) * inputs * padded);
    if (!step->weights) return DOES_NOT_FIT;
    for (size_t j = 0; j < padded; j++)
        for (size_t k = 0; k < inputs; k++) {
            size_t from = k * outputs + j;
            float value = j >= outputs ? 0
                          : is_int8    ? (float)(int8_t)weight->raw.at[from]
                                       : float_at(weight, from);
            step->weights[(j / OUTPUTS * inputs + k) * OUTPUTS + j % OUTPUTS] = value;
        }
    return LOADED;
}

static Outcome add_product(Builder *b, Step *step, const OnnxNode *node) {
    bool is_gemm = span_is(node->operator, "Gemm");
    const OnnxTensor *weight = constant(b, name_of(b, node, 1), ONNX_FLOAT);
    if (!weight || node->inputs != (is_gemm ? 3 : 2)) return NO_CHAIN;
    step->kind = PRODUCT;
    Outcome outcome = pack_weights(step, weight, false);
    if (outcome != LOADED) return outcome;
    if (is_gemm) return column_floats(b, name_of(b, node, 2), step->outputs, 1, &step->bias);
    step->bias = calloc((size_t)rounded_up(step->outputs, OUTPUTS), sizeof *step->bias);
    return step->bias ? LOADED : DOES_NOT_FIT;
}

/* DequantizeLinear of a constant of `type` along `axis`, whose result is `name`; its operands. */
static bool is_dequantized(Builder *b, Span name, uint64_t type, int64_t axis,
                           const OnnxTensor **tensor, Span *scale) {
    const OnnxNode *node = node_that_makes(b, name);
    if (!node || !span_is(node->operator, "DequantizeLinear") || node->inputs != 2) return false;
    if (node->attributes > 1 || (node->attributes && !node->has_axis)) return false;
    if ((node->has_axis ? node->axis : 1) != axis) return false;
    b->plain &= node->has_axis;
    *tensor = constant(b, name_of(b, node, 0), type);
    *scale = name_of(b, node, 1);
    return *tensor != NULL;
}

static bool same_constant(const Builder *b, Span x, Span y, uint64_t type) {
    const OnnxTensor *a = constant(b, x, type), *c = constant(b, y, type);
    return a && c && same_span(a->raw, c->raw);
}

/* The first node of the chain from `node` on: without those that dequantize constants, which stand
 * anywhere before their Gemm. */
static size_t next_in_chain(const Builder *b, size_t node) {
    for (; node < b->model->nodes.count; node++) {
        const OnnxNode *at = &b->model->nodes.at[node];
        if (!span_is(at->operator, "DequantizeLinear") || at->inputs == 0) break;
        if (find_value(b->values, name_of(b, at, 0))->tensor < 0) break;
    }
    return node;
}

/* The bias as it is stored, in units of the sums. */
static Outcome add_whole_bias(Builder *b, Step *step, const OnnxTensor *bias, Span scale_name) {
    float *scale = NULL;
    Outcome outcome = column_floats(b, scale_name, step->outputs, 1, &scale);
    bool fits = bias->rank == 1 && bias->dims[0] == (uint64_t)step->outputs && has_bytes(bias, 4);
    if (outcome == LOADED && !fits) outcome = DOES_NOT_FIT;
    step->whole_bias = calloc((size_t)rounded_up(step->outputs, OUTPUTS), sizeof *step->whole_bias);
    if (!step->whole_bias) outcome = DOES_NOT_FIT;
    for (int i = 0; outcome == LOADED && i < step->outputs; i++) {
        if (!(fabsf(scale[i] - step->unit[i]) <= 1e-6f * fabsf(step->unit[i]))) outcome = NO_CHAIN;
        step->whole_bias[i] = (int32_t)u32_at(bias->raw.at + 4 * i);
    }
    free(scale);
    return outcome;
}

/* QuantizeLinear, DequantizeLinear and a Gemm of dequantized constants: one layer in integers. */
static Outcome add_int8_product(Builder *b, Step *step, const OnnxNode *quantize) {
    size_t second = next_in_chain(b, b->node + 1), third = next_in_chain(b, second + 1);
    if (third >= b->model->nodes.count || quantize->inputs != 3) return NO_CHAIN;
    const OnnxNode *dequantize = &b->model->nodes.at[second], *gemm = &b->model->nodes.at[third];
    bool chained = span_is(dequantize->operator, "DequantizeLinear") && span_is(gemm->operator, "Gemm") &&
                   dequantize->inputs == 3 && gemm->inputs == 3 && dequantize->outputs == 1 &&
                   gemm->outputs == 1 && quantize->attributes == 0 && dequantize->attributes == 0 &&
                   gemm->attributes == 0 && same_span(name_of(b, dequantize, 0), name_of(b, quantize, 3)) &&
                   same_span(name_of(b, gemm, 0), name_of(b, dequantize, 3)) &&
                   same_constant(b, name_of(b, quantize, 1), name_of(b, dequantize, 1), ONNX_FLOAT) &&
                   same_constant(b, name_of(b, quantize, 2), name_of(b, dequantize, 2), ONNX_UINT8);
    const OnnxTensor *weight, *bias, *zero = constant(b, name_of(b, quantize, 2), ONNX_UINT8);
    Span weight_scale, bias_scale;
    if (!chained || !is_dequantized(b, name_of(b, gemm, 1), ONNX_INT8, 1, &weight, &weight_scale) ||
        !is_dequantized(b, name_of(b, gemm, 2), ONNX_INT32, 0, &bias, &bias_scale))
        return NO_CHAIN;
    step->kind = INT8_PRODUCT;
    Outcome outcome = one_float(b, name_of(b, quantize, 1), &step->step);
    if (outcome != LOADED) return outcome;
    if (element_count(zero) != 1 || !has_bytes(zero, 1)) return DOES_NOT_FIT;
    /* Stored less the zero point, so that nothing is left of it in the sums. */
    step->low = -(float)zero->raw.at[0];
    step->high = 255 + step->low;
    if ((outcome = pack_weights(step, weight, true)) != LOADED) return outcome;
    if ((outcome = column_floats(b, weight_scale, step->outputs, 1, &step->unit)) != LOADED) return outcome;
    for (int i = 0; i < step->outputs; i++) step->unit[i] *= step->step;
    if ((outcome = add_whole_bias(b, step, bias, bias_scale)) != LOADED) return outcome;
    b->node = third;
    b->used += 4;
    return LOADED;
}

static Outcome add_elementwise(Builder *b, Step *step, const OnnxNode *node) {
    if (span_is(node->operator, "Exp")) {
        step->kind = EXP;
        return node->inputs == 1 ? LOADED : NO_CHAIN;
    }
    if (span_is(node->operator, "Clip")) {
        step->kind = CLIP;
        if (node->inputs != 3) return NO_CHAIN;
        Outcome outcome = one_float(b, name_of(b, node, 1), &step->low);
        return outcome != LOADED ? outcome : one_float(b, name_of(b, node, 2), &step->high);
    }
    if (node->inputs != 2) return NO_CHAIN;
    bool enters = b->letters <= 3; /* gain and offset, one a column */
    step->kind = span_is(node->operator, "Mul") ? MULTIPLY : ADD;
    Outcome outcome = column_floats(b, name_of(b, node, 1), b->width, enters, &step->values);
    if (outcome == LOADED && span_is(node->operator, "Sub"))
        for (int k = 0; k < b->width; k++) step->values[k] = -step->values[k];
    return outcome;
}

/* The next operator of the chain. */
static Outcome add_step(Builder *b) {
    static const struct {
        const char *operator;
        char letter;
    } KINDS[] = {{"Clip", 'C'}, {"Mul", 'M'},  {"Add", 'A'},    {"Sub", 'S'}, {"Exp", 'E'},
                 {"Relu", 'R'}, {"Gemm", 'G'}, {"MatMul", 'X'}, {"QuantizeLinear", '8'}};
    const OnnxNode *node = &b->model->nodes.at[b->node];
    size_t kind = 0;
    while (kind < sizeof KINDS / sizeof *KINDS && !span_is(node->operator, KINDS[kind].operator)) kind++;
    if (kind == sizeof KINDS / sizeof *KINDS || node->attributes || node->outputs != 1 ||
        node->inputs == 0 || !same_span(name_of(b, node, 0), b->value))
        return NO_CHAIN;
    Decoder *decoder = b->decoder;
    char letter = KINDS[kind].letter;
    b->kinds[b->letters++] = letter;
    Step *step = &decoder->steps[decoder->count];
    if (letter == 'R') {
        if (node->inputs != 1 || b->letters < 2 || !strchr("GX8", b->kinds[b->letters - 2])) return NO_CHAIN;
        step[-1].relu = true;
    } else {
        *step = (Step){.inputs = b->width, .outputs = b->width};
        decoder->count++;
        Outcome outcome = letter == '8'                    ? add_int8_product(b, step, node)
                          : letter == 'G' || letter == 'X' ? add_product(b, step, node)
                                                           : add_elementwise(b, step, node);
        if (outcome != LOADED) return outcome;
        b->width = step->outputs;
        if (b->width > decoder->widest) decoder->widest = b->width;
    }
    node = &b->model->nodes.at[b->node++];
    b->value = name_of(b, node, node->inputs);
    b->used++;
    return LOADED;
}

/* Whether the chain is one of the decoder profile (section 6.4): the letters of its steps, and the
 * numbers of the last Clip and of Sub, which are fixed. */
static bool is_in_profile(const Builder *b) {
    const char *at = b->kinds;
    if (*at++ != 'C') return false;
    if (*at == 'G') {
        while (at[0] == 'G' && at[1] == 'R') at += 2;
        if (*at++ != 'G') return false;
    } else {
        if (*at++ != 'M' || *at++ != 'A' || *at != '8') return false;
        while (*at == '8') at++;
    }
    if (strcmp(at, "CESM") && strcmp(at, "CESX")) return false;
    const Step *clip = &b->decoder->steps[b->decoder->count - 4], *subtract = clip + 2;
    return b->plain && clip->low == 0 && subtract->values[0] == -1;
}

static Outcome build_decoder(Builder *b) {
    Decoder *decoder = b->decoder;
    size_t nodes = b->model->nodes.count;
    decoder->columns = decoder->widest = b->width;
    decoder->steps = calloc(nodes, sizeof *decoder->steps);
    if (!decoder->steps) return DOES_NOT_FIT;
    while ((b->node = next_in_chain(b, b->node)) < nodes) {
        Outcome outcome = add_step(b);
        if (outcome != LOADED) return outcome;
    }
    if (!same_span(b->value, TRANSPORT) || b->used != nodes) return NO_CHAIN;
    decoder->in_profile = is_in_profile(b);
    return b->width == 6 ? LOADED : DOES_NOT_FIT;
}

/* Rows filled with 0, +-1, +-1e4 and about +-3.4e38, and random ones, give finite results that are
 * not negative. */
static bool check_results(const Decoder *decoder, const char *entry, RnaReport *report) {
    static const float PROBES[] = {0, 1, -1, 1e4f, -1e4f, FLT_MAX, -3.4e38f};
    enum { PROBE_COUNT = sizeof PROBES / sizeof *PROBES };
    size_t size = sizeof(float) * ROWS * (size_t)rounded_up(decoder->widest, OUTPUTS);
    float *a = aligned(size), *b = aligned(size);
    bool good = a && b;
    uint32_t random = 1;
    for (int k = 0; good && k < decoder->columns; k++)
        for (int r = 0; r < ROWS; r++) {
            random = random * 1664525u + 1013904223u;
            a[k * ROWS + r] = r < PROBE_COUNT ? PROBES[r] : (float)random * 0x1p-31f - 1; /* -1 to 1 */
        }
    const float *transport = good ? run_decoder(decoder, a, b) : NULL;
    for (int i = 0; good && i < 6 * ROWS; i++) good = transport[i] >= 0 && transport[i] <= FLT_MAX;
    free(a);
    free(b);
    return good || refuse(report, "DECODER_RESULT", entry, "finite and >= 0 for any finite input", "others");
}

/* Whether an int8 matrix has weights, in rows 2k and 2k + 1, that add up to more than 128. */
static bool saturates(const OnnxModel *model) {
    for (size_t i = 0; i < model->initializers; i++) {
        const OnnxTensor *tensor = &model->tensors.at[i];
        size_t inputs = (size_t)tensor->dims[0], outputs = (size_t)tensor->dims[1];
        if (tensor->type != ONNX_INT8 || tensor->rank != 2 || !tensor->has_raw) continue;
        if (!has_bytes(tensor, 1)) continue;
        const int8_t *w = (const int8_t *)tensor->raw.at;
        for (size_t k = 0; k < inputs; k += 2)
            for (size_t j = 0; j < outputs; j++) {
                int x = w[k * outputs + j], y = k + 1 < inputs ? w[(k + 1) * outputs + j] : 0;
                if ((x >= 0) == (y >= 0) && abs(x + y) > 128) return true;
            }
    }
    return false;
}

/* Checks a decoder, and loads it where it is a chain. */
static void read_decoder(Span data, int columns, bool is_int8, Decoder *decoder, const char *entry,
                         RnaReport *report) {
    OnnxModel model = {0};
    ValueTable values = {0};
    Builder *builder = calloc(1, sizeof *builder);
    if (!builder) refuse(report, "DECODER_LOAD", entry, "memory for it", "not enough");
    if (builder && check_onnx(data, columns, is_int8, &model, &values, entry, report)) {
        *builder = (Builder){&model, &values, decoder, .value = QUERIES, .width = columns, .plain = true};
        Outcome outcome = build_decoder(builder);
        if (outcome == DOES_NOT_FIT)
            refuse(report, "DECODER_LOAD", entry, "constants that fit each other", "others");
        if (outcome == LOADED) decoder->runs = check_results(decoder, entry, report);
        if (outcome != DOES_NOT_FIT && !decoder->in_profile)
            warn(report, "DECODER_PROFILE", entry, "the decoder profile", "other operators");
        if (outcome != DOES_NOT_FIT && saturates(&model))
            warn(report, "DECODER_SATURATION", entry, "pairs of weights up to 128", "larger ones");
    }
    free(builder);
    free(values.at);
    free_onnx(&model);
}

/* --------------------------------------------------------------- 11 Queries */

/* ROWS points.  Directions and places are computed in float64: 1 - n.m inside a highlight, wi near
 * -wo and wi along a fiber would otherwise cancel what float32 has of them. */
typedef struct Points {
    double p[3][ROWS]; /* position in the bounds, 0 to 1 */
    double axis[3][ROWS], wo[3][ROWS], wi[3][ROWS], h[ROWS];
    bool valid[ROWS];
} Points;

typedef struct Tier {
    RnaTier public;
    Planes planes;
    Decoder decoder;
    int column[BLOCKS]; /* the first of each block, -1 where the tier has none */
} Tier;

struct RnaAsset {
    Span file;
    bool mapped;
    RnaKind kind;
    float low[3], high[3]; /* the bounds, rounded as section 3 asks; GCC 12 at -O3 may leave out the
                              rounding where it is a cast to float and back */
    RnaMesh mesh;
    RnaCurves curves;
    JsonText manifest; /* what the names live on */
    int tiers;
    Tier tier[MAX_TIERS];
};

/* Rows of an evaluation. */
typedef struct Batch {
    size_t n;
    const float *positions, *axes, *h, *wo, *wi;
} Batch;

static double limited(double x, double low, double high) {
    x = x > low ? x : low; /* low for NaN */
    return x < high ? x : high;
}

/* Brings the vectors to unit length; adds to `total` what is NaN or infinite where one is not finite
 * or has no length. */
static void normalize(double v[restrict 3][ROWS], double *restrict total) {
    for (int r = 0; r < ROWS; r++) {
        double scale = 1 / sqrt(v[0][r] * v[0][r] + v[1][r] * v[1][r] + v[2][r] * v[2][r]);
        v[0][r] *= scale;
        v[1][r] *= scale;
        v[2][r] *= scale;
        total[r] += v[0][r] + v[1][r] + v[2][r];
    }
}

/* `count` points from row `first` on; rows behind them repeat the last. */
static void load_points(const RnaAsset *asset, const Batch *batch, size_t first, int count, Points *points) {
    double total[ROWS];
    for (int r = 0; r < ROWS; r++) {
        size_t i = first + (size_t)(r < count ? r : count - 1);
        for (size_t k = 0; k < 3; k++) {
            points->p[k][r] = batch->positions[3 * i + k];
            points->axis[k][r] = batch->axes[3 * i + k];
            points->wo[k][r] = batch->wo[3 * i + k];
            points->wi[k][r] = batch->wi[3 * i + k];
        }
        points->h[r] = asset->kind == RNA_FIBER ? batch->h[i] : 0;
        total[r] = points->p[0][r] + points->p[1][r] + points->p[2][r] + points->h[r];
        points->h[r] = limited(points->h[r], -1, 1);
    }
    normalize(points->axis, total);
    normalize(points->wo, total);
    normalize(points->wi, total);
    for (int r = 0; r < ROWS; r++) points->valid[r] = total[r] - total[r] == 0;
    for (int k = 0; k < 3; k++) {
        double low = asset->low[k], scale = 1 / ((double)asset->high[k] - low);
        for (int r = 0; r < ROWS; r++) {
            points->p[k][r] = limited((points->p[k][r] - low) * scale, 0, 1);
            points->axis[k][r] = points->valid[r] ? points->axis[k][r] : k == 0;
            points->wo[k][r] = points->valid[r] ? points->wo[k][r] : k == 1;
            points->wi[k][r] = points->valid[r] ? points->wi[k][r] : k == 2;
        }
    }
}

static float from_bits(uint32_t bits) {
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* binary16 to binary32 without branches, nor help of the processor. */
static float half_value(uint16_t half) {
    uint32_t bits = (uint32_t)(half & 0x7fff) << 13, subnormal = bits < 1u << 23;
    float excess = from_bits(subnormal * 0x38800000u); /* 2^-14 */
    float value = from_bits(bits + ((112u + subnormal) << 23)) - excess;
    memcpy(&bits, &value, sizeof bits);
    return from_bits(bits | (uint32_t)(half & 0x8000) << 16);
}

/* The four texels around a point in one plane, and their weights. */
typedef struct Footprint {
    size_t texel[4]; /* places in the flat planes */
    float weight[4];
} Footprint;

enum { CHANNELS_AT_ONCE = 8 };

/* Adds scale * the weighted texels, `count` channels from `channel` on. */
#define DEFINE_ADD_TEXELS(name, type, VALUE, SCALE)                                              \
    static inline void name(const Planes *planes, const Footprint *print, const float *scales, \
                            int channel, int count, float *sums) {                             \
        const type *texels = (const type *)planes->texels + channel;                           \
        for (int c = 0; c < count; c++) {                                                      \
            float part = 0;                                                                    \
            for (int i = 0; i < 4; i++)                                                        \
                part = MULTIPLY_ADD(VALUE(texels[print->texel[i] + (size_t)c]), print->weight[i], part); \
            sums[c] += part * SCALE(scales[channel + c]);                                      \
        }                                                                                      \
    }

#define AS_IT_IS(x) (x)
#define ONE(x) ((void)scales, 1.0f)
DEFINE_ADD_TEXELS(add_int8_texels, int8_t, (float), AS_IT_IS)
DEFINE_ADD_TEXELS(add_half_texels, uint16_t, half_value, ONE)
DEFINE_ADD_TEXELS(add_float_texels, float, AS_IT_IS, ONE)

static inline void add_texels(const Planes *planes, const Footprint *print, int plane, int channel,
                              int count, float *sums) {
    const float *scales = planes->scales ? planes->scales + plane * planes->channels : NULL;
    switch (planes->precision) {
    case INT8: add_int8_texels(planes, print, scales, channel, count, sums); break;
    case FLOAT16: add_half_texels(planes, print, scales, channel, count, sums); break;
    case FLOAT32: add_float_texels(planes, print, scales, channel, count, sums); break;
    }
}

/* Where p falls along an axis of `size` texels: the texel before it, the step to the next, the part. */
typedef struct Cell {
    size_t index, step;
    float part;
} Cell;

static Cell cell_of(double p, int size) {
    double t = limited(p * size - 0.5, 0, size - 1.0);
    int index = (int)t;
    return (Cell){(size_t)index, index < size - 1, (float)(t - index)};
}

static size_t texel_bytes(const Planes *planes) {
    return planes->precision == INT8 ? 1 : planes->precision == FLOAT16 ? 2 : 4;
}

/* The footprints of a point in the three planes; asks for their memory. */
static void find_footprints(const Planes *planes, const Points *points, int r, Footprint prints[3]) {
    const size_t size = (size_t)planes->resolution, channels = (size_t)planes->channels;
    Cell cells[3];
    for (int k = 0; k < 3; k++) cells[k] = cell_of(points->p[k][r], planes->resolution);
    for (size_t plane = 0; plane < 3; plane++) { /* XY, YZ, ZX: u along rows, v across */
        Cell u = cells[plane], v = cells[(plane + 1) % 3];
        size_t start = ((plane * size + v.index) * size + u.index) * channels;
        size_t right = u.step * channels, up = v.step * size * channels;
        prints[plane] = (Footprint){{start, start + right, start + up, start + up + right},
                                    {(1 - v.part) * (1 - u.part), (1 - v.part) * u.part,
                                     v.part * (1 - u.part), v.part * u.part}};
        for (int i = 0; i < 4; i++)
            PREFETCH((const char *)planes->texels + prints[plane].texel[i] * texel_bytes(planes));
    }
}

/* The features at the points, summed over the three planes: [channels][ROWS] (section 5). */
static void gather_features(const Planes *planes, const Points *points, float *features) {
    Footprint prints[ROWS][3];
    for (int r = 0; r < ROWS; r++) find_footprints(planes, points, r, prints[r]);
    for (int r = 0; r < ROWS; r++)
        for (int c = 0; c < planes->channels; c += CHANNELS_AT_ONCE) {
            float sums[CHANNELS_AT_ONCE] = {0};
            int count = planes->channels - c;
            for (int plane = 0; plane < 3; plane++)
                if (count >= CHANNELS_AT_ONCE) /* a constant, for the compiler */
                    add_texels(planes, &prints[r][plane], plane, c, CHANNELS_AT_ONCE, sums);
                else
                    add_texels(planes, &prints[r][plane], plane, c, count, sums);
            for (int i = 0; i < count && i < CHANNELS_AT_ONCE; i++) features[(c + i) * ROWS + r] = sums[i];
        }
}

/* log2 of a positive normal number to some 1e-7: x = 2^e m with m within sqrt(2) of 1, and
 * log2 m = 2 / ln 2 (s + s^3 / 3 + s^5 / 5 + ...) with s = (m - 1) / (m + 1). */
static float log2_of(float x) {
    int32_t bits, e;
    memcpy(&bits, &x, sizeof bits);
    e = (bits - 0x3f3504f3) >> 23;
    bits -= (int32_t)((uint32_t)e << 23);
    float m;
    memcpy(&m, &bits, sizeof m);
    float s = (m - 1) / (m + 1), q = s * s;
    float series = MULTIPLY_ADD(q, 1.0f / 9, 1.0f / 7);
    series = MULTIPLY_ADD(q, series, 1.0f / 5);
    series = MULTIPLY_ADD(q, series, 1.0f / 3);
    series = MULTIPLY_ADD(q, series, 1.0f);
    return MULTIPLY_ADD(2.88539008f * s, series, (float)e);
}

static void put_vectors(double v[3][ROWS], float *out) {
    for (int k = 0; k < 3; k++)
        for (int r = 0; r < ROWS; r++) out[k * ROWS + r] = (float)v[k][r];
}

#define DOT(a, b, r) ((a)[0][r] * (b)[0][r] + (a)[1][r] * (b)[1][r] + (a)[2][r] * (b)[2][r])

static float log_gap(double cosine) {
    return log2_of((float)(1 - (cosine < 1 ? cosine : 1) + 1e-4)) * (1.0f / 6);
}

/* m: halfway of wi and wo, or `n` where they are opposite. */
static void find_halfway(const Points *points, double n[3][ROWS], double m[3][ROWS]) {
    for (int r = 0; r < ROWS; r++) {
        double x = points->wi[0][r] + points->wo[0][r], y = points->wi[1][r] + points->wo[1][r];
        double z = points->wi[2][r] + points->wo[2][r], square = x * x + y * y + z * z;
        double scale = square < 1e-12 ? 0 : 1 / sqrt(square), rest = square < 1e-12;
        m[0][r] = x * scale + rest * n[0][r];
        m[1][r] = y * scale + rest * n[1][r];
        m[2][r] = z * scale + rest * n[2][r];
    }
}

/* q: the unit vector along n + 0.1 f, f the first three features. */
static void find_learned_normal(const Points *points, const float *features, int channels,
                                double q[3][ROWS]) {
    double none[ROWS] = {0};
    for (int k = 0; k < 3; k++)
        for (int r = 0; r < ROWS; r++)
            q[k][r] = points->axis[k][r] + 0.1 * (k < channels ? features[k * ROWS + r] : none[r]);
    for (int r = 0; r < ROWS; r++) {
        double square = DOT(q, q, r), scale = square < 1e-12 ? 0 : 1 / sqrt(square), rest = square < 1e-12;
        for (int k = 0; k < 3; k++) q[k][r] = q[k][r] * scale + rest * points->axis[k][r];
    }
}

static void surface_blocks(const Tier *tier, Points *points, const float *features, float *queries) {
    double m[3][ROWS], q[3][ROWS];
    float *half_vector = queries + tier->column[HALF_VECTOR] * ROWS;
    float *highlight = queries + tier->column[HIGHLIGHT] * ROWS;
    float *learned_normal = queries + tier->column[LEARNED_NORMAL] * ROWS;
    find_halfway(points, points->axis, m);
    if (tier->column[HALF_VECTOR] >= 0)
        for (int r = 0; r < ROWS; r++) {
            double n_m = DOT(points->axis, m, r);
            half_vector[r] = (float)n_m;
            half_vector[ROWS + r] = log_gap(n_m);
            half_vector[2 * ROWS + r] = (float)DOT(points->axis, points->wi, r);
            half_vector[3 * ROWS + r] = (float)DOT(points->axis, points->wo, r);
            half_vector[4 * ROWS + r] = (float)DOT(points->wi, m, r);
        }
    if (tier->column[HIGHLIGHT] >= 0)
        for (int r = 0; r < ROWS; r++) {
            double x = points->axis[1][r] * m[2][r] - points->axis[2][r] * m[1][r];
            double y = points->axis[2][r] * m[0][r] - points->axis[0][r] * m[2][r];
            double z = points->axis[0][r] * m[1][r] - points->axis[1][r] * m[0][r];
            highlight[r] = log2_of((float)(x * x + y * y + z * z + 1e-8)) * (1.0f / 12);
        }
    if (tier->column[LEARNED_NORMAL] >= 0) {
        find_learned_normal(points, features, tier->planes.channels, q);
        find_halfway(points, q, m);
        for (int r = 0; r < ROWS; r++) {
            double q_m = DOT(q, m, r);
            learned_normal[r] = (float)q_m;
            learned_normal[ROWS + r] = log_gap(q_m);
        }
    }
}

/* Of one point of a fiber: the two blocks that fibers alone have. */
static inline void fiber_row(const Points *points, int r, double angles[6], double lobes[3]) {
    const double tx = points->axis[0][r], ty = points->axis[1][r], tz = points->axis[2][r];
    const double ox = points->wo[0][r], oy = points->wo[1][r], oz = points->wo[2][r];
    const double ix = points->wi[0][r], iy = points->wi[1][r], iz = points->wi[2][r], h = points->h[r];
    double s_o = tx * ox + ty * oy + tz * oz, s_i = tx * ix + ty * iy + tz * iz;
    /* t x wo and t x wi: the directions seen along the fiber, of lengths c_o and c_i. */
    double ax = ty * oz - tz * oy, ay = tz * ox - tx * oz, az = tx * oy - ty * ox;
    double bx = ty * iz - tz * iy, by = tz * ix - tx * iz, bz = tx * iy - ty * ix;
    double square = ax * ax + ay * ay + az * az;
    double d = sqrt(square * (bx * bx + by * by + bz * bz));
    double triple = tx * (oy * iz - oz * iy) + ty * (oz * ix - ox * iz) + tz * (ox * iy - oy * ix);
    bool along = d < 1e-6;
    double safe = along ? 1 : d;
    double cos_phi = along ? 1 : limited((ax * bx + ay * by + az * bz) / safe, -1, 1);
    double sin_phi = along ? 0 : limited(triple / safe, -1, 1);
    angles[0] = s_i;
    angles[1] = s_o;
    angles[2] = s_i + s_o;
    angles[4] = cos_phi;
    angles[5] = sin_phi;
    /* Phi_0 = 2 g_o; each inner segment turns by -2 g_t - pi.  As cosine and sine. */
    double sin_t = h * sqrt(square / (1.55 * 1.55 - s_o * s_o));
    double c = 1 - 2 * h * h, s = 2 * h * sqrt(1 - h * h);
    double turn_c = 2 * sin_t * sin_t - 1, turn_s = 2 * sin_t * sqrt(1 - sin_t * sin_t);
    for (int p = 0; p < 3; p++) {
        lobes[p] = cos_phi * c + sin_phi * s;
        double turned = c * turn_c - s * turn_s;
        s = c * turn_s + s * turn_c;
        c = turned;
    }
}

static void fiber_blocks(const Tier *tier, const Points *points, float *queries) {
    float *at_angles = queries + tier->column[FIBER_ANGLES] * ROWS;
    float *at_lobes = queries + tier->column[FIBER_LOBES] * ROWS;
    float values[9][ROWS];
    for (int r = 0; r < ROWS; r++) {
        double angles[6] = {0}, lobes[3];
        fiber_row(points, r, angles, lobes);
        for (int k = 0; k < 6; k++) values[k][r] = (float)angles[k];
        for (int k = 0; k < 3; k++) values[6 + k][r] = (float)lobes[k];
        values[3][r] = log2_of((float)(angles[2] * angles[2] + 1e-3)) * (1.0f / 6);
    }
    if (tier->column[FIBER_ANGLES] >= 0) memcpy(at_angles, values, 6 * sizeof values[0]);
    if (tier->column[FIBER_LOBES] >= 0) memcpy(at_lobes, values + 6, 3 * sizeof values[0]);
}

/* Fills [columns][ROWS]. */
static void fill_queries(const RnaAsset *asset, const Tier *tier, Points *points, float *queries) {
    const int *column = tier->column;
    float aside[MAX_CHANNELS * ROWS];
    float *features = column[FEATURES] >= 0 ? queries + column[FEATURES] * ROWS : aside;
    int at_axis = asset->kind == RNA_FIBER ? column[TANGENT] : column[NORMAL];
    if (column[FEATURES] >= 0 || column[LEARNED_NORMAL] >= 0)
        gather_features(&tier->planes, points, features);
    if (column[POSITION] >= 0)
        for (int k = 0; k < 3; k++)
            for (int r = 0; r < ROWS; r++)
                queries[(column[POSITION] + k) * ROWS + r] = (float)(2 * points->p[k][r] - 1);
    if (at_axis >= 0) put_vectors(points->axis, queries + at_axis * ROWS);
    if (column[WO] >= 0) put_vectors(points->wo, queries + column[WO] * ROWS);
    if (column[WI] >= 0) put_vectors(points->wi, queries + column[WI] * ROWS);
    if (column[H] >= 0)
        for (int r = 0; r < ROWS; r++) queries[column[H] * ROWS + r] = (float)points->h[r];
    if (asset->kind == RNA_FIBER && (column[FIBER_ANGLES] >= 0 || column[FIBER_LOBES] >= 0))
        fiber_blocks(tier, points, queries);
    if (asset->kind == RNA_SURFACE) surface_blocks(tier, points, features, queries);
}

/* --------------------------------------------------------- 12 The interface */

static int place_blocks(Tier *tier, const Json *inputs) {
    int width = 0;
    for (int block = 0; block < BLOCKS; block++) tier->column[block] = -1;
    for (const Json *name = inputs->first; name; name = name->next) {
        int block = block_of(name->string);
        tier->column[block] = width;
        width += BLOCK_TABLE[block].width ? BLOCK_TABLE[block].width : tier->planes.channels;
    }
    return width;
}

static double measured(const Json *tier, const char *object, const char *name) {
    const Json *value = member(member(tier, object), name);
    return value ? value->number : -1;
}

static void read_tier(Container *zip, const Json *record, Tier *tier, RnaReport *report) {
    const Json *precision = member(record, "planePrecision");
    Span planes = member(record, "planes")->string, decoder = member(record, "decoder")->string;
    tier->public.name = (const char *)member(record, "name")->string.at;
    tier->public.is_int8 = is_string(member(record, "decoderPrecision"), "int8");
    tier->public.multiply_adds = measured(record, "cost", "multiplyAdds");
    tier->public.flip = measured(record, "validation", "flip");
    tier->planes.resolution = (int)member(record, "resolution")->number;
    tier->planes.channels = (int)member(record, "channels")->number;
    tier->planes.precision = is_string(precision, "int8")      ? INT8
                             : is_string(precision, "float16") ? FLOAT16
                                                               : FLOAT32;
    int columns = place_blocks(tier, member(record, "inputs"));
    const Entry *entry = find_entry(zip, planes);
    if (entry && entry->intact) read_planes(entry_data(zip, entry), &tier->planes, entry->name, report);
    entry = find_entry(zip, decoder);
    if (entry && entry->intact)
        read_decoder(entry_data(zip, entry), columns, tier->public.is_int8, &tier->decoder, entry->name,
                     report);
    tier->public.runs = tier->decoder.runs;
}

static void warn_outside(const RnaAsset *asset, const float low[3], const float high[3], RnaReport *report) {
    for (int k = 0; k < 3; k++) {
        double slack = 1e-4 * ((double)asset->high[k] - asset->low[k]);
        if (low[k] >= asset->low[k] - slack && high[k] <= asset->high[k] + slack) continue;
        warn(report, "GEOMETRY_OUTSIDE", "/bounds", "geometry inside", "%g to %g along %c", low[k], high[k],
             "xyz"[k]);
        return;
    }
}

static void read_geometry(Container *zip, const Json *root, RnaAsset *asset, RnaReport *report) {
    const Json *bounds = member(root, "bounds");
    const Json *low = member(bounds, "min")->first, *high = member(bounds, "max")->first;
    for (int k = 0; k < 3; k++, low = low->next, high = high->next) {
        asset->low[k] = (float)low->number;
        asset->high[k] = (float)high->number;
    }
    const Entry *entry = find_entry(zip, member(root, "geometry")->string);
    if (!entry || !entry->intact) return;
    float corner[2][3];
    if (asset->kind == RNA_SURFACE) {
        if (!read_mesh(entry_data(zip, entry), &asset->mesh, entry->name, report)) return;
        box_around(asset->mesh.positions, NULL, asset->mesh.vertex_count, corner[0], corner[1]);
    } else {
        if (!read_curves(entry_data(zip, entry), &asset->curves, entry->name, report)) return;
        box_around(asset->curves.points, asset->curves.radii, asset->curves.point_count, corner[0],
                   corner[1]);
    }
    warn_outside(asset, corner[0], corner[1], report);
}

static void read_package(Container *zip, RnaAsset *asset, RnaReport *report) {
    if (!read_container(zip, report) || !check_crc(zip, &zip->entries[0], report)) return;
    const Json *root = read_manifest(entry_data(zip, &zip->entries[0]), &asset->manifest, report);
    if (!root) return;
    asset->kind = is_string(member(root, "kind"), "fiber") ? RNA_FIBER : RNA_SURFACE;
    check_entries(zip, root, report);
    read_geometry(zip, root, asset, report);
    for (const Json *tier = member(root, "tiers")->first; tier; tier = tier->next)
        read_tier(zip, tier, &asset->tier[asset->tiers++], report);
}

static RnaAsset *open_span(Span file, bool mapped, RnaReport *report) {
    RnaAsset *asset = calloc(1, sizeof *asset);
    Container *zip = calloc(1, sizeof *zip);
    if (asset && zip) {
        asset->file = zip->file = file;
        asset->mapped = mapped;
        read_package(zip, asset, report);
    } else {
        refuse(report, "FILE_UNREADABLE", "byte 0", "memory for it", "not enough");
        if (mapped) munmap((void *)(uintptr_t)file.at, file.size);
    }
    free(zip);
    if (report->errors == 0) return asset;
    rna_close(asset);
    return NULL;
}

RnaAsset *rna_open_memory(const void *data, size_t size, RnaReport *report) {
    memset(report, 0, sizeof *report);
    if ((uintptr_t)data % ALIGNMENT == 0) return open_span((Span){data, size}, false, report);
    refuse(report, "FILE_UNREADABLE", "byte 0", "an address that is a multiple of 64", "%p", data);
    return NULL;
}

RnaAsset *rna_open(const char *path, RnaReport *report) {
    memset(report, 0, sizeof *report);
    struct stat status;
    int file = open(path, O_RDONLY);
    bool good = file >= 0 && fstat(file, &status) == 0 && S_ISREG(status.st_mode);
    size_t size = good ? (size_t)status.st_size : 0;
    void *data = NULL;
    if (good && size > 0 && size < UINT32_MAX) {
        data = mmap(NULL, size, PROT_READ, MAP_PRIVATE, file, 0);
        good = data != MAP_FAILED;
    }
    if (file >= 0) close(file);
    if (good) return open_span((Span){data, size}, data != NULL, report);
    refuse(report, "FILE_UNREADABLE", "byte 0", "a readable file", "%s", path);
    return NULL;
}

void rna_close(RnaAsset *asset) {
    if (!asset) return;
    for (int i = 0; i < asset->tiers; i++) free_decoder(&asset->tier[i].decoder);
    free_json(&asset->manifest);
    if (asset->mapped) munmap((void *)(uintptr_t)asset->file.at, asset->file.size);
    free(asset);
}

RnaKind rna_kind(const RnaAsset *asset) { return asset->kind; }

void rna_bounds(const RnaAsset *asset, float low[3], float high[3]) {
    memcpy(low, asset->low, sizeof asset->low);
    memcpy(high, asset->high, sizeof asset->high);
}

const RnaMesh *rna_mesh(const RnaAsset *asset) {
    return asset->kind == RNA_SURFACE ? &asset->mesh : NULL;
}

const RnaCurves *rna_curves(const RnaAsset *asset) {
    return asset->kind == RNA_FIBER ? &asset->curves : NULL;
}

int rna_tier_count(const RnaAsset *asset) { return asset->tiers; }

int rna_tier_index(const RnaAsset *asset, const char *name) {
    for (int i = 0; i < asset->tiers; i++)
        if (strcmp(asset->tier[i].public.name, name) == 0) return i;
    return -1;
}

const RnaTier *rna_tier(const RnaAsset *asset, int tier) {
    return tier >= 0 && tier < asset->tiers ? &asset->tier[tier].public : NULL;
}

static float light(float value, bool valid) {
    return valid && value > 0 ? (value < FLT_MAX ? value : FLT_MAX) : 0; /* 0 for NaN */
}

RnaStatus rna_evaluate(const RnaAsset *asset, int tier_index, size_t n, const float *positions,
                       const float *axes, const float *h, const float *wo, const float *wi,
                       float *visible, float *shadowed) {
    if (!asset || !rna_tier(asset, tier_index)) return RNA_BAD_ARGUMENT;
    const Tier *tier = &asset->tier[tier_index];
    if (!tier->decoder.runs) return RNA_UNSUPPORTED_DECODER;
    if (n == 0) return RNA_OK;
    if (!positions || !axes || !wo || !wi || !visible || !shadowed || (asset->kind == RNA_FIBER && !h))
        return RNA_BAD_ARGUMENT;
    size_t size = sizeof(float) * ROWS * (size_t)rounded_up(tier->decoder.widest, OUTPUTS);
    size = (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    float *buffers = aligned(2 * size);
    if (!buffers) return RNA_OUT_OF_MEMORY;
    const Batch batch = {n, positions, axes, h, wo, wi};
    Points points;
    for (size_t first = 0; first < n; first += ROWS) {
        int count = (int)(n - first < ROWS ? n - first : ROWS);
        load_points(asset, &batch, first, count, &points);
        fill_queries(asset, tier, &points, buffers);
        const float *transport = run_decoder(&tier->decoder, buffers, buffers + size / sizeof(float));
        for (size_t r = 0; r < (size_t)count; r++)
            for (size_t k = 0; k < 3; k++) {
                visible[3 * (first + r) + k] = light(transport[k * ROWS + r], points.valid[r]);
                shadowed[3 * (first + r) + k] = light(transport[(k + 3) * ROWS + r], points.valid[r]);
            }
    }
    free(buffers);
    return RNA_OK;
}

const char *rna_status_text(RnaStatus status) {
    switch (status) {
    case RNA_OK: return "done";
    case RNA_BAD_ARGUMENT: return "an array is missing, or the tier does not exist";
    case RNA_UNSUPPORTED_DECODER: return "the decoder is no chain of the decoder profile: it needs an ONNX engine";
    default: return "out of memory";
    }
}
