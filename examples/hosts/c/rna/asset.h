/* A loaded package. */
#ifndef RNA_ASSET_H
#define RNA_ASSET_H

#include "base_color.h"
#include "container.h"
#include "decoder.h"
#include "manifest_rules.h"
#include "planes.h"

typedef struct Part {
    RnaPart public;
    RnaMesh mesh;
    RnaCurves curves;
    RnaTransmittance records[MAX_RECORDS];
    RnaNormalMap maps[MAX_RECORDS];
    RnaBaseColor colors[MAX_RECORDS];
    Pyramid *images[MAX_RECORDS]; /* of the records of base colour; NULL until the host sets them */
    Span geometry;     /* the entry; empty where it could not be read */
    void *restored;    /* what is allocated for quantised geometry, or NULL */
} Part;

/* A decoder, which tiers and parts may share. */
typedef struct Loaded {
    struct Loaded *next;
    Span entry;
    int columns;
    bool is_int8;
    int outputs;
    const char *output;
    Decoder decoder;
} Loaded;

/* A decoder and the places of its input blocks. */
typedef struct Network {
    const Decoder *decoder; /* NULL: none */
    int column[BLOCKS];     /* the first of each block, -1 where it has none */
} Network;

typedef struct TierPart {
    Planes planes;
    Span planes_entry;
    bool uses_base_color;
    bool counts_nearby;
    double nearby_lengths[3];
    float nearby_means[2][3]; /* of visible and of shadowed light */
    Network transport; /* of visible light alone where there is one of shadowed light */
    Network shadowed, emission;
} TierPart;

typedef struct Tier {
    RnaTier public;
    const Json *validation; /* NULL: not recorded */
    TierPart part[RNA_MAX_PARTS];
} Tier;

struct RnaAsset {
    Span file;
    void *block; /* the file's bytes where rna_open has read them */
    JsonText manifest; /* what the names live on */
    const Json *domain, *extensions; /* the second NULL where there are none */
    int parts, tiers;
    Part part[RNA_MAX_PARTS];
    Tier tier[MAX_TIERS];
    Loaded *decoders;
    Container *zip;
};

#endif
