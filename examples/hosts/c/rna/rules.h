/* Tables of the members that an object may have, and the check of an object against one. */
#ifndef RNA_RULES_H
#define RNA_RULES_H

#include "json.h"

/* The values that a member may have. */
typedef enum RuleKind {
    END,
    ANYTHING,
    TEXT,    /* of `low` characters at least */
    NAME,    /* of a tier or an extension */
    PATH,    /* of an entry */
    SHA256,
    NUMBER,  /* from `low` to `high` */
    INTEGER, /* the same, of whole value */
    CHOICE,  /* one of the words in `choices` */
    BOOLEAN,
    OBJECT, /* with the members in `of` */
    MAP,    /* an object with any members like `of`, whose keys are like `key` */
    LIST,   /* from `low` to `high` items like `of` */
    REGION  /* of directions: a word, or a list of cones */
} RuleKind;

/* OPTION: a member that is there if the schema has its `option`, and else is unknown. */
enum { REQUIRED = 1, NULLABLE = 2, OPTION = 4 };

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
    bool option;
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
    return push_place(schema, text_span(name));
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

static bool is_text_like(RuleKind kind, const Rule *rule, Span text) {
    switch (kind) {
    case TEXT: return (double)characters(text) >= rule->low;
    case NAME: return is_name(text);
    case PATH: return is_path(text);
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
        [SHA256] = "64 lower-case hexadecimal digits",
        [NUMBER] = "a number in its range",
        [INTEGER] = "an integer in its range",
        [BOOLEAN] = "true or false",
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
        if (rule->kind && (schema->option || !(rule->flags & OPTION)))
            check_rule(schema, rule, m);
        else
            break_rule(schema, schema->unknown, "no such member", "%.*s", (int)m->key.size,
                       (const char *)m->key.at);
        pop_place(schema, before);
    }
    for (const Rule *rule = rules; rule->kind; rule++) {
        if (!(rule->flags & REQUIRED) || member(object, rule->name)) continue;
        if (rule->flags & OPTION && !schema->option) continue;
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
    case BOOLEAN: return value->type == JSON_FALSE || value->type == JSON_TRUE;
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

#define ANY_NUMBER -HUGE_VAL, HUGE_VAL
#define ANY_COUNT 0, HUGE_VAL

static const Rule COORDINATE = {"", NUMBER, 0, ANY_NUMBER};

#endif
