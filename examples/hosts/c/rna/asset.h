/* What a package becomes. */
#ifndef RNA_ASSET_H
#define RNA_ASSET_H

#include "decoder.h"
#include "manifest_rules.h"
#include "planes.h"

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

#endif
