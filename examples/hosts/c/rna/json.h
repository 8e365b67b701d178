/* JSON, strict: UTF-8, no key twice, finite numbers, 64 levels (section 3). */
#ifndef RNA_JSON_H
#define RNA_JSON_H

#include "report.h"

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
    Span text;   /* the value as it is written */
    double number;
    struct Json *first, *next; /* items or members, and the next sibling */
    size_t count;
    bool marked; /* of an entry's record: a path names it */
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
    return compare_spans((*(Json *const *)a)->key, (*(Json *const *)b)->key);
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
    value->text.at = text->at;
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
    value->text.size = (size_t)(text->at - value->text.at);
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

static bool is_true(const Json *value) { return value && value->type == JSON_TRUE; }

static bool is_string(const Json *value, const char *text) {
    return value && value->type == JSON_STRING && span_is(value->string, text);
}

#endif
