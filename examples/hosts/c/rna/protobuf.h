/* The protobuf wire format. */
#ifndef RNA_PROTOBUF_H
#define RNA_PROTOBUF_H

#include "json.h"

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

/* A new last item; NULL where memory is out. */
#define APPEND(wire, list)                                                                      \
    ((list)->at = grown(wire, (list)->at, (list)->count, &(list)->room, sizeof *(list)->at),    \
     (list)->count < (list)->room ? &(list)->at[(list)->count++] : NULL)

#endif
