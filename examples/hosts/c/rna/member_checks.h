/* Checks of members beyond their rules (section 3), and the blocks of a query (6.3). */
#ifndef RNA_MEMBER_CHECKS_H
#define RNA_MEMBER_CHECKS_H

#include "block_table.h"
#include "rules.h"

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

static void lengths_ascend(Schema *schema, const Json *list) {
    for (const Json *a = list->first; a->next; a = a->next)
        if (!(a->number < a->next->number)) {
            break_rule(schema, schema->value, "each length above the one before", "%g", a->next->number);
            return;
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

/* The first item whose name an item before it has; NULL where there is none. */
static const Json *repeated_name(const Json *list) {
    for (const Json *a = list->first; a; a = a->next)
        for (const Json *b = list->first; b != a; b = b->next)
            if (same_span(member(a, "name")->string, member(b, "name")->string)) return a;
    return NULL;
}

static void tiers_are_unique(Schema *schema, const Json *tiers) {
    const Json *again = repeated_name(tiers);
    if (again)
        break_rule(schema, "TIER_DUPLICATE", "each tier name once", "%s",
                   (const char *)member(again, "name")->string.at);
}

static void parts_are_unique(Schema *schema, const Json *parts) {
    const Json *again = repeated_name(parts);
    if (again)
        break_rule(schema, "PART_DUPLICATE", "each part name once", "%s",
                   (const char *)member(again, "name")->string.at);
}

static void is_a_surface(Schema *schema, const Json *part) {
    static const char *const RECORDS[] = {"transmittance", "normalMaps", "baseColor"};
    for (int i = 0; i < 3 && !is_string(member(part, "kind"), "surface"); i++) {
        if (!member(part, RECORDS[i])) continue;
        size_t before = push_text(schema, RECORDS[i]);
        break_rule(schema, schema->value, "of a surface alone", "%s of fibers", RECORDS[i]);
        pop_place(schema, before);
    }
}

static void counts_triangles(Schema *schema, const Json *range) {
    if (!(range->first->next->number >= 1)) break_rule(schema, schema->value, "1 triangle at least", "0");
}

#endif
