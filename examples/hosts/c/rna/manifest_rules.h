/* The members of the manifest (section 3), and the blocks of a query (6.3). */
#ifndef RNA_MANIFEST_RULES_H
#define RNA_MANIFEST_RULES_H

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
    {"flipP95", NUMBER, 0, MEASURE},
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
#define DECODER_MEMBERS                                                                         \
    {"decoder", PATH, REQUIRED},                                                                \
        {"inputs", LIST, REQUIRED, 1, HUGE_VAL, &A_BLOCK, .also = blocks_are_known},            \
        {"decoderPrecision", CHOICE, REQUIRED, .choices = "float32 int8"},                      \
        {"agreement", OBJECT, NULLABLE, .of = AGREEMENT}
static const Rule DECODER[] = {DECODER_MEMBERS, {0}}; /* of shadowed light, or of emission */
static const Rule SHARE = {"", NUMBER, 0, 0, 1};
static const Rule A_LENGTH = {"", NUMBER, 0, 1e-18, 1e18};
static void lengths_ascend(Schema *schema, const Json *lengths) {
    for (const Json *at = lengths->first; at && at->next; at = at->next)
        if (!(at->next->number > at->number)) break_rule(schema, schema->value, "lengths that ascend", "others");
}
static const Rule NEARBY[] = {{"lengths", LIST, REQUIRED, 3, 3, &A_LENGTH, .also = lengths_ascend},
                              {"visible", LIST, REQUIRED, 3, 3, &SHARE},
                              {"shadowed", LIST, REQUIRED, 3, 3, &SHARE},
                              {0}};
static const Rule TIER_PART[] = {DECODER_MEMBERS,
                                 {"planes", PATH, REQUIRED},
                                 {"resolution", INTEGER, REQUIRED, 1, 4096},
                                 {"channels", INTEGER, REQUIRED, 1, MAX_CHANNELS},
                                 {"planePrecision", CHOICE, REQUIRED, .choices = "int8 float16 float32"},
                                 {"usesBaseColor", BOOLEAN},
                                 {"nearby", OBJECT, .of = NEARBY},
                                 {"shadowed", OBJECT, .of = DECODER},
                                 {"emission", OBJECT, .of = DECODER},
                                 {0}};
static const Rule A_TIER_PART = {"", OBJECT, .of = TIER_PART};
static const Rule TIER[] = {{"name", NAME, REQUIRED},
                            {"parts", LIST, REQUIRED, ANY_COUNT, &A_TIER_PART},
                            {"validation", OBJECT, NULLABLE, .of = VALIDATION},
                            {"cost", OBJECT, NULLABLE, .of = COST},
                            {0}};
static const Rule A_TIER = {"", OBJECT, .of = TIER};
#define ABOVE_0 DBL_TRUE_MIN
static const Rule TRIANGLE = {"", INTEGER, 0, 0, HUGE_VAL};
static const Rule INDEX_OF_REFRACTION = {"", NUMBER, 0, 0.01, 100};
static void counts_triangles(Schema *schema, const Json *range) {
    if (!(range->first->next->number >= 1)) break_rule(schema, schema->value, "1 triangle at least", "0");
}
static const Rule TRANSMITTANCE[] = {
    {"triangles", LIST, REQUIRED, 2, 2, &TRIANGLE, .also = counts_triangles},
    {"texture", PATH, REQUIRED},
    {"cutoff", NUMBER, 0, ABOVE_0, 1 - DBL_EPSILON / 2},
    {"ior", LIST, 0, 2, 2, &INDEX_OF_REFRACTION},
    {0}};
static const Rule A_TRANSMITTANCE = {"", OBJECT, .of = TRANSMITTANCE};
static const Rule NORMAL_MAP[] = {
    {"triangles", LIST, REQUIRED, 2, 2, &TRIANGLE, .also = counts_triangles},
    {"texture", PATH, REQUIRED},
    {0}};
static const Rule A_NORMAL_MAP = {"", OBJECT, .of = NORMAL_MAP};
static const Rule A_WRAP = {"", CHOICE, .choices = "repeat clamp mirror"};
static const Rule BASE_COLOR[] = {
    {"triangles", LIST, REQUIRED, 2, 2, &TRIANGLE, .also = counts_triangles},
    {"image", PATH},
    {"colorSpace", CHOICE, .choices = "srgb linear"},
    {"factor", LIST, 0, 3, 3, &SHARE},
    {"wrap", LIST, 0, 2, 2, &A_WRAP},
    {"transform", LIST, 0, 6, 6, &CORNER},
    {0}};
static const Rule A_BASE_COLOR = {"", OBJECT, .of = BASE_COLOR};
static const Rule PART[] = {{"name", NAME, REQUIRED},
                            {"kind", CHOICE, REQUIRED, .choices = "surface fiber"},
                            {"bounds", OBJECT, REQUIRED, .of = BOUNDS, .also = bounds_have_an_extent},
                            {"geometry", PATH, REQUIRED},
                            {"transmittance", LIST, 0, 1, MAX_RECORDS, &A_TRANSMITTANCE},
                            {"normalMaps", LIST, 0, 1, MAX_RECORDS, &A_NORMAL_MAP},
                            {"baseColor", LIST, 0, 1, MAX_RECORDS, &A_BASE_COLOR},
                            {0}};
static const Rule A_PART = {"", OBJECT, .of = PART, .also = is_a_surface};
static const Rule RECORD[] = {{"size", INTEGER, REQUIRED, MEASURE}, {"sha256", SHA256, REQUIRED}, {0}};
static const Rule A_RECORD = {"", OBJECT, .of = RECORD};
static const Rule PROVENANCE[] = {{"source", TEXT, REQUIRED},
                                  {"tool", TEXT, REQUIRED},
                                  {"capture", MAP, .key = ANYTHING},
                                  {"training", MAP, .key = ANYTHING},
                                  {0}};
static const Rule AN_EXTENSION = {"", NAME};
static const Rule MANIFEST[] = {{"format", CHOICE, REQUIRED, .choices = "rna"},
                                {"version", CHOICE, REQUIRED, .choices = "2.0"},
                                {"generator", TEXT, REQUIRED},
                                {"name", TEXT, REQUIRED, 1},
                                {"parts", LIST, REQUIRED, 1, RNA_MAX_PARTS, &A_PART, .also = parts_are_unique},
                                {"domain", OBJECT, REQUIRED, .of = DOMAIN},
                                {"units", OBJECT, REQUIRED, .of = UNITS},
                                {"tiers", LIST, REQUIRED, 1, MAX_TIERS, &A_TIER, .also = tiers_are_unique},
                                {"entries", MAP, REQUIRED, .key = PATH, .of = &A_RECORD},
                                {"provenance", OBJECT, REQUIRED, .of = PROVENANCE},
                                {"license", TEXT, REQUIRED, 1},
                                {"extensionsUsed", LIST, 0, ANY_COUNT, &AN_EXTENSION},
                                {"extensionsRequired", LIST, 0, ANY_COUNT, &AN_EXTENSION},
                                {"extensions", MAP, .key = NAME},
                                {"extras", MAP, .key = ANYTHING},
                                {0}};

#endif
